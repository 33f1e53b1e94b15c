"""Kitchen cabinets, counters, islands, sinks and carts."""

from __future__ import annotations

from ..builder import Builder
from ..joinery import carcass, door
from ..registry import draws
from .kitchen_parts import WORKTOPS, basin, cabinet, castors, fronts, tap, worktop, worktop_of


def _looks(b: Builder) -> tuple:
    """Body, fronts, pulls and their style."""
    leaf = b.material(
        "fronts",
        "white paint",
        "oak",
        "sage paint",
        "navy paint",
        "light grey paint",
        "walnut",
        "cream paint",
        "black paint",
        "teal paint",
        "light oak",
        "pine",
        "grey paint",
    )
    # The sides that are seen at the end of a run are faced like its fronts.
    body = leaf if b.in_suite else b.material("body", "white paint", "light grey paint")
    pull = b.material("pulls", "black steel", "brass", "steel", "bronze")
    return body, leaf, pull, b.pick("pull style", ["bar", "bar", "knob", "cup"], matched=True)


def _shaker(b: Builder) -> bool:
    return b.style in ("classic", "rustic", "scandinavian") and b.chance("shaker", 0.75, matched=True)


@draws("kitchen_cabinet", "kitchen_counter")
def base(b: Builder) -> None:
    """Base units on a plinth under one worktop."""
    d, w, h = b.size
    looks = _looks(b)
    top, t = worktop_of(b)
    x, y = (-d / 2, d / 2 - 0.027), (-w / 2, w / 2)
    shaker = _shaker(b)
    count = max(1, round(w / 0.62)) if w > 1.0 else 1
    step = w / count
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.07), (y[0] + 0.002, y[1] - 0.002), (0.0, 0.1), "black plastic", bevel=0)
        for k in range(count):
            layout = b.pick(
                f"layout {k}", ["doors", "drawers", "mixed"] if step > 0.5 else ["door", "drawers", "mixed"]
            )
            span = (y[0] + k * step, y[0] + (k + 1) * step)
            cabinet(b, f"unit-{k}", x, span, (0.1, h - t), layout, looks, shaker)
        b.box((-d / 2, d / 2 - 0.004), y, (h - t, h), top)
    b.surface("top", (-d / 2 + 0.01, d / 2 - 0.014), (y[0] + 0.01, y[1] - 0.01), h)
    b.fit()


@draws("corner_cabinet")
def corner_cabinet(b: Builder) -> None:
    """Two wings around an inner corner with a folding door in each; the corner of the room is at -x, +y."""
    d, w, h = b.size
    body, leaf, pull, style = _looks(b)
    top, t = worktop_of(b)
    deep = 0.572  # like base units of 0.62 m, whose fronts and worktop it goes on with
    o = 0.044
    over = [
        (-d / 2, -w / 2),
        (-d / 2 + deep + o, -w / 2),
        (-d / 2 + deep + o, w / 2 - deep - o),
        (d / 2, w / 2 - deep - o),
        (d / 2, w / 2),
        (-d / 2, w / 2),
    ]
    shell = body
    xa, yb = -d / 2 + deep, w / 2 - deep
    with b.solid("wing"):
        b.box((-d / 2 + 0.02, xa - 0.06), (-w / 2 + 0.002, w / 2), (0.0, 0.1), "black plastic", bevel=0)
        b.box((-d / 2, xa), (-w / 2, w / 2), (0.1, h - t), shell, bevel=0.001)
        b.box((-d / 2, xa + o), (-w / 2, w / 2), (h - t, h), top, bevel=0)
        # Hung at the outer end, and short of the other wing's front by more than its thickness: so it clears that.
        front = (xa + 0.0005, xa + 0.0205), (-w / 2, yb - 0.026), (0.1, h - t)
        door(b, "front-door", *front, leaf, pull, "right", style, leaf if _shaker(b) else None)
    with b.solid("arm"):
        b.box((xa - 0.06, d / 2 - 0.002), (yb + 0.06, w / 2 - 0.02), (0.0, 0.1), "black plastic", bevel=0)
        b.box((xa, d / 2), (yb, w / 2), (0.1, h - t), shell, bevel=0.001)
        b.box((xa + o, d / 2), (yb - o, w / 2), (h - t, h), top, bevel=0)
        b.box((xa + 0.024, d / 2 - 0.002), (yb - 0.0205, yb - 0.0005), (0.102, h - t - 0.002), leaf)
    b.surface(
        "top",
        (0, 1),
        (0, 1),
        h,
        polygon=[
            (over[0][0] + 0.01, over[0][1] + 0.01),
            (over[1][0] - 0.01, over[1][1] + 0.01),
            (over[2][0] - 0.01, over[2][1] + 0.01),
            (over[3][0] - 0.01, over[3][1] + 0.01),
            (over[4][0] - 0.01, over[4][1] - 0.01),
            (over[5][0] + 0.01, over[5][1] - 0.01),
        ],
    )
    b.fit()


