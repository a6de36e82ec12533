#!/usr/bin/env bash
# What fish offers for the last word of a line: complete_fish.sh SHARE LINE
set -euo pipefail
share=$(realpath "$1")
HOME=$(mktemp -d)
export HOME
trap 'rm -rf "$HOME"' EXIT
fish --no-config --command 'set -g fish_complete_path $argv[1]/fish/vendor_completions.d $fish_complete_path
    complete -C $argv[2]' "$share" "$2" | sed 's,\t.*,,; s,/*$,,' | sort -u
