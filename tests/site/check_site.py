#!/usr/bin/env python3
"""Do the links of a built site lead somewhere, and does it need no network? check_site.py HTML

HTML: the folder with index.html. Every link to a page, a picture or a file must exist, anchors
included; no script, style or picture may come from another machine. Each page must be reached from
index.html, and the search must know words of pages and of the reference.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

WANTED_IN_SEARCH = ["brooms", "rrt", "completion", "solveopt", "validationreport"]


class Page(html.parser.HTMLParser):
    """What a page links to, what it loads, and the anchors that it has."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        for name in ("id", "name"):
            if given.get(name):
                self.anchors.add(given[name])
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        elif tag in ("img", "script", "source", "iframe") and given.get("src"):
            self.loaded.append(given["src"])
        elif tag == "link" and given.get("rel") in ("stylesheet", "icon", "preload"):
            self.loaded.append(given["href"])


def is_remote(link):
    return bool(re.match(r"[a-z]+:|//", link))


def faults_of(path, page, pages):
    """What is wrong with the links of one page, and which pages it leads to."""
    faults, reached = [], set()
    for link in page.loaded:
        if is_remote(link) and not link.startswith("data:"):
            faults.append(f"needs the network: {link}")
    for link in page.links + page.loaded:
        if is_remote(link):
            continue
        parts = urllib.parse.urlsplit(link)
        file = urllib.parse.unquote(parts.path)
        target = (path.parent / file).resolve() if file else path
        anchor = urllib.parse.unquote(parts.fragment)
        if not target.exists():
            faults.append(f"no file: {link}")
        elif target in pages:
            reached.add(target)
            if anchor and anchor not in pages[target].anchors:
                faults.append(f"no anchor: {link}")
    return faults, reached


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(root.rglob("*.html"))}
    faults, links = [], {}
    for path, page in pages.items():
        found, links[path] = faults_of(path, page, pages)
        faults += [f"{path.relative_to(root)}: {fault}" for fault in found]

    reached, waiting = set(), [root / "index.html"]
    while waiting:
        path = waiting.pop()
        if path not in reached:
            reached.add(path)
            waiting += links[path]
    for path in sorted(set(pages) - reached - {root / "search.html"}):  # a form leads there
        faults.append(f"{path.relative_to(root)}: not reached from index.html")

    words = (root / "searchindex.js").read_text()
    faults += [f"search does not know '{word}'" for word in WANTED_IN_SEARCH if word not in words]
    for style in root.rglob("*.css"):
        for link in re.findall(r"url\([\"']?(https?:)?//[^)]*\)", style.read_text()):
            faults.append(f"{style.relative_to(root)}: needs the network: {link}")

    print("\n".join(faults) or f"{len(pages)} pages, all links lead somewhere")
    sys.exit(1 if faults else 0)


main()
