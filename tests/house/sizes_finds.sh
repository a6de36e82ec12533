#!/usr/bin/env bash
# Fails unless sizes.sh lets through what is just small enough, and finds what is one line, or one
# file, too big, and nothing else.
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# cpp LINES [NAME]: a function of that many lines; js LINES: the same in JavaScript.
cpp() { local i; echo "int ${2:-f}() {"; for ((i = 3; i < $1; ++i)); do echo "    // $i"; done; printf '    return 0;\n}\n'; }
js() { local i; echo "const f = (x) => {"; for ((i = 2; i < $1; ++i)); do echo "  // $i"; done; echo "};"; }
# comment LINES: a file of that many lines.
comment() { local i; for ((i = 0; i < $1; ++i)); do echo "// $i"; done; }

for room in fits overflows; do
    over=0
    [ "$room" = fits ] || over=1
    mkdir -p "$work/$room/many"
    cpp $((50 + over)) > "$work/$room/function.cpp"
    { echo "class C {"; cpp $((50 + over)) member; echo "};"; } > "$work/$room/method.hpp"
    js $((50 + over)) > "$work/$room/arrow.js"
    comment $((300 + over)) > "$work/$room/file.cpp"
    for ((i = 0; i < 12 + over; ++i)); do
        comment 1 > "$work/$room/many/$i.cpp"
        comment 1 > "$work/$room/many/$i.hpp"
    done
done

./sizes.sh "$work/fits"
code=0
found=$(./sizes.sh "$work/overflows") || code=$?
[ "$code" -ne 77 ] || { echo "$found"; exit 77; }
[ "$code" -ne 0 ] || { echo "What is too big passes."; exit 1; }
diff - <(echo "$found") << 'END'
function.cpp:1: function f of 51 lines
method.hpp:2: function member of 51 lines
arrow.js:1: function of 51 lines
file.cpp:1: file of 301 lines
many:1: folder of 13 source files
END
