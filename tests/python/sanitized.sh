#!/usr/bin/env bash
# The module's tests with library and binding compiled under the sanitizer for memory, whose runtime
# has to be in the interpreter before anything else. The interpreter's own leaks are not looked at.
# Needs ASV_PYTHON, ASV_BUILD, ASV_PROGRAMS, ASV_COMPILER from CTest; 77: skipped.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
for module in numpy pytest; do
    "$ASV_PYTHON" -c "import $module" 2> /dev/null || {
        echo "skipped: $ASV_PYTHON has no $module (tools/install_packages.sh python)"
        exit 77
    }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# The library of C++ as well: what it throws has to be known when the sanitizer wakes up. The names
# are those of GCC's runtime and of clang's.
runtime=$("$ASV_COMPILER" -print-file-name=libclang_rt.asan-"$(uname -m)".so)
[ -e "$runtime" ] || runtime=$("$ASV_COMPILER" -print-file-name=libasan.so)
preload=$runtime:$("$ASV_COMPILER" -print-file-name=libstdc++.so)
# The program to compare with has a runtime of its own.
printf '#!/bin/sh\nunset LD_PRELOAD\nexec "%s/asv-solve" "$@"\n' "$ASV_PROGRAMS" > asv-solve
chmod +x asv-solve
env LD_PRELOAD="$preload" ASAN_OPTIONS=detect_leaks=0 PYTHONMALLOC=malloc PYTHONDONTWRITEBYTECODE=1 \
    PYTHONPATH="$ASV_BUILD/python" ASV_SANITIZED=1 ASV_SOLVE="$work/asv-solve" \
    "$ASV_PYTHON" -m pytest -q -p no:cacheprovider --rootdir "$here" -c /dev/null "$here" "$@"