@draws("wall_cabinet")
def wall_cabinet(b: Builder) -> None:
    """A hung cupboard with one or two doors, framed, flat or glazed, and boards behind glass."""
    d, w, h = b.size
    looks = _looks(b)
    x, y = (-d / 2, d / 2 - 0.025), (-w / 2, w / 2)
    glass = b.chance("glass", 0.3, matched=True)
    units = max(1, round(w / 0.75))
    step = w / units
    with b.solid("body"):
        count = 2 if h < 0.72 else 3
        for k in range(units):
            span = (y[0] + k * step, y[0] + (k + 1) * step)
            cabinet(b, f"unit-{k}", x, span, (0.0, h), "doors" if step > 0.55 else "door", looks, _shaker(b), glass)
            for j in range(1, count):
                z = j * h / count
                b.box((x[0] + 0.006, x[1] - 0.05), (span[0] + 0.018, span[1] - 0.018), (z - 0.009, z + 0.009), looks[0])
        if b.style in ("classic", "rustic"):
            b.box((x[0], x[1] + 0.01), y, (h - 0.0005, h + 0.03), looks[1], bevel=0.01)
    b.fit()


@draws("tall_cabinet")
def tall_cabinet(b: Builder) -> None:
    """A tall cupboard with a door or a pair below and above."""
    d, w, h = b.size
    looks = _looks(b)
    x, y = (-d / 2, d / 2 - 0.025), (-w / 2, w / 2)
    shaker = _shaker(b)
    split = b.uniform("split", 1.15, 1.45)
    kind = "doors" if w > 0.62 else "door"
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.07), (y[0] + 0.002, y[1] - 0.002), (0.0, 0.1), "black plastic", bevel=0)
        carcass(b, (x[0], x[1] - 0.021), y, (0.1, h), looks[0])
        for k, z in enumerate((0.45, 0.8, split, split + 0.35)):
            deep = x[1] - 0.021 if k == 2 else x[1] - 0.06
            b.box((x[0] + 0.006, deep), (y[0] + 0.018, y[1] - 0.018), (z - 0.009, z + 0.009), looks[0], bevel=0)
        fronts(b, "low", x[1] - 0.021, y, (0.1, split), kind, looks[1], looks[2], looks[3], shaker)
        fronts(b, "high", x[1] - 0.021, y, (split, h), kind, looks[1], looks[2], looks[3], shaker)
    b.fit()


