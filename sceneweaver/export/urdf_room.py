"""A whole room as URDF: one robot for each kind of piece in ``urdf/``, and ``scene.urdf.json`` that says where they go.

URDF has one tree a file, and no free bodies beside it, so a room is a list of robots. PyBullet, SAPIEN, Genesis and
others load each file at its pose in a loop of a few lines; pieces that are there twice share their files.
"""

from __future__ import annotations

import json

from sceneweaver.assets.placed import Load
from sceneweaver.scene import Scene

from .placed_articulations import placed_articulations
from .urdf import robot

FOLDER = "urdf"
"""Where the robots and their ``meshes/`` are, beside the list."""


def room_urdf(scene: Scene, load: Load | None = None, *, loose: bool = True) -> dict[str, bytes]:
    """All files by path, ``scene.urdf.json`` among them.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        loose: Whether what can be taken off an object is a robot of its own.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    files: dict[str, bytes] = {}
    rows = []
    for placed in placed_articulations(scene, load, loose=loose):
        path = f"{FOLDER}/{placed.model.name}.urdf"
        if path not in files:
            files[path] = robot(placed.model)
            files |= {f"{FOLDER}/meshes/{name}": content for name, content in placed.model.files.items()}
        rows.append(
            {
                "name": placed.name,
                "category": placed.category,
                "file": path,
                "position": list(placed.position),
                "quaternion": list(placed.quaternion),
                "fixed": placed.fixed,
                "friction": placed.model.friction,
            }
        )
    head = {"scene": scene.id, "unit": "m", "quaternion": "x y z w"}
    files["scene.urdf.json"] = (json.dumps({**head, "robots": rows}, indent=1) + "\n").encode()
    return files
