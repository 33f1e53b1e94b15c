"""Whether a relation holds, and if not, what is off and by how much.

One function a type, in `JUDGES`; the numbers come from the catalogue (`sceneweaver.scene.catalogue`), the arithmetic is
the judge's own. Lengths have a slack of 1 mm where they are gaps, distances or heights, none where they are overlaps or
offsets aside; angles have none. Faces are those of the object's box.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from sceneweaver.scene import Relation
from sceneweaver.scene.catalogue import CATALOGUE
from sceneweaver.scene.errors import InputError
from sceneweaver.verify.case import Case
from sceneweaver.verify.contacts import face_measurements, turn, wall_contacts
from sceneweaver.verify.formations import across_from, in_middle, next_to, on_grid, run_on, seated_at
from sceneweaver.verify.measure import (
    HOLDS,
    ROUNDING,
    TOLERANCE,
    Judgement,
    Measurement,
    Measurements,
    at_least,
    at_most,
    fails,
    judge,
    judge_all,
)
from sceneweaver.verify.solids import Body, Face, Opening, Placed
from sceneweaver.verify.support import bottom, rest

CORNER = 0.17
"""Least sine of the turn at a convex corner of the room that counts for in_corner (about 10 degrees)."""


Judge = Callable[[Case], "Judgement | bool"]


def judge_relation(placed: Placed, relation: Relation) -> Judgement:
    """Judge one relation of the scene. A relation of an object that was dropped does not hold."""
    spec = CATALOGUE.get(relation.type)
    function = JUDGES.get(relation.type)
    if spec is None or function is None:
        raise InputError(
            f"relation type {relation.type!r} has no judge; give it one with sceneweaver.verify.register_judge"
        )
    kind, target = spec.target_kind, relation.target
    named = {"object": (target,), "objects": target or ()}.get(kind, ())
    for name in (relation.subject, *named):
        if name not in placed.by_id:
            return fails(f"{name} is not in the scene")
    subject = placed.by_id[relation.subject]
    other = placed.by_id[target] if kind == "object" and isinstance(target, str) else None
    judgement = function(Case(placed, relation, subject, other, spec))
    if isinstance(judgement, Judgement):
        return judgement
    return HOLDS if judgement else fails("does not hold")


def register_judge(relation_type: str, function: Judge) -> None:
    """Judge relations of a registered type with ``function``: Case -> Judgement, or a bool."""
    if relation_type in _BUILT_IN:
        raise InputError(f"relation type {relation_type!r} is built in; its judge cannot be replaced")
    JUDGES[relation_type] = function


def _whole(overlap: float) -> float:
    """Slack for a face that must lie beside the other in full: else rounding alone decides."""
    return ROUNDING if overlap >= 1.0 else 0.0


# ---- walls, corners, windows, doors ----------------------------------------------------------------------------------


def _against_wall(case: Case) -> Judgement:
    """A face that the catalogue names is against a wall. Of ``gap`` only the most counts: touching is always fine."""
    target = case.relation.target
    index = int(target[5:]) if isinstance(target, str) and target.startswith("wall:") else None
    most = case.spec.value(case.relation, "gap")[1]
    degrees, overlap = case.number("degrees"), case.number("overlap")
    word = case.spec.value(case.relation, "side") if "side" in case.spec.params else "any"
    sides = [side for side in case.spec.subject_sides if word in ("any", side)]
    walls = [wall for wall in case.placed.walls if index is None or wall.index == index]
    if "door_walls" in case.spec.params and case.spec.value(case.relation, "door_walls") == "avoided":
        with_doors = {door.wall.index for door in case.placed.doors}
        walls = [wall for wall in walls if wall.index not in with_doors]
    contacts = wall_contacts(walls, case.subject, sides, most, degrees, overlap)
    return judge(contacts, f"the room has no {target or 'wall'}", _whole(overlap))


def _in_corner(case: Case) -> Judgement:
    """Footprint near a convex corner of the room, and box near both of its walls."""
    import shapely

    placed, corners = case.placed, case.subject.corners
    to_corner, to_wall = case.number("to_corner"), case.number("to_wall")
    foot = placed.footprint(case.subject)

    def alternatives() -> Iterator[Measurements]:
        for wall in placed.walls:
            before = placed.walls[wall.index - 1]
            if before.along[0] * wall.inward[0] + before.along[1] * wall.inward[1] > -CORNER:
                continue
            away = float(shapely.distance(foot, shapely.points(wall.start)).min())
            gaps = [
                min((x - wall.start[0]) * w.inward[0] + (y - wall.start[1]) * w.inward[1] for x, y in corners)
                for w in (before, wall)
            ]
            names = (f"distance to wall {w.index}" for w in (before, wall))
            yield (
                at_most("distance to the corner", away, to_corner),
                *(at_most(name, gap, to_wall) for name, gap in zip(names, gaps, strict=True)),
            )

    return judge(alternatives(), "the room has no convex corner")


def _at_window(case: Case) -> Judgement:
    """Box before the window along its wall, about its middle, and near that wall; any window without a target."""
    most, overlap, offset = case.number("max"), case.number("overlap"), case.number("offset")
    target = case.relation.target

    def measurements(window: Opening) -> Measurements:
        spots = [window.wall.coordinates(corner) for corner in case.subject.corners]
        low, high = min(u for u, _ in spots), max(u for u, _ in spots)
        start, width = window.item.offset, window.item.width
        shared = min(high, start + width) - max(low, start)
        return (
            at_least(f"before {window.item.id}", shared, overlap * min(high - low, width)),
            at_most(
                f"off the middle of {window.item.id}",
                abs((low + high) / 2 - start - width / 2),
                offset,
                slack=TOLERANCE,
            ),
            at_most("distance to its wall", min(g for _, g in spots), most),
        )

    chosen = (w for w in case.placed.windows if target is None or w.item.id == target)
    return judge(map(measurements, chosen), f"the room has no {target or 'window'}")


def _away_from_door(case: Case) -> Judgement:
    """Footprint at least ``min`` from the zone of the door; from every door's without a target."""
    import shapely

    least, target = case.number("min"), case.relation.target
    foot = case.placed.footprint(case.subject)
    apart = [
        at_least(f"distance to {door.item.id}", float(shapely.distance(foot, zone).min()), least, slack=TOLERANCE)
        for door, zone in zip(case.placed.doors, case.placed.opening_zones.polygons, strict=False)
        if target is None or door.item.id == target
    ]
    return (
        fails(f"the room has no {target}") if target is not None and not apart else judge_all(*apart, rounding=ROUNDING)
    )


