"""Proofs that one body, or two bodies side by side, fit into a convex room at no poses.

Two convex bodies that do not overlap are parted by a line. It cuts a convex room in two, and either body has to fit
into its part. How far from the far side such a line may run, so that a body still fits, is a number for each of its
directions; where these numbers of two bodies leave no line in any direction, they do not fit together. Angles are
looked at in small steps, and what lies between them is allowed for: what is called impossible is so.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from sceneweaver.geometry.angles import cross
from sceneweaver.layout.shapes import Points

from .space import PENETRATION, hull
from .study import Study
from .words import sized, span_words

YAWS = 1440  # of a body
LINES = 720  # directions of the line, whole turn
CHUNK = 180  # directions at once
LARGEST = 6  # bodies that are tried in pairs


@dataclass(frozen=True)
class Body:
    """A body that stands on the floor: corners of all of it [N, 2], and of a convex part that has to be beside the
    other's [M, 2]; both in its own frame [m]."""

    whole: Points
    part: Points


def misfits(study: Study) -> Iterator[str]:
    """Objects on the floor that fit nowhere in a scene's room, or else pairs of the largest that do not fit together.

    Of the parts of an object the largest has to be beside that of the other, where they stand at a common height.
    """
    planes, outline = study.problem.region.planes, span_words(study.scene.room.outline)
    bodies, objects = [], study.scene.objects
    for i in (i for i in study.free if objects[i].mount == "floor" and objects[i].support is None):
        solids = study.problem.solids[i]
        part = max(solids, key=lambda prism: shapely.Polygon(prism.polygon).area)
        bodies.append((i, Body(hull(solids), np.asarray(part.polygon)), part.z))
    alone = [sized(objects[i]) for i, body, _ in bodies if not fits(body, planes)]
    if alone:
        yield from (f"{text} fits nowhere in the room: its floor is {outline}." for text in alone)
        return
    bodies.sort(key=lambda each: -shapely.Polygon(each[1].part).area)
    for (i, a, p), (j, b, q) in itertools.combinations(bodies[:LARGEST], 2):
        if min(p[1], q[1]) - max(p[0], q[0]) > PENETRATION and not fit_together(a, b, planes):
            both = f"{sized(objects[i])} and {sized(objects[j])}"
            yield f"{both} do not fit into the room beside each other: its floor is {outline}."


def fits(body: Body, planes: np.ndarray) -> bool:
    """Whether a body may fit between half planes [N, 3] (normal, offset) that enclose an area; False is certain."""
    return bool(np.isfinite(_places(body.whole, planes)[0]).any())


def fit_together(a: Body, b: Body, planes: np.ndarray) -> bool:
    """Whether two bodies may fit beside each other between half planes [N, 3] (normal, offset); False is certain.

    Args:
        a, b: the bodies; their parts stand at a common height.
        planes: of the convex hull of the room, normals inwards: inside is ``normal @ x >= offset``.
    """
    angles = np.arange(LINES) * (2 * math.pi / LINES)
    normals = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    corners, inside = _corners(planes[:, :2], planes[None, :, 2])
    radius = float(np.max(np.linalg.norm(corners[inside] - _centre(corners[inside]), axis=-1)))
    centre = _centre(corners[inside])
    beyond = [_farthest(body, planes, normals, centre) for body in (a, b)]
    # A is where n x >= d and B where -n x >= -d for some d: d <= beyond_a(n), -d <= beyond_b(-n).
    opposite = np.roll(beyond[1], LINES // 2)
    slack = PENETRATION + 2 * radius * math.pi / LINES
    return bool(np.any(beyond[0] + opposite >= -slack))


def _centre(points: np.ndarray) -> np.ndarray:
    return 0.5 * (points.min(axis=0) + points.max(axis=0))


def _farthest(body: Body, planes: np.ndarray, normals: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """For each normal [L, 2] the largest d so that the body's part may lie where ``n @ (x - centre) >= d``; [L]."""
    places, turned = _places(body.whole, planes, body.part)
    there = ~np.isnan(places[..., 0])
    some = there.any(axis=1)  # yaws at which the body fits at all
    if not some.any():
        return np.full(len(normals), -np.inf)
    places, turned, there = places[some] - centre, turned[some], there[some]
    reach = float(np.max(np.hypot(*body.part.T)))
    farthest = np.empty(len(normals))
    for first in range(0, len(normals), CHUNK):
        few = normals[first : first + CHUNK].T
        lowest = (turned @ few).min(axis=1)  # [yaw, line]
        at = np.where(there[..., None], places @ few, -np.inf).max(axis=1)
        farthest[first : first + CHUNK] = (at + lowest).max(axis=0)
    return farthest + reach * math.pi / YAWS


def _places(whole: Points, planes: np.ndarray, part: Points | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Corners [yaw, corner, 2] of the areas in which a body's origin may lie, NaN where there is none, and the part's
    corners [yaw, M, 2] turned."""
    angles = np.arange(YAWS) * (2 * math.pi / YAWS)
    turn = np.stack([np.stack([np.cos(angles), np.sin(angles)], 1), np.stack([-np.sin(angles), np.cos(angles)], 1)], 1)
    slack = 2 * PENETRATION + float(np.max(np.hypot(*np.asarray(whole).T))) * math.pi / YAWS
    lowest = np.einsum("nk,yjk,pj->ypn", planes[:, :2], turn, np.asarray(whole)).min(axis=1)
    corners, inside = _corners(planes[:, :2], planes[None, :, 2] - lowest - slack)
    places = np.where(inside[..., None], corners, np.nan)
    turned = np.einsum("yjk,pj->ypk", turn, np.asarray(whole if part is None else part))
    return places, turned


def _corners(normals: np.ndarray, need: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where two lines ``normal @ x = need`` meet [Y, C, 2], of planes [N, 2] and offsets [Y, N], and which of these
    points [Y, C] are inside of all planes."""
    i, j = np.triu_indices(len(normals), 1)
    det = cross(normals[i].T, normals[j].T)
    i, j, det = (values[np.abs(det) > 1e-9] for values in (i, j, det))
    x = (need[:, i] * normals[j, 1] - need[:, j] * normals[i, 1]) / det
    y = (need[:, j] * normals[i, 0] - need[:, i] * normals[j, 0]) / det
    points = np.stack([x, y], axis=-1)
    inside = np.einsum("yck,nk->ycn", points, normals) >= need[:, None] - 1e-9
    return points, inside.all(axis=2)
