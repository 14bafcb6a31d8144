#!/usr/bin/env bash
# Writes the golden traces, the firmware's budget baseline, the output in the manual's examples and
# the ladder's picture anew from the present build (traces/README.md, docs/finback-check.md). Review what changes before
# you commit it: git diff traces firmware/budgets docs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset release
cmake --build build/release --parallel "$(nproc)"
out=$(mktemp --directory)
trap 'rm -r "$out"' EXIT
build/release/bin/finback run --scene aloe --frames 4 --out "$out" \
  --trace-counters traces/mesvs2_aloe.json
build/release/bin/finback check firmware/budgets/mesvs2.toml --update-baseline
# The examples of the manual pages, which show what is printed.
FINBACK_REFRESH=1 ctest --preset release --tests-regex PageSaysWhatIsPrinted
build/release/bin/finback lab climb --plot docs/images/ladder.png > "$out/ladder"
git --no-pager diff --stat -- traces firmware/budgets docs
