#!/usr/bin/env bash
# Makes the Debian packages of a build and looks at what is in them: debs.sh BUILD FOLDER
set -euo pipefail
build=$1
folder=$2
command -v dpkg-shlibdeps > /dev/null || { echo "skipped: no dpkg-dev"; exit 77; }
command -v chrpath > /dev/null || { echo "skipped: no chrpath"; exit 77; }
failed=0
fail() {
    echo "$1"
    failed=1
}

rm -rf "$folder"
(cd "$build" && cpack -B "$folder" > "$build/cpack.log" 2>&1) || { cat "$build/cpack.log"; exit 1; }
rm -rf "$folder/_CPack_Packages"

# holds PACKAGE FILES...: these lie below /usr in it.
holds() {
    dpkg-deb --contents "$folder/$1"_*.deb | awk '{ print $6 }' > "$folder/list"
    for file in "${@:2}"; do
        grep -qx "./usr/$file" "$folder/list" || fail "$1: no /usr/$file"
    done
}
# needs PACKAGE PACKAGES...: it depends on them.
needs() {
    dpkg-deb --field "$folder/$1"_*.deb Depends | tr ',' '\n' | awk '{ print $1 }' > "$folder/list"
    for package in "${@:2}"; do
        grep -qx "$package" "$folder/list" || fail "$1: does not depend on $package"
    done
}

holds asv-brooms bin/asv-{bench,generate,solve,validate,view}
needs asv-brooms libc6 libcairo2 libgmp10 libpng16-16 libyaml-0-2 libsqlite3-0
holds libasv-dev include/asv/core/solve/solve.hpp include/asv/io/problem/problem_file.hpp \
    lib/libasv_{benchmark,core,generate,geometry,io,io_benchmark}.a lib/cmake/asv/asv-config.cmake \
    lib/pkgconfig/asv-{benchmark,core,generate,io,io-benchmark}.pc
needs libasv-dev libmpfr-dev libgmp-dev libcairo2-dev libpng-dev libyaml-dev libsqlite3-dev
if compgen -G "$folder/python3-asv_*.deb" > /dev/null; then
    holds python3-asv lib/python3/dist-packages/asv/__init__.py lib/python3/dist-packages/asv/py.typed
    needs python3-asv python3 python3-numpy libcairo2
fi
rm "$folder/list"

for deb in "$folder"/*.deb; do
    echo "$(basename "$deb"): $(($(stat -c %s "$deb") / 1024)) KiB," \
        "$(dpkg-deb --field "$deb" Installed-Size) KiB when installed"
done

# What lintian calls an error must not be; what it calls a warning is shown.
if command -v lintian > /dev/null; then
    lintian --fail-on error --tag-display-limit 0 "$folder"/*.deb || fail "lintian finds errors"
else
    echo "lintian is not there"
fi
exit "$failed"
