"""Beds for rooms of adults and children, and mattresses."""

from __future__ import annotations

import numpy as np

from ..builder import Builder
from ..registry import draws
from .beds_parts import bedding, head_board, slats
from .seating_parts import pillow, splayed

_WOODS = ("oak", "walnut", "pine", "light oak", "white paint", "ash grey wood", "black paint")
_COVERS = ("@fabric", "tan leather", "brown leather")


def _frame(b: Builder, x, y, top: float, wood, style: str) -> None:
    """Rails around the mattress, on legs, on a plinth, or over drawers."""
    with b.solid("bed"):
        if style == "legs":
            splayed(
                b, (x[0] + 0.06, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0, top - 0.13), wood, 0.03, 0.016, 0.026
            )
            b.box(x, y, (top - 0.14, top), wood, bevel=0.008)
        elif style == "plinth":
            b.box((x[0] + 0.08, x[1] - 0.12), (y[0] + 0.1, y[1] - 0.1), (0.0, top - 0.11), "black paint")
            b.box(x, y, (top - 0.12, top), wood, bevel=0.01)
        elif style == "upholstered":
            b.box((x[0] + 0.05, x[1] - 0.05), (y[0] + 0.05, y[1] - 0.05), (0.0, 0.05), "black paint")
            b.cushion(x, y, (0.04, top), wood, radius=0.03)
        else:
            b.box((x[0] + 0.02, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0.0, 0.05), wood)
            b.box(x, (y[0] + 0.02, y[1] - 0.02), (0.05, top), wood, bevel=0.005)
            half = (x[1] - x[0] - 0.04) / 2
            for side in (-1, 1):
                for k in range(2):
                    xs = (x[0] + 0.02 + k * half + 0.006, x[0] + 0.02 + (k + 1) * half - 0.006)
                    edge = y[1] if side > 0 else y[0]
                    ys = (edge - 0.021, edge - 0.004) if side > 0 else (edge + 0.004, edge + 0.021)
                    b.box(xs, ys, (0.065, top - 0.02), wood)
                    pull = (ys[1] - 0.001, edge) if side > 0 else (edge, ys[0] + 0.001)
                    middle = sum(xs) / 2
                    b.box((middle - 0.07, middle + 0.07), pull, (top - 0.1, top - 0.075), "black steel", bevel=0.001)


_METALS = ("black steel", "iron", "brass", "white steel")
_BUILT = {
    "platform_bed": ("plinth", ("panel", "slats")),
    "storage_bed": ("drawers", ("panel", "rails")),
    "metal_bed": ("legs", ("rails", "slats")),
}
"""Frame and head boards of beds that are known by how they are built."""


