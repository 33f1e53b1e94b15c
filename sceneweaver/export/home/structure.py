"""What of a home stands still, as convex bodies in the home's frame: walls around openings, decks, ceilings, stairs.

Walls are there once, however many rooms they part: their plan less the openings and the pockets of sliding doors as
pieces from floor to ceiling, and what is over and under each opening. Everything is in metres.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.geometry.shell import FLOOR_THICKNESS, PANE_THICKNESS, heights
from sceneweaver.home import Home, HomeDoor, HomeWindow, Storey, WallOpening, wall_openings, wall_polygons
from sceneweaver.home.treads import treads
from sceneweaver.physics.enclosure import Standing
from sceneweaver.physics.leaves import Leaf

from .doors import Pocket, leaves_of, pocket_of
from .names import HomeNames
from .pieces import convex_pieces, standing

RAILING = (0.05, 1.0)
"""Thickness and height of the railings of balconies [m]."""

_OVER = 1e-3  # [m] by which openings reach out of the wall, so that no film is left
_STEP = 0.2  # [m] that the body of a tread reaches below the one before


@dataclass(frozen=True, eq=False)
class StoreyPlan:
    """A storey in plan: ``walls`` less ``cuts`` go from floor to ceiling; all are shapely geometries.

    Attributes:
        storey: Whose plan it is.
        rooms: The clear floors indoors, by the id of the room.
        outdoors: The same of balconies.
        walls: Walls as if they had no openings.
        openings: Doors and windows with their rectangles through the walls.
        pockets: Of sliding doors, by the id of the door.
        holes: Where stairs come up.
    """

    storey: Storey
    rooms: dict[str, Any]
    outdoors: dict[str, Any]
    walls: Any
    openings: tuple[WallOpening, ...]
    pockets: dict[str, Pocket]
    holes: Any

    @property
    def low(self) -> float:
        """Of the floor [m]."""
        return self.storey.elevation

    @property
    def high(self) -> float:
        """Of the ceiling [m]."""
        return self.storey.elevation + self.storey.height

    @cached_property
    def footprint(self) -> Any:
        """All that is indoors, with the walls, and balconies."""
        import shapely

        return shapely.union_all([self.walls, *self.rooms.values(), *self.outdoors.values()])

    def hole(self, opening: WallOpening) -> Any:
        """The plan of an opening, reaching a little out of the wall on both sides."""
        return _reaching(opening)

    @cached_property
    def solid(self) -> Any:
        """Walls from floor to ceiling."""
        import shapely

        cuts = [*map(self.hole, self.openings), *(p.plan for p in self.pockets.values())]
        return self.walls.difference(shapely.union_all(cuts)) if cuts else self.walls

    def railings(self) -> dict[str, Any]:
        """The plan of the railing of each balcony."""
        import shapely

        thick, found = RAILING[0], {}
        doors = [_reaching(o, thick + _OVER) for o in self.openings if isinstance(o.opening, HomeDoor)]
        taken = shapely.union_all([self.walls, *self.rooms.values(), *self.outdoors.values(), *doors])
        for room, floor in self.outdoors.items():
            plan = floor.buffer(thick, join_style="mitre").difference(taken)
            if not plan.is_empty:
                found[room] = plan
        return found


def storey_plans(home: Home) -> list[StoreyPlan]:
    """The plans of all storeys, from below."""
    return [_plan(home, storey) for storey in home.storeys]


def _plan(home: Home, storey: Storey) -> StoreyPlan:
    import shapely

    here = home.rooms_of(storey.id)
    walls = shapely.union_all(wall_polygons(home, storey.id))
    openings = tuple(wall_openings(home, storey.id))
    free = walls.difference(shapely.union_all([_reaching(o) for o in openings])) if openings else walls
    shapely.prepare(free)
    pockets = {}
    for opening in openings:
        found = pocket_of(home, opening, free)
        if found is not None:
            pockets[opening.opening.id] = found
    ids = {room.id for room in here}
    steps = [shapely.Polygon(t.plan) for s in home.stairs if s.upper in ids for t in treads(s)]
    return StoreyPlan(
        storey,
        {r.id: shapely.Polygon(r.outline) for r in here if not r.outdoor},
        {r.id: shapely.Polygon(r.outline) for r in here if r.outdoor},
        walls,
        openings,
        pockets,
        shapely.union_all(steps),
    )


def _reaching(opening: WallOpening, over: float = _OVER) -> Any:
    import shapely

    a, b, c, d = (np.asarray(corner) for corner in opening.corners)
    out = (a - d) / np.linalg.norm(a - d) * over
    return shapely.Polygon([a + out, b + out, c - out, d - out])


def wall_bodies(plan: StoreyPlan, names: HomeNames) -> list[Standing]:
    """The walls of a storey, ``home:wall:<storey>:<k>``, and over and under openings ``home:opening:<id>``."""
    stem = f"{names.home}:wall:{plan.storey.id}"
    found = [standing(f"{stem}:{k}", piece, (plan.low, plan.high)) for k, piece in enumerate(convex_pieces(plan.solid))]
    for opening in plan.openings:
        thing = opening.opening
        low, high = (plan.low + z for z in heights(thing))
        levels = [(a, b) for a, b in ((plan.low, low), (high, plan.high)) if b - a > 1e-4]
        rest = plan.walls.intersection(plan.hole(opening)).difference(_pockets_but(plan, thing.id))
        for k, piece in enumerate(convex_pieces(rest)):
            made = standing(f"{names.home}:opening:{thing.id}" + (f":{k}" if k else ""), piece, *levels or [(low, low)])
            slabs = made.slabs if levels else ()
            if isinstance(thing, HomeWindow) and not k:
                slabs = (*slabs, *standing("", _pane(opening), (low, high), pane=True).slabs)
            if slabs:
                found.append(Standing(made.name, slabs, yaw=made.yaw))
        pocket = plan.pockets.get(thing.id)
        if pocket is not None and high < plan.high - 1e-4:
            inside = plan.walls.intersection(pocket.plan).difference(plan.hole(opening))
            for k, piece in enumerate(convex_pieces(inside)):
                found.append(standing(f"{names.home}:pocket:{thing.id}:{k}", piece, (high, plan.high)))
    return found


def _pockets_but(plan: StoreyPlan, door: str) -> Any:
    """Pockets of other doors: their plans are bodies of their own."""
    import shapely

    return shapely.union_all([p.plan for name, p in plan.pockets.items() if name != door])


def _pane(opening: WallOpening) -> np.ndarray:
    """The plan [4, 2] of the pane of a window, at the room's face of the wall."""
    a, b, c, d = (np.asarray(corner) for corner in opening.corners)
    out = (a - d) / np.linalg.norm(a - d) * PANE_THICKNESS
    return np.array([d + out, c + out, c, d])


