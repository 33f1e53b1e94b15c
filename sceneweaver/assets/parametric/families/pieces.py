"""Drawings as tables: things that are a few simple bodies, by their numbers in ``pieces/*.yaml``.

A drawing begins with its finishes, each under a letter, with ``fit: round`` where it is as wide as deep, and with
``turned: depth`` where only what is turned in it is. Each line after that is some bodies of one shape and finish: the
shape, the letter, and the numbers of one body after the other with ``;`` between them. Places are shares of the size
from 0 to 1: x from back to front, y from right to left, z from bottom to top; radii are shares of the shortest side
that they lie in, widths and profiles of the size itself. See ``_SHAPES`` for the numbers of each. ``fill`` and ``wrap``
take two heights: what is in the vessel of a line before, and a label around it. Before a line may stand

- ``?0.5``: only in that share of the seeds; ``=name``: only in that form, one of ``form: name, other``,
- ``*4 0 .2 0``: so many copies, each moved on by these shares; ``^y``: once more mirrored at y (x, or both),
- ``~``: the line goes on with the one before it,
- ``+name``: the bodies from here on are one prism of the engine of that name; without any, all are one,
- ``@name``: the bodies from here on are a thing that can be taken; ``@`` alone ends it.

``surface name x0 x1 y0 y1 z``, perhaps with headroom, is a place for other things.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from functools import partial
from importlib import resources

from ...category import read_yaml
from ...drawing import MAKERS, PROUD, Axis, Box, Drawing, Look, Maker
from ...drawing.components import tub
from ...drawing.tree import pose
from .small_parts import BARE, filling, open_vessel, wrap

Numbers = Sequence[float]

LOOSE = "contents"
"""The part of a drawing that is left out where other things are asked for in its place."""


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
    """x0 x1 y0 y1 z0 z1 of what lies on another body, and by how many millimetres it stands out (below 0.5)."""
    d.print(_place(whole, n), look, n[6] / 1000 if len(n) > 6 else PROUD)


def _oval(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """The same for what is round."""
    d.print(_place(whole, n), look, n[6] / 1000 if len(n) > 6 else PROUD, oval=True)


def _silhouette(d: Drawing, whole: Box, look: Look, n: Numbers, axis: Axis) -> None:
    """Two places along the axis, then points: (x, z) of a side, (y, z) of a face, (x, y) of a plan."""
    d.silhouette(whole.share(**{axis: (n[0], n[1])}), list(zip(n[2::2], n[3::2], strict=True)), look, axis)


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


def _profile(n: Numbers) -> list[tuple[float, float]]:
    return [(2 * r, z) for r, z in zip(n[::2], n[1::2], strict=True)]


def _about(whole: Box, x: float, y: float, even: bool = False) -> Box:
    """The box moved so that its middle is at two shares; as wide as deep when ``even``."""
    box = whole.place(width=whole.depth) if even else whole
    return box.move((x - 0.5) * whole.depth, (y - 0.5) * whole.width)


def _turned(d: Drawing, whole: Box, look: Look, n: Numbers, even: bool = False) -> None:
    """x y, then pairs of radius and z from bottom to top; stretched to an ellipse where depth and width differ."""
    d.turned(_about(whole, n[0], n[1], even), _profile(n[2:]), look, 24)


def _open(d: Drawing, whole: Box, look: Look, n: Numbers, even: bool = False, holds: bool = True) -> None:
    """x y, thickness of the wall [mm; below 1 a share of the width], z of the floor inside, pairs of radius and z."""
    box = _about(whole, n[0], n[1], even)
    open_vessel(d, box, _profile(n[4:]), look, n[2] / 1000 if n[2] >= 1 else n[2] * box.width, n[3], holds=holds)


def _sections(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x y, radius of corners as a share of a section's shorter side (0: an ellipse), then depth, width, z of each."""
    rows = [n[k : k + 3] for k in range(3, len(n), 3)]
    d.sections(_about(whole, n[0], n[1]), rows, look, n[2] or None)


