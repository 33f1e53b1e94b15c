"""What beds share: bedding, head boards, barred sides, ladders."""

from __future__ import annotations

import numpy as np

from ...drawing import Box, Drawing, Look
from ...drawing.box import Axis
from ...drawing.components import blanket, cushions, mattress, slats

SHEETS = "white fabric, beige fabric, white fabric"
_COLORS = ("blue", "navy", "green", "mustard", "rust", "rose", "grey", "charcoal", "red")
BLANKETS = ", ".join(f"{color} fabric" for color in _COLORS)
BOARDS = {"channels": 0.09, "tufted": 0.08, "arch": 0.055, "panel": 0.045, "slats": 0.045, "rails": 0.045}
BOARDS |= {"rods": 0.04, "arched rods": 0.04}
"""How far the mattress stays off the wall for a head board of each style [m]."""


def bedding(
    d: Drawing,
    box: Box,
    name: str = "bed",
    pillows: int = 2,
    hem: float | None = None,
    surface: str | None = "top",
    overhang: float = 0.0,
    runner: bool = False,
    thick: float = 0.17,
) -> None:
    """A mattress that fills a box, pillows at its head (-x), and a blanket turned down over the rest.

    The blanket hangs down to the height ``hem`` at the sides, in folds that stand out there by ``overhang`` [m]. An
    unmade bed has it thrown back in a heap, and its pillows lie askew.
    """
    unmade = d.takes("unmade") is not None
    sheet, cover = d.material("sheet", SHEETS), d.material("blanket", BLANKETS)
    long = box.depth > 1.7
    start, top = box.x[0] + (0.62 if long else 0.42), box.z[1] + 0.032
    swing = max(0.0, overhang - 0.008)
    low = box.z[0] + 0.4 * box.height if hem is None else hem
    cloth = box.inset(y=-overhang).to(x=(start, box.x[1] + (overhang or 0.004)), z=(low, top))
    flat = cloth.inset(y=swing - 0.006, bottom=cloth.height - 0.16 if overhang else 0.02)
    end = cloth.x[1] - 0.07
    with d.part(name):
        mattress(d, box if overhang else box.inset(y=0.012), sheet, piping=sheet)
        if unmade:
            _thrown_back(d, box.to(x=(start - 0.1, box.x[1])), cover, name)
        else:
            blanket(d, cloth, cover, 0.07, swing, d.uniform(f"{name} folds", 0, 6), 0.06)
    if unmade:
        _pillows_askew(d, box, name, pillows, thick, sheet)
        return
    if runner:
        band = flat.inset(front=0.2, top=-0.01).front(0.42)
        end = band.x[0] - 0.04
        with d.part(f"{name} runner"):
            blanket(d, band, d.material("runner", "@fabric"), 0.04)
    if surface:
        d.surface(surface, cloth.inset(y=0.08).to(x=(start + 0.27, end)))
    white = d.chance("white pillows", 0.4)
    case = d.material("pillows", "white fabric") if white else sheet
    depth, wide = (0.46 if long else 0.32), min(0.78 if pillows == 2 else 0.66, (box.width - 0.06) / pillows - 0.03)
    x, y, z = box.anchor("back top")
    off = (pillows - 1) / 2 * (wide + 0.03)
    with d.part(f"{name} pillows"):
        blanket(d, flat.inset(top=-0.014).to(x=(start + 0.004, start + 0.24)), sheet, 0.05)
        with d.along((x, y - off, z), (x, y + off, z), pillows):
            with d.at(0.03 + depth / 2, z=0.01, pitch=0.12):
                d.pillow(Box.sized(depth, wide, thick), case)
            if thick > 0.145 and d.chance("double pillows", 0.6):
                with d.at(0.2, z=0.2, pitch=0.85):
                    d.pillow(Box.sized(0.9 * depth, 0.96 * wide, 0.9 * thick), cover)


