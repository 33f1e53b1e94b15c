"""Drawings as tables: things that are a few simple bodies, by their numbers in ``pieces/*.yaml``.

Each line of ``draw`` is one body: what it is, the letter of its finish, and numbers. Places are shares of the size from
0 to 1: x from back to front, y from right to left, z from foot to head; radii are shares of the shortest side that they
lie in. See ``_SHAPES`` for the numbers of each. Before a line may stand

- ``?0.5``: only in that share of the seeds,
- ``*4 0 .2 0``: so many copies, each moved on by these shares,
- ``~``: the line goes on with the one before it,
- ``+name``: the bodies from here on are one prism of the engine of that name; without any, all are one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import resources
from typing import Any

import numpy as np

from ... import shapes
from ...category import read_yaml
from ..builder import Builder
from ..registry import MAKERS
from .small_kit import decal, slab, spun, target

Numbers = Sequence[float]


class _Sheet:
    """A builder with the scale of one drawing: shares become metres."""

    def __init__(self, b: Builder):
        self.b, (self.d, self.w, self.h) = b, b.size

    def x(self, v: float) -> float:
        return (v - 0.5) * self.d

    def y(self, v: float) -> float:
        return (v - 0.5) * self.w

    def box(self, n: Numbers):
        """Three intervals [m] of six shares."""
        return (self.x(n[0]), self.x(n[1])), (self.y(n[2]), self.y(n[3])), (n[4] * self.h, n[5] * self.h)

    def point(self, n: Numbers) -> tuple[float, float, float]:
        return self.x(n[0]), self.y(n[1]), n[2] * self.h


def _box(s: _Sheet, look: Any, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, bevel as a share of the shortest side."""
    x, y, z = s.box(n)
    least = min(x[1] - x[0], y[1] - y[0], z[1] - z[0])
    s.b.box(x, y, z, look, (n[6] if len(n) > 6 else 0.06) * least)


