#!/usr/bin/env bash
# Builds the libraries as shared ones and looks at them: shared.sh PROJECT PROGRAMS
#   - programs of strangers build and run with them, by CMake and by pkg-config, in a prefix that was moved;
#   - each has the project's version in its soname, and offers no names but the project's;
#   - asv-solve with them writes the same bytes as PROGRAMS/asv-solve, which is linked statically.
#   - as Debian packages, programs and development files depend on the package of the libraries.
# What is tested is how things are linked, so nothing is optimised, which is quicker to build; answers
# do not depend on it.
set -euo pipefail
project=$1
programs=$2
build=$(dirname "$programs")/shared_test
work=$build/work
mkdir -p "$build"
failed=0
fail() {
    echo "$1"
    failed=1
}

# The standard headers, read once for all files: that halves the time.
flags="-O0 -DNDEBUG -DHWY_COMPILE_ONLY_STATIC -fPIC"
printf '#include <%s>\n' algorithm array atomic chrono cmath condition_variable functional iostream map \
    memory mutex numeric optional ranges span sstream string thread variant vector > "$build/standard.hpp"
g++ -std=c++20 $flags -x c++-header "$build/standard.hpp" -o "$build/standard.hpp.gch"

cmake -S "$project" -B "$build" -G Ninja -DBUILD_SHARED_LIBS=ON -DASV_BUILD_TESTS=OFF \
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=$flags -include $build/standard.hpp" > "$build/log"
cmake --build "$build" > "$build/log" || { tail -n 30 "$build/log"; exit 1; }

cmake -D "BUILD=$build" -D CONFIGURATION=Release -D GENERATOR=Ninja -D COMPILER=g++ -D LAUNCHER= -D FLAGS= \
    -D "WORK=$work" -D KEEP=ON -P "$project/tests/house/consumer.cmake" > "$build/log" 2>&1 ||
    { tail -n 30 "$build/log"; exit 1; }

prefix=$work/all
version=$(sed -n 's/^project(asv VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
for name in benchmark core generate geometry io io_benchmark; do
    library=$(echo "$prefix"/lib*/libasv_$name.so)
    soname=$(objdump -p "$library" | awk '$1 == "SONAME" { print $2 }')
    [ "$soname" = "libasv_$name.so.$version" ] || fail "libasv_$name.so: its soname is $soname"
    foreign=$(nm --dynamic --defined-only "$library" | awk '{ print $NF }' | grep -v 3asv || true)
    [ -z "$foreign" ] || fail "libasv_$name.so offers what is not the project's: $(head -n 5 <<< "$foreign")"
    [ -n "$(nm --dynamic --defined-only "$library")" ] || fail "libasv_$name.so offers nothing"
done

options=("$project/testcases/3ASV.txt" --threads 1 --seed 1 --optimize 0.01 --time-limit 600 --quiet)
"$programs/asv-solve" "${options[0]}" "$work/static.txt" "${options[@]:1}"
"$prefix/bin/asv-solve" "${options[0]}" "$work/shared.txt" "${options[@]:1}"
cmp "$work/static.txt" "$work/shared.txt" || fail "shared libraries give other bytes"
for program in bench generate solve validate view; do
    ldd "$prefix/bin/asv-$program" > "$build/log"
    ! grep -q 'not found' "$build/log" || fail "asv-$program: $(grep 'not found' "$build/log")"
    grep -q "$prefix" "$build/log" || fail "asv-$program does not use the libraries of its prefix"
done

if command -v dpkg-shlibdeps > /dev/null && command -v chrpath > /dev/null; then
    (cd "$build" && cpack -B "$work/packages" > "$build/log" 2>&1) || { tail "$build/log"; exit 1; }
    for package in asv-brooms libasv-dev; do
        dpkg-deb --field "$work/packages/$package"_*.deb Depends | grep -q "libasv$version (= $version-1)" ||
            fail "$package does not depend on libasv$version"
    done
fi
rm -rf "$work"
[ "$failed" -ne 0 ] || echo "shared libraries: linked, moved, the same bytes; they offer the project's names alone"
exit "$failed"
