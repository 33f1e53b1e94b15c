"""Plan symbols: the pillows of a bed, the leaves of a plant. Each symbol draws inside its object's box.

A symbol is a function of the box (depth along the front, width) in metres that yields strokes in the object's frame.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.se2 import SE2
from sceneweaver.render.palette import words_of
from sceneweaver.render.words import tables
from sceneweaver.scene import Vec2


@dataclass(frozen=True)
class Stroke:
    """A line, or a closed shape filled with the object's colour made lighter (above 0) or darker (below 0)."""

    points: tuple[Vec2, ...]
    tone: float | None = None
    weight: float = 1.0


Symbol = Callable[[float, float], Iterator[Stroke]]


def strokes_of(category: str, depth: float, width: float) -> list[Stroke]:
    """The strokes of a category's symbol; empty when it has none. What does not fit into a tiny box is left out."""
    words, known = words_of(category), _symbols()
    for name in ("_".join(words), *reversed(words)):
        symbol = known.get(name) or known.get(name.removesuffix("s"))
        if symbol is not None:
            return [s for s in _DRAWN[symbol](depth, width) if _fits(s, depth, width)]
    return []


@cache
def _symbols() -> dict[str, str]:
    """The name of the symbol of each word."""
    return {word: name for name, words in tables()["symbols"].items() for word in words.split()}


def _fits(stroke: Stroke, depth: float, width: float) -> bool:
    inside = all(abs(x) <= depth / 2 + 1e-6 and abs(y) <= width / 2 + 1e-6 for x, y in stroke.points)
    return inside and (stroke.tone is None or signed_area(stroke.points) > 0)


def _rect(x0: float, y0: float, x1: float, y1: float, radius: float = 0.0) -> tuple[Vec2, ...]:
    """A rectangle with rounded corners, counter-clockwise."""
    r = min(radius, (x1 - x0) / 2, (y1 - y0) / 2)
    if r <= 1e-6:
        return ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    out: list[Vec2] = []
    for cx, cy, start in ((x1 - r, y1 - r, 0), (x0 + r, y1 - r, 90), (x0 + r, y0 + r, 180), (x1 - r, y0 + r, 270)):
        for step in range(5):
            angle = math.radians(start + 22.5 * step)
            out.append((cx + r * math.cos(angle), cy + r * math.sin(angle)))
    return tuple(out)


def _circle(radius: float, x: float = 0.0, y: float = 0.0, count: int = 32) -> tuple[Vec2, ...]:
    return tuple(
        (x + radius * math.cos(2 * math.pi * k / count), y + radius * math.sin(2 * math.pi * k / count))
        for k in range(count)
    )


def _ring(radius: float, x: float = 0.0, y: float = 0.0) -> Stroke:
    points = _circle(radius, x, y)
    return Stroke((*points, points[0]))


def _bed(d: float, w: float) -> Iterator[Stroke]:
    back = -d / 2
    fold = back + min(0.62, 0.36 * d)
    yield Stroke(_rect(fold, -w / 2 + 0.02, d / 2 - 0.02, w / 2 - 0.02, 0.05), -0.05)
    yield Stroke(_rect(fold, -w / 2 + 0.02, fold + min(0.22, 0.12 * d), w / 2 - 0.02), 0.45)
    count = 2 if w >= 1.3 else 1
    each = w / count
    for k in range(count):
        middle = -w / 2 + each * (k + 0.5)
        half = min(0.36, each / 2 - 0.06)
        yield Stroke(_rect(back + 0.08, middle - half, fold - 0.07, middle + half, 0.08), 0.7)


def _sofa(d: float, w: float) -> Iterator[Stroke]:
    back, arm = -d / 2 + 0.24 * d, min(0.16, 0.14 * w)
    yield Stroke(_rect(-d / 2, -w / 2, back, w / 2), -0.1)
    yield Stroke(_rect(back, -w / 2, d / 2, -w / 2 + arm), -0.1)
    yield Stroke(_rect(back, w / 2 - arm, d / 2, w / 2), -0.1)
    count = max(1, round((w - 2 * arm) / 0.75))
    each = (w - 2 * arm) / count
    for k in range(count):
        y = -w / 2 + arm + each * k
        yield Stroke(_rect(back + 0.01, y + 0.01, d / 2 - 0.02, y + each - 0.01, 0.06), 0.12)


