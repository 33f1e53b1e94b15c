"""How explanations name objects, relations, surfaces and numbers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from sceneweaver.scene import CATALOGUE, FreeArea, Relation, SceneObject

LINES = 3  # of one kind
FOUND = "(found by search, which is no proof)"


def sized(obj: SceneObject) -> str:
    """An object with its size: "bed-0 (2.00 x 1.60 x 0.50 m)"."""
    return f"{obj.id} ({' x '.join(f'{s:.2f}' for s in obj.size)} m)"


def listed(names: Sequence[str], most: int = 12, joint: str = ", ") -> str:
    """Names in a row, at most so many of them."""
    names = list(names)
    if len(names) > most:
        return f"{joint.join(names[: most - 1])}{joint}and {len(names) - most + 1} more"
    return joint.join(names)


def free_floor_words(areas: Sequence[FreeArea]) -> str:
    """Free areas with their measures and what they are about: "gap-0 (gap of 1.20 m: bed, wall)"."""
    said = []
    for area in areas:
        about = listed([*area.targets, *area.others], 4)
        size = " x ".join(f"{side:.2f}" for side in area.size) if area.kind == "rectangle" else f"{area.size[0]:.2f}"
        said.append(f"{area.id} ({area.kind} of {size} m{': ' + about if about else ''})")
    return listed(said, LINES + 1)


def crowd_words(objects: Sequence[SceneObject]) -> str:
    """A number of objects, by category when they share it."""
    if len(objects) == 1:
        return objects[0].id
    kinds = {o.category for o in objects}
    if len(kinds) == 1:
        return f"{len(objects)} x {kinds.pop()}"
    return f"{len(objects)} objects ({listed([o.id for o in objects], 6)})"


def relation_words(rel: Relation) -> str:
    """A relation with what it sets for itself: "chair-0 near desk-0 (max 0.5 m)"."""
    units = {"m": " m", "deg": " deg", "": ""}
    params = []
    for name, value in rel.params.items():
        numbers = value if isinstance(value, tuple) else (value,)
        text = " to ".join(v if isinstance(v, str) else f"{v:g}" for v in numbers)
        unit = "" if isinstance(value, str) else units.get(CATALOGUE[rel.type].params[name].unit, "")
        params.append(f"{name} {text}{unit}")
    words = " ".join([rel.subject, rel.type, " and ".join(rel.targets)]).rstrip()
    return f"{words} ({', '.join(params)})" if params else words


def short_length(length: float) -> str:
    """A length in metres, to the centimetre when it is tiny."""
    return f"{length:.1f}" if length >= 0.1 else f"{length:.2f}"


def plural(n: int, noun: str) -> str:
    """A count of things: "3 objects"."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


def few(lines: list[str]) -> list[str]:
    """At most LINES lines; the last says how many more there are."""
    return lines if len(lines) <= LINES else [*lines[: LINES - 1], f"And {len(lines) - LINES + 1} more like these."]


def surface_words(obj: SceneObject) -> str:
    """What an object stands on: "top of desk-0"."""
    assert obj.support is not None
    return f"{obj.support.surface} of {obj.support.object}"


def span_words(polygon) -> str:
    """Length and width of the smallest rectangle around a polygon."""
    box = shapely.Polygon(polygon).minimum_rotated_rectangle
    points = shapely.get_coordinates(box)
    sides = sorted(np.hypot(*(points[i + 1] - points[i])) for i in range(2))
    return f"{sides[1]:.2f} x {sides[0]:.2f} m"
