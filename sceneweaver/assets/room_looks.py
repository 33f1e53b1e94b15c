"""Materials of a room's walls and floor: by its finish, else by the kind of room."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass, replace

from sceneweaver.scene import InputError, Room

from .body import Material
from .materials import finishes, shade

FLOORS = ("wood", "tile", "carpet", "concrete", "stone")

_BY_WORD = {
    "tile": "bathroom toilet kitchen laundry restroom washroom hospital clinic dentist bakery cafe canteen laboratory "
    "examination supermarket",
    "carpet": "office meeting conference hotel cinema theater lecture library waiting computer",
    "concrete": "garage storage warehouse workshop gym server basement hall",
    "stone": "lobby reception museum gallery bank",
}
_FLOOR_OF = {word: floor for floor, words in _BY_WORD.items() for word in words.split()}

PAINT = Material("wall paint", (0.905, 0.89, 0.865), roughness=0.95, texture="plaster")
"""Walls of a room without a finish."""

_FLOOR_LOOKS = {
    "wood": Material("floorboard", (0.735, 0.565, 0.395), roughness=0.48, texture="floorboards"),
    "tile": Material("floor tile", (0.795, 0.775, 0.745), roughness=0.32, texture="square tiles"),
    "stone": Material("floor slab", (0.70, 0.685, 0.655), roughness=0.4, texture="large tiles"),
    "carpet": Material("carpet", (0.565, 0.575, 0.59), roughness=0.98, texture="loop carpet"),
    "concrete": Material("concrete", (0.69, 0.685, 0.67), roughness=0.6, texture="concrete"),
}


_PALE = (0.80, 0.765, 0.72)
"""What colours of floors are drawn to, as large areas of a colour look twice as strong."""


@dataclass(frozen=True)
class RoomLooks:
    """Materials of a room: ``floor_kind`` is one of `FLOORS`; ``accent`` and ``tiles`` are None where there is none."""

    floor_kind: str
    floor: Material
    wall: Material
    accent: Material | None = None
    tiles: Material | None = None


def room_looks(room: Room) -> RoomLooks:
    """The materials of a room.

    Raises:
        InputError: for a colour or a wood of ``room.finish`` that nobody knows.
    """
    finish = room.finish
    if finish is None:
        kind = _floor_for(room.type)
        return RoomLooks(kind, _FLOOR_LOOKS[kind], PAINT)
    kind, tone = finish.floor.material, finish.floor.tone
    floor = _FLOOR_LOOKS[kind]
    if tone is not None:
        floor = replace(floor, name=f"{tone} floor", color=_floor_color(tone))
    accent = finish.accent and _painted(finish.accent.color, "accent.color", 0.3)
    tiles = finish.tiles and replace(
        _painted(finish.tiles.color, "tiles.color", 0.3), name="wall tile", roughness=0.25, texture="wall tiles"
    )
    return RoomLooks(kind, floor, _painted(finish.walls, "walls", 0.5), accent, tiles)


def wall_look(room: Room, wall: int) -> Material:
    """The one material that stands for a whole wall, where it is drawn as one face."""
    looks, finish = room_looks(room), room.finish
    if finish is None:
        return looks.wall
    tiles = finish.tiles
    if looks.tiles and tiles and tiles.high - tiles.low > 0.6 * room.height and wall in (tiles.walls or (wall,)):
        return looks.tiles
    if looks.accent and finish.accent and wall in finish.accent.walls and finish.accent.kind != "panelling":
        return looks.accent
    return looks.wall


def _floor_for(room_type: str) -> str:
    words = room_type.lower().replace("_", " ").replace("-", " ").split()
    return next((_FLOOR_OF[word] for word in words if word in _FLOOR_OF), "wood")


def _floor_color(tone: str) -> tuple[float, float, float]:
    wood = finishes().get(tone)
    if wood is not None and wood.family == "wood":
        return wood.material.color
    r, g, b = (c + 0.22 * (pale - c) for c, pale in zip(_shade(tone, "floor.tone"), _PALE, strict=True))
    return round(r, 4), round(g, 4), round(b, 4)


def _painted(color: str, field: str, softer: float) -> Material:
    """Wall paint is never as strong as a colour card, as large areas look twice as strong: ``softer`` of the way to a
    pale one."""
    h, light, s = colorsys.rgb_to_hls(*_shade(color, field))
    pale = max(light, 0.86) if light > 0.45 else 0.62
    light = min((1 - softer) * light + softer * pale, 0.935)
    r, g, b = colorsys.hls_to_rgb(h, light, (1 - 0.5 * softer) * s)
    return Material(f"{color} wall", (round(r, 4), round(g, 4), round(b, 4)), roughness=0.95, texture="plaster")


def _shade(color: str, field: str) -> tuple[float, float, float]:
    try:
        return shade(color)
    except InputError as error:
        raise InputError(f"room.finish.{field}: {str(error).removeprefix('color: ')}") from None
