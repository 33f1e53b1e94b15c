"""A tool never solves poses: it proposes objects and relations, and the engine finds where things stand."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import sceneweaver.generate
import sceneweaver.tools
from tests.for_each import for_each

FOLDERS = (Path(module.__file__ or "").parent for module in (sceneweaver.tools, sceneweaver.generate))
FILES = sorted(p for folder in FOLDERS for p in folder.glob("*.py") if p.name != "__init__.py")

MAY_POSE = {
    "carry": "what stands on something goes where it goes",
    "library": "a room of the library is mirrored and stretched with its poses",
    "reshape": "a room of the library goes into another shape with its poses",
    "surface_setting": "what stands on surfaces: placed in Python so far",
    "update_rotation": "the turn that the request says in words",
    "wall_objects": "free rectangles of walls: searched in Python so far",
}
"""Modules that make poses, and why."""

ENGINE = ("layout", "kernels", "optimizers")


def _neutral(call: ast.Call) -> bool:
    """Whether a pose is a start that says nothing: the origin, at a height that its mount gives."""
    if not call.args and not call.keywords:
        return True
    given = {k.arg: k.value for k in call.keywords}
    position = given.get("position")
    if call.args or set(given) != {"position"} or not isinstance(position, ast.Tuple):
        return False
    return all(isinstance(v, ast.Constant) and v.value == 0.0 for v in position.elts[:2])


def _poses(tree: ast.AST) -> list[int]:
    """Lines where a pose is made that is not neutral."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            name = ast.unparse(node.func)
            if name.endswith("from_yaw") or (name.split(".")[-1] == "Pose" and not _neutral(node)):
                found.append(node.lineno)
    return found


@for_each(FILES)
def test_tools_make_no_poses(file):
    lines = _poses(ast.parse(file.read_text("utf-8")))
    assert bool(lines) == (file.stem in MAY_POSE), f"{file.name}: poses in lines {lines}"


@for_each(FILES)
def test_tools_do_not_know_the_engine(file):
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
        names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        assert not any(part in ENGINE for name in names for part in name.split(".")), names


@pytest.mark.parametrize(
    ("text", "neutral"),
    [
        ("Pose()", True),
        ("Pose(position=(0.0, 0.0, z))", True),
        ("Pose(position=(x, 0.0, 0.0))", False),
        ("Pose(position=p)", False),
        ("Pose(position=(0.0, 0.0, 0.0), quaternion=q)", False),
        ("scene.Pose(p)", False),
        ("Pose.from_yaw(0.0, 0.0, 0.0, 0.0)", False),
    ],
)
def test_what_counts_as_a_pose(text, neutral):
    assert bool(_poses(ast.parse(text))) is not neutral