def deck(plan: StoreyPlan, below: StoreyPlan) -> tuple[Any, float]:
    """The plan of the floor of an upper storey, less where stairs come up, and its underside [m]."""
    return plan.footprint.difference(plan.holes), min(below.high, plan.low - FLOOR_THICKNESS)


def ceiling(plan: StoreyPlan, above: StoreyPlan | None) -> Any:
    """The plan of what closes a storey where no other is above it."""
    import shapely

    roofed = shapely.union_all([plan.walls, *plan.rooms.values()])
    return roofed if above is None else roofed.difference(above.footprint)


def fixed_bodies(home: Home, plans: list[StoreyPlan], names: HomeNames) -> list[Standing]:
    """Decks, ceilings, railings and stairs; the ground floor goes on outside, and is none of them."""
    found = []
    for k, plan in enumerate(plans):
        name = plan.storey.id
        if k:
            floor, low = deck(plan, plans[k - 1])
            for n, piece in enumerate(convex_pieces(floor)):
                found.append(standing(f"{names.home}:floor:{name}:{n}", piece, (low, plan.low)))
        above = plans[k + 1] if k + 1 < len(plans) else None
        for n, piece in enumerate(convex_pieces(ceiling(plan, above))):
            found.append(standing(f"{names.home}:ceiling:{name}:{n}", piece, (plan.high, plan.high + FLOOR_THICKNESS)))
        for room, rail in plan.railings().items():
            for n, piece in enumerate(convex_pieces(rail)):
                found.append(standing(f"{names.home}:railing:{room}:{n}", piece, (plan.low, plan.low + RAILING[1])))
    for stair, steps in stair_steps(home).items():
        for n, (step, low, high) in enumerate(steps, 1):
            found.append(standing(f"{names.home}:stair:{stair}:{n}", step, (low, high)))
    return found


def stair_steps(home: Home) -> dict[str, list[tuple[np.ndarray, float, float]]]:
    """For each stair its treads and landings from below: plan [4, 2], and from and to which height they are solid."""
    found = {}
    for stair in home.stairs:
        low, high = home.storey_of(stair.lower).elevation, home.storey_of(stair.upper).elevation
        rise = (high - low) / stair.risers
        tops = [(tread.plan, low + tread.number * rise) for tread in treads(stair)]
        found[stair.id] = [(plan, max(low, top - rise - _STEP), top) for plan, top in tops]
    return found


def home_leaves(home: Home, plan: StoreyPlan, names: HomeNames) -> list[Leaf]:
    """The leaves of all doors of a storey, ``home:door:<id>``; of double ones ``.left`` and ``.right``."""
    import shapely

    doors = [o for o in plan.openings if isinstance(o.opening, HomeDoor)]
    pockets = [p.plan for p in plan.pockets.values()]
    blocks = plan.walls.difference(shapely.union_all([*map(plan.hole, doors), *pockets]))
    shapely.prepare(blocks)
    found = []
    for opening in doors:
        name = f"{names.home}:door:{opening.opening.id}"
        found += leaves_of(home, opening, plan.pockets.get(opening.opening.id), blocks, name)
    return found
