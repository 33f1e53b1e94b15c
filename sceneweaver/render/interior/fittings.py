"""Switches, sockets and radiators: where there is room for them, and what they look like."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Material
from sceneweaver.geometry.shell import heights
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Door, Scene, Window

from ..blocks import Builder, Finishes
from ..mouldings import Plane, disc, plate, rectangle, rod
from ..words import is_one_of

SWITCH, SOCKET = 1.05, 0.3
"""Heights of the middles of switches and sockets [m]."""

SPACING = 2.6
"""About how far sockets are from each other along a wall [m]."""

LEAST_SILL = 0.45
"""Height of the lowest sill under which a radiator hangs [m]."""

_SIDE = 0.081  # of a switch or socket
_RADIATOR = (0.03, 0.095)  # depths into the room [m]
_AIR = 0.1  # what furniture must keep from a radiator [m]

_UNHEATED = ("metal", "logs", "stone")
"""Walls on which no radiators hang, and that have no sockets."""

_PLASTIC = Material("switch plate", (0.94, 0.935, 0.92), roughness=0.35)
_SHADE = Material("socket recess", (0.80, 0.795, 0.78), roughness=0.4)
_DARK = Material("socket pin hole", (0.06, 0.06, 0.06), roughness=0.6)


@dataclass(frozen=True)
class Spot:
    """A place on a wall: its number, the offset along it and the height [m]."""

    wall: int
    offset: float
    height: float


@dataclass(frozen=True)
class Radiator:
    """A radiator on a wall: from and to along it, and in height [m]."""

    wall: int
    along: tuple[float, float]
    height: tuple[float, float]


@dataclass(frozen=True)
class Fittings:
    """What hangs on the walls of a room beyond its objects."""

    switches: tuple[Spot, ...]
    sockets: tuple[Spot, ...]
    radiators: tuple[Radiator, ...]


def plan_fittings(scene: Scene) -> Fittings:
    """Where switches, sockets and radiators go: never on an opening, on a door frame or behind or in furniture."""
    free = _Free(scene)
    if scene.room.finish is not None and not scene.room.finish.electric:
        return Fittings((), (), ())
    switches = [spot for door in scene.room.doors for spot in _switch(scene, door, free)][: 4 * len(scene.room.doors)]
    if scene.room.finish is not None and scene.room.finish.walls_of in _UNHEATED:
        return Fittings(tuple(switches), (), ())
    radiators = [found for window in scene.room.windows for found in _radiator(scene, window, free)]
    if scene.room.windows and not radiators:  # furniture or curtains are there: it hangs on the nearest free wall
        radiators = [*_aside(scene, free)][:1]
    taken = [(r.wall, r.along) for r in radiators]
    sockets: list[Spot] = []
    for spot in _socket_wishes(scene):
        wall = scene.room.walls[spot.wall]
        span = (spot.offset - 0.06, spot.offset + 0.06)
        near = any(s.wall == spot.wall and abs(s.offset - spot.offset) < 0.8 for s in sockets)
        behind = any(k == spot.wall and span[1] > along[0] and span[0] < along[1] for k, along in taken)
        if not near and not behind and free(wall, span, (spot.height - 0.06, spot.height + 0.06), 0.05):
            sockets.append(spot)
    return Fittings(tuple(switches), tuple(sockets), tuple(radiators))


class _Free:
    """Whether a part of a wall is free: of openings with their frames, and of objects before it."""

    def __init__(self, scene: Scene) -> None:
        self.room = scene.room
        # Of each collision prism in the room: its corners from above and its heights.
        self.prisms = [
            (
                np.asarray(thing.pose.frame.to_world(np.asarray(part.polygon))),
                np.asarray(part.z) + thing.pose.position[2],
            )
            for thing in scene.objects
            for part in thing.solids
        ]

    def __call__(self, wall: Wall, along: tuple[float, float], z: tuple[float, float], depth: float) -> bool:
        if along[0] < 0.04 or along[1] > wall.length - 0.04:
            return False
        for opening in self.room.openings_of(wall.index):
            low, high = heights(opening)
            a, b = opening.offset - 0.07, opening.offset + opening.width + 0.07
            if along[0] < b and along[1] > a and z[0] < high + 0.07 and z[1] > low - 0.03:
                return False
        for plan, (low, high) in self.prisms:
            if z[0] < high and z[1] > low:
                s, t = wall.coordinates(plan.T)
                # Where all of it is aside, behind the wall or farther away it is in nobody's way.
                if s.max() > along[0] and s.min() < along[1] and t.min() < depth and t.max() > 0.0:
                    return False
        return True


def _switch(scene: Scene, door: Door, free: _Free) -> Iterator[Spot]:
    """A switch beside the door, on the side of its handle if it can be."""
    wall = scene.room.walls[door.wall]
    start, end = door.offset - 0.15, door.offset + door.width + 0.15
    for at in (start, end) if door.swing == "in-right" else (end, start):
        if free(wall, (at - 0.05, at + 0.05), (SWITCH - 0.05, SWITCH + 0.05), 0.04):
            yield Spot(wall.index, at, SWITCH)
            return


def _radiator(scene: Scene, window: Window, free: _Free) -> Iterator[Radiator]:
    """A radiator under a window, as wide as there is room for."""
    if window.sill < LEAST_SILL:
        return
    wall = scene.room.walls[window.wall]
    top = min(0.72, window.sill - 0.13)
    middle = window.offset + window.width / 2
    for share in (0.9, 0.7, 0.5):
        half = min(0.9, share * window.width / 2)
        around = (middle - half - _AIR, middle + half + _AIR)
        if half > 0.22 and free(wall, around, (0.0, top + 0.02), _RADIATOR[1] + _AIR):
            yield Radiator(wall.index, (middle - half, middle + half), (0.11, top))
            return


def _aside(scene: Scene, free: _Free) -> Iterator[Radiator]:
    """Places for a radiator on any wall, those nearest to a window first."""
    high, half = 0.7, 0.4
    windows = [scene.room.walls[w.wall].point(w.offset + w.width / 2) for w in scene.room.windows]
    places = []
    for wall in scene.room.walls:
        for at in np.arange(half + 0.1, wall.length - half, 0.2):
            x, y = wall.point(float(at))
            near = min(np.hypot(x - a, y - b) for a, b in windows)
            places.append((round(float(near), 3), wall.index, round(float(at), 4)))
    for _, number, at in sorted(places):
        if free(scene.room.walls[number], (at - half - _AIR, at + half + _AIR), (0.0, high + 0.02), 0.3):
            yield Radiator(number, (at - half, at + half), (0.11, high))


def _socket_wishes(scene: Scene) -> Iterator[Spot]:
    """Where sockets would go: beside what needs power, then every few metres."""
    walls = scene.room.walls
    for thing in scene.objects:
        if not is_one_of(thing.category, "powered") or thing.mount == "surface":
            continue
        places = [(wall, *wall.coordinates(thing.pose.position[:2])) for wall in walls]
        wall, at, depth = min(places, key=lambda one: (round(abs(one[2]), 6), one[0].index))
        half = thing.size[1] / 2
        if abs(depth) < 0.8 and 0 < at < wall.length:
            height = thing.pose.position[2] - 0.1 if thing.mount == "wall" else SOCKET
            for offset in (at + half + 0.12, at - half - 0.12):
                yield Spot(wall.index, round(offset, 4), max(SOCKET, round(height, 4)))
    for wall in walls:
        count = int(wall.length // SPACING) + 1
        for k in range(count):
            for aside in (0.0, 0.25, -0.25, 0.5, -0.5):
                yield Spot(wall.index, round((k + 0.5) * wall.length / count + aside, 4), SOCKET)


def add_fittings(builder: Builder, walls: tuple[Wall, ...], fittings: Fittings, look: Finishes) -> None:
    """Draw them."""
    for spot in fittings.switches:
        _draw_switch(builder, Plane.on_wall(walls[spot.wall]), spot)
    for spot in fittings.sockets:
        _draw_socket(builder, Plane.on_wall(walls[spot.wall]), spot)
    for radiator in fittings.radiators:
        _draw_radiator(builder, Plane.on_wall(walls[radiator.wall]), radiator, look)


def _draw_switch(builder: Builder, plane: Plane, spot: Spot) -> None:
    half, inner = _SIDE / 2, 0.027
    u, v = spot.offset, spot.height
    plate(builder, plane, rectangle((u - half, u + half), (v - half, v + half)), (0.0, 0.009), _PLASTIC, bevel=0.003)
    rocker = rectangle((u - inner, u + inner), (v - inner, v + inner))
    plate(builder, plane, rocker, (0.0, 0.0125), _PLASTIC, bevel=0.0015)
    gap = rectangle((u - inner - 0.0015, u + inner + 0.0015), (v - inner - 0.0015, v + inner + 0.0015))
    plate(builder, plane, gap, (0.0, 0.0094), _SHADE)


def _draw_socket(builder: Builder, plane: Plane, spot: Spot) -> None:
    half = _SIDE / 2
    u, v = spot.offset, spot.height
    plate(builder, plane, rectangle((u - half, u + half), (v - half, v + half)), (0.0, 0.009), _PLASTIC, bevel=0.003)
    plate(builder, plane, disc((u, v), 0.0215, 24), (0.0, 0.0094), _SHADE)
    plate(builder, plane, disc((u, v), 0.0185, 24), (0.0, 0.0097), _PLASTIC)
    for side in (-1, 1):
        plate(builder, plane, disc((u + side * 0.0095, v), 0.0026, 10), (0.0, 0.0100), _DARK)


def _draw_radiator(builder: Builder, plane: Plane, radiator: Radiator, look: Finishes) -> None:
    """A panel radiator: two sheets with flutes, a grille on top, a valve and its pipes."""
    (a, b), (low, high), (near, far) = radiator.along, radiator.height, _RADIATOR
    metal = Material("radiator", look.trim.color, roughness=0.4)
    plate(builder, plane, rectangle((a, b), (low, high)), (near, near + 0.012), metal)
    plate(builder, plane, rectangle((a, b), (low, high)), (far - 0.018, far - 0.008), metal, bevel=0.003)
    count = max(2, round((b - a) / 0.05))
    step = (b - a) / count
    for k in range(count):
        flute = rectangle((a + (k + 0.22) * step, a + (k + 0.78) * step), (low + 0.03, high - 0.03))
        plate(builder, plane, flute, (far - 0.009, far), metal, bevel=0.0075)
    for s in ((a, a + 0.006), (b - 0.006, b)):
        plate(builder, plane, rectangle(s, (low, high)), (near, far - 0.008), metal)
    for k in range(round((b - a) / 0.02)):
        bar = a + 0.01 + k * 0.02
        plate(builder, plane, rectangle((bar, bar + 0.008), (high - 0.006, high)), (near, far - 0.012), metal)
    middle = (near + far) / 2
    pipe = b + 0.04
    rod(builder, plane, ((b, low + 0.05, middle), (pipe + 0.008, low + 0.05, middle)), 0.008, look.metal)
    rod(builder, plane, ((pipe, low + 0.06, middle), (pipe, 0.0, middle)), 0.008, look.metal)
    rod(builder, plane, ((pipe, low + 0.03, middle), (pipe, low + 0.10, middle)), 0.018, metal)
    for s in (a + 0.15, b - 0.15) if b - a > 0.5 else ((a + b) / 2,):
        plate(builder, plane, rectangle((s - 0.015, s + 0.015), (low + 0.02, high - 0.06)), (0.0, near), metal)