def _thrown_back(d: Drawing, box: Box, cover: Look, name: str) -> None:
    """A blanket in waves and ridges over a box, slanting where it was thrown back."""
    phase, slant = d.uniform(f"{name} waves", 0.0, 6.0), d.uniform(f"{name} slant", 0.15, 0.4)
    along, across = np.meshgrid(np.linspace(0.0, 1.0, 22), np.linspace(0.0, 1.0, 20), indexing="ij")
    first = box.x[0] + slant * box.depth * (0.5 + 0.5 * np.sin(2.6 * across + phase))
    x = first + along * (box.x[1] - 0.02 - first)
    y = box.y[0] + 0.02 + across * (box.width - 0.04) + 0.015 * np.sin(9.0 * along + phase)
    waves = np.sin(11.0 * along + 4.0 * across + phase) + np.sin(15.0 * across - 6.0 * along + 2.0 * phase)
    ridge = np.exp(-((along - 0.06 - 0.03 * np.sin(7.0 * across)) ** 2) / 0.004)
    z = box.z[1] + 0.03 + 0.014 * (waves + 2.0) + 0.075 * ridge
    z = z - 0.03 * (np.abs(2.0 * across - 1.0) ** 8 + (along > 0.97))
    d.sheet(np.stack([x, np.clip(y, *box.y), z], axis=-1), 0.02, cover, (3, 2))


def _pillows_askew(d: Drawing, box: Box, name: str, count: int, thick: float, case: Look) -> None:
    """Pillows where somebody slept on them."""
    deep, wide = 0.42, min(0.7, (box.width - 0.12) / count - 0.08)
    x, _, z = box.anchor("back top")
    with d.part(f"{name} pillows"):
        for k in range(count):
            y = (k + 0.5) / count - 0.5
            turn = (-1.0) ** k * d.uniform(f"{name} pillow {k}", 0.1, 0.3)
            with d.at(x + 0.1 + deep / 2, y * box.width, z + 0.004, yaw=turn, pitch=0.08):
                d.pillow(Box.sized(deep, wide, 0.8 * thick), case)


def barred(
    d: Drawing,
    box: Box,
    wood: Look,
    low: float,
    post: float = 0.05,
    rail: float = 0.06,
    pitch: float = 0.12,
    bar: float = 0.02,
    fill: str = "slats",
    axis: Axis = "y",
) -> None:
    """A side of a bed along an axis: posts at both ends, rails at its top and at the height ``low``, and what fills it.

    Args:
        d: The drawing.
        box: Its place, as thick as the posts.
        wood: What it is of.
        low: Where its lower rail begins [m].
        post: Width of its posts; 0 for none.
        rail: Height of its rails.
        pitch: Between bars.
        bar: Their size.
        fill: "slats", "rods" (round ones), "rails" (two boards) or "panel".
        axis: What it runs along.
    """
    ends, across = (("right", "left"), "x") if axis == "y" else (("back", "front"), "y")
    for end in ends if post else ():
        d.box(getattr(box, end)(post), wood, bevel=0.005)
    thick = box.depth if axis == "y" else box.width
    inner = box.inset(**{axis: post, across: 0.15 * thick}).inset(top=0.01).to(z=(low, box.z[1] - 0.01))
    d.box(inner.top(rail), wood, bevel=0.006)
    d.box(inner.bottom(rail), wood)
    room = inner.inset(z=rail - 0.004)
    if fill == "panel":
        d.box(room.inset(**{across: 0.2 * thick}), wood)
    elif fill == "rails":
        for row in room.rows([1, 2, 1, 2, 1])[1::2]:
            d.box(row.inset(**{across: 0.05 * thick}), wood)
    else:
        slats(d, room, wood, pitch, bar, axis, fill == "rods")


