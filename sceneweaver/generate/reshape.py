"""The room of a scene in another shape: the shell that a request asks for, with what stood in the old one."""

from __future__ import annotations

import math
from collections.abc import Mapping

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Pose, Relation, Room, Scene

from .carry import move
from .setup import Setup
from .shell import shell


def reshaped(setup: Setup, scene: Scene) -> tuple[Scene, list[str]]:
    """The scene in a room of the shape that the request names, with as much floor unless that is asked for as well.

    Things keep their place in proportion to the box around the floor, so some may stand outside: poses are proposals.
    Relations to a wall are to that wall of the new room which looks the same way, the nearest of several; those to
    openings that are gone fall away.
    """
    brief, old = setup.brief, scene.room
    area = brief.area or signed_area(old.outline) * brief.scale
    if brief.size is not None:
        area = brief.size[0] * brief.size[1]
    room, notes = shell(setup.room_type, brief, area, setup.seed)
    room = room.model_copy(update={"height": brief.height or max(room.height, old.height)})
    (x0, y0, w, d), (u0, v0, p, q) = _box(old), _box(room)
    poses = {}
    for o in scene.objects:
        if o.support is None:
            x, y, z = o.pose.position
            up = room.height - old.height if o.mount == "ceiling" else 0.0
            place = (u0 + (x - x0) * p / w, v0 + (y - y0) * q / d, z + up)
            poses[o.id] = Pose(position=place, quaternion=o.pose.quaternion)
    known = {*scene.ids, *(o.id for o in (*room.doors, *room.windows, *scene.free_areas))}
    walls = {f"wall:{one.index}": f"wall:{_like(one, old, room)}" for one in old.walls}
    relations = [r for r in (_retold(r, walls) for r in scene.relations) if _holds_on(r, known, len(room.walls))]
    after = {edit.id: edit.pose for edit in move(scene, poses)}
    bare = scene.model_copy(update={"room": room, "relations": tuple(relations)}).replace_poses(after)
    return bare, [f"the floor of {w:.2f} x {d:.2f} m was made a {brief.shape} of {p:.2f} x {q:.2f} m", *notes]


def _box(room: Room) -> tuple[float, float, float, float]:
    """Least corner and sides [m] of the box around a floor."""
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    return min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)


def _like(wall: Wall, old: Room, room: Room) -> int:
    """The wall of another room that looks the way of one, at about the same share of the box."""

    def middle(one: Wall, of: Room) -> tuple[float, float]:
        x0, y0, w, d = _box(of)
        x, y = one.point(one.length / 2)
        return (x - x0) / w, (y - y0) / d

    def apart(other: Wall) -> float:
        turn = 1.0 - (wall.inward[0] * other.inward[0] + wall.inward[1] * other.inward[1])
        return 4.0 * turn + math.dist(middle(wall, old), middle(other, room))

    return min(room.walls, key=lambda other: (round(apart(other), 6), other.index)).index


def _retold(relation: Relation, walls: Mapping[str, str]) -> Relation:
    if isinstance(relation.target, str) and relation.target in walls:
        return relation.model_copy(update={"target": walls[relation.target]})
    return relation


def _holds_on(relation: Relation, known: set[str], walls: int) -> bool:
    """Whether all that a relation names is there."""
    named = {relation.subject, *relation.targets}
    return named <= {*known, *(f"wall:{k}" for k in range(walls))}
