"""Sofas and other upholstered seats."""

from __future__ import annotations

import math
from typing import NamedTuple

from ...body import Material
from ...drawing import Box, Drawing, draws
from ...drawing.components import cushions, legs, piping
from ...materials import finish

COVERS = ("@fabric", "brown leather", "tan leather", "black leather")
_WOODS = ("oak", "walnut", "black paint")
_METALS = ("black steel", "chrome", "brass")
_THROWS = tuple(f"{color} fabric" for color in ("beige", "mustard", "rust", "white", "navy", "green", "rose"))
_ARMS = {"block": 0.17, "round": 0.19, "slim": 0.09, "flared": 0.13, "wood": 0.07}


def contrasting(cover: Material) -> list[str]:
    """Cloths for loose things that do not vanish on the cover."""
    return [name for name in _THROWS if not cover.near(finish(name).material.color, 0.2)]


def throw_pillow(d: Drawing, role: str, cover: Material, x: float, y: float, z: float, yaw: float = 0.25) -> None:
    """A square pillow that stands on a seat at height z and leans back against x."""
    cloth = d.material(role, *contrasting(cover))
    with d.at(x, y, z + 0.21, yaw=yaw, pitch=1.2):
        d.pillow(Box.around((0.0, 0.0, -0.01), 0.42, 0.42, 0.15), cloth)


class Style(NamedTuple):
    """Shapes and heights [m] of a sofa."""

    arms: str
    arm: float
    arm_top: float
    legs: str
    foot: float
    seat: float
    back: float


def _style(d: Drawing, narrow: bool = False) -> Style:
    arms = d.pick("arms", list(_ARMS))
    arm = min(_ARMS[arms], 0.15) if narrow else _ARMS[arms]
    foot = d.uniform("leg height", 0.09, 0.15) if d.chance("long legs", 0.7) else 0.05
    top, back = d.uniform("arm top", 0.58, 0.64), d.uniform("back", 0.13, 0.17)
    feet = d.pick("leg style", ["tapered", "block", "metal"])
    return Style(arms, arm, top, feet, foot, d.uniform("seat height", 0.42, 0.46), back)


def _feet(d: Drawing, box: Box, style: Style) -> None:
    """Four feet, six under a long sofa."""
    metal = style.legs == "metal"
    wood = d.material("metal legs", *_METALS) if metal else d.material("legs", *_WOODS)
    with d.part("base"):
        if style.legs == "tapered" and style.foot > 0.06:
            legs(d, box.inset(x=0.03, y=0.04), wood, "splayed", 0.042, 0.02)
            return
        wide = 0.028 if metal else 0.06
        stand = box.inset(x=0.04, y=0.05)
        legs(d, stand, wood, "square", wide)
        if box.width > 1.8:
            for end in ("front", "back"):
                d.box(stand.place(wide, wide, at=end), wood)


def _arm(d: Drawing, box: Box, style: Style, cover: Material) -> None:
    """The left arm; the box reaches down to where the upholstery begins."""
    if style.arms == "round":
        r = box.width / 2
        d.cushion(box.inset(y=0.015, top=r), cover, 0.025)
        roll = d.cylinder(box.top(2 * r).inset(x=0.005), cover, "x", segments=24, bevel=0.014)
        d.cylinder(roll.front(-0.006).place(width=0.8 * box.width, height=0.8 * box.width), cover, "x", bevel=0.004)
    elif style.arms == "flared":
        with d.at(y=box.y[0] + 0.05, z=box.z[0] + 0.01, roll=-0.13):
            d.cushion(Box(box.x, (-0.05, 0.05), (0.0, box.height - 0.02)), cover, 0.035)
    elif style.arms == "wood":
        wood = d.material("legs", *_WOODS)
        side = box.to(z=(0.0, box.z[1]))
        for post in (side.inset(x=0.038).back(0.044), side.inset(x=0.038).front(0.044)):
            d.box(post.inset(top=0.03).place(width=0.036), wood)
        d.box(side.top(0.03), wood, bevel=0.01)
        d.box(side.inset(x=0.08).to(z=(box.z[0] + 0.06, box.z[0] + 0.13)).place(width=0.024), wood)
    else:
        d.cushion(box, cover, 0.03 if style.arms == "slim" else 0.04)


