#!/usr/bin/env bash
# Fails unless links.py finds every fault of the bad pages and nothing else.
set -euo pipefail
cd "$(dirname "$0")"

code=0
found=$(./links.py bad_pages) || code=$?
[ "$code" -ne 0 ] || { echo "The bad pages pass."; exit 1; }
diff bad_pages/expected.txt - <<< "$found"
