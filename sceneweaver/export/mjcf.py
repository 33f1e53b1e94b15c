"""Scenes as an MJCF folder that plain MuJoCo loads from any place: ``scene.xml``, ``meshes/`` and ``textures/``.

Bodies have the names of their objects. Geoms of group 2 are what is seen, those of group 3 what collides.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import replace
from functools import partial
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
from sceneweaver.physics.hulls import Solid
from sceneweaver.physics.model import ROOM, UNSET, mesh_stem
from sceneweaver.physics.things import RigidBody, Thing
from sceneweaver.physics.xml import child
from sceneweaver.scene import Room, Scene

from .corners import indexed, texture_coordinates
from .folder import write_folder
from .images import file_stem, linear, png, tinted
from .mjcf_clients import CLIENTS, sleeping_twin
from .shared import SharedFiles

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


def mjcf(
    scene: Scene,
    load: Load | None = None,
    *,
    textures: bool = True,
    client: str | None = None,
    shared: SharedFiles | None = None,
) -> Model:
    """The scene as MJCF with what is seen: the text, and the files that it names, by path relative to it.

    Args:
        scene: The scene.
        load: From asset id to asset; None: the library of this user.
        textures: Whether materials have their colour maps, as PNG.
        client: One of ``CLIENTS``; None: the file that most readers take.
        shared: Where meshes and images go, as files that the text names; None: into ``files``.
    """
    wardrobe = _Wardrobe(textures, shared)

    def amend(root: Xml.Element) -> None:
        wardrobe.paper(root, scene.room)
        _without_slashes(root)
        for geom in root.iterfind("default/default/geom[@group='3']"):
            geom.set("margin", str(_MARGIN))
        if client is not None:
            CLIENTS[client](root)

    return replace(build(scene, load, wardrobe, shape=wardrobe.shape, amend=amend), files=wardrobe.files)


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

    def __init__(self, textured: bool, shared: SharedFiles | None) -> None:
        self._textured, self._shared = textured, shared
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

    def shape(self, name: str, thing: Thing, solid: Solid) -> dict[str, str]:
        """The hull of a collision part as a file, as some readers take no vertices."""
        if self._shared is not None:
            return {"file": self._shared.hull(thing.object.asset, solid, partial(_hull, solid))}
        return {"file": self._file(f"meshes/{name}.obj", None, partial(_hull, solid))}

    def _file(self, name: str, key: Hashable, make: Callable[[], bytes], asset: str | None = None) -> str:
        """The path of a file of that name, or of a shared one of that key."""
        if self._shared is not None:
            return self._shared.path(key, name.rpartition(".")[2], make, asset)
        self.files[name] = make()
        return name

    def _add(self, assets: Xml.Element, thing: Thing, link: int) -> list[tuple[str, Material]]:
        """One mesh for each material of a link."""
        assert thing.asset is not None
        mesh, face_body = thing.asset.mesh, thing.face_body
        found = []
        for number in np.unique(mesh.face_material[face_body == link]).tolist():
            name = f"{mesh_stem(thing)}-{link}-{number}"
            key = ("mjcf", thing.key, thing.welded, link, number, self._textured)
            file = self._file(f"meshes/{name}.obj", key, partial(self._seen, thing, link, number), thing.object.asset)
            # Sheets and open pieces enclose no volume; as shells they have a frame all the same.
            child(assets, "mesh", name=name, file=file, inertia="shell")
            found.append((name, mesh.materials[number]))
        return found

    def _seen(self, thing: Thing, link: int, number: int) -> bytes:
        """The faces of a link that are of one material, as a file."""
        assert thing.asset is not None
        mesh = thing.asset.mesh
        chosen = (thing.face_body == link) & (mesh.face_material == number)
        used, packed = np.unique(mesh.faces[chosen], return_inverse=True)
        places = None
        if self._textured and maps(mesh.materials[number].texture) is not None:
            uv = texture_coordinates(mesh)
            places = None if uv is None else indexed(uv[chosen])
        return _obj(mesh.vertices[used] * np.asarray(thing.scale), packed.reshape(-1, 3), places)

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
            file = self._file(f"textures/{name}.png", name, lambda: png(found.tint, _PIXELS))
            child(assets, "texture", name=name, type="2d", file=file)
        color, _ = tinted(material, linear(material.color))
        return to_srgb(np.array(color)).tolist(), {"texture": name}


def _hull(solid: Solid) -> bytes:
    return _obj(*hull_mesh(solid.points), None)


def _obj(points: np.ndarray, faces: np.ndarray, places: tuple[np.ndarray, np.ndarray] | None) -> bytes:
    """Wavefront OBJ of triangles, with texture coordinates [N, 2] and which of them each corner has."""
    text = _lines("v %.6g %.6g %.6g\n", points)
    if places is None:
        return (text + _lines("f %d %d %d\n", faces + 1)).encode()
    corners = np.stack([faces, places[1].reshape(-1, 3)], axis=2) + 1
    return (text + _lines("vt %.5g %.5g\n", places[0]) + _lines("f %d/%d %d/%d %d/%d\n", corners)).encode()


def _lines(line: str, values: np.ndarray) -> str:
    """A line for each row of an array."""
    return line * len(values) % tuple(values.reshape(-1).tolist())