def _chair(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2, -w / 2, -d / 2 + 0.13 * d, w / 2), -0.12)


def _wardrobe(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(((d / 2 - 0.03, -w / 2), (d / 2 - 0.03, w / 2)))
    yield Stroke(((-0.01, -w / 2 + 0.04), (-0.01, w / 2 - 0.04)), weight=1.3)
    count = max(3, round(w / 0.09))
    for k in range(count):
        y = -w / 2 + w * (k + 0.5) / count
        lean = 0.012 * ((k * 7) % 5 - 2)
        yield Stroke(((-d * 0.34, y - lean), (d * 0.32, y + lean)), weight=0.7)


def _drawers(d: float, w: float) -> Iterator[Stroke]:
    front = d / 2 - 0.025
    yield Stroke(((front, -w / 2), (front, w / 2)))
    count = max(1, round(w / 0.55))
    for k in range(1, count):
        y = -w / 2 + w * k / count
        yield Stroke(((front, y), (d / 2, y)))
    for k in range(count):
        y = -w / 2 + w * (k + 0.5) / count
        yield Stroke(((front - 0.02, y - 0.05), (front - 0.02, y + 0.05)), weight=1.4)


def _shelves(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(((-d / 2 + 0.02, -w / 2), (-d / 2 + 0.02, w / 2)))
    count = max(1, round(w / 0.45))
    for k in range(1, count):
        y = -w / 2 + w * k / count
        yield Stroke(((-d / 2, y), (d / 2, y)))
    for k in range(count):
        left = -w / 2 + w * k / count
        step = w / count / 7
        for book in range(1, 6):
            y = left + step * book
            yield Stroke(((-d / 2 + 0.02, y), (d * (0.12 + 0.1 * ((book * 5 + k * 3) % 3)), y)), weight=0.6)


def _locker(d: float, w: float) -> Iterator[Stroke]:
    front = d / 2 - 0.03
    yield Stroke(((front, -w / 2), (front, w / 2)))
    yield Stroke(((-d / 2, -w / 2), (front, w / 2)), weight=0.6)


def _plant(d: float, w: float) -> Iterator[Stroke]:
    radius = min(d, w) / 2 * 0.92
    for ring, (length, count, tone) in enumerate(((1.0, 9, -0.13), (0.72, 7, 0.1), (0.42, 5, 0.32))):
        for k in range(count):
            angle = 2 * math.pi * (k + 0.5 * ring) / count + 0.3 * ring
            yield Stroke(_leaf(radius * length, angle), tone, 0.7)


def _leaf(length: float, angle: float) -> tuple[Vec2, ...]:
    profile = ((0.0, 0.0), (0.25, 0.13), (0.55, 0.19), (0.82, 0.11), (1.0, 0.0))
    side = [(x * length, y * length) for x, y in profile]
    points = [(x, -y) for x, y in side] + side[-2:0:-1]
    frame = SE2(yaw=angle)
    return tuple(frame.world(x, y) for x, y in points)


def _lamp(d: float, w: float) -> Iterator[Stroke]:
    radius = min(d, w) / 2
    yield Stroke(_circle(radius * 0.55), 0.55)
    yield Stroke(((-radius * 0.9, 0.0), (radius * 0.9, 0.0)), weight=0.7)
    yield Stroke(((0.0, -radius * 0.9), (0.0, radius * 0.9)), weight=0.7)


def _vase(d: float, w: float) -> Iterator[Stroke]:
    radius = min(d, w) / 2
    yield _ring(radius * 0.62)
    yield Stroke(_circle(radius * 0.4), -0.08)


def _screen(d: float, w: float) -> Iterator[Stroke]:
    if d > 0.12:
        yield Stroke(_circle(min(d * 0.36, 0.13)), 0.35)
    yield Stroke(_rect(-0.02, -w / 2 + 0.01, min(0.02, d / 2), w / 2 - 0.01), -0.45)


def _laptop(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2, -w / 2, -d / 2 + 0.03, w / 2), -0.35)
    yield Stroke(_rect(-d / 2 + 0.05, -w / 2 + 0.03, d * 0.12, w / 2 - 0.03), -0.14)
    yield Stroke(_rect(d * 0.2, -w * 0.17, d * 0.42, w * 0.17), 0.25)


def _books(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2 + 0.01, -w / 2 + 0.015, d / 2 - 0.025, w / 2 - 0.01), 0.3)
    yield Stroke(_rect(-d / 2 + 0.03, -w / 2 + 0.035, d / 2 - 0.06, w / 2 - 0.02), -0.1)