def _seat(
    d: Drawing,
    box: Box,
    style: Style,
    cover: Material,
    count: int = 1,
    name: str = "seat",
    lean: float = 0.14,
    pillows: tuple[int, ...] = (),
    buttons: bool = False,
) -> None:
    """Base, back frame and so many seat and back cushions between the arms, with pillows on some of the seats."""
    front = box.x[0] + style.back
    with d.part("base" if name == "seat" else name):
        d.cushion(box.to(z=(style.foot, 0.28)).inset(back=0.01, front=0.015), cover, 0.02)
        place = box.to(x=(front - 0.02, box.x[1]), z=(0.265, style.seat))
        cells = cushions(d, place, count, cover, 0.045, 0.0, 0.004, cover)
    with d.part("back"):
        d.cushion(box.back(style.back).inset(bottom=style.foot, top=0.07), cover, 0.04)
    for k, cell in enumerate(cells):
        with d.part("back"), d.at(front + 0.035, z=style.seat - 0.005, pitch=-lean):
            rest = Box((-0.02, 0.13), cell.inset(y=0.003).y, (0.02, box.z[1] - style.seat + 0.005))
            d.cushion(rest, cover, 0.05, puff=0.35)
            if buttons:
                _buttons(d, rest.inset(front=0.004), cover, 3, 2)
        start = front + 0.195
        if k in pillows:
            y, yaw = (cell.y[0] + 0.24, -0.25) if k == 0 else (cell.y[1] - 0.24, 0.25)
            throw_pillow(d, f"pillow {k % 2}", cover, start + 0.005, y, style.seat, yaw)
            start += 0.2
        end = box.x[1] - 0.055
        if name == "chaise" and d.chance("throw", 0.5):
            throw = cell.inset(y=-0.006, bottom=-0.005, top=-0.008).to(x=(end - 0.465, end - 0.145))
            end = throw.x[0] - 0.02
            with d.part("throw"):
                d.box(throw, d.material("throw", *contrasting(cover)), bevel=0.02)
        d.surface(f"{name}-{k}" if count > 1 else name, cell.to(x=(start + 0.02, end)).inset(y=0.05))


def _buttons(d: Drawing, box: Box, cover: Material, columns: int, rows: int) -> None:
    """Tufting buttons sunk in the front of a cushion."""
    with d.grid(box.front(0.0).inset(y=0.08, z=0.08), y=columns, z=rows):
        d.ball(Box.around((0.0, 0.0, 0.05), 0.018, 0.026, 0.026), cover, segments=8)


@draws("sofa", "loveseat", "armchair")
def sofa(d: Drawing) -> None:
    """Base on feet, arms of five kinds, seat and back cushions, loose pillows; armchairs with wings in some."""
    cover = d.material("cover", *COVERS)
    single = d.category.name == "armchair"
    style, wing = _style(d, single), single and d.size.height > 0.92
    if wing:
        style = style._replace(arms="round" if style.arms in ("slim", "wood") else style.arms, arm=0.12)
    count = 1 if single else 2 if d.category.name == "loveseat" else d.pick("seats", [3, 3, 2])
    pillows = () if single else d.pick("pillows", [(0,), (0, count - 1), (0, count - 1), ()])
    buttons = d.chance("buttons", 0.35 if single else 0.25)
    room = d.bounds.inset(y=style.arm - 0.005)
    _seat(d, room, style, cover, count, lean=0.16 if single else 0.14, pillows=pillows, buttons=buttons)
    side = d.bounds.left(style.arm).inset(front=0.02)
    with d.mirror("y"):
        with d.part("arm"):
            _arm(d, side.to(z=(style.foot, style.arm_top)), style, cover)
        if wing:
            with d.part("wing"):
                ear = side.to(z=(style.arm_top - 0.06, d.size.height - 0.03)).inset(back=0.02).back(0.28)
                d.cushion(ear.place(width=0.08, at="left").move(y=-0.02), cover, 0.035)
    if style.arms != "wood":
        _feet(d, d.bounds.bottom(style.foot + 0.01), style)
    d.fit()


