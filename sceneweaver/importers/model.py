"""What a reader makes of a file: rooms with openings and objects in our frame, before anything is looked up.

Metres, radians, right-handed, z up, yaw counter-clockwise about +z, an object's front along +x of its own frame.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np

Mount = Literal["floor", "wall", "ceiling", "surface"]

Corners = tuple[tuple[float, float, float], tuple[float, float, float]]
"""Least and largest corner of a box [m]."""
Anchor = Literal["centre", "bottom", "origin"]
"""Which point of an object a position is of: the centre of its box, the bottom centre, or the origin of its model."""


@dataclass(frozen=True, eq=False)
class SourceObject:
    """One object of a file.

    ``position`` [m] is that of ``anchor``; ``rotation`` [3, 3] turns the object's frame (front +x, left +y, up +z)
    into the room's. ``size`` is (depth along the front, width, height) [m], None where the file does not say;
    ``size_assumed`` says that the reader took a usual one, because other things stand where that one's faces are.

    ``mesh`` is a file of the user's that shows it; ``mesh_axes`` [3, 3] turns the mesh's frame into the object's after
    its coordinates are multiplied by ``scale``. ``support`` is the name of what carries it, as the file says.

    ``parts`` are least and largest corners [m] of the boxes that a hollow thing consists of, in the object's frame with
    the origin in the middle of its bottom; empty: it fills its box. ``hollows`` are such boxes for what is built into
    it and rests there, as a sink in its counter.
    """

    name: str
    label: str
    position: tuple[float, float, float]
    rotation: np.ndarray = field(default_factory=lambda: np.eye(3))
    size: tuple[float, float, float] | None = None
    anchor: Anchor = "centre"
    asset: str | None = None
    mesh: Path | None = None
    mesh_axes: np.ndarray = field(default_factory=lambda: np.eye(3))
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    support: str | None = None
    mount: Mount | None = None
    description: str = ""
    fixed: bool = False
    parts: tuple[Corners, ...] = ()
    hollows: tuple[Corners, ...] = ()
    size_assumed: bool = False
    keep: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class SourceOpening:
    """A door, a window or an open passage: its two ends on the floor plan [m], its lower edge and its height [m].

    The ends may lie anywhere across the thickness of the wall; the nearest wall of the outline takes the opening.
    """

    name: str
    kind: Literal["door", "window", "passage"]
    start: tuple[float, float]
    end: tuple[float, float]
    bottom: float = 0.0
    height: float | None = None
    swing: Literal["in-left", "in-right", "out", "slide"] | None = None
    leads_to: str | None = None


@dataclass(frozen=True)
class SourceRoom:
    """One room of a file.

    ``outline`` [m] is a simple polygon in either order; None: there is none in the file, and the room is drawn around
    its objects. ``text`` is the request that the scene was made for. ``notes`` say what was left out or assumed.

    Rooms of one ``house`` share a frame; files with several houses name each. ``storey`` is the name of its storey, ""
    where the file has one alone.
    """

    name: str
    type: str = ""
    outline: tuple[tuple[float, float], ...] | None = None
    height: float | None = None
    openings: tuple[SourceOpening, ...] = ()
    objects: tuple[SourceObject, ...] = ()
    text: str = ""
    notes: tuple[str, ...] = ()
    house: str = ""
    storey: str = ""


@dataclass(frozen=True)
class ReadOptions:
    """What the user gives beside a file.

    ``folder`` holds assets, meshes or metadata of the system that wrote the file; ``room`` is the name of the only
    room that is wanted; ``scale`` is metres for a unit, for drawings that do not say it.
    """

    folder: Path | None = None
    room: str | None = None
    scale: float | None = None


@dataclass(frozen=True)
class SourceFormat:
    """How the files of one system are recognised and read.

    ``matches(path, head)`` tells from the name and the first `HEAD` bytes (for a folder: b"") whether it is one.
    ``read`` yields rooms and raises InputError for a file that is broken. ``notes`` say what is read, assumed and lost.
    ``priority``: where several formats match, the one with the highest is taken.
    """

    name: str
    title: str
    matches: Callable[[Path, bytes], bool]
    read: Callable[[Path, ReadOptions], Iterator[SourceRoom]]
    notes: tuple[str, ...] = ()
    licence: str = ""
    written: bool = False
    priority: int = 0


HEAD = 65536
"""Bytes of a file by which its format is recognised."""
