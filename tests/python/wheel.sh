#!/usr/bin/env bash
# Makes a wheel of what the build has compiled, installs it in a fresh virtual environment that sees
# nothing of the tree, without network, and runs the module's tests there.
# Needs ASV_PYTHON, ASV_BUILD, ASV_PROGRAMS from CTest; 77: skipped.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
for module in numpy pytest venv pip; do
    "$ASV_PYTHON" -c "import $module" 2> /dev/null || {
        echo "skipped: $ASV_PYTHON has no $module (tools/install_packages.sh python)"
        exit 77
    }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INDEX=1 PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH

"$ASV_PYTHON" -m venv --system-site-packages "$work/venv"
"$work/venv/bin/pip" wheel --quiet --no-deps --wheel-dir "$work" \
    --config-settings "build-dir=$ASV_BUILD" "$here/../.."
"$work/venv/bin/pip" install --quiet "$work"/asv-*.whl
"$work/venv/bin/pip" check asv | grep -v '^asv' | sed 's/^/not ours: /' || true

cd "$work"
ASV_SOLVE=$ASV_PROGRAMS/asv-solve ASV_GENERATE=$ASV_PROGRAMS/asv-generate \
    "$work/venv/bin/python" -m pytest -q -p no:cacheprovider --rootdir "$here" -c /dev/null "$here" "$@"
"$work/venv/bin/pip" uninstall --quiet --yes asv
! "$work/venv/bin/python" -c 'import asv' 2> /dev/null || { echo "asv is still there"; exit 1; }
