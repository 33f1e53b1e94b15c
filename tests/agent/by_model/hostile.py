"""A design with a model server that misbehaves, and what has to hold of what it leaves behind."""

from __future__ import annotations

import html
import json
from pathlib import Path
from typing import Any

from sceneweaver.agent import Result, design
from sceneweaver.scene import Scene
from sceneweaver.verify import check
from tests.agent.by_model.obliging import ROOM
from tests.llm.asking import assert_readable, strict_json
from tests.llm.model_server import MODEL, ModelServer
from tests.llm.planted_key import Planted
from tests.oracle.check_scene import check as oracle

QUICK: dict[str, Any] = {"candidates": 8, "finalists": 2, "generations": 0, "side_by_side": 1}
QUICK |= {"device": "cpu", "pictures": False, "export": "none"}
LIMIT = 300.0
"""Seconds that a run may take."""


def designed(server: ModelServer, out: Path, key: Planted, api: str = "chat", **more: Any) -> Result:
    """A design with the model of a server; an exception's traceback is kept for the search for the key."""
    model, url = (f"openai:{MODEL}", server.url) if api == "chat" else (f"anthropic:{MODEL}", server.root)
    given = {"seed": 1, "steps": 3, "time_limit": LIMIT, "model": model, "base_url": url, **QUICK, **more}
    prompt = given.pop("prompt", ROOM)
    try:
        return design(prompt, planner="llm", out=out, **given)
    except Exception as error:
        key.raised(error)
        raise


def assert_sound(folder: Path) -> None:
    """The scene is valid for the judge and for the oracle, and every file is whole."""
    scene = Scene.load(folder / "scene.json")
    assert check(scene).valid
    found = by_oracle(json.loads((folder / "scene.json").read_text()))
    assert found["valid"], found
    assert len(set(scene.ids)) == len(scene.ids)
    assert_readable(folder)


def assert_honest(result: Result, folder: Path) -> None:
    """What the model did not do is said in notes, metrics and, where it is drawn, in the report."""
    use = result.models
    assert use is not None and not result.undone, result.undone
    metrics = strict_json((folder / "metrics.json").read_text())
    assert metrics["models"]["planned"] == list(use.planned)
    by_rules = [number for number, name in enumerate(use.planned, 1) if name == "rules"]
    planned = [note for note in result.notes if "rules" in note and "model" in note]
    assert bool(by_rules) <= bool(planned), (by_rules, result.notes)
    if use.lost:
        assert metrics["models"]["lost"] == use.lost
    page = folder / "report.html"
    if page.exists():
        text = html.unescape(page.read_text())
        assert all(note in text for note in planned)
    assert all(note.isprintable() and len(note) < 600 for note in result.notes), result.notes


def by_oracle(scene: dict[str, Any]) -> dict[str, Any]:
    """What the oracle finds, without the relations that it does not know."""
    while True:
        try:
            return oracle(scene)
        except ValueError as error:
            known = [relation for relation in scene["relations"] if relation["type"] != str(error)]
            if len(known) == len(scene["relations"]):
                raise
            scene = scene | {"relations": known}
