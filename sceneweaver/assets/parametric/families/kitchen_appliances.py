"""Refrigerators, freezers, stoves, ovens, hoods, dishwashers, microwaves, wine coolers."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal

from sceneweaver.assets import shapes
from sceneweaver.assets.body import Material

from ..builder import Builder, Interval
from ..joinery import carcass, door, handle
from ..registry import draws
from .kitchen_parts import Finish, burners, coat_of, feet, knob, oven_door, worktop_of


def _leaf(
    b: Builder,
    name: str,
    x: Interval,
    y: Interval,
    z: Interval,
    coat: Finish,
    pull: Finish,
    hung: str,
    at: Interval,
    bevel: float = 0.006,
    more: Callable[[], None] | None = None,
) -> None:
    """A thick door of an appliance with an upright bar handle between two heights, away from its hinge.

    ``more`` draws what else is on it.
    """
    anchor = (x[1], y[1] if hung == "left" else y[0], z[0])
    limits = (0.0, 1.92) if hung == "left" else (-1.92, 0.0)
    with b.hinge(name, anchor, limits=limits):
        b.box(x, y, z, coat, bevel=bevel)
        py = y[0] + 0.05 if hung == "left" else y[1] - 0.05
        b.bar((x[1] + 0.032, py, at[0]), (x[1] + 0.032, py, at[1]), 0.011, pull, 10)
        for pz in (at[0] + 0.03, at[1] - 0.03):
            b.bar((x[1] - 0.001, py, pz), (x[1] + 0.032, py, pz), 0.008, pull, 8)
        if more is not None:
            more()


@draws("fridge")
def fridge(b: Builder) -> None:
    """A cabinet with two doors, the freezer below or above, upright handles and a small badge."""
    d, w, h = b.size
    coat = coat_of(b, "cream paint", "red paint", "sage paint")
    pull = b.material("handles", "chrome", "brushed steel", "black steel")
    side: Finish = "grey plastic" if coat.metallic else coat
    retro = coat.name in ("cream paint", "red paint", "sage paint")
    x, y = (-d / 2, d / 2 - 0.105), (-w / 2, w / 2)
    hung = b.pick("hung", ["left", "right"])
    low = b.chance("freezer below", 0.6) and not retro
    split = h * (b.uniform("split low", 0.34, 0.4) if low else b.uniform("split high", 0.68, 0.74))
    leaf = (x[1] + 0.004, x[1] + 0.062)

    def badge() -> None:
        b.box((leaf[1] - 0.002, leaf[1] + 0.0015), (-0.045, 0.045), (h - 0.13, h - 0.115), pull, bevel=0)

    with b.solid("body"):
        feet(b, (x[0], x[1]), y, 0.04)
        b.box(x, y, (0.035, h), side, bevel=0.02 if retro else 0.004)
        b.box((x[1] - 0.04, x[1] + 0.03), (y[0] + 0.02, y[1] - 0.02), (0.012, 0.05), "black plastic", bevel=0)
        b.box((x[1] - 0.001, x[1] + 0.004), (y[0] + 0.012, y[1] - 0.012), (0.07, h - 0.015), "rubber", bevel=0)
        bevel = 0.025 if retro else 0.006
        for name, zs in (("lower", (0.06, split - 0.003)), ("upper", (split + 0.003, h - 0.002))):
            long = min(0.55, 0.6 * (zs[1] - zs[0]))
            at = (zs[1] - 0.06 - long, zs[1] - 0.06) if name == "lower" else (zs[0] + 0.06, zs[0] + 0.06 + long)
            more = badge if name == "upper" else None
            _leaf(b, f"{name} door", leaf, (y[0] + 0.001, y[1] - 0.001), zs, coat, pull, hung, at, bevel, more)
    b.fit()


@draws("side_by_side_fridge")
def side_by_side_fridge(b: Builder) -> None:
    """Two tall doors with handles in the middle, an ice dispenser in one, or drawers below."""
    d, w, h = b.size
    coat = b.material("body", "brushed steel", "black paint", "white paint", "steel")
    pull = b.material("handles", "chrome", "brushed steel", "black steel")
    x, y = (-d / 2, d / 2 - 0.115), (-w / 2, w / 2)
    leaf = (x[1] + 0.004, x[1] + 0.072)
    drawers = b.chance("drawers", 0.45)
    low = 0.62 if drawers else 0.06
    m = 0.0 if drawers else -0.04

    def dispenser() -> None:
        cy = y[0] + 0.24 if not drawers else y[0] + 0.2
        f = leaf[1]
        b.box((f - 0.003, f + 0.002), (cy - 0.085, cy + 0.085), (1.0, 1.32), "black glass", bevel=0)
        b.box((f - 0.003, f + 0.004), (cy - 0.06, cy + 0.06), (1.02, 1.2), "grey plastic", bevel=0)
        b.box((f, f + 0.012), (cy - 0.05, cy + 0.05), (1.02, 1.03), "brushed steel", bevel=0)
        b.box((f, f + 0.014), (cy - 0.015, cy + 0.015), (1.13, 1.19), "black plastic", bevel=0.002)
        b.box((f, f + 0.0028), (cy - 0.04, cy + 0.04), (1.25, 1.28), "screen", bevel=0)

    with b.solid("body"):
        feet(b, x, y, 0.04)
        b.box(x, y, (0.035, h), "grey plastic", bevel=0.004)
        b.box((x[1] - 0.04, x[1] + 0.03), (y[0] + 0.02, y[1] - 0.02), (0.012, 0.05), "black plastic", bevel=0)
        b.box((x[1] - 0.001, x[1] + 0.004), (y[0] + 0.012, y[1] - 0.012), (0.07, h - 0.015), "rubber", bevel=0)
        at = (low + 0.12, h - 0.25) if drawers else (0.5, h - 0.35)
        _leaf(b, "right door", leaf, (y[0] + 0.001, m - 0.003), (low, h), coat, pull, "right", at, more=dispenser)
        _leaf(b, "left door", leaf, (m + 0.003, y[1] - 0.001), (low, h), coat, pull, "left", at)
        if drawers:
            for k, zs in enumerate(((0.06, 0.335), (0.341, 0.614))):
                with b.slide(f"drawer-{k}", limits=(0.0, 0.4)):
                    b.box(leaf, (y[0] + 0.001, y[1] - 0.001), zs, coat, bevel=0.006)
                    z = zs[1] - 0.05
                    b.bar((leaf[1] + 0.032, y[0] + 0.1, z), (leaf[1] + 0.032, y[1] - 0.1, z), 0.011, pull, 10)
                    for py in (y[0] + 0.13, y[1] - 0.13):
                        b.bar((leaf[1] - 0.001, py, z), (leaf[1] + 0.032, py, z), 0.008, pull, 8)
    b.fit()


@draws("freezer")
def freezer(b: Builder) -> None:
    """A chest with a padded lid hinged at its back, a lock, a grille and a lamp."""
    d, w, h = b.size
    coat = b.material("body", "white paint", "white paint", "light grey paint", "black paint")
    x, y = (-d / 2, d / 2 - 0.03), (-w / 2, w / 2)
    lid = h - 0.075
    with b.solid("body"):
        feet(b, x, y, 0.03)
        b.box(x, (y[0] + 0.006, y[1] - 0.006), (0.025, lid), coat, bevel=0.012)
        b.box((x[0] + 0.01, x[1] - 0.01), (y[0] + 0.015, y[1] - 0.015), (lid - 0.001, lid + 0.008), "rubber", bevel=0)
        f = x[1]
        for k in range(5):
            z = 0.08 + k * 0.022
            b.box((f - 0.002, f + 0.003), (y[1] - 0.26, y[1] - 0.06), (z, z + 0.009), "grey plastic", bevel=0)
        b.box((f - 0.002, f + 0.002), (y[0] + 0.06, y[0] + 0.2), (0.1, 0.16), "grey plastic", bevel=0)
        knob(b, f + 0.002, y[0] + 0.1, 0.13, "black plastic", 0.013, 0.012)
        b.box((f + 0.001, f + 0.003), (y[0] + 0.15, y[0] + 0.18), (0.125, 0.135), "lamp glow", bevel=0)
        with b.hinge("lid", (x[0], 0.0, lid), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0)):
            b.box((x[0], d / 2 - 0.022), y, (lid + 0.0085, h), coat, bevel=0.016)
            b.box((d / 2 - 0.0235, d / 2), (-0.1, 0.1), (lid + 0.02, lid + 0.045), "grey plastic", bevel=0.006)
            b.box((d / 2 - 0.0225, d / 2 - 0.019), (-0.018, 0.018), (h - 0.028, h - 0.018), "chrome", bevel=0)
    b.fit()


@draws("stove")
def stove(b: Builder) -> None:
    """A cooktop over a panel of knobs, an oven door with window and bar, and a drawer below."""
    d, w, h = b.size
    coat = coat_of(b, "cream paint", "navy paint", "red paint")
    pull = b.material("handles", "chrome", "brushed steel", "brass")
    gas = h > 0.915  # a plate of glass is flush with worktops of 0.9 m, iron grates stand over them
    x, y = (-d / 2, d / 2 - 0.065), (-w / 2, w / 2)
    top = h - 0.035 if gas else h
    face = x[1] + 0.04
    with b.solid("body"):
        feet(b, x, y, 0.07, "black plastic", 0.02)
        b.box((x[0] + 0.02, x[1] - 0.05), (y[0] + 0.01, y[1] - 0.01), (0.02, 0.075), "black plastic", bevel=0)
        b.box(x, y, (0.07, top - 0.02), coat, bevel=0.002)
        look: Finish = ("black paint" if b.chance("black top", 0.4) else "brushed steel") if gas else "black glass"
        b.box((x[0], face + 0.01), y, (top - 0.022, top), look, bevel=0.004)
        count = 4 if w < 0.72 else 6 if gas else 4
        burners(b, (x[0] + 0.03, face - 0.02), (y[0] + 0.03, y[1] - 0.03), top, gas, count)
        panel: Finish = "black glass" if b.chance("black panel", 0.4) else coat
        b.box((x[1] + 0.0005, face), (y[0] + 0.002, y[1] - 0.002), (top - 0.125, top - 0.022), panel, bevel=0.003)
        knobs = count + 2
        for k in range(knobs):
            s = (k + 0.5) / knobs
            s = 0.42 * s / 0.5 if s < 0.5 else 1 - 0.42 * (1 - s) / 0.5
            knob(b, face, y[0] + 0.03 + s * (w - 0.06), top - 0.074, pull if coat.metallic else "black plastic", 0.019)
        b.box((face - 0.002, face + 0.0015), (-0.05, 0.05), (top - 0.09, top - 0.055), "screen", bevel=0)
        two = w > 0.8 and b.chance("two ovens", 0.5)
        edges = [y[0] + 0.002, y[1] - 0.002] if not two else [y[0] + 0.002, y[0] + 0.62 * w, y[1] - 0.002]
        for k in range(len(edges) - 1):
            ys = (edges[k], edges[k + 1] - (0.004 if k + 2 < len(edges) else 0.0))
            oven_door(b, f"oven-{k}", (x[1] + 0.0005, face), ys, (0.235, top - 0.13), coat, pull)
        with b.slide("drawer", limits=(0.0, 0.35)):
            b.box((x[1] + 0.0005, face), (y[0] + 0.002, y[1] - 0.002), (0.075, 0.23), coat, bevel=0.003)
            b.box((face - 0.001, face + 0.012), (-0.12, 0.12), (0.19, 0.205), pull, bevel=0.003)
    if not gas:
        b.surface("hob", (x[0] + 0.02, x[1] - 0.01), (y[0] + 0.02, y[1] - 0.02), h)
    b.fit()


@draws("oven_tower")
def oven_tower(b: Builder) -> None:
    """A tall kitchen column with an oven at hand height, a small oven over it, a drawer below, a door above."""
    d, w, h = b.size
    leaf = b.material(
        "fronts", "white paint", "oak", "light grey paint", "walnut", "sage paint", "navy paint", "black paint"
    )
    shell = b.material("body", "white paint", "light grey paint")
    steel = b.material("oven", "brushed steel", "black paint", "steel")
    pull = b.material("pulls", "black steel", "steel", "brass")
    x, y = (-d / 2, d / 2 - 0.048), (-w / 2, w / 2)
    front = (x[1] + 0.0005, x[1] + 0.0205)
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.06), (y[0] + 0.002, y[1] - 0.002), (0.0, 0.1), "black plastic", bevel=0)
        inside = carcass(b, x, y, (0.1, h), shell)
        niche = (0.70, 1.70)
        for z in niche:
            b.box((x[0] + 0.006, x[1]), inside[1], (z - 0.018, z), shell, bevel=0)
        for k, zs in enumerate(((0.1, 0.4), (0.4, 0.69))):
            with b.slide(f"drawer-{k}", limits=(0.0, 0.4)):
                b.box(front, (y[0] + 0.0015, y[1] - 0.0015), (zs[0] + 0.0015, zs[1] - 0.0015), leaf)
                handle(b, front[1], 0.0, zs[1] - 0.06, pull, "bar", 0.2)
        for name, zs, oven in (("oven", (0.70, 1.295), True), ("small oven", (1.305, 1.68), False)):
            ys = (y[0] + 0.019, y[1] - 0.019)
            b.box((x[0] + 0.05, x[1]), ys, (zs[0], zs[1]), steel, bevel=0)
            panel = zs[1] - 0.105
            b.box((x[1] + 0.0005, front[1]), (y[0] + 0.003, y[1] - 0.003), (panel, zs[1]), "black glass", bevel=0.002)
            b.box((front[1] - 0.001, front[1] + 0.0012), (-0.06, 0.06), (panel + 0.03, panel + 0.07), "screen", bevel=0)
            for s in (-1, 1) if oven else (1,):
                knob(b, front[1], s * w * 0.3, panel + 0.05, steel, 0.022, 0.02)
            oven_door(b, name, front, (y[0] + 0.003, y[1] - 0.003), (zs[0] + 0.003, panel - 0.004), steel, "chrome")
        door(b, "top door", front, y, (1.69, h), leaf, pull, b.pick("hung", ["left", "right"]), "bar")
    b.fit()


@draws("hob")
def hob(b: Builder) -> None:
    """A glass or steel plate with four or five plates or burners, and its controls along the front."""
    d, w, h = b.size
    gas = h > 0.045
    look = b.material("plate", "brushed steel", "black glass") if gas else b.material("plate", "black glass")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = h - 0.035 if gas else h
    count = 6 if w > 0.78 and gas else 4
    with b.solid("hob"):
        if gas:
            b.box(x, y, (0.0, top), look, bevel=0.003)
        else:
            b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (0.0, top - 0.006), "black plastic", bevel=0)
            b.box(x, y, (top - 0.007, top), look, bevel=0.002)
        burners(b, (x[0] + 0.02, x[1] - 0.08), (y[0] + 0.02, y[1] - 0.02), top, gas, count)
        n = count + 1 if gas else 8
        for k in range(n):
            py = (k - (n - 1) / 2) * (0.065 if gas else 0.035)
            if gas:
                with b.frame(d / 2 - 0.045, py, top):
                    b.frustum(
                        0.019,
                        0.016,
                        (-0.001, 0.022),
                        "chrome" if look.name == "black glass" else "black plastic",
                        segments=14,
                        bevel=0.002,
                    )
            else:
                b.box(
                    (d / 2 - 0.05, d / 2 - 0.045),
                    (py - 0.008, py + 0.008),
                    (top - 0.002, top + 0.0001),
                    "white plastic",
                    bevel=0,
                )
    if not gas:
        b.surface("hob", (x[0] + 0.02, x[1] - 0.08), (y[0] + 0.02, y[1] - 0.02), h)
    b.fit()


@draws("range_hood")
def range_hood(b: Builder) -> None:
    """A chimney over a pyramid or a thin box, with filters, lights and buttons."""
    d, w, h = b.size
    steel = coat_of(b)
    kind = b.pick("kind", ["pyramid", "box"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    cw, cd = 0.14, 0.26
    rim = 0.055
    with b.solid("canopy"):
        b.box(x, y, (0.0, rim), steel, bevel=0.003)
        top = rim
        if kind == "pyramid":
            top = rim + 0.2 + 0.12 * (h - 0.7)
            b.hull(
                [(px, s * (w / 2 - 0.01), rim - 0.001) for px in (x[0], x[1] - 0.01) for s in (-1, 1)]
                + [(px, s * cw, top) for px in (x[0], x[0] + cd) for s in (-1, 1)],
                steel,
            )
        for s in (-1, 1):
            b.box(
                (x[0] + 0.06, x[1] - 0.12),
                (s * w / 4 - w / 5, s * w / 4 + w / 5),
                (-0.0035, 0.002),
                "aluminium",
                bevel=0,
            )
            with b.frame(x[1] - 0.07, s * w * 0.3):
                b.frustum(0.03, 0.03, (-0.004, 0.002), "lamp glow", segments=16)
        for k in range(5):
            at = (k - 2) * 0.03
            b.box((x[1] - 0.001, x[1] + 0.002), (at - 0.009, at + 0.009), (0.02, 0.034), "black plastic", bevel=0)
    with b.solid("chimney"):
        b.box((x[0], x[0] + cd), (-cw, cw), (top - 0.001, top + 0.5 * (h - top)), steel, bevel=0.001)
        b.box((x[0], x[0] + cd - 0.004), (-cw + 0.004, cw - 0.004), (top, h), steel, bevel=0.001)
        for k in range(4):
            z = h - 0.05 - 0.02 * k
            for s in (-1, 1):
                b.box(
                    (x[0] + 0.06, x[0] + cd - 0.06),
                    (s * (cw - 0.003) - 0.002, s * (cw - 0.003) + 0.002),
                    (z, z + 0.008),
                    "black plastic",
                    bevel=0,
                )
    b.fit()


@draws("dishwasher")
def dishwasher(b: Builder) -> None:
    """A cabinet whose front falls open, with a panel of buttons and a grip, under a worktop or a lid of its own."""
    d, w, total = b.size
    coat = coat_of(b)
    lid, t = worktop_of(b) if b.in_suite else (coat if coat.name == "black paint" else "white paint", 0.03)
    h = total - t + 0.03  # the front ends 33 mm under this
    x, y = (-d / 2, d / 2 - 0.0525), (-w / 2, w / 2)
    face = x[1] + 0.025
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.05), (y[0] + 0.002, y[1] - 0.002), (0.0, 0.1), "black plastic", bevel=0)
        b.box(x, y, (0.1, h - 0.03), "white paint" if not coat.metallic else "grey plastic", bevel=0.002)
        b.box((x[0], d / 2 - 0.004), y, (total - t, total), lid, bevel=0.003)
        ys = (y[0] + 0.002, y[1] - 0.002)
        with b.hinge("door", (face, 0.0, 0.11), axis=(0.0, 1.0, 0.0), limits=(0.0, 1.5)):
            b.box((x[1] + 0.0005, face), ys, (0.11, h - 0.145), coat, bevel=0.004)
            b.box(
                (x[1] + 0.0005, face),
                ys,
                (h - 0.142, h - 0.033),
                "black plastic" if coat.metallic else coat,
                bevel=0.004,
            )
            if b.chance("bar", 0.6):
                handle(b, face, 0.0, h - 0.2, "chrome", "bar", 0.75 * w)
            else:
                b.box((face - 0.001, face + 0.018), (-0.1, 0.1), (h - 0.165, h - 0.14), "grey plastic", bevel=0.006)
            f = face
            b.box((f - 0.002, f + 0.0015), (0.02, 0.1), (h - 0.1, h - 0.07), "screen", bevel=0)
            for k in range(4):
                at = -0.06 - k * 0.032
                b.box((f - 0.002, f + 0.003), (at - 0.008, at + 0.008), (h - 0.092, h - 0.078), "grey plastic", bevel=0)
            b.box((f - 0.002, f + 0.002), (y[1] - 0.075, y[1] - 0.035), (h - 0.092, h - 0.078), "chrome", bevel=0)
    b.surface("top", (x[0] + 0.01, face - 0.01), (y[0] + 0.01, y[1] - 0.01), total)
    b.fit()


@draws("microwave")
def microwave(b: Builder) -> None:
    """A box with a door of dark glass hinged at its left, and a panel with a clock, buttons or knobs."""
    d, w, h = b.size
    coat = b.material("body", "brushed steel", "white plastic", "black plastic", "red plastic", "steel")
    x, y = (-d / 2, d / 2 - 0.052), (-w / 2, w / 2)
    face = x[1] + 0.022
    # Seen from its front, the panel is to the viewer's right, which is +y.
    cut = y[1] - 0.26 * w
    with b.solid("body"):
        feet(b, (x[0], x[1]), y, 0.012, r=0.014)
        b.box(x, y, (0.01, h), coat, bevel=0.006)
        for k in range(6):
            at = x[0] + 0.05 + k * 0.018
            for s in (-1, 1):
                b.box(
                    (at, at + 0.008),
                    (s * (w / 2 - 0.001) - 0.0012, s * (w / 2 - 0.001) + 0.0012),
                    (h * 0.5, h * 0.8),
                    "black plastic",
                    bevel=0,
                )
        panel: Material | str = "black glass" if b.chance("dark panel", 0.6) else coat
        b.box((x[1] - 0.002, face), (cut + 0.001, y[1] - 0.001), (0.012, h - 0.002), panel, bevel=0.003)
        m = (cut + y[1]) / 2
        b.box((face - 0.001, face + 0.001), (m - 0.038, m + 0.038), (h - 0.07, h - 0.04), "screen", bevel=0)
        b.box((face, face + 0.0014), (m - 0.02, m + 0.02), (h - 0.06, h - 0.05), "lamp glow", bevel=0)
        if b.chance("knobs", 0.4):
            for z in (0.36 * h, 0.62 * h - 0.01):
                knob(b, face, m, z, "chrome", 0.021, 0.02)
        else:
            for i in range(4):
                for j in range(3):
                    cy, cz = m + (j - 1) * 0.026, 0.06 + i * (h - 0.17) / 4
                    b.box(
                        (face - 0.001, face + 0.0018),
                        (cy - 0.009, cy + 0.009),
                        (cz - 0.007, cz + 0.007),
                        "grey plastic",
                        bevel=0,
                    )
            b.box((face - 0.001, face + 0.003), (m - 0.035, m + 0.035), (0.022, 0.042), "grey plastic", bevel=0)
        with b.hinge("door", (face, y[0], 0.012), limits=(-1.92, 0.0)):
            b.box((x[1] + 0.0005, face), (y[0] + 0.001, cut - 0.001), (0.012, h - 0.002), coat, bevel=0.003)
            b.box((face - 0.002, face + 0.0012), (y[0] + 0.035, cut - 0.06), (0.045, h - 0.035), "black glass", bevel=0)
            at = cut - 0.03
            b.bar((face + 0.022, at, 0.05), (face + 0.022, at, h - 0.045), 0.0075, "chrome", 10)
            for z in (0.065, h - 0.06):
                b.bar((face - 0.001, at, z), (face + 0.022, at, z), 0.006, "chrome", 8)
    b.surface("top", (x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), h)
    b.fit()


@draws("wine_cooler")
def wine_cooler(b: Builder) -> None:
    """A dark box with a glass door, in it wooden racks with rows of bottles under a lamp."""
    d, w, h = b.size
    coat = b.material("body", "black paint", "brushed steel", "black steel")
    pull = b.material("handle", "chrome", "brushed steel", "black steel")
    x, y = (-d / 2, d / 2 - 0.085), (-w / 2, w / 2)
    leaf = (x[1] + 0.001, x[1] + 0.041)
    t = 0.03
    with b.solid("body"):
        feet(b, x, y, 0.03)
        b.box((x[0] + 0.02, x[1]), (y[0] + 0.01, y[1] - 0.01), (0.015, 0.08), "black plastic", bevel=0)
        for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
            b.box(x, ys, (0.075, h), coat, bevel=0.002)
        inner = (y[0] + t, y[1] - t)
        b.box(x, inner, (0.075, 0.105), coat, bevel=0)
        b.box(x, inner, (h - t, h), coat, bevel=0)
        b.box((x[0], x[0] + t), inner, (0.105, h - t), "black plastic", bevel=0)
        b.box(
            (x[1] - 0.05, x[1] - 0.03), (inner[0] + 0.03, inner[1] - 0.03), (h - t - 0.008, h - t), "lamp glow", bevel=0
        )
        rows = max(4, round((h - 0.2) / 0.15))
        n = max(3, int((inner[1] - inner[0]) / 0.095))
        step = (inner[1] - inner[0]) / n
        caps = ("red plastic", "brass", "black plastic")
        for k in range(rows):
            z = 0.12 + k * (h - 0.17) / rows
            b.box((x[0] + t, x[1] - 0.02), inner, (z, z + 0.008), "black plastic", bevel=0)
            b.box((x[1] - 0.035, x[1] - 0.015), inner, (z - 0.002, z + 0.024), "beech", bevel=0.002)
            for j in range(n):
                if (k * n + j) % 7 == 5:
                    continue
                glass = "green glass" if (j + k) % 3 else "amber glass"
                with b.frame(x[0] + 0.05, inner[0] + (j + 0.5) * step, z + 0.046, pitch=math.pi / 2):
                    r = min(0.037, step / 2 - 0.002)
                    bottle = shapes.lathe([(r, 0.0), (r, 0.2), (0.014, 0.25), (0.014, 0.302)], 10)
                    b.add(bottle, glass, [shapes.hull(bottle[0])])
                    b.add(shapes.frustum(0.0142, 0.0142, (0.265, 0.3022), 10), caps[k % 3], [])
        hung: Literal["left", "right"] = "left" if b.chance("hung", 0.5) else "right"
        door(b, "door", leaf, y, (0.08, h), coat, pull, hung, "bar", "glass")
    b.fit()
