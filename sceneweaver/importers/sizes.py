"""How large an object is that came without a size: its mesh, the user's table, the taxonomy."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.io import InputError, load_csv, load_json
from sceneweaver.io.messages import path_name, show

from .model import SourceObject

Size = tuple[float, float, float]
SizeTable = Mapping[str, Size]
"""(depth along the front, width, height) [m] by asset or by label, in lower case."""

LEAST = 0.002
"""Least side [m] of an object: what a file has as flat is as thick as a sheet of board."""

BELIEVED = 2.5
"""Factor from the usual height within which the height of an object's middle is taken for half of its own."""

Origin = Literal["file", "mesh", "table", "category"]


class Found(NamedTuple):
    """A size [m] with where it comes from, and the centre of the box from the model's origin [m], in its frame."""

    size: Size
    origin: Origin
    offset: tuple[float, float, float] | None = None


def load_sizes(path: Path) -> dict[str, Size]:
    """A table of sizes: JSON ``{"asset or label": [depth, width, height]}``, or CSV with name, depth, width, height.

    Raises:
        InputError: the file is no such table; the line names the entry.
    """
    if path.suffix.lower() == ".csv":
        rows = {str(row.get("name", "")): [row.get(k) for k in ("depth", "width", "height")] for row in load_csv(path)}
    else:
        rows = load_json(path, wanted='sizes such as {"desk": [0.7, 1.4, 0.74]}')
    if not isinstance(rows, dict):
        raise InputError(f'{path_name(path)}: give an object such as {{"desk": [0.7, 1.4, 0.74]}}')
    return {str(name).lower(): _row(path, str(name), values) for name, values in rows.items()}


def _row(path: Path, name: str, values: Any) -> Size:
    try:
        d, w, h = (float(v) for v in values)
    except (TypeError, ValueError):
        raise InputError(f"{path_name(path)}: {name}: {show(values)} is no depth, width, height [m]") from None
    if not all(math.isfinite(v) and v > 0 for v in (d, w, h)):
        raise InputError(f"{path_name(path)}: {name}: {show(values)}; lengths must be finite and above 0")
    return d, w, h


def find_size(thing: SourceObject, category: str, table: SizeTable) -> Found:
    """The size of an object: of the file (or what its reader assumed), of its mesh, of the user's table, or what is
    usual."""
    if thing.size is not None:
        return Found(_least(thing.size), "category" if thing.size_assumed else "file")
    if thing.mesh is not None:
        low, high = _bounds(thing)
        centre = (low + high) / 2
        return Found(_least(high - low), "mesh", (float(centre[0]), float(centre[1]), float(centre[2])))
    for key in (thing.asset, thing.label):
        if key and key.lower() in table:
            return Found(table[key.lower()], "table")
    return Found(_standing(thing, category, usual_size(category)), "category")


def usual_size(category: str) -> Size:
    """The middle of the usual sizes of a category [m]."""
    sizes = category_named(category).size
    if sizes is None:
        return 0.3, 0.3, 0.3
    d, w, h = (math.sqrt(low * high) for low, high in sizes.ranges)
    return round(d, 3), round(w, 3), round(h, 3)


def _standing(thing: SourceObject, category: str, size: Size) -> Size:
    """A usual size with the height that a thing on the floor has when only its middle is known: twice as high up."""
    tall = 2 * thing.position[2]
    on_floor = thing.mount in (None, "floor") and category_named(category).mount[0] == "floor"
    if thing.anchor == "centre" and on_floor and 1 / BELIEVED <= tall / size[2] <= BELIEVED:
        return size[0], size[1], tall
    return size


def _bounds(thing: SourceObject) -> tuple[np.ndarray, np.ndarray]:
    """Least and largest corner of an object's mesh in the object's frame [m]."""
    from sceneweaver.assets.imports.load import load

    assert thing.mesh is not None
    raw = load(thing.mesh)
    used = raw.vertices[np.unique(raw.faces)] * np.asarray(thing.scale) * (raw.metres or 1.0)
    turned = used @ thing.mesh_axes.T
    return turned.min(axis=0), turned.max(axis=0)


def _least(size: Any) -> Size:
    d, w, h = (max(LEAST, float(v)) for v in size)
    return d, w, h
