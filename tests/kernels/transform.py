"""A scene moved, turned, mirrored or with its objects in another order; and the same for layouts [N, 4]."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import Any

import numpy as np

from sceneweaver.scene import Pose, Scene

Json = dict[str, Any]


def with_poses(scene: Scene, layout: np.ndarray) -> Scene:
    """The scene in a layout."""
    ids = [o.id for o in scene.objects]
    return scene.replace_poses({id: Pose.from_yaw(*map(float, pose)) for id, pose in zip(ids, layout, strict=True)})


def layout_of(scene: Scene) -> np.ndarray:
    """The scene's own layout."""
    return np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects])


# ---- move and turn


def move(scene: Scene, angle: float, shift: tuple[float, float]) -> Scene:
    """The whole room turned about the origin, then shifted."""
    data = scene.to_json()
    z = np.exp(1j * angle) * np.array([complex(*p) for p in data["room"]["outline"]]) + complex(*shift)
    data["room"]["outline"] = [[float(p.real), float(p.imag)] for p in z]
    return with_poses(Scene.from_json(data), move_layout(layout_of(scene), angle, shift))


def move_layout(layout: np.ndarray, angle: float, shift: tuple[float, float]) -> np.ndarray:
    z = np.exp(1j * angle) * (layout[..., 0] + 1j * layout[..., 1]) + complex(*shift)
    return np.stack([z.real, z.imag, layout[..., 2], layout[..., 3] + angle], axis=-1)


# ---- mirror at y = 0

SWAPPED = {"left_of": "right_of", "right_of": "left_of"}
HANDED = {"in-left": "in-right", "in-right": "in-left"}


def _flip(polygon: Sequence[Sequence[float]]) -> list[list[float]]:
    """Counter-clockwise again, from the last corner."""
    return [[x, -y] for x, y in reversed(polygon)]


def mirror(scene: Scene) -> Scene:
    """The room in a mirror: y becomes -y, walls are numbered the other way round."""
    data = copy.deepcopy(scene.to_json())
    room = data["room"]
    outline = np.array(room["outline"])
    lengths = np.hypot(*(np.roll(outline, -1, axis=0) - outline).T)
    n = len(outline)
    room["outline"] = _flip(room["outline"])
    for opening in (*room["doors"], *room["windows"]):
        opening["offset"] = max(0.0, float(lengths[opening["wall"]]) - opening["offset"] - opening["width"])
        opening["wall"] = (n - 2 - opening["wall"]) % n
        if "swing" in opening:
            opening["swing"] = HANDED.get(opening["swing"], opening["swing"])
    for obj in data["objects"]:
        for shape in (*(obj.get("parts") or ()), *obj.get("zones", ()), *obj.get("surfaces", ())):
            shape["polygon"] = _flip(shape["polygon"])
    for relation in data["relations"]:
        relation["type"] = SWAPPED.get(relation["type"], relation["type"])
        target = relation.get("target")
        if isinstance(target, str) and target.startswith("wall:"):
            relation["target"] = f"wall:{(n - 2 - int(target[5:])) % n}"
    return with_poses(Scene.from_json(data), mirror_layout(layout_of(scene)))


def mirror_layout(layout: np.ndarray) -> np.ndarray:
    return layout * (1.0, -1.0, 1.0, -1.0)


# ---- permute


def permute(scene: Scene, objects: Sequence[int], relations: Sequence[int]) -> Scene:
    """Objects and relations in another order: place k is taken by what stood at ``objects[k]``."""
    return scene.model_copy(
        update={
            "objects": tuple(scene.objects[i] for i in objects),
            "relations": tuple(scene.relations[i] for i in relations),
        }
    )
