"""Books, paper, and what lies on a desk."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder, Interval
from .small_kit import Look, decal, rect, slab, small, spot, target
from .small_kit import loft as loft_rings

COVERS = (
    "red fabric",
    "navy fabric",
    "green fabric",
    "mustard fabric",
    "charcoal fabric",
    "rust fabric",
    "white paint",
    "teal paint",
    "blue paint",
    "black paint",
    "rose fabric",
    "cream paint",
    "sage paint",
)
PRINTS = (
    "ochre pigment",
    "terracotta pigment",
    "sand pigment",
    "blush pigment",
    "sky pigment",
    "sea pigment",
    "night pigment",
    "moss pigment",
    "plum pigment",
    "chalk pigment",
)


def closed_book(b: Builder, d: float, w: float, t: float, cover: Look, ink: Look, hard: bool = True) -> None:
    """A closed book that lies centred on the plane: its head at -x, its spine at -y, the title on top."""
    board = min(0.0025, 0.18 * t) if hard else 0.0006
    lip = 0.003 if hard else 0.0
    y0 = -w / 2 + 0.004
    b.box((-d / 2 + lip, d / 2 - lip), (y0 + 0.002, w / 2 - lip), (board, t - board), "paper", 0.0)
    b.box((-d / 2, d / 2), (y0, w / 2), (0.0, board), cover, 0.0005)
    b.box((-d / 2, d / 2), (y0, w / 2), (t - board, t), cover, 0.0005)
    b.hull(
        [
            (x, y, z)
            for x in (-d / 2, d / 2)
            for y, z in ((y0 + 0.003, 0.0), (y0, 0.0), (-w / 2, 0.25 * t), (-w / 2, 0.75 * t), (y0, t), (y0 + 0.003, t))
        ],
        cover,
    )
    decal(b, (-0.36 * d, -0.24 * d), (-0.3 * w, 0.34 * w), (t - board, t + 0.0003), ink)
    decal(b, (-0.2 * d, -0.17 * d), (-0.18 * w, 0.22 * w), (t - board, t + 0.0003), ink)
    decal(b, (0.33 * d, 0.35 * d), (-0.12 * w, 0.16 * w), (t - board, t + 0.0003), ink)
    for lo, hi in ((-0.36, -0.05), (0.3, 0.36)):
        decal(b, (lo * d, hi * d), (-w / 2 - 0.0003, -w / 2 + 0.001), (0.35 * t, 0.65 * t), ink)


def leaves(b: Builder, d: float, w: float, z: Interval, look: Look = "paper") -> None:
    """Sheets in a pile."""
    b.box((-d / 2, d / 2), (-w / 2, w / 2), z, look, 0.0)


def printed(
    b: Builder, d: float, w: float, z: float, ink: Look = "grey paint", lines: int = 8, head: bool = True
) -> None:
    """Lines of print on a sheet that lies at z, its head at -x."""
    if head:
        decal(b, (-0.42 * d, -0.37 * d), (-0.4 * w, 0.1 * w), (z - 0.0005, z + 0.0003), "ink pigment")
    for k in range(lines):
        x = -0.3 * d + k * 0.72 * d / lines
        decal(b, (x, x + 0.012 * d), (-0.4 * w, (0.4 if k % 4 != 3 else 0.1) * w), (z - 0.0005, z + 0.0003), ink)


@small("book")
def book(b: Builder) -> None:
    """A closed book: boards, spine, page block, title."""
    d, w, h = b.size
    closed_book(
        b,
        d,
        w,
        h,
        b.material("cover", *COVERS),
        b.material("ink", "brass", "chalk pigment", "ink pigment"),
        b.chance("hard", 0.7),
    )


@small("standing_books")
def standing_books(b: Builder) -> None:
    """Upright books of many sizes in a row, their backs to the front, the last one leaning in some."""
    d, w, h = b.size
    first = b.material("body", *COVERS)
    y, k = -w / 2, 0
    lean = b.chance("lean", 0.5)
    end = w / 2 - (0.07 if lean else 0.0)
    while end - y > 0.008:
        t = min(b.uniform(f"t{k}", 0.014, 0.042), end - y)
        if end - y - t < 0.012:
            t = end - y
        tall = h if k == 1 else h * b.uniform(f"h{k}", 0.76, 0.99)
        deep = d if k == 1 else d * b.uniform(f"d{k}", 0.82, 0.99)
        _upright(
            b,
            d / 2 - deep,
            d / 2 - 0.006 * b.uniform(f"x{k}", 0, 1),
            y,
            t,
            tall,
            first if k == 0 else b.pick(f"c{k}", COVERS),
            k,
        )
        y += t
        k += 1
    if lean:
        t, tall = 0.02, 0.86 * h
        a = float(np.arcsin((0.07 - t) / tall)) * 0.92
        with b.frame(0, w / 2 - 0.001 - t * np.cos(a), 0, roll=a):
            _upright(b, -d / 2 + 0.01, d / 2 - 0.01, 0.0, t, tall, b.pick("leaning", COVERS), 99)


def _upright(b: Builder, x0: float, x1: float, y: float, t: float, tall: float, cover: Look, k: int) -> None:
    ink = b.pick(f"ink {k}", ["brass", "chalk pigment", "ink pigment", "ochre pigment"])
    b.box((x0 + 0.003, x1 - 0.003), (y + 0.002, y + t - 0.002), (0.003, tall - 0.003), "paper", 0.0)
    for ys in ((y, y + 0.0022), (y + t - 0.0022, y + t)):
        b.box((x0, x1 - 0.002), ys, (0.0, tall), cover, 0.0004)
    b.box((x1 - 0.004, x1), (y, y + t), (0.0, tall), cover, 0.0015)
    lo = b.uniform(f"title {k}", 0.3, 0.45)
    decal(b, (x1 - 0.001, x1 + 0.0003), (y + 0.3 * t, y + 0.7 * t), (lo * tall, 0.88 * tall), ink)
    for z in (0.1, 0.14):
        decal(b, (x1 - 0.001, x1 + 0.0003), (y + 0.002, y + t - 0.002), (z * tall, (z + 0.012) * tall), ink)


@small("book_stack")
def book_stack(b: Builder) -> None:
    """Lying books on each other, turned a little; the lowest is the largest."""
    d, w, h = b.size
    count = max(2, round(h / 0.03))
    shares = [b.uniform(f"t{k}", 0.6, 1.3) for k in range(count)]
    z = 0.0
    for k, share in enumerate(shares):
        t = h * share / sum(shares)
        s = 1.0 if k == 0 else b.uniform(f"s{k}", 0.74, 0.95)
        turn = 0.0 if k == 0 else b.uniform(f"a{k}", -0.16, 0.16)
        cover = b.material("body", *COVERS) if k == 0 else b.pick(f"c{k}", COVERS)
        with b.frame(0, 0, z, yaw=turn + (np.pi if b.chance(f"flip{k}", 0.4) else 0.0)):
            closed_book(
                b,
                d * s,
                w * s,
                t,
                cover,
                b.pick(f"i{k}", ["brass", "chalk pigment", "ink pigment"]),
                b.chance(f"hard{k}", 0.7),
            )
        z += t


@small("open_book")
def open_book(b: Builder) -> None:
    """A book that lies open: two swelling blocks of printed pages on its cover, a ribbon between."""
    d, w, h = b.size
    cover = b.material("cover", *COVERS)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.003), cover, 0.0005)
    for s in (-1, 1):
        outline = [
            (0.0, 0.003),
            (w / 2 - 0.006, 0.003),
            (w / 2 - 0.01, 0.55 * h),
            (0.36 * w, 0.86 * h),
            (0.2 * w, h),
            (0.06 * w, 0.92 * h),
            (0.0, 0.55 * h),
        ]
        b.hull([(x, s * y, z) for y, z in outline for x in (-d / 2 + 0.004, d / 2 - 0.004)], "paper")
        # Print lies on the two upper slopes of the page.
        for (y0, z0), (y1, z1) in ((outline[5], outline[4]), (outline[4], outline[3])):
            for k in range(11):
                x = -0.4 * d + k * 0.075 * d
                if s > 0 and k < 4 and b.chance("picture", 0.5):
                    continue
                b.add(
                    shapes.hull(
                        np.array(
                            [
                                (x + e, s * (yy + 0.004 * (1 if yy == outline[5][0] else 0)), zz + f)
                                for e in (0.0, 0.012 * d)
                                for yy, zz in ((y0, z0), (y1, z1))
                                for f in (-0.0006, 0.0003)
                            ]
                        )
                    ),
                    "grey paint",
                    [],
                )
    b.box((-0.3 * d, d / 2), (-0.003, 0.003), (0.5 * h, 0.62 * h), b.pick("ribbon", ["red fabric", "navy fabric"]), 0.0)


def _cover_picture(b: Builder, d: float, w: float, z: float, k: str = "") -> None:
    ink = [b.pick(f"print {k}{i}", PRINTS) for i in range(3)]
    z0, z1 = z - 0.001, z + 0.0003
    decal(b, (-0.46 * d, -0.33 * d), (-0.4 * w, 0.4 * w), (z0, z1), ink[0])
    decal(b, (-0.26 * d, 0.3 * d), (-0.4 * w, 0.2 * w), (z0, z1), ink[1])
    with b.frame(0.02 * d, -0.1 * w, z):
        spot(b, 0.17 * w, (-0.001, 0.0004), ink[2], 20)
    for i in range(4):
        decal(b, ((-0.2 + 0.1 * i) * d, (-0.17 + 0.1 * i) * d), (0.25 * w, 0.42 * w), (z0, z1), ink[0])


@small("magazine")
def magazine(b: Builder) -> None:
    """A thin magazine with a picture and headlines on its cover."""
    d, w, h = b.size
    look = b.material(
        "cover", "white paint", "cream paint", "sage paint", "yellow paint", "red paint", "teal paint", "navy paint"
    )
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), look, 0.0004)
    _cover_picture(b, d, w, h)


@small("magazine_stack")
def magazine_stack(b: Builder) -> None:
    """Magazines in a loose pile."""
    d, w, h = b.size
    count = max(3, round(h / 0.006))
    t = h / count
    for k in range(count):
        name = (
            b.material("body", "white paint", "cream paint", "red paint", "teal paint")
            if k == 0
            else b.pick(
                f"c{k}",
                [
                    "white paint",
                    "cream paint",
                    "sage paint",
                    "yellow paint",
                    "red paint",
                    "teal paint",
                    "navy paint",
                    "black paint",
                ],
            )
        )
        with b.frame(
            b.uniform(f"x{k}", -0.006, 0.006),
            b.uniform(f"y{k}", -0.006, 0.006),
            k * t,
            yaw=b.uniform(f"a{k}", -0.07, 0.07),
        ):
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, t), name, 0.0004)
            b.add(
                shapes.box((-d / 2 - 0.0001, d / 2 + 0.0001), (-w / 2 + 0.002, w / 2 + 0.0001), (0.2 * t, 0.8 * t)),
                "paper",
                [],
            )
            if k == count - 1:
                _cover_picture(b, d, w, t)


@small("newspaper")
def newspaper(b: Builder) -> None:
    """A folded newspaper with a headline, a picture and columns."""
    d, w, h = b.size
    look = b.material("body", "paper")
    for k in range(3):
        e = 0.002 * k
        slab(b, (-d / 2 + e, d / 2), (-w / 2, w / 2 - 2 * e), (k * h / 3, (k + 1) * h / 3), look, 0.004, 0.0015)
    z = (h - 0.001, h + 0.0003)
    decal(b, (-0.44 * d, -0.34 * d), (-0.4 * w, 0.38 * w), z, "ink pigment")
    decal(b, (-0.32 * d, -0.31 * d), (-0.42 * w, 0.42 * w), z, "grey paint")
    decal(b, (-0.26 * d, -0.02 * d), (-0.4 * w, 0.06 * w), z, b.pick("photo", ["night pigment", "sea pigment"]))
    for c in range(3):
        for k in range(10):
            x = (-0.26 + 0.068 * k) * d
            if c < 2 and k < 5:
                continue
            decal(b, (x, x + 0.02 * d), ((-0.4 + 0.27 * c) * w, (-0.17 + 0.27 * c) * w), z, "light grey paint")


@small("notebook")
def notebook(b: Builder) -> None:
    """A notebook with a wire spine or an elastic band, in some a pencil on it."""
    d, w, h = b.size
    cover = b.material("cover", *COVERS, "black leather", "cardboard")
    t = 0.7 * h if b.chance("pencil", 0.6) else h - 0.001
    wired = b.chance("wired", 0.5)
    y0 = -w / 2 + (0.008 if wired else 0.0)
    slab(b, (-d / 2, d / 2), (y0, w / 2), (0.0, 0.0015), cover, 0.006, 0.0003)
    slab(b, (-d / 2 + 0.002, d / 2 - 0.002), (y0 + 0.001, w / 2 - 0.002), (0.0015, t - 0.0015), "paper", 0.005, 0.0)
    slab(b, (-d / 2, d / 2), (y0, w / 2), (t - 0.0015, t), cover, 0.006, 0.0003)
    if wired:
        n = 14
        for k in range(n):
            x = -0.44 * d + 0.88 * d * k / (n - 1)
            b.box((x - 0.0012, x + 0.0012), (-w / 2, -w / 2 + 0.014), (0.0, t + 0.0008), "steel", 0.001)
    else:
        b.box((-d / 2, d / 2), (0.34 * w, 0.37 * w), (0.0002, t + 0.001), "charcoal fabric", 0.0003)
        b.box((-d / 2 + 0.001, d / 2 - 0.001), (y0 - 0.0, y0 + 0.003), (0.0005, t - 0.0005), cover, 0.0005)
    decal(b, (-0.3 * d, -0.14 * d), (-0.2 * w, 0.22 * w), (t - 0.001, t + 0.0003), "paper")
    if t < 0.9 * h:
        r = (h - t) / 2
        with b.frame(-0.3 * d, -0.2 * w, t + r, yaw=0.4, pitch=np.pi / 2):
            pencil(
                b, min(0.17, 0.7 * d), r, b.pick("pencil colour", ["yellow plastic", "red plastic", "green plastic"])
            )


def pencil(b: Builder, long: float, r: float, look: Look) -> None:
    """A pencil up along z: rubber, shaft, point."""
    b.frustum(r, r, (0.0, 0.06 * long), "pink plastic", 6)
    b.frustum(r, r, (0.06 * long, 0.88 * long), look, 6)
    b.frustum(r, 0.3 * r, (0.88 * long, 0.97 * long), "beech", 6)
    b.frustum(0.3 * r, 0.08 * r, (0.97 * long, long), "ink pigment", 6)


def _binder(b: Builder, d: float, t: float, h: float, cover: Look) -> None:
    """An upright file with its back to the front, centred on y."""
    b.box((-d / 2, d / 2 - 0.004), (-t / 2, -t / 2 + 0.003), (0.0, h), cover, 0.0005)
    b.box((-d / 2, d / 2 - 0.004), (t / 2 - 0.003, t / 2), (0.0, h), cover, 0.0005)
    b.box((d / 2 - 0.006, d / 2), (-t / 2, t / 2), (0.0, h), cover, 0.0015)
    b.box((-d / 2 + 0.03, d / 2 - 0.01), (-t / 2 + 0.004, t / 2 - 0.012), (0.006, h - 0.015), "paper", 0.0)
    x = (d / 2 - 0.001, d / 2 + 0.0003)
    decal(b, x, (-0.34 * t, 0.34 * t), (0.42 * h, 0.88 * h), "paper")
    decal(b, (x[0], x[1] + 0.0001), (-0.2 * t, 0.2 * t), (0.75 * h, 0.8 * h), "ink pigment")
    decal(b, (x[0], x[1] + 0.0001), (-0.2 * t, 0.12 * t), (0.7 * h, 0.72 * h), "grey paint")
    with b.frame(d / 2, 0, 0.16 * h, pitch=np.pi / 2):
        b.add(shapes.frustum(0.014, 0.014, (-0.002, 0.0003), 16), "steel", [])
        b.add(shapes.frustum(0.009, 0.009, (-0.002, 0.0004), 16), "black plastic", [])


@small("binder")
def binder(b: Builder) -> None:
    """An upright ring binder with a label and a finger hole in its back."""
    d, w, h = b.size
    _binder(
        b,
        d,
        w,
        h,
        b.material(
            "cover", "black plastic", "red plastic", "blue plastic", "green plastic", "grey plastic", "yellow plastic"
        ),
    )


@small("binder_row")
def binder_row(b: Builder) -> None:
    """Upright ring binders side by side."""
    d, w, h = b.size
    count = max(3, round(w / 0.075))
    pool = ["black plastic", "red plastic", "blue plastic", "green plastic", "grey plastic", "white plastic"]
    main = b.material("cover", *pool)
    for k in range(count):
        with b.frame(0, -w / 2 + (k + 0.5) * w / count):
            cover = main if b.chance(f"same{k}", 0.5) else b.pick(f"c{k}", pool)
            _binder(b, d, w / count - 0.001, h, cover)


@small("document_tray")
def document_tray(b: Builder) -> None:
    """Two or three trays on each other with papers in them, open to the front."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "black steel", "oak", "white plastic", "clear plastic")
    count = 2 if h < 0.16 else 3
    gap = h / count
    for k in range(count):
        z = k * gap
        rim = 0.045 if k == count - 1 else 0.04
        rim = min(rim, gap * 0.7) if k < count - 1 else gap
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (z, z + 0.004), look, 0.001)
        for s in (-1, 1):
            y = s * (w / 2 - 0.002)
            b.box((-d / 2, 0.3 * d), (y - 0.002, y + 0.002), (z + 0.004, z + min(rim, 0.05)), look, 0.0008)
        b.box((-d / 2, -d / 2 + 0.004), (-w / 2, w / 2), (z + 0.004, z + min(rim, 0.05)), look, 0.0008)
        for px in (-d / 2 + 0.008, 0.28 * d):
            for s in (-1, 1):
                y = s * (w / 2 - 0.004)
                b.box((px - 0.006, px + 0.006), (y - 0.004, y + 0.004), (z, (k + 1) * gap), look, 0.001)
        pile = b.uniform(f"pile{k}", 0.004, 0.022)
        with b.frame(0.004, b.uniform(f"py{k}", -0.006, 0.006), z + 0.004, yaw=b.uniform(f"pa{k}", -0.01, 0.01)):
            leaves(b, min(0.297, d - 0.015), min(0.21, w - 0.03), (0.0, pile))
            if k == count - 1:
                printed(b, 0.29, 0.2, pile)


