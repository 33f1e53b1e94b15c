"""From a file's own axes and unit to ours: z up, front +x, metres, origin at the bottom centre of the box."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import InputError

from ..body import Mesh
from ..category import Category
from .front import areas, front_of
from .hints import AXES, Hints
from .load import RawMesh
from .orient import outward

UNITS = ((1.0, "metres"), (0.01, "centimetres"), (0.001, "millimetres"), (0.0254, "inches"), (0.3048, "feet"))

SMALLEST, LARGEST = 0.005, 12.0
"""Largest extent [m] of anything that is taken for a piece of furniture."""

_MISFIT = 2.5
"""By how much a size may leave its category's range before the unit is doubted."""


@dataclass(frozen=True)
class Normalised:
    """The mesh in our frame, and what was decided on the way."""

    mesh: Mesh
    axes: str
    metres: float
    confidence: float
    notes: tuple[str, ...]


def normalise(raw: RawMesh, hints: Hints, category: Category | None) -> Normalised:
    """Bring a mesh to our conventions.

    Raises:
        InputError: when no unit makes the size believable, or a hint is wrong.
    """
    notes: list[str] = []
    points = raw.vertices
    if hints.transform is not None:
        matrix = np.asarray(hints.transform, dtype=np.float64)
        if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
            raise InputError(f"{hints.name}: transform must be a 4x4 matrix of numbers")
        points = points @ matrix[:3, :3].T + matrix[:3, 3]
    used = np.unique(raw.faces)
    if not 0 < areas(points, raw.faces).sum() < math.inf:
        raise InputError(f"{hints.name}: it has no surface: all of its triangles are lines or points, or endless")
    up = hints.up or raw.up
    if up is None:
        up = _guess_up(points[used], category)
        notes.append(f"up axis guessed: {up}")
    turn = _upright(up)
    points = points @ turn.T
    front_axis, confidence, yaw = hints.front, 1.0, 0.0
    if front_axis is not None:
        direction = turn @ axis_vector(front_axis, hints.name)
        if abs(direction[2]) > 1e-6:
            raise InputError(f"{hints.name}: front {front_axis} cannot be the up axis as well")
        yaw = -math.atan2(direction[1], direction[0])
    elif category is None or category.sides or category.mount[0] == "wall":
        quarter, confidence = front_of(points[used], _packed(raw.faces, used), category)
        yaw = -quarter * math.pi / 2
        notes.append(f"front found from the shape, confidence {confidence:.2f}")
    else:
        confidence = 0.0
    if front_axis is None and hints.seen is not None:
        yaw -= hints.seen.quarters * math.pi / 2
        confidence = hints.seen.confidence
        notes.append(f"front seen by {hints.seen.by}, confidence {confidence:.2f}")
    points = _spin(points, yaw - hints.yaw)
    metres = _unit(raw, hints, category, np.ptp(points[used], axis=0), notes)
    points = points * metres
    low, high = points[used].min(axis=0), points[used].max(axis=0)
    points = points - np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    mesh = Mesh(
        vertices=points[used],
        faces=outward(points[used], _packed(raw.faces, used)).astype(np.int32),
        face_material=raw.face_material.astype(np.int32),
        face_link=np.zeros(len(raw.faces), dtype=np.int32),
        materials=raw.materials,
    )
    return Normalised(mesh, f"{up} {front_axis or '?'}", metres, confidence, tuple(notes))


def axis_vector(axis: str, name: str = "axis") -> np.ndarray:
    """The unit vector of "x", "-x", ...; InputError for anything else."""
    if axis not in AXES:
        raise InputError(f"{name}: axis '{axis}' is unknown; use one of {', '.join(AXES)}")
    vector = np.zeros(3)
    vector["xyz".index(axis[-1])] = -1.0 if axis.startswith("-") else 1.0
    return vector


def _packed(faces: np.ndarray, used: np.ndarray) -> np.ndarray:
    return np.searchsorted(used, faces)


def _upright(up: str) -> np.ndarray:
    """A rotation that turns the up axis to +z; for y up it is the usual quarter turn about x."""
    target = axis_vector(up, "up")
    if up == "z":
        return np.eye(3)
    if up == "-z":
        return np.diag([1.0, -1.0, -1.0])
    z = np.array([0.0, 0.0, 1.0])
    cross = np.cross(target, z)
    k = np.array([[0, -cross[2], cross[1]], [cross[2], 0, -cross[0]], [-cross[1], cross[0], 0]])
    return np.eye(3) + k + k @ k


