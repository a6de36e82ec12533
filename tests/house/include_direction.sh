#!/usr/bin/env bash
# Fails, and says where, when an include under ROOT goes to a room that rooms.txt does not allow, or
# is not the path of a file in the tree; when CGAL is met outside geometry's .cpp files; and when
# geometry or core know of streams or files.
# Usage: include_direction.sh ROOT
set -euo pipefail
rooms=$(cd "$(dirname "$0")" && pwd)/rooms.txt
cd "${1:?usage: include_direction.sh ROOT}"

find geometry core io tools -type f -name '*.[chi]*' -print0 | LC_ALL=C sort -z | xargs -0 awk -v rooms="$rooms" '
    # The longest room that the path lies in; empty if it lies in none.
    function room_of(path) {
        while (sub(/\/[^\/]*$/, "", path))
            if (path in allowed) return path
        return ""
    }
    function may_include(own, other,    count, names, i) {
        if (own == other) return 1
        count = split(allowed[own], names, " ")
        for (i = 1; i <= count; ++i)
            if (other == names[i] || index(other, names[i] "/") == 1) return 1
        return 0
    }
    function complain(what) {
        print FILENAME ":" FNR ": " what
        bad = 1
    }
    BEGIN {
        while ((getline line < rooms) > 0) {
            if (line ~ /^#/ || line !~ /:/) continue
            name = line
            sub(/:.*/, "", name)
            sub(/^[^:]*: */, "", line)
            allowed[name] = line
        }
    }
    match($0, /^[ \t]*#[ \t]*include[ \t]*[<"][^>"]*/) {
        name = substr($0, RSTART, RLENGTH)
        quoted = sub(/^[^"<]*"/, "", name)
        sub(/^[^<]*</, "", name)
        split(FILENAME, own, "/")
        if (quoted && (getline line < name) < 0)
            complain("\"" name "\" is not the path of a file")
        else if (quoted && !may_include(room_of(FILENAME), room_of(name)))
            complain(room_of(FILENAME) " includes " room_of(name))
        if (quoted) close(name)
        if (name ~ /^CGAL\// && !(own[1] == "geometry" && FILENAME ~ /\.cpp$/))
            complain("CGAL outside the .cpp files of geometry")
        if ((own[1] == "geometry" || own[1] == "core") &&
            name ~ /^(iostream|istream|ostream|fstream|filesystem)$/)
            complain(own[1] " includes <" name ">")
    }
    END { exit bad }
'
