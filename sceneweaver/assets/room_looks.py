"""Materials of a room's walls and floor: by its finish, else by the kind of room."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass, replace

from sceneweaver.scene import FloorFinish, InputError, Room, WallAccent, WallTiles
from sceneweaver.scene.finish import WallPattern

from .body import Material
from .materials import finishes, shade
from .textures.patterns.two_colors import PRINTS, Color, mean_of, name_of

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
    ceiling: Material | None = None
    beams: Material | None = None
    trim: Material | None = None
    doors: Material | None = None


def room_looks(room: Room) -> RoomLooks:
    """The materials of a room.

    Raises:
        InputError: for a colour or a wood of ``room.finish`` that nobody knows.
    """
    finish = room.finish
    if finish is None:
        kind = _floor_for(room.type)
        return RoomLooks(kind, _FLOOR_LOOKS[kind], PAINT)
    kind = finish.floor.material
    accent, above, tiles = finish.accent, finish.ceiling, finish.tiles
    return RoomLooks(
        kind,
        _floor(finish.floor),
        _patterned(
            _wall(finish.walls, "walls", 0.5, finish.walls_of), finish.walls, finish.walls_pattern, finish.walls_second
        ),
        accent and _accent(accent),
        tiles and _tiles(tiles),
        above and replace(_wall(above.color, "ceiling.color", 0.3, above.material), name="ceiling"),
        _of(above.beams, "ceiling.beams") if above is not None and above.beams else None,
        replace(_of(finish.trim, "trim"), name="trim") if finish.trim else None,
        replace(_of(finish.doors, "doors"), name="door leaf") if finish.doors else None,
    )


def _floor(floor: FloorFinish) -> Material:
    """The material of a floor."""
    look = _FLOOR_LOOKS[floor.material]
    if floor.pattern is not None and floor.pattern != "checkered":
        look = replace(look, texture=_LAID.get(floor.pattern, floor.pattern))
    if floor.tone is not None:
        look = replace(look, name=f"{floor.tone} floor", color=_floor_color(floor.tone))
    if floor.pattern == "checkered":
        first, second = _shade(floor.tone or "black", "floor.tone"), _shade(floor.second or "white", "floor.second")
        look = _two_colored(replace(look, roughness=0.3), "checkered", first, second)
    elif floor.pattern in (*PRINTS, "stripes"):
        first, second = _shade(floor.tone or "navy", "floor.tone"), _shade(floor.second or "cream", "floor.second")
        look = _two_colored(look, floor.pattern, first, second)
    return look


_LAID = {"earth": "soil", "pebbles": "rubble", "smooth": "plastic"}
"""Textures of floors that go by another name."""


def _accent(accent: WallAccent) -> Material:
    """The material of walls that are done otherwise."""
    if accent.kind == "panelling":
        return _wall(accent.color, "accent.color", 0.3, "boards")
    pattern = accent.pattern or ("stripes" if accent.kind == "paper" else None)
    made = _wall(accent.color, "accent.color", 0.3, accent.of or "plaster")
    return _patterned(made, accent.color, pattern, accent.second)


def _tiles(tiles: WallTiles) -> Material:
    """The material of a band of tiles."""
    made = replace(_painted(tiles.color, "tiles.color", 0.3), name="wall tile", roughness=0.25, texture="wall tiles")
    return _patterned(made, tiles.color, tiles.pattern, tiles.second)


def _patterned(made: Material, color: str, pattern: WallPattern | None, second: str | None) -> Material:
    """A material with another pattern; checks and stripes may have a colour of their own."""
    if pattern is None:
        return made
    if second is not None and pattern in ("stripes", "checkered"):
        return _two_colored(made, pattern, _shade(color, "walls"), _shade(second, "walls_second"))
    if pattern == "checkered":
        return _two_colored(made, pattern, _shade(color, "walls"), _shade("white", "walls_second"))
    return replace(made, texture=pattern)


def _two_colored(made: Material, pattern: str, first: Color, second: Color) -> Material:
    return replace(made, color=mean_of(pattern, first, second), texture=name_of(pattern, first, second))


def wall_look(room: Room, wall: int) -> Material:
    """The one material that stands for a whole wall, where it is drawn as one face."""
    looks, finish = room_looks(room), room.finish
    if finish is None:
        return looks.wall
    tiles = finish.tiles
    if looks.tiles and tiles and tiles.high - tiles.low > 0.6 * room.height and wall in (tiles.walls or (wall,)):
        return looks.tiles
    accent = finish.accent
    whole = accent is not None and accent.kind != "panelling" and (accent.high or room.height) >= room.height
    if looks.accent and accent and wall in accent.walls and whole:
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


def _of(name: str, field: str) -> Material:
    """A finish by its name, or lacquer in a colour."""
    known = finishes().get(name)
    return known.material if known is not None else Material(f"{name} lacquer", _shade(name, field), roughness=0.5)


_SHOWN = {
    "rough plaster": ("rough plaster", 0.98, 0.0),
    "concrete": ("concrete", 0.9, 0.0),
    "brick": ("brick", 0.9, 0.0),
    "stone": ("rubble", 0.95, 0.0),
    "boards": ("floorboards", 0.65, 0.0),
    "logs": ("floorboards", 0.8, 0.0),
    "metal": ("cast", 0.42, 0.35),
    "tiles": ("wall tiles", 0.2, 0.0),
}
"""Pattern, roughness and metallic of what walls show but paint and paper."""


def _wall(color: str, field: str, softer: float, of: str) -> Material:
    """What a wall or a ceiling of a material and a colour, or of a wood, looks like."""
    wood = finishes().get(color)
    if wood is not None and wood.family != "wood":
        wood = None
    if of in ("plaster", "paper", "rough plaster"):
        if wood is not None:
            return replace(wood.material, name=f"{color} wall")
        made = _painted(color, field, softer if of == "plaster" else 0.5 * softer)
        return replace(made, texture={"paper": "damask"}.get(of, of))
    texture, rough, metallic = _SHOWN[of]
    shown = wood.material.color if wood is not None else _shade(color, field)
    return Material(f"{color} {of} wall", shown, roughness=rough, metallic=metallic, texture=texture)


def _painted(color: str, field: str, softer: float) -> Material:
    """Wall paint is never as strong as a colour card, as large areas look twice as strong: ``softer`` of the way to a
    pale one."""
    h, light, s = colorsys.rgb_to_hls(*_shade(color, field))
    pale = max(light, 0.86) if light > 0.45 else 0.62
    softer *= min(1.0, max(0.25, (light - 0.1) / 0.35))  # dark paint is wanted dark: black walls are black
    light = min((1 - softer) * light + softer * pale, 0.935)
    r, g, b = colorsys.hls_to_rgb(h, light, (1 - 0.5 * softer) * s)
    return Material(f"{color} wall", (round(r, 4), round(g, 4), round(b, 4)), roughness=0.95, texture="plaster")


def _shade(color: str, field: str) -> tuple[float, float, float]:
    try:
        return shade(color)
    except InputError as error:
        raise InputError(f"room.finish.{field}: {str(error).removeprefix('color: ')}") from None
