"""Pictures of whole rooms: at eye level, from above a corner with the walls in the way cut off, and from above."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from PIL import Image, ImageFilter

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError, Room, Scene

from .blocks import finishes_of
from .camera import Camera
from .instances import Instance, hidden_with, instances_of
from .interior import Element, build_interior
from .overlay import annotated
from .shapes import View
from .shell import Shell, build_shell
from .tracing import DirectLights, Quality, TracedPicture, Tracer, interior_lights, trace
from .tracing.lights import mood_of, most_glass, portals_of, slant_of
from .viewpoints import (
    EYE_VIEWS,
    cameras_and_hero,
    corner_camera,
    corner_directions,
    cut_walls,
    eye_cameras,
    opposite,
)

_CUT = 1.5  # height [m] at which pictures from above cut the walls: through most windows

_NARROWEST = 0.35  # of the longer side of a marked plan: its shorter one

ROOM_VIEWS = (*EYE_VIEWS, "corner", "corner2", "top", "top_annotated")


def draw_room(
    scene: Scene,
    load: Callable[[str], Asset] | None = None,
    view: str = "corner",
    width: int = 1280,
    height: int = 960,
    quality: Quality | None = None,
    device: str = "cpu",
) -> Image.Image:
    """One picture of a furnished room.

    Args:
        scene: The scene.
        load: Gives the asset of an id; None: ``Library().load``.
        view: One of ``ROOM_VIEWS``: "eye-door" at eye level from the door, "eye-corner" and "eye-corner2" from the two
            corners that show most; "corner" from above the corner that shows most, "corner2" the one across.
        width: Width of the picture in pixels.
        height: Its height; pictures from above are as high as the room asks.
        quality: How carefully it is drawn.
        device: Where it is drawn: "cpu" or "cuda:0".

    Raises:
        InputError: for a view that is unknown, an asset that cannot be loaded, or a finish that nobody knows.
    """
    return draw_rooms(scene, load, (view,), width, height, quality, device)[view]


def draw_rooms(
    scene: Scene,
    load: Callable[[str], Asset] | None = None,
    views: Sequence[str] = ("corner", "top"),
    width: int = 1280,
    height: int = 960,
    quality: Quality | None = None,
    device: str = "cpu",
) -> dict[str, Image.Image]:
    """Several pictures of one room, by view; see ``draw_room``."""
    for view in views:
        if view not in ROOM_VIEWS:
            known = ", ".join(ROOM_VIEWS)
            raise InputError(f"view: '{view}' is unknown{suggest(view, ROOM_VIEWS)}; use one of {known}")
    if width < 16 or height < 16:
        raise InputError(f"width, height: {width} x {height} pixels are too few for a room; use at least 16 x 16")
    quality = quality or Quality.normal()
    things = instances_of(scene, load)
    done: dict[str, Image.Image] = {}
    cameras = eye_cameras(scene, width / height) if set(views) & set(EYE_VIEWS) else {}
    inside: Inside | None = None
    for view in views:
        if view in cameras:
            inside = inside or Inside(scene, things, list(cameras.values()), device)
            done[view] = Image.fromarray(inside.picture(cameras[view], width, height, quality).rgb)
        elif view.startswith("corner"):
            done[view] = _corner(scene, things, view == "corner2", width, height, quality, device)
        else:
            if "top" not in done:
                done["top"] = _top(scene, things, width, height, quality, device)
            if view == "top_annotated":
                done[view] = annotated(done["top"], scene, _plan(scene, width, height))
    return {view: done[view] for view in views}


def draw_marked(
    scene: Scene,
    load: Callable[[str], Asset] | None = None,
    side: int = 1280,
    *,
    most: int | None = None,
    text: float = 1.0,
    quality: Quality | None = None,
    device: str = "cpu",
) -> Image.Image:
    """The room from above with axes, grid, boxes, ids and arrows to the front, in the shape of the room.

    Args:
        scene: The scene.
        load: Gives the asset of an id; None: ``Library().load``.
        side: Longest side of the plan in pixels; axes and the key of small things come on top.
        most: Things that are not on the floor and are marked; where there are more, those on supports are not marked.
            None: all are.
        text: How much larger than usual what is written is.
        quality: How carefully it is drawn.
        device: Where it is drawn: "cpu" or "cuda:0".

    Raises:
        InputError: for an asset that cannot be loaded, or a finish that nobody knows.
    """
    low, high = _bounds(scene)
    shares = np.maximum((high - low) / max(high - low), _NARROWEST)  # names need room beside a corridor
    width, height = (max(16, round(side * share)) for share in shares)
    things = instances_of(scene, load)
    picture = _top(scene, things, width, height, quality or Quality.normal(), device)
    marked = scene.objects
    if most is not None and sum(o.mount != "floor" for o in marked) > most:
        marked = tuple(o for o in marked if o.mount != "surface")
    plain = scene.model_copy(update={"objects": marked, "relations": ()})
    return annotated(picture, plain, _plan(scene, width, height), text * 0.75 * side / height)


class Inside:
    """A furnished room, ready for any number of cameras in it.

    Attributes:
        parts: The room around the furniture.
        instances: What is drawn: the objects of the scene in their order, then ``parts``.
    """

    def __init__(
        self, scene: Scene, things: Sequence[Instance], cameras: Sequence[Camera], device: str = "cpu"
    ) -> None:
        """Build the room; a door in which one of the cameras stands is open."""
        self.parts: list[Element] = build_interior(scene, finishes_of(scene), cameras)
        self.instances = [*things, *(Instance(part.mesh, np.eye(4)) for part in self.parts)]
        self._scene, self._device = scene, device
        self._tracer: Tracer | None = None

    def picture(self, camera: Camera, width: int, height: int, quality: Quality | None = None) -> TracedPicture:
        """What a camera sees."""
        if self._tracer is None:  # most of the light is shared by all cameras
            self._tracer = Tracer(self.instances, interior_lights(self._scene), self._device)
        return self._tracer.picture(camera, width, height, quality)


class EyeLevel:
    """The pictures of a room at eye level, one by one; what they share is worked out once.

    Attributes:
        cameras: The camera of each of `EYE_VIEWS`.
        hero: The view that shows the room best.
    """

    def __init__(
        self,
        scene: Scene,
        load: Callable[[str], Asset] | None = None,
        aspect: float = 4 / 3,
        device: str = "cpu",
    ) -> None:
        """Choose the cameras; ``load`` gives the asset of an id, ``aspect`` is width over height."""
        self.cameras, self.hero = cameras_and_hero(scene, aspect)
        self._inside = Inside(scene, instances_of(scene, load), list(self.cameras.values()), device)

    def draw(self, view: str, width: int, height: int, quality: Quality | None = None) -> Image.Image:
        """One of the pictures, in any size of that aspect."""
        return Image.fromarray(self._inside.picture(self.cameras[view], width, height, quality).rgb)


def _corner(
    scene: Scene, things: list[Instance], across: bool, width: int, height: int, quality: Quality | None, device: str
) -> Image.Image:
    ways = corner_directions(scene)
    way = opposite(ways) if across else ways[0]
    cut = cut_walls(scene, way)
    gone = hidden_with(scene, cut)
    camera = corner_camera(scene, way, cut, width / height)
    shell = build_shell(scene.room, finishes_of(scene), cut)
    shown = [one for one, thing in zip(things, scene.objects, strict=True) if thing.id not in gone]
    lamps = [one for one, thing in zip(things, scene.objects, strict=True) if thing.mount == "ceiling"]
    lighting = corner_light(scene.room, way, cut, [*shown, *lamps])
    return _overview(shown, shell, camera, width, height, lighting, quality, device)


def _top(
    scene: Scene, things: list[Instance], width: int, height: int, quality: Quality | None, device: str
) -> Image.Image:
    finishes = finishes_of(scene, cut=(0.30, 0.29, 0.28))
    low, high = _bounds(scene)
    middle = (low + high) / 2
    span = height / _plan(scene, width, height).scale
    shell = build_shell(scene.room, finishes, top=_CUT)
    gone = hidden_with(scene, ())
    shown = [one for one, thing in zip(things, scene.objects, strict=True) if thing.id not in gone]
    camera = Camera.orthographic((*middle, scene.room.height + 5.0), (*middle, 0.0), span, width / height)
    lighting = top_light(scene.room, shown)
    return _overview(shown, shell, camera, width, height, lighting, quality, device)


def _overview(
    things: list[Instance],
    shell: Shell,
    camera: Camera,
    width: int,
    height: int,
    lights: DirectLights,
    quality: Quality | None,
    device: str,
) -> Image.Image:
    """Things in a shell on a pale ground."""
    solids = [Instance(mesh, np.eye(4)) for mesh in (shell.floor, *shell.walls, _ground()) if mesh is not None]
    drawn = trace([*things, *solids], camera, width, height, lights=lights, quality=quality, device=device)
    return Image.fromarray(faded(_glowing(drawn, len(things))))


def faded(rgb: np.ndarray) -> np.ndarray:
    """The picture [H, W, 3] a little brighter in the middle and darker toward its corners, so that the eye stays in."""
    height, width = rgb.shape[:2]
    y, x = np.linspace(-1.0, 1.0, height)[:, None], np.linspace(-1.0, 1.0, width)[None, :]
    share = 1.03 - 0.085 * np.clip(0.62 * x * x + 0.62 * y * y, 0.0, 1.2)
    return np.clip(rgb * share[..., None].astype(np.float32) + 0.5, 0.0, 255.0).astype(np.uint8)


def _plan(scene: Scene, width: int, height: int) -> View:
    """How a picture from above brings metres to pixels."""
    low, high = _bounds(scene)
    scale = min(width / (high[0] - low[0]), height / (high[1] - low[1]))
    x, y = (low + high) / 2
    return View(scale, float(x - width / 2 / scale), float(y + height / 2 / scale))


def _bounds(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner [2] of what a picture from above holds [m]."""
    outline = np.asarray(scene.room.outline, dtype=float)
    reach = WALL_THICKNESS + 0.15
    return outline.min(axis=0) - reach, outline.max(axis=0) + reach


