#!/usr/bin/env bash
# The package as catkin wants it. Keys cannot be looked up without the network, so rosdep's are not.
set -euo pipefail
cd "$1"
PATH="/usr/bin:$PATH" catkin_lint --strict -W2 --offline --ignore unknown_package .
