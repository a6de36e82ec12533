#!/usr/bin/env bash
# Installs what is needed, builds and runs all tests, and says at the end which were skipped and why. The
# build is the one that the compiler is done with first (quick: less optimised, some files at once), with half
# of the random cases of tests; the programs of all builds compute the same. The Python module is tried by
# release and asan, where the packages of `tools/install_packages.sh python` are there; what stands on OMPL
# and MPI by release alone, where those of `tools/install_packages.sh ompl` and `mpi` are; the site by release alone.
# test.sh PRESET... runs them in other builds: release as users run the programs, asan with the sanitizers
# for memory and undefined behaviour, by clang, tsan with the one for threads (only tests that start some),
# clang with that compiler and no sanitizer.
# test.sh packages tries the release build as those meet it who install it (docs/packages.md).
set -euo pipefail
cd "$(dirname "$0")/.."

presets=("$@")
[ $# -gt 0 ] || presets=(quick)
case " ${presets[*]} " in
    *" asan "* | *" clang "*) tools/install_packages.sh ci ;;
    *) tools/install_packages.sh test ;;
esac
case " ${presets[*]} " in
    # Where these cannot be had, the tests that need them are skipped.
    *" packages "*) tools/install_packages.sh package_test || true ;;
esac

# skipped REPORT: the tests of a JUnit report that did not run, each with what it said.
skipped() {
    awk '
        /<testcase / { name = $0; sub(/.*<testcase name="/, "", name); sub(/".*/, "", name) }
        /<skipped/ { skips = 1; why = "" }
        said { why = $0; said = 0 }
        /: Skipped$/ { said = 1 }
        /skipped: / { why = $0; sub(/.*skipped: /, "", why) }
        /<\/testcase>/ {
            sub(/<\/system-out>.*/, "", why)
            if (skips) print "Skipped: " name (why == "" ? "" : " (" why ")")
            skips = 0
        }
    ' "$1"
}

# What of Debian's the Python module lacks; without it the module is not built.
python_lacks=
[ -e /usr/include/pybind11/pybind11.h ] || python_lacks+=" pybind11-dev"
for module in numpy pytest; do
    /usr/bin/python3 -c "import $module" 2> /dev/null || python_lacks+=" python3-$module"
done

# OMPL's headers lie in a folder of their version.
ompl_found=OFF
[ ! -e "$(echo /usr/include/ompl*/ompl/config.h)" ] || ompl_found=ON

# Likewise what the programs of MPI lack.
mpi_lacks=
[ -e /usr/include/boost/mpi.hpp ] || mpi_lacks+=" libboost-mpi-dev"
command -v mpicxx > /dev/null || mpi_lacks+=" libopenmpi-dev"
command -v mpirun > /dev/null || mpi_lacks+=" openmpi-bin"

for name in "${presets[@]}"; do
    echo "== $name"
    # This sanitizer changes what GCC's optimiser sees, and with it what it warns of.
    case "$name" in
        tsan) strict=OFF ;;
        *) strict=ON ;;
    esac
    python=OFF
    case "$name" in
        release | packages | asan) [ -n "$python_lacks" ] || python=ON ;;
    esac
    ompl=OFF
    mpi=OFF
    if [ "$name" = release ]; then
        ompl=$ompl_found
        [ -n "$mpi_lacks" ] || mpi=ON
    fi
    # Packages are made of the release build, and hold nothing that stands on OMPL or MPI.
    build=$name
    [ "$name" != packages ] || build=release
    cmake --preset "$build" -DASV_BUILD_TESTS=ON -DASV_WARNINGS_AS_ERRORS="$strict" \
        -DASV_BUILD_PYTHON="$python" -DASV_BUILD_OMPL="$ompl" -DASV_BUILD_MPI="$mpi"
    cmake --build --preset "$build"
    report=build/$build/$name-tests.xml
    code=0
    # Half of the random cases are left to release, unless the caller wants another share.
    scale=${ASV_TEST_SCALE:-1}
    [ "$name" != quick ] || scale=${ASV_TEST_SCALE:-0.5}
    # Many tests wait for a process most of their time.
    ASV_TEST_SCALE=$scale ctest --preset "$name" -j "$((2 * $(nproc)))" --output-junit "$PWD/$report" || code=$?
    skipped "$report"
    if [ "$code" -ne 0 ]; then
        # What fails beside others and passes alone was kept from its time, not wrong; it is told all the same.
        echo "Failed beside others, run again alone:"
        cut --delimiter=: --fields=2 "build/$build/Testing/Temporary/LastTestsFailed.log"
        code=0
        ASV_TEST_SCALE=$scale ctest --preset "$name" --rerun-failed || code=$?
    fi
    [ "$name" = quick ] || [ "$python" = ON ] || [ -z "$python_lacks" ] ||
        echo "No Python module: missing$python_lacks"
    case "$name" in
        quick)
            echo "No Python module, nothing of OMPL, no programs of MPI, no site: tools/test.sh release has them"
            ;;
        release)
            [ "$ompl" = ON ] || echo "Nothing of OMPL: missing libompl-dev"
            [ "$mpi" = ON ] || echo "No programs of MPI: missing$mpi_lacks"
            ;;
    esac
    [ "$code" -eq 0 ] || exit "$code"
done
