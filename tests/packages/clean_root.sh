#!/usr/bin/env bash
# Installs the packages in a Debian that has nothing else and does there what docs/packages.md tells:
# clean_root.sh PROJECT FOLDER_OF_PACKAGES
#
# All blocks of the page that open with ```sh installed are run, in their order, by one shell, in a
# folder that has the packages, the examples and the test cases where the tree has them; those that open
# with ```sh installed python, where the packages have the Python module. In the end nothing must be left
# of the packages.
set -euo pipefail
project=$1
debs=$2
source "$(dirname "$0")/root.sh"
require_roots
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root
make_root "$root" "$debs/../packages_root/debian.tar"

tree=$root/root/asv
mkdir -p "$tree/build/packages" "$tree/tests/house"
cp "$debs"/*.deb "$tree/build/packages"
cp -r "$project/testcases" "$tree/testcases"
mkdir "$tree/docs"
cp -r "$project/docs/examples" "$tree/docs/examples"
cp -r "$project/tests/house/consumer" "$tree/tests/house/consumer"

kinds='^```sh installed$'
! compgen -G "$debs/python3-asv_*.deb" > /dev/null || kinds='^```sh installed( python)?$'
awk -v kinds="$kinds" '/^```/ { inside = !inside && $0 ~ kinds; next } inside' \
    "$project/docs/packages.md" > "$tree/commands"
[ -s "$tree/commands" ] || { echo "docs/packages.md: no block that begins with \`\`\`sh installed"; exit 1; }
if ! in_root "$root" /root/asv 'apt-get update && bash -euvo pipefail commands' > "$work/log" 2>&1; then
    echo "docs/packages.md: a command fails in a clean Debian; the last one here:"
    tail -n 60 "$work/log"
    exit 1
fi
echo "docs/packages.md: $(grep -c . "$tree/commands") lines run in a clean Debian"

# A shell completes by what is installed there. It is the shell of this machine, since one at a terminal
# needs devices that a folder has not.
"$project/tests/tools/manual/completion.sh" bash "$root/usr/share" "$root/usr/bin"

mapfile -t packages < <(for deb in "$debs"/*.deb; do dpkg-deb --field "$deb" Package; done)
in_root "$root" / "apt-get purge ${packages[*]}" > "$work/log" 2>&1 || { tail "$work/log"; exit 1; }
left=$(find "$root/usr" \( -name 'asv*' -o -name 'libasv*' \) -print)
[ -z "$left" ] || { echo "left when the packages are gone: $left"; exit 1; }