@small("paper_stack")
def paper_stack(b: Builder) -> None:
    """Sheets in a pile, the top one printed, slightly out of line."""
    _, _, h = b.size
    b.material("body", "paper")
    count = max(1, min(6, round(h / 0.004)))
    for k in range(count):
        last = k == count - 1
        turn = 0.0 if k == 0 else b.uniform(f"a{k}", -0.03, 0.03)
        with b.frame(b.uniform(f"x{k}", -0.003, 0.003), b.uniform(f"y{k}", -0.003, 0.003), k * h / count, yaw=turn):
            look = (
                "paper"
                if last or not b.chance(f"tint{k}", 0.3)
                else b.pick(f"t{k}", ["sky pigment", "sand pigment", "blush pigment"])
            )
            leaves(b, 0.297, 0.21, (0.0, h / count), look)
            if last:
                printed(b, 0.297, 0.21, h / count, lines=12)


@small("pen_holder", fit="round")
def pen_holder(b: Builder) -> None:
    """A cup with pencils, pens, and a ruler or scissors."""
    d, _, h = target(b)
    r = 0.4 * d
    look = b.material(
        "body",
        "black steel",
        "oak",
        "white ceramic",
        "grey ceramic",
        "concrete",
        "red plastic",
        "walnut",
        "mint plastic",
    )
    cup = 0.55 * h
    if b.chance("round", 0.6):
        b.lathe(
            [(r - 0.002, 0.0), (r, 0.002), (r, cup), (r - 0.004, cup), (r - 0.004, 0.006), (0.0, 0.005)],
            look,
            24,
            hollow=True,
        )
    else:
        loft_rings(
            b,
            [
                rect((-r + e, r - e), (-r + e, r - e), z, 0.008)
                for e, z in ((0.001, 0), (0, 0.002), (0, cup), (0.005, cup), (0.005, 0.006))
            ],
            look,
            hollow=2,
        )
    colors = [
        "yellow plastic",
        "red plastic",
        "blue plastic",
        "green plastic",
        "black plastic",
        "orange plastic",
        "white plastic",
    ]
    for k in range(7):
        a = 2 * np.pi * k / 7 + b.uniform("turn", 0, 1)
        long = h * b.uniform(f"l{k}", 0.82, 1.0) - 0.008
        if k == 0:
            long = h - 0.006
        out = np.arcsin(min(0.5, 0.42 * d * 1.1 / long)) * 0.8
        with b.frame(-0.5 * r * np.cos(a), -0.5 * r * np.sin(a), 0.006, yaw=a, pitch=out):
            if k % 3 == 2:
                b.frustum(0.0045, 0.0045, (0.0, 0.7 * long), b.pick(f"c{k}", colors), 8)
                b.frustum(0.005, 0.0045, (0.7 * long, long), "black plastic", 8)
                b.box((0.004, 0.0065), (-0.0015, 0.0015), (0.72 * long, 0.97 * long), "steel", 0.0)
            else:
                pencil(b, long, 0.0038, b.pick(f"c{k}", colors))
    with b.frame(0, 0.3 * r, 0.006, roll=-0.12):
        b.box(
            (-0.014, 0.014),
            (-0.001, 0.001),
            (0.0, 0.9 * h),
            "clear plastic" if b.chance("clear", 0.5) else "steel",
            0.0003,
        )


