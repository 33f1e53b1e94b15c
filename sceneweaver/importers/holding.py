"""What holds each imported object: the floor, a wall, the ceiling, or a surface of another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import Room, SceneObject, Support, Surface

from .model import SourceObject

NEAR = 0.08
"""Distance [m] within which something counts as touching floor, wall, ceiling or board: files are not exact."""

SAID = 0.3
"""As `NEAR`, where the file itself says what carries it."""


def hold(things: Sequence[tuple[SourceObject, SceneObject]], ids: Mapping[str, str], room: Room) -> list[SceneObject]:
    """The objects with mount and support: as the file says, else as the geometry says.

    Args:
        things: each object as the file has it and as it stands in the scene, with its surfaces.
        ids: ids in the scene by names in the file.
        room: with its walls.
    """
    bodies = [thing for _, thing in things]
    done: list[SceneObject] = []
    for source, thing in things:
        said = ids.get(source.support or "")
        carrier = _carrier(thing, [b for b in bodies if b.id == said], SAID) if said not in (None, thing.id) else None
        usual = category_named(thing.category).mount
        z = thing.pose.position[2]
        if carrier is None and source.mount in (None, "surface") and ("surface" in usual or z > NEAR):
            mine = thing.size[0] * thing.size[1]
            others = [b for b in bodies if b.id != thing.id and b.size[0] * b.size[1] > mine * 0.5]
            carrier = _carrier(thing, others, NEAR)
        if carrier is not None and not _circular(carrier.object, thing.id, done):
            done.append(thing.model_copy(update={"mount": "surface", "support": carrier}))
            continue
        done.append(
            thing.model_copy(
                update={"mount": source.mount if source.mount not in (None, "surface") else _mount(thing, usual, room)}
            )
        )
    return done


def _circular(carrier: str, name: str, done: Sequence[SceneObject]) -> bool:
    """Whether a carrier stands on what it would carry."""
    above = {o.id: o.support.object for o in done if o.support is not None}
    while carrier in above:
        carrier = above[carrier]
        if carrier == name:
            return True
    return False


def _mount(thing: SceneObject, usual: Sequence[str], room: Room) -> str:
    """Floor, wall or ceiling, by where it is among what is usual."""
    z = thing.pose.position[2]
    top = z + thing.size[2]
    if "ceiling" in usual and (top > room.height - SAID or "floor" not in usual and "wall" not in usual):
        return "ceiling"
    if z <= NEAR and "floor" in usual:
        return "floor"
    if "wall" in usual and (_at_wall(thing, room) or "floor" not in usual):
        return "wall"
    return "floor"


def _at_wall(thing: SceneObject, room: Room) -> bool:
    """Whether a side of the box is near the inner face of a wall."""
    frame = thing.pose.frame
    corners = [frame.world(x, y) for x, y in rectangle(*thing.size[:2])]
    for wall in walls_of(room.outline):
        offsets, depths = zip(*(wall.coordinates(c) for c in corners), strict=True)
        if min(depths) < SAID and max(offsets) > 0 and min(offsets) < wall.length:
            return True
    return False


def _carrier(thing: SceneObject, others: Sequence[SceneObject], near: float) -> Support | None:
    """The surface under an object's middle whose height is nearest to its bottom."""
    x, y, z = thing.pose.position
    best: tuple[float, Support] | None = None
    for other in others:
        for surface in other.surfaces:
            gap = abs(other.pose.position[2] + surface.z - z)
            if gap <= near and (best is None or gap < best[0]) and _covers(surface, other, (x, y)):
                best = gap, Support(object=other.id, surface=surface.name)
    return best[1] if best is not None else None


def _covers(surface: Surface, carrier: SceneObject, point: tuple[float, float]) -> bool:
    """Whether a point of the room lies over a surface."""
    import shapely

    x, y = carrier.pose.frame.local(*point)
    return bool(shapely.Polygon(np.asarray(surface.polygon)).buffer(1e-6).covers(shapely.Point(x, y)))
