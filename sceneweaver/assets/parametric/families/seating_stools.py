"""Stools, benches, ottomans, poufs, bean bags."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import carcass, cushions, feet, frame, leg, legs, lip, piping, tub
from .seating_parts import COVERS, arc_panel


@draws("stool", whole=True)
def stool(d: Drawing) -> None:
    """A round or square seat on three or four legs with stretchers."""
    wood = d.material("seat", "oak, walnut, beech, birch, white paint, black paint, teal paint")
    under = d.material("legs", "black steel, brass") if d.chance("metal legs", 0.25) else wood
    is_round, count, padded = d.chance("round", 0.7), d.pick("legs", [3, 4, 4]), d.chance("padded", 0.3)
    seat = Box.sized(0.36, 0.36, d.size.height).top(0.035)
    foot, head, start = 0.175, 0.115, math.pi / count + (math.pi if count == 3 else 0.0)
    if not is_round:
        count, foot, head, start = 4, 0.226, 0.198, math.pi / 4
    if not is_round:
        d.box(seat, wood, bevel=0.008)
        d.surface("top", seat, inset=0.015)
    else:
        if padded:
            d.cylinder(seat.bottom(0.022).move(z=-0.01), wood, segments=28, bevel=0.004)
            profile = [(0.92, 0.25), (0.99, 0.5), (0.99, 0.72), (0.93, 1.0)]
            d.turned(seat, profile, d.material("cover", COVERS), 28)
        else:
            d.turned(seat, [(0.84, 0.0), (0.99, 0.34), (1.0, 0.78), (0.96, 1.0)], wood, 28)
        turn = np.arange(8) * (math.pi / 4)
        d.surface("top", seat, polygon=0.15 * np.c_[np.cos(turn), np.sin(turn)])
    level, metal = 0.38, under != wood
    at, top = foot + (head - foot) * level, seat.z[0]
    next_leg = (at * math.cos(2 * math.pi / count), at * math.sin(2 * math.pi / count), level * top)
    with d.ring(count, 0.0, start):
        leg(d, (foot, 0.0, 0.0), (head, 0.0, top + 0.004), *((0.018, 0.018) if metal else (0.022, 0.036)), under)
        if not (metal and is_round):
            d.bar((at, 0.0, level * top), next_leg, 0.009, under, segments=8)
    if metal and is_round:
        d.hoop(Box.around((0.0, 0.0, level * top), 2 * at, 2 * at, 0.0), 0.007, under, steps=16)


@draws("bar_stool", whole=True)
def bar_stool(d: Drawing) -> None:
    """A high seat with a foot rest: four legs or a pedestal, with or without a low back."""
    metal = d.material("frame", "black steel, chrome, brass, oak, walnut")
    cover = d.material("cover", "@fabric", "black leather, tan leather, oak, walnut")
    h = d.size.height
    backed = h > 0.82
    top = min(h - 0.2, 0.76) if backed else h
    seat = Box.sized(0.39, 0.4, 0.07, (0.005, 0.0, top - 0.07))
    with d.part("seat"):
        if d.pick("kind", ["pedestal", "four legs", "four legs"]) == "pedestal":
            d.revolve([(0.2, 0.0), (0.205, 0.008), (0.1, 0.022), (0.035, 0.035), (0.03, 0.05)], metal, 28)
            for wide, z in ((0.056, (0.03, 0.36)), (0.038, (0.36, top - 0.07))):
                d.cylinder(Box.sized(wide, wide, 1.0).to(z=z), metal, segments=16)
            d.hoop(Box.around((0.0, 0.0, 0.27), 0.3, 0.3, 0.0), 0.009, metal, steps=18)
            d.bar((-0.15, 0.0, 0.27), (0.15, 0.0, 0.27), 0.009, metal, segments=6)
            d.cylinder(Box.sized(0.2, 0.2, 0.02, (0.0, 0.0, top - 0.085)), metal, ends=(0.7, 1.0), segments=16)
        else:
            foot, head, under = 0.18, 0.14, top - 0.06
            with d.mirror("x", "y"):
                leg(d, (foot, foot, 0.0), (head, head, under), 0.022, 0.03, metal, 4)
            for axes, z in (("x", 0.24), ("y", 0.3)):
                at = foot + (head - foot) * z / under
                start = (at, -at, z) if axes == "x" else (-at, at, z)
                with d.mirror(axes):
                    d.bar(start, (at, at, z), 0.01, metal, segments=8)
            d.box(Box.sized(0.3, 0.3, 0.025, (0.0, 0.0, top - 0.075)), metal, bevel=0.005)
        if d.chance("square seat", 0.5):
            d.cushion(seat, cover, 0.03)
        else:
            d.turned(seat, [(0.8, 0.07), (0.97, 0.28), (1.0, 0.64), (0.94, 0.9), (0.85, 1.0)], cover, 28)
    if backed:
        with d.part("back"):
            with d.at(-0.17):
                arc_panel(d, 0.36, (top + 0.1, h), 0.035, 0.09, cover, 0.03)
            with d.mirror("y"):
                d.bar((-0.15, 0.12, top - 0.06), (-0.17, 0.12, top + 0.14), 0.011, metal, segments=8)


@draws("bench")
def bench(d: Drawing) -> None:
    """A plank, slatted or padded seat on legs of several styles."""
    wood = d.material("seat", "oak, walnut, pine, light oak, ash grey wood, white paint")
    style, padded = d.pick("legs", ["panel", "tapered", "trestle", "metal", "slatted"]), d.chance("padded", 0.45)
    under = d.material("legs", "black steel, brass, white steel") if style == "metal" else wood
    box = d.bounds
    seat = box.top(0.035).move(z=-0.06 if padded else 0.0)
    stand = box.to(z=(0.0, seat.z[0])).inset(x=0.03, y=0.06)
    if style == "slatted":
        for slat in seat.split("x", 4, gap=0.012):
            d.box(slat, wood)
    else:
        d.box(seat, wood, bevel=0.006)
    if padded:
        pad = box.to(z=(seat.z[1] - 0.004, box.z[1])).inset(x=0.005, y=0.01)
        for k, own in enumerate(cushions(d, pad, 3 if box.width > 1.35 else 2, d.material("cover", COVERS), 0.025)):
            d.surface(f"top-{k}", own, inset=0.03)
    elif style != "slatted":
        d.surface("top", seat, inset=0.015)
    if style == "panel":
        legs(d, stand, wood, "panel", 0.06)
        d.box(stand.inset(y=0.03).top(0.1).inset(top=0.02).place(depth=0.03), wood)
    elif style == "trestle":
        with d.mirror("y"), d.at(y=box.y[1] - 0.2):
            with d.mirror("x"):
                leg(d, (stand.x[1], 0.0, 0.0), (0.05, 0.0, stand.height), 0.045, 0.045, wood, 4)
            d.box(Box.sized(0.2, 0.044, 0.035, (0.0, 0.0, stand.height - 0.035)), wood)
        d.box(stand.inset(y=0.14).share(z=(0.55, 0.7)).place(depth=0.03), wood)
    elif style == "metal":
        bar = stand.inset(z=0.0125).left(0.0)
        ring = [bar.anchor(f"left {end}") for end in ("bottom back", "bottom front", "top front", "top back")]
        with d.mirror("y"):
            d.sweep(ring, (0.025, 0.025), under, closed=True)
    else:
        legs(d, stand.inset(x=-0.02, y=-0.03, top=-0.002), wood, "splayed", 0.044, 0.04)
        d.box(stand.inset(x=0.03, y=0.03).top(0.05), wood)


@draws("storage_bench")
def storage_bench(d: Drawing) -> None:
    """A bench over open compartments with baskets, or a chest with a padded lid."""
    wood = d.material("body", "white paint, oak, pine, sage paint, walnut, light grey paint")
    cover, box = d.material("cover", COVERS), d.bounds
    wide = box.width > 1.08
    body, pad = box.inset(top=0.06), box.top(0.064)
    if d.pick("kind", ["open", "chest", "open"]) == "chest":
        body, pad = body.inset(front=0.022), pad.inset(front=0.022)
        front = body.inset(bottom=0.05, top=0.024)
        with d.part("chest"):
            tub(d, front.inset(front=0.006), wood, 0.018)
            d.box(body.bottom(0.05).inset(back=0.03, front=0.05, y=0.03), wood)
            for panel in front.front(0.007).inset(z=0.04).columns(3 if wide else 2):
                frame(d, panel.inset(y=0.05), wood, 0.04)
        lid = body.top(0.024).inset(bottom=0.004, top=-0.004)
        hinge = lid.anchor("back bottom")
        with d.hinge("lid", hinge, axis=(0.0, -1.0, 0.0), limits=(0.0, 1.4), role="lid"), d.part("chest"):
            d.box(lid, wood)
            lip(d, lid.front(-0.022).place(width=0.09), "brown leather")
            d.cushion(pad.inset(bottom=0.004, x=0.009, y=0.01), cover, 0.028)
    else:
        with d.part("floor"):
            feet(d, body.bottom(0.03), wood)
        room = carcass(d, body.inset(bottom=0.03), wood, 0.02)
        with d.part("seat"):
            d.cushion(pad.inset(x=0.002, y=0.002), cover, 0.028)
        weave = d.material("baskets", "wicker, rattan, grey fabric, beige fabric")
        cells = room.columns(3 if wide else 2, gap=0.02)
        full = d.integer("baskets", 0, len(cells) - 1)
        for k, cell in enumerate(cells):
            if k:
                d.box(cell.right(-0.02).inset(front=0.005), wood, bevel=0.0)
            if k < full:
                basket = cell.share(z=(0.0, 0.74)).inset(back=0.012, front=0.02, y=0.015)
                d.cushion(basket, weave, 0.018)
                d.slab(basket.top(0.02).inset(x=-0.003, y=-0.003), weave, 0.02, 0.004)
                d.box(basket.front(-0.006).place(width=0.09, height=0.02).move(z=0.03), "brown leather", bevel=0.003)
            else:
                d.surface(f"shelf-{k}", cell.bottom(0.0).inset(back=0.006, front=0.015, y=0.005), cell.height - 0.002)
    if not d.drawn.links:
        d.surface("top", box, inset=0.035)
    d.fit()


@draws("piano_bench", whole=True)
def piano_bench(d: Drawing) -> None:
    """A tufted leather seat on a wooden apron and four legs, with knobs to set its height."""
    wood = d.material("legs", "black paint, mahogany, walnut, cherry")
    cover, box = d.material("cover", "black leather, brown leather, black fabric"), d.bounds.inset(y=0.02)
    turned = d.chance("turned", 0.5)
    case = box.inset(top=0.08)
    legs(d, case, wood, "turned" if turned else "square", 0.055 if turned else 0.045)
    apron = d.box(case.top(0.07).inset(x=0.01, y=0.01), wood)
    d.box(box.top(0.085).bottom(0.016), wood, bevel=0.006)
    with d.mirror("y"), d.at(0.0, apron.y[1], apron.center[2], roll=-math.pi / 2):
        d.revolve([(0.012, -0.002), (0.012, 0.012), (0.022, 0.016), (0.022, 0.026), (0.016, 0.03)], wood, 14)
    for row in box.top(0.075).inset(x=0.005, y=0.005).split("x", 2):
        cushions(d, row, 4 if box.width > 0.6 else 3, cover, 0.03, 0.0, 0.0)


@draws("ottoman", whole=True)
def ottoman(d: Drawing) -> None:
    """A padded block on short legs, tufted in some."""
    cover, wood = d.material("cover", COVERS), d.material("legs", "oak, walnut, black paint, brass")
    box, foot = d.bounds, d.uniform("foot", 0.06, 0.14)
    legs(d, box.bottom(foot + 0.005).inset(x=0.03, y=0.03), wood, "splayed", 0.04, 0.02)
    d.cushion(box.inset(bottom=foot, top=0.11, x=0.008, y=0.008), cover, 0.02)
    piping(d, d.cushion(box.top(0.13), cover, 0.045), cover, 0.045)
    if d.chance("tufts", 0.5):
        with d.grid(box.top(0.0), x=2, y=3):
            d.ball(Box.around((0.0, 0.0, -0.003), 0.028, 0.028, 0.008), cover, segments=10)
    d.surface("top", box, inset=0.055)


_POUF = [(0.8, 0.0), (0.93, 0.06), (1.0, 0.22), (1.0, 0.55), (0.97, 0.76), (0.88, 0.9), (0.66, 0.985), (0.3, 1.0)]
"""Half widths and heights of a pouf, as shares."""


@draws("pouf", whole=True)
def pouf(d: Drawing) -> None:
    """A round, stuffed seat: gores of cloth or leather that swell between seams, or courses of thick knitted rope."""
    cover, box = d.material("cover", "@fabric", "tan leather, brown leather, wicker"), d.bounds
    depth, width, h = box.size
    if cover.kind == "fabric" and d.chance("knitted", 0.5):
        rope = h / 16
        z = np.linspace(rope, h - rope, 9)
        r = np.interp(z / h, [s for _, s in _POUF], [s for s, _ in _POUF]) - 2 * rope / width
        courses = [*zip(z.tolist(), r.tolist(), strict=True), (h - 0.7 * rope, 0.45), (h - 0.7 * rope, 0.2)]
        rings = [shapes.ellipse(share * depth / 2, share * width / 2, at, 28) for at, share in courses]
        skins = [shapes.sweep(ring, rope, 8, closed=True) for ring in rings]
        whole = shapes.containing_hull(np.concatenate([points for points, _ in skins]))
        with d.no_colliders():
            d.turned(box.inset(top=0.004), [(0.97 * r, z) for r, z in _POUF], cover, 28)
        for k, skin in enumerate(skins):
            d.add(skin, cover, [] if k else [whole])
    else:
        gores, steps = d.pick("gores", [8, 10, 12]), 6
        turn = np.arange(gores * steps) * (2 * np.pi / (gores * steps))
        seam = np.abs(np.cos(turn * gores / 2)) ** 6
        rings = []
        for r, z in (*_POUF, (0.05, 0.985)):
            own = r * (1 - (0.09 if 0 < z < 0.99 else 0.0) * seam)
            drop = (0.0 if z in (0.0, 1.0) else 0.012) * seam
            rings.append(np.c_[own * np.cos(turn) * depth / 2, own * np.sin(turn) * width / 2, z * h - drop])
        skin = shapes.lofted(rings)
        d.add(skin, cover, [shapes.containing_hull(skin[0])])
        trim = "white fabric" if cover.darker(0.8) else "charcoal fabric"
        cord = trim if d.chance("trim", 0.4) else cover
        with d.no_colliders():
            for k in range(0, gores * steps, steps):  # piping in the seams
                d.sweep(np.array([ring[k] for ring in rings[:-1]]), 0.004, cord, segments=5)
        d.ball(Box.around((0.0, 0.0, h - 0.008), 0.07, 0.07, 0.016), cover, segments=12)


@draws("bean_bag")
def bean_bag(d: Drawing) -> None:
    """A slumped sack with a dented seat and a high back, in gores with seams."""
    cover, (depth, w, h) = d.material("cover", "@fabric", "brown leather, black leather"), d.size
    t = np.linspace(0.0, 1.0, 13)[:, None]
    a = np.arange(42) * (2 * np.pi / 42)
    levels = [0.0, 0.05, 0.15, 0.32, 0.5, 0.68, 0.85, 0.95, 1.0]
    radius = np.interp(t, levels, [0.84, 0.95, 1.0, 1.0, 0.95, 0.8, 0.5, 0.22, 0.05])
    radius = radius * (1 - 0.05 * np.abs(np.cos(3 * a)) ** 8 * np.sin(np.pi * t))
    # The crown lies toward the back; the front half sags, so that a seat remains, and bulges below it.
    front = np.clip(np.cos(a), 0.0, 1.0) ** 0.7
    rise = t - 0.42 * t**1.2 * front * np.sin(t * np.pi)
    x = radius * np.cos(a) - 0.5 * t**1.8
    grid = np.stack([x * depth / 2, radius * np.sin(a) * w / 2, rise * h], axis=-1)
    hulls = [shapes.hull(grid[k : k + 4].reshape(-1, 3)) for k in (0, 3, 6, 9)]
    d.add(shapes.lofted(list(grid)), cover, hulls)
    tip = grid[-1].mean(axis=0)
    d.box(Box.around((tip[0], tip[1], tip[2] + 0.012), 0.05, 0.016, 0.05), cover, bevel=0.006)
    with d.no_colliders():
        for k in range(0, 42, 7):
            d.sweep(grid[1:, k], 0.004, cover, segments=5)
    d.fit()
