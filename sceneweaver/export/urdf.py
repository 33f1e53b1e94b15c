"""One piece of furniture as a URDF folder (the base and its doors and drawers, ``<name>.urdf`` and ``meshes/``), and a
whole room as one robot for each kind of piece in ``urdf/`` with ``scene.urdf.json``, which says where they go.

The base link has the frame of the object: origin at the bottom centre, x to the front, y to the left, z up, metres.
Each door and drawer is a link of its own, whose frame stands at the joint's anchor, turned as the base; at 0 it is
closed. Collision parts are boxes where they are boxes, else convex meshes. Mass is spread over the parts by their
volume, as in the MJCF of a scene, and inertias are those of the parts.

A door touches its own cabinet, as doors do, so contacts between a link and its parent are to be left out. Most readers
do so by themselves; MuJoCo does when the base is free, and needs an ``exclude`` for each door when it is fixed.

Meshes are named relative to the file. What MuJoCo is told besides (where the meshes are, that visual ones count) stands
in an element that other readers skip, and so does the friction that Bullet reads.

URDF has one tree a file, and no free bodies beside it, so a room is a list of robots. PyBullet, SAPIEN, Genesis and
others load each file at its pose in a loop of a few lines; pieces that are there twice share their files.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

from sceneweaver.assets import Asset
from sceneweaver.assets.placed import Load
from sceneweaver.physics.inertia import Inertia
from sceneweaver.physics.things import Joint, Thing, things_of
from sceneweaver.physics.xml import child
from sceneweaver.scene import InputError, Room, Scene, SceneObject

from .articulations import (
    BASE,
    KINDS,
    OURS,
    Articulation,
    PlacedArticulation,
    Shape,
    articulation_of,
    limits_of,
    placed_articulations,
    tensor_entries,
)
from .bodies import body_of, with_mesh
from .folder import write_beside, write_folder
from .names import model_name

FOLDER = "urdf"
"""Where the robots of a room and their ``meshes/`` are, beside the list."""


def write_urdf(piece: Asset | SceneObject, folder: str | os.PathLike[str], load: Load | None = None) -> Path:
    """Write the folder whole: under a temporary name beside it, then renamed; an older export there is replaced.

    Args:
        piece: An asset, or an object of a scene in its size; an object without an asset is its parts. Where it
            stands in the scene is no part of the file.
        folder: Where it goes; its parent must be there.
        load: From asset id to asset, for objects; None: the library of this user.

    Returns:
        The path of the URDF file.

    Raises:
        InputError: the asset is missing or has no mesh, the place cannot be written, or holds something else.
    """
    name, files = urdf(piece, load)
    target = Path(folder)
    write_folder(target, files, _ours)
    return target / name


def urdf(piece: Asset | SceneObject, load: Load | None = None) -> tuple[str, dict[str, bytes]]:
    """The name of the URDF file, and all files of the folder by path; see ``write_urdf``."""
    thing = _read(piece, load)
    model = articulation_of(thing, thing.bodies, model_name(body_of(thing).key, thing.object.category))
    file = f"{model.name}.urdf"
    return file, {file: robot(model), **{f"meshes/{name}": content for name, content in model.files.items()}}


def room_urdf(scene: Scene, load: Load | None = None, *, loose: bool = True) -> dict[str, bytes]:
    """All files by path, ``scene.urdf.json`` among them; for the arguments see `placed_articulations`."""
    return robots(scene.id, placed_articulations(scene, load, loose=loose))


def robots(name: str, articulations: Sequence[PlacedArticulation]) -> dict[str, bytes]:
    """The files of articulations under the name of their scene, as `room_urdf` has them."""
    files: dict[str, bytes] = {}
    rows = []
    for placed in articulations:
        path = f"{FOLDER}/{placed.model.name}.urdf"
        if path not in files:
            files[path] = robot(placed.model)
            files |= {f"{FOLDER}/meshes/{file}": content for file, content in placed.model.files.items()}
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
    head = {"scene": name, "unit": "m", "quaternion": "x y z w"}
    files["scene.urdf.json"] = (json.dumps({**head, "robots": rows}, indent=1) + "\n").encode()
    return files


def write_file(scene: Scene, path: Path, load: Load, *, textures: bool = True) -> None:
    """As `formats.Format.write` calls it; meshes have plain colours."""
    files = room_urdf(scene, load)
    files[path.name] = files.pop("scene.urdf.json")
    write_beside(path, files, {FOLDER: OURS})


def robot(model: Articulation) -> bytes:
    """The URDF file of an articulation, whose meshes are in ``meshes/`` beside it."""
    root = Xml.Element("robot", name=model.name)
    hints = child(child(root, "mujoco"), "compiler")
    hints.attrib.update(strippath="false", discardvisual="false", fusestatic="false", balanceinertia="false")
    for look, material in model.looks.items():
        child(child(root, "material", name=look), "color", rgba=(*material.color, material.opacity))
    for link in model.links:
        element = child(root, "link", name=link.name)
        _inertial(element, link.inertia)
        for shape, look in link.visuals:
            child(_geometry(element, "visual", shape), "material", name=look)
        for shape in link.shapes:
            _geometry(element, "collision", shape)
        child(child(element, "contact"), "lateral_friction", value=model.friction)
        if link.joint is not None:
            _joint(root, link.name, link.joint)
    Xml.indent(root, " ")
    return f'<?xml version="1.0"?>\n{Xml.tostring(root, encoding="unicode")}\n'.encode()


def _read(piece: Asset | SceneObject, load: Load | None) -> Thing:
    """The piece as a simulator sees it."""
    if isinstance(piece, Asset):
        if not len(piece.mesh.faces):
            raise InputError(f"asset: '{piece.id}' has no mesh; import it again or choose another asset")
        alone, load = piece.object("piece", mount="floor"), lambda _: piece
    else:
        alone = piece.model_copy(update={"support": None, "mount": "floor"})
    loader = with_mesh(load) if alone.asset is not None else None
    scene = Scene(id="piece", room=Room(outline=((0, 0), (1, 0), (1, 1), (0, 1))), objects=(alone,))
    try:
        return things_of(scene, loader, loose=False)[0]
    except InputError as error:
        raise InputError(str(error).replace("objects[0].asset: ", "asset: ", 1)) from None


def _inertial(element: Xml.Element, inertia: Inertia) -> None:
    made = child(element, "inertial")
    child(made, "origin", xyz=inertia.centre, rpy="0 0 0")
    child(made, "mass", value=inertia.mass)
    child(made, "inertia", tensor_entries(inertia))


def _geometry(link: Xml.Element, tag: str, shape: Shape) -> Xml.Element:
    """What is seen or collides of a link."""
    made = child(link, tag)
    child(made, "origin", xyz=shape.centre, rpy=(0, 0, shape.yaw))
    geometry = child(made, "geometry")
    if shape.size is None:
        child(geometry, "mesh", filename=f"meshes/{shape.file}")
    else:
        child(geometry, "box", size=shape.size)
    return made


def _joint(root: Xml.Element, name: str, joint: Joint) -> None:
    """From the base to a door or drawer."""
    made = child(root, "joint", name=f"{name}_joint", type=KINDS[joint.kind])
    child(made, "parent", link=BASE)
    child(made, "child", link=name)
    child(made, "origin", xyz=joint.anchor, rpy="0 0 0")
    child(made, "axis", xyz=joint.axis)
    child(made, "limit", limits_of(joint))
    child(made, "dynamics", damping=joint.hold, friction=joint.hold)


def _ours(names: set[str]) -> bool:
    """Whether a folder with these names is an export, and so may be replaced."""
    rest = names - {"meshes"}
    return not names or (len(rest) == 1 and rest.pop().endswith(".urdf"))
