#!/usr/bin/env bash
# The package as catkin wants it. Left out: keys that only rosdep's list on the network knows, the name of the
# checkout's folder, ${PROJECT_NAME} for every mention of segdf, and the scripts and benchmarks that belong to
# the sources, not to an installation.
set -euo pipefail
cd "$1"
left_out=(unknown_package package_path_name literal_project_name uninstalled_script)
PATH="/usr/bin:$PATH" catkin_lint --strict -W2 --offline "${left_out[@]/#/--ignore=}" .
