"""What drawn bodies weigh: by their material, and by the thickness of wall that things of it have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..body import Material
from ..category import read_yaml
from ..materials import finishes
from .tree import Piece

Weights = tuple[float, ...]
"""Masses [kg] of the base and of each link."""


@dataclass(frozen=True)
class Bulk:
    """Of each of some pieces its ``volume`` [m3], ``area`` [m2] and the number of its ``link``, [P]; and how many links
    there are."""

    volume: np.ndarray
    area: np.ndarray
    link: np.ndarray
    links: int


def bulk_of(pieces: Sequence[Piece], links: int) -> Bulk:
    """What weighs of some pieces, among so many links."""
    first = np.cumsum([0] + [len(piece.faces) for piece in pieces])[:-1]
    corners = np.concatenate([piece.placed[piece.faces] for piece in pieces])
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    volume = np.abs(np.add.reduceat(np.einsum("ij,ij->i", normal, a), first)) / 6
    area = np.add.reduceat(np.linalg.norm(normal, axis=1), first) / 2
    return Bulk(volume, area, np.array([piece.link for piece in pieces], dtype=np.int32), links)


def masses_of(bulk: Bulk, materials: Sequence[Material], limits: tuple[float, float]) -> Weights:
    """What the base and each link weigh, with the material of each piece.

    A body weighs as much as its volume, or as walls of its material over its surface where that is less: a leg is
    solid, the door of a fridge is sheets around air. The sum stays within ``limits`` [kg]: what is missing is in
    the base (motors, ballast, what has not been drawn), what is too much is taken off all.
    """
    density, wall = np.array([_substance(material.name) for material in materials]).T
    mass = density * np.minimum(bulk.volume, bulk.area * wall)
    found = np.bincount(bulk.link, weights=mass, minlength=bulk.links + 1)
    least, most = limits
    found[0] += max(0.0, least - found.sum())
    found *= min(1.0, most / found.sum())
    return tuple(float(value) for value in np.round(found, 5))


@cache
def _substance(name: str) -> tuple[float, float]:
    """Density [kg/m3] and thickness of walls [m] of a finish, by its name."""
    table, families = _substances(), _families()
    family = families.get(name) or families.get(name.split()[-1], "")
    return table.get(family, table["other"])


@cache
def _substances() -> dict[str, tuple[float, float]]:
    from importlib import resources

    data = read_yaml(resources.files("sceneweaver.assets").joinpath("materials.yaml"))["substances"]
    return {family: (float(density), float(wall)) for family, (density, wall) in data.items()}


@cache
def _families() -> dict[str, str]:
    """The family of each finish, and of the last word of its name, which tinted ones keep."""
    known = finishes()
    last = {name.split()[-1]: one.family for name, one in known.items()}
    return last | {name: one.family for name, one in known.items()}
