"""The critic beside strict eyes: which of their faults it finds, what it finds beside them, and how it grades."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from benchmarks.critic_fit import agreement, means
from benchmarks.judged_rooms import DESIGNED, judged_rooms, measured
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.strict_eyes import GRADED, SCENES, Comparison, comparisons, labels

QUICK = 3
"""Scenes to see that everything works."""

AGREEMENT = (
    Column("spearman", "rank correlation", "number"),
    Column("error", "mean error", "number"),
    Column("bias", "bias", "number"),
)
SIDES = (Column("strict", "strict eyes", "number"), Column("critic", "critic", "number"))
CRITERION = Column("criterion", "criterion")
GRADES = (CRITERION, *SIDES, *AGREEMENT)
UNSEEN = (Column("rooms", "rooms"), CRITERION, *AGREEMENT)

FOUND = (
    Column("labelled", "labelled", "count"),
    Column("found", "found", "count"),
    Column("beside", "critic alone", "count"),
)
SCENE, KIND = Column("scene", "scene"), Column("kind", "kind")
KINDS, ROOMS = (KIND, *FOUND), (SCENE, *FOUND, *SIDES)

FAULTS = (SCENE, Column("what", "what"), KIND, Column("objects", "objects"), Column("reason", "reason"))


def run(settings: Settings, judge: Judge) -> Result:
    """Review the graded scenes and compare."""
    del judge
    result = Result(
        "critic",
        "The critic beside strict eyes",
        "Thirty rooms that strict eyes graded 0 to 10, with every fault located. A labelled fault is found when the "
        "critic names a fault of its kind on one of its objects, or of its kind at all where it is about the room. "
        "'Critic alone' are faults that no label has: false alarms, or what the eyes left unsaid. Faults that only "
        "the picture or the drawing shows are counted apart.",
    )
    found = list(comparisons(labels()[: QUICK if settings.quick else None], SCENES))
    tabulate(result, found)
    unseen(result, QUICK if settings.quick else None)
    return result


def unseen(result: Result, most: int | None) -> None:
    """Add how the critic grades rooms of kinds that its weights were not fitted to, beside two judges of each."""
    rooms = judged_rooms("held_out")[:most]
    ours, strict = np.array([row.grades for row in measured(rooms)]), means(rooms)
    one, two = (np.array([room.grades[k] for room in rooms]) for k in (0, 1))
    designed = np.array([room.made == DESIGNED for room in rooms])
    table = result.add("unseen", "Rooms of kinds that the fit of the grades had not seen", UNSEEN, keys=2)
    for name, a, b, chosen in (
        ("critic, all", strict, ours, designed | True),
        ("critic, as designed", strict, ours, designed),
        ("the two judges, all", one, two, designed | True),
        ("the two judges, as designed", one, two, designed),
    ):
        for criterion, rank, error, bias in agreement(a[chosen], b[chosen]) if chosen.any() else ():
            table.rows.append({"rooms": name, "criterion": criterion, "spearman": rank, "error": error, "bias": bias})


def tabulate(result: Result, found: Sequence[Comparison]) -> None:
    """The tables of a comparison: grades, kinds of faults, scenes, and each fault that only one side has."""
    grades = result.add("grades", "Grades", GRADES)
    strict, ours = (np.array([[side[name] for name in GRADED] for side in sides]) for sides in _sides(found))
    averages = [*zip(strict.mean(axis=0), ours.mean(axis=0), strict=True), (strict.mean(), ours.mean())]
    for (name, rank, error, bias), (theirs, mine) in zip(agreement(strict, ours), averages, strict=True):
        row = {"strict": float(theirs), "critic": float(mine), "spearman": rank, "error": error, "bias": bias}
        grades.rows.append({"criterion": name, **row})
    _kinds(result, found)
    scenes = result.add("scenes", "Scenes", ROOMS)
    for c in found:
        strict, critic = (sum(g[name] for name in GRADED) / len(GRADED) for g in (c.graded.grades, c.review.grades))
        hits = sum(map(c.found, c.showable))
        row = {"labelled": len(c.showable), "found": hits, "beside": len(c.unlabelled)}
        scenes.rows.append({"scene": c.graded.name, **row, "strict": strict, "critic": critic})
    faults = result.add("faults", "Faults that one side alone has", FAULTS, keys=2, detail=True)
    for c in found:
        for label in c.graded.labels:
            if label.eyes or not c.found(label):
                kind = label.eyes or " or ".join(label.rules)
                what = "only eyes" if label.eyes else "missed"
                row = {"kind": kind, "objects": " ".join(sorted(label.objects)), "reason": label.why}
                faults.rows.append({"scene": c.graded.name, "what": what, **row})
        for fault in c.unlabelled:
            row = {"kind": fault.kind, "objects": " ".join(fault.objects), "reason": fault.reason}
            faults.rows.append({"scene": c.graded.name, "what": "critic alone", **row})


def _sides(found: Sequence[Comparison]) -> tuple[list[dict[str, float]], list[dict[str, float]]]:
    return [c.graded.grades for c in found], [c.review.grades for c in found]


def _kinds(result: Result, found: Sequence[Comparison]) -> None:
    labelled, hits, beside = Counter[str](), Counter[str](), Counter[str]()
    for c in found:
        labelled.update(label.kind for label in c.graded.labels)
        hits.update(label.kind for label in c.showable if c.found(label))
        beside.update(fault.kind for fault in c.unlabelled)
    kinds = result.add("kinds", "Faults by kind", KINDS)
    names = sorted({*labelled, *beside}, key=lambda k: (-labelled[k], k))
    for kind in names:
        kinds.rows.append({"kind": kind, "labelled": labelled[kind], "found": hits[kind], "beside": beside[kind]})
    total = {"labelled": sum(len(c.showable) for c in found), "found": hits.total(), "beside": beside.total()}
    kinds.rows.append({"kind": "all that a scene shows", **total})
    if total["labelled"]:
        share = f"{total['found'] / total['labelled']:.0%}"
        result.notes.append(f"{total['found']} of {total['labelled']} faults that a scene shows were found ({share}).")
    only = labelled["picture"] + labelled["drawing"]
    result.notes.append(f"Faults that only eyes can tell: {only}.")
