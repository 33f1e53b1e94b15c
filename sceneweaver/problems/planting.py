"""Relations that hold in a given layout, drawn so that the layout stays a witness."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from sceneweaver.scene import Relation, Scene
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed

from .measures import footprint

Json = dict[str, Any]

REACH = 3.0  # [m] between the middles of what is related
NEAREST = 6  # neighbours that are looked at
LIGHTEST, HEAVIEST = 0.03, 0.15  # weights of wishes: all together pull less at a thing than a hard relation
SIDES = ("left_of", "right_of", "in_front_of", "behind")


def plant(scene: Scene, count: int, rng: np.random.Generator) -> list[Json]:
    """At most ``count`` hard relations between floor objects that hold in a scene with something to spare.

    Each is judged with tighter numbers than it is given.
    """
    placed = Placed.of(scene)
    candidates = list(_candidates(scene))
    found: list[Json] = []
    for k in rng.permutation(len(candidates)):
        if len(found) == count:
            break
        tight, params = candidates[k]
        if judge_relation(placed, Relation.model_validate(tight)).holds:
            found.append({**tight, "params": params, "hard": True})
    return found


def wish(scene: Scene, count: int, rng: np.random.Generator) -> list[Json]:
    """So many soft relations between floor objects, drawn blindly, each at most once."""
    floor = [o.id for o in scene.objects if o.mount == "floor"]
    kinds = (("near", {"max": 0.3}), ("facing", {}), ("aligned", {}), *((kind, {}) for kind in SIDES))
    found: dict[tuple[str, str, str], Json] = {}
    most = len(kinds) * len(floor) * (len(floor) - 1)
    while len(found) < min(count, most):
        kind, params = kinds[rng.integers(len(kinds))]
        a, b = (floor[k] for k in rng.choice(len(floor), 2, replace=False))
        weight = round(float(rng.uniform(LIGHTEST, HEAVIEST)), 3)
        relation = {"type": kind, "subject": a, "target": b, "params": params, "hard": False, "weight": weight}
        found[kind, a, b] = relation
    return list(found.values())


def _candidates(scene: Scene) -> Iterator[tuple[Json, Json]]:
    """Relations with tight numbers, and the numbers to give them."""
    floor = [i for i, o in enumerate(scene.objects) if o.mount == "floor"]
    at = np.array([scene.objects[i].pose.position[:2] for i in floor])
    feet = [footprint(scene.objects[i]) for i in floor]
    for a, i in enumerate(floor):
        away = np.linalg.norm(at - at[a], axis=1)
        for b in np.argsort(away, kind="stable")[1 : NEAREST + 1]:
            if away[b] > REACH:
                continue
            pair = {"subject": scene.objects[i].id, "target": scene.objects[floor[b]].id}
            gap = float(feet[a].distance(feet[b]))
            low, high = round(max(gap - 0.15, 0.0), 2), round(gap + 0.15, 2)
            yield {"type": "near", **pair, "params": {"max": round(gap + 0.02, 2)}}, {"max": round(gap + 0.2, 2)}
            yield {"type": "distance", **pair, "params": {"min": low, "max": high}}, {"min": low, "max": high}
            yield {"type": "facing", **pair, "params": {"degrees": 11.0}}, {}
            for kind in ("aligned", "parallel"):
                yield {"type": kind, **pair, "params": {"degrees": 1.0}}, {}
            yield {"type": "centered_on", **pair, "params": {"offset": 0.06}}, {}
            for kind in SIDES:
                yield {"type": kind, **pair, "params": {"max": 1.4, "min": 0.1, "band": 1.2}}, {}
