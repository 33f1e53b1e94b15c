"""Scenes as an MJCF folder that plain MuJoCo loads from any place: ``scene.xml``, ``meshes/`` and ``textures/``.

Bodies have the names of their objects. Geoms of group 2 are what is seen, those of group 3 what collides.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
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
from sceneweaver.physics.model import ROOM, UNSET, Plain, hull_name
from sceneweaver.physics.things import RigidBody, Thing
from sceneweaver.physics.xml import child
from sceneweaver.scene import Room, Scene

from .corners import laid_by
from .folder import write_beside, write_folder
from .images import file_stem, linear, png, tinted
from .mjcf_clients import CLIENTS, sleeping_twin
from .mjcf_meshes import Seen, mesh_elements, seen_obj, seen_of
from .obj import obj
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


def write_file(scene: Scene, path: Path, load: Load, *, textures: bool = True, client: str | None = None) -> None:
    """As `formats.Format.write` calls it: the text with ``meshes/`` and ``textures/`` beside it, and its sleeping twin,
    which the file for all has."""
    write_model(mjcf(scene, load, textures=textures, client=client), path, scene.id, client)


def write_model(model: Model, path: Path, name: str, client: str | None = None) -> None:
    """Write the text of a model of that name and what it names; the file for all has a sleeping twin."""
    twin = {f"{path.stem}-sleep.xml": sleeping_twin(path.name, name)} if client is None else {}
    write_beside(path, {**model.files, **twin, path.name: model.xml.encode()}, {"meshes": r"[^/]*\.obj"})


def mjcf_bytes(scene: Scene, load: Load, *, shared: SharedFiles) -> bytes:
    """The text of a scene whose meshes and images are shared files."""
    return mjcf(scene, load, shared=shared).xml.encode()


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
        client: One of those of the format; None: the file that most readers take.
        shared: Where meshes and images go, as files that the text names; None: into ``files``.
    """
    looks = _RoomLooks(scene.room, textures, client, shared)
    return with_files(build(scene, load, looks), looks)


def with_files(model: Model, looks: Looks) -> Model:
    """A model with the files of its looks."""
    return replace(model, files=looks.files)


def _without_slashes(root: Xml.Element) -> None:
    """Names without "/", which other readers keep for themselves; no two of one kind alike."""
    renamed: dict[str, str] = {}
    elements = [element.attrib for element in root.iter()]
    names = [given["name"] for given in elements if "name" in given]
    taken = {name for name in names if "/" not in name}
    if len(taken) == len(names):
        return
    for given in elements:
        for key in ("name", "body1", "body2", "mesh", "material", "texture"):
            old = given.get(key, "")
            if "/" not in old:
                continue
            if old not in renamed:
                new = stem = old.replace("/", "-")
                number = 1
                while new in taken:
                    new, number = f"{stem}-{number}", number + 1
                taken.add(new)
                renamed[old] = new
            given[key] = renamed[old]


