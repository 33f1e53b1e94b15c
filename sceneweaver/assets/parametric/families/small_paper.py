"""Books, paper, and what lies on a desk."""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws

COVERS = (
    "red fabric, navy fabric, green fabric, mustard fabric, charcoal fabric, rust fabric, rose fabric, "
    "white paint, teal paint, blue paint, black paint, cream paint, sage paint"
)
GLOSSY = "white paint, cream paint, red paint, teal paint, sage paint, yellow paint, navy paint, black paint"
TONES = ("ochre", "terracotta", "sand", "blush", "sky", "sea", "night", "moss", "plum", "chalk")
PRINTS = tuple(f"{tone} pigment" for tone in TONES)
PENS = tuple(f"{name} plastic" for name in ["yellow", "red", "blue", "green", "black", "orange", "white"])
_LOOSE = 3
"""Of a row or a pile of many things, so many can be taken one by one."""

INKS = ("brass", "chalk pigment", "ink pigment", "ochre pigment")


def ruled(d: Drawing, page: Box, lines: int, ink: Look = "grey paint", head: bool = True) -> None:
    """Lines of print on a sheet that lies, its head at -x; each fourth line is short."""
    if head:
        d.print(page.share(x=(0.08, 0.13), y=(0.1, 0.6)), "ink pigment")
    for k, line in enumerate(page.share(x=(0.2, 0.92)).split("x", lines)):
        d.print(line.share(x=(0.0, 0.2), y=(0.1, 0.9 if k % 4 != 3 else 0.6)), ink)


def pencil(d: Drawing, long: float, r: float, look: Look) -> None:
    """A pencil up along z: rubber, shaft, point."""
    parts = ((0.0, 0.06, 1, 1, "pink plastic"), (0.06, 0.88, 1, 1, look), (0.88, 0.97, 1, 0.3, "beech"))
    for low, top, a, b, tone in (*parts, (0.97, 1.0, 0.3, 0.08, "ink pigment")):
        d.revolve([(a * r, low * long), (b * r, top * long)], tone, 6)


def lying_book(d: Drawing, box: Box, cover: Look, ink: Look, hard: bool = True) -> None:
    """A closed book that fills a box: its head at -x, its spine at -y, the title on top."""
    board, lip = (min(0.0025, 0.18 * box.height), 0.003) if hard else (0.0006, 0.0)
    boards = box.inset(right=0.004)
    d.box(boards.inset(x=lip, left=lip, right=0.002, z=board), "paper", 0.0)
    for side in (boards.bottom(board), boards.top(board)):
        d.box(side, cover, 0.0005)
    d.silhouette(box.right(0.007), [(1, 0), (0.57, 0), (0, 0.25), (0, 0.75), (0.57, 1), (1, 1)], cover, "x")
    for x, y in (((0.14, 0.26), (0.2, 0.84)), ((0.3, 0.33), (0.32, 0.72)), ((0.83, 0.85), (0.38, 0.66))):
        d.print(box.top(0.0).share(x, y), ink)
    for x in ((0.14, 0.45), (0.8, 0.86)):
        d.print(box.right(0.0).share(x=x, z=(0.35, 0.65)), ink)


def standing_book(d: Drawing, box: Box, cover: Look, name: object) -> None:
    """An upright book that fills a box, its spine to the front."""
    ink = d.pick(f"ink {name}", INKS)
    d.box(box.inset(x=0.003, y=0.002, z=0.003), "paper", 0.0)
    for side in (box.left(0.0022), box.right(0.0022)):
        d.box(side.inset(front=0.002), cover, 0.0004)
    spine = d.box(box.front(0.004), cover, 0.0015).front(0.0)
    d.print(spine.share(y=(0.3, 0.7), z=(d.uniform(f"title {name}", 0.3, 0.45), 0.88)), ink)
    for z in (0.1, 0.14):
        d.print(spine.inset(y=0.002).share(z=(z, z + 0.012)), ink)