def _spin(points: np.ndarray, yaw: float) -> np.ndarray:
    c, s = math.cos(yaw), math.sin(yaw)
    if abs(c - round(c)) < 1e-12 and abs(s - round(s)) < 1e-12:
        c, s = round(c), round(s)
    return points @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]).T


def _guess_up(points: np.ndarray, category: Category | None) -> str:
    """y or z: whichever suits the category's proportions; without one, the axis with more of the mesh at its foot."""
    extent = np.ptp(points, axis=0)
    if category is not None and category.size is not None:
        ranges = category.size.ranges
        misfit = {}
        for axis, (a, b, c) in (("y", (0, 2, 1)), ("z", (0, 1, 2))):
            best = math.inf
            for first, second in ((a, b), (b, a)):
                ratio = [
                    math.log(extent[k] / math.sqrt(r[0] * r[1]))
                    for k, r in zip((first, second, c), ranges, strict=True)
                    if extent[k] > 0
                ]
                best = min(best, float(np.ptp(ratio)))
            misfit[axis] = best
        if abs(misfit["y"] - misfit["z"]) > 0.15:
            return min(misfit, key=lambda axis: misfit[axis])
    foot = {}
    for axis, k in (("y", 1), ("z", 2)):
        near = points[:, k] < points[:, k].min() + 0.01 * max(extent[k], 1e-9)
        others = [j for j in range(3) if j != k]
        spread = np.ptp(points[near][:, others], axis=0) / np.maximum(extent[others], 1e-9)
        foot[axis] = float(spread.prod())
    return "z" if foot["z"] >= foot["y"] else "y"


def _unit(raw: RawMesh, hints: Hints, category: Category | None, extent: np.ndarray, notes: list[str]) -> float:
    """Metres per unit: the wanted size decides, then what is stated if it is believable, then what fits best."""
    wanted = [(w, float(e)) for w, e in zip(hints.size, extent, strict=True) if w is not None]
    scales = [w / e for w, e in wanted if e > 0]  # a flat mesh has no extent that could be scaled to a size
    if scales:
        scale = float(np.median(scales))
        if max(scales) > 1.15 * min(scales):
            notes.append("the stated size has other proportions than the mesh; the median scale was used")
        return _believable(scale, extent, hints, category, "the stated size")
    stated = hints.metres if hints.metres is not None else raw.metres
    if stated is not None and _fits(extent * stated, category):
        return stated
    if hints.metres is not None:
        return _believable(hints.metres, extent, hints, category, "the stated unit")
    options = [(u, name) for u, name in UNITS if _fits(extent * u, category)]
    if not options:
        return _believable(stated if stated is not None else 1.0, extent, hints, category, "no usual unit")
    unit, name = min(options, key=lambda option: _misfit(extent * option[0], category))
    if stated is not None:
        notes.append(f"the file says {stated:g} metres a unit, but its size fits {name}")
    elif name != "metres":
        notes.append(f"unit guessed: {name}")
    return unit


def _believable(scale: float, extent: np.ndarray, hints: Hints, category: Category | None, what: str) -> float:
    size = extent * scale
    if _fits(size, category):
        return scale
    text = " x ".join(f"{v:.3g}" for v in size)
    usual = ""
    if category is not None and category.size is not None:
        spans = " x ".join(f"{a:g}-{b:g}" for a, b in category.size.ranges)
        usual = f"; a {category.words} is {spans} m"
    raise InputError(f"{hints.name}: with {what} it would be {text} m{usual}; give --unit or --size")


def _fits(size: np.ndarray, category: Category | None) -> bool:
    if category is None or category.size is None:
        return SMALLEST <= float(size.max()) <= LARGEST
    return _misfit(size, category) <= math.log(_MISFIT)


def _misfit(size: np.ndarray, category: Category | None) -> float:
    """How far, as a logarithm, the largest extent and the height leave the category's ranges; 0 inside."""
    if category is None or category.size is None:
        # Furniture is about a metre large.
        return abs(math.log(max(1e-9, float(size.max())) / 0.8))
    (d0, d1), (w0, w1), (h0, h1) = category.size.ranges
    spans = ((max(d0, w0), max(d1, w1), float(max(size[0], size[1]))), (h0, h1, float(size[2])))
    sizes = [min(max(v, 1e-9), 1e9) for *_, v in spans]  # a size that somebody states may be anything
    return max(max(0.0, math.log(a / v), math.log(v / b)) for (a, b, _), v in zip(spans, sizes, strict=True))
