"""Small scenes made by hand."""

from __future__ import annotations

import math
from typing import Any

from sceneweaver.scene import Scene
from sceneweaver.verify import Report, Violation, check

Json = dict[str, Any]


def turned(degrees: float, axis: str = "z") -> list[float]:
    """The xyzw quaternion of a turn about an axis."""
    half = math.radians(degrees) / 2
    return [math.sin(half) if axis == a else 0.0 for a in "xyz"] + [math.cos(half)]


def times(a: list[float], b: list[float]) -> list[float]:
    """The product of two xyzw quaternions: first b, then a."""
    x1, y1, z1, w1 = a
    x2, y2, z2, w2 = b
    return [
        w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
        w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
        w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
        w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
    ]


def box(
    object_id: str, size: tuple[float, float, float], x: float, y: float, yaw: float = 0.0, z: float = 0.0, **more
) -> Json:
    """A box-shaped object; yaw in degrees."""
    pose = {"position": [x, y, z], "quaternion": more.pop("quaternion", turned(yaw))}
    return {"id": object_id, "category": "thing", "size": list(size), "pose": pose, **more}


def rectangle(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    """A counter-clockwise rectangle."""
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def beside(target: Json, ahead: float, left: float) -> tuple[float, float]:
    """World coordinates of a point given in the frame of an upright object."""
    x, y, _ = target["pose"]["position"]
    _, _, s, c = target["pose"]["quaternion"]
    yaw = 2 * math.atan2(s, c)
    return x + math.cos(yaw) * ahead - math.sin(yaw) * left, y + math.sin(yaw) * ahead + math.cos(yaw) * left


def relation(kind: str, subject: str, target: Any = None, hard: bool = True, **params) -> Json:
    return {"type": kind, "subject": subject, "target": target, "params": params, "hard": hard}


def scene(objects: list[Json], relations: list[Json] | None = None, size: float = 8.0, **room) -> Scene:
    """A scene in a square room 2.7 m high, without doors and windows unless given."""
    room = {"outline": rectangle(0.0, 0.0, size, size), **room}
    data = {"schema": "sceneweaver.scene/1", "id": "made", "room": room, "objects": objects}
    return Scene.model_validate({**data, "relations": relations or []})


def judge(objects: list[Json], relations: list[Json] | None = None, meshes: Any = None, **room) -> Report:
    return check(scene(objects, relations, **room), meshes=meshes, walkable=False)


def only(report: Report, kind: str) -> Violation:
    """The one violation of that kind."""
    (violation,) = [v for v in report.violations if v.kind == kind]
    return violation