@draws("standing_books", whole=True)
def standing_books(d: Drawing) -> None:
    """Upright books of many sizes in a row, their backs to the front, the last one leaning in some."""
    room = d.bounds
    covers = COVERS.split(", ")
    first, lean = d.material("body", COVERS), d.chance("lean", 0.5)
    y, end, k = room.y[0], room.y[1] - (0.07 if lean else 0.0), 0
    books: list[Box] = []
    while end - y > 0.008:
        thick = min(d.uniform(f"t{k}", 0.014, 0.042), end - y)
        thick = end - y if end - y - thick < 0.012 else thick
        tall, deep = (1.0, 1.0) if k == 1 else (d.uniform(f"h{k}", 0.76, 0.99), d.uniform(f"d{k}", 0.82, 0.99))
        own = room.share(x=(1 - deep, 1), z=(0, tall)).inset(front=0.006 * d.uniform(f"x{k}", 0, 1))
        books.append(own.to(y=(y, y + thick)))
        y, k = y + thick, k + 1
    held = max(2, len(books) - _LOOSE)
    for k, own in enumerate(books):
        with d.item(f"book-{k}", "book") if k >= held else nullcontext(), d.convex():
            standing_book(d, own, first if k == 0 else d.pick(f"c{k}", covers), k)
    if lean:
        thick, tall = 0.02, 0.86 * room.height
        reach, angle = 0.0695, 0.2
        for _ in range(20):  # it touches the side of the last one, or its upper edge
            angle = math.atan2(reach - thick * math.cos(angle), min(books[-1].height, tall * math.cos(angle)))
        with (
            d.item("leaning-book", "book"),
            d.convex(),
            d.at(0.0, room.y[1] - 0.0005 - thick * math.cos(angle), 0.0, roll=angle),
        ):
            standing_book(d, Box(room.inset(x=0.01).x, (0.0, thick), (0.0, tall)), d.pick("leaning", covers), 99)


@draws("book", "book_stack", whole=True)
def book(d: Drawing) -> None:
    """A closed book, or lying ones on each other, turned a little; the lowest is the largest."""
    count = max(2, round(d.size.height / 0.03)) if d.category.name == "book_stack" else 1
    for k, level in enumerate(d.bounds.rows([d.uniform(f"t{k}", 0.6, 1.3) for k in range(count)])):
        size = d.uniform(f"s{k}", 0.74, 0.95) if k else 1.0
        turn = (d.uniform(f"a{k}", -0.16, 0.16) if k else 0.0) + (math.pi if d.chance(f"flip{k}", 0.4) else 0.0)
        cover = d.pick(f"c{k}", COVERS.split(", ")) if k else d.material("cover", COVERS)
        ink = d.pick(f"i{k}", INKS[:3]) if k else d.material("ink", *INKS[:3])
        with d.item(f"book-{k}", "book") if k else nullcontext(), d.convex(), d.at(yaw=turn if count > 1 else 0.0):
            lying_book(d, level.place(size * level.depth, size * level.width), cover, ink, d.chance(f"hard{k}", 0.7))


@draws("open_book", whole=True)
def open_book(d: Drawing) -> None:
    """A book that lies open: two swelling blocks of printed pages on its cover, a ribbon between."""
    high = d.size.height
    d.box(d.bounds.bottom(0.003), d.material("cover", COVERS), 0.0005)
    block = d.bounds.inset(x=0.004, left=0.006, bottom=0.003).share(y=(0.503, 1.0))
    curve = [(0.0, 0.5), (0.12, 0.91), (0.4, 1.0), (0.74, 0.84), (0.98, 0.5)]
    slopes = [((0.12, 0.91), (0.4, 1.0)), ((0.4, 1.0), (0.74, 0.84))]  # of a page, where there is print

    def strip(place: Box, low: tuple[float, float], top: tuple[float, float], proud: float, ink: Look) -> None:
        ends = [place.point(0.0, *low), place.point(0.0, *top)]
        corners = [(x, y, z + e) for x in place.x for _, y, z in ends for e in (-0.0006, proud)]
        d.add(shapes.hull(np.array(corners)), ink, [])

    with d.mirror("y"):
        d.silhouette(block, [(0, 0), (1, 0), *curve[::-1]], "paper", "x")
        for line in block.share(x=(0.08, 0.92)).split("x", 11):
            for low, top in slopes:
                strip(line.share(x=(0.0, 0.16)), low, top, 0.0003, "grey paint")
    if d.chance("picture", 0.5):
        photo = d.pick("photo", PRINTS)
        for low, top in slopes:
            strip(block.share(x=(0.08, 0.38)), low, top, 0.0004, photo)
    ribbon = d.bounds.share(x=(0.2, 1.0), z=(0.5, 0.5)).place(width=0.006)
    d.box(ribbon.inset(z=-0.06 * high), d.pick("ribbon", ["red fabric", "navy fabric"]), 0.0)


