"""Refrigerators, freezers, wine coolers."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.box import Interval
from ...drawing.components import CORNERS, SWING, bar_pull, cavity, compartments, door, knob, lip, rack, vessel, walls
from ...drawing.drawing import Look
from .bottles import bottle
from .kitchen_common import coat_of, feet

LEAF = 0.06
"""Thickness of the insulated door of a fridge [m]."""

REACH = 0.043
"""How far its handle stands out [m]."""


def _leaf(
    d: Drawing,
    name: str,
    leaf: Box,
    coat: Look,
    pull: Look,
    hung: Literal["left", "right"],
    grip: Interval,
    bevel: float = 0.006,
    bins: int = 0,
    more: Callable[[Box], None] | None = None,
) -> None:
    """A thick door with an upright handle between two heights, and bins inside; ``more`` draws what else it has."""
    limits = (0.0, SWING) if hung == "left" else (-SWING, 0.0)
    with d.hinge(name, leaf.anchor(f"front {hung} bottom"), limits=limits):
        d.box(leaf, coat, bevel=bevel)
        x, y = leaf.x[1], leaf.y[0] + 0.05 if hung == "left" else leaf.y[1] - 0.05
        bar_pull(d, (x, y, grip[0]), (x, y, grip[1]), pull)
        inside = leaf.inset(y=0.09, z=0.06).back(-0.09)  # clear of the case as it turns
        d.box(leaf.inset(y=0.02, z=0.02).back(-0.0035), "white plastic", bevel=0.0)  # its lining, with the seal
        for place in inside.rows(bins) if bins else []:
            floor = d.box(place.bottom(0.01), "white plastic", bevel=0.0)
            d.box(floor.back(0.004).top(-0.07), "clear plastic", bevel=0.0)
        if more:
            more(leaf)


def _cold_room(d: Drawing, box: Box, shelves: int, trays: int, stocked: int = 0) -> None:
    """A white lined room with boards of glass, over clear drawers that stand on its floor.

    So many of its boards, from the lowest, are surfaces.
    """
    room = cavity(d, box, "white plastic", 0.035, inside=None).inset(front=0.1, y=0.004)
    low = room.bottom(0.17 * trays)
    for cell in low.rows(trays, gap=0.01) if trays else []:
        d.box(cell.front(0.3), "clear plastic", bevel=0.004)
    rows = room.inset(bottom=low.height if trays else 0.0).rows(shelves + 1, gap=0.006)
    for cell in rows if trays else rows[1:]:
        d.box(cell.bottom(-0.006), "glass", bevel=0.0)
    compartments(d, rows)
    for k, cell in enumerate(rows[:stocked]):
        place = cell.bottom(0.0).inset(back=0.01, front=0.02, y=0.01)
        d.surface(f"shelf-{k}", place, round(cell.height - 0.003, 4))


def _cold_case(d: Drawing, box: Box, coat: Look, radius: float) -> Box:
    """The case of a fridge on its base; returns the room to line."""
    case = box.inset(bottom=0.035)
    d.box(case.bottom(-0.035).inset(front=0.02, back=0.04, y=0.015), "black plastic")
    return cavity(d, case, coat, 0.012, radius, inside=None)


@draws("fridge")
def fridge(d: Drawing) -> None:
    """A cabinet with two doors, the freezer below or above, upright handles and a small badge."""
    coat = coat_of(d, "cream paint", "red paint", "sage paint")
    pull = d.material("handles", "chrome", "brushed steel", "black steel")
    retro = coat.called("cream paint", "red paint", "sage paint")
    body = d.bounds.inset(front=LEAF + REACH + 0.004)
    hung: Literal["left", "right"] = d.pick("hung", ["left", "right"])
    low = d.chance("freezer below", 0.6) and not retro
    height = body.height
    split = height * (d.uniform("split low", 0.34, 0.4) if low else d.uniform("split high", 0.68, 0.74))
    fronts = body.inset(y=0.001, top=0.002, bottom=0.06).front(-LEAF).move(x=0.004)

    def badge(leaf: Box) -> None:
        d.box(leaf.front(-0.0015).place(width=0.09).top(0.13).bottom(0.015), pull, bevel=0.0)

    room = _cold_case(d, body, "grey plastic" if coat.metallic else coat, 0.02 if retro else 0.004)
    lower, upper = room.to(z=(room.z[0], split)), room.to(z=(split, room.z[1]))
    _cold_room(d, lower, 1 if low else 3, 2 if low else 1, 0 if low else 2)
    _cold_room(d, upper, 3 if low else 1, 1 if low else 0, 2 if low else 0)
    with d.part("doors"):
        for name, z in (("lower", (fronts.z[0], split - 0.003)), ("upper", (split + 0.003, fronts.z[1]))):
            leaf = fronts.to(z=z)
            long = min(0.55, 0.6 * leaf.height)
            grip = leaf.inset(z=0.06).top(long) if name == "lower" else leaf.inset(z=0.06).bottom(long)
            bins = 0 if leaf.height < 0.7 else 2
            more = badge if name == "upper" else None
            _leaf(d, f"{name} door", leaf, coat, pull, hung, grip.z, 0.025 if retro else 0.006, bins, more)
    d.fit()


@draws("side_by_side_fridge")
def side_by_side_fridge(d: Drawing) -> None:
    """Two tall doors with handles in the middle, an ice dispenser in one, or drawers below."""
    coat = d.material("body", d.pick("coat", ["brushed steel", "black paint", "white paint", "steel"]))
    pull = d.material("handles", "chrome", "brushed steel", "black steel")
    with_drawers = d.chance("drawers", 0.45)
    body = d.bounds.inset(front=LEAF + REACH + 0.004)
    low, middle = (0.62, 0.0) if with_drawers else (0.06, -0.04)
    fronts = body.inset(y=0.001).front(-LEAF).move(x=0.004)
    upper = fronts.to(z=(low, fronts.z[1]))

    def dispenser(leaf: Box) -> None:
        y = leaf.y[0] + (0.2 if with_drawers else 0.24)
        face = Box((leaf.x[1], leaf.x[1]), (y - 0.085, y + 0.085), (1.0, 1.32))
        d.box(face.front(-0.002), "black glass", bevel=0.0)
        niche = face.inset(y=0.025, bottom=0.02, top=0.12)
        d.box(niche.front(-0.004), "grey plastic", bevel=0.0)
        d.box(niche.bottom(0.01).front(-0.012), "brushed steel", bevel=0.0)
        d.box(niche.top(0.06).place(width=0.03).front(-0.014), "black plastic", bevel=0.002)
        d.print(face.front(-0.002).front(0.0).place(width=0.08).inset(top=0.04, bottom=0.25), "screen")

    with d.part("body"):
        room = _cold_case(d, body, "grey plastic", 0.004)
        cells = room.to(z=(low, room.z[1])).columns([middle - room.y[0], room.y[1] - middle])
        grip = (low + 0.12, body.z[1] - 0.25) if with_drawers else (0.5, body.z[1] - 0.35)
        sides: tuple[Literal["left", "right"], ...] = ("right", "left")
        for side, cell in zip(sides, cells, strict=True):
            _cold_room(d, cell, 3, 0 if with_drawers else 2)
            own = upper.to(y=(upper.y[0], middle - 0.003) if side == "right" else (middle + 0.003, upper.y[1]))
            _leaf(d, f"{side} door", own, coat, pull, side, grip, bins=3, more=dispenser if side == "right" else None)
        if with_drawers:
            d.box(room.to(z=(room.z[0], low)).back(0.3), "white plastic", bevel=0.0)
            for k, front in enumerate(fronts.to(z=(0.06, low - 0.006)).rows(2, gap=0.006)):
                with d.slide(f"drawer-{k}", limits=(0.0, 0.4)):
                    d.box(front, coat, bevel=0.006)
                    x, z = front.x[1], front.z[1] - 0.05
                    bar_pull(d, (x, front.y[0] + 0.1, z), (x, front.y[1] - 0.1, z), pull)
                    tray = front.inset(y=0.06, bottom=0.02, top=0.06).back(-0.25)
                    d.box(tray.bottom(0.006), "clear plastic", bevel=0.0)
                    for wall in (tray.left(0.005), tray.right(0.005), tray.back(0.005)):
                        d.box(wall.inset(bottom=0.006), "clear plastic", bevel=0.0)
    d.fit()


@draws("freezer")
def freezer(d: Drawing) -> None:
    """A chest with a padded lid hinged at its back, wire baskets inside, a lock, a grille and a lamp."""
    coat = d.material("body", "white paint", "white paint", "light grey paint", "black paint")
    bounds = d.bounds.inset(front=0.03)
    lid = bounds.height - 0.075
    chest = bounds.inset(y=0.006, bottom=0.025).to(z=(0.025, lid))
    with d.part("body"):
        feet(d, bounds.bottom(0.03))
        liner = chest.inset(x=0.02, y=0.02, bottom=0.02)
        room = liner.inset(x=0.04, y=0.04, bottom=0.045)
        for outer, inner, look in ((chest, liner, coat), (liner, room, "white plastic")):
            rings = [shapes.rectangle(outer.x, outer.y, z, 0.02) for z in outer.z]
            falling = [shapes.rectangle(inner.x, inner.y, z, 0.02) for z in inner.z[::-1]]
            vessel(d, rings, falling, look, CORNERS, inside=None if inner is liner else "inside")
        rack(d, room.inset(x=0.004, y=0.004, top=0.06).left(0.24), "white steel")
        walls(d, liner.top(-0.008), "rubber", 0.02, 0.0)
        face = chest.front(0.0)
        for k in range(5):
            slat = face.left(0.2).move(y=-0.06).to(z=(0.08 + 0.022 * k, 0.089 + 0.022 * k))
            d.box(slat.front(-0.003), "grey plastic", bevel=0.0)
        panel = d.box(face.right(0.14).move(y=0.06).to(z=(0.1, 0.16)).front(-0.002), "grey plastic", bevel=0.0)
        knob(d, panel.right(0.08), "black plastic", 0.013, 0.012)
        d.print(panel.left(0.05).front(0.0).place(width=0.03, height=0.01), "lamp glow")
        with d.hinge("lid", d.bounds.anchor("back top"), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0), role="lid"):
            cover = d.box(d.bounds.inset(front=0.022).to(z=(lid + 0.0085, bounds.z[1])), coat, bevel=0.016)
            lip(d, cover.bottom(0.03).move(z=0.012).front(-0.022).place(width=0.2), "grey plastic", bevel=0.006)
            d.print(cover.front(0.0).place(width=0.036, height=0.01).move(y=0.16), "chrome")
    d.fit()


@draws("wine_cooler")
def wine_cooler(d: Drawing) -> None:
    """A dark box with a glass door, in it racks of beech with rows of bottles under a lamp."""
    coat = d.material("body", "black paint", "brushed steel", "black steel")
    pull = d.material("handle", "chrome", "brushed steel", "black steel")
    hung: Literal["left", "right"] = "left" if d.chance("hung", 0.5) else "right"
    body = d.bounds.inset(front=0.07)
    with d.part("body"):
        feet(d, body.bottom(0.03))
        case = body.inset(bottom=0.03)
        d.box(case.bottom(0.05).inset(back=0.02, front=0.01, y=0.01), "black plastic", bevel=0.0)
        room = cavity(
            d, cavity(d, case.inset(bottom=0.05), coat, 0.012, 0.004, None), "black plastic", 0.02, inside=None
        )
        d.print(room.top(0.0).inset(y=0.03).front(0.03), "lamp glow")
        rows = room.inset(top=0.03).rows(max(4, round((room.height - 0.05) / 0.15)))
        count = max(3, int(room.width / 0.095))
        radius = min(0.037, room.width / count / 2 - 0.002)
        for k, row in enumerate(rows):
            rack(d, row.bottom(0.008).inset(front=0.035, back=0.01), "black steel", 0.04)
            d.box(row.front(0.04).bottom(0.03).inset(front=0.015), "beech", bevel=0.002)
            for j, place in enumerate(row.inset(back=0.02).columns(count)):
                if (k * count + j) % 7 != 5:
                    x, y, z = place.anchor("back bottom")
                    with d.at(x, y, z + 0.009 + radius, pitch=math.pi / 2):
                        glass = "green glass" if (j + k) % 3 else "amber glass"
                        bottle(d, radius, 0.302, glass, ("red plastic", "brass", "black plastic")[k % 3])
        door(d, "door", case.inset(bottom=0.05).front(-0.041).inset(back=0.001), coat, pull, hung, "bar", "glass")
    d.fit()
