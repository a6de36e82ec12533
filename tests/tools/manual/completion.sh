#!/usr/bin/env bash
# Does a shell complete what the programs have, and nothing else? completion.sh SHELL SHARE PROGRAMS
#
# SHELL: bash, zsh or fish. SHARE: the folder with the completions, as it is installed. PROGRAMS: the
# folder of the programs. Skipped where the shell is not installed.
set -euo pipefail
export LC_ALL=C.UTF-8
shell=$1
share=$(realpath "$2")
programs=$(realpath "$3")
here=$(realpath "$(dirname "$0")")
. "$here/help_options.sh"
export PATH=$programs:$PATH
skip() {
    echo "skipped: $1; tools/install_packages.sh test"
    exit 77
}
command -v "$shell" > /dev/null || skip "no $shell"
[ "$shell" != bash ] || [ -f /usr/share/bash-completion/bash_completion ] || skip "no bash-completion"

failed=0
# expect LINE WORDS: what is offered for the line; of KEY=VALUE the part that is asked for.
expect() {
    local got wanted
    wanted=$(tr -s ' \n' '\n' <<< "$2" | sed '/^$/d' | LC_ALL=C sort -u)
    got=$("$here/complete_$shell.sh" "$share" "$1" | case $1 in
        *' --set ') sed 's,=.*,,' ;;
        *) sed 's,.*=,,' ;;
    esac | LC_ALL=C sort -u)
    [ "$got" = "$wanted" ] && return
    echo "$shell: '$1' (< expected, > offered)"
    diff <(echo "$wanted") <(echo "$got") || true
    failed=1
}
# settings PLANNER: the names of its settings. words PLANNER: all planners.
settings() { asv-solve --list-planners | awk -v planner="$1:" '/^[a-z]/ { inside = $1 == planner } inside && /^    [a-z]/ { print $1 }'; }
planners=$(asv-solve --list-planners | sed -n 's/^\([a-z-]*\):.*/\1/p')

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export ASV_ZSH_DUMP=$work/dump
mkdir -p "$work/here/folder"
cd "$work/here"
touch a.txt b.json c.png d.svg e.html f.csv

for program in asv-bench asv-generate asv-solve asv-validate asv-view; do
    expect "$program -" "$(help_options "$program")"
done
expect "asv-generate " "$(help_families asv-generate)"
expect "asv-generate -n 5 " "$(help_families asv-generate)"
for family in $(help_families asv-generate); do
    expect "asv-generate $family -" "$(help_options asv-generate; help_options asv-generate "$family")"
done
expect "asv-solve --planner " "$planners"
expect "asv-solve --planner=prm-" "$(grep '^prm-' <<< "$planners")"
expect "asv-bench --planner " "$planners all"
for planner in auto rrt-star; do
    expect "asv-solve a.txt b.txt --planner $planner --set " "$(settings "$planner")"
done
expect "asv-solve --set " "$(settings auto)"
expect "asv-solve --planner=rrt-connect --set ladder=" "on off"
expect "asv-solve --planner rrt --set sampler=pass" "passage"
expect "asv-solve " "a.txt b.json folder"
expect "asv-validate --json " "b.json folder"
expect "asv-view a.txt -o " "c.png d.svg e.html folder"
expect "asv-view --gallery " "folder"
expect "asv-bench --csv " "f.csv folder"
expect "asv-view --theme " "light dark"
expect "asv-generate spiral --direction " "random inward outward"
[ "$failed" -ne 0 ] || echo "$shell completes all of it"
exit "$failed"