@small("pencil_case")
def pencil_case(b: Builder) -> None:
    """A soft pouch with a zip, pencils peeping out of its open end."""
    d, w, h = b.size
    cloth = b.material("cloth", "@fabric", "tan leather", "black leather")
    b.cushion((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h - 0.004), cloth, radius=0.03, puff=0.3)
    b.box((-0.004, 0.004), (-0.42 * w, 0.42 * w), (h - 0.012, h - 0.001), "steel", 0.002)
    b.box((-0.003, 0.003), (0.36 * w, 0.45 * w), (h - 0.005, h), b.pick("tab", ["red fabric", "black leather"]), 0.001)
    for s in (-1, 1):
        b.box(
            (-0.28 * d, 0.28 * d),
            (s * 0.47 * w - 0.003, s * 0.47 * w + 0.003),
            (0.3 * h, 0.7 * h),
            "charcoal fabric",
            0.001,
        )


@small("stapler")
def stapler(b: Builder) -> None:
    """A stapler: foot, anvil, arm that opens to the side at -y."""
    d, w, h = b.size
    look = b.material(
        "body", "black plastic", "red plastic", "blue plastic", "grey plastic", "mint plastic", "white plastic"
    )
    slab(b, (-0.42 * d, 0.42 * d), (-w / 2, w / 2), (0.0, 0.12 * h), "black plastic", 0.01, 0.002)
    b.box((-0.2 * d, 0.2 * d), (-0.46 * w, -0.38 * w), (0.12 * h, 0.17 * h), "steel", 0.0005)
    rise = 0.1
    with b.frame(0, 0.46 * w, 0.3 * h, roll=rise):
        b.box((-0.3 * d, 0.3 * d), (-0.92 * w, 0.0), (0.0, 0.2 * h), "steel", 0.001)
    arm = [
        (0.5, 0.1),
        (0.5, 0.6),
        (0.42, 0.78),
        (-0.2, 1.0),
        (-0.44, 0.98),
        (-0.49, 0.75),
        (-0.47, 0.62),
        (0.36, 0.42),
        (0.4, 0.1),
    ]
    lower, upper = [arm[1], arm[2], arm[3], arm[4], arm[5], arm[6], arm[7]], [arm[0], arm[1], arm[7], arm[8]]
    for part in (lower, upper):
        b.hull([(x * d, y * w, z * h) for y, z in part for x in (-0.5, 0.5)], look)


