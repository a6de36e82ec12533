#!/usr/bin/env python3
"""How much of the sources the tests have run: a table by room, of what gcov counted.

table.py BUILD [FOLDER] [--gate FOLDER=PERCENT]... [--missing]

BUILD is a build with the preset coverage whose tests have run; with FOLDER it is about what lies below
that alone. A gate asks that so many percent of the branches below a folder are taken; "." is everything.
Ends with 1 where a gate is missed, after some of the branches that were not taken; --missing prints all.

A branch is a way out of a decision of the source: both outcomes of each condition, each case of a
switch. gcov counts more, which is left out here:
- whether a call returns or throws, at every call that may;
- what happens at a line that holds nothing but brackets, where objects end;
- the value that has no case in a switch without default: the compiler warns of an enumerator without.
What else the compiler makes for exceptions counts, as gcov does not tell it from the rest.
The copies of a template or an inline function are one, where a line has as many branches in each.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("core", "geometry", "io", "tools")
PLACES_TO_PRINT = 30


def counts_of_decisions(arcs):
    """Without the pairs of which one is the exception: gcov names it right after the call's return."""
    kept = []
    for arc in arcs:
        if not arc["throw"]:
            kept.append(arc["count"])
        elif kept:
            kept.pop()
    return kept


def holds_only_brackets(line):
    return not line.strip(" {}();,")


def lacks_default(text, number):
    """Does a switch without default begin at this line of a formatted file?"""
    first = text[number - 1]
    if not first.lstrip().startswith("switch ("):
        return False
    end = first[: first.index("switch")] + "}"
    for line in text[number:]:
        if line.lstrip().startswith("default:"):
            return False
        if line.startswith(end):
            break
    return True


def text_of(name):
    return (SOURCE / name).read_text().splitlines()


class Coverage:
    """Counts of the lines and branches of each file, over all object files."""

    def __init__(self):
        self.lines = collections.defaultdict(collections.Counter)
        self.branches = collections.defaultdict(collections.Counter)

    def add(self, name, line):
        number = line["line_number"]
        self.lines[name][number] += line["count"]
        counts = counts_of_decisions(line["branches"])
        for place, count in enumerate(counts):
            self.branches[name][number, len(counts), place] += count

    def forget_what_nobody_wrote(self):
        for name, branches in self.branches.items():
            text = text_of(name)
            for number, size, place in list(branches):
                is_last = place == size - 1
                if holds_only_brackets(text[number - 1]) or (is_last and lacks_default(text, number)):
                    del branches[number, size, place]


def object_files(build):
    """The compiler's notes of each. Tests count for the headers that they have run."""
    for folder in FOLDERS:
        yield from (build / folder).rglob("*.gcno")
    for counts in (build / "tests").rglob("*.gcda"):
        yield counts.with_suffix(".gcno")


def lies_in(name, folder):
    return folder == "." or name.startswith(folder + "/")


def name_in_tree(path):
    """The path below the root of one of our sources; None for those of others."""
    if not path.is_relative_to(SOURCE):
        return None
    name = path.relative_to(SOURCE)
    return str(name) if name.parts[0] in FOLDERS else None


def read(build, folder):
    coverage = Coverage()
    command = ["gcov", "--json-format", "--stdout", "--branch-probabilities", *sorted(map(str, object_files(build)))]
    with subprocess.Popen(command, cwd=build, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as gcov:
        for record in filter(str.strip, map(bytes.decode, gcov.stdout)):
            for file in json.loads(record)["files"]:
                name = name_in_tree((build / file["file"]).resolve())
                for line in file["lines"] if name and lies_in(name, folder) else []:
                    coverage.add(name, line)
    if gcov.returncode != 0 or not coverage.lines:
        sys.exit(f"table.py: gcov has nothing to tell of {build}")
    coverage.forget_what_nobody_wrote()
    return coverage


def room_of(name):
    """core/search of core/search/trees/tree.hpp."""
    return "/".join(pathlib.Path(name).parent.parts[:2])


def tally(files, belongs):
    """How many counts there are in the files whose names belong, and how many of these are above zero."""
    counts = [count for name, of_file in files.items() if belongs(name) for count in of_file.values()]
    return len(counts), sum(count > 0 for count in counts)


def percent(total, reached):
    return 100 * reached / total if total else 100.0


def print_row(title, coverage, belongs):
    lines, branches = tally(coverage.lines, belongs), tally(coverage.branches, belongs)
    print(f"{title:24}{lines[0]:8}{percent(*lines):7.1f}%{branches[0]:10}{percent(*branches):7.1f}%")


def print_table(coverage):
    print(f"{'room':24}{'lines':>8}{'run':>8}{'branches':>10}{'taken':>8}")
    for room in sorted({room_of(name) for name in coverage.lines}):
        print_row(room, coverage, lambda name, room=room: room_of(name) == room)
    print_row("all", coverage, lambda name: True)


def missing(coverage, folder="."):
    """A text for each line of the source with a branch that was never taken."""
    for name in sorted(filter(lambda name: lies_in(name, folder), coverage.branches)):
        text = text_of(name)
        never = collections.Counter(key[0] for key, count in coverage.branches[name].items() if count == 0)
        for number in sorted(never):
            yield f"{name}:{number}: {never[number]} never taken: {text[number - 1].strip()}"


def is_missed(coverage, gate):
    folder, wanted = gate.rsplit("=", 1)
    total, reached = tally(coverage.branches, lambda name: lies_in(name, folder))
    if total > 0 and percent(total, reached) >= float(wanted):
        return False
    print(f"{folder}: {reached} of {total} branches are taken, {wanted} % are wanted. The first that are not:")
    print("\n".join(list(missing(coverage, folder))[:PLACES_TO_PRINT]))
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("folder", nargs="?", default=".")
    parser.add_argument("--gate", action="append", default=[], metavar="FOLDER=PERCENT")
    parser.add_argument("--missing", action="store_true")
    arguments = parser.parse_args()
    coverage = read(arguments.build.resolve(), arguments.folder)
    print_table(coverage)
    if arguments.missing:
        print("\n".join(missing(coverage)))
    sys.exit(1 if any([is_missed(coverage, gate) for gate in arguments.gate]) else 0)


if __name__ == "__main__":
    main()
