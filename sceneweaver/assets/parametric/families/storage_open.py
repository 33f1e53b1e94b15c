"""Open shelves and glazed cabinets: every board can carry things."""

from __future__ import annotations

import numpy as np

from ...body import Material
from ..builder import Builder, Interval
from ..joinery import door
from ..registry import draws
from .storage_parts import SHADOW, cornice, feet, pulls, split

WOODS = ("oak", "walnut", "white paint", "black paint", "light oak", "pine")


def _boards(
    b: Builder,
    x: Interval,
    y: Interval,
    floors: list[float],
    top: float,
    material: Material,
    board: float,
    first: int = 0,
    name: str = "shelf",
) -> None:
    """Boards whose upper sides are at these heights, each a surface, under a ceiling at ``top``."""
    for k, z in enumerate(floors):
        if k >= first:
            with b.solid(f"{name}-{k}"):
                b.box(x, y, (z - board, z), material, bevel=0.0015)
        ceiling = floors[k + 1] - board if k + 1 < len(floors) else top
        b.surface(
            f"{name}-{k}",
            (x[0] + 0.005, x[1] - 0.005),
            (y[0] + 0.005, y[1] - 0.005),
            z,
            headroom=round(ceiling - z - 0.003, 4),
        )


@draws("low_bookcase")
def low_bookcase(b: Builder) -> None:
    """Two or three boards high, with a top to put things on."""
    d, w, h = b.size
    wood = b.material("body", *WOODS)
    board = 0.02
    base = b.pick("base", ["plinth", "tapered", "square"])
    foot = 0.05 if base == "plinth" else 0.12
    x, y = (-d / 2, d / 2 - 0.008), (-w / 2 + 0.008, w / 2 - 0.008)
    inner = (y[0] + board, y[1] - board)
    with b.solid("foot"):
        feet(b, x, y, foot, wood, base)
        b.box(x, inner, (foot, foot + board), wood, bevel=0.0015)
    for k, ys in enumerate(((y[0], inner[0]), (inner[1], y[1]))):
        with b.solid(f"side-{k}"):
            b.box(x, ys, (foot, h - 0.024), wood, bevel=0.0015)
    with b.solid("top"):
        b.box((x[0], d / 2), (-w / 2, w / 2), (h - 0.024, h), wood, bevel=0.004)
    low, high = foot + board, h - 0.024
    with b.solid("back"):
        b.box((x[0], x[0] + 0.006), inner, (low, high), wood, bevel=0.0)
    count = 2 if h < 0.95 else 3
    floors = [low + k * (high - low + board) / count for k in range(count)]
    _boards(b, (x[0] + 0.006, x[1] - 0.004), inner, floors, high, wood, board, first=1)
    b.surface("top", (x[0] + 0.01, d / 2 - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), h)


@draws("display_cabinet")
def display_cabinet(b: Builder) -> None:
    """A cabinet with glass doors and sides over a closed foot; glass boards within."""
    d, w, h = b.size
    wood = b.material("body", "oak", "walnut", "white paint", "mahogany", "black paint", "cherry")
    style, pull, reach = pulls(b, wood, "bar", "knob")
    classic = b.style in ("classic", "rustic")
    post, over = 0.035, 0.02 if classic else 0.0
    x, y = (-d / 2, d / 2 - max(reach, over)), (-w / 2 + over, w / 2 - over)
    foot = 0.28 * h if b.chance("cupboard", 0.5) else 0.12
    inner = (y[0] + 0.025, y[1] - 0.025)
    with b.solid("foot"):
        feet(b, x, y, 0.08, wood, "bracket" if classic else "plinth")
        b.box((x[0], x[1] - 0.02), y, (0.08, foot), wood)
        if foot > 0.2:
            b.box((x[1] - 0.02, x[1] - 0.0195), (y[0] + 0.005, y[1] - 0.005), (0.083, foot - 0.022), SHADOW, bevel=0.0)
            for k, ys in enumerate(split(y, 2)):
                door(
                    b,
                    f"low-{k}",
                    (x[1] - 0.0185, x[1]),
                    ys,
                    (0.08, foot - 0.02),
                    wood,
                    pull,
                    hung="right" if k == 0 else "left",
                    style=style,
                    panel=wood,
                )
            b.box((x[1] - 0.02, x[1]), y, (foot - 0.02, foot), wood, bevel=0.001)
        else:
            b.box((x[1] - 0.02, x[1]), y, (0.08, foot), wood)
    roof = h - 0.06
    for k, ys in enumerate(((y[0], y[0] + 0.025), (y[1] - 0.025, y[1]))):
        with b.solid(f"side-{k}"):
            for xs in ((x[0], x[0] + post), (x[1] - 0.02 - post, x[1] - 0.02)):
                b.box(xs, ys, (foot, roof), wood, bevel=0.001)
            middle = (ys[0] + ys[1]) / 2
            between = (x[0] + post, x[1] - 0.02 - post)
            b.box(between, ys, (foot, foot + 0.03), wood, bevel=0.001)
            b.box(between, ys, (roof - 0.03, roof), wood, bevel=0.001)
            b.box(between, (middle - 0.003, middle + 0.003), (foot + 0.03, roof - 0.03), "glass", bevel=0.0)
    with b.solid("back"):
        b.box((x[0], x[0] + 0.008), inner, (foot, roof), wood, bevel=0.0)
    with b.solid("top"):
        if classic:
            cornice(b, x, y, (roof, h), wood, over)
        else:
            b.box(x, y, (roof, h), wood)
    count = 2 if h < 1.4 else 3
    shelf = 0.008
    floors = [foot, *(foot + k * (roof - foot) / count for k in range(1, count))]
    _boards(b, (x[0] + 0.008, x[1] - 0.03), inner, floors, roof, b.material("boards", "glass"), shelf, first=1)
    with b.solid("doors"):
        for k, ys in enumerate(split(y, 1 if w < 0.55 else 2)):
            door(
                b,
                f"door-{k}",
                (x[1] - 0.0195, x[1]),
                ys,
                (foot + 0.002, roof - 0.002),
                wood,
                pull,
                hung="right" if k == 0 else "left",
                style=style,
                panel="glass",
            )
    if h < 1.4:
        b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)


