"""A bedroom of ten boxes with fourteen relations on 4 x 5 m: what solvers that know boxes only can be asked to do."""

from __future__ import annotations

import math
from functools import cache

from sceneweaver.scene import SCHEMA, Pose, Scene

NAME = "ten-boxes"

BOXES = {  # size [m], x, y [m], yaw [degrees] of a valid layout
    "bed": ((2.0, 1.6, 0.5), 2.0, 3.97, -90),
    "nightstand-left": ((0.4, 0.45, 0.5), 0.95, 4.77, -90),
    "nightstand-right": ((0.4, 0.45, 0.5), 3.05, 4.77, -90),
    "wardrobe": ((0.6, 1.2, 2.0), 0.33, 2.9, 0),
    "dresser": ((0.45, 1.0, 0.8), 0.26, 1.5, 0),
    "desk": ((0.6, 1.2, 0.75), 3.67, 1.6, 180),
    "chair": ((0.5, 0.5, 0.9), 3.09, 1.6, 0),
    "bookshelf": ((0.3, 0.8, 1.8), 3.82, 2.9, 180),
    "armchair": ((0.8, 0.8, 0.9), 1.5, 1.6, 78),
    "plant": ((0.35, 0.35, 1.0), 0.25, 0.25, 0),
}

RELATIONS = (
    ("against_wall", "bed", None),
    ("leftright_to_leftright", "nightstand-left", "bed"),
    ("leftright_to_leftright", "nightstand-right", "bed"),
    ("against_wall", "nightstand-left", None),
    ("against_wall", "nightstand-right", None),
    ("against_wall", "wardrobe", None),
    ("against_wall", "dresser", None),
    ("against_wall", "desk", None),
    ("front_to_front", "chair", "desk"),
    ("against_wall", "bookshelf", None),
    ("near", "armchair", "dresser"),
    ("facing", "armchair", "bed"),
    ("in_corner", "plant", None),
    ("aligned", "wardrobe", "bed"),
)


@cache
def ten_boxes() -> Scene:
    """The room in a valid layout: floor fill 0.41, a door, no zones."""
    objects = []
    for object_id, (size, x, y, degrees) in BOXES.items():
        pose = Pose.from_yaw(x, y, 0.0, math.radians(degrees))
        placed = {"position": list(pose.position), "quaternion": list(pose.quaternion)}
        objects.append({"id": object_id, "category": object_id, "mount": "floor", "size": list(size), "pose": placed})
    relations = [{"type": t, "subject": a, "target": b, "hard": True} for t, a, b in RELATIONS]
    door = {"id": "door", "wall": 0, "offset": 1.3, "width": 0.8, "height": 2.05}
    outline = [[0, 0], [4, 0], [4, 5], [0, 5]]
    room = {"type": "bedroom", "outline": outline, "doors": [door]}
    return Scene.from_json({"schema": SCHEMA, "id": NAME, "room": room, "objects": objects, "relations": relations})