@small("tape_dispenser")
def tape_dispenser(b: Builder) -> None:
    """A heavy foot with a roll of tape and a toothed edge."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "red plastic", "white plastic", "mint plastic")
    r = 0.36 * h
    rings = [
        rect((-d / 2 + e, d / 2 - e), (-w / 2 + f, w / 2 - g), z, 0.006)
        for e, f, g, z in ((0, 0, 0, 0.0), (0, 0, 0, 0.2 * h), (0.1 * d, 0.02 * w, 0.06 * w, 0.5 * h))
    ]
    loft_rings(b, rings, look, convex=True)
    with b.frame(0, 0.14 * w, h - r - 0.001, roll=np.pi / 2):
        b.frustum(r, r, (-0.2 * d, 0.2 * d), "clear plastic", 24)
        b.add(shapes.frustum(0.96 * r, 0.96 * r, (-0.19 * d, 0.19 * d), 24), "sand pigment", [])
        b.frustum(0.55 * r, 0.55 * r, (-0.26 * d, 0.26 * d), look, 20)
        spot(b, 0.2 * r, (-0.265 * d + 0.0003, 0.26 * d + 0.0003), "black plastic")
    for s in (-1, 1):
        b.hull(
            [
                (s * x * d, y * w, z * h)
                for x in (0.3, 0.42)
                for y, z in ((-0.08, 0.45), (0.36, 0.45), (0.22, 0.72), (0.06, 0.72))
            ],
            look,
        )
    b.hull(
        [
            (x, y * w, z * h)
            for x in (-0.3 * d, 0.3 * d)
            for y, z in ((-0.48, 0.2), (-0.2, 0.4), (-0.44, 0.55), (-0.47, 0.55))
        ],
        look,
    )
    b.box((-0.28 * d, 0.28 * d), (-0.475 * w, -0.455 * w), (0.5 * h, 0.62 * h), "steel", 0.0)


@small("sticky_notes")
def sticky_notes(b: Builder) -> None:
    """Square pads of notes in bright colours on each other, the top one written on."""
    d, w, h = b.size
    colors = ["yellow plastic", "pink icing", "green apple", "sky pigment", "orange plastic"]
    count = 1 if h < 0.03 else 3 if h < 0.045 else 4
    main = b.material("body", "banana peel", "pink icing", "pale leaf", "sky pigment", "orange peel")
    start = b.whole("start", 0, 4)
    for k in range(count):
        with b.frame(0, 0, k * h / count, yaw=0.0 if k == 0 else b.uniform(f"a{k}", -0.1, 0.1)):
            e = 0.0 if k == 0 else 0.003
            leaves(b, d - 2 * e, w - 2 * e, (0.0, h / count), main if k == 0 else colors[(start + k) % 5])
            if k == count - 1:
                for j in range(4):
                    x = (-0.3 + 0.17 * j) * d
                    decal(
                        b,
                        (x, x + 0.03 * d),
                        (-0.36 * w, (0.3 - 0.12 * (j % 3)) * w),
                        (h / count - 0.001, h / count + 0.0003),
                        "ink pigment",
                    )


@small("envelope_stack")
def envelope_stack(b: Builder) -> None:
    """Envelopes in a pile with address, stamp and window."""
    d, w, h = b.size
    b.material("body", "paper")
    count = max(3, round(h / 0.0045))
    t = h / count
    for k in range(count):
        with b.frame(0, 0, k * t, yaw=0.0 if k == 0 else b.uniform(f"a{k}", -0.12, 0.12)):
            s = 1.0 if k == 0 else b.uniform(f"s{k}", 0.82, 0.95)
            look = b.pick(f"c{k}", ["paper", "paper", "cardboard", "cream paint", "sky pigment"])
            b.box((-d / 2 * s, d / 2 * s), (-w / 2 * s, w / 2 * s), (0.0, t), look, 0.0004)
            if k == count - 1:
                z = (t - 0.001, t + 0.0003)
                decal(b, (-0.42 * d * s, -0.2 * d * s), (0.32 * w * s, 0.44 * w * s), z, "red paint")
                for j in range(3):
                    decal(
                        b,
                        ((0.05 + 0.1 * j) * d * s, (0.075 + 0.1 * j) * d * s),
                        (0.02 * w, (0.3 - 0.05 * j) * w * s),
                        z,
                        "ink pigment",
                    )


@small("calendar")
def calendar(b: Builder) -> None:
    """A tent calendar: a picture, a month of days, a wire at its ridge."""
    d, w, h = b.size
    stand = b.material("stand", "black paint", "red paint", "navy paint", "cardboard", "sage paint")
    top = h - 0.006
    lean = float(np.arctan2(d / 2, top))
    long = float(np.hypot(d / 2, top))
    for s in (-1, 1):
        with b.frame(s * (d / 2 - 0.0005), 0, 0, pitch=-s * lean):
            x = (-0.0024, 0.0) if s > 0 else (0.0, 0.0024)
            b.box(x, (-w / 2, w / 2), (0.0, long), stand, 0.0)
            if s > 0:
                decal(b, (-0.001, 0.0003), (-0.48 * w, 0.48 * w), (0.06 * long, 0.95 * long), "paper")
                decal(b, (-0.001, 0.0004), (-0.46 * w, -0.02 * w), (0.1 * long, 0.9 * long), b.pick("photo", PRINTS))
                decal(b, (-0.001, 0.00045), (-0.46 * w, -0.02 * w), (0.1 * long, 0.4 * long), b.pick("land", PRINTS))
                decal(b, (-0.001, 0.0004), (0.02 * w, 0.3 * w), (0.76 * long, 0.86 * long), stand)
                for i in range(7):
                    for j in range(5):
                        y, z = (0.03 + 0.062 * i) * w, (0.58 - 0.11 * j) * long
                        decal(
                            b,
                            (-0.001, 0.0004),
                            (y, y + 0.035 * w),
                            (z, z + 0.05 * long),
                            "red paint" if i == 6 else "grey paint",
                        )
    n = 15
    for k in range(n):
        y = -0.46 * w + 0.92 * w * k / (n - 1)
        b.box((-0.005, 0.005), (y - 0.0012, y + 0.0012), (h - 0.012, h), "steel", 0.002)


@small("clipboard")
def clipboard(b: Builder) -> None:
    """A board with a clip and a printed form."""
    d, w, h = b.size
    look = b.material("board", "oak", "black plastic", "clear plastic", "cork", "blue plastic", "walnut")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.0035), look, 0.012, 0.0008)
    with b.frame(0.014, 0, 0):
        leaves(b, min(0.285, d - 0.03), 0.205, (0.0035, 0.0052))
        printed(b, 0.28, 0.2, 0.0052, lines=11)
    slab(b, (-d / 2 + 0.006, -d / 2 + 0.035), (-0.06, 0.06), (0.0035, 0.009), "steel", 0.008, 0.002)
    b.bar((-d / 2 + 0.012, -0.05, h - 0.005), (-d / 2 + 0.012, 0.05, h - 0.005), 0.005, "steel", 10)


@small("calculator")
def calculator(b: Builder) -> None:
    """A slanted calculator with a display and keys."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "white plastic", "mint plastic")
    keys = b.material("keys", "white plastic", "grey plastic", "black plastic")
    low = 0.45 * h
    b.hull(
        [
            (x, y, z)
            for y in (-w / 2, w / 2)
            for x, z in ((d / 2, 0.0), (-d / 2, 0.0), (-d / 2, 0.75 * h), (-0.48 * d, 0.88 * h), (d / 2, low))
        ],
        look,
    )
    tilt = float(np.arctan2(0.88 * h - low, 0.98 * d))
    with b.frame(d / 2, 0, low, pitch=tilt):
        decal(b, (-0.95 * d, -0.76 * d), (-0.42 * w, 0.42 * w), (-0.002, 0.0003), "black plastic")
        decal(b, (-0.92 * d, -0.79 * d), (-0.39 * w, 0.39 * w), (-0.002, 0.0004), "pale leaf")
        for i in range(5):
            for j in range(4):
                x, y = (-0.7 + 0.135 * i) * d, (-0.42 + 0.215 * j) * w
                c = "orange plastic" if (i, j) == (4, 3) else "grey plastic" if j == 3 else keys
                b.box((x, x + 0.1 * d), (y, y + 0.17 * w), (-0.001, 0.12 * h), c, 0.001)


