"""What lamps share: shades, globes, thin bells, and the diameter of round things."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval


def across(b: Builder) -> float:
    """The diameter of a round thing: its width, or its depth when only that is asked for."""
    depth, width, _ = b.request.size
    return b.size.depth if depth is not None and width is None else b.size.width


def shade(
    b: Builder,
    low: float,
    high: float,
    z: Interval,
    material: Material | str,
    segments: int = 28,
    trim: Material | str | None = None,
) -> None:
    """A cloth or metal shade about z with these radii below and above; light shines out of both ends."""
    b.frustum(low, high, (z[0] + 0.003, z[1] - 0.003), material, segments)
    if trim is not None:
        slope = (high - low) / (z[1] - z[0])
        b.frustum(low, low + slope * 0.012, (z[0], z[0] + 0.012), trim, segments)
        b.frustum(high - slope * 0.012, high, (z[1] - 0.012, z[1]), trim, segments)
        low, high = low - 0.006, high - 0.006
    rim = min(0.006, 0.1 * min(low, high))
    b.frustum(low - rim, low - rim, (z[0], z[0] + 0.01), "lamp glow", segments)
    b.frustum(high - rim, high - rim, (z[1] - 0.01, z[1]), "lamp glow", segments)


def shell(
    b: Builder,
    outer: list[tuple[float, float]],
    thickness: float,
    material: Material | str,
    segments: int = 24,
    sectors: int = 8,
) -> None:
    """A thin bell about z: a profile of (radius, z) from foot to head with a wall; open below, parts all around."""
    inner = [(max(0.002, r - thickness), z) for r, z in outer]
    scale = 1.0 / math.cos(math.pi / segments)
    angle = (np.arange(segments) + 0.5) * (2 * np.pi / segments)
    circle = np.c_[np.cos(angle), np.sin(angle)] * scale
    rings = [np.c_[circle * r, np.full(segments, z)] for r, z in outer + inner[::-1]]
    points, n = np.concatenate(rings), segments
    i = np.arange(n)
    j = (i + 1) % n
    faces = []
    for k in range(len(rings)):
        low, high = k * n, (k + 1) % len(rings) * n
        faces.append(np.concatenate([np.c_[low + i, low + j, high + j], np.c_[low + i, high + j, high + i]]))
    hulls = []
    step = segments // sectors
    for k in range(len(outer) - 1):
        for s in range(sectors):
            pick = (np.arange(step + 1) + s * step) % n
            mates = (k, k + 1, len(rings) - 1 - k, len(rings) - 2 - k)
            hulls.append(shapes.hull(np.concatenate([rings[m][pick] for m in mates])))
    b.add((points, np.concatenate(faces).astype(np.int32)), material, hulls)


def globe(b: Builder, radius: float, z: float, segments: int = 20) -> None:
    """A glowing ball about the z axis."""
    b.ball((radius, radius, radius), (0.0, 0.0, z), "lamp glow", segments)


def foot(b: Builder, radius: float, thick: float, material: Material | str) -> None:
    """A round flat foot with a raised middle."""
    b.lathe(
        [
            (radius - 0.004, 0.0),
            (radius, 0.004),
            (radius, thick * 0.6),
            (radius - 0.008, thick * 0.8),
            (0.03, thick),
            (0.018, thick + 0.012),
        ],
        material,
        32,
    )


def arc(center: tuple[float, float], radius: float, start: float, end: float, steps: int) -> list[tuple]:
    """Points of an arc in the xz plane, angles from +x toward +z [rad]."""
    return [
        (center[0] + radius * math.cos(a), 0.0, center[1] + radius * math.sin(a))
        for a in np.linspace(start, end, steps)
    ]