@draws("sectional_sofa")
def sectional_sofa(d: Drawing) -> None:
    """A sofa whose seat at one end runs out to a chaise."""
    cover = d.material("cover", *COVERS)
    style = _style(d)
    if style.arms == "wood":
        style = style._replace(arms="block", arm=0.17)
    if style.legs == "tapered":
        style = style._replace(legs="block")
    back, width = d.bounds.back(0.95), min(0.95, 0.36 * d.size.width)
    between = d.bounds.inset(y=style.arm - 0.005)
    ends = ("left", "right") if d.chance("chaise left", 0.5) else ("right", "left")
    chaise = between.place(width=width, at=ends[0])
    couch = back.to(y=between.y).inset(**{ends[0]: width})
    _seat(d, couch, style, cover, 2, pillows=d.pick("pillows", [(0,), (1,), (0, 1)]))
    _seat(d, chaise, style, cover, name="chaise")
    wood = d.material("metal legs", *_METALS) if style.legs == "metal" else d.material("legs", *_WOODS)
    foot = chaise.bottom(style.foot + 0.005).inset(front=0.06, y=0.04)
    with d.part("chaise"):
        for end in ("left", "right"):
            d.box(foot.place(0.04, 0.04, at=f"front {end}"), wood)
    with d.mirror("y"), d.part("arm"):
        _arm(d, back.left(style.arm).inset(front=0.02).to(z=(style.foot, style.arm_top)), style, cover)
    _feet(d, back.bottom(style.foot + 0.01), style)
    d.fit()


@draws("sofa_bed")
def sofa_bed(d: Drawing) -> None:
    """A fold-down sofa: a tufted mattress for seat and back, bedding drawers below, arms."""
    cover = d.material("cover", "@fabric")
    wooden = d.chance("wooden frame", 0.5)
    wood = d.material("legs", "oak", "walnut", "light oak", "pine", "white paint")
    arm, seat = 0.07 if wooden else 0.13, 0.43
    room, top = d.bounds.inset(y=arm), d.size.height
    case = room.to(z=(0.07, 0.24)).inset(back=0.1, front=0.03)
    with d.part("base"):
        d.box(case.inset(front=0.02), wood)
        for front in case.front(0.021).inset(z=0.01).columns(2, gap=0.02):
            d.box(front, wood)
            d.box(front.front(-0.015).place(width=0.12, height=0.025).move(z=0.01), "black steel", bevel=0.004)
        legs(d, room.bottom(0.075).inset(back=0.13, front=0.09, y=0.03), wood, width=0.06)
        cells = cushions(d, room.to(z=(0.24, seat)).inset(back=0.22), 3, cover, 0.055, 0.0, 0.006, cover)
    with d.part("back"), d.at(room.x[0] + 0.24, z=0.29, pitch=-0.2):
        for cell in cells:
            rest = d.cushion(cell.to(x=(-0.1, 0.08), z=(0.0, top - 0.28)), cover, 0.055, 0.1)
            _buttons(d, rest.inset(front=0.002), cover, 2, 2)
    for k, cell in enumerate(cells[:2]):
        d.surface(f"seat-{k}", cell.inset(back=0.14, front=0.06, y=0.06))
    with d.mirror("y"), d.part("arm"):
        side = d.bounds.left(arm).inset(back=0.08, front=0.01)
        if wooden:
            legs(d, side.to(z=(0.0, 0.6)).inset(back=0.03, front=0.02, y=0.005), wood, "square", 0.06)
            d.box(side.to(z=(0.6, 0.63)), wood, bevel=0.008)
            rail = d.box(side.to(z=(0.12, 0.18)).inset(x=0.07, y=0.02), wood)
            with d.along((rail.x[0] + 0.08, rail.center[1], 0.18), (rail.x[1] - 0.08, rail.center[1], 0.18), 5):
                d.box(Box.sized(0.036, 0.022, 0.42), wood, bevel=0.004)
        else:
            d.cushion(side.to(z=(0.06, 0.62)), cover, 0.05)
            legs(d, side.bottom(0.07).inset(x=0.06, y=0.03), wood, width=0.05)
    throw_pillow(d, "pillow", cover, room.x[0] + 0.4, room.y[1] - 0.26, seat)
    d.fit()


