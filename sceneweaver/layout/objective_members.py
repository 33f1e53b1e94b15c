"""What the members of objectives are in a scene: places with their middles, pins, and what covers walls."""

from __future__ import annotations

from typing import NamedTuple

from sceneweaver.geometry.shell import heights
from sceneweaver.scene import Scene, SceneObject

from .objective import ObjectiveTerm

APPROACH = 0.3
"""[m] before the side of an object at which a way to it ends."""

DOORSTEP = 0.5
"""[m] inside of a door or before a window, where ways begin."""

LAMP = 800.0
"""[lm] that a lamp gives where nothing is said: an LED bulb that replaces one of 60 W."""

DAYLIGHT = 2_000.0
"""[lm] that a square metre of window gives where nothing is said: an overcast sky of some 5,000 lx, seen by half."""


class Place(NamedTuple):
    """A door, window or wall: its middle, the way into the room, half its width, and its heights [m]."""

    middle: tuple[float, float]
    inward: tuple[float, float]
    half: float
    z: tuple[float, float]


def places_of(scene: Scene) -> dict[str, Place]:
    """Doors, windows and walls ("wall:k") of a scene by name."""
    found, walls = {}, scene.room.walls
    for opening in scene.room.openings:
        wall = walls[opening.wall]
        middle = wall.point(opening.offset + opening.width / 2)
        found[opening.id] = Place(middle, wall.inward, opening.width / 2, heights(opening))
    for k, wall in enumerate(walls):
        found[f"wall:{k}"] = Place(wall.point(wall.length / 2), wall.inward, wall.length / 2, (0.0, scene.room.height))
    return found


def members_of(scene: Scene, term: ObjectiveTerm) -> list[str]:
    """Names of a term's members; of walls also what may cover them: all that no other object carries, nor a ceiling."""
    if term.kind != "exposed_wall":
        return list(term.objects)
    walls = list(term.objects) or [f"wall:{k}" for k in range(len(scene.room.walls))]
    return [*walls, *(o.id for o in scene.objects if o.support is None and o.mount != "ceiling")]


def pins_of(scene: Scene, term: ObjectiveTerm) -> list[tuple[float, float, float]]:
    """The pin (x, y, z) [m] of each member in its own frame; of a place x is into the room."""
    names, things, places = members_of(scene, term), {o.id: o for o in scene.objects}, places_of(scene)
    if term.kind == "wire_length":
        return [(x, y, 0.0) for x, y in term.pins]
    if term.kind == "walking":
        sides = term.value("sides") or (0, 0)
        return [
            (DOORSTEP, 0.0, 0.0) if name in places else _before(things[name], side)
            for name, side in zip(names, sides, strict=True)
        ]
    if term.kind == "light":
        height = term.value("height")
        first = names[0]
        top = places[first].z[0] if first in places else things[first].size[2]
        lit = (0.0, 0.0, float(top if height is None else height))
        return [lit, *(_lamp(things[n]) if n in things else (0.0, 0.0, sum(places[n].z) / 2) for n in names[1:])]
    return [(0.0, 0.0, 0.0)] * len(names)


def fluxes_of(scene: Scene, term: ObjectiveTerm) -> list[float]:
    """Luminous flux [lm] of each member of a term; 0 of what gives no light."""
    names = members_of(scene, term)
    if term.kind != "light":
        return [0.0] * len(names)
    places, given = places_of(scene), term.value("flux")
    found = [0.0]
    for k, name in enumerate(names[1:]):
        if given is not None:
            found.append(float(given[k] if isinstance(given, list | tuple) else given))
        elif name in places:
            place = places[name]
            found.append(DAYLIGHT * 2.0 * place.half * (place.z[1] - place.z[0]))
        else:
            found.append(LAMP)
    return found


def _before(obj: SceneObject, side: int) -> tuple[float, float, float]:
    reach = obj.size[0] / 2 if side in (0, 2) else obj.size[1] / 2
    x, y = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[side]
    return (reach + APPROACH) * x, (reach + APPROACH) * y, 0.0


def _lamp(obj: SceneObject) -> tuple[float, float, float]:
    """Where a lamp gives its light: at its top, hung from a ceiling at its lowest point."""
    return 0.0, 0.0, 0.0 if obj.mount == "ceiling" else obj.size[2]
