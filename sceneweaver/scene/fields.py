"""The kinds of values in a scene: numbers, ids, polygons, free JSON. Each refuses bad values with a clear text."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, WithJsonSchema

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.io.messages import show

from .limits import MAX_CORNERS
from .messages import FieldError
from .polygons import Points, check_simple, convex, counter_clockwise

LARGEST = 1e6
"""Largest magnitude of any length [m]."""

SMALLEST = 1e-6
"""Smallest size of anything that must have one [m]."""

UNIT_TOLERANCE = 1e-3
"""A quaternion whose length is this near 1 is scaled to 1; any other is refused."""

_MAX_DEPTH = 32
_WALL = re.compile(r"wall:")

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-LARGEST, le=LARGEST)]
"""A finite number; numpy scalars are taken, strings and booleans are not."""
Length = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=SMALLEST, le=LARGEST)]
"""A positive length [m]."""
Offset = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.0, le=LARGEST)]
"""A length that may be 0 [m]."""
Weight = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0.0, le=LARGEST)]
"""A positive factor."""
Index = Annotated[int, Field(strict=True, ge=0)]
"""A number of something, from 0."""
Flag = Annotated[bool, Field(strict=True)]


def _check_text(value: str) -> str:
    if not value.isascii() and any("\ud800" <= c <= "\udfff" for c in value):
        raise FieldError((), "holds half a surrogate pair, which no file can hold; give valid Unicode")
    return value


Text = Annotated[str, AfterValidator(_check_text)]
"""A string that UTF-8 can hold."""
Name = Annotated[str, Field(min_length=1), AfterValidator(_check_text)]
"""A string that is not empty."""

Vec2 = tuple[Number, Number]
Vec3 = tuple[Number, Number, Number]


def _check_id(value: str) -> str:
    if not value.isprintable() or value != value.strip():
        raise FieldError((), f"is {show(value)}; ids are printable and neither start nor end with a space")
    if _WALL.match(value):
        raise FieldError((), f'is {show(value)}; ids that start with "wall:" mean walls, choose another')
    return value


def _check_interval(value: tuple[float, float]) -> tuple[float, float]:
    if not value[1] - value[0] >= SMALLEST:
        raise FieldError((), f"is [{value[0]:g}, {value[1]:g}]; the first must be less than the second")
    return value


def _unit(value: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    length = math.hypot(*value)
    if not abs(length - 1.0) <= UNIT_TOLERANCE:
        raise FieldError((), f"has norm {length:.4g}; divide it by its norm to make that 1 (the order is x, y, z, w)")
    if abs(length - 1.0) <= 1e-12:  # as good as 1: scaling again would only stir the last bits
        return value
    x, y, z, w = value
    return (x / length, y / length, z / length, w / length)


def _check_outline(points: Points) -> Points:
    check_simple(points)
    if signed_area(points) < 0:
        raise FieldError((), "runs clockwise; reverse it and renumber the walls of doors, windows and relations")
    return points


def json_value(value: Any, depth: int = 0) -> Any:
    """A copy of ``value`` as plain JSON: lists for tuples, Python numbers for numpy scalars.

    Raises:
        FieldError: when something in it cannot be written as JSON (NaN, other types, deeper than 32 levels).
    """
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, str):
        return _check_text(value)
    if type(value).__module__ == "numpy" and getattr(value, "ndim", None) == 0:
        value = value.item()
    if isinstance(value, int):
        if value.bit_length() > 1000:
            raise FieldError((), "is a huge number; numbers must fit a double")
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            raise FieldError((), f"is {show(value)}; numbers must be finite")
        return value
    if depth >= _MAX_DEPTH:
        raise FieldError((), f"is nested deeper than {_MAX_DEPTH} levels; flatten it")
    if isinstance(value, Mapping):
        return {_json_key(key): _at(key, item, depth) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_at(i, item, depth) for i, item in enumerate(value)]
    raise FieldError((), f"is {show(value)}; give something that JSON can hold")


def _json_key(key: object) -> str:
    if not isinstance(key, str):
        raise FieldError((), f": key {show(key)} is not a string; JSON keys are")
    return json_value(key)


def _at(key: str | int, value: object, depth: int) -> object:
    try:
        return json_value(value, depth + 1)
    except FieldError as error:
        raise FieldError((key, *error.loc), error.text) from None


def _check_target(value: Any) -> Any:
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, list | tuple) and len(value) == 2 and all(isinstance(v, str) for v in value):
        return tuple(value)
    raise FieldError((), f"is {show(value)}; give an id, a list of two ids, or null")


_Corners = Annotated[tuple[Vec2, ...], Field(min_length=3, max_length=MAX_CORNERS, fail_fast=True)]

Id = Annotated[str, Field(min_length=1), AfterValidator(_check_id)]
"""The name of a door, window or object: printable, not empty, not like "wall:3"."""
Interval = Annotated[Vec2, AfterValidator(_check_interval)]
"""[low, high] with low < high [m]."""
Quat = Annotated[tuple[Number, Number, Number, Number], AfterValidator(_unit)]
"""A unit quaternion in the order x, y, z, w."""
Outline = Annotated[_Corners, AfterValidator(_check_outline)]
"""A simple polygon that runs counter-clockwise; its edges are numbered, so it is never turned round."""
Polygon = Annotated[_Corners, AfterValidator(counter_clockwise)]
"""A simple polygon; turned counter-clockwise."""
ConvexPolygon = Annotated[_Corners, AfterValidator(convex)]
"""A convex polygon; turned counter-clockwise."""
JsonDict = Annotated[dict[str, Any], AfterValidator(json_value), WithJsonSchema({"type": "object"})]
"""Free JSON."""
Target = Annotated[str | tuple[str, str] | None, BeforeValidator(_check_target)]
"""What a relation refers to besides its subject: an id, two ids, "wall:k", or nothing."""