def _ground() -> Mesh:
    """An endless pale ground under the slab."""
    r, z = 500.0, -FLOOR_THICKNESS - 0.001
    corners = np.array([(-r, -r, z), (r, -r, z), (r, r, z), (-r, r, z)])
    zeros = np.zeros(2, dtype=np.int32)
    look = Material("ground", (0.79, 0.778, 0.757), roughness=1.0)
    return Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), zeros, zeros, (look,))


def _glowing(picture: TracedPicture, things: int) -> np.ndarray:
    """The picture [H, W, 3] with a soft warm shine around what is very bright of the first ``things`` instances."""
    rgb = picture.rgb
    bright = (picture.instance >= 0) & (picture.instance < things) & (rgb.min(axis=2) >= 250)
    if not bright.any():
        return rgb
    radius = rgb.shape[0] / 75
    reach = int(4 * radius) + 1  # nothing shines farther
    rows, columns = (np.flatnonzero(bright.any(axis=axis)) for axis in (1, 0))
    part = tuple(slice(max(0, at[0] - reach), at[-1] + reach + 1) for at in (rows, columns))
    mask = Image.fromarray(bright[part].astype(np.uint8) * 255).filter(ImageFilter.GaussianBlur(radius))
    shine = np.asarray(mask, dtype=np.float32)[..., None] / 255 * np.array([0.50, 0.40, 0.26], dtype=np.float32)
    rgb = rgb.copy()
    rgb[part] = (255.0 - (255.0 - rgb[part]) * (1.0 - shine)).astype(np.uint8)
    return rgb


