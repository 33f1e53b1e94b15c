"""Rugs, mats, curtains, cushions and throws."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval
from ..registry import draws

_CLOTHS = (
    "grey fabric",
    "charcoal fabric",
    "beige fabric",
    "white fabric",
    "blue fabric",
    "navy fabric",
    "green fabric",
    "mustard fabric",
    "rust fabric",
    "rose fabric",
    "red fabric",
)


OFF_WALL = 0.09
"""Distance [m] of a curtain's cloth from the wall: a sill stands 0.07 m out of it."""

FOLD = 0.065
"""Width [m] of a fold of a curtain that is drawn open."""


def _inlay(b: Builder, polygon, h: float, level: int, material: Material | str) -> None:
    """A flat region of another colour; regions of a higher level (0 to 5) lie over lower ones."""
    top = _ground(h)
    b.add(shapes.extrusion(np.asarray(polygon), (h * 0.4, top + (h - top) * level / 5)), material, hulls=[])


def _ground(h: float) -> float:
    """Height [m] of the cloth under the pattern; a rug is so thin that its pattern is most of it."""
    return max(h - 0.0014, 0.5 * h)


def _rectangle(x: Interval, y: Interval) -> list[tuple[float, float]]:
    return [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]


def _woven(b: Builder, d: float, w: float, h: float, fringe: float) -> None:
    """A rectangular rug with a pattern; stripes run along y, the long side, and the fringes lie at its ends."""
    field = b.material("field", *_CLOTHS)
    second = b.material("second", "white fabric", "navy fabric", "beige fabric", "rust fabric", "charcoal fabric")
    if second.name == field.name:
        second = b.material("other second", "mustard fabric" if field.name != "mustard fabric" else "navy fabric")
    third = b.material(
        "third", "mustard fabric", "rose fabric", "green fabric", "red fabric", "blue fabric", "white fabric"
    )
    y1 = w / 2 - fringe
    x, y = (-d / 2, d / 2), (-y1, y1)
    whole = shapes.box(x, (-w / 2, w / 2), (0.0, h))
    with b.solid("rug"):
        b.add(shapes.box(x, y, (0.0, _ground(h))), field, hulls=[whole])
        edge = 0.012
        for xs, ys in (
            (x, (y[0], y[0] + edge)),
            (x, (y[1] - edge, y[1])),
            ((x[0], x[0] + edge), y),
            ((x[1] - edge, x[1]), y),
        ):
            _inlay(b, _rectangle(xs, ys), h, 5, second)
        if fringe:
            count = int(d / 0.025)
            for k in range(count):
                c = x[0] + (k + 0.5) * d / count
                for s in (-1, 1):
                    ys = sorted((s * y1, s * w / 2))
                    b.add(shapes.box((c - 0.004, c + 0.004), (ys[0], ys[1]), (0.0, h * 0.6)), "white fabric", hulls=[])
        pattern = b.pick("pattern", ["border", "stripes", "diamonds", "medallion", "checks", "zigzag", "arcs"])
        if pattern in ("border", "medallion"):
            for k, (inset, look) in enumerate(((0.06, second), (0.09, field), (0.16, third), (0.175, field))):
                m = inset * min(d, w)
                _inlay(b, _rectangle((x[0] + m, x[1] - m), (y[0] + m, y[1] - m)), h, k, look)
            if pattern == "medallion":
                for k, (share, look) in enumerate(((1.0, second), (0.78, third), (0.5, second), (0.25, field))):
                    a = np.arange(16) * math.pi / 8
                    wave = np.where(np.arange(16) % 2 == 0, 1.0, 0.84)
                    ring = np.c_[0.27 * d * wave * np.cos(a), 0.3 * y1 * 1.2 * wave * np.sin(a)] * share
                    _inlay(b, ring, h, min(5, k + 2), look)
        elif pattern == "stripes":
            count = b.whole("stripes", 5, 11)
            for k in range(count):
                c = x[0] + (k + 0.5) * d / count
                half = d / count * (0.25 if k % 2 else 0.12)
                _inlay(b, _rectangle((c - half, c + half), y), h, 1, second if k % 2 else third)
        elif pattern in ("diamonds", "checks"):
            n = max(2, round(d / 0.32))
            m = max(3, round((y[1] - y[0]) / 0.32))
            for i in range(n):
                for j in range(m):
                    cx, cy = x[0] + (i + 0.5) * d / n, y[0] + (j + 0.5) * (y[1] - y[0]) / m
                    rx, ry = 0.42 * d / n, 0.42 * (y[1] - y[0]) / m
                    if pattern == "diamonds":
                        diamond = np.array([(-rx, 0), (0, -ry), (rx, 0), (0, ry)])
                        _inlay(b, diamond + (cx, cy), h, 1, second)
                        _inlay(b, diamond * 0.5 + (cx, cy), h, 2, third if (i + j) % 2 else field)
                    elif (i + j) % 2:
                        _inlay(
                            b,
                            _rectangle((cx - rx * 1.19, cx + rx * 1.19), (cy - ry * 1.19, cy + ry * 1.19)),
                            h,
                            1,
                            second,
                        )
        elif pattern == "zigzag":
            rows, teeth = max(3, round(d / 0.35)), max(4, round((y[1] - y[0]) / 0.2))
            t = np.linspace(y[0] + 0.013, y[1] - 0.013, 2 * teeth + 1)
            tooth = np.where(np.arange(2 * teeth + 1) % 2 == 0, -0.03, 0.03)
            for k in range(rows):
                c = x[0] + (k + 0.5) * d / rows
                band = np.concatenate([np.c_[c + tooth + 0.035, t], np.c_[c + tooth[::-1] - 0.035, t[::-1]]])
                _inlay(b, band, h, 1, second if k % 2 else third)
        else:
            a = np.linspace(0, np.pi, 13)
            for k, look in enumerate((second, third, field, second)):
                r = min(d * 0.48, y1) * (0.95 - 0.2 * k)
                half = np.c_[r * np.cos(a) * 0.98, y[0] + 0.013 + 1.15 * r * np.sin(a)]
                _inlay(b, half, h, 1 + k, look)


