"""Tables to eat and meet at."""

from __future__ import annotations

import math

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .tables_parts import apron, corner_legs, ellipse, end_frame, pedestal, planks, prism_leg, rounded, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "pine", "cherry", "ash grey wood", "mahogany", "wenge")


@draws("dining_table")
def dining_table(b: Builder) -> None:
    """A rectangular top of wood, boards, glass or marble on legs with an apron, end frames or trestles."""
    d, w, h = b.size
    base = b.pick("base", ["tapered", "square", "turned", "splayed", "loop", "vee", "cross", "a", "trestle"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wooden = base in ("tapered", "square", "turned", "splayed", "a", "trestle", "cross")
    tops = WOODS + (("glass", "marble") if base in ("vee", "loop") else ("white paint",))
    top = b.material("top", *tops)
    glass = top.name == "glass"
    thick = 0.012 if glass else b.uniform("thickness", 0.024, 0.038)
    z = (h - thick, h)
    low = z[0]
    if wooden:
        legs = b.material("legs", "white paint", "cream paint", "black paint") if b.chance("painted", 0.3) else top
    else:
        legs = b.material("legs", "black steel", "white steel", "brushed steel", "black paint")
    with b.solid("top"):
        if base in ("turned", "trestle", "cross", "a", "square") and b.chance("boards", 0.75):
            planks(b, x, y, z, top, ends=b.pick("ends", [0.0, 0.1]))
        elif base in ("splayed", "vee", "tapered"):
            tabletop(
                b,
                rounded(x, y, b.pick("corner", [0.03, 0.08, 0.2])),
                z,
                top,
                edge="soft" if glass else b.pick("edge", ["soft", "knife"]),
            )
        else:
            tabletop(b, rounded(x, y, 0.015, 3), z, top)
        if base in ("tapered", "square", "turned"):
            inset = 0.035
            apron(b, (x[0] + inset, x[1] - inset), (y[0] + inset, y[1] - inset), (max(low - 0.085, 0.625), low), legs)
        elif base == "splayed":
            apron(b, (x[0] + 0.16, x[1] - 0.16), (y[0] + 0.16, y[1] - 0.16), (low - 0.05, low), legs)
    if base in ("tapered", "square", "turned", "splayed"):
        width = {"tapered": 0.065, "square": 0.075, "turned": 0.085, "splayed": 0.055}[base]
        inset = 0.03 if base != "splayed" else 0.045
        corner_legs(b, (x[0] + inset, x[1] - inset), (y[0] + inset, y[1] - inset), low, legs, base, width)
    else:
        bar = {"loop": 0.05, "vee": 0.05, "cross": 0.07, "a": 0.065, "trestle": 0.08}[base]
        at = w / 2 - b.uniform("overhang", 0.12, 0.3)
        for s in (-1, 1):
            end_frame(b, s * at, (x[0] + 0.07, x[1] - 0.07), low, legs, base, bar)
        rail = (-at + bar / 2, at - bar / 2)
        if base in ("trestle", "cross", "a"):
            height = 0.14 if base == "trestle" else 0.29 if base == "a" else 0.5 * low
            with b.solid("rail"):
                b.box((-0.03, 0.03), rail, (height - 0.04, height + 0.04), legs)
        elif glass:
            with b.solid("top"):
                for s in (-1, 1):
                    b.box((s * 0.2 - 0.02, s * 0.2 + 0.02), rail, (low - 0.03, low), legs)
    if base not in ("trestle", "cross", "a"):
        b.clear((x[0], x[1]), (y[0] + 0.32, y[1] - 0.32), (0.0, 0.62))
    else:
        for s in (-1, 1):
            b.clear((0.06, x[1]) if s > 0 else (x[0], -0.06), (y[0] + 0.36, y[1] - 0.36), (0.0, 0.62))


@draws("round_dining_table")
def round_dining_table(b: Builder) -> None:
    """A round top on a tulip foot, a turned column with claws, a drum of slats, or four legs."""
    d, w, h = b.size
    d = w = min(d, w)
    base = b.pick("base", ["tulip", "claw", "drum", "cross", "splayed", "tapered"])
    tops = {
        "tulip": ("marble", "white paint", "dark marble", "oak", "walnut"),
        "drum": ("oak", "walnut", "marble"),
        "cross": ("glass", "black paint", "oak", "white paint"),
    }
    top = b.material("top", *tops.get(base, WOODS))
    glass = top.name == "glass"
    thick = 0.012 if glass else b.uniform("thickness", 0.022, 0.034)
    low = h - thick
    if base == "tulip":
        foot = b.material("foot", "white paint", "black paint", "white steel")
    elif base == "cross":
        foot = b.material("foot", "black steel", "brushed steel", "chrome")
    else:
        foot = b.material("foot", "white paint", "cream paint", "black paint") if b.chance("painted", 0.3) else top
        if foot.name in ("marble", "dark marble", "glass"):
            foot = b.material("column", "oak", "walnut", "black paint")
    with b.solid("top"):
        tabletop(
            b,
            ellipse(d / 2, w / 2, 48),
            (low, h),
            top,
            edge="soft" if glass or base == "claw" else b.pick("edge", ["soft", "knife"]),
        )
        if base in ("splayed", "tapered", "claw"):
            r = 0.5 * d / 2 if base != "claw" else 0.42 * d
            b.frustum(r, r, (low - (0.05 if base != "claw" else 0.018), low), foot, segments=32)
    if base in ("splayed", "tapered"):
        reach = 0.36 * d if base == "splayed" else 0.3 * d
        corner_legs(b, (-reach, reach), (-reach, reach), low, foot, base, 0.055)
    else:
        pedestal(b, low, d * {"tulip": 0.27, "claw": 0.36, "drum": 0.36, "cross": 0.34}[base], foot, base)
    for yaw in (0, 1, 2, 3):
        lo, hi = 0.3 * d, d / 2
        xs, ys = [
            ((lo, hi), (-0.2, 0.2)),
            ((-hi, -lo), (-0.2, 0.2)),
            ((-0.2, 0.2), (lo, hi)),
            ((-0.2, 0.2), (-hi, -lo)),
        ][yaw]
        b.clear(xs, ys, (0.07, 0.62))


@draws("oval_table")
def oval_table(b: Builder) -> None:
    """An oval top on two pedestals, on crossed steel, on splayed legs or on two round drums."""
    d, w, h = b.size
    base = b.pick("base", ["tulips", "splayed", "vee", "drums"])
    tops = ("marble", "white paint", "walnut", "oak") if base == "tulips" else WOODS
    top = b.material("top", *tops)
    thick = b.uniform("thickness", 0.024, 0.034)
    low = h - thick
    dark = ("black steel", "brass") if base == "vee" else ("white paint", "black paint")
    foot = b.material("foot", *dark) if base in ("tulips", "vee") else top
    with b.solid("top"):
        plan = ellipse(d / 2, w / 2, 56, b.pick("power", [2.0, 2.5]))
        tabletop(b, plan, (low, h), top, edge=b.pick("edge", ["soft", "knife"]))
    at = 0.26 * w
    if base == "splayed":
        with b.solid("top"):
            apron(b, (-0.27 * d, 0.27 * d), (-0.3 * w, 0.3 * w), (low - 0.055, low), foot)
        corner_legs(b, (-0.37 * d, 0.37 * d), (-0.38 * w, 0.38 * w), low, foot, "splayed", 0.058)
    elif base == "vee":
        for s in (-1, 1):
            end_frame(b, s * at, (-0.36 * d, 0.36 * d), low, foot, "vee", 0.055)
    else:
        for s in (-1, 1):
            with b.frame(0, s * at), b.solid(f"foot {s}"):
                if base == "tulips":
                    b.lathe(
                        [
                            (0.3, 0.0),
                            (0.3, 0.008),
                            (0.21, 0.02),
                            (0.12, 0.05),
                            (0.065, 0.13),
                            (0.048, 0.28),
                            (0.048, 0.7 * low),
                            (0.07, 0.88 * low),
                            (0.16, low),
                        ],
                        foot,
                        segments=24,
                    )
                else:
                    b.frustum(0.2, 0.2, (0, 0.03), foot, segments=32)
                    b.frustum(0.17, 0.17, (0.03, low - 0.03), foot, segments=16)
                    b.frustum(0.2, 0.2, (low - 0.03, low), foot, segments=32)
    for s in (-1, 1):
        b.clear((0.31, d / 2) if s > 0 else (-d / 2, -0.31), (-0.2 * w, 0.2 * w), (0.0, 0.62))


@draws("conference_table")
def conference_table(b: Builder) -> None:
    """A long top in the form of a boat or a racetrack on panel feet or steel frames, with sockets in its middle."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    form = b.pick("form", ["boat", "racetrack", "rectangle"])
    base = b.pick("base", ["panel", "loop", "drum"])
    top = b.material("top", "walnut", "oak", "light oak", "wenge", "white paint", "cherry")
    foot = (
        b.material("foot", "black steel", "brushed steel", "white steel")
        if base == "loop"
        else b.material("foot", "black paint", "grey paint")
        if b.chance("dark", 0.5)
        else top
    )
    low = h - 0.032
    with b.solid("top"):
        if form == "boat":
            plan = ellipse(d / 2, w / 2, 60, 4.5)
        elif form == "racetrack":
            plan = rounded(x, y, 0.48 * d, 10)
        else:
            plan = rounded(x, y, 0.05, 4)
        tabletop(b, plan, (low, h), top, edge="soft" if base == "loop" else "knife")
    count = 2 if w < 3.0 else 3
    reach = 0.34 * w
    for k in range(count):
        at = -reach + 2 * reach * k / (count - 1)
        if base == "loop":
            end_frame(b, at, (-0.32 * d, 0.32 * d), low, foot, "loop", 0.06)
        elif base == "panel":
            with b.solid(f"foot {k}"):
                b.box((-0.26 * d, 0.26 * d), (at - 0.04, at + 0.04), (0.02, low), foot, bevel=0.006)
                b.box((-0.29 * d, 0.29 * d), (at - 0.06, at + 0.06), (0.0, 0.02), "black steel")
        else:
            with b.solid(f"foot {k}"), b.frame(0, at):
                b.frustum(0.25, 0.25, (0, 0.02), "black steel", segments=28)
                b.frustum(0.22, 0.22, (0.02, low), foot, segments=28)
    if base != "drum":
        with b.solid("rail"):
            b.box((-0.02, 0.02), (-reach + 0.03, reach - 0.03), (low - 0.1, low - 0.005), foot)
    for k in range(2):
        at = (-0.16 + 0.32 * k) * w
        b.box((-0.06, 0.06), (at - 0.16, at + 0.16), (h - 0.01, h + 0.001), "black plastic", bevel=0.001)
    for s in (-1, 1):
        b.clear((0.33 * d, d / 2) if s > 0 else (-d / 2, -0.33 * d), (-0.4 * w, 0.4 * w), (0.0, 0.62))
    b.fit()


@draws("bar_table", "cafe_table")
def bistro_table(b: Builder) -> None:
    """A small top, round or square, on a column of steel with a disc or a cross; a high one has a ring for the feet."""
    d, w, h = b.size
    d = w = min(d, w)
    high = h > 0.9
    base = b.pick("base", ["disc", "cross", "tulip", "iron"])
    form = b.pick("form", ["round", "square", "round"])
    top = b.material("top", "oak", "walnut", "marble", "white paint", "black paint", "dark marble", "light oak")
    metal = b.material("foot", "black steel", "brushed steel", "chrome", "iron")
    low = h - b.uniform("thickness", 0.02, 0.03)
    r = d / 2
    with b.solid("top"):
        plan = ellipse(r, r, 40) if form == "round" else rounded((-r, r), (-r, r), 0.04, 4)
        tabletop(b, plan, (low, h), top)
        if top.name in ("marble", "white paint") and form == "round" and base == "iron":
            b.frustum(r * 0.97, r * 0.97, (low - 0.012, low), "brass", segments=36)
        b.frustum(0.12, 0.12, (low - 0.02, low), metal, segments=20)
    reach = max(0.24, 0.72 * r) if not high else max(0.23, 0.8 * r)
    if base in ("disc", "cross", "tulip"):
        pedestal(b, low, reach, metal, base, slim=0.75)
    else:
        with b.solid("foot"):
            for yaw in range(4):
                with b.frame(yaw=0.785398 + yaw * 1.570796):
                    b.tube(
                        [
                            (0.03, 0, 0.26),
                            (0.05, 0, 0.14),
                            (0.12, 0, 0.06),
                            (reach - 0.03, 0, 0.03),
                            (reach - 0.012, 0, 0.012),
                        ],
                        0.012,
                        metal,
                        segments=8,
                    )
                    with b.frame(reach - 0.02):
                        b.frustum(0.02, 0.016, (0.0, 0.02), metal, segments=12)
            b.frustum(0.045, 0.03, (0.08, 0.28), metal, segments=16)
        with b.solid("column"):
            b.frustum(0.026, 0.026, (0.28, low - 0.02), metal, segments=16)
            b.frustum(0.045, 0.045, (0.5 * low, 0.5 * low + 0.02), metal, segments=16)
    if high:
        n = 24
        with b.solid("ring"):
            turn = [k * 2 * math.pi / n for k in range(n)]
            b.tube([(0.2 * math.cos(a), 0.2 * math.sin(a), 0.3) for a in turn], 0.009, metal, segments=8, closed=True)
            for yaw in (0.0, 1.570796):
                with b.frame(yaw=yaw):
                    b.bar((-0.2, 0, 0.3), (0.2, 0, 0.3), 0.006, metal, segments=6)


@draws("folding_table")
def folding_table(b: Builder) -> None:
    """A light top of plastic or wood on two pairs of folding steel legs with braces."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", "white plastic", "grey plastic", "light oak", "white paint", "plywood")
    metal = b.material("legs", "grey paint", "black steel", "steel")
    low = h - 0.04
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.05, 4), (low, h), top)
        for s in (-1, 1):
            b.box((s * 0.3 * d - 0.012, s * 0.3 * d + 0.012), (y[0] + 0.08, y[1] - 0.08), (low - 0.02, low), metal)
        b.box((x[0] + 0.03, x[1] - 0.03), (-0.004, 0.004), (low - 0.004, low), "black plastic", bevel=0.0)
    r = 0.0125
    for s in (-1, 1):
        at = s * (w / 2 - 0.16)
        x0, x1 = x[0] + 0.07, x[1] - 0.07
        with b.solid(f"end {s}"):
            for px in (x0, x1):
                b.bar((px, at, 0.012), (px, at, low - 0.004), r, metal, segments=10)
                with b.frame(px, at):
                    b.frustum(0.017, 0.016, (0.0, 0.03), "rubber", segments=12)
            for z in (0.12, low - 0.03):
                b.bar((x0, at, z), (x1, at, z), r * 0.8, metal, segments=8)
        with b.solid(f"brace {s}"):
            b.bar((0, at, 0.42), (0, at - s * min(0.3, abs(at) - 0.26), low - 0.008), 0.008, metal, segments=8)
            b.bar((x0, at, 0.42), (x1, at, 0.42), 0.008, metal, segments=8)
    b.clear((x[0], x[1]), (y[0] + 0.5, y[1] - 0.5), (0.0, 0.62))


