"""Drawings as tables: things that are a few simple bodies, by their numbers in ``pieces/*.yaml``.

A drawing begins with its finishes, each under a letter, and with ``fit: round`` where it is as wide as deep. Each line
after that is some bodies of one shape and finish: the shape, the letter, and the numbers of one body after the other
with ``;`` between them. Places are shares of the size from 0 to 1: x from back to front, y from right to left, z from
bottom to top; radii are shares of the shortest side that they lie in. See ``_SHAPES`` for the numbers of each. Before a
line may stand

- ``?0.5``: only in that share of the seeds,
- ``*4 0 .2 0``: so many copies, each moved on by these shares,
- ``~``: the line goes on with the one before it,
- ``+name``: the bodies from here on are one prism of the engine of that name; without any, all are one.

``surface name x0 x1 y0 y1 z``, perhaps with headroom, is a place for other things.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import resources

from ...category import read_yaml
from ...drawing import MAKERS, Axis, Box, Drawing, Look

Numbers = Sequence[float]


def _place(whole: Box, n: Numbers) -> Box:
    """The box of six shares."""
    return whole.share((n[0], n[1]), (n[2], n[3]), (n[4], n[5]))


def _points(whole: Box, n: Numbers) -> list[tuple[float, float, float]]:
    return [whole.point(*n[k : k + 3]) for k in range(0, len(n), 3)]


def _box(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, bevel as a share of the shortest side."""
    box = _place(whole, n)
    d.box(box, look, (n[6] if len(n) > 6 else 0.06) * min(box.size))


def _slab(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, radius in plan as a share of the shorter side."""
    box = _place(whole, n)
    side = min(box.depth, box.width)
    d.slab(box, look, (n[6] if len(n) > 6 else 0.15) * side, 0.12 * min(side, box.height))


def _print(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1 of what lies on another body, and stands out of it by less than half a millimetre."""
    d.print(_place(whole, n), look)


def _cushion(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1, puff."""
    box = _place(whole, n)
    d.cushion(box, look, 0.3 * min(box.size), n[6] if len(n) > 6 else 0.0)


def _round(d: Drawing, whole: Box, look: Look, n: Numbers, axis: Axis) -> None:
    """Two places across the axis and two along it (up), or two along it and two across, and the radius at each end."""
    k = "xyz".index(axis)
    a, b, u, v = n[:4]
    middle = {"z": (a, b, (u + v) / 2), "x": ((a + b) / 2, u, v), "y": (u, (a + b) / 2, v)}[axis]
    radii = [share * min(size for m, size in enumerate(whole.size) if m != k) for share in (n[4], n[-1])]
    size = [2 * max(radii)] * 3
    size[k] = ((v - u) if axis == "z" else (b - a)) * whole.size[k]
    d.cylinder(Box.around(whole.point(*middle), *size), look, axis, (radii[0] / max(radii), radii[1] / max(radii)))


def _ball(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """Middle and radii as shares of depth, width and height."""
    box = Box.around(whole.point(*n[:3]), *(2 * share * size for share, size in zip(n[3:6], whole.size, strict=True)))
    d.ball(box, look, 12 if max(box.size) < 0.1 else 20)


def _turned(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x y, then pairs of radius and z from bottom to top; stretched to an ellipse where depth and width differ."""
    box = whole.move((n[0] - 0.5) * whole.depth, (n[1] - 0.5) * whole.width)
    d.turned(box, [(2 * r, z) for r, z in zip(n[2::2], n[3::2], strict=True)], look, 20)


def _bar(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """Radius, then points; the radius is a share of the shortest side of all."""
    d.sweep(_points(whole, n[1:]), n[0] * min(whole.size), look, 8)


def _ring(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """Axis (0 x, 1 y, 2 z), middle, radius of the ring and of its wire, as shares of the shorter side across it."""
    axis = int(n[0])
    side = min(size for k, size in enumerate(whole.size) if k != axis)
    size = [0.0 if k == axis else 2 * n[4] * side for k in range(3)]
    d.hoop(Box.around(whole.point(*n[1:4]), *size), n[5] * side, look, ("x", "y", "z")[axis])


def _hull(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """Points of a convex body."""
    d.hull(_points(whole, n), look)


_SHAPES: dict[str, Callable[[Drawing, Box, Look, Numbers], None]] = {
    "box": _box,
    "slab": _slab,
    "print": _print,
    "cushion": _cushion,
    "up": partial(_round, axis="z"),  # x y z0 z1, radius at the bottom and at the top
    "x": partial(_round, axis="x"),  # x0 x1 y z, radius at the back and in front
    "y": partial(_round, axis="y"),  # y0 y1 x z, radius at the right and at the left
    "ball": _ball,
    "turned": _turned,
    "bar": _bar,
    "ring": _ring,
    "hull": _hull,
}


def draw(d: Drawing, text: str) -> None:
    """A thing of the tables."""
    lines = text.strip().replace("\n~", "").splitlines()
    settings = "; ".join(line.rstrip(";") for line in lines if ":" in line)
    named = dict(entry.split(": ") for entry in settings.split("; "))
    whole = d.even(named.pop("fit", "box"))  # pyright: ignore[reportArgumentType]
    looks = {letter: d.material(letter, names) for letter, names in named.items()}
    group: str | None = None if "\n+" in text else "all"
    for number, line in enumerate(line for line in lines if ":" not in line):
        words = line.split()
        if words[0][0] == "+":
            group = words[0][1:]
            continue
        if words[0][0] == "?" and not d.chance(f"piece {number}", float(words.pop(0)[1:])):
            continue
        if words[0] == "surface":
            x0, x1, y0, y1, z, *headroom = (float(word) for word in words[2:])
            own = whole.share((x0, x1), (y0, y1), (0.0, z))
            d.surface(words[1], own, headroom[0] * whole.height if headroom else None)
            continue
        count, step = 1, (0.0, 0.0, 0.0)
        if words[0][0] == "*":
            count = int(words[0][1:])
            step = tuple(float(word) * size for word, size in zip(words[1:4], whole.size, strict=True))
            words = words[4:]
        bodies = [[float(word) for word in body.split()] for body in " ".join(words[2:]).split(";")]
        for k in range(count):
            with d.part(group or f"piece {number}"), d.at(*(k * v for v in step)):
                for numbers in bodies:
                    _SHAPES[words[0]](d, whole, looks[words[1]], numbers)
    d.fit(whole.size)


def _register() -> None:
    folder = resources.files((__package__ or "").rpartition(".")[0]).joinpath("pieces")
    for file in sorted(folder.iterdir(), key=lambda f: f.name):
        if file.name.endswith(".yaml"):
            for name, text in read_yaml(file).items():
                if name in MAKERS:
                    raise ValueError(f"{file.name}: two drawings of {name}")
                MAKERS[name] = partial(draw, text=text)


_register()
