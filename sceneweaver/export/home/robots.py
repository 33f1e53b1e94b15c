"""Homes as one SDF world, and as a list of URDF robots: ``home``, which is all that is around things, and the things.

As in the files of one room, every object is a model or robot of its own, and so is what can be taken off it; pieces
that are there twice share their files, in whichever rooms they stand.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.home import Home
from sceneweaver.physics.enclosure import Standing
from sceneweaver.physics.shell import Slab

from ..articulations import OURS, PlacedArticulation, building, legal_names, placed_things, standing_still
from ..folder import write_beside
from ..sdf import FOLDER as SDF_FOLDER
from ..sdf import world_sdf
from ..urdf import FOLDER as URDF_FOLDER
from ..urdf import robots
from .built import BuiltHome
from .meshes import by_material

_DEEP, _AROUND = 0.5, 1.0
"""Of the ground [m]: nothing falls through it in one step; and how far it goes on outside."""


def write_sdf(home: Home, path: Path, load: Load, *, textures: bool = True, client: str | None = None) -> None:
    """As `formats.export_home` calls it; meshes have plain colours."""
    files = world_sdf(home.id, home_articulations(BuiltHome.of(home, load)), client == "pybullet")
    files[path.name] = files.pop("scene.sdf")
    write_beside(path, files, {SDF_FOLDER: OURS})


def write_urdf(home: Home, path: Path, load: Load, *, textures: bool = True) -> None:
    """As `formats.export_home` calls it; meshes have plain colours."""
    files = robots(home.id, home_articulations(BuiltHome.of(home, load)))
    files[path.name] = files.pop("scene.urdf.json")
    write_beside(path, files, {URDF_FOLDER: OURS})


def home_articulations(built: BuiltHome) -> list[PlacedArticulation]:
    """All that is around things, then the things of all rooms; see `placed_articulations`."""
    low, high = built.corners
    least, most = low[:2] - _AROUND, high[:2] + _AROUND
    ground = Slab(np.array([*(least + most) / 2, low[2] - _DEEP / 2]), np.array([*(most - least) / 2, _DEEP / 2]))
    model = building("home", [ground], _pieces(built), [leaf for leaves in built.leaves for leaf in leaves])
    return [standing_still("home", model), *placed_things(built.things)]


def _pieces(built: BuiltHome) -> Iterator[tuple[dict[str, Mesh], Standing | None]]:
    """What is seen, a mesh of each material, and what it collides as. Windows are seen as meshes, not as panes."""
    seen = [(part.name, mesh) for part in built.parts if part.kind != "ceiling" for mesh in by_material(part.mesh)]
    yield dict(zip(legal_names([name for name, _ in seen]), (mesh for _, mesh in seen), strict=True)), None
    for body in built.standing:
        slabs = tuple(Slab(s.centre, s.half, points=s.points) for s in body.slabs)
        yield {}, Standing(body.name, slabs, body.position, body.yaw)
