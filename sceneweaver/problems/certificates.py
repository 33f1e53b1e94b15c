"""Proofs that no layout of a scene is valid, and their check from first principles.

A certificate names what the proof is about; the check works the figures out of the scene alone and grants the layout
every tolerance of the judge. Nothing of the engine is used.

- ``area``: bodies that all fill some slab of heights cover more than the floor that they may stand on.
- ``wall_length``: what has to stand with its back to a wall needs more wall than there is.
- ``clearance``: a disc inside an object does not fit where a relation wants the object.
- ``distance``: a chain of near things is shorter than the distance that its ends have to keep.
- ``angle``: relations that fix angles around a cycle, or between two walls, do not add up.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any

import shapely

from sceneweaver.scene import CATALOGUE, InputError, Relation, Scene, SceneObject, wall_number

from .measures import openings_in, placed_polygon

Json = dict[str, Any]

LENGTH = 1e-3  # [m] by which the judge lets bodies sink in, leave the room, or miss a gap
HEIGHT = 2e-3  # [m] by which something may stand too high
VOLUME = 1e-6  # [m3] of two bodies in one another that are no collision
OPENING = (5e-3, 1e-4)  # depth [m] and area [m2] to which a body may reach into what an opening needs free
FIXED = 3e-3  # [m] by which a disc may overlap a fixed body, at its corners as well


def prove(scene: Scene, certificate: Json) -> str:
    """Check a proof that no layout of a scene is valid.

    Returns:
        The proof in one line, with its figures.

    Raises:
        InputError: the certificate is not one, names what is not there, or does not prove it.

    Examples:
        >>> from sceneweaver import problems
        >>> case = problems.load("infeasible/clearance-n008")
        >>> print(problems.prove(case.scene, case.certificate))
        a disc of 0.414 m, which chest contains, fits nowhere within 0.07 m of wall:2
    """
    kind = certificate.get("kind") if isinstance(certificate, dict) else None
    if kind not in _PROOFS:
        raise InputError(f"certificate: kind {kind!r} is none of {', '.join(_PROOFS)}")
    try:
        return _PROOFS[kind](scene, certificate)
    except (KeyError, TypeError, ValueError, IndexError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"certificate: {kind} lacks something or has it wrong ({error})") from None


def _area(scene: Scene, certificate: Json) -> str:
    """Sum of the bodies' cross-sections at some heights against the floor that is free there."""
    low, high = certificate["z"]
    items = _distinct(scene, certificate["objects"])
    if high - low < 0.05:
        raise InputError("certificate: z has to be at least 0.05 m high")
    taken, parts = 0.0, 0
    for item in items:
        across = [p for p in item.solids if p.z[0] + HEIGHT <= low and high <= p.z[1] - HEIGHT]
        if item.mount != "floor" or not across:
            raise InputError(f"certificate: {item.id} does not stand on the floor, or does not fill the heights")
        # Two bodies that sink in by 1 mm no longer meet when each is half of that smaller all around.
        taken += shapely.unary_union([shapely.Polygon(p.polygon).buffer(-LENGTH / 2) for p in across]).area
        parts += len(across)
    floor = shapely.Polygon(scene.room.outline).buffer(LENGTH, join_style="mitre")
    lost = parts * (parts - 1) / 2 * VOLUME / (high - low)
    for zone, z in openings_in(scene):
        if z[0] <= low and high <= z[1]:
            floor = floor.difference(zone.buffer(-OPENING[0]))
            lost += parts * OPENING[1]
    if taken <= floor.area + lost:
        raise InputError(f"certificate: {taken:.3f} m2 of bodies do fit on {floor.area + lost:.3f} m2")
    return (
        f"{len(items)} bodies cover {taken:.3f} m2 between {low:g} and {high:g} m; {floor.area + lost:.3f} m2 are free"
    )


