"""What each part of the agent is worth: the ablations of the SceneWeaver paper, with this agent's parts."""

from __future__ import annotations

from statistics import fmean
from typing import Any

from benchmarks.designs import PAPER
from benchmarks.judging import Judge
from benchmarks.made import Made, Task, made_side_by_side
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.critic import CRITERIA

INITIALIZERS = ("init_prior",)
MODIFIERS = ("add_objects", "remove_objects", "add_relation", "update_rotation", "update_size", "update_layout")
IMPLEMENTERS = ("add_tabletop", "add_crowd")

PARTS: dict[str, dict[str, Any]] = {
    "full": {},
    "without rules": {"rules": False},
    "without choice": {"choice": False},
    "without reflection": {"reflect": False},
    "without physical optimisation": {"physics": False},
    "one-shot plan": {"one_shot": True},
}
TOOLS: dict[str, dict[str, Any]] = {
    "initializer only": {"tools": INITIALIZERS},
    "with modifiers": {"tools": INITIALIZERS + MODIFIERS},
    "with implementers": {"tools": INITIALIZERS + IMPLEMENTERS},
    "full": {},
}
VARIANTS = {**PARTS, **TOOLS}

LIMIT = 100.0
"""Time limit of a design [s]."""

COUNTS = (
    Column("objects", "#Obj", "number"),
    Column("out", "#OB", "number"),
    Column("colliding", "#CN", "number"),
    Column("dropped", "dropped", "number"),
)
MEASURES = (
    *COUNTS,
    Column("valid", "valid", "share"),
    *(Column(name, name.capitalize(), "number") for name in CRITERIA),
    Column("seconds", "seconds", "number"),
    Column("cpu", "CPU seconds", "number"),
    Column("cut_off", "cut off", "share"),
)
COLUMNS = (Column("variant", "variant"), *MEASURES)
EACH = (Column("room", "room"), Column("seed", "seed", "count"), *COLUMNS)


def run(settings: Settings, judge: Judge) -> Result:
    """Design the ten kinds of rooms with parts of the agent switched off."""
    del judge
    result = Result(
        "ablations",
        "Ablations",
        'Means over "Design me a <room>" for the ten kinds of rooms of the SceneWeaver paper. #OB: objects out of '
        "bounds, #CN: colliding pairs, by the judge; grades are the symbolic critic's, by all design rules. Without "
        "rules neither the choice among layouts nor what the agent hears of the critic knows them; the groups of the "
        f"rooms' files are the same. No pictures; a design is cut off at {LIMIT:g} s.",
    )
    kinds = settings.kinds or tuple(PAPER)[: 1 if settings.quick else None]
    seeds = range(settings.seed, settings.seed + (settings.count or 1))
    variants = settings.variants or tuple(VARIANTS)
    tasks = [Task(kind, seed, name, VARIANTS[name]) for kind in kinds for seed in seeds for name in variants]
    each = result.add("each", "Each design", EACH, keys=3, detail=True)
    each.rows += [_row(one) for one in made_side_by_side(tasks, settings, LIMIT)]
    for name, title, known in (("parts", "Without one part", PARTS), ("tools", "Kinds of tools", TOOLS)):
        wanted = [variant for variant in variants if variant in known]
        if wanted and wanted != ["full"]:
            result.add(name, title, COLUMNS).rows += [_mean(variant, each.rows) for variant in wanted]
    return result


def _row(one: Made) -> dict[str, Any]:
    task = {"room": one.task.room, "seed": one.task.seed, "variant": one.task.variant}
    share = {"valid": float(one.valid), "cut_off": float(one.cut_off)}
    return {**task, **one.counts, **one.grades, **share, "seconds": one.seconds, "cpu": one.cpu}


def _mean(variant: str, rows: list[dict[str, Any]]) -> dict[str, Any]:
    own = [row for row in rows if row["variant"] == variant]
    return {"variant": variant, **{c.key: fmean(row[c.key] for row in own) for c in MEASURES}}
