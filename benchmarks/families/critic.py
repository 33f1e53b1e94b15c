"""The critic beside strict eyes: which of their faults it finds, what it finds beside them, and how it grades."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np
from scipy.stats import spearmanr

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.strict_eyes import GRADED, SCENES, Comparison, comparisons, labels

QUICK = 3
"""Scenes to see that everything works."""

GRADES = (
    Column("criterion", "criterion"),
    Column("strict", "strict eyes", "number"),
    Column("critic", "critic", "number"),
    Column("spearman", "rank correlation", "number"),
    Column("error", "mean error", "number"),
)

KINDS = (
    Column("kind", "kind"),
    Column("labelled", "labelled", "count"),
    Column("found", "found", "count"),
    Column("beside", "critic alone", "count"),
)

ROOMS = (
    Column("scene", "scene"),
    Column("labelled", "labelled", "count"),
    Column("found", "found", "count"),
    Column("beside", "critic alone", "count"),
    Column("strict", "strict eyes", "number"),
    Column("critic", "critic", "number"),
)

FAULTS = (
    Column("scene", "scene"),
    Column("what", "what"),
    Column("kind", "kind"),
    Column("objects", "objects"),
    Column("reason", "reason"),
)


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
    return result


def tabulate(result: Result, found: Sequence[Comparison]) -> None:
    """The tables of a comparison: grades, kinds of faults, scenes, and each fault that only one side has."""
    grades = result.add("grades", "Grades", GRADES)
    for criterion in (*GRADED, "mean"):
        strict, critic = (np.array([_grade(g, criterion) for g in side]) for side in _sides(found))
        rank = spearmanr(strict, critic)[0] if len(set(strict)) > 1 and len(set(critic)) > 1 else 0.0
        error = float(np.abs(strict - critic).mean())
        row = {"strict": float(strict.mean()), "critic": float(critic.mean())}
        grades.rows.append({"criterion": criterion, **row, "spearman": float(rank), "error": error})
    _kinds(result, found)
    scenes = result.add("scenes", "Scenes", ROOMS)
    for c in found:
        strict, critic = (_grade(g, "mean") for g in (c.graded.grades, c.review.grades))
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


def _grade(grades: dict[str, float], criterion: str) -> float:
    return sum(grades[c] for c in GRADED) / len(GRADED) if criterion == "mean" else grades[criterion]


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
