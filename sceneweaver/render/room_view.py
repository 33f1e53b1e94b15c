"""Pictures of whole rooms: from above a corner, with the walls in the way cut off, and from straight above."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from PIL import Image

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.messages import suggest

from .camera import Camera
from .caster import Instance, Lighting, Quality, cast
from .room_bodies import hidden_with, instances_of
from .room_camera import corner_camera, corner_directions, cut_walls, opposite
from .room_finish import finishes_of
from .room_shell import SLAB, build_shell

ROOM_VIEWS = ("corner", "corner2", "top", "top_annotated")


def draw_room(
    scene: Scene, load: Callable[[str], Asset] | None = None, view: str = "corner", width: int = 1280,
    height: int = 960, quality: Quality | None = None, device: str = "cpu",
) -> Image.Image:  # fmt: skip
    """One picture of a furnished room.

    Args:
        scene: The scene.
        load: Gives the asset of an id; None: ``Library().load``.
        view: One of ``ROOM_VIEWS``: "corner" is the corner that shows most, "corner2" the one across.
        width: Width of the picture in pixels.
        height: Its height; pictures from above are as high as the room asks.
        quality: How carefully it is drawn.
        device: Where it is drawn: "cpu" or "cuda:0".

    Raises:
        InputError: for a view that is unknown, an asset that cannot be loaded, or a finish that nobody knows.
    """
    return draw_rooms(scene, load, (view,), width, height, quality, device)[view]


def draw_rooms(
    scene: Scene, load: Callable[[str], Asset] | None = None, views: Sequence[str] = ("corner", "top"),
    width: int = 1280, height: int = 960, quality: Quality | None = None, device: str = "cpu",
) -> dict[str, Image.Image]:  # fmt: skip
    """Several pictures of one room, by view; see ``draw_room``."""
    for view in views:
        if view not in ROOM_VIEWS:
            raise InputError(f"view: '{view}' is unknown{suggest(view, ROOM_VIEWS)}; use one of {', '.join(ROOM_VIEWS)}")
    things = instances_of(scene, load)
    done: dict[str, Image.Image] = {}
    for view in views:
        if view.startswith("corner"):
            done[view] = _corner(scene, things, view == "corner2", width, height, quality, device)
        else:
            if "top" not in done:
                done["top"] = _top(scene, things, width, height, quality, device)
            if view == "top_annotated":
                done[view] = done["top"]
    return {view: done[view] for view in views}


def _corner(
    scene: Scene, things: list[Instance], across: bool, width: int, height: int, quality: Quality | None, device: str
) -> Image.Image:
    ways = corner_directions(scene)
    way = opposite(ways) if across else ways[0]
    cut = cut_walls(scene, way)
    gone = hidden_with(scene, cut)
    shell = build_shell(scene.room, finishes_of(scene), cut)
    camera = corner_camera(scene, way, cut, width / height)
    shown = [one for one, thing in zip(things, scene.objects, strict=True) if thing.id not in gone]
    left = np.array([-way[1], way[0]])
    sun = 0.75 * way + 0.55 * left
    lighting = Lighting(sun=(float(sun[0]), float(sun[1]), 1.0), softness=0.06)
    eye = np.eye(4)
    solids = [Instance(mesh, eye) for mesh in (shell.floor, *shell.walls, _ground()) if mesh is not None]
    return Image.fromarray(
        cast([*shown, *solids], camera, width, height, lighting=lighting, quality=quality, device=device).rgb
    )


def _top(
    scene: Scene, things: list[Instance], width: int, height: int, quality: Quality | None, device: str
) -> Image.Image:
    finishes = finishes_of(scene, cut=(0.30, 0.29, 0.28))
    shell = build_shell(scene.room, finishes)
    shown = [one for one, thing in zip(things, scene.objects, strict=True) if thing.mount != "ceiling"]
    low, high = shell.outer.min(axis=0) - 0.15, shell.outer.max(axis=0) + 0.15
    middle, size = (low + high) / 2, high - low
    span = max(size[1], size[0] * height / width)
    camera = Camera.orthographic((*middle, scene.room.height + 5.0), (*middle, 0.0), span, width / height)
    lighting = Lighting(sun=(-0.45, 0.6, 1.3), softness=0.08)
    eye = np.eye(4)
    solids = [Instance(mesh, eye) for mesh in (shell.floor, *shell.walls, _ground()) if mesh is not None]
    return Image.fromarray(
        cast([*shown, *solids], camera, width, height, lighting=lighting, quality=quality, device=device).rgb
    )


def _ground() -> Mesh:
    """An endless pale ground under the slab."""
    r, z = 500.0, -SLAB - 0.001
    corners = np.array([(-r, -r, z), (r, -r, z), (r, r, z), (-r, r, z)])
    zeros = np.zeros(2, dtype=np.int32)
    look = Material("ground", (0.80, 0.79, 0.775), roughness=1.0)
    return Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), zeros, zeros, (look,))
