"""Soft things: mattresses that sag, blankets, curtains and towels with folds, rows of cushions."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from ... import shapes
from ...shapes.convex import Shape
from ..box import Box
from ..drawing import Drawing, Look


def mattress(d: Drawing, box: Box, material: Look, piping: Look | None = None, radius: float = 0.05) -> Box:
    """A mattress that fills a box: full edges, a top that bulges a little, and piping around both edges."""
    d.cushion(box.inset(top=0.012), material, radius=min(radius, 0.4 * box.height))
    d.cushion(box.inset(x=0.05, y=0.05).top(0.5 * box.height), material, radius=0.1, puff=0.35)
    if piping:
        for z in (box.z[0] + 0.25 * box.height, box.z[1] - 0.012 - 0.25 * box.height):
            ring = shapes.rectangle(box.inset(x=0.002).x, box.inset(y=0.002).y, z, radius, 3)
            d.add(shapes.sweep(ring, 0.005, 6, closed=True), piping, [])
    return box


def blanket(
    d: Drawing,
    box: Box,
    material: Look,
    corner: float = 0.05,
    swing: float = 0.0,
    phase: float = 0.0,
    top: float = 0.04,
) -> Box:
    """Cloth over something as large as the box: a flat top with edges of radius ``top``, and skirts.

    Their hem swings out by ``swing`` in folds; ``corner`` is their radius in plan.
    """
    shape = draped(box, corner, swing, phase, top)
    d.add(shape, material, [shapes.containing_hull(shape[0])])
    return box


def draped(box: Box, corner: float, swing: float = 0.0, phase: float = 0.0, top: float = 0.04) -> Shape:
    """The skin of `blanket`; folds are about 0.06 m apart, and there are none at its back (the head of a bed)."""
    core = box.inset(x=corner + swing, y=corner + swing)
    points, normals = [], []
    ends = ((1, 0, -90), (1, 1, 0), (0, 1, 90), (0, 0, 180))
    for k, (i, j, start) in enumerate(ends):
        here = np.array([core.x[i], core.y[j]])
        there = np.array([core.x[ends[(k + 1) % 4][0]], core.y[ends[(k + 1) % 4][1]]])
        turns = np.radians([start + a for a in (0, 30, 60, 90)])
        points += [here] * 4
        normals += list(np.c_[np.cos(turns), np.sin(turns)])
        count = max(1, round(float(np.linalg.norm(there - here)) / 0.06)) if swing > 0 else 1
        for step in range(1, count):
            points.append(here + (there - here) * step / count)
            normals.append(normals[-1])
    base, out = np.array(points), np.array(normals)
    n = len(base)
    run = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(base + corner * out, axis=0), axis=1))])
    wave = 0.5 + 0.35 * np.sin(run * 19 + phase) + 0.15 * np.sin(run * 41 + 2 * phase)
    wave *= np.clip(1 + 1.5 * out[:, 0], 0, 1)
    r = min(top, 0.9 * corner)
    rings = []
    for share in (1.0, 0.55, 0.15) if swing > 0 else (1.0,):
        height = box.z[0] + (1 - share) * (box.z[1] - r - box.z[0])
        rings.append(np.c_[base + out * (corner + swing * share * wave)[:, None], np.full(n, height)])
    for a in np.radians([0, 30, 60, 90]):
        rings.append(np.c_[base + out * (corner - r * (1 - np.cos(a))), np.full(n, box.z[1] - r + r * np.sin(a))])
    faces = [ring_faces(k * n, (k + 1) * n, n) for k in range(len(rings) - 1)]
    fan = np.arange(1, n - 1)
    faces += [np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + (len(rings) - 1) * n]
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)


def curtain(d: Drawing, box: Box, material: Look, folds: int = 8, gather: float = 0.0, phase: float = 0.0) -> Box:
    """Cloth that hangs as high as a box, along y, in so many folds as deep as the box.

    ``gather`` (0 to 1) draws it together at 0.42 of its height, as a tie does.
    """
    t = np.linspace(0.0, 1.0, 6 * folds + 1)
    rows = []
    for z in (0.0, 0.2, 0.42, 0.7, 1.0):
        tight = 1.0 - gather * math.exp(-((z - 0.42) ** 2) / 0.03)
        deep = box.depth / 2 * (0.75 + 0.25 * (1 - z))  # folds open toward the hem
        x = box.center[0] + 0.96 * deep * np.sin(2 * np.pi * folds * t + phase + 0.6 * z * np.sin(7 * t))
        y = box.center[1] + (t - 0.5) * box.width * tight
        rows.append(np.c_[x, y, np.full(len(t), box.z[0] + z * box.height)])
    d.sheet(np.array(rows), 0.003, material, (2, max(1, folds // 2)))
    return box


def towel(d: Drawing, box: Box, material: Look, hem: Look | None = None, layers: int = 2) -> Box:
    """A folded towel that fills a box: round layers with the fold in front, and a woven stripe near its front."""
    for k, layer in enumerate(box.rows(layers)):
        own = layer.inset(x=0.004 * k, bottom=-0.002 if k else 0.0)
        d.cushion(own, material, radius=0.48 * layer.height, puff=0.12)
    if hem:
        for share in (0.7, 0.78):
            stripe = box.top(0.0).inset(y=0.012).share(x=(share - 0.02, share + 0.02))
            d.print(stripe, hem, 0.0008)
    return box


def piping(d: Drawing, box: Box, material: Look, radius: float = 0.05, cord: float = 0.004) -> None:
    """Two cords around a cushion that fills a box, where its round edges of ``radius`` turn; without a collider."""
    turn = 0.29 * min(radius, 0.499 * box.height)  # 1 - cos 45 degrees
    edge = box.inset(turn)
    for z in edge.z:
        d.add(shapes.sweep(shapes.rectangle(edge.x, edge.y, z, 0.71 * radius, 3), cord, 5, closed=True), material, [])


def cushions(
    d: Drawing,
    box: Box,
    count: int,
    material: Look,
    radius: float = 0.05,
    puff: float = 0.0,
    gap: float = 0.002,
    cord: Look | None = None,
) -> list[Box]:
    """Upholstered cushions side by side that fill a box; ``cord`` is the finish of their piping."""
    cells = box.columns(count, gap)
    for own in cells:
        d.cushion(own, material, radius, puff)
        if cord:
            piping(d, own, cord, radius)
    return cells
