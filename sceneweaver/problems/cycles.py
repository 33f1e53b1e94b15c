"""Contradictions around a cycle of relations, by interval arithmetic."""

from __future__ import annotations

import itertools
import math
from typing import Any

from sceneweaver.scene import CATALOGUE, InputError, Relation, Scene, SceneObject, wall_number

Json = dict[str, Any]

SLACK = 1e-3  # [m] that the judge grants every bound
ROUNDING = 0.01  # [deg]
ANGLES = {  # of the subject against the target [deg]: the middle, and the period
    "front_to_front": (180.0, 360.0),
    "back_to_back": (180.0, 360.0),
    "parallel": (0.0, 180.0),
    "aligned": (0.0, 90.0),
    "front_against": (0.0, 90.0),
}


def distance(scene: Scene, certificate: Json) -> str:
    """The ends of a chain are at most so far apart as its gaps and the things in it are long."""
    import shapely

    chain = [_hard(scene, k) for k in certificate["near"]]
    nodes = _nodes(chain)
    most = sum(_most(r) + SLACK for r in chain)
    for name in nodes[1:-1]:
        if name.startswith("wall:"):
            raise InputError("certificate: a wall is no link of a chain")
        most += _diameter(scene.object(name))
    if "far" in certificate:
        far = _hard(scene, certificate["far"])
        if far.type != "distance" or {far.subject, far.target} != {nodes[0], nodes[-1]}:
            raise InputError("certificate: far is no distance between the ends of the chain")
        least = float(CATALOGUE["distance"].value(far, "min") or 0.0) - SLACK
    else:
        walls = [scene.room.walls[_wall(name)] for name in (nodes[0], nodes[-1])]
        one, two = (shapely.LineString([w.start, w.end]) for w in walls)
        least = float(one.distance(two))
    if most >= least:
        raise InputError(f"certificate: a chain of {most:.3f} m does reach over {least:.3f} m")
    return f"{' - '.join(nodes)} are at most {most:.3f} m apart and have to be at least {least:.3f} m"


def angle(scene: Scene, certificate: Json) -> str:
    """The turns along a chain that closes, or that ends at two walls, do not add up."""
    chain = [_hard(scene, k) for k in certificate["relations"]]
    nodes = _nodes(chain)
    middle, tolerance, period = 0.0, ROUNDING, 360.0
    for relation in chain:
        centre, step = (0.0, 360.0) if relation.type == "against_wall" else ANGLES.get(relation.type, (None, 0.0))
        if centre is None:
            raise InputError(f"certificate: {relation.type} says nothing of angles")
        middle += centre
        tolerance += float(CATALOGUE[relation.type].value(relation, "degrees"))
        period = min(period, step)
    if nodes[0] != nodes[-1]:
        one, two = (scene.room.walls[_wall(name)].inward for name in (nodes[0], nodes[-1]))
        middle += math.degrees(math.atan2(one[1], one[0]) - math.atan2(two[1], two[0]))
    off = abs(math.remainder(middle, period))
    if off <= tolerance:
        raise InputError(f"certificate: the angles do add up, {off:.1f} of {tolerance:.1f} degrees")
    return f"{' - '.join(nodes)}: the angles are {off:.1f} degrees off and may be {tolerance:.1f}"


def _hard(scene: Scene, k: Any) -> Relation:
    if isinstance(k, bool) or not isinstance(k, int) or not 0 <= k < len(scene.relations):
        raise InputError(f"certificate: {k!r} is the number of no relation")
    if not scene.relations[k].hard:
        raise InputError(f"certificate: relation {k} is not hard")
    return scene.relations[k]


def _nodes(chain: list[Relation]) -> list[str]:
    """What a chain of relations goes through, from one end to the other."""
    pairs = [(r.subject, r.target) for r in chain]
    if not pairs or not all(isinstance(b, str) for _, b in pairs):
        raise InputError("certificate: a chain needs relations, each with one target")
    for start in pairs[0]:
        nodes = [str(start)]
        for a, b in pairs:
            if nodes[-1] not in (a, b):
                break
            nodes.append(str(b) if nodes[-1] == a else str(a))
        else:
            return nodes
    raise InputError("certificate: the relations are no chain")


def _most(relation: Relation) -> float:
    """The largest distance [m] of footprints, or of a footprint and a wall, that a relation allows."""
    spec = CATALOGUE[relation.type]
    if relation.type == "against_wall":
        return float(spec.value(relation, "gap")[1])
    most = spec.value(relation, "max") if relation.type in ("near", "distance") else None
    if most is None:
        raise InputError(f"certificate: {relation.type} says nothing of a largest distance")
    return float(most)


def _wall(name: str) -> int:
    number = wall_number(name)
    if number is None:
        raise InputError("certificate: a chain that does not close has to end at two walls")
    return number


def _diameter(item: SceneObject) -> float:
    """The longest distance within a footprint [m]."""
    points = [point for part in item.solids for point in part.polygon]
    return max(math.dist(a, b) for a, b in itertools.combinations(points, 2))
