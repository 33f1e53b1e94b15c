"""Whole homes: rooms on storeys, the doors, windows and stairs that join them, and the walls between."""

from .grid import GRID, millimetres, on_grid
from .io import EXAMPLES, SCHEMA, is_home
from .model import Home
from .parts import DoorKind, HomeDoor, HomeRoom, HomeWindow, Stair, Storey, WallThickness
from .shells import place_in, swing_in
from .wall_polygons import WallOpening, wall_openings, wall_polygons

__all__ = [
    "EXAMPLES",
    "GRID",
    "SCHEMA",
    "DoorKind",
    "Home",
    "HomeDoor",
    "HomeRoom",
    "HomeWindow",
    "Stair",
    "Storey",
    "WallOpening",
    "WallThickness",
    "is_home",
    "millimetres",
    "on_grid",
    "place_in",
    "swing_in",
    "wall_openings",
    "wall_polygons",
]
