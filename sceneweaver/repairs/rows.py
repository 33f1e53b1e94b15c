"""What the repair of many scenes did, as rows of tables and as one summary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sceneweaver.verify import Report

from .report import Repair

KINDS = ("collision", "out_of_bounds", "unsupported", "blocked_zone", "blocked_opening", "yaw_domain", "relation")
"""Kinds of hard violations that a repair mends, as columns."""

MOVED = 1e-3
"""Movement [m] or [degrees] from which an object counts as moved."""

Row = dict[str, Any]


def scene_row(name: str, done: Repair, more: Mapping[str, Any]) -> Row:
    """One row about a scene. Lengths in metres; ``more`` comes first, such as where the scene is from."""
    before, after = _counts(done.before), _counts(done.after)
    far = _moved(done)
    return {
        "scene": name,
        **more,
        "objects": len(done.source.objects),
        "valid_before": done.before.valid,
        "valid_after": done.after.valid,
        "proved_infeasible": done.proof is not None and (not done.after.valid or bool(done.taken_out)),
        "taken_out": list(done.taken_out),
        **{f"{kind}_before": before[kind] for kind in KINDS},
        **{f"{kind}_after": after[kind] for kind in KINDS},
        "held": len(done.held),
        "held_after": len(done.held) - len(done.lost),
        "nearly_held": len(done.nearly),
        "nearly_held_after": len(done.nearly) - len(done.unmended),
        "moved": len(far),
        "farthest": max(far, default=0.0),
        "walkable_before": done.before.walkable_share,
        "walkable_after": done.after.walkable_share,
        "explanation": " ".join((done.explanation or "").split("\n")) or None,
        "notes": list(done.notes),
    }


def object_rows(name: str, done: Repair) -> list[Row]:
    """A row for each object of a scene: how far it went [m], rose [m] and turned [degrees]."""
    moves = {m.id: m for m in done.moves}
    rows = []
    for obj in done.source.objects:
        move = moves.get(obj.id)
        rows.append(
            {
                "scene": name,
                "object": obj.id,
                "category": obj.category,
                "distance": move.distance if move else 0.0,
                "rise": move.rise if move else 0.0,
                "turn": move.turn if move else 0.0,
                "taken_out": obj.id in done.taken_out,
            }
        )
    return rows


def summary(scenes: Sequence[Row], objects: Sequence[Row]) -> Row:
    """The table before and after of many scenes.

    Percentiles of movement [m] are in the plane, over what is still there: over all objects, and over those that moved.
    ``infeasible`` scenes are those of which a proof says that they have no valid layout with all their objects.
    """
    there = [row for row in objects if not row["taken_out"]]
    far = np.array([row["distance"] for row in there])
    infeasible = [row for row in scenes if row["proved_infeasible"]]
    feasible = [row for row in scenes if not row["proved_infeasible"]]
    return {
        "scenes": len(scenes),
        "objects": len(objects),
        "valid_before": sum(row["valid_before"] for row in scenes),
        "valid_after": sum(row["valid_after"] for row in scenes),
        "infeasible": len(infeasible),
        "share_valid_before": _share([row["valid_before"] for row in scenes]),
        "share_valid_after": _share([row["valid_after"] for row in scenes]),
        "share_valid_of_feasible": _share([row["valid_after"] for row in feasible]),
        "violations_before": {kind: sum(row[f"{kind}_before"] for row in scenes) for kind in KINDS},
        "violations_after": {kind: sum(row[f"{kind}_after"] for row in scenes) for kind in KINDS},
        "movement_all": _percentiles(far),
        "movement_moved": _percentiles(far[far > MOVED]),
        "share_moved": float(np.mean(far > MOVED)) if len(far) else None,
        "raised": _percentiles(np.array([abs(row["rise"]) for row in there])),
        "turned": _percentiles(np.array([abs(row["turn"]) for row in there])),
        "relations": _kept(scenes, "held"),
        "relations_nearly": _kept(scenes, "nearly_held"),
        "relations_feasible": _kept(feasible, "held"),
        "taken_out": sum(len(row["taken_out"]) for row in scenes),
    }


def _kept(scenes: Sequence[Row], name: str) -> Row:
    before, after = (sum(row[key] for row in scenes) for key in (name, f"{name}_after"))
    return {"before": before, "after": after, "share": after / before if before else None}


def _share(values: Sequence[bool]) -> float | None:
    return sum(values) / len(values) if values else None


def _percentiles(values: np.ndarray) -> Row:
    if not len(values):
        return {"p50": None, "p90": None, "max": None}
    p50, p90, most = (round(float(v), 6) for v in np.percentile(values, (50, 90, 100)))
    return {"p50": p50, "p90": p90, "max": most}


def _moved(done: Repair) -> list[float]:
    return [m.distance for m in done.moves if m.distance > MOVED]


def _counts(report: Report) -> dict[str, int]:
    counts: dict[str, int] = dict.fromkeys(KINDS, 0)
    for violation in report.violations:
        if violation.hard and violation.kind in counts:
            counts[violation.kind] += 1
    return counts