@draws("magazine", "magazine_stack", whole=True)
def magazine(d: Drawing) -> None:
    """A thin magazine with a title, a picture with a sun and headlines on its cover; or a loose pile."""
    count = max(3, round(d.size.height / 0.006)) if d.category.name == "magazine_stack" else 1
    for k, level in enumerate(d.bounds.rows(count)):
        look = d.pick(f"c{k}", GLOSSY.split(", ")) if k else d.material("cover", GLOSSY)
        x, y, turn = (d.uniform(f"{name}{k}", -1, 1) if k else 0.0 for name in "xya")
        loose = d.item(f"magazine-{k}", "magazine") if 0 < k >= count - _LOOSE else nullcontext()
        with loose, d.at(0.006 * x, 0.006 * y, yaw=0.07 * turn):
            page = d.box(level, look, 0.0004).top(0.0)
            with d.no_colliders():  # the edges of its pages
                d.box(level.inset(x=-0.0001, right=0.002, left=-0.0001).share(z=(0.2, 0.8)), "paper", 0.0)
            if k < count - 1:
                continue
            inks = [d.pick(f"print {i}", PRINTS) for i in range(3)]
            d.print(page.share(x=(0.04, 0.17), y=(0.1, 0.9)), inks[0])
            photo = d.print(page.share(x=(0.24, 0.8), y=(0.1, 0.7)), inks[1])
            d.print(photo.place(0.34 * page.width, 0.34 * page.width), inks[2], 0.0004, oval=True)
            for line in page.share(x=(0.3, 0.7), y=(0.75, 0.92)).split("x", 4):
                d.print(line.share(x=(0.0, 0.3)), inks[0])


@draws("newspaper", whole=True)
def newspaper(d: Drawing) -> None:
    """A folded newspaper with a headline, a picture and columns."""
    look = d.material("body", "paper")
    for k, layer in enumerate(d.bounds.rows(3)):
        d.slab(layer.inset(back=0.002 * k, left=0.004 * k), look, 0.004, 0.0015)
    page = d.bounds.top(0.0)
    for x, y, ink in (((0.06, 0.16), (0.1, 0.88), "ink pigment"), ((0.18, 0.19), (0.08, 0.92), "grey paint")):
        d.print(page.share(x, y), ink)
    d.print(page.share((0.24, 0.48), (0.1, 0.56)), d.pick("photo", ["night pigment", "sea pigment"]))
    for c, column in enumerate(page.share((0.24, 0.93), (0.1, 0.91)).columns(3, gap=0.04 * page.width)):
        for line in column.split("x", 10)[5 if c < 2 else 0 :]:
            d.print(line.share(x=(0.0, 0.3)), "light grey paint")


@draws("notebook", whole=True)
def notebook(d: Drawing) -> None:
    """A notebook with a wire spine or an elastic band, in some a pencil on it."""
    cover = d.material("cover", COVERS, "black leather, cardboard")
    high = d.size.height
    thick = 0.7 * high if d.chance("pencil", 0.6) else high - 0.001
    wired = d.chance("wired", 0.5)
    own = d.bounds.bottom(thick).inset(right=0.008 if wired else 0.0)
    for board in (own.bottom(0.0015), own.top(0.0015)):
        d.slab(board, cover, 0.006, 0.0003)
    d.slab(own.inset(x=0.002, left=0.002, right=0.001, z=0.0015), "paper", 0.005, 0.0)
    if wired:
        with d.along(d.bounds.point(0.06, 0.0, 0.0), d.bounds.point(0.94, 0.0, 0.0), 14):
            d.box(Box((-0.0012, 0.0012), (0.0, 0.014), (0.0, thick + 0.0008)), "steel", 0.001)
    else:
        d.box(own.share(y=(0.84, 0.87)).inset(bottom=0.0002, top=-0.001), "charcoal fabric", 0.0003)
        d.box(own.right(0.003).inset(x=0.001, z=0.0005), cover, 0.0005)
    d.print(own.top(0.0).share((0.2, 0.36), (0.3, 0.72)), "paper")
    if thick < 0.9 * high:
        r = (high - thick) / 2
        with d.at(*own.point(0.2, 0.3)[:2], thick + r, yaw=0.4, pitch=math.pi / 2):
            pencil(d, min(0.17, 0.7 * own.depth), r, d.pick("pencil colour", PENS[:4:3] + PENS[1:2]))