@draws("bed", "king_bed", "single_bed", "platform_bed", "upholstered_bed", "storage_bed", "metal_bed")
def bed(b: Builder) -> None:
    """A head board of six kinds, a frame on legs, plinth or drawers, mattress, pillows, blanket, sometimes a foot."""
    d, w, h = b.size
    name = b.category.name
    single = name == "single_bed"
    padded = name == "upholstered_bed" or (name not in _BUILT and b.chance("upholstered", 0.25 if single else 0.5))
    if padded:
        cover = b.material("cover", *_COVERS)
        wood, style = cover, b.pick("padded frame", ["upholstered", "upholstered", "legs"])
        board = b.pick("padded board", ["channels", "tufted", "arch"])
    elif name in _BUILT:
        wood = cover = b.material("frame", *(_METALS if name == "metal_bed" else _WOODS))
        style, boards = _BUILT[name]
        board = b.pick("board", list(boards))
    else:
        wood = cover = b.material("frame", *_WOODS)
        style = b.pick("frame", ["legs", "plinth", "drawers", "legs"])
        board = b.pick("board", ["panel", "slats", "rails"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    rail = b.uniform("rail", 0.27, 0.33)
    top = rail + b.uniform("mattress", 0.17, 0.22)
    thick = {"channels": 0.09, "tufted": 0.08, "arch": 0.055}.get(board, 0.045)
    head_board(b, x[0], y, (rail, h), board, cover, wood)
    body = (x[0] + thick - 0.005, x[1])
    beam = wood
    if style == "legs" and padded:
        with b.solid("bed"):
            feet = b.material("legs", "oak", "walnut", "black paint")
            splayed(b, (body[0] + 0.06, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0, 0.14), feet, 0.02, 0.014, 0.024)
            b.cushion(body, y, (0.13, rail), cover, radius=0.03)
    else:
        _frame(b, body, y, rail, beam, style)
    foot = not padded and name != "platform_bed" and b.chance("foot board", 0.4)
    if foot:
        with b.solid("foot board"):
            rise = rail + 0.28 if single else rail + 0.2
            if board == "panel":
                b.box((x[1] - 0.035, x[1]), y, (0.0, rise), wood, bevel=0.006)
            else:
                for ys in ((y[0], y[0] + 0.05), (y[1] - 0.05, y[1])):
                    b.box((x[1] - 0.05, x[1]), ys, (0, rise), wood, bevel=0.005)
                b.box((x[1] - 0.042, x[1] - 0.008), (y[0] + 0.05, y[1] - 0.05), (rise - 0.08, rise - 0.015), wood)
                slats(
                    b,
                    (x[1] - 0.035, x[1] - 0.015),
                    (y[0] + 0.05, y[1] - 0.05),
                    (rail - 0.02, rise - 0.08),
                    wood,
                    0.12,
                    0.02,
                )
    edge = 0.035 if w > 1.05 else 0.025
    last = x[1] - (0.055 if foot else 0.035)
    bedding(
        b,
        (x[0] + thick, last),
        (y[0] + edge, y[1] - edge),
        (rail - 0.03, top),
        pillows=1 if single else 2,
        rail=rail + 0.004,
        overhang=edge - 0.006 if not foot else 0.0,
        runner=not single and b.chance("runner", 0.35),
    )
    if not single and b.chance("throw pillow", 0.5):
        accent = b.material("throw pillow", "@fabric", "tan leather")
        with b.solid("bed pillows"), b.frame(x[0] + thick + 0.52, 0.0, top + 0.17, pitch=0.95):
            pillow(b, 0.32, 0.5, 0.12, accent, lift=-0.05)
    b.fit()


@draws("canopy_bed")
def canopy_bed(b: Builder) -> None:
    """Four posts and a rail around their heads; curtains of thin cloth at the posts in some."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "walnut", "mahogany", "black steel", "white paint", "black paint")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    metal = wood.name == "black steel"
    post = 0.04 if metal else 0.07
    turned = not metal and b.style in ("classic", "rustic")
    rail, top = 0.3, 0.5
    for cx in (x[0] + post / 2, x[1] - post / 2):
        for cy in (y[0] + post / 2, y[1] - post / 2):
            with b.solid(f"post {cx:.1f} {cy:.1f}"), b.frame(cx, cy):
                if turned:
                    b.box((-post / 2, post / 2), (-post / 2, post / 2), (0, 0.55), wood, bevel=0.006)
                    b.lathe(
                        [
                            (0.02, 0.55),
                            (0.034, 0.6),
                            (0.022, 0.66),
                            (0.033, 1.0),
                            (0.025, 1.5),
                            (0.018, h - 0.12),
                            (0.03, h - 0.08),
                            (0.03, h),
                        ],
                        wood,
                        segments=14,
                    )
                else:
                    b.box((-post / 2, post / 2), (-post / 2, post / 2), (0, h), wood, bevel=0.005)
    half = post * 0.35
    with b.solid("canopy"):
        for cx in (x[0] + post / 2, x[1] - post / 2):
            b.box((cx - half, cx + half), (y[0] + post / 2, y[1] - post / 2), (h - 0.06, h - 0.015), wood)
        for cy in (y[0] + post / 2, y[1] - post / 2):
            b.box((x[0] + post / 2, x[1] - post / 2), (cy - half, cy + half), (h - 0.06, h - 0.015), wood)
    with b.solid("bed"):
        b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.015, y[1] - 0.015), (rail - 0.14, rail), wood, bevel=0.006)
    with b.solid("head board"):
        cover = b.material("head", "@fabric") if b.chance("padded head", 0.4) else wood
        b.box((x[0] + 0.012, x[0] + 0.05), (y[0] + post, y[1] - post), (rail - 0.05, 1.05), cover, bevel=0.008)
        b.box((x[0] + 0.049, x[0] + 0.06), (y[0] + post + 0.08, y[1] - post - 0.08), (rail, 0.97), cover, bevel=0.005)
    inset = 0.045
    bedding(
        b,
        (x[0] + 0.065, x[1] - 0.05),
        (y[0] + inset, y[1] - inset),
        (rail - 0.03, top),
        rail=rail + 0.004,
        overhang=0.0,
        runner=b.chance("runner", 0.4),
    )
    if b.chance("curtains", 0.65):
        cloth = b.material("curtain", "sheer fabric")
        for side in (-1, 1):
            cy = side * (w / 2 - post / 2)
            s = np.linspace(0, 1, 15)
            rows = []
            for t in s:
                wave = 0.012 * np.sin(t * 22)
                rows.append(
                    [
                        (x[0] + post + t * 0.26 * k, cy + wave, z)
                        for k, z in ((1.0, h - 0.05), (0.8, 1.3), (0.6, 1.05), (0.85, 0.1))
                    ]
                )
            with b.solid(f"post {x[0] + post / 2:.1f} {cy:.1f}"):
                b.sheet(np.array(rows), 0.006, cloth, cells=1)
                b.box((x[0] + post - 0.01, x[0] + post + 0.17), (cy - 0.016, cy + 0.016), (1.035, 1.065), cloth)
    b.fit()


@draws("daybed")
def daybed(b: Builder) -> None:
    """A bed along the wall like a sofa: a back on the long side, two ends, cushions, a pillow at the left end."""
    d, w, h = b.size
    wood = b.material("frame", "white paint", "oak", "walnut", "black steel", "pine")
    metal = wood.name == "black steel"
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    t = 0.03 if metal else 0.045
    rail, top = 0.24, 0.43
    with b.solid("bed"):
        b.box((x[0], x[1] - 0.02), (y[0] + 0.01, y[1] - 0.01), (rail - 0.11, rail), wood, bevel=0.005)
        if b.chance("trundle", 0.5):
            b.box((x[0] + 0.06, x[1] - 0.015), (y[0] + 0.08, y[1] - 0.08), (0.025, rail - 0.118), wood)
            for k in (-1, 1):
                b.box((x[1] - 0.016, x[1] - 0.002), (k * w / 4 - 0.06, k * w / 4 + 0.06), (0.06, 0.08), "black steel")
    panel = not metal and b.chance("panels", 0.5)

    def side(xs, ys, name: str, rise: float) -> None:
        with b.solid(name):
            along_x = xs[1] - xs[0] > ys[1] - ys[0]
            long = xs if along_x else ys
            for a in ((long[0], long[0] + t), (long[1] - t, long[1])):
                b.box(a if along_x else xs, ys if along_x else a, (0.0, rise), wood, bevel=0.004)
            inner = (long[0] + t, long[1] - t)
            b.box(inner if along_x else xs, ys if along_x else inner, (rise - 0.06, rise), wood, bevel=0.006)
            if panel:
                b.box(
                    inner if along_x else (xs[0] + 0.01, xs[1] - 0.01),
                    (ys[0] + 0.01, ys[1] - 0.01) if along_x else inner,
                    (rail - 0.04, rise - 0.06),
                    wood,
                )
            else:
                slats(
                    b,
                    inner if along_x else xs,
                    ys if along_x else inner,
                    (rail - 0.02, rise - 0.05),
                    wood,
                    0.11,
                    0.02,
                    metal,
                )

    side((x[0], x[0] + t), y, "back", h)
    low = h - b.pick("step", [0.0, 0.1, 0.15])
    side((x[0] + t, x[1]), (y[0], y[0] + t), "end 0", low)
    side((x[0] + t, x[1]), (y[1] - t, y[1]), "end 1", low)
    cover = b.material("cover", "@fabric")
    with b.solid("bed"):
        b.cushion((x[0] + t, x[1] - 0.01), (y[0] + t, y[1] - t), (rail - 0.01, top), cover, radius=0.045)
    b.surface("top", (x[0] + 0.42, x[1] - 0.07), (y[0] + 0.4, y[1] - 0.4), top)
    with b.solid("back cushions"):
        accent = b.material("cushions", "@fabric")
        for k in range(3):
            wide = (w - 2 * t - 0.3) / 3
            at = (k - 1) * wide
            with b.frame(x[0] + t + 0.15, at, top + 0.21, pitch=1.25):
                pillow(b, 0.45, wide * 0.96, 0.15, accent if k != 1 else cover, lift=-0.05)
    with b.solid("bolster"), b.frame(0.04, t + 0.1 - w / 2, top + 0.085, pitch=1.5707963):
        b.frustum(0.09, 0.09, (-d / 2 + 0.13, d / 2 - 0.1), accent, segments=20, bevel=0.025)
    with b.solid("pillow"), b.frame(0.04, w / 2 - t - 0.175, top - 0.01):
        pillow(b, d - 0.3, 0.32, 0.14, cover)
    b.fit()


@draws("toddler_bed")
def toddler_bed(b: Builder) -> None:
    """A low bed with half rails at its head, a round-topped head board and a small foot board."""
    d, w, h = b.size
    wood = b.material("frame", "white paint", "birch", "pine", "light grey paint", "beech", "sage paint")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    rail, top = 0.2, 0.31
    head_board(b, x[0], y, (rail, h), b.pick("board", ["arch", "slats", "panel"]), wood, wood)
    with b.solid("foot board"):
        b.box((x[1] - 0.025, x[1]), y, (0.0, 0.4), wood, bevel=0.008)
    with b.solid("bed"):
        b.box((x[0] + 0.03, x[1] - 0.02), (y[0] + 0.015, y[1] - 0.015), (rail - 0.1, rail), wood, bevel=0.004)
    bedding(
        b,
        (x[0] + 0.065, x[1] - 0.03),
        (y[0] + 0.03, y[1] - 0.03),
        (rail - 0.02, top),
        pillows=1,
        rail=rail + 0.01,
        thick=0.09,
    )
    for side in (-1, 1):
        ys = (y[1] - 0.02, y[1]) if side > 0 else (y[0], y[0] + 0.02)
        with b.solid(f"rail {side}"):
            long = 0.52 * d
            b.box((x[0] + 0.03, x[0] + long), ys, (0.42, 0.46), wood, bevel=0.006)
            b.box((x[0] + long - 0.04, x[0] + long), ys, (rail - 0.09, 0.43), wood, bevel=0.004)
            slats(b, (x[0] + 0.05, x[0] + long - 0.04), ys, (rail - 0.05, 0.42), wood, 0.1, 0.016)
    b.fit()


@draws("mattress")
def mattress(b: Builder) -> None:
    """A mattress on the floor, or a futon on a slatted base, with pillows and a blanket folded back."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    low = 0.0
    if b.chance("pallet", 0.5):
        low = 0.08
        wood = b.material("base", "pine", "oak", "plywood")
        with b.solid("bed"):
            for k in range(3):
                at = y[0] + 0.06 + k * (w - 0.12) / 2
                b.box((x[0], x[1]), (at - 0.04, at + 0.04), (0.0, 0.062), wood)
            count = 13
            for k in range(count):
                at = x[0] + 0.045 + k * (d - 0.09) / (count - 1)
                b.box((at - 0.045, at + 0.045), y, (0.06, 0.08), wood)
    top = low + min(0.2, h - low - 0.1)
    bedding(
        b,
        (x[0] + 0.02, x[1] - 0.02),
        (y[0] + 0.02, y[1] - 0.02),
        (low, top),
        pillows=1 if w < 1.2 else 2,
        rail=low + 0.03,
        overhang=0.018,
        thick=0.13,
    )
    b.fit()
