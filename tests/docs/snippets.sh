#!/usr/bin/env bash
# Do the pages show their examples as they are? snippets.sh ROOT
#
# A ```cpp block whose first line is
#     // docs/examples/NAME.cpp           shows the whole file
#     // docs/examples/NAME.cpp: PART     shows what stands between "// part: PART" and "// end of part"
# and must be that text, byte for byte. Every file of docs/examples is shown in full or in parts, and
# no other block of C++ may be in the pages, since nothing would compile it.
set -euo pipefail
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
fail() {
    echo "$1"
    failed=1
}

# The blocks become files named by a number, their places a list of "NUMBER PAGE:LINE".
awk -v work="$work" '
    FNR == 1 { inside = 0 }
    /^```/ && inside { inside = 0; close(file); next }
    /^```cpp/ { inside = 1; file = work "/" ++count; print count, FILENAME ":" FNR > (work "/places")
                printf "" > file; next }
    inside { print > file }' README.md CONTRIBUTING.md docs/*.md docs/tutorials/*.md

touch "$work/places" "$work/shown"
while read -r number place; do
    first=$(head -n 1 "$work/$number")
    file=$(sed -n 's,^// \(docs/examples/[a-z0-9_]*\.cpp\).*,\1,p' <<< "$first")
    part=$(sed -n 's,^// docs/examples/[a-z0-9_]*\.cpp: \(.*\),\1,p' <<< "$first")
    if [ ! -f "$file" ]; then
        fail "$place: the first line names no file of docs/examples: $first"
        continue
    fi
    echo "$file" >> "$work/shown"
    tail -n +2 "$work/$number" > "$work/block"
    if [ -n "$part" ]; then
        awk -v begin="// part: $part" '
            $0 == "// end of part" { inside = 0 }
            inside { print }
            $0 == begin { inside = 1 }' "$file" > "$work/text"
    else
        cp "$file" "$work/text"
    fi
    diff "$work/text" "$work/block" || fail "$place: not the text of $file${part:+, part $part}"
done < "$work/places"

for file in docs/examples/*.cpp; do
    grep -qx "$file" "$work/shown" || fail "$file: shown in no page"
done
[ "$failed" -ne 0 ] || echo "$(wc -l < "$work/places") snippets are the text of their files"
exit "$failed"
