"""The package itself: stubs, docstrings, examples of docstrings, what the compiler was told."""

import ast
import doctest
import importlib
import inspect
import json
import os
import pkgutil
from pathlib import Path

import pytest

import asv
from asv import _core


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_the_stub_has_what_the_compiled_module_has():
    stub = ast.parse((Path(asv.__file__).parent / "_core.pyi").read_text())
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert set(classes) | functions == public(dir(_core))
    for name, node in classes.items():
        members = public(member.name for member in node.body
                         if isinstance(member, ast.FunctionDef))
        assert members == public(dir(getattr(_core, name))), name


def test_the_stub_names_the_arguments_of_the_compiled_functions():
    stub = ast.parse((Path(asv.__file__).parent / "_core.pyi").read_text())
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            signature = getattr(_core, node.name).__doc__.splitlines()[0]
            for argument in node.args.args + node.args.kwonlyargs:
                assert f"{argument.arg}:" in signature, (node.name, argument.arg)


def test_everything_public_is_explained():
    assert sorted(asv.__all__) == asv.__all__
    for name in public(asv.__all__):
        thing = getattr(asv, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and not issubclass(thing, (BaseException, str)):
            for member in public(vars(thing)):
                if callable(getattr(thing, member)) or isinstance(vars(thing)[member], property):
                    assert inspect.getdoc(getattr(thing, member)), f"{name}.{member}"


def test_examples_in_docstrings():
    for module in pkgutil.iter_modules(asv.__path__):
        outcome = doctest.testmod(importlib.import_module(f"asv.{module.name}"))
        assert outcome.failed == 0, module.name
    assert doctest.testmod(asv).failed == 0


def test_it_is_typed_and_has_a_version():
    assert (Path(asv.__file__).parent / "py.typed").exists()
    assert asv.__version__.count(".") == 2


def test_nothing_is_compiled_for_this_machine_alone():
    commands = Path(os.environ.get("ASV_BUILD", "/none")) / "compile_commands.json"
    if not commands.exists():
        pytest.skip("ASV_BUILD names no build folder")
    for entry in json.loads(commands.read_text()):
        assert "-march" not in entry["command"] and "-mtune=native" not in entry["command"]
