#!/usr/bin/env bash
# Installs the Debian packages that the project needs: install_packages.sh [build|test|ci|python|ompl|mpi|package|
# package_test|site|tex|playground|fuzz]. "build" is what the libraries and programs need, "test" adds what the tests need,
# "ci" the second compiler as well; "python" is "build" and what the Python module and its tests need; "ompl" is "build" and OMPL;
# "mpi" is "build" and what ASV_BUILD_MPI needs;
# "package" is "build" and what makes Debian packages, "package_test" what tries them as well; "site" is
# what tools/site.sh needs, with what it takes to configure the project; "tex" is "build" and what puts tables
# and figures of asv-bench into a page of LaTeX; "playground" is what tools/playground.sh needs to compile the
# planner for a browser; "fuzz" is "build" and what tools/fuzz.sh needs.
set -euo pipefail

build_packages=(
    g++ cmake ninja-build          # compiler and build system
    libcgal-dev                    # exact predicates
    libhwy-dev                     # vector code chosen at run time
    libeigen3-dev                  # linear algebra
    libboost-dev                   # graph algorithms, distributions
    libcli11-dev                   # command lines
    nlohmann-json3-dev             # JSON files
    libcairo2-dev pkg-config       # pictures
    libpng-dev                     # maps that are PNG pictures
    libyaml-dev                    # maps of ROS
    libsqlite3-dev                 # databases of benchmarks
    libjs-chart.js                 # charts in pages of benchmarks
)
test_packages=(
    libgtest-dev librapidcheck-dev # unit and property tests
    libbenchmark-dev               # benchmarks
    clang-format universal-ctags   # the form and the sizes of the sources
    gdb                            # the walk through the program
    python3                        # links between pages
    python3-jsonschema             # schemas of JSON files
    ffmpeg                         # films
)
manual_packages=(
    bash-completion zsh fish       # shells that complete
    mandoc groff                   # what finds faults in manual pages
)
ci_packages=(
    clang libclang-rt-dev          # a second compiler, and its sanitizers
)
python_packages=(
    pybind11-dev python3-dev       # C++ that Python can call
    python3-numpy                  # arrays
    python3-pip python3-venv       # wheels and where to install them
    python3-pytest                 # tests
    python3-matplotlib             # axes to draw on
)
ompl_packages=(
    libompl-dev                    # planners of OMPL, and ours among them
)
mpi_packages=(
    libboost-mpi-dev               # messages between processes
    libopenmpi-dev openmpi-bin     # what carries them, and mpirun
)
package_packages=(
    dpkg-dev file                  # which packages a program stands on
    chrpath                        # programs without search paths
)
package_test_packages=(
    lintian                        # Debian's own judge of packages
    mmdebstrap                     # a Debian with nothing in it
    qemu-user                      # an old processor
)
site_packages=(
    python3-sphinx python3-myst-parser furo # pages
    doxygen python3-breathe                 # the reference of the public headers
)
tex_packages=(
    texlive-latex-base             # pdflatex
    texlive-latex-recommended      # booktabs
    poppler-utils                  # what is in a PDF: fonts, pictures, text
)
playground_packages=(
    emscripten                     # a compiler for WebAssembly
    libstb-dev                     # reads PNG pictures there
)
fuzz_packages=(
    clang libclang-rt-dev          # a compiler with libFuzzer and its own sanitizers
)

what=${1:-build}
packages=("${build_packages[@]}")
case "$what" in
    ci) packages+=("${ci_packages[@]}") ;;
    package) packages+=("${package_packages[@]}") ;;
    package_test) packages+=("${package_packages[@]}" "${package_test_packages[@]}") ;;
    python) packages+=("${python_packages[@]}") ;;
    ompl) packages+=("${ompl_packages[@]}") ;;
    mpi) packages+=("${mpi_packages[@]}") ;;
    site) packages+=("${site_packages[@]}") ;;
    tex) packages+=("${tex_packages[@]}") ;;
    playground) packages+=("${playground_packages[@]}") ;;
    fuzz) packages+=("${fuzz_packages[@]}") ;;
esac
if [ "$what" = test ] || [ "$what" = ci ]; then
    packages+=("${test_packages[@]}" "${manual_packages[@]}")
    # A browser to open the player in, and what drives it; other sources of node serve as well.
    command -v chromium > /dev/null || packages+=(chromium)
fi
if [ "$what" = test ] || [ "$what" = ci ] || [ "$what" = playground ]; then
    command -v node > /dev/null || packages+=(nodejs)
    command -v npm > /dev/null || packages+=(npm)
fi

missing=()
for package in "${packages[@]}"; do
    dpkg-query --show --showformat='${Status}\n' "$package" 2> /dev/null |
        grep -q '^install ok installed$' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing ${missing[*]}"
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
