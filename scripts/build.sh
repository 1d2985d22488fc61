#!/usr/bin/env bash
# Installs, configures and builds, into build/: build.sh [cmake target ...]. Without a target programs and nodelet; `all`
# has the tests, too.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/setup.sh"
# ROS tools are written for the system's Python.
export PATH="/usr/bin:$PATH"

# Two compilers at a time need about 3 GB.
jobs=$(nproc)
mkdir -p "$root/build"
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release >"$root/build/configure.log" 2>&1 || {
  cat "$root/build/configure.log" >&2
  exit 1
}
[ $# -gt 0 ] || set -- segdf_programs
targets=()
for target in "$@"; do targets+=(--target "$target"); done
cmake --build "$root/build" -j "$jobs" "${targets[@]}" |
  { grep -E 'error|Error|Built target segdf' || true; }  # a build without such a line is no failure
