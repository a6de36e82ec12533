#!/usr/bin/env bash
# The packaged programs run on a processor of 2008, which has no AVX, and on one of 2013, which has AVX2
# and no AVX-512; there they write the same bytes: old_processor.sh PROJECT FOLDER_OF_PACKAGES
set -euo pipefail
project=$1
debs=$2
[ "$(uname -m)" = x86_64 ] || { echo "skipped: the processors that are imitated are x86-64"; exit 77; }
command -v qemu-x86_64 > /dev/null || { echo "skipped: no qemu-x86_64 (qemu-user)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dpkg-deb --extract "$debs"/asv-brooms_*.deb "$work/root"
programs=$work/root/usr/bin
cd "$work"

# The imitation has to be one: what needs AVX-512 must not run.
echo '#include <immintrin.h>
int main(int count, char**) { return _mm512_reduce_add_epi32(_mm512_set1_epi32(count)) != 16 * count; }' > wide.cpp
g++ -mavx512f -o wide wide.cpp
problem=$project/testcases/3ASV.txt
options=(--threads 1 --seed 1 --optimize 0.01 --quiet)
"$programs/asv-solve" "$problem" here.txt "${options[@]}"
for processor in Nehalem Haswell; do
    if qemu-x86_64 -cpu "$processor" ./wide > /dev/null 2>&1; then
        echo "skipped: this qemu runs AVX-512 on $processor"
        exit 77
    fi
    on=(qemu-x86_64 -cpu "$processor")
    "${on[@]}" "$programs/asv-solve" "$problem" there.txt "${options[@]}" 2> log || { cat log; exit 1; }
    cmp here.txt there.txt
    "${on[@]}" "$programs/asv-validate" "$problem" there.txt --continuous > /dev/null
    "${on[@]}" "$programs/asv-view" "$problem" there.txt -o there.svg
    "${on[@]}" "$programs/asv-generate" -n 3 --seed 2 -o generated.txt maze
    "${on[@]}" "$programs/asv-bench" "$problem" --seeds 1 --optimize 0 --jobs 1 > /dev/null
    echo "$processor: solves, validates, draws, generates, compares; the same bytes"
done