@draws("metal_shelf")
def metal_shelf(b: Builder) -> None:
    """Slotted posts, four or five trays or boards, a cross brace at the back."""
    d, w, h = b.size
    steel = b.material("frame", "brushed steel", "black steel", "white steel", "blue paint", "grey paint")
    tray = b.material("boards", "plywood", "brushed steel", "pine") if b.chance("wood", 0.5) else steel
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wide, thin, lip = 0.035, 0.003, 0.03
    for k, sy in enumerate((-1, 1)):
        with b.solid(f"side-{k}"):
            for sx in (-1, 1):
                ex, ey = sx * d / 2, sy * w / 2
                xs, ys = sorted((ex, ex - sx * thin)), sorted((ey, ey - sy * wide))
                b.box((xs[0], xs[1]), (ys[0], ys[1]), (0.0, h), steel, bevel=0.0)
                xs, ys = sorted((ex - sx * thin, ex - sx * wide)), sorted((ey, ey - sy * thin))
                b.box((xs[0], xs[1]), (ys[0], ys[1]), (0.0, h), steel, bevel=0.0)
                xs, ys = sorted((ex, ex - sx * wide)), sorted((ey, ey - sy * wide))
                b.box((xs[0], xs[1]), (ys[0], ys[1]), (0.0, 0.006), "black plastic", bevel=0.0)
    with b.solid("brace"):
        for sy in (-1, 1):
            b.bar(
                (x[0] + 0.006, -sy * (w / 2 - 0.02), 0.15),
                (x[0] + 0.006, sy * (w / 2 - 0.02), h - 0.15),
                0.003,
                steel,
                segments=6,
            )
    count = 4 if h < 1.75 else 5
    levels = [0.12 + k * (h - 0.14) / (count - 1) for k in range(count)]
    levels[-1] = h - 0.012
    for k, z in enumerate(levels):
        with b.solid(f"tray-{k}"):
            inner_x, inner_y = (x[0] + 0.012, x[1] - thin), (y[0] + thin, y[1] - thin)
            b.box(inner_x, inner_y, (z - 0.012, z), tray, bevel=0.001)
            for xs in ((inner_x[0], inner_x[0] + 0.015), (inner_x[1] - 0.015, inner_x[1])):
                b.box(xs, inner_y, (z - lip - 0.012, z - 0.012), steel, bevel=0.001)
        ceiling = levels[k + 1] - lip - 0.012 - z if k + 1 < count else None
        b.surface(
            f"shelf-{k}" if ceiling else "top",
            (x[0] + 0.04, x[1] - 0.04),
            (y[0] + 0.04, y[1] - 0.04),
            z,
            headroom=None if ceiling is None else round(ceiling - 0.003, 4),
        )


