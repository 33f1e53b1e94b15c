"""Boards, screens and stands to show things on, and what guides people."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import castors, frame

_INKS = ("blue plastic", "red plastic", "black plastic", "green plastic")


def _board(d: Drawing, box: Box, sheet: Look, rim: Look, edge: float = 0.02) -> Box:
    """A framed panel that fills a box; returns the panel, 6 mm behind the front of the frame."""
    return d.box(frame(d, box, rim, edge).inset(y=-0.002, z=-0.002, front=0.006), sheet, 0.0)


def _tray(d: Drawing, box: Box, metal: Look, chalk: bool = False) -> None:
    """A ledge on a box's top with a lip, three pens or chalks and a wiper."""
    d.box(box, metal)
    d.box(box.front(0.007).top(-0.012).inset(bottom=-0.01), metal, 0.002)
    x, y, z = box.anchor("top")
    tones = ("white plastic", "yellow plastic", "pink plastic") if chalk else _INKS
    for k in range(3):
        pen = Box.around((x, y - 0.25 + 0.16 * k, z + 0.008), 0.016, 0.08 if chalk else 0.12, 0.016)
        d.cylinder(pen, tones[k], "y", segments=8)
    d.box(Box.sized(0.043, 0.12, 0.03, (x, y + 0.26, z)), "charcoal fabric" if chalk else "blue plastic")


def _writing(d: Drawing, face: Box, looks: tuple[str, ...]) -> None:
    """Lines of words and a little bar chart on the front of a box."""
    page, w = face.front(0.0), face.width
    for k in range(d.integer("lines", 3, 6)):
        line, y = page.inset(top=(0.14 + 0.11 * k) * face.height).top(0.012), page.y[1] - 0.08 * w
        for j in range(d.integer(f"words {k}", 2, 4)):
            long = w * d.uniform(f"word {k} {j}", 0.04, 0.1)
            d.print(line.to(y=(y - long, y)), looks[k % len(looks)])
            y -= long + 0.02
    for k in range(4):
        bar = page.share(y=(0.12 + 0.07 * k, 0.16 + 0.07 * k), z=(0.25, 0.25 + d.uniform(f"bar {k}", 0.12, 0.4)))
        d.print(bar, looks[(k + 1) % len(looks)])


@draws("whiteboard", "blackboard", whole=True)
def whiteboard(d: Drawing) -> None:
    """A white panel in a metal frame with a pen tray, or a slate in wood with a chalk ledge; most are written on."""
    slate = d.category.name == "blackboard"
    tones = "oak, beech, walnut, pine" if slate else "aluminium, grey plastic, white steel, light oak"
    rim = d.material("frame", tones)
    sheet: Look = d.material("slate", "forest pigment, ink pigment") if slate else "white plastic"
    box = d.bounds.inset(bottom=0.02).back(0.02)
    panel = _board(d, box, sheet, rim, 0.045 if slate else 0.02)
    ledge = Box((box.x[0] + 0.015, d.bounds.x[1]), box.y if slate else box.share(y=(0.2, 0.8)).y, (0.018, 0.032))
    _tray(d, ledge, rim, slate)
    if not slate:
        with d.mirror("y"):
            for z in (0.035, box.z[1] - 0.015):
                d.box(Box.around((box.x[0] + 0.012, box.y[1] - 0.02, z), 0.024, 0.036, 0.03), "grey plastic")
    if d.chance("written", 0.8):
        looks = ("chalk pigment", "chalk pigment", "yellow petal") if slate else _INKS[:3]
        _writing(d, panel.inset(y=0.08, bottom=0.08, top=0.03), looks)


