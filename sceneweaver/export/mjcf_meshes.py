"""Meshes of an MJCF file: what is seen of a thing and the hulls of its parts, as OBJ files or as elements."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from sceneweaver.assets.textures import maps
from sceneweaver.physics.model import hull_name, mesh_stem
from sceneweaver.physics.things import Thing

from .corners import first_of_each, indexed, texture_coordinates
from .obj import obj

Seen = tuple[str, int]
"""The name of a mesh, and the number of its material."""

Arrays = tuple[np.ndarray, np.ndarray, tuple[np.ndarray, np.ndarray] | None]
"""Points [V, 3], faces [F, 3], and texture coordinates [T, 2] with which of them each corner has [3 F]."""


def seen_of(thing: Thing) -> Mapping[int, list[Seen]]:
    """The meshes that are seen of a thing with an asset: one for each material, by the number of the body."""
    assert thing.asset is not None
    mesh, face_body = thing.asset.mesh, thing.face_body
    count, stem = len(mesh.materials), mesh_stem(thing)
    found: dict[int, list[Seen]] = {}
    for pair in np.flatnonzero(np.bincount(face_body * count + mesh.face_material)).tolist():
        link, number = divmod(pair, count)
        found.setdefault(link, []).append((f"{stem}-{link}-{number}", number))
    return found


def seen_obj(thing: Thing, link: int, number: int, textured: bool) -> bytes:
    """What is seen of a body in the material of a number as Wavefront OBJ."""
    return obj(*_arrays(thing, link, number, _coordinates(thing, textured)), digits=6)


def mesh_elements(thing: Thing, textured: bool) -> bytes:
    """All meshes of a thing as a file for ``include``: numbers in attributes, so that a thing is one file.

    What is seen is there to 0.01 mm and a ten thousandth of an image, as these files are most of a data set.
    """
    lines = ["<mujoco>"]
    for k, solid in enumerate(thing.solids):
        if solid.box is None:
            points = " ".join([f"{x:.6g}" for x in solid.points.reshape(-1).tolist()])
            lines.append(f'<mesh name="{hull_name(thing, k)}" inertia="convex" vertex="{points}"/>')
    uv = _coordinates(thing, textured)
    for link, found in seen_of(thing).items():
        for name, number in found:
            points, faces, places = _arrays(thing, link, number, uv)
            more = ""
            if places is not None:  # one number for both: a vertex for each different corner
                coordinates, index = places
                first, packed = first_of_each([faces.reshape(-1), index])
                points, faces = points[faces.reshape(-1)[first]], packed.reshape(-1, 3)
                at = coordinates[index[first]] * (1.0, -1.0) + (0.0, 1.0)  # here v grows downward
                more = f' texcoord="{decimals(at, 4)}"'
            indices = " ".join(map(str, faces.reshape(-1).tolist()))
            shape = f'vertex="{decimals(points, 5)}" face="{indices}"'
            lines.append(f'<mesh name="{name}" inertia="shell" {shape}{more}/>')
    return ("\n".join([*lines, "</mujoco>"]) + "\n").encode()


def _coordinates(thing: Thing, textured: bool) -> np.ndarray | None:
    """Of each corner of what is seen, as `texture_coordinates` has them, [F, 3, 2]."""
    return texture_coordinates(thing.asset.mesh) if textured and thing.asset is not None else None


def _arrays(thing: Thing, link: int, number: int, uv: np.ndarray | None) -> Arrays:
    assert thing.asset is not None
    mesh = thing.asset.mesh
    chosen = (thing.face_body == link) & (mesh.face_material == number)
    used, packed = np.unique(mesh.faces[chosen], return_inverse=True)
    mapped = maps(mesh.materials[number].texture) is not None
    places = indexed(uv[chosen]) if uv is not None and mapped else None
    return mesh.vertices[used] * np.asarray(thing.scale), packed.reshape(-1, 3), places


def decimals(values: np.ndarray, digits: int) -> str:
    """All numbers of an array with blanks between, each as short as it can be written: -.05 is -0.0500.

    Coordinates recur, so that each is made into text once.
    """
    steps, which = np.unique(np.rint(values.reshape(-1) * 10**digits).astype(np.int64), return_inverse=True)
    text = f"%.{digits}f " * len(steps) % tuple((steps / 10**digits).tolist())  # at once, as there are millions
    short = _FIRST_ZERO.sub("", _LAST_ZEROS.sub("", text)).split()
    return " ".join([short[k] for k in which.tolist()])


_LAST_ZEROS = re.compile(r"\.?0+(?= )")
_FIRST_ZERO = re.compile(r"(?<!\d)0(?=\.)")
