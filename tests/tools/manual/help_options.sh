# The options that --help tells, for other scripts to source.

# help_options PROGRAM [FAMILY]: its options, short and long ones, one a line, sorted.
help_options() {
    "$@" --help | awk '
        /^Options:/ { inside = 1; next }
        /^[A-Z][a-z]*:/ { inside = 0 }
        inside && /^  -/ { gsub(",", "\n", $1); print $1 }
    ' | LC_ALL=C sort -u
}

# help_families PROGRAM: its subcommands.
help_families() {
    "$1" --help | awk '/^Subcommands:/ { inside = 1; next } /^[^ ]/ { inside = 0 } inside && /^  [a-z]/ { print $1 }'
}