@draws("sink_cabinet")
def sink_cabinet(b: Builder) -> None:
    """A base unit with one or two basins let into its worktop, and a mixer behind them."""
    d, w, total = b.size
    looks = _looks(b)
    top, t = worktop_of(b)
    steel = b.material("sink", "brushed steel", "steel", "white ceramic", "granite")
    metal = b.material("tap", "chrome", "black steel", "brass", "brushed steel")
    h = min(0.92, max(0.87, total - 0.34))
    x, y = (-d / 2, d / 2 - 0.027), (-w / 2, w / 2)
    shaker = _shaker(b)
    drain = w > 1.05
    side = b.pick("side", [-1, 1]) if drain else 0
    half = b.uniform("basin", 0.24, 0.29)
    middle = side * (w / 2 - half - 0.1)
    hx = (-d / 2 + 0.13, d / 2 - 0.085)
    double = w > 1.2 and b.chance("double", 0.5)
    if double:
        bowls = [(middle - half - 0.04, middle - 0.008), (middle + 0.008, middle + half + 0.04)]
    else:
        bowls = [(middle - half, middle + half)]
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.07), (y[0] + 0.002, y[1] - 0.002), (0.0, 0.1), "black plastic", bevel=0)
        xs, front = (x[0], x[1] - 0.021), x[1] - 0.021
        for ys in ((y[0], y[0] + 0.018), (y[1] - 0.018, y[1])):
            b.box(xs, ys, (0.1, h - t), looks[0], bevel=0.001)
        inner = (y[0] + 0.018, y[1] - 0.018)
        b.box(xs, inner, (0.1, 0.118), looks[0], bevel=0)
        b.box((x[0], x[0] + 0.006), inner, (0.118, h - t), looks[0], bevel=0)
        b.box((front - 0.018, front), inner, (h - t - 0.08, h - t), looks[0], bevel=0)
        count = 1 if w < 1.05 else 2
        for k in range(count):
            span = (y[0] + k * w / count, y[0] + (k + 1) * w / count)
            here = span[0] < middle < span[1]
            fronts(
                b,
                f"unit-{k}",
                front,
                span,
                (0.1, h - t),
                "doors" if here or count == 1 else b.pick("beside", ["drawers", "mixed"]),
                looks[1],
                looks[2],
                looks[3],
                shaker,
            )
        worktop(
            b,
            (-d / 2, d / 2 - 0.004),
            y,
            (h - t, h),
            top,
            [(hx, ys) for ys in bowls] if not double else [(hx, (bowls[0][0], bowls[1][1]))],
        )
        for ys in bowls:
            lip = 0.015 if not double else 0.007
            basin(
                b,
                (hx[0] + 0.002, hx[1] - 0.002),
                (ys[0] + 0.002, ys[1] - 0.002),
                h,
                b.pick("deep", [0.17, 0.2]),
                steel,
                lip,
            )
        if double:
            b.box(
                (hx[0] + 0.002, hx[1] - 0.002), (middle - 0.012, middle + 0.012), (h - 0.03, h + 0.0015), steel, bevel=0
            )
    tap(b, -d / 2 + 0.065, middle, h, metal, total - h, 0.2, square=b.chance("square tap", 0.35))
    edge = (bowls[0][0] - 0.025, bowls[-1][1] + 0.025)
    sides = (("top-right", (y[0] + 0.01, edge[0])), ("top-left", (edge[1], y[1] - 0.01)))
    behind = (("top-right", (y[0] + 0.01, middle - 0.05)), ("top-left", (middle + 0.05, y[1] - 0.01)))
    wide = [(name, ys) for name, ys in sides if ys[1] - ys[0] > 0.11]
    for name, ys in wide or behind:  # a narrow one has its soap beside the tap
        b.surface(name, (-d / 2 + 0.01, d / 2 - 0.014) if wide else (-d / 2 + 0.01, hx[0] - 0.02), ys, h)
    b.fit()


