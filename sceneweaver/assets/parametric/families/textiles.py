"""Rugs, mats, curtains, cushions and throws."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import curtain, piping

_COLORS = ("grey", "charcoal", "beige", "white", "blue", "navy", "green", "mustard", "rust", "rose", "red")
CLOTHS = ", ".join(f"{color} fabric" for color in _COLORS)

OFF_WALL = 0.09
"""Distance [m] of a curtain's cloth from the wall: a sill stands 0.07 m out of it."""

COVERS = {"closed": 0.995, "half_closed": 0.5}
"""Share of the width that curtains cover in these postures."""

FOLD = 0.085
"""Width [m] of a fold of a curtain that is drawn open."""


def _ground(h: float) -> float:
    """Height [m] of the cloth under the pattern; a rug is so thin that its pattern is most of it."""
    return max(h - 0.0014, 0.5 * h)


def _inlay(d: Drawing, polygon, level: int, look: Look) -> None:
    """A flat region of another colour; regions of a higher level (1 to 9) lie over lower ones, never in one plane."""
    h = d.size.height
    top = _ground(h) + (h - _ground(h)) * level / 9
    d.add(shapes.extrusion(np.asarray(polygon), (0.4 * h, top)), look, [])


def _field(d: Drawing, box: Box, level: int, look: Look) -> None:
    (x0, x1), (y0, y1) = box.x, box.y
    _inlay(d, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], level, look)


def _rim(d: Drawing, box: Box, wide: float, look: Look) -> None:
    for strip in (box.left(wide), box.right(wide), box.front(wide).inset(y=wide), box.back(wide).inset(y=wide)):
        _field(d, strip, 9, look)


def _pattern(d: Drawing, box: Box, name: str, looks: tuple[Look, Look, Look]) -> None:
    """The woven pattern of a rug: the field, and two more colours; stripes run along y, its long side."""
    field, second, third = looks
    depth, width, _ = box.size
    if name in ("border", "medallion"):
        for k, (share, look) in enumerate(((0.06, second), (0.09, field), (0.16, third), (0.175, field))):
            _field(d, box.inset(x=share * depth, y=share * depth), k + 1, look)
    if name == "medallion":
        a = np.arange(16) * (math.pi / 8)
        star = np.c_[0.27 * depth * np.cos(a), 0.18 * width * np.sin(a)] * np.tile([1.0, 0.84], 8)[:, None]
        for k, (share, look) in enumerate(((1.0, second), (0.78, third), (0.5, second), (0.25, field))):
            _inlay(d, share * star, k + 5, look)
    elif name == "stripes":
        for k, stripe in enumerate(box.split("x", d.integer("stripes", 5, 11))):
            _field(d, stripe.share(x=(0.25, 0.75) if k % 2 else (0.38, 0.62)), 1, second if k % 2 else third)
    elif name in ("diamonds", "checks"):
        rows = box.split("x", max(2, round(depth / 0.32)))
        for i, row in enumerate(rows):
            for j, cell in enumerate(row.columns(max(3, round(width / 0.32)))):
                if name == "checks" and (i + j) % 2:
                    _field(d, cell, 1, second)
                elif name == "diamonds":
                    reach = 0.42 * np.array([(-cell.depth, 0), (0, -cell.width), (cell.depth, 0), (0, cell.width)])
                    _inlay(d, cell.center[:2] + reach, 1, second)
                    _inlay(d, cell.center[:2] + 0.5 * reach, 2, third if (i + j) % 2 else field)
    elif name == "zigzag":
        t = np.linspace(*box.inset(y=0.013).y, 2 * max(4, round(width / 0.2)) + 1)
        tooth = np.where(np.arange(len(t)) % 2 == 0, -0.03, 0.03)
        for k, row in enumerate(box.split("x", max(3, round(depth / 0.35)))):
            x = row.center[0] + tooth
            _inlay(d, np.r_[np.c_[x + 0.035, t], np.c_[x - 0.035, t][::-1]], 1, second if k % 2 else third)
    elif name == "arcs":
        a = np.linspace(0.0, np.pi, 17)
        for k, look in enumerate((second, third, field, second)):
            r = min(0.48 * depth, width / 2) * (0.95 - 0.2 * k)
            _inlay(d, np.c_[0.98 * r * np.cos(a), box.y[0] + 0.013 + 1.15 * r * np.sin(a)], 1 + k, look)


