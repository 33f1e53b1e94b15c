"""What floors and walls are made of: chosen by the scene's provenance, else by the kind of room."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass

from sceneweaver.assets.body import Material
from sceneweaver.assets.materials import color_named, tinted
from sceneweaver.scene import InputError, Scene

FLOORS = ("wood", "tile", "carpet", "concrete", "stone")

_BY_WORD = {
    "tile": "bathroom toilet kitchen laundry restroom washroom hospital clinic dentist bakery cafe canteen laboratory "
    "examination supermarket",
    "carpet": "office meeting conference hotel cinema theater lecture library waiting computer",
    "concrete": "garage storage warehouse workshop gym server basement hall",
    "stone": "lobby reception museum gallery bank",
}
_FLOOR_OF = {word: floor for floor, words in _BY_WORD.items() for word in words.split()}
_PAINT = Material("wall paint", (0.905, 0.89, 0.865), roughness=0.95)


@dataclass(frozen=True)
class Finishes:
    """Materials of the shell: ``floor`` names the way it is laid, ``wall`` is the paint inside."""

    floor: str
    wall: Material
    outside: Material = Material("wall outside", (0.88, 0.87, 0.85), roughness=0.95)
    cut: Material = Material("wall cut", (0.83, 0.82, 0.80), roughness=0.9)
    trim: Material = Material("trim", (0.95, 0.945, 0.93), roughness=0.55)
    leaf: Material = Material("door leaf", (0.73, 0.57, 0.41), roughness=0.5, texture="wood")
    metal: Material = Material("door handle", (0.74, 0.74, 0.75), roughness=0.3, metallic=1.0)
    glass: Material = Material("pane", (0.82, 0.92, 0.97), roughness=0.06, opacity=0.12)
    daylight: Material = Material("daylight", (0.87, 0.94, 1.0), roughness=1.0, emission=0.62)


def finishes_of(scene: Scene, cut: tuple[float, float, float] | None = None) -> Finishes:
    """The finishes of a scene's room; ``cut`` is the sRGB colour of walls where they are cut.

    Raises:
        InputError: for a floor or a wall colour that ``scene.provenance["finish"]`` names and nobody knows.
    """
    said = scene.provenance.get("finish")
    said = said if isinstance(said, dict) else {}
    floor = said.get("floor") or _floor_for(scene.room.type)
    if floor not in FLOORS:
        raise InputError(f"provenance.finish.floor: '{floor}' is unknown; use one of {', '.join(FLOORS)}")
    wall = _PAINT
    color = said.get("walls")
    if color:
        try:
            wall = _softened(tinted(_PAINT, color_named(str(color))))
        except InputError as error:
            raise InputError(f"provenance.finish.walls: {str(error).removeprefix('color: ')}") from None
    more = {} if cut is None else {"cut": Material("wall cut", cut, roughness=0.9)}
    return Finishes(str(floor), wall, **more)


def _floor_for(room_type: str) -> str:
    words = room_type.lower().replace("_", " ").replace("-", " ").split()
    return next((_FLOOR_OF[word] for word in words if word in _FLOOR_OF), "wood")


def _softened(paint: Material) -> Material:
    """Wall paint is never as strong as a colour card: large areas of a colour look twice as strong."""
    h, light, s = colorsys.rgb_to_hls(*paint.color)
    light = 0.5 * light + 0.5 * max(light, 0.86) if light > 0.45 else 0.55 * light + 0.45 * 0.62
    r, g, b = colorsys.hls_to_rgb(h, min(light, 0.935), 0.75 * s)
    return Material(f"{paint.name} wall", (round(r, 4), round(g, 4), round(b, 4)), roughness=0.95)
