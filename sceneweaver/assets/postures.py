"""Things in another posture than they are usually drawn in: on their side, upside down, with doors or drawers open.

The body changes, so that everything that reads it (engine, judge, physics, pictures, exports) sees the thing as it is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.geometry.rotations import matrix

from .asset import Asset
from .body import Hull, Link, Mesh
from .prisms import prisms_of

TURNS: dict[str, tuple[tuple[float, float, float], float]] = {
    "on_side": ((1.0, 0.0, 0.0), math.pi / 2),
    "on_back": ((0.0, 1.0, 0.0), -math.pi / 2),
    "on_end": ((1.0, 0.0, 0.0), math.pi / 2),
    "spilled": ((1.0, 0.0, 0.0), math.pi / 2),
    "upside_down": ((1.0, 0.0, 0.0), math.pi),
}
"""Postures of the whole thing: the axis that it is turned about, and how far [rad]."""

OPENINGS: dict[str, tuple[tuple[str, ...], float, int | None]] = {
    "opened": (("door", "lid"), 0.85, None),
    "half_opened": (("door", "lid"), 0.35, None),
    "drawer_out": (("drawer",), 0.75, 1),
    "drawers_out": (("drawer",), 0.75, None),
}
"""Postures of parts: the roles of links that are opened, how far as a share of what they can, and how many of them."""

POSTURES = frozenset((*TURNS, *OPENINGS))
"""What is done to any drawing; drawings of some categories know more postures, by name."""


def postured(asset: Asset, posture: str, groups: Sequence[str | None]) -> Asset:
    """The asset in a posture; as it is where it has no part that the posture moves, or where that is none of these.

    Args:
        asset: Upright and closed.
        posture: One of `POSTURES`.
        groups: The group of each of its hulls, for its prisms.
    """
    if posture in TURNS:
        return _centred(_turned(asset, *TURNS[posture]), groups)
    if posture not in OPENINGS:
        return asset
    roles, share, most = OPENINGS[posture]
    moved = [k for k, link in enumerate(asset.links) if link.role in roles and _range(link)][:most]
    return _centred(_opened(asset, {k: share * _range(asset.links[k]) for k in moved}), groups) if moved else asset


def _range(link: Link) -> float:
    """How far a link goes from where it is closed, with its sign."""
    return max(link.limits, key=abs)


def _turned(asset: Asset, axis: tuple[float, float, float], angle: float) -> Asset:
    """All of it turned; nothing stands on it then, and nobody uses it."""
    turn = _about(axis, angle)
    return replace(
        asset,
        mesh=replace(asset.mesh, vertices=asset.mesh.vertices @ turn.T),
        hulls=tuple(replace(hull, vertices=hull.vertices @ turn.T) for hull in asset.hulls),
        links=tuple(
            replace(link, axis=_vector(turn @ link.axis), anchor=_vector(turn @ link.anchor)) for link in asset.links
        ),
        surfaces=(),
        zones=(),
        sides=(),
        grasps=(),
        interiors=(),
    )


def _opened(asset: Asset, moved: dict[int, float]) -> Asset:
    """Some of its links moved by so much [rad or m], where they are then at 0."""
    mesh, hulls, links = asset.mesh, list(asset.hulls), list(asset.links)
    vertices = mesh.vertices.copy()
    for k, way in moved.items():
        link = links[k]
        own = np.unique(mesh.faces[mesh.face_link == k + 1])
        vertices[own] = _along(link, way, vertices[own])
        hulls = [replace(h, vertices=_along(link, way, h.vertices)) if h.link == k + 1 else h for h in hulls]
        low, high = link.limits
        links[k] = replace(link, limits=(low - way + 0.0, high - way + 0.0))
    there = {k + 1 for k in moved}
    return replace(
        asset,
        mesh=replace(mesh, vertices=vertices),
        hulls=tuple(hulls),
        links=tuple(links),
        grasps=tuple(grasp for grasp in asset.grasps if grasp.link not in there),
        interiors=tuple(room for room in asset.interiors if room.link not in there),
    )


def _along(link: Link, way: float, points: np.ndarray) -> np.ndarray:
    """Points that move with a link."""
    axis, anchor = np.array(link.axis), np.array(link.anchor)
    if link.joint == "slide":
        return points + way * axis
    return (points - anchor) @ _about(link.axis, way).T + anchor


def _about(axis: tuple[float, float, float], angle: float) -> np.ndarray:
    """The matrix of a turn about a unit vector."""
    x, y, z = (math.sin(angle / 2) * v for v in axis)
    return matrix((x, y, z, math.cos(angle / 2)))


def _centred(asset: Asset, groups: Sequence[str | None]) -> Asset:
    """With its origin at the bottom centre of its box again, and prisms of its hulls as they are now."""
    low, high = asset.mesh.bounds
    shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    x, y, z = _vector(shift)
    hulls = tuple(_moved(hull, shift) for hull in asset.hulls)
    return replace(
        asset,
        mesh=_shifted(asset.mesh, shift),
        hulls=hulls,
        parts=prisms_of(hulls, list(groups)),
        links=tuple(replace(link, anchor=_vector(np.array(link.anchor) - shift)) for link in asset.links),
        surfaces=tuple(
            s.model_copy(update={"polygon": tuple((a - x, b - y) for a, b in s.polygon), "z": s.z - z})
            for s in asset.surfaces
        ),
        zones=tuple(
            zone.model_copy(update={"polygon": tuple((a - x, b - y) for a, b in zone.polygon)}) for zone in asset.zones
        ),
        grasps=tuple(replace(grasp, position=_vector(np.array(grasp.position) - shift)) for grasp in asset.grasps),
        interiors=tuple(
            replace(room, low=_vector(np.array(room.low) - shift), high=_vector(np.array(room.high) - shift))
            for room in asset.interiors
        ),
    )


def _moved(hull: Hull, shift: np.ndarray) -> Hull:
    return replace(hull, vertices=np.ascontiguousarray(hull.vertices - shift), faces=np.ascontiguousarray(hull.faces))


def _shifted(mesh: Mesh, shift: np.ndarray) -> Mesh:
    return replace(mesh, vertices=np.ascontiguousarray(mesh.vertices - shift))


def _vector(v: np.ndarray) -> tuple[float, float, float]:
    return round(float(v[0]), 9), round(float(v[1]), 9), round(float(v[2]), 9)


__all__ = ["OPENINGS", "POSTURES", "TURNS", "postured"]
