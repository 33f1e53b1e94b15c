"""Walls and floor of a room that is drawn: by the palette of the room, with a tiled band where there is water."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import dot
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.looks import Look
from sceneweaver.knowledge.palettes import Palette, accent_for, floor_for
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import StatedFinish
from sceneweaver.scene import CeilingFinish, Room, RoomFinish, RoomLight, Scene, WallAccent, WallTiles
from sceneweaver.scene.finish import FloorFinish, FloorMaterial, FloorPattern, WallMaterial, WallPattern

from .look import is_electric, look_of
from .relations import wall_named
from .unwanted_looks import cleaned

PANELS = "walnut"
"""Finish of wooden panels where nothing is said of their wood."""

PANELLED = 9.0
"""Height [m] of panels where nothing is said of it: up to the ceiling."""

AT_WALL = 0.3
"""Distance [m] of the back of a piece from its wall at most."""


def finished(room: Room, room_type: RoomType, palette: Palette, seed: int, brief: SceneGraph | None = None) -> Room:
    """The room with the paint, accent wall, tiles, floor, ceiling and light of its palette.

    ``brief`` is the request: what it states of a part of the room is done so, what it says of the look of the whole
    room comes next. Of the colours that it names for the room one that the palette has as its accent shows on a wall.
    A room that has a finish keeps it.
    """
    if room.finish is not None:
        return room
    brief = brief or SceneGraph(text=" ")
    look = look_of(brief) or Look(name="", kind="style")
    said = brief.finish_of
    walls, every = _walls(said("walls"), look, palette), tuple(wall.index for wall in room.walls)
    usual = room_type.tiles if said("panels") is None and walls["walls_of"] in ("plaster", "paper") else None
    usual = usual if said("lower") is None else None
    tiles, whole = _tiles(said("tiled"), usual, palette, room), said("everything")
    finish = RoomFinish(
        **walls,
        floor=_floor(said("floor"), look, palette, room_type, seed, _woods(brief)),
        accent=_accent(brief, look, palette, room, room_type, seed, every, tiles is not None),
        tiles=tiles,
        ceiling=_ceiling(said("ceiling") or whole, said("beams"), look),
        trim=look.trim if whole is None else whole.color,
        doors=doors.color if (doors := said("doors")) is not None else None,
        electric=is_electric(brief),
    )
    update: dict[str, object] = {"finish": cleaned(finish, brief)}
    if (light := light_of(look)) is not None:
        update["light"] = light
    return room.model_copy(update=update)


def _tiles(
    said: StatedFinish | None, usual: tuple[float, float] | None, palette: Palette, room: Room
) -> WallTiles | None:
    """The band of tiles that is asked for, else the one that such rooms have."""
    if said is not None:
        high = min(said.high or room.height, room.height)
        pattern = cast("WallPattern | None", said.pattern)
        return WallTiles(color=said.color or tile_color(palette), high=high, pattern=pattern, second=said.second)
    return None if usual is None else WallTiles(color=tile_color(palette), low=usual[0], high=usual[1])


def light_of(look: Look) -> RoomLight | None:
    """The light that a look asks for; None where it says nothing of it."""
    said = look.light.model_dump(exclude_none=True)
    return RoomLight(**said) if said else None


def _walls(said: StatedFinish | None, look: Look, palette: Palette) -> dict[str, Any]:
    """Colour and material of the walls."""
    own = look.walls.of if look.walls is not None else "plaster"
    of = "rough plaster" if own == "rough" else own
    if said is None:
        return {"walls": palette.walls, "walls_of": of}
    painted = "paper" if of == "paper" else "plaster"
    printed = {"walls_pattern": said.pattern, "walls_second": said.second} if said.pattern is not None else {}
    return {
        "walls": said.color or palette.walls,
        "walls_of": said.material or (painted if said.color else of),
        **printed,
    }


def _floor(
    said: StatedFinish | None, look: Look, palette: Palette, room_type: RoomType, seed: int, woods: Sequence[str]
) -> FloorFinish:
    if said is not None:
        material = cast("FloorMaterial", said.material or "tile")
        pattern = cast("FloorPattern | None", said.pattern)
        tone = said.color or (None if pattern is None else palette.floors.get(material))
        return FloorFinish(material=material, tone=tone, pattern=pattern, second=said.second)
    usual = floor_for(room_type.name, room_type.floor, seed)
    if look.floor is not None and not (room_type.tiles and look.floor.material in ("carpet", "wood")):
        usual = look.floor.material
    return FloorFinish(material=usual, tone=woods[0] if usual == "wood" and woods else palette.floors.get(usual))


def _woods(brief: SceneGraph) -> list[str]:
    return [one.color for one in brief.finishes if one.part == "furniture" and one.color]


def _accent(
    brief: SceneGraph,
    look: Look,
    palette: Palette,
    room: Room,
    room_type: RoomType,
    seed: int,
    every: tuple[int, ...],
    tiled: bool,
) -> WallAccent | None:
    """What is done otherwise on some walls, or on all up to some height."""
    panels, lower, said = (brief.finish_of(part) for part in ("panels", "lower", "accent"))
    if panels is not None:
        wood = panels.color or next(iter(_woods(brief)), None) or next(iter(look.woods), PANELS)
        return WallAccent(kind="panelling", color=wood, walls=every, high=min(panels.high or PANELLED, room.height))
    if lower is not None and lower.color is not None:
        return _stated(lower, every, min(lower.high or room.height, room.height))
    wall = accent_wall(room)
    if said is not None and said.color is not None:
        if said.where != "any":
            wall = wall_named(said.where, room)
        if wall is None:
            wall = max(room.walls, key=lambda one: one.length).index
        return _stated(said, (wall,), None)
    if brief.finish_of("walls") is not None or tiled:
        return None
    if look.panels is not None:
        return WallAccent(
            kind="panelling", color=look.panels.color, walls=every, high=min(look.panels.high, room.height)
        )
    if look.accent is not None:
        high = None if look.accent.high is None else min(look.accent.high, room.height)
        color = brief.colors[0] if brief.colors and palette.accent in brief.colors else look.accent.color
        return WallAccent(kind=look.accent.kind, color=color, walls=(wall,), high=high) if wall is not None else None
    kind = accent_for(room_type.name, seed)
    if wall is None:
        return None
    if palette.accent in brief.colors:
        return WallAccent(kind="paint" if kind == "plain" else kind, color=palette.accent, walls=(wall,))
    if kind != "plain" and look.walls is None:
        return WallAccent(kind=kind, color=palette.accent, walls=(wall,))
    return None


def _stated(said: StatedFinish, walls: tuple[int, ...], high: float | None) -> WallAccent:
    """Walls, or a band of all, as the request has them."""
    of = cast("WallMaterial | None", said.material if said.material not in ("plaster", "paper") else None)
    kind = "paper" if said.material == "paper" else "paint"
    pattern = cast("WallPattern | None", said.pattern)
    return WallAccent(
        kind=kind, color=said.color or "white", walls=walls, high=high, of=of, pattern=pattern, second=said.second
    )


def _ceiling(said: StatedFinish | None, beams: StatedFinish | None, look: Look) -> CeilingFinish | None:
    own = look.ceiling
    if said is None and beams is None and own is None:
        return None
    material = (said and said.material) or (own.of if own is not None and said is None else "plaster")
    color = (said and said.color) or (own.color if own is not None and said is None else "white")
    wood = (beams and (beams.color or "dark oak")) or (own.beams if own is not None else None)
    return CeilingFinish(material=cast("WallMaterial", material), color=color, beams=wood)


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
