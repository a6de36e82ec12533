#!/usr/bin/env python3
"""Lays out the sources of the site: stage.py ROOT XML OUT

ROOT: the project's folder. XML: what Doxygen made of the public headers. OUT: gets the pages at the
places that they have in the tree, so that their links lead where they did, what they link to, an
index made of docs/README.md, and a page of reference for each folder of headers.
"""

import pathlib
import re
import shutil
import sys

import reference

HERE = pathlib.Path(__file__).parent
TOP_PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "testcases/README.md"]
PLAYGROUND = "build/playground/asv-playground.html"
ALIVE = re.compile(r'<img src="[^"]*" alt="([^"]*)" width="(\d+)" data-alive="([^"]*)">')
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)|(?:src|srcset)=\"([^\"]+)\"")


def pages(root):
    """The paths of all pages, relative to the root."""
    found = [root / page for page in TOP_PAGES] + sorted((root / "docs").rglob("*.md"))
    return [page.relative_to(root) for page in found if page.exists()]


def adapted(text):
    """The text of a page as MyST understands it: pictures for two colour schemes, code blocks."""
    text = re.sub(
        r'<picture>\s*<source [^>]*srcset="([^"]*)">\s*<img src="([^"]*)"([^>]*)>\s*</picture>',
        r'<img src="\2"\3 class="only-light">\n<img src="\1"\3 class="only-dark">',
        text,
    )
    return re.sub(r"^```walk$", "```text", text, flags=re.MULTILINE)


def alive(text, page):
    """The text with its pictures of the playground replaced by the playground itself, in frames."""
    playground = "../" * (len(page.parts) - 1) + "_static/" + pathlib.Path(PLAYGROUND).name
    return ALIVE.sub(
        rf'<iframe src="{playground}?\3" title="\1" width="\2" height="700" style="max-width: 100%; border: 0" loading="lazy"></iframe>', text
    )


def stage_pages(root, out):
    """Copies the pages and the files that they link to."""
    for page in pages(root):
        text = (root / page).read_text()
        if (root / PLAYGROUND).is_file():
            text = alive(text, page)
        target = out / page
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(adapted(text))
        for link in LINK.finditer(text):
            linked = (root / page).parent / (link[1] or link[2])
            if linked.is_file() and linked.suffix != ".md":
                copy = out / linked.resolve().relative_to(root)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(linked, copy)


def toctree(caption, entries):
    lines = [f"```{{toctree}}\n:hidden:\n:caption: {caption}\n"]
    return "\n".join(lines + entries) + "\n```\n"


def contents(root):
    """The chapters of docs/README.md, each with its pages, as a sidebar has them."""
    caption, chapters = "", {}
    for line in (root / "docs/README.md").read_text().splitlines():
        if line.endswith(":") and not line.startswith("-"):
            caption = line[:-1]
        link = re.match(r"- \[[^]]*\]\(([^)#]+\.md)", line)
        if link:
            page = (root / "docs" / link[1]).resolve().relative_to(root)
            chapters.setdefault(caption, []).append(str(page))
    chapters.setdefault("Begin here", []).insert(0, "docs/README.md")
    return chapters


def stage_index(root, out):
    """The first page, and the contents of the sidebar; what is in no list is an orphan."""
    chapters = contents(root)
    text = (HERE / "index.md").read_text()
    for caption, entries in chapters.items():
        text += "\n" + toctree(caption, entries)
    text += "\n" + toctree("Reference", ["api/index.rst"])
    (out / "index.md").write_text(text)
    listed = {entry for entries in chapters.values() for entry in entries}
    for page in pages(root):
        if str(page) not in listed:
            path = out / page
            path.write_text("---\norphan: true\n---\n\n" + path.read_text())


def main():
    root, xml, out = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    stage_pages(root, out)
    stage_index(root, out)
    reference.write_pages(xml, out / "api")
    shutil.copytree(HERE / "_static", out / "_static")


main()
