"""What the tests of the schemas share: the schemas of docs/schemas/ behind a validator, and the programs."""

import json
import subprocess
import sys
from pathlib import Path

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: no jsonschema (Debian package python3-jsonschema)")
    sys.exit(77)

root, programs = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
schemas = {file.name.removesuffix(".schema.json"): json.loads(file.read_text())
           for file in sorted((root / "docs" / "schemas").glob("*.schema.json"))}
# The lines of a journal are told where its runs are.
schemas["journal_line"] = {"$defs": schemas["benchmark"]["$defs"], "$ref": "#/$defs/journal_line"}
_faults = 0


def fault_of(value, schema):
    """What the schema of that name has against the value, with its place; None where it has nothing."""
    error = next(Draft202012Validator(schemas[schema]).iter_errors(value), None)
    return f"{error.json_path}: {error.message}"[:400] if error else None


def expect(holds, message):
    global _faults
    if not holds:
        _faults += 1
        print(message)


def end():
    sys.exit(1 if _faults else 0)


def run(program, *arguments, code=0):
    """Standard error of a program that shall end with this code, or None for any."""
    done = subprocess.run([programs / program, *map(str, arguments)], capture_output=True, text=True, check=False)
    expect(code is None or done.returncode == code,
           f"{program} {' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stderr}")
    return done


def places(value, at=()):
    """The paths of all values inside a document, itself included."""
    yield at
    for key, inner in value.items() if isinstance(value, dict) else \
            enumerate(value) if isinstance(value, list) else ():
        yield from places(inner, (*at, key))


def value_at(value, at):
    for key in at:
        value = value[key]
    return value


def with_value(document, at, value):
    """A copy of the document in which something else stands there."""
    if not at:
        return value
    copy = json.loads(json.dumps(document))
    value_at(copy, at[:-1])[at[-1]] = value
    return copy


def without(document, at):
    """A copy of the document without the member there."""
    copy = json.loads(json.dumps(document))
    del value_at(copy, at[:-1])[at[-1]]
    return copy
