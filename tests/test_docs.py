"""What the texts say about the tree is so: the paths that they name, the functions of the diagrams, the map."""

from __future__ import annotations

import ast
import re
from pathlib import Path, PurePosixPath

import pytest

from sceneweaver.assets import categories
from tests.test_repository import ROOT, code_blocks, tracked_files

TEXTS = ["README.md", "CONTRIBUTING.md", *(p.relative_to(ROOT).as_posix() for p in (ROOT / "docs").rglob("*.md"))]
NAMED = re.compile(r"(?:[\w.*-]+/)*[\w.*-]+\.(?:py|yaml|schema\.json)|(?:[\w.*-]+/)+(?=[\s`,;)]|$)")
LINKED = re.compile(r"^sceneweaver/(?=(kernels|optimizers|tools|toolcards)/)")
OUTPUTS = (
    "out/",
    "views/",
    "steps/",
    "meshes/",
    "models/",
    "sdf/",
    "urdf/",
    "meta/",
    "work/",
    "spec.yaml",
)  # what commands write


@pytest.fixture(scope="module")
def tree() -> list[PurePosixPath]:
    """Files and folders under version control."""
    files = {PurePosixPath(path.relative_to(ROOT).as_posix()) for path in tracked_files()}
    return sorted(files | {parent for path in files for parent in path.parents})


def prose(text: str) -> str:
    """The text without examples of code; diagrams stay."""
    return re.sub(r"^```(?!mermaid).*?^```", "", text, flags=re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("name", TEXTS)
def test_every_path_that_a_text_names_is_there(name, tree):
    quoted = re.findall(r"`([^`\n]+)`|\"([^\"\n]+)\"", prose((ROOT / name).read_text()))
    named = {path for one, other in quoted for path in NAMED.findall(one or other)}
    missing = [
        path
        for path in sorted(named)
        if not path.startswith(OUTPUTS) and not any(p.match(LINKED.sub("", path.rstrip("/"))) for p in tree)
    ]
    assert missing == []


def test_every_box_of_a_diagram_is_a_function_or_class_of_its_file():
    diagrams = "".join(code_blocks((ROOT / "docs" / "architecture.md").read_text(), "mermaid"))
    boxes = re.findall(r"\[\"([\w/]+\.py): (\w+)\"\]", diagrams)
    assert len(boxes) >= 20 and len(boxes) == diagrams.count('["')
    for path, name in boxes:
        defined = {getattr(node, "name", None) for node in ast.parse((ROOT / path).read_text()).body}
        assert name in defined, f"{path} has no {name}"


def test_the_map_names_every_folder(tree):
    text = (ROOT / "CONTRIBUTING.md").read_text()
    named = set(re.findall(r"`([\w./-]+)/`", text.split("## Map")[1].split("## Floors")[0]))
    floors = {f"sceneweaver/{name}" for name in re.findall(r"^\| `(\w+)` \|", text.split("## Floors")[1], re.MULTILINE)}
    folders = {path.as_posix() for path in tree if (ROOT / path).is_dir()} - {"."}
    inner = {f"tests/{Path(floor).name}" for floor in floors} | {"tests/benchmarks"}  # tests of a floor
    inner |= {folder for folder in folders if folder.startswith(("tests/oracle/", "tests/export/"))}
    assert folders - inner - floors - named == set()
    assert named - folders == set()


def test_texts_agree_on_how_many_categories_are_drawn():
    drawn = sum(category.size is not None for category in categories().values())
    texts = [*TEXTS, *(path.relative_to(ROOT).as_posix() for path in sorted((ROOT / "notebooks").glob("*.ipynb")))]
    # The changelog and pages of one run tell of their own time.
    found = {
        (name, int(number.replace(",", "")))
        for name in texts
        for number in re.findall(r"(?i)more than ([\d,]+) (?:categories|kinds of furniture)", (ROOT / name).read_text())
    }
    assert {name for name, _ in found} >= {"README.md", "docs/index.md"}
    assert found == {(name, drawn // 100 * 100) for name, _ in found}
