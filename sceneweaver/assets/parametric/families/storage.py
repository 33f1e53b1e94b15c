"""Bookcases and wardrobes."""

from __future__ import annotations

from ..builder import Builder
from ..joinery import carcass, door
from ..registry import draws
from .storage_parts import REACH, SHADOW, cornice, split


@draws("bookcase")
def bookcase(b: Builder) -> None:
    """Sides, back and three to four openings; modern with a shadow foot, classic with plinth and cornice."""
    d, w, h = b.size
    wood = b.material(
        "body", "oak", "walnut", "white paint", "black paint", "light oak", "cherry", "pine", "sage paint"
    )
    rear = b.material("back", "white paint", "navy paint", "sage paint") if b.chance("painted back", 0.15) else wood
    classic = b.style in ("classic", "rustic") and b.chance("cornice", 0.8)
    over = 0.025 if classic else 0.0
    board = b.pick("board", [0.018, 0.022, 0.03])
    plinth = b.uniform("plinth", 0.06, 0.1) if classic else b.uniform("plinth", 0.04, 0.07)
    head = 0.055 if classic else 0.0
    x, y = (-d / 2, d / 2 - over), (-w / 2 + over, w / 2 - over)
    inner = (y[0] + board, y[1] - board)
    for k, ys in enumerate(((y[0], inner[0]), (inner[1], y[1]))):
        with b.solid(f"side-{k}"):
            b.box(x, ys, (0.0, h - head), wood, bevel=0.002)
            if classic:  # a bead down the front edge
                middle = (ys[0] + ys[1]) / 2
                b.box(
                    (x[1], x[1] + 0.005),
                    (middle - 0.005, middle + 0.005),
                    (plinth + board, h - head),
                    wood,
                    bevel=0.002,
                )
    with b.solid("back"):
        b.box((x[0], x[0] + 0.006), inner, (plinth + board, h - head - board), rear, bevel=0.0)
    with b.solid("foot"):
        if classic:
            b.box((x[1] - 0.02, x[1] + 0.012), (y[0] - 0.012, y[1] + 0.012), (0.0, plinth), wood, bevel=0.004)
            b.box((x[0], x[1] - 0.02), inner, (0.0, plinth), wood, bevel=0.0)
        else:
            b.box((x[0], x[1] - 0.03), inner, (0.0, plinth), SHADOW, bevel=0.0)
        b.box(x, inner, (plinth, plinth + board), wood, bevel=0.0015)
    count = 3 if h < 1.6 else 4  # openings; with sides, back, foot and top at most eight prisms
    low, high = plinth + board, h - head - board
    # The lowest opening is the highest: for folders and large books.
    shares = [1.12 - 0.24 * k / (count - 1) for k in range(count)] if b.chance("graded", 0.5) else [1.0] * count
    step = (high - low + board) / sum(shares)
    floors = [low + step * sum(shares[:k]) for k in range(count)]
    for k, z in enumerate(floors):
        if k:
            with b.solid(f"shelf-{k}"):
                b.box((x[0] + 0.006, x[1] - 0.004), inner, (z - board, z), wood, bevel=0.0015)
        ceiling = floors[k + 1] - board if k + 1 < count else high
        b.surface(
            f"shelf-{k}",
            (x[0] + 0.011, x[1] - 0.009),
            (inner[0] + 0.005, inner[1] - 0.005),
            z,
            headroom=round(ceiling - z - 0.005, 4),
        )
    with b.solid("top"):
        b.box(x, inner, (high, h - head), wood, bevel=0.0015)
        if classic:
            cornice(b, x, y, (h - head, h), wood, over)
    if h < 1.6:
        b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)


@draws("wardrobe")
def wardrobe(b: Builder) -> None:
    """A carcass on a plinth with two to four doors, a rail inside; a cornice in the classic style."""
    d, w, h = b.size
    two_tone = b.chance("two tone", 0.3)
    woods = ("oak", "white paint", "walnut", "light grey paint", "pine", "cherry", "cream paint", "sage paint")
    wood = b.material("body", *(("oak", "light oak", "walnut") if two_tone else woods))
    fronts = b.material("fronts", "white paint", "sage paint", "navy paint", "cream paint") if two_tone else wood
    pull = b.material("pulls", "black steel", "brass", "brushed steel")
    style = b.pick("pull style", ["bar", "knob", "bar"])
    classic = b.style in ("classic", "rustic")
    over = 0.025 if classic else 0.0
    head = 0.06 if classic else 0.0
    framed = classic or b.chance("framed", 0.25)
    mirror = b.chance("mirror", 0.3)
    front = 0.02
    x, y = (-d / 2, d / 2 - max(REACH[style] + front, over)), (-w / 2 + over, w / 2 - over)
    foot, roof = 0.08, h - head
    with b.solid("foot"):
        if classic:
            b.box((x[0], x[1] + 0.012), y, (0.0, foot), wood, bevel=0.004)
        else:
            b.box((x[0], x[1] - 0.03), (y[0] + 0.01, y[1] - 0.01), (0.0, foot), SHADOW, bevel=0.0)
    interior = carcass(b, x, y, (foot, roof), wood)
    rail = roof - 0.1
    b.bar(((x[0] + x[1]) / 2, interior[1][0], rail), ((x[0] + x[1]) / 2, interior[1][1], rail), 0.0125, "brushed steel")
    b.surface(
        "floor",
        (interior[0][0] + 0.01, interior[0][1] - 0.02),
        interior[1],
        interior[2][0],
        headroom=round(rail - 0.0125 - interior[2][0] - 0.005, 4),
    )
    count = 2 if w < 1.2 else 3 if w < 1.6 else 4
    for k, ys in enumerate(split(y, count, 0.003)):
        panel = "mirror" if mirror and k == count // 2 else fronts if framed else None
        door(
            b,
            f"door-{k}",
            (x[1], x[1] + front),
            ys,
            (foot + 0.003, roof - 0.003),
            fronts,
            pull,
            hung="right" if k % 2 == 0 and k + 1 < count else "left",
            style=style,
            panel=panel,
        )
    if classic:
        with b.solid("cornice"):
            cornice(b, x, y, (roof, h), wood, over)
    b.surface("top", (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), h)