@draws("binder", "binder_row", whole=True)
def binder(d: Drawing) -> None:
    """Upright ring binders with labels and finger holes in their backs; alone or side by side."""
    pool = [f"{tone} plastic" for tone in ("black", "red", "blue", "green", "grey", "yellow")]
    main = d.material("cover", *pool)
    row = d.category.name == "binder_row"
    for k, cell in enumerate(d.bounds.columns(max(3, round(d.size.width / 0.075)) if row else 1)):
        own = cell.inset(y=0.0005) if row else cell
        cover = d.pick(f"c{k}", pool) if row and not d.chance(f"same{k}", 0.5) else main
        for side in (own.left(0.003), own.right(0.003)):
            d.box(side.inset(front=0.004), cover, 0.0005)
        d.box(own.inset(back=0.03, front=0.01, right=0.004, left=0.012, bottom=0.006, top=0.015), "paper", 0.0)
        back = d.box(own.front(0.006), cover, 0.0015).front(0.0)
        label = d.print(back.share(y=(0.16, 0.84), z=(0.42, 0.88)), "paper")
        d.print(label.share(y=(0.2, 0.8), z=(0.72, 0.82)), "ink pigment", 0.0004)
        d.print(label.share(y=(0.2, 0.68), z=(0.61, 0.65)), "grey paint", 0.0004)
        hole = back.share(z=(0.16, 0.16)).place(width=0.0)
        d.print(hole.inset(y=-0.014, z=-0.014), "steel", oval=True)
        d.print(hole.inset(y=-0.009, z=-0.009), "black plastic", 0.0004, oval=True)


@draws("document_tray", whole=True)
def document_tray(d: Drawing) -> None:
    """Two or three trays on each other with papers in them, open to the front."""
    look = d.material("body", "black plastic, grey plastic, black steel, oak, white plastic, clear plastic")
    trays = d.bounds.rows(2 if d.size.height < 0.16 else 3)
    for k, own in enumerate(trays):
        floor = d.box(own.bottom(0.004), look, 0.001)
        walls = floor.bottom(0.0).inset(top=-min(0.05, 0.7 * own.height)).inset(bottom=0.004)
        for wall in (*(w.share(x=(0.0, 0.8)) for w in (walls.left(0.004), walls.right(0.004))), walls.back(0.004)):
            d.box(wall, look, 0.0008)
        with d.mirror("y"):
            for x in (0.008, 0.78 * own.depth):
                d.box(own.left(0.008).back(x + 0.006).front(0.012), look, 0.001)
        with d.at(0.004, d.uniform(f"py{k}", -0.006, 0.006), yaw=d.uniform(f"pa{k}", -0.01, 0.01)):
            pile = floor.top(-d.uniform(f"pile{k}", 0.004, 0.022))
            sheets = d.box(pile.place(min(0.297, own.depth - 0.015), min(0.21, own.width - 0.03)), "paper", 0.0)
            if k == len(trays) - 1:
                ruled(d, sheets.top(0.0), 8)


@draws("paper_stack", whole=True)
def paper_stack(d: Drawing) -> None:
    """Sheets in a pile, the top one printed, slightly out of line."""
    d.material("body", "paper")
    levels = d.bounds.rows(max(1, min(6, round(d.size.height / 0.004))))
    for k, level in enumerate(levels):
        last = k == len(levels) - 1
        x, y = d.uniform(f"x{k}", -0.003, 0.003), d.uniform(f"y{k}", -0.003, 0.003)
        with d.at(x, y, yaw=d.uniform(f"a{k}", -0.03, 0.03) if k else 0.0):
            tint = not last and d.chance(f"tint{k}", 0.3)
            sheet = d.box(level.place(0.297, 0.21), d.pick(f"t{k}", PRINTS[2:5]) if tint else "paper", 0.0)
            if last:
                ruled(d, sheet.top(0.0), 12)