@draws("notice_board", whole=True)
def notice_board(d: Drawing) -> None:
    """Cork or felt in a frame with pinned papers."""
    rim = d.material("frame", "light oak, aluminium, white paint, walnut")
    sheet = d.material("board", "cork, cork, blue fabric, green fabric")
    panel = _board(d, d.bounds.back(0.02), sheet, rim, 0.028)
    looks = ("paper", "yellow plastic", "pink plastic", "mint plastic", "sky pigment", "paper")
    columns = panel.inset(y=0.04, z=0.03).columns(max(2, int((panel.width - 0.1) / 0.24)))
    for k, row in enumerate(cell for column in columns for cell in column.rows(2)):
        if d.chance(f"no note {k}", 0.2):
            continue
        x, y, z = row.anchor("front")
        y, z = y + d.uniform(f"y {k}", -0.02, 0.02), z + d.uniform(f"z {k}", -0.02, 0.02)
        note = Box.around((x + 0.001, y, z), 0.0025, 2 * d.uniform(f"wide {k}", 0.05, 0.08), min(0.2, 0.8 * row.height))
        d.box(note, d.pick(f"note {k}", looks), 0.0)
        pin = Box.around((x + 0.006, y, note.z[1] - 0.015), 0.009, 0.014, 0.014)
        d.cylinder(pin, _INKS[k % 4], "x", segments=10)


@draws("mobile_whiteboard", whole=True)
def mobile_whiteboard(d: Drawing) -> None:
    """A whiteboard that turns between two uprights on castors."""
    metal = d.material("frame", "aluminium, white steel, black steel, grey paint")
    box, (deep, w, h) = d.bounds, d.size
    castors(d, box.bottom(0.075))
    with d.mirror("y"):
        y = w / 2 - 0.025
        d.box(Box.around((0.0, y, 0.09), deep - 0.04, 0.04, 0.04), metal, 0.006)
        d.box(Box.sized(0.04, 0.036, 0.66 * h - 0.09, (0.0, y, 0.09)), metal)
        d.bar((0.0, y - 0.031, 0.64 * h), (0.0, y + 0.025, 0.64 * h), 0.03, "black plastic", 16)
    low = h - min(1.25, h - 0.5)
    panel = _board(d, Box((-0.01, 0.01), (0.05 - w / 2, w / 2 - 0.05), (low, h)), "white plastic", metal)
    _tray(d, Box((0.008, 0.078), panel.share(y=(0.2, 0.8)).y, (low, low + 0.012)), metal)
    d.box(Box((-0.012, 0.012), panel.inset(y=-0.02).y, (0.2, 0.23)), metal)
    if d.chance("written", 0.7):
        _writing(d, panel.inset(y=0.08, bottom=0.08, top=0.03), _INKS[:3])


@draws("flip_chart", whole=True)
def flip_chart(d: Drawing) -> None:
    """A pad of paper on a board with three legs."""
    metal = d.material("legs", "aluminium, black steel, grey plastic")
    deep, w, h = d.size
    lean, low = math.atan2(0.42 * deep, h), h - 1.02
    with d.mirror("y"):
        d.bar((deep / 2 - 0.015, w / 2 - 0.02, 0.0), (-0.05 * deep, 0.3 * w, 0.9 * h), 0.014, metal, 8)
        d.box(Box.sized(0.03, 0.032, 0.04, (deep / 2 - 0.015, w / 2 - 0.02, 0.0)), "rubber")
    d.bar((0.015 - deep / 2, 0.0, 0.0), (-0.06 * deep, 0.0, 0.8 * h), 0.014, metal, 8)
    with d.at(deep / 2 - 0.02 - math.tan(lean) * low * 1.05, 0.0, low, pitch=-lean):
        board = d.box(Box((-0.02, 0.0), (-w / 2, w / 2), (0.0, 1.02 / math.cos(lean))), "white plastic")
        pad = d.box(board.front(-0.02).inset(y=0.03, bottom=0.1, top=0.03), "paper", 0.0)
        d.box(board.front(-0.035).inset(y=0.02).top(0.06).inset(top=0.02), metal, 0.006)
        d.box(board.front(-0.06).inset(y=0.02).bottom(0.02), metal)
        _writing(d, pad.inset(y=0.03, top=0.05, bottom=0.02), _INKS[:3])


