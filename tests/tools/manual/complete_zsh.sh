#!/usr/bin/env bash
# What zsh offers for the last word of a line: complete_zsh.sh SHARE LINE
#
# A real interactive zsh completes the line in a pseudo terminal; its compadd, through which all that
# is offered goes, tells a file as well. ASV_ZSH_DUMP: a file in which zsh keeps the list of all that it
# can complete, which takes a second to make; whoever completes many lines sets it.
set -euo pipefail
share=$(realpath "$1")
line=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/.zshrc" << END
PROMPT=
fpath=($share/zsh/vendor-completions \$fpath)
autoload -Uz compinit
compinit -u -C -d ${ASV_ZSH_DUMP:-$work/dump}
compadd() {
    # With -O, -A or -D it only fills arrays.
    if [[ \${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
        builtin compadd "\$@"
        return
    fi
    local -a hits
    builtin compadd -A hits "\$@"
    (( \$#hits )) && print -rl -- \$hits >> $work/words
    builtin compadd "\$@"
}
finish() { : > $work/done }
zle -N finish
bindkey '^X' finish
unsetopt auto_list  # a long list would ask whether to show it
: > $work/ready
END
: > "$work/words"
cat > "$work/drive" << 'END'
zmodload zsh/zpty
work=$1 line=$2
export ZDOTDIR=$work TERM=dumb
zpty terminal zsh -i
# FILE: waits until it is there, at most a minute.
await() { repeat 600; do [[ -e $1 ]] && return; sleep 0.1; done; exit 1 }
await $work/ready
zpty -w -n terminal "$line"$'\t\x18'
await $work/done
zpty -d terminal
END
zsh -f "$work/drive" "$work" "$line" > /dev/null 2>&1
sed 's,/*$,,' "$work/words" | sort -u