_LEAST_GLOW = 0.3  # emission from which on a material is a lamp's
_MOST_LAMPS = 48
_PANE = 0.9  # depth of panes in their walls, in shares of these: before what shines behind them

_DAY: dict[str, Any] = {
    "sky": (0.68, 0.695, 0.725),
    "ground": (0.36, 0.335, 0.31),
    "background": (0.80, 0.79, 0.775),
    "reach": 1.6,
    "bounce": 0.62,
    "exposure": 1.06,
}
"""What all pictures of rooms have in common: an even daylight from all sides before a light ground."""


def corner_light(room: Room, way: np.ndarray, cut: set[int], things: Sequence[Instance]) -> DirectLights:
    """The light of a picture from a corner in the direction ``way`` [2] (unit, from the room to the camera)."""
    left = np.array([-way[1], way[0]])
    key = 0.66 * way + 0.34 * left
    walls = list(range(len(room.outline)))
    # Best is a window that is seen; sun also comes through those of the walls that are cut away.
    more = _beam(room, [k for k in walls if k not in cut]) or _beam(room, walls)
    return _in_mood(
        room,
        DirectLights(
            sun=(float(key[0]), float(key[1]), 1.15),
            softness=0.075,
            sun_color=(0.62, 0.58, 0.53) if more else (0.68, 0.64, 0.58),
            glows=glows_of(things),
            **_DAY,
            **more,
        ),
    )