@draws("projector_screen", whole=True)
def projector_screen(d: Drawing) -> None:
    """A long case with a white sheet with black borders let down from it."""
    case = d.material("case", "white steel, black steel, aluminium")
    box = d.bounds
    tube = d.box(box.top(box.depth), case, 0.25 * box.depth)
    for cap in (tube.left(0.03), tube.right(0.03)):
        d.box(cap.inset(x=-0.0005), "grey plastic", 0.2 * box.depth)
    sheet = d.box(box.inset(y=0.05, bottom=0.02, top=box.depth / 2).place(depth=0.006), "black plastic", 0.0)
    d.print(sheet.front(0.0).inset(y=0.05, bottom=0.05, top=0.12 + box.depth / 2), "white plastic")
    d.box(box.bottom(0.025).inset(y=0.05).place(depth=0.024), case)


@draws("projector", whole=True)
def projector(d: Drawing) -> None:
    """A projector under the ceiling on a pole, its lens to the front."""
    body = d.material("body", "white plastic, black plastic, grey plastic")
    box, h = d.bounds, d.size.height
    case = d.box(box.bottom(0.13).inset(front=0.015), body, 0.02)
    lens = Box.around(case.point(1.0, 0.72, 0.55), 0.03, 0.096, 0.096)
    d.cylinder(lens, "black plastic", "x", bevel=0.004)
    d.print(lens.front(0.0).inset(y=0.013, z=0.013), "screen", oval=True)
    for slot in case.front(0.0).share(y=(0.1, 0.45), z=(0.23, 0.78)).rows(6, gap=0.007):
        d.print(slot, "grey plastic")
    plate = d.box(case.top(-0.018).inset(bottom=-0.001).place(0.18, 0.18), "grey plastic")
    d.cylinder(Box.sized(0.044, 0.044, h - plate.z[1] - 0.02, plate.anchor("top")), "aluminium", segments=16)
    d.cylinder(Box.sized(0.16, 0.16, 0.025, (0.0, 0.0, h - 0.025)), "aluminium", ends=(0.88, 1.0))


@draws("partition", whole=True)
def partition(d: Drawing) -> None:
    """A felt screen in a thin frame on two flat feet, glazed above in some."""
    cloth, metal = d.material("cloth", "@fabric"), d.material("frame", "aluminium, black steel, white steel, light oak")
    box, h = d.bounds, d.size.height
    glazed = h > 1.5 and d.chance("glazed", 0.6)
    inner = frame(d, box.inset(bottom=0.06).place(depth=0.048), metal, 0.03)
    felt = inner.inset(x=0.004, y=-0.003, bottom=-0.003, top=0.37 if glazed else -0.003)
    d.box(felt, cloth)
    with d.mirror("y"):
        y = box.y[1] - 0.1
        d.box(Box.sized(box.depth, 0.06, 0.02, (0.0, y, 0.0)), metal)
        d.box(Box.sized(0.03, 0.04, 0.07, (0.0, y, 0.015)), metal, 0.002)
    if glazed:
        d.box(felt.top(-0.02).inset(x=-0.002, y=0.003), metal)
        d.box(inner.inset(bottom=felt.z[1] - inner.z[0]).place(depth=0.008), "frosted glass", 0.0)
        return
    for seam in felt.rows(d.integer("seams", 2, 4))[1:]:
        for side in (seam.front(0.0), seam.back(0.0)):
            d.print(side.bottom(0.004), metal)


@draws("stanchion", whole=True)
def stanchion(d: Drawing) -> None:
    """Two posts with a belt or a velvet rope between them."""
    rope = d.chance("rope", 0.5)
    metal = d.material("posts", "brass" if rope else "black steel", "chrome")
    band = d.material("band", "red fabric, navy fabric, black fabric")
    _, w, h = d.size
    r = d.size.depth / 2
    profile = [(r, 0.0), (r, 0.012), (0.6 * r, 0.035), (0.03, 0.06), (0.024, 0.08), (0.024, h - 0.08)]
    for name, s in (("left", 1), ("right", -1)):
        with d.part(f"post {name}"), d.at(0.0, s * (w / 2 - r)):
            d.revolve([*profile, (0.036, h - 0.07), (0.036, h - 0.02), (0.018, h)], metal)
    end = w / 2 - r - 0.03
    with d.part("band"):
        if rope:
            sag = [(k / 4, -0.22 * (1 - (k / 4) ** 2)) for k in range(-4, 5)]
            d.sweep([(0.0, s * end, h - 0.07 + z) for s, z in sag], 0.018, band)
        else:
            d.box(Box((-0.0015, 0.0015), (-end, end), (h - 0.07, h - 0.022)), band, 0.0)


