"""Scenes as SceneState JSON (``scene@1.0.2``), which SceneEval and the scene toolkit read.

The scene is in metres, z up, and its front is +y, as SceneEval has it by default. An object's matrix (column by
column) maps from **the frame of its model file** to the scene. That frame is glTF's: y up, front +z, left +x, origin
at the bottom centre, which is the object's own frame (z up, front +x, left +y) with its axes renamed: (x, y, z) of the
object is (y, z, x) of the model. So the matrix of an object that stands at yaw 0 is a rotation too, and one who uses
the boxes instead of the models should take ``obb``: centre, full edge lengths and axes (one after the other) in the
scene's frame.

Walls run along the outline counter-clockwise, the room on their left. The box of a hole is [along, up] in metres from
the wall's first point. SceneEval turns walls by multiples of 90 degrees only, so rooms with slanted walls are for
other readers.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.assets.placed import Load
from sceneweaver.assets.room_looks import room_looks, wall_look
from sceneweaver.geometry.rotations import matrix, multiply
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS, heights
from sceneweaver.scene import Door, Room, Scene, SceneObject, Window

from .bodies import Body, Missing, bodies_of, with_mesh
from .folder import write_beside
from .glb import model_bytes
from .names import model_name

SOURCE = "sceneweaver"
"""The asset source: what stands before the dot of a model id."""

_MODEL = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])  # from the model's frame to the object's
_MODEL_QUATERNION = (0.5, 0.5, 0.5, 0.5)  # the same as x, y, z, w


def write_scenestate(
    scene: Scene,
    path: str | os.PathLike[str],
    load: Load | None = None,
    missing: Missing = "error",
    models: bool = False,
) -> Path:
    """Write a scene as SceneState JSON, on wish with its geometry.

    Args:
        scene: The scene.
        path: Of the JSON file; its folder must be there.
        load: From asset id to asset; None: the library of this user.
        missing: Whether an asset that cannot be loaded is an error, or its object is shown as its parts.
        models: Also write ``models/<name>/<name>.glb`` and ``data.json`` beside it, once for each asset; the model id
            of an object is ``sceneweaver.<name>``. Several scenes in one folder share them.

    Returns:
        The path of the JSON file, which comes last: where it is new, all models are there.

    Raises:
        InputError: an asset is missing or has no mesh, or the place cannot be written.
    """
    target = Path(path)
    bodies = bodies_of(scene, with_mesh(load), missing)
    text = json.dumps(_document(scene, bodies), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    files = _model_files(bodies) if models else {}
    write_beside(target, {**files, target.name: text.encode()}, {})
    return target


def write_file(scene: Scene, path: Path, load: Load, *, textures: bool = True) -> None:
    """As `formats.Format.write` calls it; models always have their maps, as scenes share them."""
    write_scenestate(scene, path, load, models=True)


def scenestate(scene: Scene, load: Load | None = None, missing: Missing = "error") -> dict[str, Any]:
    """A scene as the data of a SceneState file; for the arguments see ``write_scenestate``."""
    return _document(scene, bodies_of(scene, with_mesh(load), missing))


def _document(scene: Scene, bodies: Sequence[Body]) -> dict[str, Any]:
    return {
        "format": "sceneState",
        "scene": {
            "version": "scene@1.0.2",
            "id": scene.id,
            "description": scene.prompt,
            "up": [0, 0, 1],
            "front": [0, 1, 0],
            "unit": 1.0,
            "assetSource": [SOURCE],
            "arch": _arch(scene.id, scene.room),
            "object": [_object(scene, index, body) for index, body in enumerate(bodies)],
            "modifications": [],
        },
        "selected": [],
    }


def _object(scene: Scene, index: int, body: Body) -> dict[str, Any]:
    thing = body.object
    parent = thing.support.object if thing.support is not None else None
    entry: dict[str, Any] = {
        "id": thing.id,
        "modelId": f"{SOURCE}.{_name(body)}",
        "index": index,
        "parentId": parent or "",
        "parentIndex": -1 if parent is None else scene.index(parent),
        "transform": _transform(thing, body.scale),
        "obb": _box(thing),
        "category": thing.category,
        "mount": thing.mount,
    }
    if thing.description:
        entry["description"] = thing.description
    if thing.support is not None:
        entry["surface"] = thing.support.surface
    if thing.asset is not None:
        entry["asset"] = thing.asset
    if body.note:
        entry["note"] = body.note
    return entry


def _transform(thing: SceneObject, scale: Sequence[float]) -> dict[str, Any]:
    """From the model's frame to the scene's: as a matrix, and as what it is made of (first scale, then rotation)."""
    turn = matrix(thing.pose.quaternion)
    to_scene = np.eye(4)
    to_scene[:3, :3] = turn @ np.diag(scale) @ _MODEL
    to_scene[:3, 3] = thing.pose.position
    return {
        "rows": 4,
        "cols": 4,
        "data": to_scene.T.reshape(-1).tolist(),
        "rotation": list(multiply(thing.pose.quaternion, _MODEL_QUATERNION)),
        "translation": list(thing.pose.position),
        "scale": [scale[1], scale[2], scale[0]],
    }


def _box(thing: SceneObject) -> dict[str, list[float]]:
    """The object's box in the scene: centre, full lengths, and its front, left and up axes, one after the other."""
    turn = matrix(thing.pose.quaternion)
    centre = np.asarray(thing.pose.position) + turn[:, 2] * thing.size[2] / 2
    return {"centroid": centre.tolist(), "axesLengths": list(thing.size), "normalizedAxes": turn.T.reshape(-1).tolist()}