@draws("rug", "runner_rug", whole=True)
def rug(d: Drawing) -> None:
    """A rectangular rug: borders, stripes, diamonds, a medallion, checks, zigzags or arcs, with fringes in some."""
    field = d.material("field", CLOTHS)
    second = d.material("second", "white fabric, navy fabric, beige fabric, rust fabric, charcoal fabric")
    if second.name == field.name:
        second = d.material("other second", "mustard fabric" if not field.called("mustard fabric") else "navy fabric")
    third = d.material("third", "mustard fabric, rose fabric, green fabric, red fabric, blue fabric, white fabric")
    fringe = (0.04 if d.category.name == "runner_rug" else 0.05) if d.chance("fringe", 0.5) else 0.0
    box, h = d.bounds, d.size.height
    cloth = box.inset(y=fringe)
    d.add(shapes.box(cloth.x, cloth.y, (0.0, _ground(h))), field, [shapes.box(box.x, box.y, box.z)])
    _rim(d, cloth, 0.012, second)
    if fringe:
        with d.mirror("y"), d.no_colliders():
            for tassel in box.left(fringe).bottom(0.6 * h).split("x", int(box.depth / 0.025), gap=0.017):
                d.box(tassel, "white fabric", bevel=0.0)
    if field.printed:
        return
    patterns = ["border", "stripes", "diamonds", "medallion", "checks", "zigzag", "arcs"]
    _pattern(d, cloth, d.pick("pattern", patterns), (field, second, third))


@draws("round_rug", whole=True, even="round")
def round_rug(d: Drawing) -> None:
    """A round rug of rings, or with rays."""
    box, h = d.even("round"), d.size.height
    r = box.width / 2
    field = d.material("field", CLOTHS, "rattan")
    second = d.material("second", "white fabric, navy fabric, beige fabric, mustard fabric, rust fabric")
    rings = d.integer("rings", 3, 8)
    ground = shapes.frustum(r, r, (0.0, _ground(h)), 48)
    d.add(ground, field, [shapes.frustum(r, r, (0.0, h), 48)])
    a = np.arange(48) * (math.pi / 24)
    circle = r * np.c_[np.cos(a), np.sin(a)]
    if d.chance("rays", 0.35) and not field.printed:
        for k in range(0, 48, 3):
            _inlay(d, [0.3 * circle[k + 1], 0.86 * circle[k], 0.86 * circle[k + 1]], 1, second)
        rings = 0
    for k in range(0 if field.printed else rings):
        top = _ground(h) + (h - _ground(h)) * (k + 1) / (rings + 1)
        share = 1.0 - (k + 0.4) / rings
        d.add(shapes.extrusion(share * circle, (0.4 * h, top)), field if k % 2 else second, [])
    with d.no_colliders():
        d.cylinder(box.share(z=(0.4, 1.0)).place(0.12 * r, 0.12 * r), second, segments=16)


@draws("doormat", whole=True)
def doormat(d: Drawing) -> None:
    """A coir mat with a dark rim and a simple pattern of bars."""
    box, h = d.bounds, d.size.height
    coir = d.material("mat", "wicker, cork, charcoal fabric, grey fabric")
    dark = "charcoal fabric" if not coir.called("charcoal fabric") else "grey fabric"
    slant = d.uniform("slant", -0.08, 0.08)
    mat = shapes.box(box.x, box.y, (0.0, h - 0.0014), 0.002)
    d.add(mat, coir, [shapes.box(box.x, box.y, box.z)])
    _rim(d, box.inset(x=0.02, y=0.02), 0.02, dark)
    for bar in box.share(x=(0.2, 0.8)).inset(y=0.1).columns(d.integer("bars", 3, 6)):
        y, ends = bar.center[1], ((0, -1, -1), (1, 1, -1), (1, 1, 1), (0, -1, 1))
        _inlay(d, [(bar.x[i], y + s * slant + t * 0.018) for i, s, t in ends], 3, dark)


@draws("curtain", "sheer_curtain", whole=True)
def curtains(d: Drawing) -> None:
    """Two panels in folds, of cloth or of a thin one that lets light through, on a rod or a track; tied in some.

    They hang beside the glass unless they are to be closed or half open, and clear of a sill or a radiator before the
    wall.
    """
    drawn = d.takes("closed", "half_closed", "drawn_back")
    sheer, box = d.category.name == "sheer_curtain", d.bounds
    cloth = d.material("cloth", "sheer fabric" if sheer else CLOTHS)
    metal = d.material("rod", "black steel, brass, oak, brushed steel, walnut")
    on_track, tied = d.chance("track", 0.2), d.chance("tied", 0.3) and drawn not in COVERS
    thick = min(box.depth - OFF_WALL, 0.08)
    axis, rod, end = box.x[1] - thick / 2, box.height - 0.03, box.y[1]
    with d.part("rod"):
        if on_track:
            d.box(Box.around((axis, 0.0, rod + 0.012), 0.04, box.width, 0.036), "white paint", bevel=0.004)
        else:
            d.bar((axis, -end + 0.06, rod), (axis, end - 0.06, rod), 0.012, metal, 12)
        with d.mirror("y"):
            y = end - 0.1
            d.box(Box((box.x[0], axis), (y - 0.007, y + 0.007), (rod - 0.008, rod + 0.008)), metal, bevel=0.002)
            d.box(Box.around((box.x[0] + 0.003, y, rod - 0.002), 0.006, 0.032, 0.064), metal, bevel=0.002)
            if not on_track:
                with d.at(axis, end - 0.07, rod, roll=-math.pi / 2):
                    finial = [
                        (0.014, 0.0),
                        (0.018, 0.004),
                        (0.01, 0.01),
                        (0.026, 0.034),
                        (0.028, 0.046),
                        (0.018, 0.064),
                    ]
                    d.revolve([*finial, (0.004, 0.07)], metal, 14)
    wide = min(max(0.28, d.uniform("drawn", 0.15, 0.2) * box.width), 0.9 * (end - 0.06))
    wide = COVERS[drawn] * (end - 0.06) if drawn in COVERS else wide
    panel = Box((axis - thick / 2, axis + thick / 2), (end - 0.06 - wide, end - 0.06), (0.0, rod - 0.016))
    folds = max(4, round(wide / FOLD))
    with d.mirror("y"), d.part("panel"):
        curtain(d, panel, cloth, folds, 0.45 if tied else 0.0, d.uniform("phase", 0.0, 6.0))
        d.box(panel.top(0.02).place(depth=0.02), cloth, bevel=0.004)
        if tied:
            loop = panel.share(z=(0.4, 0.44)).inset(x=0.01).place(width=0.6 * wide)
            d.slab(loop, cloth, 0.03, 0.004)
        for cell in panel.top(-0.016).columns(folds):
            x, y, _ = cell.center
            if on_track:
                d.box(Box.sized(0.006, 0.012, 0.03, (x, y, panel.z[1] - 0.005)), "white plastic", bevel=0.0)
                continue
            with d.no_colliders():
                d.hoop(Box.around((x, y, rod - 0.005), 0.033, 0.0, 0.033), 0.0028, metal, "y", 12)


