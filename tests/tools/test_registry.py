"""The registry finds our tools and those of other packages, and no broken one stops the others."""

from __future__ import annotations

import logging
import sys
import textwrap
from pathlib import Path

import pytest

from sceneweaver.scene import InputError, Scene
from sceneweaver.tools.card import own_card
from sceneweaver.tools.registry import GROUP, tool, tools

CARD = """
name: NAME
role: modifier
description: Paints all objects.
when: Colours clash.
when_not: They do not.
strengths: [quick]
weaknesses: [taste]
inputs: {type: object, properties: {color: {type: string}}}
example: {instruction: Paint it blue., inputs: {color: blue}}
"""

MODULE = """
from sceneweaver.scene.edits import SetAttributes
from sceneweaver.tools.base import Proposal


class Paint:
    name = "paint_all"

    def propose(self, context):
        color = context.inputs.get("color", "white")
        return Proposal(edits=tuple(SetAttributes(id=i, set={"color": color}) for i in context.scene.ids))
"""


@pytest.fixture
def site(tmp_path, monkeypatch):
    """A folder on the path that holds an installed package with the given files and entry points."""

    def install(points: dict[str, str], files: dict[str, str], name: str = "painters") -> Path:
        info = tmp_path / f"{name}-1.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        lines = "\n".join(f"{k} = {v}" for k, v in points.items())
        (info / "entry_points.txt").write_text(f"[{GROUP}]\n{lines}\n")
        for path, text in files.items():
            file = tmp_path / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(textwrap.dedent(text))
        return tmp_path

    before = set(sys.modules)
    monkeypatch.syspath_prepend(str(tmp_path))
    yield install
    for module in set(sys.modules) - before:
        if module.startswith(("painters", "paint_")):
            del sys.modules[module]


def test_own_tools_are_found_without_entry_points():
    known = tools()
    assert {"init_prior", "add_objects", "remove_objects", "update_layout", "init_library"} <= set(known)
    for name, entry in known.items():
        assert entry.card == own_card(name)
        assert entry.load().name == name


def test_cards_are_read_without_importing_tools(site):
    site(
        {"paint_all": "painters.brush:Paint"},
        {
            "painters/__init__.py": "",
            "painters/brush.py": "1 / 0",
            "painters/paint_all.yaml": CARD.replace("NAME", "paint_all"),
        },
    )
    entry = tools()["paint_all"]
    assert entry.card.role == "modifier"
    assert "painters.brush" not in sys.modules
    with pytest.raises(InputError, match="tool paint_all: painters.brush:Paint does not load: ZeroDivisionError"):
        entry.load()


@pytest.mark.parametrize(
    "card",
    [
        "painters/deep/paint_all.yaml",
        "painters/deep/toolcards/paint_all.yaml",
        "painters/toolcards/paint_all.yaml",
        "painters/paint_all.yaml",
    ],
)
def test_a_foreign_tool_works(site, call, card):
    site(
        {"paint_all": "painters.deep.brush:Paint"},
        {
            "painters/__init__.py": "",
            "painters/deep/__init__.py": "",
            "painters/deep/brush.py": MODULE,
            card: CARD.replace("NAME", "paint_all"),
        },
    )
    scene = Scene.example("bedroom")
    proposal = call("paint_all", scene, {"color": "blue"}, room="bedroom")
    assert {e.id for e in proposal.edits} == set(scene.ids)


def test_a_module_without_a_package(site):
    site(
        {"paint_all": "paint_alone:Paint"},
        {"paint_alone.py": MODULE, "paint_all.yaml": CARD.replace("NAME", "paint_all")},
    )
    assert tool("paint_all").load().name == "paint_all"


BROKEN = {
    "no card": ({"paint_a": "painters.brush:Paint"}, {"painters/__init__.py": "", "painters/brush.py": MODULE}),
    "no package": ({"paint_a": "nowhere_at_all.brush:Paint"}, {}),
    "broken package": ({"paint_a": "painters.brush:Paint"}, {"painters/__init__.py": "raise OSError('no\\nway')"}),
    "wrong name": (
        {"paint_a": "painters.brush:Paint"},
        {"painters/__init__.py": "", "painters/paint_a.yaml": CARD.replace("NAME", "paint_b")},
    ),
    "bad card": (
        {"paint_a": "painters.b:P"},
        {
            "painters/__init__.py": "",
            "painters/paint_a.yaml": "role: [",
        },
    ),
}


@pytest.mark.parametrize("kind", BROKEN)
def test_a_broken_tool_is_left_out_with_a_warning(site, caplog, kind):
    site(*BROKEN[kind])
    with caplog.at_level(logging.WARNING):
        known = tools()
    assert "paint_a" not in known and "add_objects" in known
    lines = [r.getMessage() for r in caplog.records if "paint_a" in r.getMessage()]
    assert len(lines) == 1 and "\n" not in lines[0]


def test_our_names_are_not_taken_over(site, caplog):
    site(
        {"add_objects": "painters.brush:Paint"},
        {
            "painters/__init__.py": "",
            "painters/brush.py": MODULE,
            "painters/add_objects.yaml": CARD.replace("NAME", "add_objects"),
        },
    )
    assert tools()["add_objects"].origin.startswith("sceneweaver.")
    assert "the name is taken" in caplog.text


def test_what_is_no_tool_does_not_load(site):
    site(
        {"paint_a": "painters.brush:Paint"},
        {
            "painters/__init__.py": "",
            "painters/brush.py": MODULE,
            "painters/paint_a.yaml": CARD.replace("NAME", "paint_a"),
        },
    )
    with pytest.raises(InputError, match="is no tool"):
        tools()["paint_a"].load()


def test_unknown_tool():
    with pytest.raises(InputError, match='did you mean "add_objects"'):
        tool("add_object")