def _near_opening(case: Case) -> Judgement:
    """Footprint ``min`` to ``max`` from the line that a window or door takes in its wall; any without a target."""
    import shapely

    target, foot = case.relation.target, case.placed.footprint(case.subject)
    openings = case.placed.windows if case.relation.type == "near_window" else case.placed.doors

    def measurements(opening: Opening) -> Measurements:
        item, wall = opening.item, opening.wall
        ends = [
            (wall.start[0] + u * wall.along[0], wall.start[1] + u * wall.along[1])
            for u in (item.offset, item.offset + item.width)
        ]
        away = float(shapely.distance(foot, shapely.linestrings(ends)).min())
        name = f"distance to {item.id}"
        return (Measurement(name, away, case.number("min"), case.number("max"), "m", TOLERANCE),)

    chosen = (o for o in openings if target is None or o.item.id == target)
    return judge(map(measurements, chosen), f"the room has no {target or case.spec.target_kind}")


def _facing_door(case: Case) -> Judgement:
    """Front toward the wall of the door, and near its axis where ``aside`` says so; of any door without a target."""
    target, aside = case.relation.target, case.spec.value(case.relation, "aside")

    def measurements(door: Opening) -> Measurements:
        name = door.item.id
        off = turn(case.subject.front, door.wall.outward)
        angle = at_most(f"turned from {name}", off, case.number("degrees"), "deg")
        if aside is None:
            return (angle,)
        along = door.wall.coordinates(case.subject.centre)[0] - (door.item.offset + door.item.width / 2)
        return (angle, at_most(f"beside {name}", abs(along), aside, slack=TOLERANCE))

    chosen = (door for door in case.placed.doors if target is None or door.item.id == target)
    return judge(map(measurements, chosen), f"the room has no {target or 'door'}")