def _rug(d: float, w: float) -> Iterator[Stroke]:
    for inset in (0.06, 0.1):
        if min(d, w) > 4 * inset:
            x, y = d / 2 - inset, w / 2 - inset
            points = _rect(-x, -y, x, y)
            yield Stroke((*points, points[0]), weight=0.8)


def _treadmill(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2 + 0.08, -w / 2 + 0.14, d / 2 - 0.3, w / 2 - 0.14, 0.03), -0.32)
    yield Stroke(_rect(d / 2 - 0.2, -w / 2 + 0.06, d / 2 - 0.06, w / 2 - 0.06, 0.03), 0.3)


def _bench(d: float, w: float) -> Iterator[Stroke]:
    for share in (-0.25, 0.0, 0.25):
        yield Stroke(((share * d, -w / 2 + 0.02), (share * d, w / 2 - 0.02)), weight=0.8)


def _rack(d: float, w: float) -> Iterator[Stroke]:
    count = max(2, round(w / 0.2))
    for k in range(count):
        y = -w / 2 + w * (k + 0.5) / count
        yield Stroke(_circle(min(d * 0.3, w / count * 0.36), -d * 0.05, y, 20), -0.2)


def _toilet(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2, -w / 2, -d / 2 + 0.2 * d, w / 2, 0.03), 0.3)
    yield Stroke(tuple((0.12 * d + 0.34 * d * x, 0.4 * w * y) for x, y in _circle(1.0)), 0.5)


def _basin(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(tuple((0.04 * d + 0.34 * d * x, 0.38 * w * y) for x, y in _circle(1.0)), 0.5)
    yield _ring(0.02, -0.2 * d)


def _bathtub(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(_rect(-d / 2 + 0.07, -w / 2 + 0.07, d / 2 - 0.07, w / 2 - 0.07, 0.2), 0.55)


def _stove(d: float, w: float) -> Iterator[Stroke]:
    for x in (-0.22, 0.22):
        for y in (-0.22, 0.22):
            yield _ring(0.15 * min(d, w), x * d, y * w)


def _fridge(d: float, w: float) -> Iterator[Stroke]:
    yield Stroke(((d / 2 - 0.05, -w / 2), (d / 2 - 0.05, w / 2)))
    yield Stroke(((-d / 2, -w / 2), (d / 2 - 0.05, w / 2)), weight=0.6)
    yield Stroke(((-d / 2, w / 2), (d / 2 - 0.05, -w / 2)), weight=0.6)


_DRAWN: dict[str, Symbol] = {
    "nothing": lambda d, w: iter(()),
    "bed": _bed,
    "sofa": _sofa,
    "chair": _chair,
    "wardrobe": _wardrobe,
    "drawers": _drawers,
    "shelves": _shelves,
    "locker": _locker,
    "plant": _plant,
    "lamp": _lamp,
    "vase": _vase,
    "screen": _screen,
    "laptop": _laptop,
    "books": _books,
    "rug": _rug,
    "treadmill": _treadmill,
    "bench": _bench,
    "rack": _rack,
    "toilet": _toilet,
    "basin": _basin,
    "bathtub": _bathtub,
    "stove": _stove,
    "fridge": _fridge,
}
