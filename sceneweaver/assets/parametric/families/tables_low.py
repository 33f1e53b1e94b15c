"""Low tables of living rooms and bedrooms, and what stands along their walls."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..joinery import door, drawer
from ..registry import draws
from .tables_parts import apron, corner_legs, ellipse, end_frame, pedestal, planks, proud, rounded, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "cherry", "ash grey wood", "wenge", "pine")
PAINTS = ("white paint", "cream paint", "sage paint", "navy paint", "light grey paint", "black paint")
METALS = ("black steel", "brass", "brushed steel", "white steel")


@draws("coffee_table")
def coffee_table(b: Builder) -> None:
    """A low top on legs with a shelf, a glass top on metal, a waterfall of boards, or a chest with drawers."""
    d, w, h = b.size
    kind = b.pick("kind", ["shelf", "glass", "waterfall", "splayed", "drawers", "rustic", "hairpin"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    if kind == "glass":
        top = b.material("top", "glass", "marble", "dark marble")
        metal = b.material("frame", "black steel", "brass", "chrome")
        low = h - (0.012 if top.name == "glass" else 0.022)
        with b.solid("top"):
            tabletop(b, rounded(x, y, 0.012, 3), (low, h), top, inset=0.012)
            for ys in ((y[0] + 0.01, y[0] + 0.03), (y[1] - 0.03, y[1] - 0.01)):
                b.box((x[0] + 0.03, x[1] - 0.03), ys, (low - 0.02, low), metal)
            for xs in ((x[0] + 0.01, x[0] + 0.03), (x[1] - 0.03, x[1] - 0.01)):
                b.box(xs, (y[0] + 0.01, y[1] - 0.01), (low - 0.02, low), metal)
        corner_legs(b, (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), low - 0.02, metal, "square", 0.02)
        with b.solid("shelf"):
            z = 0.1
            lower = b.material("lower", "glass", "oak", "walnut") if top.name == "glass" else top
            b.box((x[0] + 0.012, x[1] - 0.012), (y[0] + 0.03, y[1] - 0.03), (z - 0.012, z), lower, bevel=0.0015)
            for xs in ((x[0] + 0.01, x[0] + 0.03), (x[1] - 0.03, x[1] - 0.01)):
                b.box(xs, (y[0] + 0.03, y[1] - 0.03), (z - 0.03, z - 0.012), metal)
        b.surface("shelf", (x[0] + 0.04, x[1] - 0.04), (y[0] + 0.04, y[1] - 0.04), z, round(low - 0.02 - z - 0.005, 4))
    elif kind == "waterfall":
        wood = b.material("top", *WOODS, "white paint", "black paint")
        t = b.uniform("thickness", 0.026, 0.036)
        with b.solid("top"):
            b.box(x, y, (h - t, h), wood, bevel=0.004)
        b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
        for k, ys in enumerate(((y[0], y[0] + t), (y[1] - t, y[1]))):
            with b.solid(f"side {k}"):
                b.box(x, ys, (0, h - t), wood, bevel=0.004)
        z = b.uniform("shelf", 0.1, 0.16)
        with b.solid("shelf"):
            b.box((x[0] + 0.03, x[1] - 0.03), (y[0] + t, y[1] - t), (z - 0.02, z), wood)
        b.surface(
            "shelf", (x[0] + 0.04, x[1] - 0.04), (y[0] + t + 0.01, y[1] - t - 0.01), z, round(h - t - z - 0.005, 4)
        )
    elif kind == "drawers":
        wood = b.material("top", *WOODS, *PAINTS)
        front = b.material("fronts", *WOODS) if wood.name.endswith("paint") else wood
        pull = b.material("pulls", "brass", "black steel", "brushed steel")
        legs = b.material("legs", "black steel", "brass") if b.chance("metal legs", 0.3) else wood
        t, rise = 0.022, 0.13
        low = h - t
        style = b.pick("pull style", ["knob", "cup"])
        face = x[1] - proud(style)
        with b.solid("top"):
            tabletop(b, rounded(x, y, 0.02, 3), (low, h), wood)
            b.box((x[0] + 0.03, face - 0.019), (y[0] + 0.02, y[1] - 0.02), (low - 0.11, low), wood)
            step = (w - 0.04) / 2
            for k in range(2):
                at = y[0] + 0.02 + k * step
                drawer(
                    b,
                    f"drawer-{k}",
                    (x[0] + 0.05, face),
                    (at, at + step),
                    (low - 0.11, low - 0.003),
                    front,
                    pull,
                    style,
                )
        corner_legs(b, (x[0] + 0.04, x[1] - 0.045), (y[0] + 0.03, y[1] - 0.03), low - 0.11, legs, "tapered", 0.04)
        if low - 0.11 - rise > 0.1:
            with b.solid("shelf"):
                b.box((x[0] + 0.05, x[1] - 0.055), (y[0] + 0.045, y[1] - 0.045), (rise - 0.055, rise - 0.037), wood)
            b.surface(
                "shelf",
                (x[0] + 0.09, x[1] - 0.095),
                (y[0] + 0.08, y[1] - 0.08),
                rise - 0.037,
                round(low - 0.11 - rise + 0.037 - 0.005, 4),
            )
    else:
        wood = b.material("top", *WOODS)
        t = 0.036 if kind == "rustic" else b.uniform("thickness", 0.022, 0.03)
        low = h - t
        legs = wood
        if kind == "hairpin":
            legs = b.material("legs", "black steel", "brass", "copper")
        elif b.chance("painted", 0.35):
            legs = b.material("legs", "white paint", "black paint", "cream paint")
        with b.solid("top"):
            if kind == "rustic":
                planks(b, x, y, (low, h), wood, ends=0.09)
            elif kind == "splayed":
                tabletop(b, ellipse(d / 2, w / 2, 44, b.pick("power", [2.0, 2.6, 3.4])), (low, h), wood, edge="knife")
            else:
                tabletop(b, rounded(x, y, b.pick("corner", [0.01, 0.04, 0.1])), (low, h), wood)
            if kind in ("shelf", "rustic"):
                apron(b, (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (low - 0.055, low), legs)
        if kind == "splayed":
            with b.solid("top"):
                apron(b, (x[0] * 0.62, x[1] * 0.62), (y[0] * 0.62, y[1] * 0.62), (low - 0.035, low), legs)
            corner_legs(
                b,
                (x[0] * 0.8, x[1] * 0.8),
                (y[0] * 0.8, y[1] * 0.8),
                low,
                legs,
                "splayed",
                0.04,
                cap=b.pick("cap", [None, "brass"]),
            )
        elif kind == "hairpin":
            corner_legs(b, (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), low, legs, "hairpin")
        else:
            style = b.pick("legs", ["square", "tapered"]) if kind == "shelf" else b.pick("legs", ["turned", "square"])
            width = 0.05 if kind == "shelf" else 0.07
            corner_legs(b, (x[0] + 0.025, x[1] - 0.025), (y[0] + 0.025, y[1] - 0.025), low, legs, style, width)
            z = 0.13 if style != "turned" else 0.1
            with b.solid("shelf"):
                if kind == "rustic":
                    planks(b, (x[0] + 0.06, x[1] - 0.06), (y[0] + 0.06, y[1] - 0.06), (z - 0.022, z), wood, name=None)
                else:
                    b.box((x[0] + 0.04, x[1] - 0.04), (y[0] + 0.04, y[1] - 0.04), (z - 0.02, z), wood)
            reach = 0.03 + width
            b.surface(
                "shelf",
                (x[0] + reach, x[1] - reach),
                (y[0] + reach, y[1] - reach),
                z,
                round(low - 0.055 - z - 0.005, 4),
            )


@draws("nightstand")
def nightstand(b: Builder) -> None:
    """Two drawers on legs, a drawer over an open niche, or a drawer over a shelf between four legs."""
    d, w, h = b.size
    kind = b.pick("kind", ["two drawers", "niche", "table", "three drawers"])
    style = b.pick("pull style", ["knob", "bar", "cup"])
    x, y = (-d / 2, d / 2 - proud(style) + 0.004), (-w / 2, w / 2)
    wood = b.material("body", *WOODS, *PAINTS)
    front = b.material("fronts", *WOODS, "white paint") if b.chance("two tone", 0.3) else wood
    pull = b.material("pulls", "brass", "black steel", "brushed steel")
    legs = b.material("legs", "brass", "black steel", "oak", "walnut") if b.chance("other legs", 0.4) else wood
    leg = b.pick("leg style", ["tapered", "splayed", "round"])
    t = 0.02
    low = h - t
    with b.solid("top"):
        tabletop(b, rounded(x, y, b.pick("corner", [0.006, 0.02]), 3), (low, h), wood)
    body, face = (x[0] + 0.01, x[1] - 0.023), x[1] - 0.004
    ys = (y[0] + 0.01, y[1] - 0.01)
    if kind in ("two drawers", "three drawers"):
        rise = 0.15 if kind == "two drawers" else 0.06
        count = 2 if kind == "two drawers" else 3
        with b.solid("all"):
            b.box(body, ys, (rise, low), wood)
            if kind == "two drawers":
                corner_legs(b, (x[0] + 0.02, x[1] - 0.03), (y[0] + 0.02, y[1] - 0.02), rise, legs, leg, 0.035, "all")
            else:
                b.box((body[0], body[1] - 0.02), (ys[0] + 0.015, ys[1] - 0.015), (0, rise), legs)
            step = (low - rise) / count
            for k in range(count):
                at = rise + (count - 1 - k) * step
                drawer(b, f"drawer-{k}", (body[0] + 0.02, face), ys, (at, at + step), front, pull, style)
    elif kind == "niche":
        rise, deep = 0.12, 0.15
        with b.solid("drawer"):
            b.box(body, ys, (low - deep, low), wood)
            drawer(b, "drawer", (body[0] + 0.02, face), ys, (low - deep, low), front, pull, style)
        with b.solid("floor"):
            b.box((body[0], face), ys, (rise, rise + 0.018), wood)
            corner_legs(b, (x[0] + 0.02, x[1] - 0.03), (y[0] + 0.02, y[1] - 0.02), rise, legs, leg, 0.035, "floor")
        for k, side in enumerate(((ys[0], ys[0] + 0.018), (ys[1] - 0.018, ys[1]))):
            with b.solid(f"side {k}"):
                b.box((body[0], face), side, (rise + 0.018, low - deep), wood)
        with b.solid("back"):
            b.box((body[0], body[0] + 0.008), (ys[0] + 0.018, ys[1] - 0.018), (rise + 0.018, low - deep), wood, 0.0)
        b.surface(
            "shelf",
            (body[0] + 0.015, face - 0.01),
            (ys[0] + 0.024, ys[1] - 0.024),
            rise + 0.018,
            round(low - deep - rise - 0.023, 4),
        )
    else:
        deep, z = 0.13, 0.14
        with b.solid("top"):
            b.box(body, ys, (low - deep, low), wood)
            drawer(b, "drawer", (body[0] + 0.02, face), ys, (low - deep, low - 0.002), front, pull, style)
        corner_legs(b, (body[0], face), ys, low - deep, legs, b.pick("table legs", ["square", "tapered"]), 0.038)
        with b.solid("shelf"):
            b.box((body[0] + 0.012, face - 0.012), (ys[0] + 0.012, ys[1] - 0.012), (z - 0.018, z), wood)
        b.surface(
            "shelf",
            (body[0] + 0.045, face - 0.045),
            (ys[0] + 0.045, ys[1] - 0.045),
            z,
            round(low - deep - z - 0.005, 4),
        )


@draws("side_table")
def side_table(b: Builder) -> None:
    """A small table: round on three legs or a disc, a drum, square with a shelf, or a C that reaches over a seat."""
    d, w, h = b.size
    kind = b.pick("kind", ["three legs", "disc", "square", "frame", "drum", "tulip"])
    if kind in ("square", "frame"):
        x, y = (-d / 2, d / 2), (-w / 2, w / 2)
        top = b.material("top", *WOODS, *(("marble", "glass") if kind == "frame" else PAINTS))
        legs = b.material("legs", *METALS) if kind == "frame" else top
        low = h - (0.012 if top.name == "glass" else 0.02)
        with b.solid("top"):
            tabletop(b, rounded(x, y, 0.015, 3), (low, h), top)
            apron(
                b,
                (x[0] + 0.012, x[1] - 0.012),
                (y[0] + 0.012, y[1] - 0.012),
                (low - (0.018 if kind == "frame" else 0.06), low),
                legs,
                thick=0.018,
            )
        width = 0.018 if kind == "frame" else 0.036
        corner_legs(
            b,
            (x[0] + 0.012, x[1] - 0.012),
            (y[0] + 0.012, y[1] - 0.012),
            low,
            legs,
            "square" if kind == "frame" else b.pick("legs", ["tapered", "square", "turned"]),
            width,
        )
        z = 0.15
        with b.solid("shelf"):
            b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (z - 0.016, z), top)
        b.surface(
            "shelf",
            (x[0] + 0.055, x[1] - 0.055),
            (y[0] + 0.055, y[1] - 0.055),
            z,
            round(low - (0.018 if kind == "frame" else 0.06) - z - 0.005, 4),
        )
        return
    r = min(d, w) / 2
    top = b.material("top", *WOODS, "white paint", "marble", "dark marble", "teal paint", "black paint")
    low = h - 0.02
    if kind == "drum":
        metal = b.material("frame", "brass", "black steel", "copper")
        with b.solid("all"):
            tabletop(b, ellipse(r, r, 36), (low, h), top)
            b.frustum(r * 0.97, r * 0.97, (0.0, 0.03), metal, segments=36)
            count = 28
            for k in range(count):
                with b.frame(yaw=2 * math.pi * k / count):
                    b.box((0.86 * r, 0.94 * r), (-0.012, 0.012), (0.03, low), top, bevel=0.003)
            b.frustum(r * 0.84, r * 0.84, (0.03, low), top, segments=28)
        return
    with b.solid("top"):
        tabletop(b, ellipse(r, r, 36), (low, h), top, edge=b.pick("edge", ["soft", "knife"]))
    if kind == "three legs":
        legs = b.material("legs", "brass", "black steel", "oak", "walnut", "white paint")
        steel = legs.name in ("brass", "black steel")
        for k in range(3):
            a = math.pi / 3 + k * 2 * math.pi / 3
            c, s = math.cos(a), math.sin(a)
            with b.solid(f"leg {k}"):
                foot, head = (0.86 * r * c, 0.86 * r * s, 0.0), (0.5 * r * c, 0.5 * r * s, low)
                b.hull(
                    [
                        (p[0] + q * math.cos(t), p[1] + q * math.sin(t), p[2])
                        for t in np.arange(12) * math.pi / 6
                        for p, q in ((foot, 0.008 if steel else 0.01), (head, 0.009 if steel else 0.018))
                    ],
                    legs,
                )
        with b.solid("top"):
            b.frustum(0.6 * r, 0.6 * r, (low - 0.012, low), legs, segments=28)
    else:
        foot = b.material("foot", *METALS) if kind == "disc" else b.material("foot", "white paint", "black paint")
        pedestal(b, low, 0.7 * r, foot, kind, slim=0.55)


@draws("tv_stand")
def tv_stand(b: Builder) -> None:
    """A long low cabinet: doors or drawers at both ends, open shelves for players in the middle."""
    d, w, h = b.size
    wood = b.material("body", *WOODS, "white paint", "black paint", "light grey paint")
    front = (
        b.material("fronts", "white paint", "light grey paint", "oak", "walnut", "rattan")
        if b.chance("two tone", 0.5)
        else wood
    )
    pull = b.material("pulls", "black steel", "brass", "brushed steel")
    drawers = b.chance("drawers", 0.4)
    style = b.pick("pull style", ["bar", "knob", "cup"] if drawers else ["knob", "none"])
    feet = b.pick("feet", ["tapered", "splayed", "plinth", "sled"])
    x, y = (-d / 2, d / 2 - proud(style)), (-w / 2, w / 2)
    rise = {"plinth": 0.05, "sled": 0.12}.get(feet, b.uniform("rise", 0.11, 0.16))
    t = 0.022
    face = x[1]
    with b.solid("base"):
        b.box((x[0], face), y, (rise, rise + t), wood)
        if feet == "plinth":
            b.box((x[0] + 0.01, face - 0.05), (y[0] + 0.02, y[1] - 0.02), (0, rise), wood)
        elif feet == "sled":
            metal = b.material("legs", "black steel", "brass", "white steel")
            for s in (-1, 1):
                end_frame(b, s * (w / 2 - 0.14), (x[0] + 0.03, face - 0.04), rise, metal, "loop", 0.022)
        else:
            legs = b.material("legs", "oak", "walnut", "black steel", "brass") if b.chance("other legs", 0.5) else wood
            corner_legs(b, (x[0] + 0.03, face - 0.04), (y[0] + 0.06, y[1] - 0.06), rise, legs, feet, 0.042, "base")
    with b.solid("top"):
        b.box((x[0], face), y, (h - t, h), wood)
    b.surface("top", (x[0] + 0.01, face - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
    z = (rise + t, h - t)
    share = b.uniform("side share", 0.27, 0.36)
    inner = (y[0] + share * w, y[1] - share * w)
    for name, ys in (("right", (y[0], inner[0])), ("left", (inner[1], y[1]))):
        with b.solid(name):
            b.box((x[0], face - 0.0205), ys, z, wood, bevel=0.001)
            if drawers:
                half = (z[0] + z[1]) / 2
                drawer(b, f"{name}-upper", (x[0] + 0.03, face), ys, (half, z[1]), front, pull, style)
                drawer(b, f"{name}-lower", (x[0] + 0.03, face), ys, (z[0], half), front, pull, style)
            else:
                door(
                    b,
                    f"{name}-door",
                    (face - 0.02, face),
                    ys,
                    z,
                    front,
                    pull,
                    hung="right" if name == "right" else "left",
                    style=style,
                )
    with b.solid("back"):
        b.box((x[0], x[0] + 0.01), inner, z, wood, bevel=0.0)
    middle = (z[0] + z[1]) / 2 + b.uniform("shelf", -0.02, 0.03)
    shelf = z[1] - z[0] > 0.24
    levels = [z[0]]
    if shelf:
        levels.append(middle)
        with b.solid("shelf"):
            b.box((x[0] + 0.01, face - 0.02), inner, (middle - 0.016, middle), wood)
    for k, level in enumerate(levels):
        ceiling = middle - 0.016 if shelf and k == 0 else z[1]
        b.surface(
            f"shelf-{k}",
            (x[0] + 0.02, face - 0.03),
            (inner[0] + 0.01, inner[1] - 0.01),
            level,
            round(ceiling - level - 0.005, 4),
        )


@draws("console_table")
def console_table(b: Builder) -> None:
    """A narrow table along a wall: slim frame, drawers, a shelf below, or a half moon."""
    d, w, h = b.size
    kind = b.pick("kind", ["frame", "drawers", "half moon", "cross", "waterfall"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", *WOODS, *(("marble", "glass") if kind == "frame" else ("white paint", "cream paint")))
    low = h - (0.012 if top.name == "glass" else 0.024)
    if kind == "half moon":
        t = np.linspace(-math.pi / 2, math.pi / 2, 21)
        plan = np.c_[x[0] + d * np.cos(t), (w / 2) * np.sin(t)]
        with b.solid("top"):
            tabletop(b, plan, (low, h), top, edge="soft", inset=0.012)
            inner = np.c_[x[0] + (d - 0.03) * np.cos(t), (w / 2 - 0.04) * np.sin(t)]
            b.extrude(inner, (low - 0.1, low), top)
            drawn = np.c_[x[0] + (d - 0.024) * np.cos(t), (w / 2 - 0.034) * np.sin(t)]
            b.extrude(drawn, (low - 0.1, low - 0.088), top)
        for k, a in enumerate((-1.36, -0.55, 0.55, 1.36)):
            px, py = x[0] + (d - 0.06) * math.cos(a), (w / 2 - 0.075) * math.sin(a)
            with b.solid(f"leg {k}"), b.frame(max(px, x[0] + 0.03), py):
                b.frustum(0.011, 0.021, (0, low - 0.1), top, segments=14)
        return
    legs = b.material("legs", *METALS) if kind == "frame" else top
    if kind != "frame" and b.chance("painted", 0.3):
        legs = b.material("legs", "white paint", "black paint", "sage paint", "navy paint")
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.01, 3), (low, h), top)
    z = 0.16
    if kind == "waterfall":
        for k, ys in enumerate(((y[0], y[0] + 0.03), (y[1] - 0.03, y[1]))):
            with b.solid(f"side {k}"):
                b.box(x, ys, (0, low), legs)
        with b.solid("shelf"):
            b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.03, y[1] - 0.03), (z - 0.022, z), top)
        b.surface("shelf", (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.045, y[1] - 0.045), z, round(low - z - 0.005, 4))
        return
    if kind == "cross":
        for s in (-1, 1):
            end_frame(b, s * (w / 2 - 0.07), (x[0] + 0.01, x[1] - 0.01), low, legs, "cross", 0.045)
        with b.solid("rail"):
            b.box((-0.02, 0.02), (-w / 2 + 0.09, w / 2 - 0.09), (0.5 * low - 0.03, 0.5 * low + 0.03), legs)
        return
    deep = 0.02 if kind == "frame" else 0.13
    with b.solid("top"):
        if kind == "frame":
            apron(b, (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), (low - deep, low), legs, thick=0.02)
        else:
            b.box((x[0] + 0.01, x[1] - 0.045), (y[0] + 0.015, y[1] - 0.015), (low - deep, low), legs)
            pull = b.material("pulls", "brass", "black steel")
            count = 2 if w < 1.15 else 3
            step = (w - 0.03) / count
            for k in range(count):
                at = y[0] + 0.015 + k * step
                drawer(
                    b,
                    f"drawer-{k}",
                    (x[0] + 0.03, x[1] - 0.026),
                    (at, at + step),
                    (low - deep, low - 0.003),
                    legs,
                    pull,
                    b.pick("pull style", ["knob", "cup"]),
                )
    front = x[1] - 0.01 if kind == "frame" else x[1] - 0.03
    corner_legs(
        b,
        (x[0] + 0.01, front),
        (y[0] + 0.015, y[1] - 0.015),
        low - deep,
        legs,
        "square" if kind == "frame" else b.pick("legs", ["tapered", "turned", "square"]),
        0.022 if kind == "frame" else 0.045,
    )
    if kind == "frame" or b.chance("shelf", 0.6):
        with b.solid("shelf"):
            b.box((x[0] + 0.02, front - 0.01), (y[0] + 0.03, y[1] - 0.03), (z - 0.018, z), top)
        b.surface(
            "shelf", (x[0] + 0.06, front - 0.055), (y[0] + 0.07, y[1] - 0.07), z, round(low - deep - z - 0.005, 4)
        )
