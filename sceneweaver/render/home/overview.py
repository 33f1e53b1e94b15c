"""A storey from above without its roof, all walls cut at one height: a doll's house."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import shapely
from PIL import Image

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.home import Home, HomeDoor, wall_polygons
from sceneweaver.scene import Scene

from ..blocks import Finishes, finishes_of
from ..camera import Camera
from ..instances import Instance, hidden_with, instances_of
from ..tracing import Lights, Quality, trace
from ..views import faded
from . import shell

CUT = 1.5
"""Height [m] at which the walls are cut: through most windows, over most furniture."""

_PITCH, _TURN, _FOV = math.radians(58.0), math.radians(16.0), 0.36
_CUT_COLOR = (0.30, 0.29, 0.28)
_GROUND = Material("ground", (0.79, 0.778, 0.757), roughness=1.0)
_AJAR = 1.35  # how far leaves stand open [rad]
_OVER = 0.12  # how far something on a wall may stand over the cut [m]


def draw_overview(
    home: Home,
    storey: str,
    load: Callable[[str], Asset] | None = None,
    width: int = 1280,
    height: int = 960,
    quality: Quality | None = None,
    device: str = "cpu",
) -> Image.Image:
    """The picture of a storey; see `sceneweaver.render.home.render_home`."""
    meshes = [*(mesh for _, mesh in open_storey(home, storey)), shell.ground_mesh(home, storey, _GROUND)]
    solids = [Instance(mesh, np.eye(4)) for mesh in meshes if mesh is not None]
    things = furniture(home, storey, load)
    camera = overview_camera(home, storey, width / height)
    x0, y0, x1, y1 = _bounds(home, storey)
    low = shell.lowest(home, storey)
    light = replace(_LIGHT, room=((x0 - 0.5, y0 - 0.5, low), (x1 + 0.5, y1 + 0.5, 2.6)))
    drawn = trace([*things, *solids], camera, width, height, lights=light, quality=quality, device=device)
    return Image.fromarray(faded(drawn.rgb))


_LIGHT = Lights(
    sun=(-0.45, -0.5, 1.25),
    softness=0.05,
    sun_color=(1.9, 1.72, 1.45),
    zenith=(1.0, 1.05, 1.12),
    horizon=(1.0, 1.0, 1.0),
    ground=(0.6, 0.58, 0.55),
    adapted=0.9,
    lamp_flux=0.25,
)


def furniture(home: Home, storey: str, load: Callable[[str], Asset] | None) -> list[Instance]:
    """What stands in the rooms of a storey, without what hangs from ceilings or stands over the cut of the walls."""
    found = []
    for room in home.rooms_of(storey):
        if room.scene is not None:
            gone = hidden_when_cut(room.scene)
            things = zip(room.scene.objects, instances_of(room.scene, load), strict=True)
            found += [instance for thing, instance in things if thing.id not in gone]
    return found


def hidden_when_cut(scene: Scene) -> set[str]:
    """Ids of the objects that hang from the ceiling or over the cut of the walls, and of what stands on these."""
    return hidden_with(scene, (), CUT + _OVER)


def overview_camera(home: Home, storey: str, aspect: float) -> Camera:
    """A camera in the south, a little aslant, that holds the storey: north is up, as in a plan."""
    x0, y0, x1, y1 = _bounds(home, storey)
    points = np.array([(x, y, z) for x in (x0, x1) for y in (y0, y1) for z in (-0.1, CUT)])
    flat = np.array([math.sin(_TURN), math.cos(_TURN)])
    forward = np.array([*(flat * math.cos(_PITCH)), -math.sin(_PITCH)])
    return Camera.holding(points, forward, fov=_FOV, aspect=aspect, margin=1.05)


def _bounds(home: Home, storey: str) -> tuple[float, float, float, float]:
    """The least and greatest x and y of a storey with its walls [m]: x, y, x, y."""
    shapes = [*wall_polygons(home, storey), *(shapely.Polygon(room.outline) for room in home.rooms_of(storey))]
    return shapely.union_all(shapes).bounds


def open_storey(home: Home, storey: str, cut: float = CUT) -> list[tuple[str, Mesh]]:
    """A storey without ceilings, its walls cut at a height [m]: meshes with what they are, floor or wall.

    Heights are counted from the floor of the storey, as in the scenes of its rooms.
    """
    looks: dict[str, Finishes] = {
        room.id: finishes_of(shell.scene_of(home, room), cut=_CUT_COLOR) for room in home.rooms_of(storey)
    }
    framed = {room: replace(look, metal=shell.LEDGE) for room, look in looks.items()}

    def ajar(door: HomeDoor) -> float:
        return 0.0 if door.to is None else _AJAR

    low = cut - 0.002  # frames do not end in the plane of the walls' cut
    found: list[tuple[str, Mesh | None]] = [("wall", shell.walls_mesh(home, storey, looks, cut))]
    found += [("floor", mesh) for mesh in shell.floors_of(home, storey, looks)]
    found += [("wall", mesh) for _, mesh in shell.doors_of(home, storey, looks, ajar, low)]
    found += [("wall", mesh) for _, mesh in shell.windows_of(home, storey, framed, top=low)]
    found += [("floor", shell.stairs_mesh(home, storey, cut)), ("wall", shell.railings_mesh(home, storey))]
    return [(kind, mesh) for kind, mesh in found if mesh is not None]
