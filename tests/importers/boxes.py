"""Boxes of imported objects compared corner by corner with what the test computes from the file's own terms."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from sceneweaver.importers.formats import formats
from sceneweaver.importers.model import ReadOptions, SourceObject, SourceRoom
from sceneweaver.importers.read import format_of
from sceneweaver.io import InputError

SIGNS = np.array(list(itertools.product((-1.0, 1.0), repeat=3)))
"""Of the eight corners: back or front, right or left, lower or upper."""


def corners(thing: SourceObject) -> np.ndarray:
    """The corners [8, 3] of an object's box in the order of `SIGNS`."""
    assert thing.size is not None
    middle = np.asarray(thing.position)
    if thing.anchor == "bottom":
        middle = middle + thing.rotation[:, 2] * thing.size[2] / 2
    return middle + (SIGNS * np.asarray(thing.size) / 2) @ thing.rotation.T


def y_up_corners(centre: object, full: object, turn: np.ndarray) -> np.ndarray:
    """Corners [8, 3] in our frame of a box in a right-handed frame with y up, whose front is +z.

    Args:
        centre: its middle [3].
        full: its full extents along its own x, y, z.
        turn: its rotation [3, 3].
    """
    x, y, z = np.asarray(full, dtype=float) / 2
    local = np.array([(left * x, up * y, front * z) for front, left, up in SIGNS])  # left of +z, seen from above, is +x
    world = np.array([turn @ p for p in local]) + np.asarray(centre)
    return np.column_stack((world[:, 0], -world[:, 2], world[:, 1]))


def about_y(angle: float) -> np.ndarray:
    """x' = x cos + z sin, z' = -x sin + z cos."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rooms(path: Path, name: str, *, folder: Path | None = None, room: str | None = None) -> list[SourceRoom]:
    """What a reader yields, which recognises the file as well."""
    assert format_of(path).name == name
    return list(formats()[name].read(path, ReadOptions(folder=folder, room=room)))


def only(found: Iterator[SourceRoom] | list[SourceRoom]) -> SourceRoom:
    """The one room."""
    (room,) = found
    return room


def same_ring(outline: object, expected: object) -> None:
    """That two outlines are one, whatever corner they begin with and whichever way they run."""
    found, wanted = np.asarray(outline, dtype=float), np.asarray(expected, dtype=float)
    assert len(found) == len(wanted), found
    turns = [np.roll(way, k, axis=0) for way in (wanted, wanted[::-1]) for k in range(len(wanted))]
    assert min(np.abs(turn - found).max() for turn in turns) < 1e-5, found


def refused(name: str, path: Path, *, folder: Path | None = None, match: str = ".") -> None:
    """That reading a file raises one InputError of one line that names the file."""
    with pytest.raises(InputError, match=match) as error:
        list(formats()[name].read(path, ReadOptions(folder=folder)))
    line = str(error.value)
    assert "\n" not in line and path.name in line and len(line) < 400, line
