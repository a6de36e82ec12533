#!/usr/bin/env bash
# What bash offers for the last word of a line: complete_bash.sh SHARE LINE
#
# A real interactive bash is given the line and told to insert all completions (readline's M-*); then
# printf is put before the line and prints the words.
set -euo pipefail
share=$1
line=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/rc" << END
PS1=
bind 'set enable-bracketed-paste off'
BASH_COMPLETION_USER_DIR=$share/bash-completion
XDG_DATA_HOME=$share
. /usr/share/bash-completion/bash_completion
END
# M-* inserts, C-a and C-e go to the begin and the end of the line.
printf '%s\e*\x01printf "%%s\\n" \x05 > %s\nexit\n' "$line" "$work/words" > "$work/keys"
script --quiet --return --command "bash --noprofile --rcfile $work/rc -i" /dev/null \
    < "$work/keys" > "$work/log" 2>&1 || true
given=$(($(wc -w <<< "$line")))
[[ $line == *' ' ]] || given=$((given - 1))
tail -n +$((given + 1)) "$work/words" | sed 's,/*$,,' | sort -u
