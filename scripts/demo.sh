#!/usr/bin/env bash
# From nothing to disparity maps: installs what is missing, builds, and runs the stereo camera's
# firmware on two scenes. The maps and the full results are then in out/demo.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset release
# What runs here; tests and benchmarks are built by scripts/test.sh.
cmake --build build/release --parallel "$(nproc)" --target finback finback_firmware_mesvs2

for scene in aloe synthetic; do
  echo
  build/release/bin/finback run --scene "$scene" --frames 4 --out "out/demo/$scene"
done

echo
echo "Disparity maps: out/demo/{aloe,synthetic}/disparity_*.png"
echo "Full results:   out/demo/{aloe,synthetic}/result.json (docs/result-json.md)"
