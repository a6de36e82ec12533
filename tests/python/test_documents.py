"""The pages: their Python is the text of the examples or is run; what they print is what is shown."""

import contextlib
import io
import re
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
EXAMPLES = sorted((ROOT / "docs" / "examples").glob("*.py"))
BLOCK = re.compile(r"^```(python|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
HEAD = re.compile(r"# (docs/examples/(\w+)\.py)(?:: (\w+))?\n")


def blocks():
    """(page, kind, text) of every block of Python or of what it prints."""
    return [(page, kind, text) for page in PAGES
            for kind, text in BLOCK.findall(page.read_text(encoding="utf-8"))]


def part_of(text, name):
    """What stands between "# part: NAME" and "# end of part"."""
    return text.split(f"# part: {name}\n", 1)[1].split("# end of part\n", 1)[0]


def test_blocks_that_name_an_example_are_its_text():
    shown = set()
    for page, kind, text in blocks():
        head = HEAD.match(text)
        if kind == "python" and head:
            file, name, part = head.groups()
            whole = (ROOT / file).read_text(encoding="utf-8")
            expected = part_of(whole, part) if part else whole
            assert text[head.end():] == expected.strip("\n") + "\n", f"{page}: {file}"
            shown.add(name)
    assert shown == {file.stem for file in EXAMPLES}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_examples_print_what_the_page_shows(example, tmp_path):
    printed = subprocess.run([sys.executable, example], cwd=tmp_path, check=True,
                             capture_output=True, text=True).stdout
    expected = [following for (_, kind, text), (_, _, following) in zip(blocks(), blocks()[1:])
                if kind == "python" and (head := HEAD.match(text)) and head[2] == example.stem
                and head[3] in (None, "lesson")]
    assert [printed] == expected
    for picture in tmp_path.glob("*.svg"):
        assert picture.read_text().lstrip().startswith(("<?xml", "<svg"))


@pytest.mark.parametrize("page", sorted({page for page, kind, _ in blocks() if kind == "python"}),
                         ids=lambda page: page.name)
def test_other_blocks_run_one_after_the_other(page, tmp_path, monkeypatch):
    """All blocks of a page share their names; a block of text behind one is what it prints."""
    monkeypatch.chdir(tmp_path)
    shutil.copytree(ROOT / "testcases", "testcases")
    names, printed = {}, None
    for _, kind, text in [block for block in blocks() if block[0] == page]:
        if kind == "text":
            assert printed is None or printed == text, f"{page.name} shows:\n{text}"
        elif HEAD.match(text):
            printed = None
        else:
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile(text, str(page), "exec"), names)
            printed = out.getvalue()