def _arch(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """Radius as of a bar, both ends, and how far it reaches out of their middle."""
    x, y, z = (share * size for share, size in zip(n[7:], whole.size, strict=True))
    start, end = _points(whole, n[1:7])
    d.arch(start, end, (x, y, z), n[0] * min(whole.size), look, 8)


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


def _tub(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1 of an open box, its wall [mm], and how much narrower it is below, as a share of its depth."""
    box = _place(whole, n)
    tub(d, box, look, n[6] / 1000, (n[7] if len(n) > 7 else 0.0) * box.depth)


def _inside(d: Drawing, whole: Box, look: Look, n: Numbers) -> None:
    """x0 x1 y0 y1 z0 z1 of room between other bodies, open above."""
    d.interior("inside", _place(whole, n))


_SHAPES: dict[str, Callable[[Drawing, Box, Look, Numbers], None]] = {
    "box": _box,
    "slab": _slab,
    "print": _print,
    "oval": _oval,
    "side": partial(_silhouette, axis="y"),
    "face": partial(_silhouette, axis="x"),
    "plan": partial(_silhouette, axis="z"),
    "cushion": _cushion,
    "up": partial(_round, axis="z"),  # x y z0 z1, radius at the bottom and at the top
    "x": partial(_round, axis="x"),  # x0 x1 y z, radius at the back and in front
    "y": partial(_round, axis="y"),  # y0 y1 x z, radius at the right and at the left
    "ball": _ball,
    "turned": _turned,
    "open": _open,
    "full": partial(_open, holds=False),  # the same with a stopper, or with things in it
    "sections": _sections,
    "arch": _arch,
    "bar": _bar,
    "ring": _ring,
    "hull": _hull,
    "tub": _tub,
    "inside": _inside,
}


def draw(d: Drawing, text: str) -> None:
    """A thing of the tables."""
    lines = text.strip().replace("\n~", "").splitlines()
    settings = "; ".join(line.rstrip(";") for line in lines if ":" in line)
    named = dict(entry.split(": ") for entry in settings.split("; "))
    whole = d.even(named.pop("fit", "box"))  # pyright: ignore[reportArgumentType]
    even = named.pop("turned", "") == "depth"
    shapes = _SHAPES | {"turned": partial(_turned, even=even), "open": partial(_open, even=even)}
    shapes["full"] = partial(_open, even=even, holds=False)
    form = d.pick("form", named.pop("form").split(", ")) if "form" in named else ""
    looks = {letter: d.material(letter, names) for letter, names in named.items()}
    group: str | None = None if "\n+" in text else "all"
    item = ExitStack()  # open while lines draw what can be taken
    last, layer = (whole, []), 0
    for number, line in enumerate(line for line in lines if ":" not in line):
        words, drawn = line.split(), True
        if words[0][0] == "+":
            group = words[0][1:]
            continue
        if group == LOOSE and d.request.shape == BARE:
            continue
        if words[0][0] == "@":
            item.close()
            if words[0][1:]:
                item.enter_context(d.item(words[0][1:]))
            continue
        if words[0] == "surface":
            x0, x1, y0, y1, z, *headroom = (float(word) for word in words[2:])
            own = whole.share((x0, x1), (y0, y1), (0.0, z))
            d.surface(words[1], own, headroom[0] * whole.height if headroom else None)
            continue
        with ExitStack() as around:
            around.enter_context(d.part(group or f"piece {number}"))
            while (sign := words[0][0]) in "?=*^":
                word = words.pop(0)[1:]
                if sign == "?":
                    drawn &= d.chance(f"piece {number}", float(word))
                elif sign == "=":
                    drawn &= word == form
                elif sign == "^":
                    around.enter_context(d.mirror(*word))
                else:
                    x, y, z = (float(words.pop(0)) * size for size in whole.size)
                    frames = [pose(k * x, k * y, k * z) for k in range(int(word))]
                    around.enter_context(d.copies(frames))
            if not drawn:
                continue
            shape, look = words[0], looks[words[1]]
            for body in " ".join(words[2:]).split(";"):
                numbers = [float(word) for word in body.split()]
                if shape == "fill":
                    filling(d, *last, numbers[0], numbers[1], look)
                elif shape == "wrap":
                    wrap(d, *last, numbers[0], numbers[1], look, layer)
                    layer += 1
                else:
                    shapes[shape](d, whole, look, numbers)
                if shape in ("turned", "open", "full"):
                    last, layer = (
                        (
                            _about(whole, numbers[0], numbers[1], even),
                            _profile(numbers[2 if shape == "turned" else 4 :]),
                        ),
                        0,
                    )
    item.close()
    d.fit(whole.size)


def _register() -> None:
    folder = resources.files((__package__ or "").rpartition(".")[0]).joinpath("pieces")
    for file in sorted(folder.iterdir(), key=lambda f: f.name):
        if file.name.endswith(".yaml"):
            for name, text in read_yaml(file).items():
                if name in MAKERS:
                    raise ValueError(f"{file.name}: two drawings of {name}")
                MAKERS[name] = _maker(text)


def _maker(text: str) -> Maker:
    def drawn(d: Drawing) -> None:
        draw(d, text)

    return drawn


_register()
