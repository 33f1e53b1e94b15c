"""What each family of problems is made of: the rows of ``recipes.yaml``."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from sceneweaver.io import packaged
from sceneweaver.scene import InputError

from . import units
from .units import Unit

DATA: dict[str, Any] = packaged.yaml_data(__package__ or "", "recipes.yaml")

MOST_SEED = 2**32 - 1


@dataclass(frozen=True)
class Recipe:
    """A family that can be generated; ``recipes.yaml`` says what its fields are."""

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


def _unit(row: dict[str, Any]) -> Unit:
    fill = getattr(units, row["fill"])
    return Unit(row["objects"], row["area"], partial(fill, **row["with"]) if "with" in row else fill)


UNITS: dict[str, Unit] = {name: _unit(row) for name, row in DATA["units"].items()}

RECIPES: dict[str, Recipe] = {
    name: Recipe(**{**row, "units": tuple((UNITS[unit], share) for unit, share in row["units"].items())})
    for name, row in DATA["families"].items()
}


def whole_number(what: str, value: Any, least: int, most: int) -> int:
    """An argument that has to be a whole number.

    Raises:
        InputError: it is not one from ``least`` to ``most``.
    """
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not least <= value <= most:
        words = "2**32 - 1" if most == MOST_SEED else str(most)
        raise InputError(f"{what}: {value!r} is not a whole number from {least} to {words}")
    return int(value)


def families() -> dict[str, str]:
    """What each family is, in one line, by name.

    Examples:
        >>> from sceneweaver import problems
        >>> problems.families()["packing"]
        'Boxes and nothing else: no relations, tightness is all.'
    """
    about = {name: recipe.about for name, recipe in RECIPES.items()} | DATA["others"]
    return {name: about[name] for name in sorted(about)}
