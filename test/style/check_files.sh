#!/usr/bin/env bash
# No file is longer than 350 lines, and no scan, label, map or bag is under version control.
set -euo pipefail
cd "$1"
status=0
while read -r lines file; do
  [ "$file" = total ] || [ "$lines" -le 350 ] || { echo "$file has $lines lines"; status=1; }
done < <(find include src test -name '*.hpp' -o -name '*.cpp' | xargs wc -l)
if [ -e .git ]; then
  data=$(git ls-files | grep -E '\.(bag|bin|label|pcd|ply|npz)$' || true)
  [ -z "$data" ] || { echo "data under version control: $data"; status=1; }
fi
exit $status
