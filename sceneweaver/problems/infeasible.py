"""Make problems without a valid layout, each with a certificate that proves it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from sceneweaver.scene import InputError, Scene

from .case import ProblemCase, from_plain
from .certificates import prove
from .generator import generate, scattered
from .measures import facts_of
from .recipes import whole_number

Json = dict[str, Any]

EXCESS = 1.04  # of what has to fit to what there is
NICHE = 0.8  # [m] width of a bay
NICHES = 3


def generate_infeasible(kind: str, objects: int, seed: int = 0, *, name: str | None = None) -> ProblemCase:
    """Make a problem that has no valid layout.

    Args:
        kind: of the certificate: "area", "wall_length", "clearance", "distance", "angle".
        objects: how many, from 8 to 200.
        seed: from 0 to 2**32 - 1.
        name: by default made of the numbers.

    Raises:
        InputError: an unknown kind, or numbers out of range.

    Examples:
        >>> from sceneweaver import problems
        >>> case = problems.generate_infeasible("angle", 8, seed=3)
        >>> case.feasible, case.certificate["kind"]
        (False, 'angle')
    """
    if kind not in _MAKERS:
        raise InputError(f"kind: {kind!r} is none of {', '.join(_MAKERS)}")
    scene, certificate = _MAKERS[kind](whole_number("objects", objects, 8, 200), seed)
    prove(scene, certificate)
    title = name or f"infeasible/{kind.replace('_', '-')}-n{objects:03d}-s{seed}"
    data = scattered(scene, seed).model_copy(update={"id": title.replace("/", "-")}).to_json()
    plain = {"name": title, "family": "infeasible", "version": 1, "scene": data, "witness": None}
    density = facts_of(scene)["density"]  # how tight no layout is has no meaning
    return from_plain({**plain, "certificate": certificate}, {"density": density})


def _base(family: str, objects: int, tightness: float, seed: int) -> Scene:
    case = generate(family, objects, tightness, seed)
    assert case.witness is not None
    return case.layout(case.witness)


def _area(objects: int, seed: int) -> tuple[Scene, Json]:
    """A packing in a room that is too small by a little."""
    scene = _base("packing", objects, 0.7, seed)
    low, high = 0.01, min(o.size[2] for o in scene.objects) - 0.01
    certificate = {"kind": "area", "objects": list(scene.ids), "z": [low, round(high, 3)]}
    return _shrunk(scene, certificate, (True, True))


def _wall_length(objects: int, seed: int) -> tuple[Scene, Json]:
    """A corridor of cabinets that is too short by a little."""
    scene = _base("walls", objects, 0.55, seed)
    depth = min(o.size[0] for o in scene.objects) - 0.06
    reach = max(0.075 + o.size[1] / 2 * math.sin(math.radians(5.1)) for o in scene.objects)
    certificate = {"kind": "wall_length", "objects": list(scene.ids), "depth": round((depth + reach) / 2, 3)}
    return _shrunk(scene, certificate, (True, False))


def _shrunk(scene: Scene, certificate: Json, axes: tuple[bool, bool]) -> tuple[Scene, Json]:
    """The scene in a room that is made smaller along some axes until the certificate holds, and a little more."""
    data = scene.to_json()
    outline = np.array(scene.room.outline)
    proven = False
    for step in range(200):
        scale = np.where(axes, 0.99**step, 1.0)
        room = {**data["room"], "outline": (outline * scale).round(3).tolist()}
        smaller = Scene.from_json({**data, "room": room})
        if proven:
            return smaller, certificate
        try:
            prove(smaller, certificate)
            proven = True
        except InputError:
            continue
    raise InputError("objects: no room is small enough")


def _clearance(objects: int, seed: int) -> tuple[Scene, Json]:
    """Bays between fixed pillars along a wall, and a chest that is a little wider than every one of them."""
    scene = _base("relations", objects - NICHES - 1, 0.3, seed)
    data = scene.to_json()
    xs, ys = (max(c) for c in zip(*scene.room.outline, strict=True))
    width = round((xs - NICHES * NICHE) / NICHES, 3)
    deep = 1.0
    wall = 2  # of a rectangle, the one opposite the door
    data["room"]["outline"] = [[0, 0], [xs, 0], [xs, round(ys + deep, 3)], [0, round(ys + deep, 3)]]
    data["room"]["windows"] = []
    for k in range(NICHES):
        x = NICHE + width / 2 + k * (NICHE + width)
        pillar = {"id": f"pillar-{k}", "category": "pillar", "size": [deep, width, 2.4], "fixed": True}
        pillar["pose"] = {
            "position": [round(x, 4), round(ys + deep / 2, 4), 0.0],
            "quaternion": [0, 0, -math.sqrt(0.5), math.sqrt(0.5)],
        }
        data["objects"].append(pillar)
    side = NICHE + 0.03
    data["objects"].append({"id": "chest", "category": "chest", "size": [side, side, 1.0], "pose": {}})
    relation = {"type": "against_wall", "subject": "chest", "target": f"wall:{wall}", "hard": True}
    data["relations"].append(relation)
    return Scene.from_json(data), {"kind": "clearance", "relation": len(data["relations"]) - 1}


def _distance(objects: int, seed: int) -> tuple[Scene, Json]:
    """Things in a chain that is too short for its ends, among others that can be laid out."""
    scene = _base("relations", objects, 0.25, seed)
    rng = np.random.default_rng([seed, 0xD157])
    members = [scene.ids[k] for k in rng.choice(objects, 4, replace=False)]
    inner = [max(math.hypot(*scene.object(name).size[:2]), 0.1) for name in members[1:-1]]
    near = [round(float(rng.uniform(0.15, 0.35)), 2) for _ in members[1:]]
    far = round((sum(near) + sum(inner)) * EXCESS, 2)
    data = scene.to_json()
    first = len(data["relations"])
    for a, b, most in zip(members, members[1:], near, strict=False):
        data["relations"].append({"type": "near", "subject": a, "target": b, "params": {"max": most}, "hard": True})
    ends = {"subject": members[0], "target": members[-1]}
    data["relations"].append({"type": "distance", **ends, "params": {"min": far, "max": far + 5.0}, "hard": True})
    return Scene.from_json(data), {"kind": "distance", "near": list(range(first, first + 3)), "far": first + 3}


def _angle(objects: int, seed: int) -> tuple[Scene, Json]:
    """Backs at two walls at a right angle that are asked to be parallel, through a third thing."""
    scene = _base("relations", objects, 0.25, seed)
    rng = np.random.default_rng([seed, 0xA461])
    a, b, c = (scene.ids[k] for k in rng.choice(objects, 3, replace=False))
    data = scene.to_json()
    first = len(data["relations"])
    chain = (
        ("against_wall", a, "wall:1"),
        ("parallel", a, b),
        ("back_to_back", b, c),
        ("against_wall", c, "wall:2"),
    )
    data["relations"] += [{"type": t, "subject": s, "target": o, "hard": True} for t, s, o in chain]
    return Scene.from_json(data), {"kind": "angle", "relations": list(range(first, first + 4))}


_MAKERS: dict[str, Callable[[int, int], tuple[Scene, Json]]] = {
    "area": _area,
    "wall_length": _wall_length,
    "clearance": _clearance,
    "distance": _distance,
    "angle": _angle,
}