@draws("rug")
def rug(b: Builder) -> None:
    """A rectangular rug: borders, stripes, diamonds, a medallion, checks, zigzags or arcs."""
    d, w, h = b.size
    _woven(b, d, w, h, 0.05 if b.chance("fringe", 0.5) else 0.0)


@draws("runner_rug")
def runner_rug(b: Builder) -> None:
    """A long narrow rug for a corridor."""
    d, w, h = b.size
    _woven(b, d, w, h, 0.04 if b.chance("fringe", 0.5) else 0.0)


@draws("round_rug")
def round_rug(b: Builder) -> None:
    """A round rug of rings, or braided of jute, or with rays."""
    depth, width, _ = b.request.size
    r, h = (b.size.depth if depth is not None and width is None else b.size.width) / 2, b.size.height
    field = b.material("field", *_CLOTHS, "rattan")
    second = b.material("second", "white fabric", "navy fabric", "beige fabric", "mustard fabric", "rust fabric")
    rings = b.whole("rings", 3, 8)
    with b.solid("rug"):
        b.add(shapes.frustum(r, r, (0.0, _ground(h)), 48), field, [shapes.frustum(r, r, (0.0, h), 48)])
        if b.chance("rays", 0.35):
            for k in range(16):
                a = np.array([k, k + 0.5]) * math.pi / 8
                ring = [(0.3 * r * math.cos(a.mean()), 0.3 * r * math.sin(a.mean()))]
                ring += [(0.86 * r * math.cos(t), 0.86 * r * math.sin(t)) for t in a]
                _inlay(b, ring, h, 1, second)
            rings = 0
        for k in range(rings):
            share = 1.0 - (k + 0.4) / rings
            top = _ground(h) + (h - _ground(h)) * (k + 1) / (rings + 1)
            b.add(
                shapes.frustum(r * share, r * share, (h * 0.4, top), 48),
                second if k % 2 == 0 else field,
                hulls=[],
            )
        b.add(shapes.frustum(r * 0.06, r * 0.06, (h * 0.4, h), 16), second, hulls=[])


@draws("doormat")
def doormat(b: Builder) -> None:
    """A coir mat with a dark rim and a simple pattern of bars."""
    d, w, h = b.size
    coir = b.material("mat", "wicker", "cork", "charcoal fabric", "grey fabric")
    dark = "charcoal fabric" if coir.name != "charcoal fabric" else "grey fabric"
    with b.solid("mat"):
        b.add(
            shapes.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h - 0.0014), 0.002),
            coir,
            [shapes.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h))],
        )
        m = 0.02
        x, y = (-d / 2 + m, d / 2 - m), (-w / 2 + m, w / 2 - m)
        for xs, ys in ((x, (y[0], y[0] + m)), (x, (y[1] - m, y[1])), ((x[0], x[0] + m), y), ((x[1] - m, x[1]), y)):
            _inlay(b, _rectangle(xs, ys), h, 5, dark)
        count = b.whole("bars", 3, 6)
        slant = b.uniform("slant", -0.08, 0.08)
        for k in range(count):
            c = (k + 0.5) * (w - 0.2) / count - (w - 0.2) / 2
            _inlay(
                b,
                [
                    (-d * 0.3, c - 0.018 - slant),
                    (d * 0.3, c - 0.018 + slant),
                    (d * 0.3, c + 0.018 + slant),
                    (-d * 0.3, c + 0.018 - slant),
                ],
                h,
                3,
                dark,
            )


