#!/usr/bin/env bash
# Builds the fuzzers (clang's libFuzzer with the sanitizers for memory and undefined behaviour) and gives
# each of them its share of MINUTES, one after the other: fuzz.sh MINUTES [TARGET...]; without targets all
# of them. Ends with 1 where something was found, and says which input in build/fuzz/found/ it was. What
# the inputs in build/fuzz/corpus/ have reached is where the next call goes on.
set -euo pipefail
cd "$(dirname "$0")/.."
usage="usage: fuzz.sh MINUTES [TARGET...]; targets: $(cd tests/fuzz/corpus && echo *)"
[ $# -gt 0 ] || { echo "$usage" >&2; exit 2; }
minutes=$1
shift
targets=("$@")
[ $# -gt 0 ] || mapfile -t targets < <(ls tests/fuzz/corpus)
for target in "${targets[@]}"; do
    [ -d "tests/fuzz/corpus/$target" ] || { echo "$usage" >&2; exit 2; }
done
seconds=$(awk -v minutes="$minutes" -v count="${#targets[@]}" \
    'BEGIN { seconds = int(60 * minutes / count); print seconds < 1 ? 1 : seconds }')

tools/install_packages.sh fuzz
cmake --preset fuzz > /dev/null
cmake --build --preset fuzz

# about TARGET: its options. The longest input in bytes, the longest time for one in seconds of a busy machine,
# and its dictionary where one helps.
about() {
    case "$1" in
        problem | solution) echo "-max_len=4096 -timeout=60 -dict=tests/fuzz/dictionaries/numbers.dict" ;;
        settings) echo "-max_len=1024 -timeout=60 -dict=tests/fuzz/dictionaries/numbers.dict" ;;
        scenario | trajectory | trees | statistics) echo "-max_len=2048 -timeout=60 -dict=tests/fuzz/dictionaries/json.dict" ;;
        map) echo "-max_len=1024 -timeout=60 -dict=tests/fuzz/dictionaries/map.dict" ;;
        solve) echo "-max_len=128 -timeout=300" ;;
    esac
}

found=build/fuzz/found
mkdir -p "$found"
failed=()
for target in "${targets[@]}"; do
    corpus=build/fuzz/corpus/$target
    mkdir -p "$corpus"
    log=build/fuzz/$target.log
    # shellcheck disable=SC2046
    build/fuzz/fuzzers/"fuzz_$target" $(about "$target") -max_total_time="$seconds" -print_final_stats=1 \
        -malloc_limit_mb=512 -rss_limit_mb=2048 -report_slow_units=60 -artifact_prefix="$found/$target-" \
        "$corpus" "tests/fuzz/corpus/$target" > "$log" 2>&1 || failed+=("$target")
    awk -v target="$target" -v seconds="$seconds" '
        / cov: / { for (i = 1; i < NF; ++i) { if ($i == "cov:") edges = $(i + 1); if ($i == "corp:") inputs = $(i + 1) } }
        /number_of_executed_units/ { runs = $2 }
        END { printf "%-10s %5d s %10d runs %6d edges of code, by inputs of %s\n", target, seconds, runs, edges, inputs }
    ' "$log"
done
[ ${#failed[@]} -eq 0 ] && exit 0
for target in "${failed[@]}"; do
    echo "$target: found something, see build/fuzz/$target.log"
    grep -h 'Test unit written to' "build/fuzz/$target.log" || true
done
exit 1
