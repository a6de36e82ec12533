#!/usr/bin/env bash
# Fails, and says where, when an include in the rooms under ROOT runs against
#     geometry <- core <- io <- tools
# or is not written "asv/<room>/<file>"; when CGAL is met outside geometry's .cpp files; and when
# geometry or core know of streams or files.
# Usage: include_direction.sh ROOT
set -euo pipefail
cd "${1:?usage: include_direction.sh ROOT}"

find geometry core io tools -type f -name '*.[chi]*' -print0 | LC_ALL=C sort -z | xargs -0 awk '
    BEGIN {
        split("geometry core io tools", rooms, " ")
        for (i in rooms) rank[rooms[i]] = i
    }
    function complain(what) {
        print FILENAME ":" FNR ": " what
        bad = 1
    }
    match($0, /^[ \t]*#[ \t]*include[ \t]*[<"][^>"]*/) {
        name = substr($0, RSTART, RLENGTH)
        quoted = sub(/^[^"<]*"/, "", name)
        sub(/^[^<]*</, "", name)
        split(FILENAME, own, "/")
        split(name, part, "/")
        if (part[1] == "asv") {
            if (!(part[2] in rank))
                complain("there is no room " part[2])
            else if (rank[part[2]] > rank[own[1]])
                complain(own[1] " includes " part[2])
        } else if (quoted) {
            complain("\"" name "\" is not written \"asv/<room>/<file>\"")
        }
        if (part[1] == "CGAL" && !(own[1] == "geometry" && FILENAME ~ /\.cpp$/))
            complain("CGAL outside the .cpp files of geometry")
        if ((own[1] == "geometry" || own[1] == "core") &&
            name ~ /^(iostream|istream|ostream|fstream|filesystem)$/)
            complain(own[1] " includes <" name ">")
    }
    END { exit bad }
'
