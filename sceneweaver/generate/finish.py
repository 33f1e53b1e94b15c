"""Walls and floor of a room that is drawn: by the palette of the room, with a tiled band where there is water."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.assets.materials import color_name
from sceneweaver.assets.materials import finish as finish_named
from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import dot
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.palettes import Palette, accent_for, floor_for
from sceneweaver.scene import Room, RoomFinish, Scene, WallAccent, WallTiles
from sceneweaver.scene.finish import FloorFinish

from .stated_finish import stated_finish

PANELS = "tan"
"""Colour of wooden panels where nothing is said of their wood."""

AT_WALL = 0.3
"""Distance [m] of the back of a piece from its wall at most."""


def finished(
    room: Room, room_type: RoomType, palette: Palette, seed: int, text: str = "", colors: Sequence[str] = ()
) -> Room:
    """The room with the paint, accent wall, tiles and floor of its palette.

    ``text`` is the request: "navy walls" and "a red accent wall" are painted so, "an oak floor" is laid. ``colors``
    are those that it names for the room: where the palette has one of them as its accent, a wall shows it.
    """
    said = stated_finish(text)
    usual = floor_for(room_type.name, room_type.floor, seed)
    tone = said.woods[0] if usual == "wood" and said.woods else palette.floors.get(usual)
    floor = said.floor or FloorFinish(material=usual, tone=tone)
    tiles = room_type.tiles
    kind = accent_for(room_type.name, seed)
    wall = accent_wall(room)
    accent = None
    if said.panelled:
        color = color_name(finish_named(said.woods[0]).material.color) if said.woods else PANELS
        accent = WallAccent(kind="panelling", color=said.walls or color, walls=tuple(w.index for w in room.walls))
    elif said.accent is not None and wall is not None:
        accent = WallAccent(kind="paint", color=said.accent, walls=(wall,))
    elif palette.accent in colors and wall is not None and tiles is None and said.walls is None:
        accent = WallAccent(kind="paint" if kind == "plain" else kind, color=palette.accent, walls=(wall,))
    elif kind != "plain" and tiles is None and wall is not None and said.walls is None:
        accent = WallAccent(kind=kind, color=palette.accent, walls=(wall,))
    finish = RoomFinish(
        walls=said.walls or palette.walls,
        floor=floor,
        accent=accent,
        tiles=None if tiles is None else WallTiles(color=tile_color(palette), low=tiles[0], high=tiles[1]),
    )
    return room.model_copy(update={"finish": finish})


def accented(scene: Scene) -> Scene:
    """The scene with its accent on the wall behind its main piece: the largest bed, sofa or desk with its back at one.

    Without such a piece, or where there is no accent or one on several walls, it stays as it is.
    """
    room, finish = scene.room, scene.room.finish
    if finish is None or finish.accent is None or len(finish.accent.walls) > 1:
        return scene
    main = [o for o in scene.objects if o.mount == "floor" and has_role(o.category, "main_piece")]
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
