"""Turn objects where they stand."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sceneweaver.generate.carry import local, move, world
from sceneweaver.generate.draft import Draft
from sceneweaver.geometry.angles import bearing, wrap_angle
from sceneweaver.io.messages import suggest
from sceneweaver.scene import CATALOGUE, InputError, Pose, Scene, SceneObject
from sceneweaver.scene.edits import AnyEdit, Relate, Unrelate, apply_all

from .add_relation import related
from .base import Context, Proposal
from .card import checked

WIDE = 30.0
"""Angle [deg] that a `facing` relation is given where objects are turned toward one."""

TURNS = CATALOGUE.with_role("turning")
"""Types that decide how their subject is turned: next to one of them toward the same thing, facing says nothing new."""


class UpdateRotation:
    """Turns objects, with what they carry, to an angle or toward something."""

    name = "update_rotation"

    def propose(self, context: Context) -> Proposal:
        """New poses for ``ids``; toward an object also a relation that keeps them so."""
        scene, inputs = context.scene, checked(self.name, context.inputs)
        ids = known_ids(scene, inputs["ids"], f"tool {self.name}: inputs.ids")
        ways = [key for key in ("yaw", "degrees", "toward", "square") if inputs.get(key, False) is not False]
        if len(ways) != 1:
            said = f"has {' and '.join(ways)}" if ways else "says no angle"
            raise InputError(f"tool {self.name}: inputs {said}; give one of yaw, degrees, toward and square")
        toward = _toward(scene, inputs["toward"]) if "toward" in inputs else None
        poses: dict[str, Pose] = {}
        notes: list[str] = []
        unmet: list[str] = []
        for id in ids:
            obj = scene.object(id)
            if id == toward:
                notes.append(f"{id} cannot be turned toward itself")
                continue
            if obj.fixed:
                unmet.append(f"{id} is fixed")
                continue
            if obj.mount == "wall":
                unmet.append(f"{id} hangs on a wall, which decides how it is turned")
                continue
            yaw = _yaw(scene, obj, inputs, toward)
            if abs(wrap_angle(yaw - obj.pose.yaw)) < 1e-4:
                notes.append(f"{id} is turned so already")
                continue
            poses[id] = _turned(scene, obj, yaw)
        edits: list[AnyEdit] = [*_yielding(scene, poses, toward), *move(scene, poses)]
        scene, _ = apply_all(scene, edits)
        if toward in set(scene.ids):
            edits += _facing(scene, [i for i in ids if i != toward and scene.object(i).mount == "floor"], toward, unmet)
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def known_ids(scene: Scene, ids: list[str], where: str) -> list[str]:
    """The ids once each; InputError when one is no object."""
    known = scene.ids
    for k, id in enumerate(ids):
        if id not in known:
            fix = suggest(id, known, what="objects", mark="'")
            raise InputError(f"{where}[{k}] is '{id}', which is no object{fix}")
    return list(dict.fromkeys(ids))


def _toward(scene: Scene, word: str) -> str:
    """What objects are turned to: an id of an object, door or window, or door, window, middle or wall."""
    room = scene.room
    openings = [d.id for d in room.doors] + [w.id for w in room.windows]
    if word in ("middle", "wall") or word in scene.ids or word in openings:
        return word
    for noun, found in (("door", room.doors), ("window", room.windows)):
        if word == noun:
            if not found:
                raise InputError(f"tool update_rotation: inputs.toward is '{word}'; the room has none")
            return word
    named = Draft.of(scene).named(word)
    if named:
        return named[0]
    options = [*scene.ids, *openings, "door", "window", "middle", "wall"]
    raise InputError(f"tool update_rotation: inputs.toward is '{word}', which is nothing here{suggest(word, options)}")


def _yaw(scene: Scene, obj: SceneObject, inputs: Mapping[str, Any], toward: str | None) -> float:
    """The new angle [rad] of the front."""
    if inputs.get("square"):
        return _square(scene, obj.pose.yaw)
    if toward is None:
        return float(inputs["yaw"]) if "yaw" in inputs else math.radians(inputs["degrees"])
    x, y, _ = obj.pose.position
    tx, ty = _point(scene, toward, (x, y))
    if math.hypot(tx - x, ty - y) < 1e-6:
        return obj.pose.yaw
    return bearing((x, y), (tx, ty))


def _square(scene: Scene, yaw: float) -> float:
    """The angle [rad] nearest to one at which something stands square to a wall."""
    turns = (wrap_angle(wall.yaw - yaw, math.pi / 2) for wall in scene.room.walls)
    return wrap_angle(yaw + min(turns, key=abs))


def _point(scene: Scene, toward: str, at: tuple[float, float]) -> tuple[float, float]:
    """Where to look [m]."""
    import shapely

    room = scene.room
    if toward in scene.ids:
        return scene.object(toward).pose.position[:2]
    if toward == "middle":
        shape = shapely.Polygon(room.outline)
        spot = shape.centroid if shape.contains(shape.centroid) else shape.representative_point()
        return spot.x, spot.y
    if toward == "wall":
        line = shapely.Polygon(room.outline).exterior
        spot = line.interpolate(line.project(shapely.Point(at)))
        return spot.x, spot.y
    openings = [o for o in (*room.doors, *room.windows) if o.id == toward] or list(
        room.doors if toward == "door" else room.windows
    )
    middles = [room.walls[o.wall].point(o.offset + o.width / 2) for o in openings]
    return min(middles, key=lambda p: math.dist(p, at))


def _turned(scene: Scene, obj: SceneObject, yaw: float) -> Pose:
    """The pose with that yaw; what stands on something keeps to the plane of its support."""
    x, y, z = obj.pose.position
    if obj.support is None:
        return Pose.from_yaw(x, y, z, yaw)
    carrier = scene.object(obj.support.object).pose
    lx, ly, lz, _ = local(carrier, obj.pose)
    return world(carrier, lx, ly, lz, yaw - carrier.yaw)


def _yielding(scene: Scene, poses: Mapping[str, Pose], toward: str | None) -> list[AnyEdit]:
    """Edits that make wishes of the relations that nobody asked for and that would turn objects back."""
    edits: list[AnyEdit] = []
    for r in scene.relations:
        if r.type != "facing" or not r.hard or r.subject not in poses or r.target == toward:
            continue
        if r.asked or not isinstance(r.target, str):
            continue
        at = poses[r.subject].position[:2]
        off = wrap_angle(bearing(at, _point(scene, r.target, at)) - poses[r.subject].yaw)
        if abs(off) > math.radians(float(CATALOGUE["facing"].value(r, "degrees"))):
            edits.append(Unrelate(type=r.type, subject=r.subject, target=r.target))
            edits.append(Relate(relation=r.model_copy(update={"hard": False})))
    return edits


def _facing(scene: Scene, ids: list[str], toward: str, unmet: list[str]) -> list[AnyEdit]:
    """Relations that keep objects turned to one; none where another relation says it already, or says otherwise."""
    rows = []
    for id in ids:
        own = [r for r in scene.relations if r.subject == id and r.hard]
        if any(r.type in TURNS and r.target == toward for r in own):
            continue
        row = {"type": "facing", "subject": id, "target": toward, "params": {"degrees": WIDE}}
        # A bed or a shelf at the wall looks where the wall lets it; then it is a wish.
        row["hard"] = not any(r.type in TURNS for r in own)
        rows.append(row)
    edits, _, against = related(scene, rows, "tool update_rotation: toward")
    unmet += against
    return list(edits)