@draws("cube_shelf")
def cube_shelf(b: Builder) -> None:
    """A thick frame around square openings; in some, a row of fabric boxes at the foot."""
    d, w, h = b.size
    wood = b.material("body", "white paint", "oak", "black paint", "light oak", "walnut")
    rim, board = 0.036, 0.018
    columns = max(2, min(3, round(w / 0.37)))
    rows = max(2, min(6 - columns, round(h / 0.37)))
    x = (-d / 2, d / 2)
    ys, zs = split((-w / 2 + rim, w / 2 - rim), columns, board), split((rim, h - rim), rows, board)
    bins = b.chance("bins", 0.45)
    if bins:
        cloth = b.material("bins", "grey fabric", "beige fabric", "rattan", "navy fabric", "mustard fabric")
    for k in range(columns + 1):
        with b.solid(f"upright-{k}"):
            if k in (0, columns):
                side = (-w / 2, -w / 2 + rim) if k == 0 else (w / 2 - rim, w / 2)
                b.box(x, side, (0.0, h), wood, bevel=0.002)
            else:
                for z in zs:
                    b.box((x[0], x[1] - 0.004), (ys[k - 1][1], ys[k][0]), z, wood, bevel=0.001)
    inner = (-w / 2 + rim, w / 2 - rim)
    for j in range(rows + 1):
        low = 0.0 if j == 0 else zs[j - 1][1]
        high = h if j == rows else zs[j][0]
        with b.solid(f"board-{j}"):
            b.box(x, inner, (low, high), wood, bevel=0.001)
            if j == 0 and bins:
                for y in ys:
                    front = x[1] - 0.01
                    top = zs[0][1] - 0.03
                    b.box((x[0] + 0.02, front), (y[0] + 0.006, y[1] - 0.006), (high, top), cloth, bevel=0.006)
                    middle = (y[0] + y[1]) / 2
                    b.box(
                        (front, front + 0.006),
                        (middle - 0.04, middle + 0.04),
                        (top - 0.07, top - 0.05),
                        "brown leather",
                        bevel=0.002,
                    )
        if j == rows:
            b.surface("top", (x[0] + 0.01, x[1] - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), h)
        elif j or not bins:
            for k, y in enumerate(ys):
                b.surface(
                    f"shelf-{j * columns + k}",
                    (x[0] + 0.005, x[1] - 0.009),
                    (y[0] + 0.005, y[1] - 0.005),
                    zs[j][0],
                    headroom=round(zs[j][1] - zs[j][0] - 0.003, 4),
                )


@draws("ladder_shelf")
def ladder_shelf(b: Builder) -> None:
    """Leaning rails in front of upright posts, boards that grow shallower upward."""
    d, w, h = b.size
    frame = b.material("frame", "black steel", "oak", "white paint", "walnut", "bamboo")
    wood = b.material("boards", "oak", "walnut", "pine", "light oak")
    t, deep = 0.022, 0.035
    x = (-d / 2, d / 2)
    least = 0.42 * d

    def front(z: float) -> float:
        return x[0] + d + (least - d) * z / h

    for k, ys in enumerate(((-w / 2, -w / 2 + t), (w / 2 - t, w / 2))):
        with b.solid(f"side-{k}"):
            b.box((x[0], x[0] + t), ys, (0.0, h), frame, bevel=0.002)
            b.hull([(front(z) - a, y, z) for z in (0.0, h) for a in (0.0, deep) for y in ys], frame)
    count = 4 if h < 1.65 else 5
    levels = [0.18 + k * (h - 0.35) / (count - 1) for k in range(count)]
    for k, z in enumerate(levels):
        y = (-w / 2 + t, w / 2 - t)
        ends = (x[0] + 0.002, front(z) - 0.006)
        with b.solid(f"shelf-{k}"):
            b.box(ends, y, (z - 0.02, z), wood, bevel=0.002)
        room = None if k + 1 == count else round(levels[k + 1] - 0.023 - z, 4)
        b.surface(f"shelf-{k}", (ends[0] + 0.008, ends[1] - 0.008), (y[0] + 0.005, y[1] - 0.005), z, headroom=room)


@draws("corner_shelf")
def corner_shelf(b: Builder) -> None:
    """Quarter-round boards between two narrow sides that meet in the corner of a room."""
    d, w, h = b.size
    wood = b.material("body", *WOODS)
    t, board = 0.016, 0.02
    x0, y0 = -d / 2, w / 2
    with b.solid("back"):
        b.box((x0, x0 + t), (-w / 2 + 0.03, y0), (0.0, h), wood, bevel=0.0015)
    with b.solid("side"):
        b.box((x0 + t, d / 2 - 0.03), (y0 - t, y0), (0.0, h), wood, bevel=0.0015)
    a = np.linspace(0.0, np.pi / 2, 13)
    rx, ry = d - t, w - t
    ring = [(x0 + t, y0 - t), *((x0 + t + rx * np.cos(v), y0 - t - ry * np.sin(v)) for v in a)]
    small = [
        (x0 + t + 0.005, y0 - t - 0.005),
        *(
            (x0 + t + 0.95 * rx * np.cos(v), y0 - t - 0.95 * ry * np.sin(v))
            for v in np.linspace(0.03, np.pi / 2 - 0.03, 9)
        ),
    ]
    count = 4 if h < 1.5 else 5
    levels = [0.08 + k * (h - 0.28) / (count - 1) for k in range(count)]
    for k, z in enumerate(levels):
        with b.solid(f"shelf-{k}"):
            b.extrude(np.array(ring[::-1]), (z - board, z), wood)
        room = None if k + 1 == count else round(levels[k + 1] - board - z - 0.003, 4)
        b.surface(f"shelf-{k}", (0, 0), (0, 0), z, headroom=room, polygon=small[::-1])