def _off_walls(case: Case) -> Judgement:
    """Footprint at least ``min`` from the line of every wall."""
    import shapely

    foot = case.placed.footprint(case.subject)
    apart = [
        at_least(
            f"distance to wall {wall.index}",
            float(shapely.distance(foot, shapely.linestrings([wall.start, wall.end])).min()),
            case.number("min"),
            slack=TOLERANCE,
        )
        for wall in case.placed.walls
    ]
    return judge_all(*apart, rounding=ROUNDING)


# ---- faces of two objects --------------------------------------------------------------------------------------------


def _faces(case: Case) -> Judgement:
    """A face of the subject opposes a face of the target; which faces may, the catalogue says."""
    spec, subject, other = case.spec, case.subject, case.other
    gap = spec.gap_range(case.relation, subject.size[0])
    degrees, overlap = case.number("degrees"), case.number("overlap")
    theirs = [other.face(side) for side in spec.target_sides]
    faces = (subject.face(side) for side in spec.subject_sides)
    offset = spec.value(case.relation, "offset") if "offset" in spec.params else None

    def measured(face: Face, theirs: Face) -> Measurements:
        across = (-theirs.normal[1], theirs.normal[0])
        aside = sum((p - q) * n for p, q, n in zip(face.centre, theirs.centre, across, strict=True))
        centred = () if offset is None else (at_most("off its middle", abs(aside), offset, slack=TOLERANCE),)
        return (*face_measurements(face, theirs, gap, degrees, overlap), *centred, *in_line)

    in_line: Measurements = ()
    if "backs" in spec.params and (most := spec.value(case.relation, "backs")) is not None:
        ahead = other.local(subject.face("back").centre)[0] + other.size[0] / 2
        in_line = (
            at_most("turned from the other", turn(subject.front, other.front), degrees, "deg"),
            at_most("back out of line", abs(ahead), most, slack=TOLERANCE),
        )
    pairs = (measured(f, g) for f in faces for g in theirs)
    return judge(pairs, "it has no such face", _whole(overlap))


def _around(case: Case) -> Judgement:
    """Front against an edge of the hull of the target's footprint, and evenly spread among the group.

    The group are the subjects of all ``around`` relations with this target. The angles between the subject and its two
    neighbours, about the target's centre, are 360 / n each; ``n`` is the size of the group when it is not given.
    A group of one has no neighbours.
    """
    subject, other = case.subject, case.other
    gap = case.spec.gap_range(case.relation, subject.size[0])
    degrees, overlap = case.number("degrees"), case.number("overlap")
    spread = _spread(case)
    front = subject.face("front")
    edges = _edges(case.placed, other)
    alternatives = ((*face_measurements(front, e, gap, degrees, overlap), *spread) for e in edges)
    return judge(alternatives, "the target has no edge", ROUNDING)


def _edges(placed: Placed, body: Body) -> Iterator[Face]:
    """Edges of the convex hull of a footprint, as faces."""
    import shapely

    hull = shapely.convex_hull(shapely.multipolygons(placed.footprint(body)))
    ring = shapely.get_coordinates(shapely.normalize(hull))[:-1]
    x, y = ring[:, 0], ring[:, 1]
    if np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) < 0:
        ring = ring[::-1]
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        size = math.hypot(b[0] - a[0], b[1] - a[1])
        if size >= 1e-9:
            normal = (float(b[1] - a[1]) / size, float(a[0] - b[0]) / size)
            yield Face((float(a[0] + b[0]) / 2, float(a[1] + b[1]) / 2), normal, size / 2)


def _spread(case: Case) -> Measurements:
    """Measurements of the angles to the neighbours on both sides [deg]."""
    target, by_id = case.relation.target, case.placed.by_id
    names = {r.subject for r in case.placed.scene.relations if r.type == "around" and r.target == target}
    group = [by_id[name] for name in names if name in by_id]
    n = case.spec.value(case.relation, "n") or len(group)
    if len(group) < 2 or n < 2:
        return ()
    here = _bearing(case.other, case.subject)
    turns = sorted((_bearing(case.other, b) - here) % 360.0 for b in group if b is not case.subject)
    even, off = 360.0 / n, case.number("spread")
    gaps = (("angle to the next", turns[0]), ("angle to the one before", 360.0 - turns[-1]))
    return tuple(Measurement(name, gap, even - off, even + off, "deg") for name, gap in gaps)