def head_board(d: Drawing, box: Box, low: float, style: str, cover: Look, wood: Look) -> None:
    """A head board of one of the `BOARDS` over the back of a box, from the floor up; ``low``: where it is seen [m]."""
    high = box.z[1]
    seen = box.inset(bottom=low)
    with d.part("head board"):
        if style == "panel":
            board = d.box(box.back(0.035), wood, bevel=0.006)
            d.box(board.front(-0.01).inset(back=-0.002, y=0.07, bottom=low, top=0.07), wood, bevel=0.004)
        elif style == "channels":
            d.box(box.back(0.04).inset(top=0.01), cover, bevel=0.01)
            strips = seen.back(0.095).inset(back=0.02)
            cushions(d, strips, max(5, round(box.width / 0.17)), cover, 0.035, 0.0, 0.0)
        elif style == "tufted":
            board = d.cushion(box.back(0.085), cover, 0.035)
            count, rows = max(4, round(box.width / 0.22)), 2 if seen.height < 0.55 else 3
            for k in range(rows):
                row = board.front(0.0).top(0.0).move(x=-0.002, z=-0.1 - 0.14 * k).inset(y=k % 2 * box.width / count / 2)
                with d.grid(row, y=count - k % 2):
                    d.ball(Box.around((0.0, 0.0, 0.0), 0.018, 0.028, 0.028), cover, segments=8)
        elif style == "arch":
            angle = np.linspace(0, np.pi, 17)
            rise = min(0.35, 0.45 * seen.height)
            arch = np.c_[np.cos(angle) * box.width / 2, high - rise + np.sin(angle) * rise]
            outline = np.r_[arch, [(box.y[0], 0.0), (box.y[1], 0.0)]]
            pad = (arch - (0.0, low)) * (0.86, 0.8) + (0.0, low + 0.04)
            pad = np.r_[pad, [(0.86 * box.y[0], low), (0.86 * box.y[1], low)]]
            d.extrude(outline, (box.x[0], box.x[0] + 0.05), cover, axis="x", bevel=0.012)
            d.extrude(pad, (box.x[0] + 0.03, box.x[0] + 0.062), cover, axis="x", bevel=0.01)
        elif "rods" in style:
            rods(d, box.back(0.04), wood, low, "arched" in style)
        else:
            barred(d, box.back(0.05), wood, low - 0.08, rail=0.09, fill=style)


def rods(d: Drawing, box: Box, metal: Look, low: float, arched: bool = True) -> None:
    """A side of a bed of metal rods between two posts with finials; the top rail is an arch in some."""
    y, post, rise = box.width / 2 - 0.02, box.depth / 2, 0.2 * (box.z[1] - low) if arched else 0.0
    spring = box.z[1] - rise - (0.012 if arched else 0.05)
    with d.at(box.center[0]):
        with d.mirror("y"):
            d.bar((0.0, y, 0.0), (0.0, y, spring + 0.01), 0.9 * post, metal)
            d.ball(Box.around((0.0, y, spring + 0.02), 0.05, 0.04, 0.05), metal, segments=12)
        d.bar((0.0, -y, low), (0.0, y, low), 0.012, metal, segments=8)
        t = np.linspace(-1.0, 1.0, 9 if arched else 2)
        d.sweep(np.c_[0 * t, t * y, spring + rise * (1 - t**2)], 0.012, metal, segments=8)
        for s in np.linspace(-1.0, 1.0, 2 * round(y / 0.12) + 1)[1:-1].tolist():
            top = spring + rise * (1 - s * s)
            d.bar((0.0, s * y, low), (0.0, s * y, top), 0.006, metal, segments=6)


def ladder(d: Drawing, box: Box, material: Look, rungs: int) -> None:
    """A ladder that fills a box: stiles at both ends of x that lean from its left at the floor to its right."""
    lean = box.width - 0.05
    for x in (box.x[0], box.x[1]):
        ends = [(box.z[0], box.y[1] - 0.05), (box.z[1], box.y[0])]
        d.hull([(x + s, y + t, z) for s in (-0.016, 0.016) for t in (0, 0.05) for z, y in ends], material)
    for step in np.linspace(0.0, 1.0, rungs + 2)[1:-1].tolist():
        y = box.y[0] + lean * (1 - step) + 0.025
        z = box.z[0] + step * box.height
        d.box(Box.around((box.center[0], y, z), box.depth - 0.028, 0.06, 0.024), material)
