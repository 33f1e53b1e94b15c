"""One request designed twice, by rules and with a scripted model, and both rooms measured by one reading of it.

python -m benchmarks.rooms_by_model ROOM... --out DIR --ask DIR   # ask a person what the model says
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from benchmarks.scripted import FOLDER, Script
from sceneweaver.agent import design
from sceneweaver.agent.by_model.critic import look
from sceneweaver.agent.request_file import RequestFile
from sceneweaver.assets import Library
from sceneweaver.critic.review import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.load import read_yaml
from sceneweaver.language import SceneGraph
from sceneweaver.llm import Endpoint, open_client
from sceneweaver.scene import Scene
from sceneweaver.verify import check

FILE = Path(__file__).with_name("data") / "by_model.yaml"

LEARNED = "SCENEWEAVER_ROOMS"
"""Variable that names the folder of learned rooms."""

PATIENCE = 86400.0
"""Seconds that a person may take for a reply."""


@dataclass(frozen=True)
class Room:
    """A request that is designed twice, and what eyes say about both rooms."""

    name: str
    prompt: str
    seed: int
    eyes: str = ""

    @property
    def replies(self) -> Path:
        """The file with what the model says."""
        return FOLDER / f"{self.name}.yaml"


@dataclass
class Made:
    """A room as one side made it, by the files of its run.

    Attributes:
        side: "rules" or "model".
        scene: the room.
        metrics: what `metrics.json` says.
        steps: steps of the agent.
        seconds: that the run took, less those that a person was asked.
        asked: how much the model's reading of the request asks for.
        met: how much of that is so.
        seen: grades of the critic by vision in the end.
    """

    side: str
    scene: Scene
    metrics: dict[str, Any]
    steps: int
    seconds: float
    asked: int = 0
    met: int = 0
    seen: Mapping[str, float] = field(default_factory=dict[str, float])

    @classmethod
    def read(cls, side: str, run: Path, waited: float = 0.0) -> Self:
        """What a run left in its folder."""
        metrics = json.loads((run / "metrics.json").read_text("utf-8"))
        steps = len(json.loads((run / "state.json").read_text("utf-8"))["memory"]["steps"])
        return cls(side, Scene.load(run / "scene.json"), metrics, steps, metrics["seconds"]["total"] - waited)


@dataclass
class Pair:
    """Both rooms of a request, questions that the replies were not written for, and those without any."""

    room: Room
    rules: Made
    model: Made
    changed: list[str] = field(default_factory=list[str])
    missing: list[str] = field(default_factory=list[str])

    @property
    def sides(self) -> tuple[Made, Made]:
        """Both, that without a model first."""
        return self.rules, self.model


def rooms() -> dict[str, Room]:
    """The rooms of the file, by name."""
    found = read_yaml(FILE.read_text("utf-8"))
    return {name: Room(name, **row) for name, row in found.items()}


def pair(room: Room, out: Path, ask_in: Path | None = None, looks: bool = True, **options: Any) -> Pair:
    """A request by rules and with the model that says what its replies are.

    Args:
        room: what is designed.
        out: folder for the folders `rules` and `model` of the two runs; what is in them is made anew.
        ask_in: folder in which a person is asked where no reply fits.
        looks: whether the critic by vision looks at a room that no one has looked at, in the end.
        options: of `design`.
    """
    from tests.llm.model_server import MODEL, ModelServer

    script = Script(room.replies, ask_in)
    shutil.rmtree(out / "looks", ignore_errors=True)
    with ModelServer(script) as server, _nothing_learned(out / "rooms"):
        _design(room, out / "rules", options)
        _design(room, out / "model", {"planner": "llm", "model": MODEL, "base_url": server.url, **options})
        found = Pair(room, Made.read("rules", out / "rules"), Made.read("model", out / "model", script.waited))
        graph = RequestFile.load(out / "model" / "request.json").graph
        kind = room_type(found.model.scene.room.type)
        patience = PATIENCE if ask_in else 120.0
        client = open_client(Endpoint(MODEL, server.url, timeout=patience), records=out / "looks")
        for made in found.sides:
            made.asked, made.met = asked_and_met(made.scene, graph)
            made.seen = made.metrics["scores"].get("seen", {}).get("grades", {})
            if looks and not made.seen:
                made.seen = look(client, made.scene, check(made.scene), graph, kind, Library()).grades
    found.changed, found.missing = script.changed, script.missing
    return found


@contextmanager
def _nothing_learned(folder: Path) -> Iterator[None]:
    """A folder of learned rooms with nothing in it, so that both sides begin with what ships with the library."""
    before = os.environ.get(LEARNED)
    shutil.rmtree(folder, ignore_errors=True)
    os.environ[LEARNED] = str(folder)
    try:
        yield
    finally:
        del os.environ[LEARNED]
        if before is not None:
            os.environ[LEARNED] = before


def _design(room: Room, out: Path, options: Mapping[str, Any]) -> None:
    shutil.rmtree(out, ignore_errors=True)
    out.parent.mkdir(parents=True, exist_ok=True)
    chosen: dict[str, Any] = {"device": "cpu", "time_limit": None, "pictures": False, "export": "none", **options}
    design(room.prompt, seed=room.seed, out=out, **chosen)


def asked_and_met(scene: Scene, graph: SceneGraph) -> tuple[int, int]:
    """How much of a reading is asked for and how much is so; things count by what they are, whoever put them there."""
    bare = [o.model_copy(update={"intent": o.intent.model_copy(update={"request": None})}) for o in scene.objects]
    scene = scene.model_copy(update={"objects": tuple(bare)})
    summary = review_scene(scene, check(scene), room_type(scene.room.type), graph).alignment.summary
    return summary["total"], summary["met"] + summary["assumed"]


def main() -> int:
    """Design rooms while a person says what the model says."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rooms", nargs="+", choices=rooms())
    parser.add_argument("--ask", type=Path, required=True, metavar="DIR", help="where questions and replies are")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="where the rooms are")
    options = parser.parse_args()
    os.environ["SCENEWEAVER_MODEL_TIMEOUT"] = str(PATIENCE)
    for name in options.rooms:
        for made in pair(rooms()[name], options.out / name, options.ask / name).sides:
            scores = made.metrics["scores"]
            print(name, made.side, made.metrics["valid"], f"{made.met} of {made.asked}", scores, flush=True)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
