# To be sourced: pages under test in a real Chromium.

# use_chromium PROGRAMS OUT: leaves with 77, which CTest counts as skipped, where no Chromium is
# installed. OUT gets the node packages, anew only when their lock file has changed, and empty folders for
# screenshots and pages.
use_chromium() {
    local browser here out=$2
    here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
    browser=$(command -v chromium || command -v chromium-browser || true)
    if [ -z "$browser" ]; then
        echo "Skipped: chromium is not installed (Debian package chromium)."
        exit 77
    fi
    mkdir -p "$out"
    if ! cmp --silent "$here/package-lock.json" "$out/node_modules/.lock-used"; then
        cp "$here/package.json" "$here/package-lock.json" "$out/"
        npm ci --prefix "$out" --no-audit --no-fund --loglevel error
        cp "$here/package-lock.json" "$out/node_modules/.lock-used"
    fi
    rm -rf "$out/screenshots" "$out/figures.json"
    mkdir -p "$out/screenshots" "$out/pages"
    ASV_PROGRAMS=$(realpath "$1") ASV_OUT=$(realpath "$out") ASV_SOURCE=$(realpath "$here/../..")
    export ASV_BROWSER=$browser ASV_PROGRAMS ASV_OUT ASV_SOURCE
}

# run_tests FOLDER...: one file after the other, since what is measured in one is not to be disturbed by another.
run_tests() {
    local folder tests failed=0
    for folder in "$@"; do
        for tests in "$folder"/*_test.mjs; do
            node --test --test-reporter=spec "$tests" || failed=1
        done
    done
    echo "Screenshots and figures.json are in $ASV_OUT"
    return $failed
}