def _slab(s: _Sheet, look: Any, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, radius in plan as a share of the shorter side."""
    x, y, z = s.box(n)
    side = min(x[1] - x[0], y[1] - y[0])
    slab(s.b, x, y, z, look, (n[6] if len(n) > 6 else 0.15) * side, 0.12 * min(side, z[1] - z[0]))


def _print(s: _Sheet, look: Any, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1 of what lies on another body, and stands out of it by less than half a millimetre."""
    (x0, x1), (y0, y1), (z0, z1) = s.box(n)
    e = 0.0003
    decal(s.b, (x0 - e, x1 + e), (y0 - e, y1 + e), (z0 - e, z1 + e), look)


def _cushion(s: _Sheet, look: Any, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, puff."""
    x, y, z = s.box(n)
    radius = 0.3 * min(x[1] - x[0], y[1] - y[0], z[1] - z[0])
    s.b.cushion(x, y, z, look, radius, n[6] if len(n) > 6 else 0.0)


def _upright(s: _Sheet, look: Any, n: Numbers) -> None:
    """x y z0 z1, radius at the foot and at the head."""
    r = min(s.d, s.w)
    with s.b.frame(s.x(n[0]), s.y(n[1])):
        s.b.frustum(n[4] * r, n[-1] * r, (n[2] * s.h, n[3] * s.h), look, 24)


def _along_x(s: _Sheet, look: Any, n: Numbers) -> None:
    """x0 x1 y z, radius at the back and at the front."""
    r = min(s.w, s.h)
    with s.b.frame(s.x(n[0]), s.y(n[2]), n[3] * s.h, pitch=np.pi / 2):
        s.b.frustum(n[4] * r, n[-1] * r, (0.0, (n[1] - n[0]) * s.d), look, 24)


def _along_y(s: _Sheet, look: Any, n: Numbers) -> None:
    """y0 y1 x z, radius at the right and at the left."""
    r = min(s.d, s.h)
    with s.b.frame(s.x(n[2]), s.y(n[0]), n[3] * s.h, roll=-np.pi / 2):
        s.b.frustum(n[4] * r, n[-1] * r, (0.0, (n[1] - n[0]) * s.w), look, 24)


def _ball(s: _Sheet, look: Any, n: Numbers) -> None:
    """Middle and radii as shares of depth, width and height."""
    radii = n[3] * s.d, n[4] * s.w, n[5] * s.h
    s.b.ball(radii, s.point(n), look, 12 if max(radii) < 0.05 else 20)


def _turned(s: _Sheet, look: Any, n: Numbers) -> None:
    """x y, then pairs of radius and z from foot to head; stretched to an ellipse where depth and width differ."""
    profile = [(float(r), float(z) * s.h) for r, z in zip(n[2::2], n[3::2], strict=True)]
    with s.b.frame(s.x(n[0]), s.y(n[1])):
        spun(s.b, profile, look, s.d, s.w, 20)


def _bar(s: _Sheet, look: Any, n: Numbers) -> None:
    """Radius, then points; the radius is a share of the shortest side of all."""
    points = [s.point(n[k : k + 3]) for k in range(1, len(n), 3)]
    s.b.tube(points, n[0] * min(s.d, s.w, s.h), look, 8)


def _ring(s: _Sheet, look: Any, n: Numbers) -> None:
    """Axis (0 x, 1 y, 2 z), middle, radius of the ring and of its wire, as shares of the shorter side across it."""
    across = [e for k, e in enumerate((s.d, s.w, s.h)) if k != int(n[0])]
    t = np.arange(20) * (2 * np.pi / 20)
    a, c = n[4] * min(across) * np.cos(t), n[4] * min(across) * np.sin(t)
    zero = np.zeros_like(t)
    path = {0: np.c_[zero, a, c], 1: np.c_[c, zero, a], 2: np.c_[a, c, zero]}[int(n[0])] + np.array(s.point(n[1:4]))
    s.b.tube(path, n[5] * min(across), look, 8, closed=True)


def _hull(s: _Sheet, look: Any, n: Numbers) -> None:
    """Points of a convex body."""
    s.b.add(shapes.hull(np.array([s.point(n[k : k + 3]) for k in range(0, len(n), 3)])), look)


_SHAPES: dict[str, Callable[[_Sheet, Any, Numbers], None]] = {
    "box": _box,
    "slab": _slab,
    "print": _print,
    "cushion": _cushion,
    "up": _upright,
    "x": _along_x,
    "y": _along_y,
    "ball": _ball,
    "turned": _turned,
    "bar": _bar,
    "ring": _ring,
    "hull": _hull,
}


def _moved(shape: str, n: list[float], by: Numbers) -> list[float]:
    """The numbers of a shape, moved on."""
    if shape in ("box", "slab", "print", "cushion"):
        return [v + by[k // 2] if k < 6 else v for k, v in enumerate(n)]
    if shape == "hull":
        return [v + by[k % 3] for k, v in enumerate(n)]
    if shape == "bar":
        return [n[0], *(v + by[k % 3] for k, v in enumerate(n[1:]))]
    if shape == "ring":
        return [n[0], *(v + by[k] for k, v in enumerate(n[1:4])), *n[4:]]
    axes = {"up": (0, 1, 2, 2), "x": (0, 0, 1, 2), "y": (1, 1, 0, 2), "ball": (0, 1, 2)}.get(shape, (0, 1))
    if shape == "turned":
        return [n[0] + by[0], n[1] + by[1], *(v + by[2] if k % 2 else v for k, v in enumerate(n[2:]))]
    return [v + by[axes[k]] if k < len(axes) else v for k, v in enumerate(n)]


def draw(b: Builder, row: dict[str, Any]) -> None:
    """A thing of the tables."""
    size = target(b, row.get("fit", "box"))
    b.size = type(b.size)(*size)
    sheet = _Sheet(b)
    looks = {key: b.material(key, *value.split(", ")) for key, value in row.items() if len(key) == 1}
    group: str | None = None if "+" in row["draw"] else "all"
    for number, line in enumerate(row["draw"].strip().replace("\n~", "").splitlines()):
        words = line.split()
        if words[0][0] == "+":
            group = words[0][1:]
            continue
        if words[0][0] == "?" and not b.chance(f"piece {number}", float(words.pop(0)[1:])):
            continue
        count, by = 1, (0.0, 0.0, 0.0)
        if words[0][0] == "*":
            count, by = int(words[0][1:]), (float(words[1]), float(words[2]), float(words[3]))
            words = words[4:]
        shape, look, numbers = words[0], looks[words[1]], [float(word) for word in words[2:]]
        for k in range(count):
            with b.solid(group or f"piece {number}"):
                _SHAPES[shape](sheet, look, _moved(shape, numbers, [k * v for v in by]))
    for name, numbers in row.get("surfaces", {}).items():
        x, y, _ = sheet.box([*numbers[:4], 0, 0])
        b.surface(name, x, y, numbers[4] * sheet.h, numbers[5] * sheet.h if len(numbers) > 5 else None)
    b.fit(size)


def _register() -> None:
    folder = resources.files((__package__ or "").rpartition(".")[0]).joinpath("pieces")
    for file in sorted(folder.iterdir(), key=lambda f: f.name):
        if file.name.endswith(".yaml"):
            for name, row in read_yaml(file).items():
                if name in MAKERS:
                    raise ValueError(f"{file.name}: two drawings of {name}")
                MAKERS[name] = partial(draw, row=row)


_register()