def _pleats(b: Builder, y: Interval, z: Interval, depth: float, material: Material | str) -> None:
    """A hanging panel in soft folds between two ends."""
    count = max(4, round((y[1] - y[0]) / FOLD))
    n = count * 6 + 1
    t = np.linspace(0, 1, n)
    levels = np.array([0.0, 0.25, 0.42, 0.6, 0.85, 1.0])
    grid = np.zeros((n, len(levels), 3))
    for j, v in enumerate(levels):
        swing = (depth / 2 - 0.003) * (1.0 - 0.25 * v)
        wander = 0.25 * np.sin(2 * np.pi * t * 2.3 + 1.1 * v)
        grid[:, j, 0] = swing * np.sin(2 * np.pi * count * t + wander)
        grid[:, j, 1] = y[0] + 0.004 + t * (y[1] - y[0] - 0.008)
        grid[:, j, 2] = z[0] + v * (z[1] - z[0])
    shape = shapes.sheet(grid[:, ::-1], 0.003)
    b.add(shape, material, [shapes.box((-depth / 2, depth / 2), y, z)])


def _hang(b: Builder, cloth: Material) -> None:
    """Two panels drawn open: they hang beside the glass, and clear of a sill or radiator before the wall."""
    d, w, h = b.size
    metal = b.material("rod", "black steel", "brass", "oak", "brushed steel", "walnut")
    rod = h - 0.03
    thick = min(d - OFF_WALL, 0.08)
    front = d / 2 - thick / 2
    with b.solid("rod"), b.frame(front):
        b.bar((0, -w / 2 + 0.03, rod), (0, w / 2 - 0.03, rod), 0.012, metal, 12)
        for s in (-1, 1):
            b.ball((0.026, 0.026, 0.026), (0, s * (w / 2 - 0.026), rod), metal, 12)
            y = s * (w / 2 - 0.09)
            b.box((-front - d / 2, 0.0), (y - 0.006, y + 0.006), (rod - 0.008, rod + 0.008), metal, bevel=0.001)
            b.box((-front - d / 2, -front - d / 2 + 0.006), (y - 0.015, y + 0.015), (rod - 0.03, rod + 0.03), metal)
    edge = w / 2 - 0.055
    wide = min(max(0.26, b.uniform("drawn", 0.15, 0.2) * w), 0.9 * edge)
    for name, s in (("left", 1), ("right", -1)):
        y = sorted((s * edge, s * (edge - wide)))
        with b.solid(name), b.frame(front):
            _pleats(b, (y[0], y[1]), (0.0, rod - 0.012), thick, cloth)
            count = max(4, round((y[1] - y[0]) / FOLD))
            for k in range(count):
                c = y[0] + (k + 0.5) * (y[1] - y[0]) / count
                b.box((-0.017, 0.017), (c - 0.0025, c + 0.0025), (rod - 0.022, rod + 0.017), metal, bevel=0.001)


@draws("curtain")
def curtain(b: Builder) -> None:
    """Two panels in folds on a rod with round ends, rings and brackets."""
    _hang(b, b.material("cloth", *_CLOTHS))
    b.fit()


@draws("sheer_curtain")
def sheer_curtain(b: Builder) -> None:
    """Two panels of thin cloth that let light through."""
    _hang(b, b.material("cloth", "sheer fabric"))
    b.fit()