@draws("kitchen_island")
def kitchen_island(b: Builder) -> None:
    """A block of units with a broad top that overhangs at the back for stools."""
    d, w, h = b.size
    looks = _looks(b)
    top = b.material("top", *WORKTOPS)
    t = b.pick("top thickness", [0.03, 0.04, 0.06])
    y = (-w / 2 + 0.03, w / 2 - 0.03)
    deep = min(0.62, d - 0.27)
    x = (d / 2 - 0.027 - deep, d / 2 - 0.027)
    shaker = _shaker(b)
    count = max(2, round(w / 0.65))
    step = (y[1] - y[0]) / count
    with b.solid("body"):
        b.box((x[0] + 0.03, x[1] - 0.07), (y[0] + 0.03, y[1] - 0.03), (0.0, 0.1), "black plastic", bevel=0)
        for k in range(count):
            layout = b.pick(f"layout {k}", ["doors", "drawers", "mixed"])
            span = (y[0] + k * step, y[0] + (k + 1) * step)
            cabinet(b, f"unit-{k}", x, span, (0.1, h - t), layout, looks, shaker)
        # A dressed back: a panel with battens.
        b.box((x[0] - 0.016, x[0]), y, (0.06, h - t), looks[1], bevel=0.001)
        for k in range(count + 1):
            at = min(max(y[0] + k * step, y[0] + 0.03), y[1] - 0.03)
            b.box((x[0] - 0.024, x[0] - 0.0155), (at - 0.03, at + 0.03), (0.06, h - t), looks[1], bevel=0.001)
    with b.solid("top"):
        b.box((-d / 2, d / 2 - 0.004), (-w / 2, w / 2), (h - t, h), top, bevel=0.004)
    b.clear((-d / 2, x[0] - 0.03), y, (0.0, h - t - 0.005))
    b.surface("top", (-d / 2 + 0.015, d / 2 - 0.019), (-w / 2 + 0.015, w / 2 - 0.015), h)
    b.fit()


@draws("kitchen_cart")
def kitchen_cart(b: Builder) -> None:
    """A butcher's block on four posts and castors with a drawer, two slatted shelves and a towel bar."""
    d, w, h = b.size
    wood = b.material("top", "beech", "oak", "bamboo", "birch", "walnut")
    frame = b.material("frame", "white paint", "oak", "black steel", "birch", "sage paint")
    metal = b.material("metal", "steel", "black steel")
    t, p = 0.036, 0.04
    bar = 0.05
    x, y = (-d / 2 + 0.02, d / 2 - 0.045), (-w / 2 + 0.02, w / 2 - bar - 0.02)
    for px in (x[0], x[1] - p):
        for py in (y[0], y[1] - p):
            b.box((px, px + p), (py, py + p), (0.075, h - t), frame)
    with b.solid("top"):
        b.box((-d / 2, d / 2 - 0.025), (-w / 2, w / 2 - bar), (h - t, h), wood, bevel=0.004)
        inner = (y[0] + p, y[1] - p)
        b.box((x[0] + 0.01, x[0] + 0.028), inner, (h - t - 0.15, h - t), frame, bevel=0)
        for ys in ((y[0] + 0.01, y[0] + 0.028), (y[1] - 0.028, y[1] - 0.01)):
            b.box((x[0] + p, x[1] - p), ys, (h - t - 0.15, h - t), frame, bevel=0)
        b.box((x[0] + 0.03, x[1] - 0.02), inner, (h - t - 0.15, h - t - 0.14), frame, bevel=0)
        fronts(b, "unit", x[1] - 0.021, inner, (h - t - 0.15, h - t), "drawer", frame, metal, "knob")
        yb = w / 2 - 0.01
        b.bar((x[0] + 0.03, yb, h - 0.08), (x[1] - 0.03, yb, h - 0.08), 0.009, metal, 8)
        for px in (x[0] + 0.05, x[1] - 0.05):
            b.bar((px, y[1] - 0.005, h - 0.08), (px, yb, h - 0.08), 0.006, metal, 8)
    zs = (0.14, 0.14 + (h - t - 0.15 - 0.14) * 0.5)
    for k, z in enumerate(zs):
        with b.solid(f"shelf {k}"):
            b.box((x[0] + 0.005, x[1] - 0.005), (y[0] + 0.004, y[1] - 0.004), (z - 0.02, z), wood, bevel=0.002)
        up = (zs[1] - 0.02 if k == 0 else h - t - 0.15) - z - 0.01
        b.surface(f"shelf-{k}", (x[0] + 0.045, x[1] - 0.045), (y[0] + 0.045, y[1] - 0.045), z, headroom=round(up, 3))
    with b.solid("shelf 0"):
        castors(b, (x[0] + p / 2, x[1] - p / 2), (y[0] + p / 2, y[1] - p / 2), 0.0755)
    b.surface("top", (-d / 2 + 0.01, d / 2 - 0.035), (-w / 2 + 0.01, w / 2 - bar - 0.01), h)
    b.fit()
