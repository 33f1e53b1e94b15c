"""What strict eyes said about thirty scenes: their grades and faults, and which of these the critic finds."""

from __future__ import annotations

import gzip
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.critic import Fault, Review, review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check

DATA = Path(__file__).parent / "data"
LABELS, SCENES = DATA / "strict_eyes.yaml", DATA / "strict_eyes"

GRADED = ("realism", "functionality", "layout", "completion")
"""The criteria that strict eyes grade; alignment is measured by the request alone."""


@dataclass(frozen=True)
class Label:
    """A fault that strict eyes named: of which kinds (rules or older checks) on which objects, or why only eyes can."""

    rules: tuple[str, ...]
    objects: frozenset[str]
    eyes: str = ""
    why: str = ""

    @property
    def kind(self) -> str:
        """What it is counted under: its first rule, or that only eyes can tell."""
        return self.eyes or self.rules[0]

    def found_by(self, fault: Fault) -> bool:
        """Whether a fault of the critic is this one: of one of its kinds, on one of its objects where it has some."""
        return fault.kind in self.rules and (not self.objects or not self.objects.isdisjoint(fault.objects))


@dataclass(frozen=True)
class Graded:
    """A scene with the grades 0 to 10 and the faults that strict eyes gave it."""

    name: str
    grades: dict[str, float]
    labels: tuple[Label, ...]


@dataclass(frozen=True)
class Comparison:
    """What the critic makes of a graded scene."""

    graded: Graded
    review: Review

    @property
    def showable(self) -> list[Label]:
        """The labels that geometry or metadata can tell."""
        return [label for label in self.graded.labels if not label.eyes]

    def found(self, label: Label) -> bool:
        """Whether some fault of the critic is the labelled one."""
        return any(map(label.found_by, self.review.faults))

    @property
    def unlabelled(self) -> list[Fault]:
        """Faults of the critic that no label has: candidates for false alarms."""
        labels = self.graded.labels
        return [f for f in self.review.faults if f.criterion in GRADED and not any(lb.found_by(f) for lb in labels)]


def read_labels(data: Any) -> list[Graded]:
    """The graded scenes of a label file; ValueError where a row is neither found by rules nor by eyes alone."""
    found = []
    for name, row in data.items():
        labels = []
        for fault in row["faults"]:
            rules, eyes = tuple(fault.get("rules", ())), fault.get("eyes", "")
            if bool(rules) == bool(eyes):
                raise ValueError(f"{name}: a fault has either rules or eyes: {fault}")
            labels.append(Label(rules, frozenset(fault["objects"]), eyes, fault.get("why", "")))
        found.append(Graded(name, {c: float(row["grades"][c]) for c in GRADED}, tuple(labels)))
    return found


def labels(path: Path = LABELS) -> list[Graded]:
    """The graded scenes that are stored here."""
    import yaml

    return read_labels(yaml.safe_load(path.read_text("utf-8")))


def load_scene(name: str, folder: Path = SCENES) -> Scene:
    """A graded scene by name."""
    scene = Scene.loads(gzip.decompress((folder / f"{name}.json.gz").read_bytes()))
    # what stood for which item of its kind of room has changed since, and scenes of other systems say nothing of it
    bare = [o.model_copy(update={"intent": o.intent.model_copy(update={"program_item": None})}) for o in scene.objects]
    return scene.model_copy(update={"objects": tuple(bare)})


def review(scene: Scene) -> Review:
    """What the critic says about a scene that was designed for its prompt."""
    return review_scene(scene, check(scene), room_type(scene.room.type), read_request(scene.prompt))


def comparisons(graded: Sequence[Graded], folder: Path = SCENES) -> Iterator[Comparison]:
    """Every graded scene with what the critic says about it."""
    for row in graded:
        yield Comparison(row, review(load_scene(row.name, folder)))