def _bearing(centre: Body, body: Body) -> float:
    return math.degrees(math.atan2(body.position[1] - centre.position[1], body.position[0] - centre.position[0]))


# ---- distances and directions ----------------------------------------------------------------------------------------


def _apart(case: Case) -> Judgement:
    """Distance between the footprints."""
    least = case.number("min") if "min" in case.spec.params else 0.0
    apart = case.placed.distance(case.subject, case.other)
    return judge_all(Measurement("distance", apart, least, case.number("max"), "m", TOLERANCE))


def _facing(case: Case) -> Judgement:
    """Target's centre near the direction of the front; coinciding centres face nothing (90 degrees)."""
    (ax, ay), (bx, by) = case.subject.centre, case.other.centre
    off = turn(case.subject.front, (bx - ax, by - ay)) if (ax, ay) != (bx, by) else 90.0
    measured = [at_most("turned away by", off, case.number("degrees"), "deg")]
    if (offset := case.spec.value(case.relation, "offset")) is not None:
        aside = abs(case.other.local(case.subject.centre)[1])
        measured.append(at_most("off its axis", aside, offset, slack=TOLERANCE))
    return judge_all(*measured)


def _yaws(case: Case, modulo: float) -> Judgement:
    off = math.degrees(case.subject.yaw - case.other.yaw)
    off = abs((off + modulo / 2) % modulo - modulo / 2)
    return judge_all(at_most("turned", off, case.number("degrees"), "deg"))


def _aligned(case: Case) -> Judgement:
    return _yaws(case, 90.0)


def _parallel(case: Case) -> Judgement:
    return _yaws(case, 180.0)


def _beside(case: Case) -> Judgement:
    """Subject's centre beyond a face of the target, in a band ``band`` times as wide as that face."""

    def measured(face: Face) -> Measurements:
        dx, dy = case.subject.position[0] - face.centre[0], case.subject.position[1] - face.centre[1]
        beyond = dx * face.normal[0] + dy * face.normal[1]
        aside = abs(dy * face.normal[0] - dx * face.normal[1])
        return (
            Measurement("distance beyond its face", beyond, case.number("min"), case.number("max"), "m", TOLERANCE),
            at_most("aside", aside, case.number("band") / 2 * 2 * face.half),
        )

    return judge((measured(case.other.face(side)) for side in case.spec.target_sides), "", ROUNDING)


def _centered_on(case: Case) -> Judgement:
    """Offsets of the subject's centre in the target's frame: the smaller one, that along its width, or both."""
    forward, aside = case.other.local(case.subject.centre)
    axis, ahead = (case.spec.value(case.relation, name) for name in ("axis", "ahead"))
    offs = {"either": [min(abs(forward), abs(aside))], "width": [abs(aside)], "both": [abs(aside), abs(forward)]}
    counted = offs["width" if ahead is not None else axis]
    measured = [at_most("off centre by", off, case.number("offset"), slack=TOLERANCE) for off in counted]
    if ahead is not None:
        least, most = ahead
        measured.append(Measurement("ahead of its centre", forward, least, most, "m", TOLERANCE))
    return judge_all(*measured)


def _centre_over(case: Case) -> Judgement:
    """Subject's centre inside the target's box, seen from above, ``inset`` from its edges; with ``offset`` as close to
    its place there."""
    local = case.other.local(case.subject.centre)
    inset, offset = case.number("inset"), case.spec.value(case.relation, "offset")
    names, shares = ("along its front", "along its width"), (case.number("forward"), case.number("left"))
    measured = []
    for name, off, size, share in zip(names, local, case.other.size, shares, strict=False):
        measured.append(at_most(f"off {name}", abs(off), max(size / 2 - inset, 0.0), slack=TOLERANCE))
        if offset is not None:
            measured.append(at_most(f"off its place {name}", abs(off - share * size), offset, slack=TOLERANCE))
    return judge([measured], "", ROUNDING)