@draws("cushion")
def cushion(b: Builder) -> None:
    """A throw pillow that lies flat, with a seam, and stripes or a button in some."""
    d, w, h = b.size
    cloth = b.material("cover", *_CLOTHS, "tan leather")
    trim = b.material("trim", "white fabric", "mustard fabric", "charcoal fabric", "rust fabric", "navy fabric")
    with b.solid("cushion"):
        pillow = _pillow(d, w, h)
        b.add(pillow, cloth, [shapes.hull(pillow[0])])
        kind = b.pick("kind", ["plain", "stripes", "button", "edge"])
        if kind == "stripes":
            for share in (-0.24, 0.0, 0.24):
                band = _pillow(d, w, h, (share - 0.05, share + 0.05), 0.0012)
                b.add(band, trim, [shapes.hull(band[0])])
        elif kind == "button":
            b.ball((0.018, 0.018, 0.007), (0.0, 0.0, h - 0.004), trim, 12)
        elif kind == "edge":
            for share in (-0.46, 0.46):
                band = _pillow(d, w, h, (share - 0.035, share + 0.035), 0.0012)
                b.add(band, trim, [shapes.hull(band[0])])


def _pillow(d: float, w: float, h: float, part: Interval = (-0.5, 0.5), swell: float = 0.0):
    """A plump pillow with rounded corners, or the slice of it between two shares of its width."""
    n = 13
    u = np.sin(np.linspace(-np.pi / 2, np.pi / 2, n))
    v = u if part == (-0.5, 0.5) else np.linspace(2 * part[0], 2 * part[1], 5)
    uu, vv = np.meshgrid(u, v, indexing="ij")
    # Its edges bulge a little in their middles, and its middle is flat: filled to the corners.
    x = d / 2 * uu * (1 - 0.07 * vv**4)
    y = w / 2 * vv * (1 - 0.07 * uu**4)
    rise = np.clip((1 - uu**4) * (1 - vv**4), 0, 1) ** 0.5
    z = np.maximum((h / 2 - swell) * rise, 0.003) + swell
    grid = np.stack([x, y, z], axis=-1)
    faces = shapes.sheet(grid, 0.001)[1]
    upper, lower = grid.reshape(-1, 3), (grid * (1, 1, -1)).reshape(-1, 3)
    return np.concatenate([upper, lower]) + (0.0, 0.0, h / 2), faces


@draws("floor_cushion")
def floor_cushion(b: Builder) -> None:
    """A thick square or round cushion to sit on, tufted, with a handle of cloth."""
    d, w, h = b.size
    cloth = b.material("cover", *_CLOTHS)
    with b.solid("cushion"):
        handle = 0.02
        b.cushion(
            (-d / 2, d / 2 - handle), (-w / 2, w / 2), (0.0, h - 0.004), cloth, radius=min(0.06, h * 0.4), puff=0.18
        )
        for sx in (-1, 0, 1):
            for sy in (-1, 0, 1):
                b.ball((0.014, 0.014, 0.006), (sx * d * 0.22, sy * w * 0.22, h - 0.006), cloth, 10)
        x = d / 2 - handle
        b.tube(
            [
                (x - 0.01, -0.05, h * 0.5),
                (x + handle - 0.005, -0.04, h * 0.5),
                (x + handle - 0.005, 0.04, h * 0.5),
                (x - 0.01, 0.05, h * 0.5),
            ],
            0.005,
            cloth,
            8,
        )


@draws("blanket_throw")
def blanket_throw(b: Builder) -> None:
    """A blanket folded in layers, with a stripe and fringes."""
    d, w, h = b.size
    cloth = b.material("cloth", *_CLOTHS)
    trim = b.material("trim", "white fabric", "charcoal fabric", "mustard fabric")
    layers = 4
    step = h / layers
    fringe = 0.03
    with b.solid("blanket"):
        for k in range(layers):
            shift = 0.006 * math.sin(2.1 * k)
            b.cushion(
                (-d / 2 + abs(shift), d / 2 - fringe - abs(shift)),
                (-w / 2 + 0.004 * k, w / 2 - 0.003 * k),
                (k * step, (k + 1) * step),
                cloth,
                radius=step * 0.48,
            )
        x = d / 2 - fringe
        for share in (-0.3, 0.3):
            y = share * w
            b.box((-d / 2 + 0.02, x - 0.02), (y - 0.02, y + 0.02), (h - 0.004, h + 0.0008), trim, bevel=0.0)
        count = int(w / 0.02)
        whole = shapes.box((x - 0.01, d / 2), (-w / 2 + 0.012, w / 2 - 0.012), (step * 3.1, step * 3.7))
        for k in range(count):
            y = -w / 2 + 0.014 + (k + 0.5) * (w - 0.028) / count
            b.add(
                shapes.box((x - 0.012, d / 2), (y - 0.003, y + 0.003), (step * 3.2, step * 3.5)),
                trim,
                [whole] if k == 0 else [],
            )
