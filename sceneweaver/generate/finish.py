"""Walls and floor of a room that is drawn: by the palette of the room, with a tiled band where there is water."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sceneweaver.assets.materials import color_words
from sceneweaver.geometry.angles import dot
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.palettes import Palette, accent_for, floor_for
from sceneweaver.scene import Room, RoomFinish, Scene, WallAccent, WallTiles
from sceneweaver.scene.finish import FloorFinish

from .draft import groups_of

TILED = {"bathroom": (0.0, 2.1), "guest_toilet": (0.0, 1.2), "kitchen": (0.9, 1.5), "laundry_room": (0.9, 1.5)}
"""Heights [m] between which the walls of a kind of room are tiled."""


MAIN = frozenset(("bed_group", "sofa", "sectional_sofa", "loveseat", "desk"))
"""Groups and categories of what a room is built around."""

_WALLS = re.compile(r"(?P<color>[a-z]+(?: [a-z]+)?)(?:[- ]painted)? (?:walls\b|(?P<accent>accent|feature) wall\b)")

AT_WALL = 0.3
"""Distance [m] of the back of a piece from its wall at most."""


def finished(room: Room, room_type: RoomType, palette: Palette, seed: int, text: str = "") -> Room:
    """The room with the paint, accent wall, tiles and floor of its palette.

    ``text`` is the request: "navy walls" and "a red accent wall" are painted so.
    """
    said = {which: color for color, which in _named(text)}
    floor = floor_for(room_type.name, room_type.floor, seed)
    tiles = TILED.get(room_type.name)
    kind = accent_for(room_type.name, seed)
    wall = accent_wall(room)
    accent = None
    if said.get("accent") and wall is not None:
        accent = WallAccent(kind="paint", color=said["accent"], walls=(wall,))
    elif kind != "plain" and tiles is None and wall is not None and "walls" not in said:
        accent = WallAccent(kind=kind, color=palette.accent, walls=(wall,))
    finish = RoomFinish(
        walls=said.get("walls", palette.walls),
        floor=FloorFinish(material=floor, tone=palette.floors.get(floor)),
        accent=accent,
        tiles=None if tiles is None else WallTiles(color=tile_color(palette), low=tiles[0], high=tiles[1]),
    )
    return room.model_copy(update={"finish": finish})


def _named(text: str) -> Iterator[tuple[str, str]]:
    """Colours that a text says of walls, with "walls" or "accent"."""
    for match in _WALLS.finditer(text.lower()):
        words = match["color"].split()
        for color in (" ".join(words), words[-1]):
            if color in color_words():
                yield color, "accent" if match["accent"] else "walls"
                break


def accented(scene: Scene) -> Scene:
    """The scene with its accent on the wall behind its main piece: the largest bed, sofa or desk with its back at one.

    Without such a piece, or an accent, it stays as it is.
    """
    room, finish = scene.room, scene.room.finish
    if finish is None or finish.accent is None:
        return scene
    main = [o for o in scene.objects if o.mount == "floor" and groups_of(o.category) & MAIN]
    for piece in sorted(main, key=lambda o: (-o.size[0] * o.size[1], o.id)):
        back = piece.pose.frame.world(-piece.size[0] / 2, 0.0)
        for wall in room.walls:
            along, deep = wall.coordinates(back)
            facing = dot(piece.pose.frame.axis, wall.inward) > 0.9
            if facing and abs(deep) < AT_WALL and 0.0 < along < wall.length:
                accent = finish.accent.model_copy(update={"walls": (wall.index,)})
                finish = finish.model_copy(update={"accent": accent})
                return scene.model_copy(update={"room": room.model_copy(update={"finish": finish})})
    return scene


def tile_color(palette: Palette) -> str:
    """Colour of tiles on walls: white, but the accent where the walls are white themselves."""
    return "white" if palette.walls != "white" else palette.accent


def accent_wall(room: Room) -> int | None:
    """The wall that an accent is on: the longest without door and window, one across from the door before others."""
    ahead = room.walls[room.doors[0].wall].inward if room.doors else (0.0, 1.0)
    bare = [wall for wall in room.walls if not room.openings_of(wall.index)]
    if not bare:
        return None
    best = max(bare, key=lambda wall: (wall.length > 2.0, -dot(wall.inward, ahead) > 0.5, wall.length))
    return best.index if best.length > 1.5 else None
