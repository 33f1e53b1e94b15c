"""Seats of waiting rooms, cinemas, terraces and hospitals."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import wheel
from .seating_parts import bent


@draws("waiting_bench", whole=True)
def waiting_bench(d: Drawing) -> None:
    """Three to five shells on a steel beam with two feet, a small table in place of one in some."""
    body = d.material("seats", "black leather, grey plastic, blue plastic, brushed steel, beech, green plastic")
    metal = d.material("frame", "brushed steel, chrome, black steel")
    box, (depth, w, h) = d.bounds, d.size
    count = 3 if w < 2.05 else 4 if w < 2.5 else 5
    table = d.integer("table", 0, count - 1) if count > 3 and d.chance("with table", 0.4) else None
    seat, rail, x0, x1 = 0.43, 0.33, -depth / 2, depth / 2
    padded = body.called("black leather")
    with d.part("beam"):
        d.box(Box((-0.06, 0.0), box.inset(y=0.06).y, (rail - 0.04, rail + 0.02)), metal, bevel=0.006)
        with d.mirror("y"), d.at(y=w / 2 - w / count / 2):
            d.box(Box((-0.055, -0.005), (-0.025, 0.025), (0.04, rail - 0.03)), metal, bevel=0.004)
            foot = Box((x0 + 0.04, x1 - 0.06), (-0.025, 0.025), (0.0, 0.06))
            d.silhouette(foot, [(0, 0), (1, 0), (1, 0.33), (0.45, 1), (0, 0.33)], metal)
    for k, cell in enumerate(box.columns(count)):
        half, y = cell.width / 2 - 0.03, cell.center[1]
        if k == table:
            with d.part("seats"), d.at(y=y):
                top = Box((-0.2, x1 - 0.06), (-half, half), (seat - 0.02, seat))
                d.box(top, d.material("top", "beech, white paint"))
                d.box(Box((-0.1, 0.1), (-0.05, 0.05), (rail, seat - 0.019)), metal)
            continue
        with d.part("seats"), d.at(y=y):
            d.box(Box((-0.09, 0.06), (-0.1, 0.1), (rail + 0.01, seat - 0.04)), metal, bevel=0.004)
            if padded:
                with d.at(z=seat, pitch=-0.06):
                    d.cushion(Box((x0 + 0.14, x1), (-half, half), (-0.075, 0.0)), body, 0.03)
            else:
                profile = [(x1, -0.04), (x1 - 0.05, 0.0), (x1 - 0.2, -0.012), (x0 + 0.24, -0.03), (x0 + 0.16, -0.01)]
                rows = [(x, seat + z, half, 0.0, 0.006) for x, z in profile]
                d.sheet(bent(rows, 2.0, 5), 0.016, body, (4, 1))
        with d.part("backs"), d.at(x0 + 0.19, y, seat - 0.02, pitch=-0.3):
            high = (h - seat + 0.02) / math.cos(0.3) - 0.01
            if padded:
                d.cushion(Box((-0.03, 0.025), (-half, half), (0.03, high)), body, 0.027)
            else:
                rows = [(0.0, 0.0), (0.02, 0.14), (0.0, 0.3), (-0.02, high)]
                d.sheet(bent([(x, z, half, 0.008, 0.0) for x, z in rows], 2.0, 5), 0.016, body, (3, 1))
            d.box(Box((-0.045, -0.002), (-0.03, 0.03), (-0.02, 0.2)), metal, bevel=0.004)
    for k in range(count + 1):
        if d.style == "scandinavian" and 0 < k < count:
            continue
        y = min(max((k / count - 0.5) * w, -w / 2 + 0.022), w / 2 - 0.022)
        low, inner = seat - 0.06, min(max(y, -w / 2 + 0.08), w / 2 - 0.08)
        with d.part(f"arm {k}"):
            d.sweep([(-0.1, y, low), (-0.12, y, 0.6), (0.12, y, 0.61), (0.1, y, low)], 0.012, metal, 8)
            d.cushion(Box((-0.14, 0.14), (y - 0.022, y + 0.022), (0.605, 0.63)), "black plastic", 0.01)
            d.bar((-0.1, y, low), (0.1, y, low), 0.012, metal, 8)
            d.bar((-0.03, y, low), (-0.03, inner, rail), 0.012, metal, 8)


@draws("egg_chair", whole=True)
def egg_chair(d: Drawing) -> None:
    """A woven egg that hangs from a bent post on a round foot, with cushions inside."""
    weave = d.material("basket", "rattan, wicker, black steel, white plastic")
    metal = d.material("stand", "black steel, white steel, brushed steel")
    cover = d.material("cushion", "beige fabric, grey fabric", "@fabric")
    depth, w, h = d.size
    r, back = w / 2, -depth / 2 + 0.025
    with d.part("foot"):
        d.hoop(Box.around((0.0, 0.0, 0.022), depth - 0.044, w - 0.044, 0.0), 0.022, metal, steps=28)
        d.bar((-depth / 2 + 0.03, 0.0, 0.022), (depth / 2 - 0.03, 0.0, 0.022), 0.02, metal, 8)
        d.bar((0.0, -r + 0.03, 0.022), (0.0, r - 0.03, 0.022), 0.02, metal, 8)
    with d.part("post"):
        s = np.linspace(0.0, np.pi / 2, 11)
        bend = np.c_[back + (0.5 * depth - 0.03) * (1 - np.cos(s)), 0 * s, 1.25 + (h - 1.272) * np.sin(s)]
        d.sweep(np.r_[[(back, 0.0, 0.03), (back, 0.0, 0.9)], bend], 0.022, metal)
    with d.part("chain"):
        d.bar((-0.005, 0.0, h - 0.03), (-0.005, 0.0, h - 0.16), 0.007, metal, 6)
    low, top = 0.24, h - 0.15
    middle = (low + top) / 2
    # The egg: a wall about z, open to the front; thick enough to be seen as wicker.
    rise = np.linspace(-0.97, 1.0, 12)[:, None]
    turn = np.linspace(1.0, 2 * np.pi - 1.0, 19)
    gap = np.clip(1.0 - 0.85 * np.abs(rise) ** 2.5, 0.1, 1.0)
    ring = np.maximum(0.06, np.sqrt(np.clip(1 - np.abs(rise) ** 2.3, 0.0, None)))
    angle = np.pi + (turn - np.pi) * (np.pi - gap) / (np.pi - 1.0)
    x, y = (depth / 2 - 0.075) * ring * np.cos(angle) + 0.01, (r - 0.06) * ring * np.sin(angle)
    egg = np.stack([x, y, np.broadcast_to(middle + rise * (top - low) / 2, x.shape)], axis=-1)
    with d.part("basket"):
        d.sheet(egg[:, ::-1], 0.022, weave, (5, 6))
        outward = (egg - (0.01, 0.0, middle)) * (1.0, 1.0, 0.0)
        ribs = egg + 0.004 * outward / (np.linalg.norm(outward, axis=-1, keepdims=True) + 1e-9)
        with d.no_colliders():  # ribs and courses make the weave readable
            for path in [*ribs[:, 1:-1:2].swapaxes(0, 1), *ribs[1:-1:2]]:
                d.sweep(path, 0.012, weave, segments=5)
        for edge in (egg[:, 0], egg[:, -1]):
            d.sweep(edge, 0.018, weave, segments=6)
        d.cylinder(Box.sized(0.12, 0.12, 0.025, (0.0, 0.0, low - 0.005)), weave, segments=14)
        d.revolve([(0.3, low + 0.14), (0.37, low + 0.19), (0.37, low + 0.25), (0.33, low + 0.29)], cover)
        with d.at(-0.2, z=low + 0.52, pitch=1.2):
            d.pillow(Box.sized(0.5, 0.6, 0.2, (0.0, 0.0, -0.1)), cover)
        accent = d.material("pillow", "white fabric, mustard fabric, rust fabric, green fabric")
        with d.at(-0.02, 0.1, low + 0.45, pitch=1.05, yaw=0.2):
            d.pillow(Box.sized(0.34, 0.4, 0.14, (0.0, 0.0, -0.06)), accent)


def _rings(d: Drawing, box: Box, wires: list[tuple[float, float, str]]) -> None:
    """Rings about y side by side, of middle radius and radius of wire; they share twelve collision parts."""
    turn = np.arange(24) * (np.pi / 12)
    x, y, z = box.center
    skins = []
    for radius, wire, _ in wires:
        path = np.c_[x + radius * np.cos(turn), np.full(24, y), z + radius * np.sin(turn)]
        skins.append(shapes.sweep(path, wire, 6, closed=True))
    points = np.concatenate([skin[0].reshape(24, -1, 3) for skin in skins], axis=1)
    hulls = [shapes.hull(points[np.arange(k, k + 3) % 24].reshape(-1, 3)) for k in range(0, 24, 2)]
    for skin, (_, _, look) in zip(skins, wires, strict=True):
        d.add(skin, look, hulls)
        hulls = []


@draws("wheelchair", whole=True)
def wheelchair(d: Drawing) -> None:
    """Two large spoked wheels with push rims, castors, a cloth seat and back, arms, handles, foot plates."""
    frame = d.material("frame", "black steel, chrome, blue paint, red paint, brushed steel")
    cloth = d.material("seat", "black fabric, navy fabric, charcoal fabric")
    depth, w, h = d.size
    x0, big, seat, r = -depth / 2, 0.3, 0.5, 0.0115
    hub, back, front, tip = x0 + 0.34, x0 + 0.17, x0 + 0.6, depth / 2
    track, rim = w / 2 - 0.06, w / 2 - 0.008
    inner = track - 0.045

    def tube(*points: tuple[float, float], wire: float = r, look: Look = frame) -> None:
        d.sweep([(x, 0.0, z) for x, z in points], wire, look, segments=8)

    with d.mirror("y"):
        with d.part("wheel"):
            axle = Box.around((hub, track, big), 0.05, 0.07, 0.05)
            _rings(d, axle, [(big - 0.014, 0.014, "rubber"), (big - 0.034, 0.009, "aluminium")])
            _rings(d, axle.move(y=rim - track), [(big - 0.05, 0.008, "chrome")])
            d.cylinder(axle, "aluminium", "y", segments=12)
            for turn in np.arange(5) * (math.pi / 5):
                x, z = (big - 0.034) * math.cos(turn), (big - 0.034) * math.sin(turn)
                d.bar((hub - x, track, big - z), (hub + x, track, big + z), 0.003, "aluminium", segments=4)
            for turn in (0.6, 2.2, 3.8, 5.4):
                x, z = hub + (big - 0.045) * math.cos(turn), big + (big - 0.045) * math.sin(turn)
                d.bar((x, track, z), (x, rim, z), 0.005, "aluminium", segments=5)
        with d.part("side"), d.at(y=inner):
            tube((back + 0.02, 0.2), (back, h - 0.015))
            tube((back, h - 0.06), (back - 0.02, h - 0.015), (x0 + 0.1, h - 0.0125))
            tube((x0 + 0.1, h - 0.0145), (x0, h - 0.0145), wire=0.0145, look="rubber")
            tube((back, seat - 0.03), (front, seat - 0.03))
            tube((back + 0.02, 0.21), (front, 0.21))
            tube((front, 0.17), (front, seat + 0.17), (front - 0.05, seat + 0.21), (back, seat + 0.21))
            tube((hub, 0.21), (hub, seat - 0.03))
            pad = Box((back + 0.08, front - 0.05), (-0.025, 0.025), (seat + 0.215, seat + 0.245))
            d.cushion(pad, "black plastic", 0.012)
            guard = Box((back + 0.03, front - 0.02), (-0.002, 0.002), (seat - 0.02, seat + 0.17))
            d.box(guard, cloth, bevel=0.0)
            d.bar((hub, 0.0, big), (hub, track - inner, big), 0.012, frame, segments=8)
            wheel(d, Box.around((front, 0.0, 0.075), 0.15, 0.028, 0.15), hub="grey plastic")
            with d.mirror("y"):
                d.bar((front, 0.022, 0.07), (front, 0.022, 0.175), 0.006, frame, segments=6)
            d.bar((front, -0.025, 0.172), (front, 0.025, 0.172), 0.009, frame, segments=6)
            hanger = [(front, 0.0, seat - 0.03), (front + 0.06, -0.035, seat - 0.05), (tip - 0.12, -0.035, 0.12)]
            d.sweep(hanger, r, frame, segments=8)
        with d.part("foot plate"), d.at(tip - 0.1, inner - 0.1, 0.115, pitch=-0.12):
            d.box(Box((-0.08, 0.095), (-0.075, 0.09), (-0.008, 0.008)), "black plastic", bevel=0.004)
    with d.part("seat"):
        place = Box((back, front + 0.01), (-inner - 0.002, inner + 0.002), (seat - 0.035, seat + 0.02))
        d.cushion(place, cloth, 0.025)
        for s in (-1, 1):
            d.bar((hub + 0.1, -s * inner, 0.21), (hub + 0.1, s * inner, seat - 0.035), 0.01, frame, segments=8)
    with d.part("back"):
        rows = [(back - 0.03, z, inner, 0.03, 0.0) for z in (seat, seat + 0.2, h - 0.07)]
        d.sheet(bent(rows).swapaxes(0, 1), 0.014, cloth, (3, 1))
