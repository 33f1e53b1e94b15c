"""Door leaves of a home: on hinges in the face of the wall on the side to which they open, or sliding into the wall."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from sceneweaver.geometry.walls import Wall
from sceneweaver.home import Home, HomeDoor, WallOpening
from sceneweaver.physics.leaves import THICK, Leaf, limited, sliding, swinging

_SLOT = 0.06  # [m], width of a pocket: the leaf has a centimetre on each side
_SKIN = 0.01  # [m] of wall that is left on each side of it at least
_LEFT = 0.02  # [m] of a pocket behind the open leaf
_STEP = 0.05  # [m] between the lengths of pockets that are tried
_INSET = 0.003  # [m] between a sliding leaf and the jambs


@dataclass(frozen=True, eq=False)
class Pocket:
    """The slot in a wall that takes a sliding leaf: its ``plan`` (a shapely polygon); ``far``: before the opening."""

    plan: Any
    far: bool


def pocket_of(home: Home, opening: WallOpening, free: Any) -> Pocket | None:
    """The pocket of a sliding door, on the side with more wall; None for other openings.

    ``free`` are the walls of the storey without all openings. Where there is no room on either side, the leaf cannot
    open far, and its pocket is short.
    """
    import shapely

    door = opening.opening
    if not isinstance(door, HomeDoor) or door.kind != "sliding":
        return None
    wall = _wall(home, door)
    width = max(min(_SLOT, opening.thickness - 2 * _SKIN), THICK + 0.002)
    near, deep = -opening.thickness / 2 - width / 2, -opening.thickness / 2 + width / 2
    most = _leaf(home, opening, False, "").limits[1] + _LEFT
    best, found = 0.0, Pocket(shapely.Polygon(), False)
    for far in (False, True):
        length = most
        while length > best:
            start = door.offset - length if far else door.offset + door.width
            plan = shapely.Polygon(wall.strip(start, length, near, deep))
            if plan.difference(free).area < 1e-5:
                # It begins within the opening, so that no film is left between them.
                start = start if far else start - _INSET
                best = length
                found = Pocket(shapely.Polygon(wall.strip(start, length + _INSET, near, deep)), far)
                break
            length -= _STEP
    return found


def leaves_of(home: Home, opening: WallOpening, pocket: Pocket | None, walls: Any, name: str) -> list[Leaf]:
    """The leaves of a door, named so, of double ones with ``.left`` and ``.right``; a passage has none.

    ``walls`` is the plan of the walls of its storey less doorways and pockets, in which leaves stop.
    """
    door = opening.opening
    assert isinstance(door, HomeDoor)
    up = home.storey_of(door.room).elevation
    made: list[Leaf] = []
    if door.kind == "sliding":
        made = [_leaf(home, opening, pocket is not None and pocket.far, name)]
    elif door.kind != "open":
        out = door.opens_into != door.room
        wall, face = _wall(home, door), -opening.thickness if out else 0.0
        # The start of the wall is on the left of somebody who comes into its room.
        sides = ("left", "right") if door.kind == "double" else (door.hinge,)
        for side in sides:
            far = (side == "right") != out
            start, wide = door.offset, door.width
            if door.kind == "double":
                start, wide = start + (wide / 2 if far else 0.0), wide / 2
            title = f"{name}.{side}" if door.kind == "double" else name
            made.append(swinging(wall, (start, wide), door.height, (door.id, title), face, out=out, far=far))
    return [_raised(limited(leaf, walls), up) for leaf in made]


def _leaf(home: Home, opening: WallOpening, far: bool, name: str) -> Leaf:
    """A sliding leaf in the middle of its wall: what goes to the far end of it slides along, else back."""
    door = opening.opening
    assert isinstance(door, HomeDoor)
    span, depths = (door.offset, door.width), (-opening.thickness / 2, 0.0)
    return sliding(_wall(home, door), span, door.height, (door.id, name), depths, -_INSET, far=far)


def _raised(leaf: Leaf, up: float) -> Leaf:
    x, y, z = leaf.position
    return replace(leaf, position=(x, y, z + up))


def _wall(home: Home, door: HomeDoor) -> Wall:
    return home.room(door.room).walls[door.wall]
