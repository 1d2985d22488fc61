#!/usr/bin/env bash
# All sources are as clang-format writes them.
set -euo pipefail
cd "$1"
find include src test -name '*.hpp' -o -name '*.cpp' | xargs clang-format --dry-run -Werror
