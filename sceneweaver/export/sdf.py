"""A whole room as one SDF world, ``scene.sdf`` with its meshes in ``sdf/``, for Drake, Gazebo and PyBullet.

Every object is a model with the object's id, at the object's pose; its links are ``base`` and its doors and drawers,
whose joints end in ``_joint``. What stands still and has no joints is static. By the standard, joints of static models
do not move, so the base of a fixed piece with doors is welded to the world instead. PyBullet knows no link "world", and
moves the joints of static models: for it, all that stands still is static.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.assets.placed import Load
from sceneweaver.geometry.rotations import matrix
from sceneweaver.physics.xml import text
from sceneweaver.scene import Scene

from .articulations import (
    BASE,
    KINDS,
    OURS,
    ArticulatedLink,
    PlacedArticulation,
    Shape,
    limits_of,
    placed_articulations,
    tensor_entries,
)
from .folder import write_beside

FOLDER = "sdf"
"""Where the meshes are, beside the file."""

_STUD = 1e-3  # [m], radius of the balls in corners of undersides
_INSET = 0.25  # of the way to the middle, where the underside is one face: what lies below it may have bevels
_LEVEL = 1e-4  # [m] within which corners belong to the underside: bevels are higher


def sdf(scene: Scene, load: Load | None = None, *, loose: bool = True, bullet: bool = False) -> dict[str, bytes]:
    """All files by path, ``scene.sdf`` among them; for the arguments see `placed_articulations`.

    ``bullet`` is for PyBullet, which departs from the standard in what stands still and in friction.
    """
    return world_sdf(scene.id, placed_articulations(scene, load, loose=loose), bullet)


def world_sdf(name: str, articulations: Sequence[PlacedArticulation], bullet: bool = False) -> dict[str, bytes]:
    """The files of a world of that name, as `sdf` has them."""
    root = Xml.Element("sdf", {} if bullet else {"xmlns:drake": "http://drake.mit.edu"}, version="1.7")
    world = Xml.SubElement(root, "world", name=model_name(name))
    _text(world, "gravity", (0, 0, -9.81))
    files: dict[str, bytes] = {}
    for placed in articulations:
        _model(world, placed, bullet)
        files |= {f"{FOLDER}/{file}": content for file, content in placed.model.files.items()}
    Xml.indent(root, " ")
    files["scene.sdf"] = f'<?xml version="1.0"?>\n{Xml.tostring(root, encoding="unicode")}\n'.encode()
    return files


def write_file(scene: Scene, path: Path, load: Load, *, textures: bool = True, client: str | None = None) -> None:
    """As `formats.Format.write` calls it; meshes have plain colours."""
    files = sdf(scene, load, bullet=client == "pybullet")
    files[path.name] = files.pop("scene.sdf")
    write_beside(path, files, {FOLDER: OURS})


def model_name(name: str) -> str:
    """The name of a model for an id: letters, digits, ``_``, ``-`` and ``.`` only, as ``::`` separates names in SDF."""
    return re.sub(r"[^A-Za-z0-9_.-]", "_", name)


def roll_pitch_yaw(quaternion: tuple[float, float, float, float]) -> tuple[float, float, float]:
    """Angles [rad] about the fixed axes x, y, z, one after the other, of a rotation (x, y, z, w)."""
    from scipy.spatial.transform import Rotation

    m = matrix(quaternion)
    if abs(m[2][2] - 1.0) < 1e-12:
        return 0.0, 0.0, float(np.arctan2(m[1][0], m[0][0]))
    roll, pitch, yaw = Rotation.from_quat(quaternion).as_euler("xyz")
    return float(roll), float(pitch), float(yaw)


def _text(parent: Xml.Element, tag: str, value) -> Xml.Element:
    made = Xml.SubElement(parent, tag)
    made.text = text(value)
    return made


def _model(world: Xml.Element, placed: PlacedArticulation, bullet: bool) -> None:
    model = Xml.SubElement(world, "model", name=model_name(placed.name))
    links = placed.model.links
    static = placed.fixed and (bullet or len(links) == 1)
    if static:
        _text(model, "static", "1")  # which PyBullet reads, and not "true"
    _text(model, "pose", [*(f"{v:.12g}" for v in placed.position), *map(_exact, roll_pitch_yaw(placed.quaternion))])
    for link in links:
        _link(model, link, placed, bullet)
        if link.joint is not None:
            _joint(model, link)
    if placed.fixed and not static:
        weld = Xml.SubElement(model, "joint", name="weld", type="fixed")
        _text(weld, "parent", "world")
        _text(weld, "child", BASE)


def _exact(angle: float) -> str:
    return f"{angle:.15g}"


def _link(model: Xml.Element, link: ArticulatedLink, placed: PlacedArticulation, bullet: bool) -> None:
    element = Xml.SubElement(model, "link", name=link.name)
    if link.joint is not None:
        _text(element, "pose", (*link.joint.anchor, 0, 0, 0))
    inertial = Xml.SubElement(element, "inertial")
    _text(inertial, "pose", (*link.inertia.centre, 0, 0, 0))
    _text(inertial, "mass", link.inertia.mass)
    inertia = Xml.SubElement(inertial, "inertia")
    for tag, value in tensor_entries(link.inertia).items():
        _text(inertia, tag, value)
    if bullet:
        _text(Xml.SubElement(element, "contact"), "lateral_friction", placed.model.friction)
    for number, (shape, look) in enumerate(link.visuals):
        made = _geometry(element, "visual", number, shape)
        _material(made, placed.model.looks[look])
    for number, shape in enumerate(link.shapes):
        made = _geometry(element, "collision", number, shape, convex=not bullet)
        _friction(made, placed.model.friction)
    if not bullet and link.name == BASE and not placed.fixed:
        for number, corner in enumerate(_underside(link)):
            _friction(_stud(element, number, corner), placed.model.friction)


def _underside(link: ArticulatedLink) -> np.ndarray:
    """At most four points [N, 3] of what a link stands on, near its corners."""
    points = np.concatenate([shape.points for shape in link.shapes])
    level = points[:, 2].min() + _LEVEL
    low = points[points[:, 2] < level]
    ways = np.array([(1, 1), (1, -1), (-1, 1), (-1, -1)], dtype=float)
    middle = low[:, :2].mean(axis=0)
    corners = [low[int(((low[:, :2] - middle) @ way).argmax())] for way in ways]
    share = _INSET if sum(shape.points[:, 2].min() < level for shape in link.shapes) == 1 else 0.0
    offs = [corner[:2] - middle for corner in corners]
    inset = [c - [*(_STUD * np.sign(off) + share * off), 0.0] for c, off in zip(corners, offs, strict=True)]
    return np.unique(np.round(inset, 9), axis=0)


def _stud(link: Xml.Element, number: int, corner: np.ndarray) -> Xml.Element:
    """A small ball in a corner of an underside. Drake has one point of contact a pair of parts, on which boards, boxes
    and books rock and wander; with four more they stand still."""
    made = Xml.SubElement(link, "collision", name=f"stud_{number}")
    _text(made, "pose", (corner[0], corner[1], corner[2] + _STUD, 0, 0, 0))
    _text(Xml.SubElement(Xml.SubElement(made, "geometry"), "sphere"), "radius", _STUD)
    return made


def _friction(collision: Xml.Element, value: float) -> None:
    made = Xml.SubElement(Xml.SubElement(Xml.SubElement(collision, "surface"), "friction"), "ode")
    _text(made, "mu", value)
    _text(made, "mu2", value)


def _geometry(link: Xml.Element, tag: str, number: int, shape: Shape, convex: bool = False) -> Xml.Element:
    """What is seen or collides of a link; ``convex`` tells Drake that a mesh is."""
    made = Xml.SubElement(link, tag, name=f"{tag}_{number}")
    geometry = Xml.SubElement(made, "geometry")
    if shape.size is None:
        mesh = Xml.SubElement(geometry, "mesh")
        _text(mesh, "uri", f"{FOLDER}/{shape.file}")
        if convex:
            Xml.SubElement(mesh, "drake:declare_convex")
    else:
        _text(made, "pose", (*shape.centre, 0, 0, shape.yaw))
        _text(Xml.SubElement(geometry, "box"), "size", shape.size)
    return made


def _material(visual: Xml.Element, look: Material) -> None:
    made = Xml.SubElement(visual, "material")
    _text(made, "diffuse", (*look.color, look.opacity))


def _joint(model: Xml.Element, link: ArticulatedLink) -> None:
    """From the base; its frame is that of the link."""
    joint = link.joint
    assert joint is not None
    made = Xml.SubElement(model, "joint", name=f"{link.name}_joint", type=KINDS[joint.kind])
    _text(made, "parent", BASE)
    _text(made, "child", link.name)
    axis = Xml.SubElement(made, "axis")
    _text(axis, "xyz", joint.axis)
    limit = Xml.SubElement(axis, "limit")
    for tag, value in limits_of(joint).items():
        _text(limit, tag, value)
    dynamics = Xml.SubElement(axis, "dynamics")
    _text(dynamics, "damping", joint.hold)
    _text(dynamics, "friction", joint.hold)
