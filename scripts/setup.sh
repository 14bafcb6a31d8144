#!/usr/bin/env bash
# Installs what Finback needs to build: packages of Debian 12, nothing else. Safe to run again; when
# everything is there it does not touch apt.
set -euo pipefail

packages=(
  # building
  g++ cmake ninja-build make git ca-certificates
  # finback-cc: LLVM as a library and clang as its front end
  llvm-19-dev clang-19 zlib1g-dev libzstd-dev
  # libraries of the simulator and its tools
  libopencv-calib3d-dev libopencv-core-dev libopencv-imgcodecs-dev libopencv-imgproc-dev
  libopencv-videoio-dev
  libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libeigen3-dev
  # finback explore: the table of finished points, and its plot
  libsqlite3-dev gnuplot-nox
  # tests, benchmarks and checks
  libgtest-dev libgmock-dev libbenchmark-dev clang-format clang-tidy python3
  # random C programs for the compiler
  csmith libcsmith-dev
)
# ... and a host compiler whose long has 32 bits, too, where there is one
if [[ $(dpkg --print-architecture) == amd64 ]]; then
  packages+=(gcc-multilib)
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query --show --showformat='${db:Status-Abbrev}' "$package" 2>/dev/null || true)
  [[ $state == ii* ]] || missing+=("$package")
done

if [[ ${#missing[@]} -eq 0 ]]; then
  echo "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: not root and no sudo; as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi

echo "setup: installing ${#missing[@]} of ${#packages[@]} packages: ${missing[*]}"
"${as_root[@]}" apt-get update --quiet
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
echo "setup: done"
