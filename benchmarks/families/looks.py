"""A vision critic beside strict eyes, and the symbolic critic by the same measure.

The model is the one that the environment names (`SCENEWEAVER_MODEL`, `SCENEWEAVER_BASE_URL`, the key as for a design);
without one only the symbolic critic is measured. ``--count`` is the number of answers for each scene.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.critic_fit import agreement
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.strict_eyes import GRADED, SCENES, Graded, Label, labels, load_scene, review
from sceneweaver.agent.by_model.critic import look
from sceneweaver.agent.by_model.pictures import room_pictures
from sceneweaver.assets import Library
from sceneweaver.critic import Fault
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.llm import ModelClient, ModelError, open_client
from sceneweaver.rules.design import design_rules
from sceneweaver.scene import MissingDependencyError
from sceneweaver.verify import check

QUICK = 3
"""Scenes to see that everything works."""

CRITIC = Column("critic", "critic")
FOUND = (
    Column("labelled", "labelled", "count"),
    Column("found", "found", "count"),
    Column("recall", "recall", "share"),
    Column("named", "named", "count"),
    Column("precision", "precision", "share"),
    Column("eyes", "only eyes", "count"),
)
AGREES = (Column("spearman", "rank correlation", "number"), Column("error", "mean error", "number"))
CRITICS = (CRITIC, Column("scenes", "scenes", "count"), *FOUND, *AGREES, Column("spread", "spread", "number"))
GRADES = (CRITIC, Column("criterion", "criterion"), Column("mean", "mean", "number"), *AGREES)
ROOMS = (CRITIC, Column("scene", "scene"), *FOUND[:4], Column("grade", "grade", "number"))


@dataclass(frozen=True)
class Looked:
    """What a critic says about a graded scene."""

    graded: Graded
    grades: Mapping[str, float]
    faults: Sequence[Fault]
    spread: float | None = None

    @property
    def showable(self) -> list[Label]:
        """The labels that a scene shows: all but those that only a picture of that time or a drawing tells."""
        return [label for label in self.graded.labels if not label.eyes]

    def found(self) -> int:
        """Labels that are found, each by a fault of its own."""
        return matched(self.showable, self.faults)

    def drawn(self) -> int:
        """Found of the faults that only eyes can tell from how a thing is drawn."""
        return matched([label for label in self.graded.labels if label.eyes == "drawing"], self.faults)


def matched(labelled: Sequence[Label], faults: Sequence[Fault]) -> int:
    """How many labels have a fault of their own that may be the same.

    A label on objects and a fault may be the same where they share an object; one of the whole room, where the fault is
    of the room as well and lowers the grade of one of its rules.
    """
    from scipy.optimize import linear_sum_assignment

    if not labelled or not faults:
        return 0
    same = np.array([[_same(label, fault) for fault in faults] for label in labelled], dtype=float)
    rows, columns = linear_sum_assignment(same, maximize=True)
    return int(same[rows, columns].sum())


def _same(label: Label, fault: Fault) -> bool:
    if label.objects:
        return not label.objects.isdisjoint(fault.objects)
    known = {design_rules()[name].criterion for name in label.rules if name in design_rules()}
    return not fault.objects and (not known or fault.criterion in known)


def run(settings: Settings, judge: Judge) -> Result:
    """Let both critics look at the graded scenes, and compare."""
    del judge
    result = Result(
        "looks",
        "A vision critic beside strict eyes",
        "Thirty rooms that strict eyes graded 0 to 10, with every fault located. A labelled fault is found when a "
        "fault of the critic shares an object with it, each label by a fault of its own; one of the whole room, when "
        "the critic has one of the room under the same criterion. The symbolic critic is measured alike; by kinds of "
        "faults it does better, see `critic`, and its points were fitted to these very grades. 'Only eyes' are faults "
        "of drawing that were found, which are not among the labelled.",
    )
    graded = labels()[: QUICK if settings.quick else None]
    try:
        client = open_client()
    except MissingDependencyError as error:
        client = None
        result.notes.append(f"No model looked: {error}")
    seen = look_at(client, graded, settings, result) if client is not None else []
    scenes = [one.graded for one in seen] or graded
    sides = {"symbolic": [symbolic(one) for one in scenes]}
    if client is not None and seen:
        sides[client.name] = seen
        spent = client.usage.to_dict()
        asked = f"{client.name} was asked for {settings.count or 1} answers a scene"
        result.notes.append(f"{asked}: {spent['calls']} calls, {spent['tokens_in']} and {spent['tokens_out']} tokens.")
    tabulate(result, sides)
    return result


def symbolic(graded: Graded) -> Looked:
    """What the symbolic critic says; alignment aside, which strict eyes do not grade."""
    found = review(load_scene(graded.name, SCENES))
    faults = [fault for fault in found.faults if fault.criterion in GRADED]
    return Looked(graded, {name: found.grades[name] for name in GRADED}, faults)


def look_at(client: ModelClient, graded: Sequence[Graded], settings: Settings, result: Result) -> list[Looked]:
    """What a model says about each scene; one without an answer is left out and noted."""
    library, device = Library(), "cuda" if settings.device.startswith("cuda") else "cpu"
    found = []
    for one in graded:
        scene = load_scene(one.name, SCENES)
        eye_level = not settings.quick
        shown = room_pictures(scene, library.load, device=device, eye_level=eye_level) if client.pictures else ()
        brief, kind = read_request(scene.prompt), room_type(scene.room.type)
        try:
            seen = look(client, scene, check(scene), brief, kind, library, samples=settings.count or 1, pictures=shown)
        except ModelError as error:
            result.notes.append(f"{one.name} is left out: {error}")
            continue
        found.append(Looked(one, seen.grades, seen.faults, seen.spread))
    return found


def tabulate(result: Result, sides: Mapping[str, Sequence[Looked]]) -> None:
    """The tables: critics, their grades by criterion, and scenes."""
    critics = result.add("critics", "Critics", CRITICS)
    grades = result.add("grades", "Grades", GRADES, keys=2)
    rooms = result.add("scenes", "Scenes", ROOMS, keys=2, detail=True)
    for name, looked in sides.items():
        strict = np.array([[one.graded.grades[c] for c in GRADED] for one in looked])
        ours = np.array([[one.grades[c] for c in GRADED] for one in looked])
        agrees = agreement(strict, ours)
        means = [*ours.mean(axis=0), ours.mean()]
        for (criterion, rank, error, _), mean in zip(agrees, means, strict=True):
            row = {"critic": name, "criterion": criterion, "mean": float(mean)}
            grades.rows.append({**row, "spearman": rank, "error": error})
        counts = [(len(one.showable), one.found(), len(one.faults)) for one in looked]
        labelled, hits, named = (sum(column) for column in zip(*counts, strict=True))
        spreads = [one.spread for one in looked if one.spread is not None]
        _, rank, error, _ = agrees[-1]
        critics.rows.append(
            {
                "critic": name,
                "scenes": len(looked),
                "labelled": labelled,
                "found": hits,
                "recall": hits / max(1, labelled),
                "named": named,
                "precision": hits / max(1, named),
                "eyes": sum(one.drawn() for one in looked),
                "spearman": rank,
                "error": error,
                "spread": float(np.mean(spreads)) if spreads else None,
            }
        )
        for one, (there, hit, said) in zip(looked, counts, strict=True):
            row = {"labelled": there, "found": hit, "recall": hit / max(1, there), "named": said}
            mean = sum(one.grades[c] for c in GRADED) / len(GRADED)
            rooms.rows.append({"critic": name, "scene": one.graded.name, **row, "grade": mean})