def _arch(name: str, room: Room) -> dict[str, Any]:
    elements: list[dict[str, Any]] = []
    looks = room_looks(room)
    for kind, z, depth in (("Floor", 0.0, FLOOR_THICKNESS), ("Ceiling", room.height, FLOOR_THICKNESS)):
        made = {"id": f"room|{kind.lower()}", "type": kind, "roomId": "room", "depth": depth}
        look = [{"name": "surface", "diffuse": _hex(looks.floor if kind == "Floor" else looks.wall)}]
        elements.append(made | {"points": [[x, y, z] for x, y in room.outline], "materials": look})
    for wall in room.walls:
        paint = _hex(wall_look(room, wall.index))
        elements.append(
            {
                "id": f"room|wall|{wall.index}",
                "type": "Wall",
                "roomId": "room",
                "height": room.height,
                "depth": WALL_THICKNESS,
                "points": [[*wall.start, 0.0], [*wall.end, 0.0]],
                "holes": [_hole(o) for o in room.openings_of(wall.index)],
                "materials": [{"name": side, "diffuse": paint} for side in ("inside", "outside")],
            }
        )
    return {
        "version": "arch@1.0.2",
        "id": name,
        "up": [0, 0, 1],
        "front": [0, 1, 0],
        "coords2d": [0, 1],
        "scaleToMeters": 1,
        "defaults": {
            "Wall": {"depth": WALL_THICKNESS, "extraHeight": 0.0},
            "Ceiling": {"depth": FLOOR_THICKNESS},
            "Floor": {"depth": FLOOR_THICKNESS},
        },
        "elements": elements,
        "regions": [{"id": "room", "type": room.type, "walls": list(range(2, len(elements)))}],
    }


def _hole(opening: Door | Window) -> dict[str, Any]:
    low, high = heights(opening)
    box = {"min": [opening.offset, low], "max": [opening.offset + opening.width, high]}
    return {"id": opening.id, "type": "Door" if isinstance(opening, Door) else "Window", "box": box}


def _model_files(bodies: Sequence[Body]) -> dict[str, bytes]:
    """GLB and facts of each model, by path beside the JSON file."""
    files: dict[str, bytes] = {}
    for body in {b.key: b for b in bodies}.values():  # bodies with an equal key have the same mesh
        name, thing = _name(body), body.object
        materials = list(dict.fromkeys(body.mesh.materials[int(k)].name for k in body.mesh.face_material))
        facts = {"category": thing.category, "description": thing.description or "", "materials": materials}
        data = {"annotations": facts, "up": [0, 1, 0], "front": [0, 0, 1], "unit": 1.0}
        files[f"models/{name}/{name}.glb"] = model_bytes(body.mesh, name)
        files[f"models/{name}/data.json"] = (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode()
    return files


def _name(body: Body) -> str:
    return model_name(body.key, body.object.category)


def _hex(material: Material) -> str:
    return "#" + "".join(f"{round(c * 255):02x}" for c in material.color)
