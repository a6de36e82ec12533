#!/usr/bin/env bash
# Does what tools/Dockerfile says, in clean Debian systems in place of containers, and runs the result:
# dockerfile.sh PROJECT FOLDER_OF_PACKAGES
#
# The stage that builds takes long; unless ASV_TEST_DOCKER_BUILD is set, only its script is looked for,
# and the packages given are taken for its result.
set -euo pipefail
project=$1
debs=$2
source "$(dirname "$0")/root.sh"
require_roots
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
place=/
stage=

# copy FROM TO: from the tree as .dockerignore leaves it, or from the stage that builds.
copy() {
    local to=$2
    [ "$to" != . ] || to=$place
    mkdir -p "$stage$to"
    if [[ $1 == --from=build\ * ]]; then
        cp -r "$work/build${1#--from=build }". "$stage$to"
    else
        tar -C "$project" --exclude-from="$project/.dockerignore" -cf - "$1" | tar -C "$stage$to" -xf -
    fi
}

# One instruction a line, without comments.
sed -e '/^#/d' -e ':again' -e '/\\$/{N;s/\\\n */ /;b again' -e '}' "$project/tools/Dockerfile" > "$work/instructions"
while read -r word rest; do
    case $word in
        FROM)
            [[ $rest == debian:12-slim* ]] || { echo "not from Debian 12: $rest"; exit 1; }
            stage=$work/program
            [[ $rest != *" AS build" ]] || stage=$work/build
            place=/
            make_root "$stage" "$debs/../packages_root/debian.tar"
            before=$(du -sm "$stage" | cut -f1)
            ;;
        WORKDIR)
            place=$rest
            mkdir -p "$stage$place"
            ;;
        COPY) copy "${rest% *}" "${rest##* }" ;;
        RUN)
            if [ "$stage" = "$work/build" ] && [ -z "${ASV_TEST_DOCKER_BUILD:-}" ]; then
                [ -x "$stage$place/$rest" ] || { echo "no script $rest"; exit 1; }
                mkdir -p "$stage$place/build/packages"
                cp "$debs"/*.deb "$stage$place/build/packages"
            else
                in_root "$stage" "$place" "$rest" > "$work/log" 2>&1 || { tail -n 40 "$work/log"; exit 1; }
            fi
            ;;
        CMD) command=$(tr -d '[],"' <<< "$rest") ;;
        "") ;;
        *) echo "this test does not know the instruction $word"; exit 1 ;;
    esac
done < "$work/instructions"

in_root "$stage" "$place" "$command" > "$work/log"
cp "$project/testcases/7ASV.txt" "$stage$place"
in_root "$stage" "$place" "asv-solve 7ASV.txt path.txt --quiet && asv-validate 7ASV.txt path.txt > checks"
echo "tools/Dockerfile: the image is $(($(du -sm "$stage" | cut -f1) - before)) MiB larger than Debian's"