def top_light(room: Room, things: Sequence[Instance]) -> DirectLights:
    """The light of a picture from straight above: the sun stands high, so that walls throw short shadows."""
    return _in_mood(
        room,
        DirectLights(
            sun=(-0.30, 0.34, 1.3),
            softness=0.07,
            sun_color=(0.72, 0.68, 0.62),
            glows=glows_of(things),
            **_DAY,
            **_beam(room, list(range(len(room.outline)))),
        ),
    )


def _in_mood(room: Room, lights: DirectLights) -> DirectLights:
    """Plain light as a room is to be shown in: dimmer, in another colour, without the sun."""
    if room.light is None:
        return lights
    mood = mood_of(room.light)
    level, tint = mood.level**1.5, np.asarray(mood.tint)

    def dyed(color: tuple[float, float, float], share: float = 1.0) -> tuple[float, float, float]:
        r, g, b = np.asarray(color) * tint * share
        return float(r), float(g), float(b)

    return replace(
        lights,
        sun_color=dyed(lights.sun_color, 0.35 + 0.65 * mood.day),
        sky=dyed(lights.sky),
        ground=dyed(lights.ground),
        background=dyed(lights.background, max(0.12, mood.day)),
        beam_color=dyed(lights.beam_color, mood.day),
        exposure=lights.exposure * level,
        glows=tuple((x, y, z, power * (1.0 + 2.2 * (1.0 - level))) for x, y, z, power in lights.glows),
        glow_color=mood.lamp if room.light.kelvin < 2600 else lights.glow_color,
    )


def glows_of(things: Sequence[Instance]) -> tuple[tuple[float, float, float, float], ...]:
    """A small light in the middle of what glows of each thing, by its area; the strongest when there are many."""
    found = []
    for one in things:
        mesh = one.mesh
        glowing = np.array([m.emission >= _LEAST_GLOW for m in mesh.materials], dtype=bool)
        faces = mesh.faces[glowing[mesh.face_material]] if len(mesh.faces) else mesh.faces
        if not len(faces):
            continue
        corners = (mesh.vertices @ one.transform[:3, :3].T + one.transform[:3, 3])[faces]
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        x, y, z = np.average(corners.mean(axis=1), axis=0, weights=np.maximum(area, 1e-9))
        power = 0.16 * min(1.0, math.sqrt(float(area.sum()) / 0.12))
        found.append((round(float(x), 5), round(float(y), 5), round(float(z), 5), power))
    return tuple(sorted(found, key=lambda lamp: (-lamp[3], lamp))[:_MOST_LAMPS])


def _beam(room: Room, walls: Sequence[int]) -> dict[str, Any]:
    """The sun through the windows of the wall of ``walls`` with the most glass; nothing without windows."""
    wall = most_glass(room, walls)
    if wall is None:
        return {}
    x, y, z = slant_of(wall)
    return {
        "beam": (x, y, z),
        "beam_softness": 0.022,
        "beam_floor": -0.02,
        "beam_color": (2.1, 1.72, 1.25),
        "portals": portals_of(room, _PANE),
    }
