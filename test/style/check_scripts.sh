#!/usr/bin/env bash
# Every shell script can at least be parsed.
set -euo pipefail
cd "$1"
for script in scripts/*.sh test/*/*.sh .ci/run; do bash -n "$script"; done