@draws("pen_holder", whole=True, even="round")
def pen_holder(d: Drawing) -> None:
    """A cup with pencils, pens, and a ruler."""
    box = d.even("round")
    look = d.material("body", "black steel, oak, white ceramic, concrete, red plastic, walnut, mint plastic")
    high, wide = box.height, box.width
    cup, r = box.share(x=(0.1, 0.9), y=(0.1, 0.9), z=(0.0, 0.55)), 0.4 * wide
    corner = None if d.chance("round", 0.6) else 0.12
    wall = 1 - 0.008 / r
    d.sections(
        cup, [(0.98, 0.98, 0), (1, 1, 1), (wall, wall, 1), (wall, wall, 0.1)], look, corner, hollow=2, holds=False
    )
    for k in range(7):
        a = 2 * math.pi * k / 7 + d.uniform("turn", 0, 1)
        long = (high - 0.006) if k == 0 else high * d.uniform(f"l{k}", 0.82, 1.0) - 0.008
        lean, tone = 0.8 * math.asin(min(0.5, 0.46 * wide / long)), d.pick(f"c{k}", PENS)
        with d.at(-0.5 * r * math.cos(a), -0.5 * r * math.sin(a), 0.006, yaw=a, pitch=lean):
            if k % 3 < 2:
                pencil(d, long, 0.0038, tone)
                continue
            d.revolve([(0.0045, 0.0), (0.0045, 0.7 * long)], tone, 8)
            d.revolve([(0.005, 0.7 * long), (0.0045, long)], "black plastic", 8)
            d.box(Box((0.004, 0.0065), (-0.0015, 0.0015), (0.72 * long, 0.97 * long)), "steel", 0.0)
    with d.at(0.0, 0.3 * r, 0.006, roll=-0.12):
        d.box(Box.sized(0.028, 0.002, 0.9 * high), "clear plastic" if d.chance("clear", 0.5) else "steel", 0.0003)


@draws("sticky_notes", whole=True)
def sticky_notes(d: Drawing) -> None:
    """Square pads of notes in bright colours on each other, the top one written on."""
    tones = "yellow plastic, pink plastic, mint plastic, sky pigment, orange plastic"
    main, start, high = d.material("body", tones), d.integer("start", 0, 4), d.size.height
    levels = d.bounds.rows(1 if high < 0.03 else 3 if high < 0.045 else 4)
    for k, level in enumerate(levels):
        with d.at(yaw=d.uniform(f"a{k}", -0.1, 0.1) if k else 0.0):
            pad = level.inset(x=0.003, y=0.003) if k else level
            d.box(pad, tones.split(", ")[(start + k) % 5] if k else main, 0.0)
            if k == len(levels) - 1:
                for j, line in enumerate(pad.top(0.0).share(x=(0.2, 0.88)).split("x", 4)):
                    d.print(line.share((0.0, 0.18), (0.14, 0.8 - 0.12 * (j % 3))), "ink pigment")


@draws("envelope_stack", whole=True)
def envelope_stack(d: Drawing) -> None:
    """Envelopes in a pile with address and stamp."""
    d.material("body", "paper")
    levels = d.bounds.rows(max(3, round(d.size.height / 0.0045)))
    tones = ["paper", "paper", "cardboard", "cream paint", "sky pigment"]
    for k, level in enumerate(levels):
        size = d.uniform(f"s{k}", 0.82, 0.95) if k else 1.0
        with d.at(yaw=d.uniform(f"a{k}", -0.12, 0.12) if k else 0.0):
            own = d.box(level.place(size * level.depth, size * level.width), d.pick(f"c{k}", tones), 0.0004).top(0.0)
    d.print(own.share((0.08, 0.3), (0.82, 0.94)), "red paint")
    for j in range(3):
        d.print(own.share((0.55 + 0.1 * j, 0.575 + 0.1 * j), (0.52, 0.8 - 0.05 * j)), "ink pigment")