@draws("recliner", "theater_seat", whole=True)
def recliner(d: Drawing) -> None:
    """A thickly padded chair that leans back, its foot rest raised; or up to three of a cinema with cup holders."""
    cinema = d.category.name == "theater_seat"
    colors = ("red", "charcoal", "navy") if cinema else ("grey", "beige", "green")
    cover = d.material("cover", "black leather, brown leather, tan leather", *(f"{color} fabric" for color in colors))
    body, arm, top, glow = d.bounds.inset(back=0.15), 0.2, d.size.height, cinema and d.chance("glow", 0.6)
    count, lean, legroom = 1, 0.42, d.size.depth - 0.98
    if cinema:
        count, lean, legroom = max(1, min(3, round((body.width - arm) / 0.7))), 0.26, 0.0
    body = body.inset(front=legroom)
    seats = body.inset(y=arm).columns(count, gap=arm)
    for cell in seats:
        with d.part("seat"):
            d.box(cell.bottom(0.07).inset(x=0.1, y=-0.03), "black plastic")
            d.cushion(cell.to(z=(0.06, 0.34)).inset(front=0.03), cover, 0.03)
            with d.at(cell.x[1] - 0.26, z=0.38, pitch=-0.06):
                d.cushion(Box((-0.34, 0.25), cell.inset(y=0.002).y, (-0.08, 0.09)), cover, 0.07, 0.15)
            if cinema:
                d.cushion(cell.front(0.09).to(z=(0.12, 0.4)).inset(y=0.01), cover, 0.044)
        with d.part("back"), d.at(body.x[0] + 0.2, z=0.34, pitch=-lean):
            rest = Box((-0.08, 0.1), cell.y, (0.06, (top - 0.34) / math.cos(lean) - 0.05))
            d.cushion(rest.inset(y=-0.05, top=0.02, bottom=-0.06).to(x=(-0.17, -0.04)), cover, 0.05)
            for row, part in enumerate(rest.rows([4, 4, 5])):
                d.cushion(part.inset(y=-0.04 * (row == 2), top=-0.012, front=0.01 * row), cover, 0.07)
    for k in range(count + 1):
        y = body.y[0] + k * (body.width - arm) / count
        side = body.to(y=(y, y + arm))
        with d.part(f"arm {k}"):
            d.cushion(side.to(z=(0.04, 0.54)).inset(front=0.03, y=0.012), cover, 0.05)
            rest = d.cushion(side.to(z=(0.48, 0.63)).inset(back=-0.02), cover, 0.07)
            if cinema:
                holder = rest.top(0.03).inset(top=-0.008).place(0.1, 0.1, at="front").move(x=-0.12)
                d.turned(holder, [(1.0, 0.0), (1.0, 0.87), (0.92, 1.0)], "brushed steel", 20)
                d.print(holder.top(0.0).inset(x=0.01, y=0.01), "black plastic", oval=True)
            elif k == 0 and d.chance("lever", 0.7):
                start, end = side.point(0.7, 0.0, 0.3 / top), side.point(0.85, 0.0, 0.36 / top)
                d.bar(start, end, 0.011, d.material("lever", "walnut, black plastic, chrome"), segments=8)
            if glow:
                d.box(side.to(z=(0.045, 0.055)).inset(back=0.14, front=0.2, y=0.008), "lamp glow", bevel=0.0)
    if not cinema:
        with d.part("foot rest"):
            with d.at(body.x[1] + 0.02, z=0.36, pitch=-0.12):
                d.cushion(Box((0.0, legroom - 0.01), seats[0].inset(y=0.01).y, (-0.03, 0.1)), cover, 0.06, 0.1)
            with d.mirror("y"):
                y, x = seats[0].y[1] - 0.06, body.x[1]
                d.bar((x - 0.06, y, 0.22), (x + 0.14, y, 0.37), 0.013, "black steel", segments=6)


