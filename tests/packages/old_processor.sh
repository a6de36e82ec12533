#!/usr/bin/env bash
# The packaged programs run on a processor of 2008, which has no AVX, and on one of 2013, which has AVX2
# and no AVX-512; there they write the same bytes. AVX-512 stands nowhere but in functions that are chosen
# when a program runs, which the names in PROGRAMS, not those stripped for packages, tell:
# old_processor.sh PROJECT FOLDER_OF_PACKAGES PROGRAMS
set -euo pipefail
project=$1
debs=$2
[ "$(uname -m)" = x86_64 ] || { echo "skipped: the processors that are imitated are x86-64"; exit 77; }
command -v qemu-x86_64 > /dev/null || { echo "skipped: no qemu-x86_64 (qemu-user)"; exit 77; }
built=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dpkg-deb --extract "$debs"/asv-brooms_*.deb "$work/root"
programs=$work/root/usr/bin
cd "$work"

# on PROCESSOR PROGRAM ARGUMENTS...: what it says is shown where it fails; the imitator warns of much.
on() {
    qemu-x86_64 -cpu "$@" > log 2>&1 || { cat log; return 1; }
}

# An imitation that runs everything would prove nothing: what needs more must not run.
echo '#include <immintrin.h>
int main(int count, char**) { return _mm256_extract_epi32(_mm256_set1_epi32(count), 7) != count; }' > needs_avx2.cpp
echo '#include <immintrin.h>
int main(int count, char**) { return _mm512_reduce_add_epi32(_mm512_set1_epi32(count)) != 16 * count; }' > needs_avx512.cpp
g++ -O0 -mavx2 -o needs_avx2 needs_avx2.cpp
g++ -O0 -mavx512f -o needs_avx512 needs_avx512.cpp

# Highway's functions for it are in a namespace N_AVX3, those that the compiler clones end in .avx512f.
for program in bench generate solve validate view; do
    objdump --disassemble --no-show-raw-insn "$built/asv-$program" |
        awk '/^[0-9a-f]+ <.*>:$/ { name = $2 } /%zmm/ { print name }' | sort -u > wide
    everywhere=$(grep -vE 'N_AVX3|\.avx512f>' wide || true)
    [ -z "$everywhere" ] || { echo "asv-$program needs AVX-512 in $everywhere"; exit 1; }
done

problem=$project/testcases/3ASV.txt
options=(--threads 1 --seed 1 --optimize 0.01 --time-limit 600 --quiet)
"$programs/asv-solve" "$problem" here.txt "${options[@]}"
for missing in Nehalem:needs_avx2 Haswell:needs_avx512; do
    processor=${missing%:*}
    if { on "$processor" "./${missing#*:}" > /dev/null; } 2> /dev/null; then
        echo "skipped: this qemu runs on a $processor what a $processor cannot"
        exit 77
    fi
    on "$processor" "$programs/asv-solve" "$problem" there.txt "${options[@]}"
    cmp here.txt there.txt
    on "$processor" "$programs/asv-validate" "$problem" there.txt --continuous
    on "$processor" "$programs/asv-view" "$problem" there.txt -o there.svg
    on "$processor" "$programs/asv-generate" -n 3 --seed 2 -o generated.txt maze
    on "$processor" "$programs/asv-bench" "$problem" --seeds 1 --time-limit 600
    echo "$processor: solves, validates, draws, generates, compares; the same bytes"
done