@draws("patio_table")
def patio_table(b: Builder) -> None:
    """Slats of hardwood or metal with gaps, or glass, on weatherproof legs."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    kind = b.pick("kind", ["slats", "metal", "glass"])
    if kind == "slats":
        top = b.material("top", "oak", "cherry", "ash grey wood", "mahogany")
        legs = b.material("legs", "black steel", "white steel", "aluminium") if b.chance("metal legs", 0.4) else top
    elif kind == "metal":
        top = legs = b.material("top", "white steel", "black steel", "sage paint", "teal paint", "grey paint")
    else:
        top = b.material("top", "frosted glass", "glass")
        legs = b.material("legs", "black steel", "aluminium", "wicker")
    low = h - 0.026
    with b.solid("top"):
        if kind == "glass":
            tabletop(b, rounded(x, y, 0.06, 4), (h - 0.012, h), top)
            apron(b, (x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), (low - 0.04, h - 0.012), legs)
        else:
            rim = 0.06 if kind == "slats" else 0.035
            apron(b, x, y, (low - 0.01, h), top, thick=rim)
            across, inner = (x[0] + rim, x[1] - rim), (y[0] + rim, y[1] - rim)
            count = round((inner[1] - inner[0]) / (0.085 if kind == "slats" else 0.05)) | 1
            step, gap = (inner[1] - inner[0]) / count, 0.007 if kind == "slats" else 0.005
            for k in range(count):
                at = inner[0] + k * step
                slat = shapes.box(across, (at + gap / 2, at + step - gap / 2), (h - 0.018, h), 0.0014)
                b.add(slat, top, hulls=[])
            # What shows between the slats; the whole field is one flat part.
            ground = "black plastic" if top.name != "black steel" else "grey plastic"
            b.add(
                shapes.box(across, inner, (h - 0.024, h - 0.0013)),
                ground,
                hulls=[shapes.box(across, inner, (h - 0.024, h))],
            )
            apron(b, (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (low - 0.06, low - 0.01), legs)
            b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
    corner_legs(
        b,
        (x[0] + 0.02, x[1] - 0.02),
        (y[0] + 0.02, y[1] - 0.02),
        low - 0.01,
        legs,
        "tapered" if kind == "slats" else b.pick("leg style", ["square", "round"]),
        0.06,
    )
    b.clear(x, (y[0] + 0.3, y[1] - 0.3), (0.0, 0.62))


@draws("picnic_table")
def picnic_table(b: Builder) -> None:
    """A table and two benches of thick boards on A-frames, all in one."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wood = b.material("wood", "pine", "oak", "ash grey wood", "cherry", "green paint")
    seat, deep = 0.44, 0.27
    top = 0.36
    with b.solid("top"):
        planks(b, (-top, top), y, (h - 0.038, h), wood, wide=0.145)
    for s, name in ((1, "front seat"), (-1, "back seat")):
        xs = (x[1] - deep, x[1]) if s > 0 else (x[0], x[0] + deep)
        with b.solid(name):
            planks(b, xs, y, (seat - 0.038, seat), wood, name=None)
            b.surface(name.replace(" ", "-"), (xs[0] + 0.01, xs[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), seat)
    for s in (-1, 1):
        at = s * (w / 2 - 0.32)
        feet, heads, cut = d / 2 - 0.12, 0.2, seat - 0.04
        knee = feet + (heads - feet) * cut / (h - 0.038)
        side = (at + 0.0225, at + 0.0625) if s > 0 else (at - 0.0625, at - 0.0225)
        with b.solid(f"frame {s}"):
            for k in (-1, 1):
                prism_leg(b, (k * feet, at, 0), (k * knee, at, cut), (0.1, 0.045), (0.1, 0.045), wood)
            b.box((x[0] + 0.03, x[1] - 0.03), side, (seat - 0.138, seat - 0.038), wood)
        with b.solid(f"upper frame {s}"):
            for k in (-1, 1):
                prism_leg(b, (k * knee, at, cut), (k * heads, at, h - 0.038), (0.1, 0.045), (0.1, 0.045), wood)
        with b.solid("top"):
            b.box((-top + 0.03, top - 0.03), side, (h - 0.13, h - 0.038), wood)
    b.clear((top + 0.02, d / 2 - deep), (y[0] + 0.5, y[1] - 0.5), (0, 0.6))
    b.clear((-d / 2 + deep, -top - 0.02), (y[0] + 0.5, y[1] - 0.5), (0, 0.6))
