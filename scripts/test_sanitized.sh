#!/usr/bin/env bash
# Builds with the address and undefined-behaviour sanitizers into build-asan and runs the unit tests there; the first
# finding ends a test. Left out are style, the real sequences, and what loads our library into programs of others,
# which are not built so.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build-asan"
"$root/scripts/setup.sh"
export PATH="/usr/bin:$PATH"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DSEGDF_SANITIZE=ON -DCMAKE_CXX_FLAGS=-g1
cmake --build "$build" -j "$(nproc)"

export LD_BIND_NOW=1
# Whole call stacks, without which libraries cannot be told from our code.
export ASAN_OPTIONS=fast_unwind_on_malloc=0
export LSAN_OPTIONS="suppressions=$root/test/support/leaks.supp:print_suppressions=0"
cd "$build"
ctest -j "$(nproc)" --output-on-failure --timeout 1500 -E '^style|^real|rostest|^rviz|^launch\.|^launched.demo|^nodelet.leaks'
