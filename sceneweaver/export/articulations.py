"""What URDF and SDF have in common: articulations with their meshes, and where each of them stands in the room.

An articulation is a base link and the doors, drawers and controls that hang on it. The base link has the frame of the
object: origin at the bottom centre, x to the front, y to the left, z up, metres. The frame of every other link stands
at its joint's anchor, turned as the base; at 0 it is closed. What can be taken off an object is an articulation of its
own, one link in the frame of the object.

Collision parts are boxes where they are boxes, else convex meshes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from sceneweaver.assets import Material, Mesh
from sceneweaver.physics.hulls import Solid
from sceneweaver.physics.inertia import Inertia, inertia_of, triangles
from sceneweaver.physics.things import RigidBody, Thing, joint_of
from sceneweaver.physics.xml import text

from .bodies import Body

BASE = "base"
"""Name of the link that all others hang on."""

EFFORT = {"revolute": 50.0, "prismatic": 200.0}
"""[N m], [N] by kind of joint: what a person's pull comes to."""

SPEED = {"revolute": 3.0, "prismatic": 2.0}
"""[rad/s], [m/s]"""


@dataclass(frozen=True)
class Joint:
    """A joint from the base; ``limits`` [rad] or [m], ``hold`` is friction and damping at once, [N m] or [N]."""

    kind: Literal["revolute", "prismatic"]
    axis: np.ndarray
    limits: tuple[float, float]
    hold: float


@dataclass(frozen=True)
class Shape:
    """A body in its link's frame: a box of ``size`` [3] about ``centre`` [3], turned by ``yaw`` [rad] about z, or the
    mesh ``file`` as it is. ``points`` [N, 3] are the corners of a collision part of a piece."""

    size: np.ndarray | None = None
    centre: np.ndarray = field(default_factory=lambda: np.zeros(3))
    yaw: float = 0.0
    file: str = ""
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))


@dataclass(frozen=True)
class ArticulatedLink:
    """A link: ``anchor`` [3] is the place of its frame in that of the base, ``visuals`` are shapes with the name of
    their material."""

    name: str
    anchor: np.ndarray
    inertia: Inertia
    shapes: tuple[Shape, ...]
    visuals: tuple[tuple[Shape, str], ...]
    joint: Joint | None = None


@dataclass(frozen=True)
class Articulation:
    """A base link, first, and what hangs on it; ``files`` are its meshes by name, ``looks`` its materials by name."""

    name: str
    links: tuple[ArticulatedLink, ...]
    friction: float
    looks: Mapping[str, Material]
    files: Mapping[str, bytes]


def articulation_of(thing: Thing, look: Body, bodies: Sequence[RigidBody], name: str, prefix: str = "") -> Articulation:
    """Some bodies of a thing: the first is the base, the others have joints; ``prefix`` begins the names of files."""
    scale = np.asarray(thing.scale)
    names = legal_names([BASE, *(b.link.name for b in bodies[1:] if b.link is not None)])
    meshes, links = _Meshes(look.mesh, scale, prefix), []
    face_body = thing.face_body if thing.asset is not None else look.mesh.face_link
    for body, own in zip(bodies, names, strict=True):
        anchor, joint = np.zeros(3), None
        if body is not bodies[0]:
            assert body.link is not None
            anchor = np.asarray(body.link.anchor) * scale
            axis, limits, hold = joint_of(body.link, thing.scale, body.mass)
            joint = Joint("prismatic" if body.link.joint == "slide" else "revolute", axis, limits, hold)
        volume = sum(solid.volume for solid in body.solids)
        inertia = inertia_of(body.solids, [body.mass * solid.volume / volume for solid in body.solids])
        inertia = replace(inertia, centre=inertia.centre - anchor)
        shapes = meshes.shapes(own, body.solids, anchor)
        visuals = meshes.visuals(own, face_body == body.number, anchor)
        links.append(ArticulatedLink(own, anchor, inertia, shapes, visuals, joint))
    return Articulation(name, tuple(links), thing.friction, meshes.looks, meshes.files)


def legal_names(names: Sequence[str]) -> list[str]:
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


def material_library(looks: Mapping[str, Material]) -> bytes:
    """The Wavefront MTL file of materials by name."""
    lines = []
    for name, m in looks.items():
        shine = text(np.asarray(m.color) * min(1.0, m.emission))
        lines += [f"newmtl {name}", f"Kd {text(m.color)}", f"Ke {shine}", f"d {text(m.opacity)}"]
        lines += [f"Pr {text(m.roughness)}", f"Pm {text(m.metallic)}", "illum 2", ""]
    return "\n".join(lines).encode()


def obj(points: np.ndarray, faces: np.ndarray, library: str = "", material: str = "") -> bytes:
    """A Wavefront OBJ file of triangles, with a material of a library where one is named."""
    lines = [f"mtllib {library}"] if library else []
    lines += [f"v {text(point)}" for point in points.tolist()]
    lines += [f"usemtl {material}"] if library else []
    lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    return ("\n".join(lines) + "\n").encode()


class _Meshes:
    """The mesh files of an articulation: one for each link and material, as most readers take one colour a mesh."""

    def __init__(self, mesh: Mesh, scale: np.ndarray, prefix: str):
        self._mesh, self._scale, self._prefix = mesh, scale, prefix
        used = np.unique(mesh.face_material).tolist()
        self._names = dict(zip(used, legal_names([mesh.materials[k].name for k in used]), strict=True))
        self._library = f"{prefix}materials.mtl"
        self.looks = {name: mesh.materials[k] for k, name in self._names.items()}
        self.files = {self._library: material_library(self.looks)}

    def visuals(self, link: str, chosen: np.ndarray, anchor: np.ndarray) -> tuple[tuple[Shape, str], ...]:
        """What is seen of a link: the faces [F] that are ``chosen``."""
        found = []
        for number, look in self._names.items():
            faces = self._mesh.faces[chosen & (self._mesh.face_material == number)]
            if not len(faces):
                continue
            kept, packed = np.unique(faces, return_inverse=True)
            points = self._mesh.vertices[kept] * self._scale - anchor
            file = f"{self._prefix}{link}-{look}.obj"
            self.files[file] = obj(points, packed.reshape(-1, 3), self._library, look)
            found.append((Shape(file=file), look))
        return tuple(found)

    def shapes(self, link: str, solids: Sequence[Solid], anchor: np.ndarray) -> tuple[Shape, ...]:
        """The collision parts of a link."""
        found = []
        for k, solid in enumerate(solids):
            at = solid.points - anchor
            if solid.box is not None:
                centre, half = (np.asarray(v, dtype=float) for v in solid.box)
                found.append(Shape(2 * half, centre - anchor, points=at))
                continue
            file = f"{self._prefix}{link}-part-{k}.obj"
            corners = triangles(solid.points)[1].reshape(-1, 3)
            points, packed = np.unique(corners, axis=0, return_inverse=True)
            self.files[file] = obj(points - anchor, packed.reshape(-1, 3))
            found.append(Shape(file=file, points=at))
        return tuple(found)
