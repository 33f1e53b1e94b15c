"""Shelves and cupboards."""

from __future__ import annotations

from ..builder import Builder
from ..joinery import carcass, door
from ..registry import draws


@draws("bookcase")
def bookcase(b: Builder) -> None:
    """Sides, back, and three to five boards that carry things."""
    d, w, h = b.size
    wood = b.material("body", "oak", "walnut", "white paint", "black paint", "light oak")
    plinth = b.uniform("plinth", 0.04, 0.08)
    board, back = 0.02, 0.006
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    b.box(x, (y[0], y[0] + board), (0.0, h), wood, bevel=0.0015)
    b.box(x, (y[1] - board, y[1]), (0.0, h), wood, bevel=0.0015)
    inner = (y[0] + board, y[1] - board)
    b.box((x[0], x[0] + back), inner, (plinth, h), wood, bevel=0.0)
    with b.solid("foot"):
        b.box((x[0], x[1] - 0.02), inner, (0.0, plinth), wood, bevel=0.0)
        b.box(x, inner, (plinth, plinth + board), wood, bevel=0.0015)
    count = 3 if h < 1.6 else 4  # openings; with sides, back and top at most eight prisms
    floors = [plinth + board + k * (h - plinth - board) / count for k in range(count)]
    for k, z in enumerate(floors):
        if k:
            b.box((x[0] + back, x[1]), inner, (z - board, z), wood, bevel=0.0015)
        ceiling = (floors[k + 1] if k + 1 < count else h) - board
        b.surface(f"shelf-{k}", (x[0] + back + 0.005, x[1] - 0.005), (inner[0] + 0.005, inner[1] - 0.005), z,
                  headroom=round(ceiling - z - 0.005, 4))  # fmt: skip
    b.box((x[0] + back, x[1]), inner, (h - board, h), wood, bevel=0.0015)
    if h < 1.6:
        b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)


@draws("wardrobe")
def wardrobe(b: Builder) -> None:
    """A carcass on a plinth with two to four doors."""
    d, w, h = b.size
    wood = b.material("body", "oak", "white paint", "walnut", "light grey paint", "pine")
    fronts = b.material("fronts", "white paint", "oak", "sage paint", "mirror") if b.chance("two tone", 0.4) else wood
    pull = b.material("pulls", "black steel", "brass", "steel")
    style = b.pick("pull style", ["bar", "knob", "cup"])
    x, y = (-d / 2, d / 2 - 0.045), (-w / 2, w / 2)
    b.box((x[0], x[1] - 0.04), (y[0] + 0.01, y[1] - 0.01), (0.0, 0.06), wood)
    interior = carcass(b, x, y, (0.06, h), wood)
    b.surface("floor", (interior[0][0] + 0.01, interior[0][1] - 0.02), interior[1], interior[2][0],
              headroom=round(interior[2][1] - interior[2][0] - 0.005, 4))  # fmt: skip
    count = 2 if w < 1.2 else 3 if w < 1.6 else 4
    step = w / count
    for k in range(count):
        door(b, f"door-{k}", (x[1], x[1] + 0.02), (y[0] + k * step, y[0] + (k + 1) * step), (0.06, h), fronts, pull,
             hung="right" if k % 2 == 0 else "left", style=style)  # fmt: skip
    b.surface("top", (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), h)
