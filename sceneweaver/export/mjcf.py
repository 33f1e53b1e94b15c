"""Scenes as an MJCF folder that plain MuJoCo loads from any place: ``scene.xml`` and ``meshes/``.

Bodies have the names of their objects. Geoms of group 2 are what is seen, those of group 3 what collides.
"""

from __future__ import annotations

import os
import zlib
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.assets.placed import Load
from sceneweaver.physics import Model, build
from sceneweaver.physics.model import Thing
from sceneweaver.physics.xml import child
from sceneweaver.scene import Scene

from .folder import write_folder


def write_mjcf(scene: Scene, folder: str | os.PathLike[str], load: Load | None = None) -> Path:
    """Write the folder whole: under a temporary name beside it, then renamed; an older export there is replaced.

    Args:
        scene: The scene.
        folder: Where it goes; its parent must be there.
        load: From asset id to asset; None: the library of this user.

    Returns:
        The path of ``scene.xml``.

    Raises:
        InputError: an asset is missing, the place cannot be written, or holds something that is no MJCF export.
    """
    target = Path(folder)
    model = mjcf(scene, load)
    files = {"scene.xml": model.xml.encode(), **{f"meshes/{name}": data for name, data in model.files.items()}}
    write_folder(target, files, lambda names: names <= {"scene.xml", "meshes"})
    return target / "scene.xml"


def mjcf(scene: Scene, load: Load | None = None) -> Model:
    """The scene as MJCF with what is seen: the text, and the files of ``meshes/`` by name."""
    wardrobe = _Wardrobe()
    model = build(scene, load, wardrobe)
    return Model(model.xml, wardrobe.files, model.free, model.fixed)


class _Wardrobe:
    """Gives bodies their looks; meshes and materials are there once, however many use them."""

    def __init__(self) -> None:
        self.files: dict[str, bytes] = {}
        self._materials: dict[Material, str] = {}
        self._made: dict[tuple[str, int], list[tuple[str, Material]]] = {}

    def __call__(self, assets: Xml.Element, body: Xml.Element, thing: Thing, link: int) -> None:
        if thing.asset is None:
            return  # its collision parts are all there is to see
        if (thing.key, link) not in self._made:
            self._made[thing.key, link] = self._add(assets, thing, link)
        for name, material in self._made[thing.key, link]:
            look = self._material(assets, material)
            child(body, "geom", {"class": "visual"}, mesh=name, material=look)

    def _add(self, assets: Xml.Element, thing: Thing, link: int) -> list[tuple[str, Material]]:
        """One mesh for each material of a link."""
        assert thing.asset is not None
        mesh, found = thing.asset.mesh, []
        stem = f"{thing.asset.category}-{zlib.crc32(thing.key.encode()):08x}-{link}"
        for number in np.unique(mesh.face_material[mesh.face_link == link]):
            faces = mesh.faces[(mesh.face_link == link) & (mesh.face_material == number)]
            used, packed = np.unique(faces, return_inverse=True)
            name = f"{stem}-{number}"
            points = mesh.vertices[used] * np.asarray(thing.scale)
            self.files[f"{name}.obj"] = _obj(points, packed.reshape(-1, 3))
            # Sheets and open pieces enclose no volume; as shells they have a frame all the same.
            child(assets, "mesh", name=name, file=f"{name}.obj", inertia="shell")
            found.append((name, mesh.materials[int(number)]))
        return found

    def _material(self, assets: Xml.Element, material: Material) -> str:
        if material not in self._materials:
            name = f"{material.name} {len(self._materials)}"
            color = " ".join(f"{c:.4g}" for c in (*material.color, material.opacity))
            child(
                assets,
                "material",
                name=name,
                rgba=color,
                roughness=f"{material.roughness:.4g}",
                metallic=f"{material.metallic:.4g}",
                emission=f"{material.emission:.4g}",
                shininess=f"{1 - material.roughness:.4g}",
                specular=f"{0.5 * (1 - material.roughness):.4g}",
            )
            self._materials[material] = name
        return self._materials[material]


def _obj(points: np.ndarray, faces: np.ndarray) -> bytes:
    lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    return ("\n".join(lines) + "\n").encode()