@draws("kiosk", whole=True)
def kiosk(d: Drawing) -> None:
    """An information terminal: a tilted touch screen on a slim column, or an upright panel."""
    body = d.material("body", "white steel, black steel, grey paint, aluminium")
    accent = d.material("accent", "blue plastic, red plastic, teal paint, orange plastic")
    box, h = d.bounds, d.size.height
    d.box(box.bottom(0.03), body, 0.008)
    if h > 1.45:
        panel = d.box(Box((-0.07, 0.05), box.inset(y=0.01).y, (0.03, h)), body, 0.012)
        d.print(panel.front(0.0).inset(y=0.05).to(z=(0.1, 0.13)), accent)
        face = d.box(Box((0.04, 0.054), box.inset(y=0.04).y, (0.55, h - 0.06)), "screen", 0.002)
    else:
        column = d.box(Box((-0.09, 0.03), (-0.14, 0.14), (0.03, h - 0.2)), body, 0.02)
        d.print(column.front(0.0).place(width=0.1).to(z=(0.2, 0.55 * h)), accent)
    tilted = d.at() if h > 1.45 else d.at(-0.02, 0.0, h - 0.3, pitch=-0.75)
    with tilted:
        if h <= 1.45:
            d.box(Box((-0.05, 0.03), box.y, (-0.06, 0.36)), body, 0.012)
            face = d.box(Box((0.025, 0.034), box.inset(y=0.03).y, (-0.03, 0.33)), "screen", 0.002)
        rows = face.front(0.0).inset(y=0.04, z=0.04).rows(4 if h <= 1.45 else 6, gap=0.03)
        for k, row in enumerate(rows[0 if h <= 1.45 else 2 :]):
            d.print(row, (accent, "white plastic", "sky pigment")[k % 3])


@draws("lectern", whole=True)
def lectern(d: Drawing) -> None:
    """A speaker's desk with a sloping top and a microphone; the speaker stands behind."""
    wood = d.material("wood", "walnut, oak, mahogany, light oak, black paint")
    (deep, w, h), top = d.size, d.size.height - 0.2
    if d.chance("closed", 0.6):
        case = d.box(Box((-0.2 * deep, 0.4 * deep), (-0.4 * w, 0.4 * w), (0.05, top - 0.1)), wood, 0.006)
        d.box(case.bottom(0.06).inset(x=-0.07 * deep, y=-0.06 * w).move(z=-0.05), wood, 0.01)
        field = d.box(case.front(-0.012).inset(back=-0.002).share(y=(0.15, 0.85), z=(0.12, 0.88)), wood, 0.008)
        d.cylinder(field.front(-0.005).inset(back=-0.001).place(width=0.18, height=0.18), "brass", "x")
    else:
        d.box(Box((-0.36 * deep, 0.36 * deep), (-0.4 * w, 0.4 * w), (0.0, 0.045)), wood, 0.012)
        d.box(Box.sized(0.12, 0.16, top - 0.14, (0.0, 0.0, 0.04)), wood, 0.012)
    with d.at(0.0, 0.0, top - 0.02, pitch=-0.3):
        slope = d.box(Box((-deep / 2, deep / 2), (-w / 2, w / 2), (-0.09, 0.0)), wood, 0.008)
        d.box(slope.back(0.02).top(-0.025).inset(bottom=-0.02), wood)
        for page in slope.top(-0.003).share(x=(0.14, 0.7)).place(width=0.44).columns(2, gap=0.01):
            d.box(page, "paper", 0.0)
    z, x = top - 0.02 + 0.12 * deep, 0.2 * deep
    d.sweep([(0.38 * deep, 0.0, z - 0.03), (0.36 * deep, 0.0, z + 0.12), (x, 0.0, h - 0.015)], 0.005, "black steel", 6)
    d.bar((x, 0.0, h - 0.015), (0.08 * deep, 0.0, h - 0.012), 0.012, "black plastic")
