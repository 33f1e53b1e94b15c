"""What each family of feasible problems is made of."""

from __future__ import annotations

from dataclasses import dataclass

from . import units
from .units import Unit

CRATE = Unit(1, 0.7, units.box)
CABINET = Unit(1, 1.05, units.cabinet)
CORNER = Unit(2, 2.4, units.corner_piece)
ROUND = Unit(1, 0.9, units.octagon)
DESK = Unit(2, 1.5, units.desk)
TWIN = Unit(4, 3.2, units.twin_desks)
TABLE_4 = Unit(5, 2.6, units.table(4))
TABLE_6 = Unit(7, 3.6, units.table(6))
LADEN_TABLE = Unit(7, 1.5, units.laden(1, 6))
LADEN_SHELF = Unit(10, 0.8, units.laden(3, 9))


@dataclass(frozen=True)
class Recipe:
    """A family.

    Attributes:
        about: one line.
        units: what is put into the cells, with how many of a hundred; one of a single object fills up the count.
        at_wall: the chance that a unit in a cell at a wall stands with its back to it, and then has to.
        shapes: the shapes of rooms.
        corridor: only the edge of the room holds cells.
        turned: whether the room is turned out of the axes.
        window: whether there is a window, before which nothing may be taller than its sill.
        density: hard relations an object, those of seats and walls included; 0: only those.
        wishes: soft relations an object, drawn blindly, so that they contradict each other.
        least: the fewest objects.
    """

    about: str
    units: tuple[tuple[Unit, int], ...]
    at_wall: float = 0.0
    shapes: tuple[str, ...] = ("rectangle",)
    corridor: bool = False
    turned: bool = False
    window: bool = False
    density: float = 0.0
    wishes: float = 0.0
    least: int = 2


RECIPES: dict[str, Recipe] = {
    "bodies": Recipe(
        "L-shaped and eight-cornered bodies, boxes in the notches: hulls overlap, bodies do not.",
        ((CORNER, 55), (ROUND, 25), (CRATE, 20)),
        at_wall=0.3,
    ),
    "groups": Recipe(
        "Tables and desks with their seats: what moves together is several objects.",
        ((TABLE_4, 30), (TABLE_6, 15), (TWIN, 25), (DESK, 30)),
        at_wall=0.6,
        window=True,
        least=5,
    ),
    "halls": Recipe(
        "A hundred objects and more of every kind: what a method does when problems are large.",
        ((TABLE_4, 25), (TWIN, 15), (CORNER, 15), (CABINET, 25), (CRATE, 20)),
        at_wall=0.8,
        least=50,
    ),
    "packing": Recipe(
        "Boxes and nothing else: no relations, tightness is all.",
        ((CRATE, 100),),
    ),
    "preferences": Recipe(
        "Soft relations that contradict each other: the question is which layout is best.",
        ((CRATE, 60), (CABINET, 40)),
        at_wall=0.5,
        wishes=1.5,
        least=4,
    ),
    "relations": Recipe(
        "Boxes in a room that is not tight, tied by more and more relations.",
        ((CRATE, 60), (CABINET, 40)),
        at_wall=0.5,
        density=1.0,
    ),
    "rooms": Recipe(
        "Rooms shaped like an L, a T, a U or an S, turned out of the axes.",
        ((CRATE, 35), (CABINET, 40), (DESK, 25)),
        at_wall=0.8,
        shapes=("L", "T", "U", "S"),
        turned=True,
        window=True,
    ),
    "surfaces": Recipe(
        "Tables and shelves with things on their boards: small problems within a large one.",
        ((LADEN_TABLE, 50), (LADEN_SHELF, 50)),
        at_wall=0.6,
        least=7,
    ),
    "walls": Recipe(
        "Cabinets with hard zones, all with their backs to the walls of a narrow room.",
        ((CABINET, 100),),
        at_wall=1.0,
        corridor=True,
        least=4,
    ),
}

OTHERS = {
    "bedrooms": "Bedrooms that are tight to the last: backs to walls, zones, seats, things on furniture.",
    "designs": "Rooms that the agent designed: real furniture, lamps, small things on everything.",
    "infeasible": "No layout is valid, and a certificate says why.",
}


def families() -> dict[str, str]:
    """What each family is, in one line, by name.

    Examples:
        >>> from sceneweaver import problems
        >>> problems.families()["packing"]
        'Boxes and nothing else: no relations, tightness is all.'
    """
    about = {name: recipe.about for name, recipe in RECIPES.items()} | OTHERS
    return {name: about[name] for name in sorted(about)}