@draws("calendar", whole=True)
def calendar(d: Drawing) -> None:
    """A tent calendar: a picture, a month of days, a wire at its ridge."""
    deep, wide, high = d.size
    stand = d.material("stand", "black paint, red paint, navy paint, cardboard, sage paint")
    lean, long = math.atan2(deep / 2, high - 0.006), math.hypot(deep / 2, high - 0.006)
    leaf = Box((-0.0024, 0.0), (-wide / 2, wide / 2), (0.0, long))
    for side in (-1, 1):
        with d.at(side * (deep / 2 - 0.0005), pitch=-side * lean):
            d.box(leaf if side > 0 else leaf.move(x=0.0024), stand, 0.0)
            if side < 0:
                continue
            page = d.print(leaf.front(0.0).share(y=(0.02, 0.98), z=(0.06, 0.95)), "paper")
            photo = d.print(page.share(y=(0.02, 0.48), z=(0.05, 0.95)), d.pick("photo", PRINTS), 0.0004)
            d.print(photo.share(z=(0.0, 0.38)), d.pick("land", PRINTS), 0.00045)
            d.print(page.share(y=(0.52, 0.8), z=(0.8, 0.92)), stand, 0.0004)
            for i, column in enumerate(page.share(y=(0.52, 0.98), z=(0.1, 0.7)).columns(7)):
                for cell in column.rows(5):
                    d.print(cell.share(y=(0.2, 0.8), z=(0.25, 0.75)), "red paint" if i == 6 else "grey paint", 0.0004)
    with d.along((0, -0.46 * wide, high - 0.012), (0, 0.46 * wide, high - 0.012), 15):
        d.box(Box.sized(0.01, 0.0024, 0.012), "steel", 0.002)


@draws("clipboard", whole=True)
def clipboard(d: Drawing) -> None:
    """A board with a clip and a printed form."""
    look = d.material("board", "oak, black plastic, clear plastic, cork, blue plastic, walnut")
    board = d.slab(d.bounds.bottom(0.0035), look, 0.012, 0.0008)
    form = d.box(board.top(-0.0017).place(min(0.285, board.depth - 0.03), 0.205).move(x=0.014), "paper", 0.0)
    ruled(d, form.top(0.0), 11)
    clip = d.slab(board.top(-0.0055).back(0.035).inset(back=0.006).place(width=0.12), "steel", 0.008, 0.002)
    level = d.bounds.z[1] - 0.005
    d.bar((clip.x[0] + 0.006, -0.05, level), (clip.x[0] + 0.006, 0.05, level), 0.005, "steel", 10)


@draws("calculator", whole=True)
def calculator(d: Drawing) -> None:
    """A slanted calculator with a display and keys."""
    deep, wide, high = d.size
    look = d.material("body", "black plastic, grey plastic, white plastic, mint plastic")
    keys = d.material("keys", "white plastic, grey plastic, black plastic")
    d.silhouette(d.bounds, [(1, 0), (0, 0), (0, 0.75), (0.02, 0.88), (1, 0.45)], look)
    tilt = math.atan2(0.43 * high, 0.98 * deep)
    slope = Box((-0.98 * deep / math.cos(tilt), 0.0), (-wide / 2, wide / 2), (0.0, 0.0))
    with d.at(deep / 2, 0.0, 0.45 * high, pitch=tilt):
        d.print(slope.share((0.03, 0.24), (0.08, 0.92)), "black plastic")
        d.print(slope.share((0.06, 0.21), (0.11, 0.89)), "mint plastic", 0.0004)
        for i, row in enumerate(slope.share((0.29, 0.95), (0.08, 0.92)).split("x", 5, gap=0.03 * deep)):
            for j, key in enumerate(row.columns(4, gap=0.04 * wide)):
                tone = "orange plastic" if (i, j) == (4, 3) else "grey plastic" if j == 3 else keys
                d.box(key.top(-0.12 * high).inset(bottom=-0.001), tone, 0.001)


@draws("scissors", whole=True)
def scissors(d: Drawing) -> None:
    """Scissors lying a little open, with bright grips."""
    deep, wide, high = d.size
    grip = d.material("grip", "red plastic, black plastic, orange plastic, blue plastic, green plastic")
    blade = [(-0.52, -0.01), (-0.05, -0.09), (0.05, -0.05), (0.18, 0.02), (0.16, 0.16), (0.03, 0.06), (-0.05, 0.06)]
    t = np.arange(14) * 2 * np.pi / 14
    for s in (-1, 1):
        plan = [(x * deep, s * y * wide) for x, y in blade][::s]
        low = 0.1 * high if s < 0 else 0.4 * high
        with d.at(yaw=s * 0.14):
            d.extrude(plan, (low, low + 0.4 * high), "steel")
        with d.at(0.3 * deep, s * 0.25 * wide, 0.5 * high, yaw=s * 0.3):
            d.sweep(np.c_[0.15 * deep * np.cos(t), 0.2 * wide * np.sin(t), 0 * t], (0.012, high), grip, closed=True)
    d.print(Box.sized(0.0084, 0.0084, 0.0, (0, 0, 0.8 * high)), "black plastic", oval=True)
