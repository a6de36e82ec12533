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
- which objects an exception ends on its way: what only exceptions lead to, at a line that also runs
  without one. What a handler of exceptions decides counts.
The copies of a template or an inline function are one, where a line has as many branches in each.
"""

import argparse
import collections
import concurrent.futures
import functools
import json
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("core", "geometry", "io", "tools")
PLACES_TO_PRINT = 30


def decisions(arcs):
    """Without the pairs of which one is the exception: gcov names it right after the call's return."""
    kept = []
    for arc in arcs:
        if not arc["throw"]:
            kept.append(arc)
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
        self.of_exceptions = collections.defaultdict(set)

    def add(self, name, line):
        number = line["line_number"]
        self.lines[name][number] += line["count"]
        kept = decisions(line["branches"])
        for place, arc in enumerate(kept):
            key = number, len(kept), place
            self.branches[name][key] += arc["count"]
            if arc["ends_objects"]:
                self.of_exceptions[name].add(key)

    def forget_what_nobody_wrote(self):
        for name, branches in self.branches.items():
            text = text_of(name)
            for number, size, place in list(branches):
                key, line = (number, size, place), text[number - 1]
                is_no_case = place == size - 1 and lacks_default(text, number)
                ends_objects = key in self.of_exceptions[name] and "} catch (" not in line
                if holds_only_brackets(line) or is_no_case or ends_objects:
                    del branches[key]


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


def gcov(build, notes, *options):
    """The lines that gcov prints of one object file."""
    command = ["gcov", "--branch-probabilities", "--stdout", *options, str(notes)]
    result = subprocess.run(command, cwd=build, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    if result.returncode != 0:
        sys.exit(f"table.py: gcov has nothing to tell of {notes}")
    return result.stdout.splitlines()


# Rows of gcov's text: a line of the source, and a block of one. A block that was not run has a sign instead
# of its count, which is the last one here where exceptions alone lead to it.
LINE = re.compile(r" *(?:\d+\*?|#{5}|={5}): *(\d+):")
BLOCK = re.compile(r" *(?:\d+\*?|%{5}|(\${5})): *\d+-block")
FILE = "        -:    0:Source:"


class SignsOfExceptions:
    """Which branches exceptions alone lead to, though not to their line: gcov's text tells it, its JSON does not."""

    def __init__(self, text):
        self.found = collections.defaultdict(list)
        name = number = of_exceptions = None
        branches, line_is_run = [], False
        for row in [*text, FILE]:
            if row.startswith("branch"):
                branches.append(of_exceptions)
            elif block := name and BLOCK.match(row):
                of_exceptions = block[1] is not None
                line_is_run |= not of_exceptions
            elif (line := name and LINE.match(row)) or row.startswith(FILE):
                if name and branches:
                    self.found[name, number].append([line_is_run and sign for sign in branches])
                branches, line_is_run = [], False
                if line:
                    number = int(line[1])
                else:
                    name = name_in_tree(pathlib.Path(row[len(FILE) :]))

    def next_of(self, name, line):
        """For the branches of a line, which the JSON tells in the same order; none where it differs."""
        count = len(line["branches"])
        told = self.found[name, line["line_number"]]
        signs = told.pop(0) if count > 0 and told else []
        return signs if len(signs) == count else [False] * count


def read_object(build, folder, notes):
    """Our lines in one object file, with the names of their files."""
    signs = SignsOfExceptions(gcov(build, notes, "--all-blocks"))
    lines = []
    for record in filter(str.strip, gcov(build, notes, "--json-format")):
        for file in json.loads(record)["files"]:
            name = name_in_tree((build / file["file"]).resolve())
            for line in file["lines"] if name and lies_in(name, folder) else []:
                for arc, sign in zip(line["branches"], signs.next_of(name, line)):
                    arc["ends_objects"] = sign
                lines.append((name, line))
    return lines


def read(build, folder):
    coverage = Coverage()
    with concurrent.futures.ProcessPoolExecutor() as pool:
        for lines in pool.map(functools.partial(read_object, build, folder), sorted(object_files(build))):
            for name, line in lines:
                coverage.add(name, line)
    if not coverage.lines:
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
