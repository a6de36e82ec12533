"""The pages of reference: for each folder of public headers one, with a section for each header."""

import collections
import re
import xml.etree.ElementTree as ElementTree

# What Breathe calls the kinds of members that Doxygen finds in a namespace.
DIRECTIVES = {
    "enum": "doxygenenum",
    "typedef": "doxygentypedef",
    "variable": "doxygenvariable",
    "function": "doxygenfunction",
}


class Header:
    """One public header: its path, and the directives that show what it declares."""

    def __init__(self):
        self.entries = []

    def add(self, directive, name, options=()):
        lines = [f".. {directive}:: {name}"] + [f"   :{option}:" for option in options]
        self.entries.append("\n".join(lines) + "\n\n")


def simplify(xml):
    """Leaves out default values that Sphinx cannot read: {.step = 0}."""
    for file in xml.glob("*.xml"):
        text = file.read_text()
        simpler = re.sub(r"<initializer>[^<]*\{ ?\.[^<]*</initializer>", "", text)
        if simpler != text:
            file.write_text(simpler)


def add_classes(compound, headers):
    """A class or struct; one inside another is shown with that one."""
    kind, name = compound.get("kind"), compound.findtext("compoundname")
    file = compound.find("location").get("file")
    if not re.fullmatch(r"asv::(core|geometry|io)(::[a-z_]+)*::\w+", name):
        return
    headers[file].add(f"doxygen{kind}", name, ["members", "undoc-members"])


def add_members(compound, headers):
    """Functions, enumerations, aliases and constants of a namespace."""
    namespace = compound.findtext("compoundname")
    members = compound.findall("sectiondef/memberdef")
    overloads = collections.Counter(member.findtext("name") for member in members)
    for member in members:
        name = member.findtext("name")
        shown = f"{namespace}::{name}"
        if member.get("kind") == "function" and overloads[name] > 1:
            shown += member.findtext("argsstring")
        headers[member.find("location").get("file")].add(DIRECTIVES[member.get("kind")], shown)


def declared(xml):
    """All headers that declare something, by their path."""
    headers = collections.defaultdict(Header)
    for file in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(file).getroot().findall("compounddef"):
            if compound.get("kind") in ("class", "struct"):
                add_classes(compound, headers)
            elif compound.get("kind") == "namespace":
                add_members(compound, headers)
    return headers


def heading(text, underline):
    return f"{text}\n{underline * len(text)}\n\n"


def write_pages(xml, out):
    """Writes OUT/index.rst and a page for each folder."""
    simplify(xml)
    folders = collections.defaultdict(str)
    for file, header in sorted(declared(xml).items()):
        folder, _, name = file.removeprefix("asv/").rpartition("/")
        folders[folder] += heading(name, "-") + f".. code-block:: cpp\n\n   #include <{file}>\n\n"
        folders[folder] += "".join(header.entries)
    out.mkdir()
    index = heading("Reference of the C++ library", "=")
    index += "Every public header, by its folder; :doc:`/docs/library` tells how to use them, "
    index += ":ref:`the index <genindex>` has every name.\n\n"
    index += ".. toctree::\n   :maxdepth: 2\n\n"
    for folder, text in folders.items():
        page = folder.replace("/", "-")
        index += f"   {page}\n"
        (out / f"{page}.rst").write_text(heading(folder, "=") + text)
    (out / "index.rst").write_text(index)