@small("scissors")
def scissors(b: Builder) -> None:
    """Scissors lying a little open, with bright grips."""
    d, w, h = b.size
    grip = b.material("grip", "red plastic", "black plastic", "orange plastic", "blue plastic", "green plastic")
    for s in (-1, 1):
        z = 0.0 if s < 0 else 0.4 * h
        with b.frame(0, 0, 0, yaw=s * 0.14):
            b.hull(
                [
                    (x * d, s * y * w, z + t)
                    for x, y in ((-0.52, -0.01), (-0.05, -0.09), (0.06, -0.06), (0.06, 0.06), (-0.05, 0.06))
                    for t in (0.15 * h, 0.5 * h)
                ],
                "steel",
            )
            b.hull(
                [
                    (x * d, s * y * w, t)
                    for x, y in ((0.03, -0.04), (0.03, 0.06), (0.16, 0.16), (0.18, 0.02))
                    for t in (z, z + 0.5 * h)
                ],
                "steel",
            )
        with b.frame(0.3 * d, s * 0.25 * w, 0.5 * h, yaw=s * 0.3):
            t = np.arange(14) * 2 * np.pi / 14
            n = np.array([[-0.006, -0.5 * h], [0.006, -0.5 * h], [0.006, 0.5 * h], [-0.006, 0.5 * h]])
            b.tube(np.c_[0.15 * d * np.cos(t), 0.2 * w * np.sin(t), 0 * t], n, grip, closed=True)
    spot(b, 0.0042, (0.4 * h, 0.9 * h + 0.0003), "black plastic", 12)


