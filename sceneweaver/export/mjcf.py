"""Scenes as an MJCF folder that plain MuJoCo loads from any place: ``scene.xml``, ``meshes/`` and ``textures/``.

Bodies have the names of their objects. Geoms of group 2 are what is seen, those of group 3 what collides.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.assets.placed import Load
from sceneweaver.assets.room_looks import room_looks, wall_look
from sceneweaver.assets.textures import maps
from sceneweaver.assets.textures.relief import to_srgb
from sceneweaver.geometry.hulls import hull_mesh
from sceneweaver.physics import Model, build
from sceneweaver.physics.model import ROOM, UNSET, mesh_stem
from sceneweaver.physics.things import RigidBody, Thing
from sceneweaver.physics.xml import child
from sceneweaver.scene import Room, Scene

from .corners import indexed, texture_coordinates
from .folder import write_folder
from .images import file_stem, linear, png, tinted
from .mjcf_clients import CLIENTS, sleeping_twin

_PIXELS = 256
"""Side of the images: simulators show them small, and PNG is large."""

_MARGIN = 2e-5
"""Distance [m] at which parts touch: at none, stacked hulls lose contacts in MuJoCo 3.3, and creep."""


def write_mjcf(
    scene: Scene, folder: str | os.PathLike[str], load: Load | None = None, *, textures: bool = True
) -> Path:
    """Write the folder whole: under a temporary name beside it, then renamed; an older export there is replaced.

    Args:
        scene: The scene.
        folder: Where it goes; its parent must be there.
        load: From asset id to asset; None: the library of this user.
        textures: Whether materials have their colour maps, as PNG.

    Returns:
        The path of ``scene.xml``. ``scene-sleep.xml`` is the same for MuJoCo 3.4 and newer, quicker: what is at rest
        sleeps.

    Raises:
        InputError: an asset is missing, the place cannot be written, or holds something that is no MJCF export.
    """
    target = Path(folder)
    model = mjcf(scene, load, textures=textures)
    twin = {"scene-sleep.xml": sleeping_twin("scene.xml", scene.id)}
    files = {"scene.xml": model.xml.encode(), **twin, **model.files}
    write_folder(target, files, lambda names: names <= {"scene.xml", *twin, "meshes", "textures"})
    return target / "scene.xml"


def mjcf(scene: Scene, load: Load | None = None, *, textures: bool = True, client: str | None = None) -> Model:
    """The scene as MJCF with what is seen: the text, and the files that it names, by path relative to it.

    ``client`` is one of ``CLIENTS``; None: the file that most readers take.
    """
    wardrobe = _Wardrobe(textures)
    model = build(scene, load, wardrobe)
    root = Xml.fromstring(model.xml)
    wardrobe.paper(root, scene.room)
    _without_slashes(root)
    for geom in root.iterfind("default/default/geom[@group='3']"):
        geom.set("margin", str(_MARGIN))
    files = {**wardrobe.files, **_hulls_as_files(root)}
    if client is not None:
        CLIENTS[client](root)
    Xml.indent(root, " ")
    return replace(model, xml=Xml.tostring(root, encoding="unicode") + "\n", files=files)


def _hulls_as_files(root: Xml.Element) -> dict[str, bytes]:
    """Moves the vertices of hulls to files, as some readers take no others; returns these by path."""
    files = {}
    for mesh in root.iterfind("asset/mesh[@vertex]"):
        points = np.array(mesh.attrib.pop("vertex").split(), dtype=float).reshape(-1, 3)
        name = f"meshes/{mesh.get('name')}.obj"
        files[name] = _obj(*hull_mesh(points), None)
        mesh.set("file", name)
    return files


def _without_slashes(root: Xml.Element) -> None:
    """Names without "/", which other readers keep for themselves; no two of one kind alike."""
    renamed: dict[str, str] = {}
    taken = {value for element in root.iter() if "/" not in (value := element.get("name", ""))}
    for element in root.iter():
        for key in ("name", "body1", "body2", "mesh", "material", "texture"):
            old = element.get(key, "")
            if "/" not in old:
                continue
            if old not in renamed:
                new = stem = old.replace("/", "-")
                number = 1
                while new in taken:
                    new, number = f"{stem}-{number}", number + 1
                taken.add(new)
                renamed[old] = new
            element.set(key, renamed[old])


class _Wardrobe:
    """Gives bodies their looks; meshes and materials are there once, however many use them."""

    def __init__(self, textured: bool) -> None:
        self._textured = textured
        self._textures: set[str] = set()
        self.files: dict[str, bytes] = {}
        self._materials: dict[Material, str] = {}
        self._made: dict[tuple[str, int], list[tuple[str, Material]]] = {}

    def __call__(self, assets: Xml.Element, body: Xml.Element, thing: Thing, own: RigidBody) -> None:
        if thing.asset is None:
            return  # its collision parts are all there is to see
        key = (thing.key, own.number)
        if key not in self._made:
            self._made[key] = self._add(assets, thing, own.number)
        for k, (name, material) in enumerate(self._made[key]):
            look = self._material(assets, material)
            seen = {"name": f"{own.name}:visual:{k}", "class": f"{ROOM}:visual"}
            child(body, "geom", seen, mesh=name, material=look)

    def paper(self, root: Xml.Element, room: Room) -> None:
        """Give floor and walls the looks of the room; the floor's image repeats at its real size."""
        floor, assets = root.find(".//geom[@name='room:floor']"), root.find("asset")
        assert floor is not None and assets is not None
        look = room_looks(room).floor
        found = maps(look.texture) if self._textured else None
        if found is not None:
            floor.set("rgba", UNSET)
            u, v = found.size
            repeat = {"texuniform": "true", "texrepeat": f"{1 / u:.6g} {1 / v:.6g}"}
            floor.set("material", self._material(assets, look, repeat))
        else:
            floor.set("rgba", " ".join(f"{c:.4g}" for c in (*look.color, 1)))
        for k in range(len(room.outline)):
            for geom in root.iterfind(f".//body[@name='room:wall:{k}']/geom"):
                if geom.get("rgba", "").endswith(" 1"):  # not a pane
                    geom.set("rgba", " ".join(f"{c:.4g}" for c in (*wall_look(room, k).color, 1)))

    def _add(self, assets: Xml.Element, thing: Thing, link: int) -> list[tuple[str, Material]]:
        """One mesh for each material of a link."""
        assert thing.asset is not None
        mesh, found = thing.asset.mesh, []
        face_body = thing.face_body
        uv = texture_coordinates(mesh) if self._textured else None
        stem = f"{mesh_stem(thing)}-{link}"
        for number in np.unique(mesh.face_material[face_body == link]):
            chosen = (face_body == link) & (mesh.face_material == number)
            material = mesh.materials[int(number)]
            used, packed = np.unique(mesh.faces[chosen], return_inverse=True)
            places = None if uv is None or maps(material.texture) is None else indexed(uv[chosen])
            name = f"{stem}-{number}"
            points = mesh.vertices[used] * np.asarray(thing.scale)
            self.files[f"meshes/{name}.obj"] = _obj(points, packed.reshape(-1, 3), places)
            # Sheets and open pieces enclose no volume; as shells they have a frame all the same.
            child(assets, "mesh", name=name, file=f"meshes/{name}.obj", inertia="shell")
            found.append((name, material))
        return found

    def _material(self, assets: Xml.Element, material: Material, more: Mapping[str, str] | None = None) -> str:
        if material not in self._materials:
            name = f"{material.name} {len(self._materials)}"
            tint, look = self._texture(assets, material)
            color = " ".join(f"{c:.4g}" for c in (*tint, material.opacity))
            child(
                assets,
                "material",
                {**look, **(more or {})},
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

    def _texture(self, assets: Xml.Element, material: Material) -> tuple[Sequence[float], dict[str, str]]:
        """The sRGB colour with which the image of a material is multiplied, and which image that is."""
        found = maps(material.texture) if self._textured else None
        if found is None:
            return material.color, {}
        name = file_stem(material.texture)
        if name not in self._textures:
            self._textures.add(name)
            self.files[f"textures/{name}.png"] = png(found.tint, _PIXELS)
            child(assets, "texture", name=name, type="2d", file=f"textures/{name}.png")
        color, _ = tinted(material, linear(material.color))
        return to_srgb(np.array(color)).tolist(), {"texture": name}


def _obj(points: np.ndarray, faces: np.ndarray, places: tuple[np.ndarray, np.ndarray] | None) -> bytes:
    """Wavefront OBJ of triangles, with texture coordinates [N, 2] and which of them each corner has."""
    lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in points.tolist()]
    if places is None:
        lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
        return ("\n".join(lines) + "\n").encode()
    lines += [f"vt {u:.5g} {v:.5g}" for u, v in places[0].tolist()]
    corners = zip((faces + 1).tolist(), (places[1].reshape(-1, 3) + 1).tolist(), strict=True)
    lines += [f"f {a}/{i} {b}/{j} {c}/{k}" for (a, b, c), (i, j, k) in corners]
    return ("\n".join(lines) + "\n").encode()
