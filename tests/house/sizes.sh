#!/usr/bin/env bash
# Fails, and says where, when something under ROOT has outgrown what one reads in one go:
#   - a function of more than 50 lines, from the line of its name to its closing brace, lambdas
#     inside it included (C++ and JavaScript);
#   - a source file of more than 300 lines. CMake lists, style sheets and pages (HTML) are free:
#     they are lists, which no splitting makes shorter;
#   - a folder with more than a dozen source files at its root; x.hpp and x.cpp count as one.
# The functions of C++ are those that ctags knows; of JavaScript, whose ends this ctags does not
# tell, those that begin with a line ending in "{" and end with a "}" under its first character.
# Usage: sizes.sh ROOT
set -euo pipefail
cd "${1:?usage: sizes.sh ROOT}"
max_function=50
max_file=300
max_folder=12

[[ $(ctags --version 2> /dev/null) == 'Universal Ctags'* ]] || { echo "skipped: no universal-ctags"; exit 77; }

# Generated files, other people's files and the bad examples of these tests are not ours to cut.
files() {
    find . \( -name 'build*' -o -name install -o -name node_modules -o -name 'bad_*' -o -name '.?*' \) -prune \
        -o -type f "$@" -print | sed 's,^\./,,' | LC_ALL=C sort
}

long_functions() {
    files \( -name '*.cpp' -o -name '*.hpp' \) |
        ctags -L - --c++-kinds=f --fields=+ne --output-format=xref --_xformat='%F %n %e %N' -f - |
        awk -v max="$max_function" '$3 - $2 + 1 > max {
            print $1 ":" $2 ": function " $4 " of " $3 - $2 + 1 " lines"
        }'
    files \( -name '*.js' -o -name '*.mjs' \) | xargs -r awk -v max="$max_function" '
        FNR == 1 { depth = 0 }
        { indent = match($0, /[^ ]/) }
        /^ *}/ && depth > 0 && indent == indents[depth] {
            lines = FNR - starts[depth] + 1
            if (lines > max) print FILENAME ":" starts[depth] ": function of " lines " lines"
            --depth
        }
        /(=>|\)) \{$/ && !/^ *(}? *else )?(if|for|while|switch) / { indents[++depth] = indent; starts[depth] = FNR }
    '
}

long_files() {
    files \( -name '*.[ch]pp' -o -name '*.js' -o -name '*.mjs' -o -name '*.sh' -o -name '*.py' \) |
        xargs -r awk -v max="$max_file" '
            { lines[FILENAME] = FNR }
            END { for (file in lines) if (lines[file] > max) print file ":1: file of " lines[file] " lines" }
        ' | LC_ALL=C sort
}

full_folders() {
    files \( -name '*.[ch]pp' -o -name '*.js' -o -name '*.mjs' -o -name '*.sh' -o -name '*.py' \) |
        sed 's,\.[a-z]*$,,' | uniq | sed 's,/[^/]*$,,' | sort | uniq -c |
        awk -v max="$max_folder" '$1 > max { print $2 ":1: folder of " $1 " source files" }'
}

found=$(long_functions; long_files; full_folders)
[ -z "$found" ] || { echo "$found"; exit 1; }