@draws("chaise_longue", whole=True)
def chaise_longue(d: Drawing) -> None:
    """A long seat with a raised back at its head and, in some, an arm along one side."""
    cover = d.material("cover", *COVERS)
    foot, seat, lean = d.uniform("legs", 0.12, 0.18), 0.42, 0.3
    style = d.pick("leg style", ["tapered", "metal", "turned"])
    wood = d.material("legs", "oak", "walnut", "black steel", "brass")
    box = d.bounds
    with d.part("base"):
        stand = box.bottom(foot + 0.01).inset(x=0.05, y=0.02)
        if style == "turned":
            legs(d, stand.inset(x=0.04, y=0.02), wood, "turned", 0.06)
        else:
            legs(d, stand, wood, "splayed", 0.02 if style == "metal" else 0.044, 0.03)
        d.cushion(box.to(z=(foot, 0.28)).inset(back=0.06, front=0.02, y=0.01), cover, 0.025)
        mattress = box.to(z=(0.27, seat)).inset(back=0.2)
        piping(d, d.cushion(mattress, cover, 0.05), cover, 0.05)
    with d.part("back"):
        with d.at(box.x[0] + 0.29, z=0.24, pitch=-lean):
            rest = Box((-0.09, 0.07), box.y, (0.0, (box.height - 0.24) / math.cos(lean) - 0.02))
            d.cushion(rest, cover, 0.06, 0.1)
            if d.chance("buttons", 0.6):
                _buttons(d, rest.inset(bottom=0.2, front=0.002), cover, 4, 2)
        if d.chance("roll", 0.75):
            roll = Box.around((box.x[0] + 0.39, 0.0, seat + 0.075), 0.16, box.width - 0.1, 0.16)
            cloth = d.material("roll", "@fabric", "tan leather")
            d.cylinder(roll, cloth, "y", segments=24, bevel=0.025)
            for end in (roll.left(-0.005), roll.right(-0.005)):
                d.cylinder(end.place(depth=0.03, height=0.03), cloth, "y", segments=12)
    arm = d.chance("arm", 0.5)
    if arm:
        with d.part("arm"):
            d.cushion(box.share(x=(0.0, 0.6)).inset(back=0.2).to(z=(0.3, 0.62)).left(0.09), cover, 0.04)
    d.surface("seat", mattress.inset(back=0.32, front=0.06, right=0.06, left=0.12 if arm else 0.1))


@draws("booth_seat", whole=True)
def booth_seat(d: Drawing) -> None:
    """A diner's bench: plinth, thick seat, a high back in upright channels."""
    colors = ("red fabric", "brown leather", "black leather", "green fabric", "navy fabric", "tan leather")
    cover = d.material("cover", *colors)
    panel = d.material("panel", "walnut", "oak", "black paint", "white paint")
    box, seat, top = d.bounds, 0.46, d.size.height
    with d.part("seat"):
        d.box(box.bottom(0.08).inset(back=0.02, front=0.08, y=0.03), "black paint")
        d.box(box.to(z=(0.08, 0.34)).inset(front=0.04), panel)
        cushion = d.cushion(box.to(z=(0.33, seat)).inset(back=0.1, y=0.005), cover, 0.045)
    with d.part("back"):
        d.box(box.back(0.05).to(z=(0.34, top - 0.02)), panel)
        count = max(4, round(box.width / d.pick("channel", [0.14, 0.2, 0.28])))
        with d.at(box.x[0] + 0.11, z=seat - 0.03, pitch=-0.07):
            channels = Box((-0.07, 0.06), cushion.y, (0.0, top - seat - 0.05))
            cushions(d, channels, count, cover, 0.05, gap=0.0)
        d.box(box.back(0.09).top(0.06), panel, bevel=0.01)
    d.surface("seat", cushion.inset(back=0.11, front=0.055, y=0.055))
