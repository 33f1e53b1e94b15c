"""What each part of the agent is worth: the ablations of the SceneWeaver paper, with this agent's parts."""

from __future__ import annotations

from statistics import fmean
from typing import Any

from benchmarks.designs import PAPER, designed
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings

INITIALIZERS = ("init_prior",)
MODIFIERS = ("add_objects", "remove_objects", "add_relation", "update_rotation", "update_size", "update_layout")
IMPLEMENTERS = ("add_tabletop", "add_crowd")

PARTS: dict[str, dict[str, Any]] = {
    "full": {},
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
COLUMNS = (
    Column("variant", "variant"),
    Column("objects", "#Obj", "number"),
    Column("out", "#OB", "number"),
    Column("colliding", "#CN", "number"),
    Column("valid", "valid", "share"),
    *(Column(n, n.capitalize(), "number") for n in ("realism", "functionality", "layout", "completion")),
    Column("seconds", "seconds", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Design the ten kinds of rooms with parts of the agent switched off."""
    del judge
    result = Result(
        "ablations",
        "Ablations",
        'Means over "Design me a <room>" for the ten kinds of rooms of the SceneWeaver paper. #OB: objects out of '
        "bounds, #CN: colliding pairs, by the judge; grades are the symbolic critic's.",
    )
    rooms = list(PAPER)[:1] if settings.quick else list(PAPER)
    kept: dict[str, dict[str, Any]] = {}
    for name, title, variants in (("parts", "Without one part", PARTS), ("tools", "Kinds of tools", TOOLS)):
        table = result.add(name, title, COLUMNS)
        for variant, switches in variants.items():
            if variant not in kept:
                kept[variant] = _row(variant, [_one(room, settings, switches) for room in rooms])
            table.rows.append(kept[variant])
    return result


def _one(room: str, settings: Settings, switches: dict[str, Any]) -> dict[str, float]:
    made, seconds = designed(room, settings, settings.seed, **switches)
    report = made.report
    return {
        "objects": report.placed,
        "out": report.out_of_bounds,
        "colliding": report.collisions,
        "valid": float(report.valid),
        "seconds": seconds,
        **made.review.grades,
    }


def _row(variant: str, rows: list[dict[str, float]]) -> dict[str, Any]:
    return {"variant": variant, **{c.key: fmean(row[c.key] for row in rows) for c in COLUMNS if c.key != "variant"}}
