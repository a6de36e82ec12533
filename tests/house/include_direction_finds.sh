#!/usr/bin/env bash
# Fails unless include_direction.sh finds every fault of the bad example and nothing else.
set -euo pipefail
cd "$(dirname "$0")"

code=0
found=$(./include_direction.sh bad_example) || code=$?
[ "$code" -ne 0 ] || { echo "The bad example passes."; exit 1; }
diff bad_example/expected.txt - <<< "$found"
