"""What is drawn: meshes somewhere in the world, those of a scene's objects, and which of these a picture leaves out."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.assets.placed import Load, loader, parts_mesh, plain_material, scaled_asset
from sceneweaver.geometry.rotations import matrix
from sceneweaver.geometry.walls import wall_behind
from sceneweaver.scene import Scene, SceneObject


@dataclass(frozen=True)
class Instance:
    """A mesh somewhere in the world; ``transform`` is 4x4, from its frame to the world's."""

    mesh: Mesh
    transform: np.ndarray


def instances_of(scene: Scene, load: Load | None = None) -> list[Instance]:
    """One instance an object, in their order; objects without an asset are drawn as their parts.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    load = loader(load)
    return [_instance(k, thing, load) for k, thing in enumerate(scene.objects)]


def hidden_with(scene: Scene, cut: Collection[int], top: float = math.inf) -> set[str]:
    """Ids of the objects that hang on walls that are cut away or from the ceiling, and of all that stands on those.

    Pictures from above have no ceiling: what hangs from it would float before the furniture. Nor is there anything on
    walls that reaches over the height ``top`` [m] at which all are cut.
    """
    walls = scene.room.walls
    hung = [o for o in scene.objects if o.mount == "wall"]
    gone = {o.id for o in hung if wall_behind(walls, o.pose.position, o.pose.frame.axis) in cut}
    gone |= {o.id for o in hung if o.pose.position[2] + o.size[2] > top}
    gone |= {o.id for o in scene.objects if o.mount == "ceiling"}
    grown = True
    while grown:
        more = {o.id for o in scene.objects if o.support is not None and o.support.object in gone} - gone
        gone |= more
        grown = bool(more)
    return gone


def _instance(index: int, thing: SceneObject, load: Load) -> Instance:
    place = np.eye(4)
    place[:3, :3] = matrix(thing.pose.quaternion)
    place[:3, 3] = thing.pose.position
    asset, scale = scaled_asset(index, thing, load)
    if asset is None:
        return Instance(parts_mesh(thing.solids, plain_material(thing)), place)
    place[:3, :3] = place[:3, :3] * scale
    return Instance(asset.mesh, place)