@draws("cushion", whole=True)
def cushion(d: Drawing) -> None:
    """A throw pillow that lies flat, with a cord along its seam, a button or a ruffled edge in some."""
    cloth = d.material("cover", CLOTHS, "tan leather")
    trim = d.material("trim", "white fabric, mustard fabric, charcoal fabric, rust fabric, navy fabric")
    kind = d.pick("kind", ["plain", "cord", "button", "flange"])
    box, h = d.bounds, d.size.height
    edge = {"cord": 0.004, "flange": 0.02}.get(kind, 0.0)
    body = d.pillow(box.inset(x=edge, y=edge), cloth)
    if kind == "flange":
        d.slab(box.place(height=0.006), trim, 0.02, 0.002)
    elif kind == "cord":
        t = np.linspace(-1.0, 1.0, 7)[:-1]
        side = np.c_[t, -1.0 + 0.04 * (1 - t**2)]
        turns = [side, side[:, ::-1] * (-1, 1), -side, side[:, ::-1] * (1, -1)]
        ring = np.concatenate(turns) * (body.depth / 2, body.width / 2)
        d.sweep(np.c_[ring, np.full(len(ring), h / 2)], 0.004, trim, segments=6, closed=True)
    elif kind == "button":
        d.ball(Box.around((0.0, 0.0, h - 0.006), 0.036, 0.036, 0.012), trim, segments=12)


@draws("floor_cushion", whole=True)
def floor_cushion(d: Drawing) -> None:
    """A thick square cushion to sit on, tufted, with piping and a handle of cloth."""
    cloth, h = d.material("cover", CLOTHS), d.size.height
    box = d.bounds.inset(front=0.02, top=0.003)
    radius = min(0.06, 0.4 * h)
    piping(d, d.cushion(box, cloth, radius), cloth, radius)
    with d.grid(box.top(0.0).share(x=(0.11, 0.89), y=(0.11, 0.89)), x=3, y=3):
        d.ball(Box.around((0.0, 0.0, -0.002), 0.03, 0.03, 0.01), cloth, segments=10)
    handle = ((-0.01, -0.06), (0.015, -0.04), (0.015, 0.04), (-0.01, 0.06))
    d.sweep([(box.x[1] + x, y, h / 2) for x, y in handle], 0.005, cloth)


@draws("blanket_throw", whole=True)
def blanket_throw(d: Drawing) -> None:
    """A blanket folded in layers, with stripes and fringes in front."""
    cloth, trim = d.material("cloth", CLOTHS), d.material("trim", "white fabric, charcoal fabric, mustard fabric")
    folded = d.bounds.inset(front=0.03)
    layers = folded.rows(4)
    for k, layer in enumerate(layers):
        own = layer.inset(x=abs(0.006 * math.sin(2.1 * k)), y=0.0035 * k, bottom=-0.002 * (k > 0))
        d.cushion(own, cloth, 0.48 * layer.height, 0.1)
    for share in (0.2, 0.8):
        d.print(folded.top(0.0).inset(x=0.03).place(width=0.04).move(y=(share - 0.5) * folded.width), trim, 0.0012)
    edge = layers[3].front(-0.03).inset(y=0.014, z=0.3 * layers[3].height)
    for strand in edge.inset(back=-0.01).columns(int(folded.width / 0.02), gap=0.014):
        d.box(strand, trim, bevel=0.0)
