"""Lengths of a scene that an optimiser may choose: sizes of objects, places of openings, extents of the room."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import InputError, Pose, Scene
from sceneweaver.scene.edits import SetSize, apply_all

SIZES = ("depth", "width", "height")
OPENINGS = ("offset", "width")
ROOM = ("x", "y", "height")
KINDS = {"size": SIZES, "opening": OPENINGS, "room": ROOM}
MOST = 64
"""Variables of one problem."""


@dataclass(frozen=True)
class Variable:
    """A length [m] between bounds.

    Attributes:
        kind: "size" of an object, place of an "opening" (a door or window) along its wall, extent of the "room".
        target: id of the object or opening; of the room "".
        axis: of a size "depth" (along the front), "width" or "height"; of an opening its "offset" from the wall's first
            corner or its "width"; of the room "x" or "y", how far its outline reaches along that axis, or "height".
        low, high: bounds [m], both may be taken.
        cost: weight of its value in the objective, per metre; negative: the longer the better.

    With its size an object's collision parts, zones and surfaces are scaled, and its mesh where it is drawn. With the
    room's extent all corners and the poses of what is not fixed are scaled from the outline's lowest corner, and the
    middles of openings keep their share of their wall; their widths stay.

    Raises:
        InputError: a kind or axis that there is not, or bounds that are none.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.Variable("size", "desk", "width", 1.0, 1.8, cost=-1.0).name
        'desk.width'
    """

    kind: str
    target: str
    axis: str
    low: float
    high: float
    cost: float = 0.0

    def __post_init__(self) -> None:
        """Raise InputError on what is out of range."""
        if self.kind not in KINDS:
            raise InputError(f"variable: kind {self.kind!r} is not one of {', '.join(KINDS)}")
        if not isinstance(self.target, str) or (self.target == "") != (self.kind == "room"):
            raise InputError(f'variable: target {self.target!r} is not an id; of the room it is ""')
        if self.axis not in KINDS[self.kind]:
            raise InputError(f"variable {self.name}: axis {self.axis!r} is not one of {', '.join(KINDS[self.kind])}")
        for key in ("low", "high", "cost"):
            value = getattr(self, key)
            if not isinstance(value, int | float) or isinstance(value, bool) or not math.isfinite(value):
                raise InputError(f"variable {self.name}: {key} {value!r} is not a finite number")
        least = 0.0 if self.axis == "offset" else 1e-3
        if not least <= self.low <= self.high:
            text = f"variable {self.name}: bounds [{self.low:g}, {self.high:g}] m are none; low is at least {least:g}"
            raise InputError(f"{text} and at most high")

    @property
    def name(self) -> str:
        """What it is called: target and axis."""
        return f"{self.target or 'room'}.{self.axis}"

    def value(self, scene: Scene) -> float:
        """Its value [m] in a scene."""
        if self.kind == "size":
            return float(scene.object(self.target).size[SIZES.index(self.axis)])
        if self.kind == "opening":
            return float(getattr(next(o for o in scene.room.openings if o.id == self.target), self.axis))
        if self.axis == "height":
            return float(scene.room.height)
        return float(np.ptp(np.asarray(scene.room.outline)[:, ROOM.index(self.axis)]))


def check_variables(scene: Scene, variables: Sequence[Variable]) -> None:
    """Raise InputError when variables are none, name what the scene does not have, or one thing twice."""
    if isinstance(variables, Variable) or not variables or len(variables) > MOST:
        raise InputError(f"variables: give a list of 1 to {MOST} Variables")
    known = {"size": set(scene.ids), "opening": {o.id for o in scene.room.openings}, "room": {""}}
    seen: set[tuple[str, str, str]] = set()
    for variable in variables:
        if not isinstance(variable, Variable):
            raise InputError(f"variables: {variable!r} is not a Variable")
        if variable.target not in known[variable.kind]:
            what = "object" if variable.kind == "size" else "door or window"
            raise InputError(f'variables: "{variable.target}" is no {what} of the scene')
        key = (variable.kind, variable.target, variable.axis)
        if key in seen:
            raise InputError(f"variables: {variable.name} is there twice")
        seen.add(key)


def with_values(scene: Scene, variables: Sequence[Variable], values: Sequence[float] | np.ndarray) -> Scene:
    """The scene with its variables at values [m]: sizes first, then the room, then openings.

    Raises:
        InputError: there is no such scene, as where an opening reaches over the end of its wall.
    """
    given = list(zip(variables, map(float, values), strict=True))
    sizes: dict[str, list[float]] = {}
    for variable, value in given:
        if variable.kind == "size":
            size = sizes.setdefault(variable.target, list(scene.object(variable.target).size))
            size[SIZES.index(variable.axis)] = value
    scene, _ = apply_all(scene, [SetSize(id=name, size=(s[0], s[1], s[2])) for name, s in sizes.items()])
    room = {variable.axis: value for variable, value in given if variable.kind == "room"}
    openings: dict[str, dict[str, float]] = {}
    for variable, value in given:
        if variable.kind == "opening":
            openings.setdefault(variable.target, {})[variable.axis] = value
    return _in_room(scene, room, openings) if room or openings else scene


def _in_room(scene: Scene, extents: dict[str, float], openings: dict[str, dict[str, float]]) -> Scene:
    """The scene in a room of other extents and openings."""
    data = scene.room.model_dump(by_alias=True)
    corners = np.asarray(scene.room.outline, dtype=np.float64)
    low, reach = corners.min(axis=0), np.ptp(corners, axis=0)
    factor = np.array([extents.get(axis, reach[k]) / reach[k] for k, axis in enumerate("xy")])
    before, after = walls_of(scene.room.outline), None
    if (factor != 1.0).any():
        outline = [tuple(map(float, low + factor * (corner - low))) for corner in corners]
        after = walls_of(outline)
        data["outline"] = outline
    data["height"] = extents.get("height", scene.room.height)
    for key in ("doors", "windows"):
        for opening in data[key]:
            changed = openings.get(opening["id"], {})
            middle = opening["offset"] + opening["width"] / 2
            opening["width"] = changed.get("width", opening["width"])
            if after is not None:
                middle *= after[opening["wall"]].length / before[opening["wall"]].length
                length = after[opening["wall"]].length
                middle = min(max(middle, opening["width"] / 2), max(length - opening["width"] / 2, 0.0))
            if after is not None or changed:
                opening["offset"] = (
                    changed["offset"] if "offset" in changed else max(middle - opening["width"] / 2, 0.0)
                )
    room = type(scene.room).model_validate(data)
    poses = {}
    moved: dict[str, np.ndarray] = {}
    for obj in scene.objects:
        if obj.fixed:
            continue
        at = np.asarray(obj.pose.position, dtype=np.float64)
        if obj.support is None:
            shift = np.append((factor - 1.0) * (at[:2] - low), 0.0)
            if obj.mount == "ceiling":
                shift[2] = room.height - scene.room.height
            moved[obj.id] = shift
    carried = {o.id: o.support.object for o in scene.objects if o.support is not None}
    for obj in scene.objects:
        root = obj.id
        while root in carried:
            root = carried[root]
        if root in moved and not obj.fixed and moved[root].any():
            x, y, z = (np.asarray(obj.pose.position) + moved[root]).tolist()
            poses[obj.id] = Pose(position=(x, y, z), quaternion=obj.pose.quaternion)
    changed = scene.model_copy(update={"room": room})
    return Scene.from_json(changed.to_json()).replace_poses(poses)