class Looks(Plain):
    """Gives bodies their looks; meshes and materials are there once, however many use them."""

    visible = True

    def __init__(self, textured: bool, client: str | None, shared: SharedFiles | None = None) -> None:
        self._textured, self._client, self._shared = textured, client, shared
        self._textures: set[str] = set()
        self.files: dict[str, bytes] = {}
        self._materials: dict[Material, str] = {}
        self._made: dict[str, Mapping[int, list[Seen]]] = {}
        self._included: dict[str, str] = {}

    def finish(self, root: Xml.Element) -> None:
        """Looks of the surroundings, legal names, margins, and what one reader needs."""
        self.paper(root)
        _without_slashes(root)
        for geom in root.iterfind("default/default/geom[@group='3']"):
            geom.set("margin", str(_MARGIN))
        if self._client in CLIENTS:
            CLIENTS[self._client](root)

    def dress(self, assets: Xml.Element, frame: Xml.Element, thing: Thing, body: RigidBody) -> None:
        """Meshes of a body of a thing with an asset."""
        if thing.asset is None:
            return  # its collision parts are all there is to see
        if self._shared is not None:
            self._shared.uses(thing.asset.id, self._included[thing.shape])
        for k, (name, number) in enumerate(self._made[thing.shape].get(body.number, ())):
            look = self.material(assets, thing.asset.mesh.materials[number])
            seen = {"name": f"{body.name}:visual:{k}", "class": f"{ROOM}:visual"}
            child(frame, "geom", seen, mesh=name, material=look)

    def paper(self, root: Xml.Element) -> None:
        """Give what is around things its looks."""

    def shape(self, thing: Thing) -> str:
        """Equal for things with the same meshes: in two finishes, where their images have the same sizes."""
        if thing.asset is None or not self._textured:
            return thing.shape
        return f"{thing.shape}|{laid_by(thing.asset.mesh)}"

    def add_meshes(self, assets: Xml.Element, thing: Thing) -> None:
        """The meshes of a thing: one for each hull, and for each link and material that is seen."""
        if thing.asset is None and self._shared is not None:
            super().add_meshes(assets, thing)
            return
        if thing.asset is not None:
            self._made[thing.shape] = seen_of(thing)
        if self._shared is not None and thing.asset is not None:
            key = (thing.shape, thing.welded, self._textured)
            text = partial(mesh_elements, thing, self._textured)
            self._included[thing.shape] = self._shared.path(key, "xml", text)
            child(assets, "include", file=self._included[thing.shape])
            return
        for k, solid in enumerate(thing.solids):
            if solid.box is None:
                name = hull_name(thing, k)
                file = self.add_file(f"meshes/{name}.obj", obj(*hull_mesh(solid.points), digits=6))
                child(assets, "mesh", name=name, inertia="convex", file=file)
        for link, found in self._made.get(thing.shape, {}).items():
            for name, number in found:
                file = self.add_file(f"meshes/{name}.obj", seen_obj(thing, link, number, self._textured))
                # Sheets and open pieces enclose no volume; as shells they have a frame all the same.
                child(assets, "mesh", name=name, file=file, inertia="shell")

    def add_file(self, name: str, content: bytes) -> str:
        """Keep a file by its path; returns that."""
        self.files[name] = content
        return name

    def material(self, assets: Xml.Element, material: Material, more: Mapping[str, str] | None = None) -> str:
        """The name of the element of a material, which is made when it is first asked for."""
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
            image = partial(png, found.tint, _PIXELS)
            if self._shared is not None:
                file = self._shared.path(name, "png", image)
            else:
                file = self.add_file(f"textures/{name}.png", image())
            child(assets, "texture", name=name, type="2d", file=file)
        color, _ = tinted(material, linear(material.color))
        return to_srgb(np.array(color)).tolist(), {"texture": name}


class _RoomLooks(Looks):
    """Floor and walls have the looks of the room; the floor's image repeats at its real size."""

    def __init__(self, room: Room, textured: bool, client: str | None, shared: SharedFiles | None) -> None:
        super().__init__(textured, client, shared)
        self._room = room

    def paper(self, root: Xml.Element) -> None:
        floor, assets = root.find(".//geom[@name='room:floor']"), root.find("asset")
        assert floor is not None and assets is not None
        look = room_looks(self._room).floor
        found = maps(look.texture) if self._textured else None
        if found is not None:
            floor.set("rgba", UNSET)
            u, v = found.size
            repeat = {"texuniform": "true", "texrepeat": f"{1 / u:.6g} {1 / v:.6g}"}
            floor.set("material", self.material(assets, look, repeat))
        else:
            floor.set("rgba", " ".join(f"{c:.4g}" for c in (*look.color, 1)))
        for k in range(len(self._room.outline)):
            for geom in root.iterfind(f".//body[@name='room:wall:{k}']/geom"):
                if geom.get("rgba", "").endswith(" 1"):  # not a pane
                    geom.set("rgba", " ".join(f"{c:.4g}" for c in (*wall_look(self._room, k).color, 1)))