@small("hole_punch")
def hole_punch(b: Builder) -> None:
    """A punch with a lever and two holes."""
    d, w, h = b.size
    look = b.material("body", "black steel", "red plastic", "grey plastic", "blue plastic")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.16 * h), "black plastic", 0.01, 0.002)
    for s in (-1, 1):
        b.box((0.1 * d, 0.24 * d), (s * 0.34 * w - 0.008, s * 0.34 * w + 0.008), (0.16 * h, 0.6 * h), "steel", 0.002)
        b.box(
            (-0.3 * d, 0.3 * d), (s * 0.47 * w - 0.003, s * 0.47 * w + 0.003), (0.1 * h, 0.62 * h), "black steel", 0.001
        )
    b.hull(
        [
            (x * d, y * w, z * h)
            for y in (-0.44, 0.44)
            for x, z in ((0.3, 0.5), (0.32, 0.6), (0.1, 0.72), (-0.5, 1.0), (-0.5, 0.88), (-0.2, 0.55))
        ],
        look,
    )
    b.box((0.28 * d, 0.31 * d), (-0.4 * w, 0.4 * w), (0.18 * h, 0.2 * h), "steel", 0.0)


@small("business_card_holder")
def business_card_holder(b: Builder) -> None:
    """Cards upright in a small stand."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "oak", "walnut", "clear plastic", "steel", "brass")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.12 * h), look, 0.001)
    b.box((0.42 * d, d / 2), (-w / 2, w / 2), (0.12 * h, 0.34 * h), look, 0.001)
    b.box((-d / 2, -0.4 * d), (-w / 2, w / 2), (0.12 * h, 0.7 * h), look, 0.001)
    for k in range(5):
        with b.frame(0.3 * d - 0.13 * d * k, 0, 0.12 * h, pitch=-0.12):
            b.box((-0.003, 0.0), (-0.44 * w, 0.44 * w), (0.0, (0.8 + 0.02 * k) * h), "paper", 0.0)
            if k == 0:
                decal(
                    b,
                    (-0.001, 0.0003),
                    (-0.36 * w, -0.05 * w),
                    (0.6 * h, 0.68 * h),
                    b.pick("logo", ["navy paint", "red paint", "teal paint"]),
                )
                decal(b, (-0.001, 0.0003), (-0.36 * w, 0.2 * w), (0.5 * h, 0.53 * h), "grey paint")
