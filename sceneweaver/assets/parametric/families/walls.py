"""Pictures, mirrors, clocks and screens on the wall or before it."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import art, beam, clock_face, frame, leg

_FRAMES = "oak, walnut, black paint, white paint, brass, light oak, cherry"


def _rng(d: Drawing) -> np.random.Generator:
    return np.random.default_rng(d.integer("art", 0, 2**31 - 1))


def _framed(d: Drawing, box: Box, look: Look, bar: float, mat: float, rng: np.random.Generator) -> None:
    """A picture in a frame of four bars, with a mat of paper ``mat`` wide (0 for none)."""
    sheet = frame(d, box, look, bar).inset(front=min(0.011, 0.5 * box.depth))
    d.box(sheet, "chalk pigment", 0.0)
    art(d, sheet.front(-0.003).inset(y=mat, z=mat), rng)


@draws("picture", whole=True)
def picture(d: Drawing) -> None:
    """A framed painting: landscape, sea, blocks, circles, arches, leaves or waves."""
    mat = d.uniform("mat", 0.03, 0.07) if d.chance("has mat", 0.5) else 0.0
    _framed(d, d.bounds, d.material("frame", _FRAMES), d.uniform("bar", 0.018, 0.035), mat, _rng(d))


@draws("poster", whole=True)
def poster(d: Drawing) -> None:
    """A print on paper between two wooden bars, with two lines of print below the picture."""
    wood = d.material("bars", "light oak, walnut, black paint, oak")
    box = d.bounds
    for bar in (box.top(0.022), box.bottom(0.022)):
        d.box(bar, wood)
    sheet = d.box(box.back(0.003).inset(y=0.006, z=0.01), "paper", 0.0)
    art(d, sheet.front(-0.003).inset(y=0.05, top=0.06, bottom=0.2 * box.height), _rng(d))
    for share, z in ((0.6, 0.13), (0.35, 0.08)):
        line = sheet.front(0.0).place(width=share * box.width)
        d.print(line.to(z=(z * box.height - 0.01, z * box.height + 0.01)), "ink pigment")


@draws("photo_frames", whole=True)
def photo_frames(d: Drawing) -> None:
    """Five or six small frames hung together."""
    looks = [d.material("frame", _FRAMES)] * 2
    if d.chance("two woods", 0.5):
        looks[1] = d.material("second frame", _FRAMES)
    # Of each plan its columns: where they begin and end, and where each is cut.
    plans = [
        [(0.0, 0.4, (0.0, 0.45, 1.0)), (0.4, 0.72, (0.0, 0.62, 1.0)), (0.72, 1.0, (0.12, 0.5, 0.9))],
        [(0.0, 0.3, (0.1, 0.5, 0.95)), (0.3, 0.7, (0.0, 1.0)), (0.7, 1.0, (0.05, 0.5, 1.0))],
        [(0.0, 0.34, (0.0, 0.5, 1.0)), (0.34, 0.67, (0.0, 0.5, 1.0)), (0.67, 1.0, (0.0, 0.5, 1.0))],
    ]
    rng, half = _rng(d), 0.0175  # half the gap between two
    cells = [((u, v), z) for u, v, cuts in d.pick("plan", plans) for z in zip(cuts[:-1], cuts[1:], strict=True)]
    for k, ((u, v), (low, high)) in enumerate(cells):
        gaps = {"right": u > 0, "left": v < 1, "bottom": low > 0, "top": high < 1}
        cell = d.bounds.share(y=(u, v), z=(low, high)).inset(**{side: half * there for side, there in gaps.items()})
        _framed(d, cell, looks[k % 2], 0.014, 0.1 * min(cell.width, cell.height), rng)


@draws("wall_mirror", whole=True)
def wall_mirror(d: Drawing) -> None:
    """A mirror in a rectangular frame, or one with an arched head."""
    look = d.material("frame", "black steel, brass, oak, walnut, white paint")
    box, bar = d.bounds, d.uniform("bar", 0.02, 0.05)
    if not d.chance("arch", 0.4):
        d.box(frame(d, box, look, bar).inset(front=0.006), "mirror", 0.0)
        return
    turn = np.linspace(0, np.pi, 17)
    for place, finish in ((box.inset(front=0.003), look), (box.inset(y=0.022, z=0.022), "mirror")):
        rise = 0.5 * place.width / place.height
        head = np.c_[0.5 + 0.5 * np.cos(turn), 1 - rise + rise * np.sin(turn)]
        d.silhouette(place, [(0.0, 0.0), (1.0, 0.0), *head], finish, "x")


@draws("gym_mirror", whole=True)
def gym_mirror(d: Drawing) -> None:
    """Panels of mirror side by side, without a frame, held by rails at the foot and the head."""
    box = d.bounds
    for pane in box.inset(front=0.004, y=0.003, z=0.012).columns(max(2, round(box.width)), gap=0.006):
        d.box(pane, "mirror", 0.0)
    for rail in (box.top(0.02), box.bottom(0.02)):
        d.box(rail, "brushed steel", 0.0)


@draws("round_mirror", whole=True, even="round")
def round_mirror(d: Drawing) -> None:
    """A round mirror in a thin ring, or with rays like a sun."""
    look = d.material("frame", "brass, black steel, oak, walnut, rattan")
    box = d.even("round")
    r = box.width / 2
    sun = d.chance("sun", 0.3)
    rim = 0.44 * r if sun else 0.0
    if sun:
        with d.at(0.0, 0.0, r, pitch=math.pi / 2), d.ring(16):
            for turn, out in ((0.0, r), (math.pi / 16, 0.84 * r)):
                c, s = math.cos(turn), math.sin(turn)
                d.bar((0.56 * r * c, 0.56 * r * s, 0.0), (out * c, out * s, 0.0), 0.004, look, 6)
    ring = d.cylinder(box.inset(y=rim, z=rim, front=0.002), look, "x", bevel=0.003, segments=40)
    inner = 0.1 * (r - rim) if sun else 0.018
    d.cylinder(ring.inset(y=inner, z=inner, front=-0.002, back=0.5 * ring.depth), "mirror", "x", segments=40)


@draws("standing_mirror")
def standing_mirror(d: Drawing) -> None:
    """A tall mirror that leans back in a frame, with a prop behind."""
    wood = d.material("frame", "oak, walnut, black steel, white paint, brass")
    (deep, w, h), thick, bar = d.size, 0.028, d.uniform("bar", 0.03, 0.05)
    lean = math.asin(min(0.22, 0.42 * deep / h))
    leaf = Box((0.0, thick), (-w / 2, w / 2), (0.0, (h - thick * math.sin(lean)) / math.cos(lean)))
    with d.at(deep / 2 - thick * math.cos(lean), pitch=-lean), d.part("frame"):
        inner = frame(d, leaf, wood, bar)
        d.box(inner.inset(back=0.004, front=0.006), "mirror", 0.0)
        d.box(inner.back(0.006).inset(y=-0.5 * bar, z=-0.5 * bar), wood, 0.0)
    with d.part("prop"):
        top = 0.62 * h
        foot, head = 0.012 - deep / 2, deep / 2 - thick - math.tan(lean) * top
        with d.mirror("y"):
            leg(d, (foot, 0.3 * w, 0.0), (head, 0.3 * w, top), 0.024, 0.024, wood, 4)
        d.box(Box.around((foot + 0.3 * (head - foot), 0.0, 0.3 * top), 0.016, 0.6 * w, 0.024), wood)
    d.fit()


@draws("wall_clock", whole=True, even="round")
def wall_clock(d: Drawing) -> None:
    """A round clock with marks and hands."""
    rim = d.material("rim", "black steel, oak, walnut, brass, white plastic, red plastic, copper")
    dial = d.material("dial", "white paint, cream paint, black paint, navy paint")
    hands = "white paint" if dial.called("black paint", "navy paint") else "black steel"
    box, deep = d.even("round"), d.size.depth
    r = box.width / 2
    with d.at(box.x[0], 0.0, r, pitch=math.pi / 2):
        shape = [(0.94, 0.0), (1.0, 0.006), (1.0, deep - 0.006), (0.975, deep), (0.95, deep), (0.93, deep - 0.01)]
        d.revolve([(r * s, z) for s, z in shape], rim, 40, hollow=True)
    inner = 0.07 * r
    clock_face(d, box.inset(y=inner, z=inner), dial, hands)


@draws("grandfather_clock", whole=True)
def grandfather_clock(d: Drawing) -> None:
    """A tall case: plinth, waist with a pendulum behind glass, hood with dial and pediment."""
    wood, brass = d.material("case", "cherry, mahogany, walnut, oak"), "brass"
    box, h = d.bounds, d.size.height
    base, hood = 0.24 * h, 0.7 * h
    d.box(box.bottom(0.07), wood, 0.006)
    d.box(box.to(z=(0.07, base)).inset(front=0.015, y=0.02), wood)
    for z in (base, hood):
        d.box(box.to(z=(z, z + 0.025)).inset(y=0.005), wood, 0.008)
    waist = box.to(z=(base + 0.025, hood)).inset(front=0.045, y=0.055)
    d.box(waist.inset(front=0.012), wood)
    glass = frame(d, waist.front(0.012), wood, 0.05, 0.001).back(0.002)
    d.box(glass, "black glass", 0.0)
    rod = d.box(glass.front(-0.003).place(width=0.012).inset(bottom=0.14), brass, 0.0)
    d.cylinder(Box.around(rod.anchor("bottom back"), 0.012, 0.1, 0.1), brass, "x")
    top = h - 0.09
    head = d.box(box.to(z=(hood + 0.025, top)).inset(front=0.02, y=0.03), wood)
    with d.mirror("y"):
        pillar = Box.sized(0.032, 0.032, head.height, (head.x[1] - 0.004, head.y[1] - 0.01, head.z[0]))
        d.cylinder(pillar, wood, ends=(1.0, 0.85), segments=12)
    r = min(box.width / 2 - 0.075, 0.42 * (top - hood))
    plate = Box.around(head.anchor("front"), 0.0, 2 * r, 2 * r).front(-0.006).inset(back=-0.01)
    d.cylinder(plate.inset(y=-0.014, z=-0.014), brass, "x", segments=32)
    clock_face(d, plate.inset(front=-0.008), "cream paint", "black steel")
    d.box(box.to(z=(top, top + 0.03)), wood, 0.008)
    with d.mirror("y"):
        gable = box.inset(back=0.02, front=0.02).to(y=(0.03, box.y[1] - 0.02), z=(top + 0.03, h - 0.012))
        d.silhouette(gable, [(0.0, 0.0), (1.0, 0.0), (0.2, 0.85), (0.0, 1.0)], wood, "x")
    finial = Box.sized(0.048, 0.048, h - top - 0.03, (0.0, 0.0, top + 0.03))
    d.turned(finial, [(0.8, 0.0), (1.0, 0.35), (0.5, 0.5), (0.66, 0.72), (0.0, 1.0)], brass, 12)


def _screen(d: Drawing, box: Box, bezel: Look) -> None:
    """A flat set that fills a box: a case, a dark panel in a thin rim, a chin, and on some a picture with tiles."""
    case = box.inset(back=0.018, front=0.002)
    d.box(case, bezel)
    d.box(box.back(0.022).inset(y=0.2 * box.width).share(z=(0.15, 0.6)), "black plastic", 0.006)
    panel = box.front(0.006).inset(y=0.006, top=0.006, bottom=0.018)
    d.box(panel.inset(front=0.003), "black glass", 0.0)
    chin = d.print(case.front(0.0).bottom(0.016).inset(y=0.004, bottom=0.003), "brushed steel")
    d.print(chin.place(width=0.06, height=0.006), "black plastic", 0.00045)
    d.print(chin.share(y=(0.08, 0.08 + 0.008 / box.width)).place(height=0.004), "red plastic", 0.00045)
    if not d.chance("on", 0.7):
        d.box(panel.front(0.004), "black glass", 0.0)
        return
    # A menu: a large picture, and a row of smaller ones below.
    shown = panel.inset(y=0.004, z=0.004)
    d.box(panel.inset(back=0.002, front=0.0022), "screen", 0.0)
    rng = _rng(d)
    art(d, shown.front(0.002).share(z=(0.36, 1.0)), rng, d.pick("shown", ["hills", "sea", "hills"]))
    for tile in shown.front(0.002).share(y=(0.03, 0.97), z=(0.06, 0.31)).columns(5, gap=0.02 * box.width):
        art(d, tile, rng)


@draws("tv")
def tv(d: Drawing) -> None:
    """A flat television on the wall."""
    box = d.bounds.to(z=(0.0, 0.5625 * d.size.width + 0.013))
    with d.part("tv"):
        _screen(d, box, d.material("bezel", "black plastic, black steel, brushed steel"))


@draws("tv_on_stand")
def tv_on_stand(d: Drawing) -> None:
    """A flat television on two feet or on a plate, its cable hanging behind."""
    bezel = d.material("bezel", "black plastic, black steel, brushed steel")
    (deep, w, _), lift = d.size, 0.07
    with d.part("screen"):
        _screen(d, Box((-0.03, 0.03), (-w / 2, w / 2), (lift, lift + 0.5625 * w + 0.013)), bezel)
    with d.part("foot"):
        if d.chance("plate", 0.4):
            d.slab(Box.sized(deep, 0.4 * w, 0.012), bezel, 0.02, 0.004)
            d.box(Box((-0.028, 0.0), (-0.06, 0.06), (0.01, lift + 0.1)), bezel)
        else:
            with d.mirror("x", "y"):
                beam(d, (deep / 2 - 0.015, 0.36 * w, 0.006), (0.0, 0.36 * w, lift + 0.01), bezel, 0.018, 0.012)
                d.box(Box.sized(0.03, 0.018, 0.012, (deep / 2 - 0.015, 0.36 * w, 0.0)), bezel)
        cable = [(-0.03, 0.12, lift + 0.06), (-0.06, 0.12, 0.05), (-0.07, 0.13, 0.006), (-0.08, 0.2, 0.004)]
        d.sweep(cable, 0.003, "black plastic", 6)
