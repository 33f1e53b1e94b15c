"""One piece of furniture as a URDF folder: the base and its doors and drawers, ``<name>.urdf`` and ``meshes/``.

The base link has the frame of the object: origin at the bottom centre, x to the front, y to the left, z up, metres.
Each door and drawer is a link of its own, whose frame stands at the joint's anchor, turned as the base; at 0 it is
closed. Collision parts are boxes where they are boxes, else convex meshes. Mass is spread over the parts by their
volume, as in the MJCF of a scene, and inertias are those of the parts.

A door touches its own cabinet, as doors do, so contacts between a link and its parent are to be left out. Most readers
do so by themselves; MuJoCo does when the base is free, and needs an ``exclude`` for each door when it is fixed.

Meshes are named relative to the file. What MuJoCo is told besides (where the meshes are, that visual ones count) stands
in an element that other readers skip, and so does the friction that Bullet reads.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets import Asset, Link
from sceneweaver.assets.placed import Load
from sceneweaver.physics.hulls import Solid
from sceneweaver.physics.inertia import Inertia, inertia_of, triangles
from sceneweaver.physics.things import Thing, joint_of, things_of
from sceneweaver.physics.xml import child, text
from sceneweaver.scene import InputError, Room, Scene, SceneObject

from .bodies import Body, bodies_of
from .folder import write_folder
from .models import model_name, with_mesh

BASE = "base"
"""Name of the link that stands still."""

_EFFORT = {"hinge": 50.0, "slide": 200.0}  # [N m], [N]: what a person's pull comes to
_SPEED = {"hinge": 3.0, "slide": 2.0}  # [rad/s], [m/s]
_MATERIALS = "materials.mtl"


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
    thing, body = _read(piece, load)
    parts = thing.bodies
    names = _names([BASE, *(part.link.name for part in parts if part.link is not None)])
    anchors = [np.zeros(3) if p.link is None else np.asarray(p.link.anchor) * np.asarray(thing.scale) for p in parts]
    title = model_name(body.key, thing.object.category)
    robot = Xml.Element("robot", name=title)
    hints = child(child(robot, "mujoco"), "compiler")
    hints.attrib.update(strippath="false", discardvisual="false", fusestatic="false", balanceinertia="false")
    looks = _Looks(robot, thing, body)
    meshes: dict[str, bytes] = {}
    for part, name, anchor in zip(parts, names, anchors, strict=True):
        volume = sum(solid.volume for solid in part.solids)
        element = child(robot, "link", name=name)
        inertia = inertia_of(part.solids, [part.mass * solid.volume / volume for solid in part.solids])
        _inertial(element, inertia, anchor)
        meshes |= looks.visuals(element, name, part.number, anchor)
        meshes |= _collisions(element, name, part.solids, anchor)
        contact = child(element, "contact")
        child(contact, "lateral_friction", value=thing.friction)
        if part.link is not None:
            _joint(robot, name, part.link, thing.scale, anchor, inertia.mass)
    meshes[_MATERIALS] = looks.library()
    Xml.indent(robot, " ")
    text = Xml.tostring(robot, encoding="unicode", xml_declaration=False)
    top = f'<?xml version="1.0"?>\n{text}\n'
    file = f"{title}.urdf"
    return file, {file: top.encode(), **{f"meshes/{name}": content for name, content in meshes.items()}}


def _read(piece: Asset | SceneObject, load: Load | None) -> tuple[Thing, Body]:
    """The piece as a simulator and as a viewer see it, both in the frame of the object."""
    if isinstance(piece, Asset):
        if not len(piece.mesh.faces):
            raise InputError(f"asset: '{piece.id}' has no mesh; import it again or choose another asset")
        alone, load = piece.object("piece", mount="floor"), lambda _: piece
    else:
        alone = piece.model_copy(update={"support": None, "mount": "floor"})
    loader = with_mesh(load) if alone.asset is not None else None
    scene = Scene(id="piece", room=Room(outline=((0, 0), (1, 0), (1, 1), (0, 1))), objects=(alone,))
    try:
        return things_of(scene, loader, loose=False)[0], bodies_of(scene, loader)[0]
    except InputError as error:
        raise InputError(str(error).replace("objects[0].asset: ", "asset: ", 1)) from None


def _names(names: Sequence[str]) -> list[str]:
    """Names that every reader takes, and no two alike."""
    found: list[str] = []
    for name in names:
        word = re.sub(r"[^A-Za-z0-9_]", "_", name) or "link"
        spare, count = word, 1
        while spare in found:
            count += 1
            spare = f"{word}_{count}"
        found.append(spare)
    return found


def _inertial(element: Xml.Element, inertia: Inertia, anchor: np.ndarray) -> None:
    made = child(element, "inertial")
    child(made, "origin", xyz=inertia.centre - anchor, rpy="0 0 0")
    child(made, "mass", value=inertia.mass)
    t = inertia.tensor
    entries = {"ixx": t[0, 0], "ixy": t[0, 1], "ixz": t[0, 2], "iyy": t[1, 1], "iyz": t[1, 2], "izz": t[2, 2]}
    child(made, "inertia", {name: f"{float(value):.12g}" for name, value in entries.items()})


def _collisions(element: Xml.Element, name: str, solids: Sequence[Solid], anchor: np.ndarray) -> dict[str, bytes]:
    """The collision parts of a link; returns the meshes that they need."""
    files: dict[str, bytes] = {}
    for k, solid in enumerate(solids):
        made = child(element, "collision")
        if solid.box is not None:
            centre, half = solid.box
            child(made, "origin", xyz=centre - anchor, rpy="0 0 0")
            child(child(made, "geometry"), "box", size=2 * np.asarray(half))
            continue
        file = f"{name}-part-{k}.obj"
        corners = triangles(solid.points)[1].reshape(-1, 3)
        points, faces = np.unique(corners, axis=0, return_inverse=True)
        files[file] = _obj(points - anchor, faces.reshape(-1, 3))
        child(made, "origin", xyz="0 0 0", rpy="0 0 0")
        child(child(made, "geometry"), "mesh", filename=f"meshes/{file}")
    return files


def _joint(
    robot: Xml.Element, name: str, link: Link, scale: tuple[float, float, float], anchor: np.ndarray, mass: float
) -> None:
    """From the base to a door or drawer."""
    axis, (low, high), hold = joint_of(link, scale, mass)
    kind = "prismatic" if link.joint == "slide" else "revolute"
    made = child(robot, "joint", name=f"{name}_joint", type=kind)
    child(made, "parent", link=BASE)
    child(made, "child", link=name)
    child(made, "origin", xyz=anchor, rpy="0 0 0")
    child(made, "axis", xyz=axis)
    child(made, "limit", lower=low, upper=high, effort=_EFFORT[link.joint], velocity=_SPEED[link.joint])
    child(made, "dynamics", damping=hold, friction=hold)


class _Looks:
    """What is seen: a mesh for each link and material, since most readers take one colour for each mesh."""

    def __init__(self, robot: Xml.Element, thing: Thing, body: Body):
        self._body = body
        self._face_body = thing.face_body if thing.asset is not None else body.mesh.face_link
        used = np.unique(body.mesh.face_material).tolist()
        names = _names([body.mesh.materials[k].name for k in used])
        self._looks = {k: (name, body.mesh.materials[k]) for k, name in zip(used, names, strict=True)}
        for look, material in self._looks.values():
            color = text((*material.color, material.opacity))
            child(child(robot, "material", name=look), "color", rgba=color)

    def visuals(self, element: Xml.Element, name: str, link: int, anchor: np.ndarray) -> dict[str, bytes]:
        """Add the visual meshes of a link; returns their files."""
        mesh, files = self._body.mesh, {}
        for k, (look, _) in self._looks.items():
            faces = mesh.faces[(self._face_body == link) & (mesh.face_material == k)]
            if not len(faces):
                continue
            kept, packed = np.unique(faces, return_inverse=True)
            points = mesh.vertices[kept] * np.asarray(self._body.scale) - anchor
            file = f"{name}-{look}.obj"
            files[file] = _obj(points, packed.reshape(-1, 3), look)
            made = child(element, "visual")
            child(made, "origin", xyz="0 0 0", rpy="0 0 0")
            child(child(made, "geometry"), "mesh", filename=f"meshes/{file}")
            child(made, "material", name=look)
        return files

    def library(self) -> bytes:
        """The material library that the visual meshes name."""
        lines = []
        for name, m in self._looks.values():
            rgb = text(m.color)
            shine = text(np.asarray(m.color) * min(1.0, m.emission))
            lines += [f"newmtl {name}", f"Kd {rgb}", f"Ke {shine}", f"d {text(m.opacity)}"]
            lines += [f"Pr {text(m.roughness)}", f"Pm {text(m.metallic)}", "illum 2", ""]
        return "\n".join(lines).encode()


def _obj(points: np.ndarray, faces: np.ndarray, material: str | None = None) -> bytes:
    lines = [] if material is None else [f"mtllib {_MATERIALS}", f"usemtl {material}"]
    lines[1:1] = [f"v {text(point)}" for point in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    return ("\n".join(lines) + "\n").encode()


def _ours(names: set[str]) -> bool:
    """Whether a folder with these names is an export, and so may be replaced."""
    rest = names - {"meshes"}
    return not names or (len(rest) == 1 and rest.pop().endswith(".urdf"))