@draws("library_shelf")
def library_shelf(b: Builder) -> None:
    """A free-standing case with boards on both sides of a middle panel."""
    d, w, h = b.size
    wood = b.material("body", "oak", "beech", "light grey paint", "walnut", "white paint")
    ends = b.material("ends", "oak", "beech", "walnut") if b.chance("ends", 0.4) else wood
    t, board = 0.03, 0.02
    y = (-w / 2 + t, w / 2 - t)
    for k, ys in enumerate(((-w / 2, y[0]), (y[1], w / 2))):
        with b.solid(f"end-{k}"):
            b.box((-d / 2, d / 2), ys, (0.0, h), ends, bevel=0.004)
    with b.solid("foot"):
        b.box((-d / 2 + 0.03, d / 2 - 0.03), y, (0.0, 0.08), SHADOW, bevel=0.0)
        b.box((-d / 2 + 0.005, d / 2 - 0.005), y, (0.08, 0.1), wood, bevel=0.0015)
    with b.solid("panel"):
        b.box((-0.009, 0.009), y, (0.1, h - 0.03), wood, bevel=0.0)
    with b.solid("roof"):
        b.box((-d / 2 + 0.002, d / 2 - 0.002), y, (h - 0.03, h), wood, bevel=0.002)
    count = 4 if h > 1.5 else 3
    levels = [0.1 + k * (h - 0.11) / count for k in range(count)]
    for k, z in enumerate(levels):
        if k:
            with b.solid(f"shelf-{k}"):
                for xs in ((-d / 2 + 0.008, -0.009), (0.009, d / 2 - 0.008)):
                    b.box(xs, y, (z - board, z), wood, bevel=0.0015)
        room = (levels[k + 1] - board if k + 1 < count else h - 0.03) - z - 0.003
        for name, xs in (("front", (0.014, d / 2 - 0.014)), ("back", (-d / 2 + 0.014, -0.014))):
            b.surface(f"{name}-{k}", xs, (y[0] + 0.005, y[1] - 0.005), z, headroom=round(room, 4))


@draws("pantry_shelf")
def pantry_shelf(b: Builder) -> None:
    """Slatted sides, four boards, two crates at the foot."""
    d, w, h = b.size
    wood = b.material("body", "pine", "oak", "white paint", "birch")
    crate = b.material("crates", "wicker", "pine", "plywood")
    t, post = 0.022, 0.04
    y = (-w / 2 + t, w / 2 - t)
    for k, ys in enumerate(((-w / 2, y[0]), (y[1], w / 2))):
        with b.solid(f"side-{k}"):
            for xs in ((-d / 2, -d / 2 + post), (d / 2 - post, d / 2)):
                b.box(xs, ys, (0.0, h), wood, bevel=0.003)
            for z in np.linspace(0.25, h - 0.06, 7):
                b.box((-d / 2 + post, d / 2 - post), (ys[0] + 0.004, ys[1] - 0.004), (z, z + 0.03), wood, bevel=0.002)
    levels = [0.1, *(0.5 + k * (h - 0.52) / 3 for k in range(4))]
    x = (-d / 2 + 0.006, d / 2 - 0.006)
    for k, z in enumerate(levels):
        with b.solid(f"shelf-{k}"):
            b.box(x, y, (z - 0.02, z), wood, bevel=0.002)
            if k == 0:
                for ys in split((y[0] + 0.01, y[1] - 0.01), 2, 0.02):
                    b.box((x[0] + 0.02, x[1] - 0.01), ys, (z, z + 0.24), crate, bevel=0.006)
                    middle = (ys[0] + ys[1]) / 2
                    b.box(
                        (x[1] - 0.01, x[1] - 0.008),
                        (middle - 0.045, middle + 0.045),
                        (z + 0.17, z + 0.2),
                        SHADOW,
                        bevel=0.0,
                    )
        if k:
            room = None if k == 4 else round(levels[k + 1] - 0.023 - z, 4)
            name = "top" if k == 4 else f"shelf-{k - 1}"
            b.surface(name, (x[0] + 0.008, x[1] - 0.008), (y[0] + 0.005, y[1] - 0.005), z, headroom=room)