def _wall_length(scene: Scene, certificate: Json) -> str:
    """Widths of what stands along walls against the lines in the room at some depth before the walls.

    Every body crosses the line before its wall over at least its width, and two bodies share next to nothing of it.
    """
    depth, items = float(certificate["depth"]), _distinct(scene, certificate["objects"])
    widths = 0.0
    for item in items:
        relation = next((r for r in scene.relations if _backs(r) and r.subject == item.id), None)
        if relation is None or item.parts is not None or item.mount != "floor":
            raise InputError(f"certificate: {item.id} is no box on the floor that has to stand against a wall")
        tilt = math.radians(CATALOGUE["against_wall"].value(relation, "degrees") + 0.1)
        low, high = CATALOGUE["against_wall"].gap_range(relation, item.size[0])
        aside = item.size[1] / 2 * math.sin(tilt)
        if not high + 3 * LENGTH + aside <= depth <= low + item.size[0] * math.cos(tilt) - aside - 3 * LENGTH:
            raise InputError(f"certificate: the line {depth:g} m before the wall may miss {item.id}")
        widths += item.size[1] - 2 * LENGTH
    low = max(HEIGHT, 0.0)
    high = min(item.size[2] for item in items) - HEIGHT
    floor = shapely.Polygon(scene.room.outline).buffer(LENGTH, join_style="mitre")
    for zone, z in openings_in(scene):
        if z[0] <= low and min(high, z[1]) - low > 0.1 and zone.area > 10 * OPENING[1]:
            floor = floor.difference(zone.buffer(-2 * OPENING[0]))
    there = 0.0
    for wall in scene.room.walls:
        line = shapely.LineString([wall.point(s, depth) for s in (-1e3, wall.length + 1e3)])
        there += line.intersection(floor).length
    if widths <= there:
        raise InputError(f"certificate: {widths:.3f} m of furniture do fit along {there:.3f} m of wall")
    return f"{len(items)} bodies need {widths:.3f} m of wall; {there:.3f} m are free, {depth:g} m before the walls"


def _clearance(scene: Scene, certificate: Json) -> str:
    """Where the middle of an object can be for its inner disc to fit, against where its relation wants it."""
    relation = scene.relations[certificate["relation"]]
    item = scene.object(relation.subject)
    target = relation.target
    if not _backs(relation) or not isinstance(target, str) or item.parts is not None or item.mount != "floor":
        raise InputError("certificate: the relation does not put a box on the floor to a wall that it names")
    wall = scene.room.walls[int(target.removeprefix("wall:"))]
    depth, width, height = item.size
    tilt = math.sin(math.radians(CATALOGUE["against_wall"].value(relation, "degrees")))
    share = 2 * CATALOGUE["against_wall"].value(relation, "overlap") - 1
    _, gap = CATALOGUE["against_wall"].gap_range(relation, depth)
    ends = share * width / 2 - depth / 2 * tilt - 2 * LENGTH
    wanted = shapely.Polygon(wall.strip(ends, max(wall.length - 2 * ends, 0.0), -1.0, gap + depth / 2 + 2 * LENGTH))
    radius = min(depth, width) / 2 - LENGTH
    free = shapely.Polygon(scene.room.outline).buffer(LENGTH, join_style="mitre")
    for other in scene.objects:
        if other.fixed and other.id != item.id:
            for part in other.solids:
                if part.z[0] <= 0.0 and min(part.z[1], height) > 0.1:
                    free = free.difference(placed_polygon(other, part.polygon).buffer(-FIXED))
    places = free.buffer(-radius, quad_segs=64)  # arcs from within: rather too large
    if places.intersects(wanted):
        raise InputError(f"certificate: a disc of {radius:.3f} m does fit where {item.id} has to stand")
    return f"a disc of {radius:.3f} m, which {item.id} contains, fits nowhere within {gap:g} m of {target}"


def _backs(relation: Relation) -> bool:
    return relation.hard and relation.type == "against_wall"


def _distinct(scene: Scene, names: Any) -> list[SceneObject]:
    if not names or len(set(names)) != len(names):
        raise InputError("certificate: objects have to be named, each once")
    return [scene.object(name) for name in names]


SLACK = 1e-3  # [m] that the judge grants every bound
ROUNDING = 0.01  # [deg]
ANGLES = {  # of the subject against the target [deg]: the middle, and the period
    "front_to_front": (180.0, 360.0),
    "back_to_back": (180.0, 360.0),
    "parallel": (0.0, 180.0),
    "aligned": (0.0, 90.0),
    "front_against": (0.0, 90.0),
}


def _distance(scene: Scene, certificate: Json) -> str:
    """The ends of a chain are at most so far apart as its gaps and the things in it are long."""
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


def _angle(scene: Scene, certificate: Json) -> str:
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


_PROOFS: dict[str, Callable[[Scene, Json], str]] = {
    "area": _area,
    "wall_length": _wall_length,
    "clearance": _clearance,
    "distance": _distance,
    "angle": _angle,
}
