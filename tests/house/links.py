#!/usr/bin/env python3
"""Fails, and says where, when a relative link of a page under ROOT leads to no file, or when a page of
docs/ cannot be reached by links from docs/README.md. Usage: links.py ROOT"""

import os
import re
import sys
from pathlib import Path

LINK = re.compile(r'\]\(([^)]*)\)|^\[[^]]*\]: *([^ ]+)|(?:src|href|srcset)="([^"]*)"')
SCHEME = re.compile(r"[a-z]+:")


def pages():
    """All pages but those of packages from elsewhere and the bad ones that tests read."""
    found = [str(page) for page in Path(".").glob("*.md")]
    for top in ("docs", "testcases", "tests"):
        for folder, folders, files in os.walk(top):
            folders[:] = [name for name in folders if name != "node_modules" and not name.startswith("bad_")]
            found += [f"{folder}/{name}" for name in files if name.endswith(".md")]
    return sorted(found)


def links(page):
    """(line, target, the path in the tree it leads to) of each relative link; code is no link."""
    code = False
    for number, line in enumerate(Path(page).read_text().splitlines(), start=1):
        if re.match(r" *```", line):
            code = not code
        if code or line.startswith("    "):
            continue
        for match in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            target = re.sub(r'[ )"].*', "", next(filter(None, match.groups()), ""))
            if SCHEME.match(target):
                continue
            target = target.partition("#")[0]
            if target:
                yield number, target, os.path.normpath(os.path.join(os.path.dirname(page), target))


def reached_from(first):
    reached, waiting = set(), [first]
    while waiting:
        page = waiting.pop()
        if page in reached or not os.path.isfile(page):
            continue
        reached.add(page)
        for _, _, path in links(page):
            path = os.path.join(path, "README.md") if os.path.isdir(path) else path
            if path.endswith(".md"):
                waiting.append(path)
    return reached


def main():
    os.chdir(sys.argv[1])
    faults = [f"{page}:{line}: no file {target}"
              for page in pages() for line, target, path in links(page) if not os.path.exists(path)]
    reached = reached_from("docs/README.md")
    faults += [f"{page}:1: not reached from docs/README.md"
               for page in pages() if page.startswith("docs/") and page not in reached]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
