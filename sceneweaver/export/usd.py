"""Scenes as USD stages (``.usda`` text, ``.usdc`` binary) for Isaac Sim and everything else that reads UsdPhysics.

::

    /PhysicsScene               gravity; beside /World, so that a stage that refers to this one keeps its own
    /World                      the default prim: metres, kilograms, z up
      Looks, PhysicsMaterials   what is seen, and how it rubs
      Prototypes                mesh and colliders of each asset, once
      Room                      Floor, Walls, Windows, Doors (leaves on hinges), Spawns (where a robot comes in)
      Objects/<id>              one for each object, at its pose; below it an instance of its prototype, and frames of
                                grasps, interiors and support surfaces
      Lights, Cameras           sky, sun and views; lamps carry lights of their own

What may move is a rigid body with its mass; all else has colliders only and stands still. Which is which is decided
where the model for MuJoCo is made, so that both behave alike.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sceneweaver.assets.placed import Load
from sceneweaver.io import open_writable, read_bytes, whole
from sceneweaver.physics.frames import views
from sceneweaver.physics.model import coverings
from sceneweaver.physics.things import Thing, things_of
from sceneweaver.scene import InputError, Scene

from .folder import fill, move
from .shared import SharedFiles
from .usd_bodies import Solids, filter_pair
from .usd_engines import tune_scene
from .usd_layer import attribute, prim, prim_names, usd
from .usd_looks import Looks
from .usd_objects import Prototypes, add_object
from .usd_room import add_room
from .usd_views import AUTO_EXPOSURE, add_cameras, add_lights

SUFFIXES = (".usda", ".usdc")
"""What a file may be called."""

_GRAVITY = 9.81  # [m/s2]


def write_usd(scene: Scene, path: str | os.PathLike[str], load: Load | None = None, *, textures: bool = True) -> None:
    """Write a scene as USD under a temporary name in the same folder, and rename it; images go to ``textures/`` there.

    Args:
        scene: The scene.
        path: The file; ``.usda`` is text, ``.usdc`` binary.
        load: From asset id to asset; None: the library of this user.
        textures: Whether materials have their maps.

    Raises:
        InputError: an asset is missing, the suffix is another, or the place cannot be written.
    """
    name = usd_path(path)
    layer, files = _layer(scene, load, textures)
    save_layer(layer, name, files)


def usd_path(path: str | os.PathLike[str]) -> str:
    """The path of a stage, which has one of the ``SUFFIXES`` and is no folder; InputError for any other."""
    name = os.fspath(path)
    suffix = os.path.splitext(name)[1].lower()
    if suffix not in SUFFIXES:
        raise InputError(f"path: {name} must end in .usda (text) or .usdc (binary)")
    if os.path.isdir(name):
        raise InputError(f"path: {name} is a folder; give a file name in it, such as scene{suffix}")
    return name


def usd_layer(scene: Scene, load: Load | None = None) -> Any:
    """The scene as a ``pxr.Sdf.Layer`` in memory, without maps; ``Usd.Stage.Open`` takes it.

    For the arguments see ``write_usd``.
    """
    return _layer(scene, load, False)[0]


def usd_bytes(scene: Scene, load: Load | None, *, shared: SharedFiles) -> bytes:
    """The scene as a binary stage whose images are shared files."""
    layer, _ = _layer(scene, load, True, shared)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.usdc"
        layer.Export(str(path))
        return read_bytes(path, max_bytes=2**32)


def _layer(
    scene: Scene, load: Load | None, textures: bool, shared: SharedFiles | None = None
) -> tuple[Any, dict[str, bytes]]:
    """The layer, and the images that it names by path relative to it."""
    things = things_of(scene, load)
    layer = usd().Sdf.Layer.CreateAnonymous(".usda")
    with usd().Sdf.ChangeBlock():
        facts = {"id": scene.id, "prompt": scene.prompt, "room": scene.room.type}
        head(layer, facts)
        world = prim(layer, "World", kind="assembly", displayName=scene.id)
        looks = Looks(prim(world, "Looks", "Scope"), prim(world, "PhysicsMaterials", "Scope"), textures, shared)
        prototypes = Prototypes(prim(world, "Prototypes", "Scope"), looks)
        # No two bodies or joints are named alike: engines and importers take the last part of a path.
        names = prim_names()
        titles = [names(thing.object.id) for thing in things]
        doors = add_room(prim(world, "Room", kind="group"), scene.room, looks, names)
        add_lights(prim(world, "Lights", "Scope"), scene.room)
        add_cameras(prim(world, "Cameras", "Scope"), views(scene.room, scene.objects))
        objects = prim(world, "Objects", kind="group")
        solids = [
            add_object(objects, title, thing, prototypes, names) for title, thing in zip(titles, things, strict=True)
        ]
        filter_coverings(things, solids, doors, layer)
    return layer, looks.files


def filter_coverings(things: Sequence[Thing], solids: Sequence[Solids], doors: Sequence[Solids], layer: Any) -> None:
    """Leave out contacts of rugs and mats, which share the layer of what stands or swings over them."""
    for cover, above in coverings(things):
        for other in (*doors, *(solids[k] for k in above)):
            filter_pair(solids[cover], other, layer)


def head(layer: Any, facts: dict[str, Any]) -> None:
    """Units, facts of what is in it and the physics of a layer."""
    layer.defaultPrim = "World"
    layer.comment = "Made by sceneweaver"
    for key, value in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        layer.pseudoRoot.SetInfo(key, value)
    layer.customLayerData = {"sceneweaver": facts, **AUTO_EXPOSURE}
    physics = prim(layer, "PhysicsScene", "PhysicsScene")
    attribute(physics, "physics:gravityDirection", "Vector3f", (0.0, 0.0, -1.0))
    attribute(physics, "physics:gravityMagnitude", "Float", _GRAVITY)
    tune_scene(physics)


def save_layer(layer: Any, name: str, files: dict[str, bytes]) -> None:
    """Write a layer and the images that it names, whole or not at all."""
    try:
        with whole(name) as temporary:
            # Made here first: the system says better than USD why a place cannot be written.
            open_writable(temporary, "xb").close()
            try:
                written = layer.Export(str(temporary))
            except usd().Tf.ErrorException:
                written = False
            if not written:
                raise OSError("the disk may be full")
            fill(temporary.parent, files)
            move(temporary.parent, list(files), Path(name).parent)
    except InputError as error:
        raise InputError(f"path: {error}") from None
