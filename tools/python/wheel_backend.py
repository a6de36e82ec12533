"""What pip calls to make a wheel (PEP 517): builds the module with CMake and packs what CMake
installs as component `python`. The version is that of the root's CMakeLists.txt.

pip wheel . --config-settings build-dir=build/release takes what that build has already compiled.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

root = Path(__file__).resolve().parents[2]


def _run(*command):
    subprocess.run([str(part) for part in command], check=True)


def _compile(build):
    """Configures a fresh folder for this interpreter; one that is configured is used as it is."""
    if not (build / "CMakeCache.txt").exists():
        generator = ["-G", "Ninja"] if _has_ninja() else []
        _run("cmake", "-S", root, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release",
             "-DASV_BUILD_PYTHON=ON", "-DASV_BUILD_TOOLS=OFF", "-DASV_BUILD_TESTS=OFF",
             f"-DPython3_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", build, "--target", "asv_python", "--parallel", os.cpu_count() or 1)


def _has_ninja():
    return any((Path(folder) / "ninja").exists() for folder in os.get_exec_path())


def _installed(build, prefix):
    """The package's files as CMake installs them, by their names in the wheel."""
    _run("cmake", "--install", build, "--component", "python", "--strip", "--prefix", prefix)
    package = next(Path(prefix).rglob("asv/__init__.py")).parent
    files = sorted(path for path in package.rglob("*") if path.is_file())
    return {path.relative_to(package.parent).as_posix(): path.read_bytes() for path in files}


def _project():
    project = tomllib.loads((root / "pyproject.toml").read_text())["project"]
    lists = (root / "CMakeLists.txt").read_text()
    project["version"] = re.search(r"project\(asv VERSION ([0-9.]+)", lists)[1]
    return project


def _metadata(project):
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {name}" for name in project["dependencies"]]
    for extra, names in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f"Requires-Dist: {name}; extra == '{extra}'" for name in names]
    readme = (root / project["readme"]).read_text()
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def _tag():
    """The interpreter, its binary interface, the machine: cp311-cp311-linux_x86_64."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _record(files, record):
    """The list of all files with their digests, by which pip checks and uninstalls."""
    lines = []
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(content)}")
    return "\n".join([*lines, f"{record},,", ""])


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into the folder; returns its file name."""
    build = root / (config_settings or {}).get("build-dir", "build/wheel")
    project, tag = _project(), _tag()
    stem = f"{project['name']}-{project['version']}"
    _compile(build)
    with tempfile.TemporaryDirectory() as prefix:
        files = _installed(build, prefix)
    info = f"{stem}.dist-info"
    files[f"{info}/METADATA"] = _metadata(project).encode()
    files[f"{info}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: tools/python/wheel_backend.py\n"
                              f"Root-Is-Purelib: false\nTag: {tag}\n").encode()
    files[f"{info}/LICENSE"] = (root / "LICENSE").read_bytes()
    files[f"{info}/RECORD"] = _record(files, f"{info}/RECORD").encode()
    name = f"{stem}-{tag}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """All files that git knows, as a .tar.gz; returns its file name."""
    project = _project()
    stem = f"{project['name']}-{project['version']}"
    archive = Path(sdist_directory) / f"{stem}.tar.gz"
    with tempfile.TemporaryDirectory() as folder:
        info = Path(folder) / "PKG-INFO"
        info.write_text(_metadata(project))
        _run("git", "-C", root, "archive", f"--prefix={stem}/", f"--add-file={info}",
             "--output", archive.resolve(), "HEAD")
    return archive.name