def _between(case: Case) -> Judgement:
    """Subject's centre beside the middle part of the line between two centres."""
    a, b = (case.placed.by_id[name].centre for name in case.relation.target or ())
    dx, dy = b[0] - a[0], b[1] - a[1]
    size = math.hypot(dx, dy)
    if size < 1e-9:
        return fails("the two targets stand in one place")
    px, py = case.subject.position[0] - a[0], case.subject.position[1] - a[1]
    low, high = case.spec.value(case.relation, "along")
    return judge_all(
        Measurement("along the line", (px * dx + py * dy) / size, low * size, high * size),
        at_most("aside", abs(px * dy - py * dx) / size, case.number("aside")),
        rounding=ROUNDING,
    )


# ---- heights and supports --------------------------------------------------------------------------------------------


def _on_floor(case: Case) -> Judgement:
    z = bottom(case.subject)
    name = "height above the floor" if z >= 0 else "depth below the floor"
    return judge_all(at_most(name, abs(z), case.number("height")), rounding=ROUNDING)


def _on_surface(case: Case) -> Judgement:
    """Subject rests on a surface of the target: the one that its support names, or any when it names none.

    For ``inside`` only surfaces with a head room count.
    """
    item, other = case.subject.item, case.other
    inner = case.relation.type == "inside"
    if item.support is not None and item.support.object != other.id:
        return fails(f"stands on {item.support.object}")
    surfaces = [
        s
        for s in other.item.surfaces
        if (item.support is None or s.name == item.support.surface) and (s.headroom is not None or not inner)
    ]
    rests = [(rest(case.placed, case.subject, other, s), s.name) for s in surfaces]
    if any(r.ok for r, _ in rests):
        return HOLDS
    if not rests:
        return fails(f"{other.id} has no {'inner ' if inner else ''}surface for it")
    nearest, name = min(rests, key=lambda found: found[0].worst.excess)
    return Judgement(False, nearest.text(f"{name} of {other.id}"), nearest.worst)


def _over(case: Case) -> Judgement:
    """``above``: bottom at or over the target's top; ``below``: top at or under its bottom; both within its width."""
    other, subject = case.other, case.subject
    aside = abs(other.local(subject.centre)[1])
    above = case.relation.type == "above"
    clear = bottom(subject) - other.z[1] if above else bottom(other) - subject.z[1]
    return judge_all(
        at_least("clearance", clear, 0.0, slack=TOLERANCE),
        at_most("aside", aside, case.number("lateral") * other.size[1], slack=TOLERANCE),
        rounding=ROUNDING,
    )


def _same_height(case: Case) -> Judgement:
    off = abs(bottom(case.subject) - bottom(case.other))
    return judge_all(at_most("difference of height", off, case.number("tolerance"), slack=TOLERANCE), rounding=ROUNDING)


JUDGES: dict[str, Judge] = {
    "against_wall": _against_wall,
    "side_against_wall": _against_wall,
    "front_against": _faces,
    "front_to_front": _faces,
    "leftright_to_leftright": _faces,
    "side_by_side": _faces,
    "back_to_back": _faces,
    "around": _around,
    "on_floor": _on_floor,
    "on_top": _on_surface,
    "inside": _on_surface,
    "near": _apart,
    "distance": _apart,
    "facing": _facing,
    "aligned": _aligned,
    "parallel": _parallel,
    "left_of": _beside,
    "right_of": _beside,
    "in_front_of": _beside,
    "behind": _beside,
    "beside": _beside,
    "centered_on": _centered_on,
    "in_corner": _in_corner,
    "at_window": _at_window,
    "between": _between,
    "away_from_door": _away_from_door,
    "above": _over,
    "below": _over,
    "same_height": _same_height,
    "seated_at": seated_at,
    "next_to": next_to,
    "run_on": run_on,
    "in_middle": in_middle,
    "over": _centre_over,
    "near_window": _near_opening,
    "near_door": _near_opening,
    "across_from": across_from,
    "facing_door": _facing_door,
    "off_walls": _off_walls,
    "on_grid": on_grid,
}
"""The judge of every relation type."""

_BUILT_IN = frozenset(JUDGES)
