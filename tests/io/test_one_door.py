"""Files are opened on one floor: what others wrote is bounded there, and what is ours is written whole."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2] / "sceneweaver"

METHODS = {
    *("read_text", "read_bytes", "write_text", "write_bytes"),
    *("load_scene", "load_mesh", "Open", "OpenMasked", "from_xml_path", "from_file", "from_zip"),
    *("ParquetFile", "ParquetDataset", "read_metadata", "memory_map", "fromfile", "loadtxt", "genfromtxt"),
}
"""Names of methods and of functions of modules that open files."""

READERS = {
    *("json.load", "np.load", "os.open", "gzip.open", "Image.open", "trimesh.load", "io.open", "pickle.load"),
    *("ElementTree.parse", "ElementTree.fromstring", "Xml.parse", "Xml.fromstring", "ET.parse", "ET.fromstring"),
    *("parquet.read_table", "parquet.read_schema", "pq.read_table", "csv.reader", "csv.DictReader"),
    *("yaml.load", "yaml.safe_load", "yaml.parse", "yaml.load_all", "tarfile.open", "zipfile.ZipFile"),
}
"""What reads a file, or a text in a language that has to be bounded first."""

MODULES = {"yaml", "zipfile", "tarfile", "bz2", "lzma", "shelve", "configparser"}

NAMED = re.compile(rf"\b(?:{'|'.join({'open', *MODULES, *METHODS, *(name.partition('.')[2] for name in READERS)})})\b")
"""Words of which a source has one where it opens anything."""

ALONE = {
    "runtime/deadline.py": "what the system says of this process",
    "runtime/memory.py": "what the system says of this process",
    "runtime/processes.py": "what the system says of a process",
    "bench/results.py": "what the system says of its processor",
    "physics/mjcf_file.py": "a program that runs where the library is not installed",
    "assets/sources/infinigen_worker.py": "a program for another environment",
}
"""Files that may open others, and why."""


def tree() -> list[Path]:
    """The sources of the library but those of the floor itself; folders that are links are walked as well."""
    folders = [ROOT, *(path.resolve() for path in ROOT.iterdir() if path.is_symlink())]
    found = {file.resolve() for folder in folders for file in folder.rglob("*.py")}
    return sorted(file for file in found if not file.is_relative_to(ROOT / "io"))


def doors(source: str) -> list[str]:
    """The calls and imports of a source that open files."""
    found: list[str] = []
    if not NAMED.search(source):
        return found
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module or ""]
            found += [f"line {node.lineno}: import {name}" for name in names if name.partition(".")[0] in MODULES]
        elif isinstance(node, ast.Call) and _opens(node.func) and not _of_a_stream(node):
            found.append(f"line {node.lineno}: {ast.unparse(node.func)}")
    return found


def _opens(func: ast.expr) -> bool:
    if isinstance(func, ast.Attribute):
        of = func.value.attr if isinstance(func.value, ast.Attribute) else getattr(func.value, "id", "")
        return func.attr in METHODS or f"{of}.{func.attr}" in READERS
    return isinstance(func, ast.Name) and func.id == "open"


def _of_a_stream(call: ast.Call) -> bool:
    """Whether it opens what is open already, such as the terminal, or the null device."""
    return bool(call.args) and ast.unparse(call.args[0]).startswith(
        ("os.dup(", "os.devnull", "os.memfd_create(", "descriptor")
    )


def test_nothing_but_io_opens_files():
    found = {}
    for file in tree():
        name = file.relative_to(ROOT if file.is_relative_to(ROOT) else ROOT.parent).as_posix()
        if name not in ALONE and (doors_of := doors(file.read_text(encoding="utf-8"))):
            found[name] = doors_of
    assert found == {}


@pytest.mark.parametrize(
    "source",
    [
        "open('a')",
        "import yaml",
        "from zipfile import ZipFile",
        "Path('a').read_text()",
        "import json\njson.load(file)",
        "np.load('a')",
        "trimesh.load_scene('a')",
        "Usd.Stage.Open('a')",
        "ElementTree.fromstring(text)",
        "pa.parquet.ParquetFile('a')",
        "def f():\n    import tarfile",
    ],
)
def test_a_door_is_found(source):
    assert doors(source)


@pytest.mark.parametrize(
    "source", ["webbrowser.open(url)", "open(os.dup(2), 'w')", "open(os.devnull)", "handles.open(1)"]
)
def test_other_things_may_be_opened(source):
    assert not doors(source)
