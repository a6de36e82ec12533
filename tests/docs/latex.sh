#!/usr/bin/env bash
# Do tables and figures of asv-bench go into a page of LaTeX? latex.sh ROOT PROGRAMS WORK
#
# The page is the block of LaTeX in docs/tutorials/compare_planners.md; the files that it asks for are of a
# small benchmark whose names mean much to LaTeX. They stay in WORK, to be looked at. Skipped where TeX or
# what reads PDF files is not installed.
set -euo pipefail
root=$(realpath "$1")
programs=$(realpath "$2")
work=$3
for program in pdflatex pdffonts pdfimages pdfinfo pdftotext; do
    command -v "$program" > /dev/null || { echo "skipped: no $program; tools/install_packages.sh tex"; exit 77; }
done
kpsewhich booktabs.sty > /dev/null || { echo "skipped: no booktabs; tools/install_packages.sh tex"; exit 77; }

# No font is to be made of pixels, and none to be left in somebody's home.
export MKTEXPK=0 TEXMFVAR="$work/texmf"
rm -rf "$work"
mkdir -p "$work"
cd "$work"
failed=0
fail() {
    echo "$1"
    failed=1
}

# Names of files, of planners and, since labels are free, of anything.
cp "$root/testcases/3ASV.txt" 'a_b&50%#1{x}.txt'
cp "$root/testcases/3ASV-x4.txt" 'tilde~^$2\y.txt'
"$programs/asv-bench" 'a_b&50%#1{x}.txt' 'tilde~^$2\y.txt' --planner 'fast_1 & 100%: auto' \
    --planner '#2 \input{x} _{$y^2$} ~ with a name that is long: rrt-connect' \
    --seeds 2 --time-limit 20 --optimize 0.02 --quiet --layout column --table table.tex --json runs.json \
    --plot shares.pdf --profile profile.pdf --anytime anytime.pdf \
    --parameter obstacles --parameter-plot obstacles.pdf

figures=(shares profile anytime obstacles)
for name in "${figures[@]}"; do
    [ "$(pdfimages -list "$name.pdf" | wc -l)" -eq 2 ] || fail "$name.pdf: has pixels"
    # Words, as their boxes: none may stick out of the page that they are on, nor cover another one, nor be
    # too small to read where the page is 8 cm wide: 227 points.
    pdftotext -bbox "$name.pdf" - | awk -v name="$name.pdf" -F'"' '
        /<page / { width = $2; height = $4 }
        /<word / {
            word = $9
            gsub(/^>|<\/word>$/, "", word)
            if (($8 - $4) * 227 / width < 7) { print name ": too small: " word; bad = 1 }
            if ($2 < 0 || $4 < 0 || $6 > width || $8 > height) { print name ": cut off: " word; bad = 1 }
            for (i = 0; i < count; ++i)
                if ($2 < right[i] && left[i] < $6 && $4 + 3 < low[i] && high[i] + 3 < $8) {
                    print name ": one over the other: " words[i] " " word
                    bad = 1
                }
            left[count] = $2; high[count] = $4; right[count] = $6; low[count] = $8; words[count++] = word
        }
        END { if (count < 5) { print name ": no words"; bad = 1 } exit bad }' || failed=1
done

awk '/^```latex/ { inside = 1; next } /^```/ { inside = 0 } inside' \
    "$root/docs/tutorials/compare_planners.md" > paper.tex
if ! pdflatex -halt-on-error -interaction=nonstopmode paper.tex > output; then
    tail -n 20 output
    exit 1
fi
# A point more than the text is wide is seen by nobody.
awk '/^Overfull/ { sub(/.*\(/, ""); if ($1 + 0 > 1) { print "sticks out: " $0; bad = 1 } }
     /Undefined|Missing character|Float too large|LaTeX Warning/ { print; bad = 1 }
     END { exit bad }' paper.log || failed=1

fonts=$(pdffonts paper.pdf | tail -n +3)
grep -q DejaVu <<< "$fonts" || fail "no font of the figures: $fonts"
# Behind the name and the type: encoding, embedded, subset, unicode, and two numbers of the object.
awk '/Type 3/ || $(NF - 4) != "yes" { print "not embedded, or of pixels: " $0; bad = 1 } END { exit bad }' \
    <<< "$fonts" || failed=1
[ "$(pdfimages -list paper.pdf | wc -l)" -eq 2 ] || fail "paper.pdf: has pixels"

pages=$(pdfinfo paper.pdf | awk '/^Pages:/ { print $2 }')
[ "$pages" -ge 4 ] && [ "$pages" -le 7 ] || fail "$pages pages"
text=$(pdftotext -layout paper.pdf -)
# LaTeX's first font encoding draws an underscore as a rule, which is no text.
for words in 'a.{1,3}b&50%#1\{x\}, forward: 3 ASVs' '~\^\$2\\y, forward' 'fast.{1,3}1 & 100% +2 of 2' '#2 \\input\{x\}' \
    'solved' 'PAR-2 ms' 'Planners compared' 'Performance profiles\.' 'number of obstacles\.' 'time to the first path'; do
    grep -Eq "$words" <<< "$text" || fail "the page does not have: $words"
done
[ "$failed" -eq 0 ] || exit 1
echo "$pages pages of LaTeX, fonts embedded, nothing cut off"
