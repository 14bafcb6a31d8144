#!/usr/bin/env bash
# Everything that must hold before a change is merged: formatting, the release build and its tests,
# the same tests under the address and undefined-behaviour sanitizers (without the compiler, whose
# LLVM is not instrumented), and clang-tidy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=$(nproc)

step() { printf '\n== %s (%d s so far)\n' "$1" "$SECONDS"; }

step "packages"
scripts/setup.sh

# The project's own sources, as version control knows them.
mapfile -t sources < <(git ls-files '*.cpp' '*.hpp')
mapfile -t firmware_sources < <(git ls-files 'firmware/*.c' 'firmware/*.h')

step "clang-format"
clang-format --dry-run --Werror "${sources[@]}" "${firmware_sources[@]}"
echo "${#sources[@]} C++ and ${#firmware_sources[@]} C files are formatted"

step "release build"
cmake --preset release
cmake --build build/release --parallel "$jobs"

step "release tests"
ctest --preset release --parallel "$jobs" --no-tests=error

step "asan-ubsan build"
cmake --preset asan-ubsan
cmake --build build/asan-ubsan --parallel "$jobs"

step "asan-ubsan tests"
ctest --preset asan-ubsan --parallel "$jobs" --no-tests=error

step "clang-tidy"
# Not the tests: what is wrong with them shows when they run, and GoogleTest's headers take minutes.
mapfile -t files < <(git ls-files '*.cpp' ':!tests')
scripts/tidy-units.py build/release/compile_commands.json build/tidy "${files[@]}" |
  xargs --max-procs="$jobs" --max-args=1 clang-tidy --quiet -p build/tidy
echo "clang-tidy: ${#files[@]} files are clean"

step "all passed"
