"""What lights a room: sun and sky through its windows, and everything in it that shines."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.materials import shade
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import InputError, Room, RoomLight, Scene

Color = tuple[float, float, float]

_SUN_HEIGHT = math.radians(36.0)
_SUN_SLANT = 0.42  # sideways, so that bars and curtains draw lines that run into the room
_FAINT = 1.2  # radiance of a white screen with an emission of 1
_PLAIN = 1.6  # radiance of what is white with an emission of 1, in plain light
_LAMP = 0.3  # emission from which on a material is a lamp's
_LEAST_LAMP = 0.012  # what glows on less [m2] is a display or a flame
_LEAST_SQUARE = 0.002  # of the distance to a lamp's triangle [m2]
_LEAST_AREA = 1e-7  # of a triangle that shines [m2]


@dataclass(frozen=True)
class Portal:
    """A rectangle that daylight comes in by: a corner and two edges at right angles [m], world frame.

    ``inward`` is the unit normal into the room.
    """

    corner: Color
    across: Color
    up: Color
    inward: Color


@dataclass(frozen=True)
class Lights:
    """Radiance, relative to that of the sky's zenith, of everything that gives light; linear RGB.

    Without ``portals`` and ``enclosed`` the whole sky lights what is drawn. With ``enclosed`` daylight comes by the
    portals alone, and what is seen past the walls elsewhere is a ``hall``.

    ``sun`` points toward the sun, ``softness`` is the tangent of its half angle, ``sun_color`` its irradiance at right
    angles. ``view`` is how bright the world outside looks at most beside the light that it gives. ``lamp_color`` is
    that of everything with an emission; ``lamp_flux`` what one of 0.12 m2 sends out. ``level`` is how bright the
    picture is beside one that is exposed as usual, ``adapted`` the share of the colour of the light that an eye gets
    used to. ``room`` is the box [m] that the room fills, lower and upper corner; None: all that is drawn. ``cell`` is
    the side [m] of the cells in which light between surfaces is gathered.
    """

    sun: Color = (0.5, -0.35, 0.79)
    softness: float = 0.012
    sun_color: Color = (2.4, 2.12, 1.75)
    zenith: Color = (0.72, 0.86, 1.10)
    horizon: Color = (1.05, 1.06, 1.06)
    ground: Color = (0.34, 0.33, 0.29)
    hall: Color = (0.16, 0.15, 0.13)
    view: float = 1.0
    lamp_color: Color = (1.0, 0.74, 0.48)
    lamp_flux: float = 0.9
    level: float = 1.0
    adapted: float = 0.65
    enclosed: bool = False
    portals: tuple[Portal, ...] = ()
    room: tuple[Color, Color] | None = None
    cell: float = 0.11

    def __post_init__(self) -> None:
        _check_sun(self.sun)
        for key in ("sun_color", "zenith", "horizon", "ground", "hall", "lamp_color"):
            value = np.asarray(getattr(self, key), dtype=float)
            if value.shape != (3,) or not np.isfinite(value).all() or (value < 0).any():
                raise InputError(f"lights.{key}: {getattr(self, key)} is no colour of three numbers from 0 on")


@dataclass(frozen=True)
class DirectLights:
    """Sun and sky without bounces, for drafts, in linear light: what a white surface at right angles shows.

    ``sun`` points toward it, ``softness`` is the tangent of its half angle, ``reach`` how far what hides the sky is
    looked for [m]. ``bounce`` is how much light near surfaces throw back in their own colour (0: a plain share of the
    sky's). ``beam`` is a second sun that shines in by the ``portals`` only, and on nothing below the height
    ``beam_floor`` [m]; when it is black there is none. ``glows`` are small lights (x, y, z [m], power) in one colour;
    they reach 3 m and throw no shadows. ``exposure`` is what all is multiplied by.
    """

    sun: Color = (0.55, -0.35, 0.75)
    softness: float = 0.08
    sun_color: Color = (1.25, 1.16, 1.02)
    sky: Color = (0.78, 0.82, 0.88)
    ground: Color = (0.46, 0.43, 0.40)
    background: Color = (0.86, 0.86, 0.85)
    reach: float = 1.5
    exposure: float = 0.92
    bounce: float = 0.0
    beam: Color = (0.0, 0.0, 1.0)
    beam_softness: float = 0.02
    beam_color: Color = (0.0, 0.0, 0.0)
    beam_floor: float = -math.inf
    portals: tuple[Portal, ...] = ()
    glows: tuple[tuple[float, float, float, float], ...] = ()
    glow_color: Color = (1.0, 0.78, 0.52)

    def __post_init__(self) -> None:
        _check_sun(self.sun)


def _check_sun(sun: Color) -> None:
    if not 0 < float(np.linalg.norm(sun)) < math.inf:
        raise InputError(f"lights.sun: {sun} is no direction")


def interior_lights(scene: Scene) -> Lights:
    """The light of a furnished room by day: its windows are portals, and the sun stands so that it enters by one.

    It follows from the scene alone. A room without windows has its lamps.
    """
    room = scene.room
    sunny = most_glass(room, range(len(room.walls))) or room.walls[0]
    stated = mood_of(room.light)
    outline = np.asarray(room.outline, dtype=float)
    low, high = outline.min(axis=0) - 2 * WALL_THICKNESS, outline.max(axis=0) + 2 * WALL_THICKNESS
    return Lights(
        sun=slant_of(sunny),
        enclosed=True,
        portals=portals_of(room),
        room=((float(low[0]), float(low[1]), -0.3), (float(high[0]), float(high[1]), room.height + 0.4)),
        lamp_flux=stated.flux * (0.9 if room.windows else 1.6),
        sun_color=_times(Lights.sun_color, stated.sun),
        zenith=_times(Lights.zenith, stated.sky),
        horizon=_times(Lights.horizon, stated.sky),
        ground=_times(Lights.ground, stated.sky),
        lamp_color=stated.lamp,
        level=stated.level,
        adapted=stated.adapted,
    )


def portals_of(room: Room, depth: float = 0.5) -> tuple[Portal, ...]:
    """Each window as a rectangle at a depth in its wall, in shares of the wall's thickness."""
    found = []
    for window in room.windows:
        wall = room.walls[window.wall]
        x, y = wall.point(window.offset, -depth * WALL_THICKNESS)
        across = (wall.along[0] * window.width, wall.along[1] * window.width, 0.0)
        inward = (float(wall.inward[0]), float(wall.inward[1]), 0.0)
        found.append(Portal((float(x), float(y), window.sill), across, (0.0, 0.0, window.height), inward))
    return tuple(found)


def most_glass(room: Room, walls: Iterable[int]) -> Wall | None:
    """The one of some walls with the largest windows; None where they have none."""
    glass = {k: 0.0 for k in walls}
    for window in room.windows:
        if window.wall in glass:
            glass[window.wall] += window.width * window.height
    best = max(glass, key=lambda k: (round(glass[k], 6), -k), default=None)
    return None if best is None or glass[best] <= 0 else room.walls[best]


def slant_of(wall: Wall) -> Color:
    """Toward a sun that shines in by a wall, a little aslant: unit vector [3]."""
    way = np.asarray(wall.outward) + _SUN_SLANT * np.asarray(wall.along)
    way = way / np.linalg.norm(way) * math.cos(_SUN_HEIGHT)
    return float(way[0]), float(way[1]), math.sin(_SUN_HEIGHT)


GLOW = " glow tube"
"""End of the names of materials that shine in their own colour."""


@dataclass(frozen=True)
class Mood:
    """What a light that is asked for makes of the usual one: factors on sun, sky and lamps, the colour of lamps, how
    bright a picture is, how far an eye gets used to the colour, and a tint for pictures in plain light."""

    sun: Color = (1.0, 1.0, 1.0)
    sky: Color = (1.0, 1.0, 1.0)
    flux: float = 1.0
    lamp: Color = Lights.lamp_color
    level: float = 1.0
    adapted: float = Lights.adapted
    tint: Color = (1.0, 1.0, 1.0)
    day: float = 1.0


_SUN: Mapping[str, tuple[Color, Color, float]] = {
    "day": ((1.0, 1.0, 1.0), (1.0, 1.0, 1.0), 1.0),
    "overcast": ((0.0, 0.0, 0.0), (0.62, 0.64, 0.68), 0.8),
    "dusk": ((0.30, 0.16, 0.06), (0.22, 0.20, 0.26), 0.4),
    "night": ((0.0, 0.0, 0.0), (0.006, 0.008, 0.016), 0.0),
}
"""What is left of sun and sky, and of the share of daylight in a room."""

_LEVELS: Mapping[str, float] = {"bright": 1.12, "normal": 1.0, "dim": 0.55, "dark": 0.32}


def mood_of(light: RoomLight | None) -> Mood:
    """What a stated light makes of the usual one."""
    if light is None:
        return Mood()
    sun, sky, day = _SUN[light.daylight]
    lamp, level = kelvin_color(light.kelvin), _LEVELS[light.level]
    if light.level in ("dim", "dark"):  # what comes in is kept out by the same measure
        sun, sky, day = _times(sun, (0.35, 0.35, 0.35)), _times(sky, (0.4, 0.4, 0.4)), 0.6 * day
    colored = 1.0 - 0.75 * day if light.glow is None else 1.0
    usual = kelvin_color(3200)
    tint = tuple(min(max(0.6, a / b), 1.2) ** (0.8 * colored) for a, b in zip(lamp, usual, strict=True))
    if light.glow is not None:
        hue = np.asarray(shade(light.glow)) ** 1.6
        hue = 0.30 + 0.9 * hue / max(float(hue.max()), 1e-6)
        tint = tuple(float(v) for v in hue)
    return Mood(
        sun,
        sky,
        1.0 + 0.8 * (1.0 - day),
        lamp,
        level,
        0.65 - 0.4 * colored * (light.level != "bright") if light.glow is None else 0.1,
        (float(tint[0]), float(tint[1]), float(tint[2])),
        day,
    )


def kelvin_color(kelvin: float) -> Color:
    """Linear RGB of a lamp of a colour temperature [K], the strongest 1: a fit of the colours of a black body."""
    t = kelvin / 100.0
    red = 1.0 if t <= 66 else 1.293 * (t - 60) ** -0.1332
    green = (0.3901 * math.log(t) - 0.6318) if t <= 66 else 1.1299 * (t - 60) ** -0.0755
    blue = 1.0 if t >= 66 else 0.0 if t <= 19 else 0.5432 * math.log(t - 10) - 1.1963
    r, g, b = (min(max(v, 0.0), 1.0) ** 2.2 for v in (red, green, blue))
    return round(r, 4), round(g, 4), round(b, 4)


def _times(a: Color, b: Color) -> Color:
    return a[0] * b[0], a[1] * b[1], a[2] * b[2]


@dataclass(frozen=True)
class Emitters:
    """Triangles that shine, lamp by lamp.

    ``corners`` [N, 3, 3] and ``radiance`` [N, 3] are those of each, ``visible`` [N] the share of its light that leaves
    the lamp, ``least`` [N] the square of the distance [m2] under which it looks no larger, ``owner`` [N] its instance
    (-1: none). ``start`` [L + 1] is where the triangles of each lamp begin.
    """

    corners: np.ndarray
    radiance: np.ndarray
    visible: np.ndarray
    least: np.ndarray
    owner: np.ndarray
    start: np.ndarray

    def __add__(self, other: Emitters) -> Emitters:
        """Both, the other's lamps last."""
        names = ("corners", "radiance", "visible", "least", "owner")
        joined = {name: np.concatenate([getattr(self, name), getattr(other, name)]) for name in names}
        return Emitters(**joined, start=np.concatenate([self.start, other.start[1:] + self.start[-1]]))

    @property
    def area(self) -> np.ndarray:
        """Of each triangle [N] in m2."""
        return areas(self.corners)


def areas(corners: np.ndarray) -> np.ndarray:
    """Of triangles [N, 3, 3], in m2."""
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


def linear_color(material: Material) -> np.ndarray:
    """The base colour [3] in linear light."""
    color = np.asarray(material.color, dtype=np.float64)
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def emission_of(mesh: Mesh, area: np.ndarray | None, lights: Lights | DirectLights) -> np.ndarray:
    """Radiance [M, 3] that each material of a mesh sends out, whose triangles have ``area`` [F] in the world
    (None: nothing of it shines).

    A lamp sends out what its size says, however its shade is drawn: bulbs are bright, panels are pale. What shines
    faintly is a screen, what shines on very little a display or a flame. In plain light all shine in their colour.
    """
    if isinstance(lights, DirectLights):
        return np.array([_PLAIN * m.emission * linear_color(m) for m in mesh.materials]).reshape(-1, 3)
    radiance = np.zeros((len(mesh.materials), 3))
    if area is None:
        return radiance
    shining = np.array([m.emission for m in mesh.materials])
    total = np.bincount(mesh.face_material, area, len(mesh.materials)) if len(mesh.faces) else np.zeros(len(shining))
    lamp = float(total[shining >= _LAMP].sum())
    flux = lights.lamp_flux * min((lamp / 0.12) ** 0.65, 3.0) if lamp > 0 else 0.0
    for k, material in enumerate(mesh.materials):
        if material.name.endswith(GLOW):
            radiance[k] = 3.2 * linear_color(material)
        elif material.emission >= _LAMP and lamp >= _LEAST_LAMP:
            level = min(flux / (math.pi * lamp), 6.0) * material.emission
            radiance[k] = level * np.asarray(lights.lamp_color)
        elif material.emission > 0:
            radiance[k] = _FAINT * min(material.emission, _LAMP) * np.asarray(material.color) ** 2.2
    return radiance


def emitters(groups: Sequence[tuple[np.ndarray, np.ndarray, int]], as_discs: bool = False) -> Emitters:
    """The table of emitters from corners [N, 3, 3] and radiance [N, 3] of each lamp's triangles, and its instance.

    Very near to a lamp one sample would outshine all others: its distance is not less than a few centimetres, or, for
    triangles that stand for discs of their area, than that at which such a disc fills half of what is seen.
    """
    corners, radiance, owner, start = [np.zeros((0, 3, 3))], [np.zeros((0, 3))], [np.zeros(0, dtype=int)], [0]
    for triangles, light, instance in groups:
        kept = areas(triangles) > _LEAST_AREA
        if kept.any():
            corners.append(triangles[kept])
            radiance.append(light[kept])
            owner.append(np.full(int(kept.sum()), instance))
            start.append(start[-1] + int(kept.sum()))
    every = np.concatenate(corners)
    least = areas(every) / math.pi if as_discs else np.full(len(every), _LEAST_SQUARE)
    return Emitters(
        every, np.concatenate(radiance), np.ones(len(every)), least, np.concatenate(owner), np.asarray(start)
    )
