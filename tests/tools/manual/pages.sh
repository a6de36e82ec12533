#!/usr/bin/env bash
# Are the manual pages well-formed, and do they tell the options of --help, those and no others?
# pages.sh SHARE PROGRAMS
#
# SHARE: the folder with the pages, as it is installed. PROGRAMS: the folder of the programs.
set -euo pipefail
export LC_ALL=C.UTF-8
share=$1
programs=$2
. "$(dirname "$0")/help_options.sh"
failed=0
fail() {
    echo "$1"
    failed=1
}
plain() { sed 's/\\-/-/g; s/\\f[BRI]//g; s/\\&//g'; }

# page_options PAGE SECTION: the options that are items of a section or of one of its subsections.
page_options() {
    awk -v title="$2" '
        /^\.S[SH] / { inside = ($2 == title) || ($1 == ".SS" && within && $2 == title) }
        inside && item && /^\\fB\\-/ { print }
        { item = /^\.TP/ }
    ' "$1" | sed 's/ \\fI.*//' | plain | tr -d ' ' | tr ',' '\n' | LC_ALL=C sort -u
}
# compare NAME OPTIONS_OF_HELP OPTIONS_OF_PAGE
compare() {
    [ "$2" = "$3" ] && return
    fail "$1: not the options of --help (< help, > page)"
    diff <(echo "$2") <(echo "$3") || true
}

names=(asv-bench asv-generate asv-solve asv-validate asv-view)
[ ! -x "$programs/asv-ompl" ] || names+=(asv-ompl)  # not built without OMPL
for name in "${names[@]}"; do
    page=$share/man/man1/$name.1
    program=$programs/$name
    compare "$name" "$(help_options "$program")" "$(page_options "$page" OPTIONS)"
    for family in $(help_families "$program"); do
        compare "$name $family" "$(help_options "$program" "$family")" "$(page_options "$page" "$family")"
    done
    for section in NAME SYNOPSIS DESCRIPTION OPTIONS 'EXIT STATUS' EXAMPLES FILES 'SEE ALSO'; do
        grep -qx "\.SH $section" "$page" || fail "$name.1: no section $section"
    done
    # A type name that CLI11 chose says nothing: whoever adds an option says what it takes.
    ! "$program" --help | grep -E '^  [-A-Z][^ ]* TEXT( |$)' || fail "$name: what does this option take?"
done
# Every planner and setting of the catalogue is on the page.
terms=$(plain < "$share/man/man1/asv-solve.1" | sed 's/^\.SS //')
while read -r word; do
    grep -qxF -e "$word" <<< "$terms" || fail "asv-solve.1: nothing of $word"
done < <("$programs/asv-solve" --list-planners |
    sed -n 's/^\([a-z-]*\):.*/\1/p; s/^    \([a-z][a-z-]*\) .*/\1/p' | sort -u)

checkers=0
for page in "$share"/man/man1/*.1; do
    if command -v mandoc > /dev/null; then
        checkers=1
        mandoc -T lint -W style "$page" || failed=1
    fi
    if command -v groff > /dev/null; then
        checkers=1
        said=$(groff -ww -man -Tutf8 "$page" 2>&1 > /dev/null) || true
        [ -z "$said" ] || fail "$said"
    fi
done
[ "$failed" -eq 0 ] || exit 1
[ "$checkers" -eq 1 ] || { echo "skipped: neither mandoc nor groff; tools/install_packages.sh test"; exit 77; }
echo "the pages tell the options of --help"
