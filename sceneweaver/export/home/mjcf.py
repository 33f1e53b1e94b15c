"""Homes as MJCF: one model with all rooms, as `sceneweaver.export.mjcf` writes one room.

Bodies are named ``<room>:<object>`` and ``<room>:<object>.<link>``, doors ``home:door:<id>``, and what stands still
``home:wall:<storey>:<k>`` and so on. Collision parts are of group 3, which viewers hide; what is seen of walls, floors,
stairs and windows are geoms of group 2 in the world. Ceilings collide and are not shown.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.assets.textures import maps
from sceneweaver.home import Home
from sceneweaver.physics import Model
from sceneweaver.physics.model import ROOM, assemble
from sceneweaver.physics.xml import child

from ..corners import indexed, texture_coordinates
from ..mjcf import Looks, with_files, write_model
from ..names import legal_name
from ..obj import obj
from ..shared import SharedFiles
from .built import BuiltHome
from .meshes import by_material


def write_file(home: Home, path: Path, load: Load, *, textures: bool = True, client: str | None = None) -> None:
    """As `formats.export_home` calls it."""
    write_model(home_mjcf(BuiltHome.of(home, load), textures=textures, client=client), path, home.id, client)


def home_mjcf_bytes(home: Home, load: Load, *, shared: SharedFiles) -> bytes:
    """The text of a home whose meshes and images are shared files."""
    return home_mjcf(BuiltHome.of(home, load), shared=shared).xml.encode()


def home_mjcf(
    built: BuiltHome, *, textures: bool = True, client: str | None = None, shared: SharedFiles | None = None
) -> Model:
    """The home as MJCF with what is seen; for the arguments see `sceneweaver.export.mjcf.mjcf`."""
    looks = _HomeLooks(built, textures, client, shared)
    return with_files(assemble(built.enclosure(), built.things, looks), looks)


class _HomeLooks(Looks):
    """Walls, floors, stairs and windows as meshes, one for each material of each."""

    def __init__(self, built: BuiltHome, textured: bool, client: str | None, shared: SharedFiles | None = None) -> None:
        super().__init__(textured, client, shared)
        self._built = built

    def paper(self, root: Xml.Element) -> None:
        name = self._built.names.home
        world, assets = root.find("worldbody"), root.find("asset")
        assert world is not None and assets is not None
        floor = world.find(f"geom[@name='{name}:floor']")
        assert floor is not None
        for geom in (floor, *(g for body in self._standing(world) for g in body.iterfind("geom"))):
            geom.set("group", "3")
        for part in self._built.parts:
            if part.kind == "ceiling":
                continue
            for k, mesh in enumerate(by_material(part.mesh)):
                stem = f"{legal_name(part.name)}-{k}"
                (material,) = mesh.materials
                places = None
                if self._textured and maps(material.texture) is not None:
                    uv = texture_coordinates(mesh)
                    places = None if uv is None else indexed(uv)
                content = obj(mesh.vertices, np.asarray(mesh.faces), places, digits=6)
                child(assets, "mesh", name=stem, file=self._file(f"meshes/{stem}.obj", content), inertia="shell")
                seen = {"name": f"{part.name}:visual:{k}", "class": f"{ROOM}:visual"}
                child(world, "geom", seen, mesh=stem, material=self.material(assets, material))

    def _file(self, name: str, content: str | bytes) -> str:
        """The path of a mesh of the home itself: one of its own, or a shared one, which is named by its content."""
        data = content.encode() if isinstance(content, str) else content
        if self._shared is None:
            return self.add_file(name, data)
        return self._shared.path(("home", hashlib.sha256(data).hexdigest()), "obj", lambda: data)

    def _standing(self, world: Xml.Element) -> list[Xml.Element]:
        names = {body.name for body in self._built.standing}
        return [body for body in world.iterfind("body") if body.get("name") in names]
