"""What hangs, is strung up, worn or rolled: braids of onions, bundles of herbs, bunting, boas, gowns, wigs, maps."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from .small_paper import pencil, ruled
from .small_parts import GOLDEN

FLAGS = "red fabric, mustard fabric, blue fabric, green fabric, rose fabric, white fabric"


def _sag(box: Box, count: int, swags: int = 1) -> np.ndarray:
    """Points [N, 3] of a string along y that hangs down between its ends and ``swags - 1`` places between these."""
    t = np.linspace(0.0, 1.0, count)
    fall = np.abs(np.sin(math.pi * swags * t))
    x, y, z = box.center[0], box.y[0] + t * box.width, box.z[1] - 0.004 - fall * 0.45 * box.height
    return np.c_[np.full(count, x), y, z]


@draws("onion_braid", whole=True)
def onion_braid(d: Drawing) -> None:
    """Onions, or heads of garlic, plaited on their stalks and hung up by a loop."""
    box = d.bounds
    skin = d.material("onions", "terracotta pigment, ochre pigment, plum pigment, ivory silk")
    stalk = d.material("stalks", "sand pigment")
    x, y, _ = box.center
    top = box.z[1] - 0.03
    for s in (-1, 1):
        t = np.linspace(0, 1, 19)
        d.sweep(np.c_[x + 0.012 * np.cos(14 * t), y + s * 0.012 * np.sin(14 * t), top - t * 0.9 * (top - box.z[0])],
                0.009, stalk, 6)  # fmt: skip
    d.hoop(Box.around((x, y, top + 0.008), 0.0, 0.04, 0.04), 0.004, stalk, "x", 10)
    size, count = min(0.075, 0.5 * box.width), max(9, round(box.height / 0.034))
    for k in range(count):
        low = box.z[0] + size / 2 + k / count * 0.78 * box.height
        out = (0.5 * box.width - size / 2) * (1.0 - 0.35 * k / count)
        a = GOLDEN * k
        at = (x + min(out, 0.5 * box.depth - size / 2) * math.cos(a), y + out * math.sin(a), low)
        d.ball(Box.around(at, size, size, 0.94 * size), skin, 12)
        d.bar((at[0], at[1], low + 0.4 * size), (x, y, low + 0.9 * size), 0.004, stalk, 5)
    d.fit()


@draws("herb_bundle", whole=True)
def herb_bundle(d: Drawing) -> None:
    """Dried herbs or flowers tied at their stalks and hung with their heads down."""
    box = d.bounds
    leaf = d.material("leaves", "moss pigment, forest pigment, silver leaf")
    stalk, heads = (
        d.material("stalks", "bark"),
        d.pick("heads", ["plum pigment", "moss pigment", "silver leaf", "ochre pigment"]),
    )
    x, y, _ = box.center
    mid, knot = (x, y), box.z[1] - 0.3 * box.height
    d.bar((x, y, knot), (x, y, box.z[1] - 0.002), 0.0015, "jute", 5)
    d.cylinder(Box.sized(0.03, 0.03, 0.025, (x, y, knot - 0.012)), "jute", segments=12)
    for k in range(22):
        a, out = GOLDEN * k, ((k + 0.5) / 22) ** 0.5
        low = box.z[0] + 0.05 + 0.06 * d.uniform(f"low {k}", 0, 1)
        end = (
            mid[0] + out * (box.depth / 2 - 0.03) * math.cos(a),
            mid[1] + out * (box.width / 2 - 0.03) * math.sin(a),
            low,
        )
        start = (mid[0] + 0.006 * math.cos(a), mid[1] + 0.006 * math.sin(a), knot + 0.06)
        d.bar(start, end, 0.0016, stalk, 5)
        for j, t in enumerate((0.45, 0.6, 0.75, 0.9, 1.0)):  # its leaves, larger towards its end
            x, y, z = (s + t * (e - s) for s, e in zip(start, end, strict=True))
            wide = 0.022 + 0.008 * (j % 2)
            d.ball(Box.around((x, y, z), wide, wide, 0.05), heads if j > 2 and k % 3 == 0 else leaf, 6)
    d.fit()


@draws("bunting", whole=True)
def bunting(d: Drawing) -> None:
    """Triangles of cloth in turn of colour on a string that sags."""
    box = d.bounds
    string = _sag(box, 25, max(1, round(box.width / 1.8)))
    d.sweep(string, 0.004, "white cotton", 5)
    looks = FLAGS.split(", ")
    d.material("flags", FLAGS)
    first = d.integer("first", 0, 5)
    count = max(5, round(box.width / 0.2))
    tall = 0.5 * box.height
    for k in range(count):
        y = box.y[0] + (k + 0.5) / count * box.width
        z = float(np.interp(y, string[:, 1], string[:, 2]))
        half = 0.42 * box.width / count
        look = looks[(first + k) % len(looks)]
        d.extrude(
            [(y - half, z), (y, z - tall), (y + half, z)],
            (box.center[0] - 0.002, box.center[0] + 0.002),
            look,
            axis="x",
        )
    d.fit()


@draws("paper_chain", whole=True)
def paper_chain(d: Drawing) -> None:
    """Rings of coloured paper linked to a chain that sags."""
    box = d.bounds
    looks = ["red paint", "yellow paint", "green paint", "blue paint", "pink plastic"]
    d.material("rings", ", ".join(looks))
    count = max(9, round(box.width / 0.075))
    path = _sag(box.inset(y=0.04, top=0.045), count, max(1, round(box.width / 1.8)))
    for k, (x, y, z) in enumerate(path.tolist()):
        wide = 0.055
        with d.convex(), d.at(x, y, z, yaw=0.0 if k % 2 else math.pi / 2, pitch=0.0 if k % 2 else 0.2):
            t = np.linspace(0, 2 * math.pi, 13)[:-1]
            d.sweep(
                np.c_[np.zeros(12), 0.8 * wide * np.cos(t), 0.6 * wide * np.sin(t)],
                (0.022, 0.003),
                looks[k % 5],
                closed=True,
            )
    d.fit()


@draws("garland", "wreath", whole=True)
def garland(d: Drawing) -> None:
    """Leaves and berries along a string that sags, or around a ring."""
    box = d.bounds
    leaf = d.material("leaves", "leaf, dark leaf, forest pigment")
    berry = d.pick("berries", ["red paint", "gold", "white petal", "ochre pigment"])
    round_ = d.category.name == "wreath"
    thick = 0.42 * box.depth if round_ else min(0.05, 0.4 * box.depth)
    if round_:
        r = 0.5 * min(box.width, box.height) - 1.6 * thick
        t = np.linspace(0, 2 * math.pi, 61)[:-1]
        y, z = box.center[1] + r * np.cos(t), box.center[2] + r * np.sin(t)
        path = np.c_[np.full(60, box.center[0]), y, z]
    else:
        path = _sag(box.inset(y=0.05, top=0.05), max(40, round(box.width / 0.03)), max(1, round(box.width / 1.8)))
    d.sweep(path, 0.3 * thick, "bark", 6, closed=round_)
    for k, at in enumerate(path.tolist()):
        with d.convex():
            for j in range(3):
                a = GOLDEN * (3 * k + j)
                out = (abs(math.cos(a)) - 0.3, 1.3 * math.sin(a), 1.3 * math.cos(1.7 * a))
                tip = (at[0] + thick * out[0], at[1] + thick * out[1], at[2] + thick * out[2])
                x, y, z = ((p + q) / 2 for p, q in zip(at, tip, strict=True))
                side = 0.35 * thick
                middle = [(x + e, y + s * side, z - s * side) for s in (-1, 1) for e in (0.0, 0.004)]
                d.hull([at, tip, *middle], leaf)
        if k % 4 == 0:
            d.ball(Box.around((at[0] + 0.8 * thick, at[1], at[2] + 0.3 * thick), *[0.55 * thick] * 3), berry, 8)
    if round_:
        x, y, z = box.center[0] + thick, box.center[1], box.z[0] + 1.7 * thick
        red = d.pick("bow", ["red fabric", "white fabric", "green fabric"])
        for s in (-1, 1):
            wide = [(x + e, y + s * 0.2 * box.width, z + u) for e in (-0.01, 0.015) for u in (-0.02, 0.05)]
            d.hull([(x - 0.01, y, z), (x + 0.015, y, z), *wide], red)
    d.fit()


@draws("feather_boa", whole=True)
def feather_boa(d: Drawing) -> None:
    """A boa of fluffy feathers that hangs double over what holds it."""
    box = d.bounds
    look = d.material("feathers", "pink petal, purple petal, red petal, white petal, black fabric, teal paint")
    r = 0.24 * box.width
    path = [(box.y[0] + r, box.z[0] + r + 0.12 * box.height), (box.y[0] + r, 0.6 * box.height),
            (box.center[1] - 0.4 * r, box.z[1] - 1.5 * r), (box.center[1] + 0.4 * r, box.z[1] - 1.5 * r),
            (box.y[1] - r, 0.6 * box.height), (box.y[1] - r, box.z[0] + r)]  # fmt: skip
    line = np.array([(box.center[0], y, z) for y, z in path])
    far = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    count = max(14, round(far[-1] / 0.03))
    at = np.array([np.interp(np.linspace(0, far[-1], count), far, line[:, k]) for k in range(3)]).T
    d.sweep(at, 0.35 * r, look, 6)
    for k, (x, y, z) in enumerate(at.tolist()):
        with d.convex():
            for j in range(7):
                a = 2 * math.pi * (j / 7) + 0.6 * k
                out = (min(0.48 * box.depth, r) * math.cos(a), r * math.sin(a))
                side = 0.22 * r
                tip = (x + out[0], y + out[1], z - 0.5 * r + 0.6 * r * math.sin(2.1 * a))
                sides = [
                    (x + 0.6 * out[0] + s * side, y + 0.6 * out[1] - s * side, z + 0.05 * r * (1 - s)) for s in (-1, 1)
                ]
                d.hull([(x, y, z), (x, y, z + 0.3 * r), tip, *sides], look)
    d.fit()


@draws("gown", whole=True)
def gown(d: Drawing) -> None:
    """A long gown on a hanger: narrow bodice, sash, a wide skirt in folds, of some with sequins."""
    cloth = d.material(
        "cloth", "red fabric, rose fabric, navy fabric, green velvet, gold, silver, black fabric, plum pigment"
    )
    box = d.bounds
    x, y, _ = box.center
    top = box.z[1] - 0.1
    rows = [
        (0.0, 0.26, 0.3),
        (0.08, 0.42, 0.5),
        (0.18, 0.44, 0.6),
        (0.3, 0.3, 0.42),
        (0.36, 0.36, 0.5),
        (0.6, 0.66, 0.8),
        (1.0, 1.0, 1.0),
    ]
    turns = np.linspace(0, 2 * math.pi, 33)[:-1]
    rings = []
    for share, wide, deep in rows[::-1]:
        fold = 1.0 - (0.12 * max(0.0, share - 0.36)) * (1 + np.sin(9 * turns))
        z = box.z[0] + (1 - share) * (top - box.z[0])
        rings.append(
            np.c_[
                x + 0.5 * box.depth * deep * fold * np.cos(turns),
                y + 0.5 * box.width * wide * fold * np.sin(turns),
                np.full(32, z),
            ]
        )
    d.loft(rings, cloth)
    waist = box.z[0] + 0.68 * (top - box.z[0])
    d.cylinder(
        Box.around((x, y, waist), 0.46 * box.depth, 0.34 * box.width, 0.05),
        d.pick("sash", ["gold", "black fabric", "white fabric"]),
        segments=20,
    )
    with d.mirror("y"):
        d.bar((x, y + 0.1 * box.width, top - 0.02), (x, y + 0.02, top + 0.02), (0.012, 0.006), cloth)
        d.bar((x, y, top + 0.03), (x, y + 0.2 * box.width, top - 0.01), 0.007, "oak", 6)
    d.bar((x, y, top + 0.02), (x, y, box.z[1] - 0.03), 0.003, "chrome", 6)
    d.arch((x, y, box.z[1] - 0.03), (x, y + 0.04, box.z[1] - 0.03), (0, 0, 0.024), 0.003, "chrome")
    with d.no_colliders():
        for k in range(40):
            a, share = GOLDEN * k, 0.08 + 0.9 * k / 40
            wide, deep = (float(np.interp(share, [q[0] for q in rows], [q[n] for q in rows])) for n in (1, 2))
            shrink = 1.0 - (0.12 * max(0.0, share - 0.36)) * (1 + math.sin(9 * a))
            at = (x + 0.5 * box.depth * deep * shrink * math.cos(a), y + 0.5 * box.width * wide * shrink * math.sin(a),
                  box.z[0] + (1 - share) * (top - box.z[0]))  # fmt: skip
            d.ball(Box.around(at, 0.009, 0.009, 0.009), "silver", 6)
    d.fit()


@draws("wig_head", whole=True)
def wig_head(d: Drawing) -> None:
    """A wig with long locks on a plain head and a foot."""
    box = d.bounds
    hair = d.material("hair", "mustard fabric, chocolate, bark, black fabric, rust fabric, pink plastic, icing, copper")
    head = d.material("head", "white plastic, skin tone, cream ceramic")
    x, y, _ = box.center
    d.cylinder(box.share(x=(0.25, 0.75), y=(0.28, 0.72), z=(0.0, 0.05)), head, bevel=0.003)
    d.cylinder(box.share(x=(0.38, 0.6), y=(0.4, 0.6), z=(0.05, 0.36)), head)
    d.ball(box.share(x=(0.26, 0.9), y=(0.25, 0.75), z=(0.3, 0.94)), head, 18)
    d.hull(
        [box.point(*p) for p in ((0.86, 0.46, 0.56), (0.86, 0.54, 0.56), (0.95, 0.5, 0.57), (0.88, 0.5, 0.68))], head
    )
    d.ball(box.share(x=(0.06, 0.8), y=(0.14, 0.86), z=(0.62, 1.0)), hair, 18)
    style = d.pick("style", ["long", "bob", "curls"])
    end = {"long": 0.06, "bob": 0.36, "curls": 0.22}[style]
    for k in range(15):
        a = math.pi * (0.32 + 1.36 * k / 14)
        px, py = 0.44 + 0.36 * math.cos(a), 0.5 + 0.38 * math.sin(a)
        low = end + 0.05 * d.uniform(f"low {k}", 0, 1)
        if style == "curls":
            for j in range(7):
                z = 0.84 - j * (0.84 - low) / 7
                d.ball(Box.around(box.point(px + 0.03 * math.sin(2.4 * j), py, z), 0.05, 0.05, 0.045), hair, 8)
            continue
        t = np.linspace(0, 1, 7)
        lock = [
            box.point(px + 0.02 * math.sin(9 * s + k), py + 0.03 * math.sin(8 * s + k), 0.86 - s * (0.86 - low))
            for s in t.tolist()
        ]
        d.sweep(lock, 0.022, hair, 7)
    for k in range(5):
        a = -0.9 + 0.45 * k
        d.sweep(
            [
                box.point(0.5, 0.5 + 0.1 * a, 0.985),
                box.point(0.78, 0.5 + 0.26 * a, 0.9),
                box.point(0.86, 0.5 + 0.36 * a, 0.74),
            ],
            0.02,
            hair,
            7,
        )
    d.fit()


@draws("sock_pair", whole=True)
def sock_pair(d: Drawing) -> None:
    """Socks that lie flat, with ribbed cuffs, toes and heels of another colour."""
    box = d.bounds
    tip = d.pick("tip", ["charcoal fabric", "red fabric", "white fabric", "mustard fabric"])
    look = d.material("socks", "grey fabric, navy fabric, red fabric, white fabric, green fabric, mustard fabric")
    sock = [
        (0.02, 0.06),
        (0.02, 0.44),
        (0.52, 0.42),
        (0.66, 0.62),
        (0.8, 0.94),
        (0.95, 0.96),
        (0.98, 0.78),
        (0.88, 0.36),
        (0.72, 0.04),
        (0.5, 0.02),
    ]
    for k in range(2):
        with d.at(0.0, (0.19 if k else -0.25) * box.width, 0.0, yaw=0.22 * (2 * k - 1)):
            own = Box.sized(0.86 * box.depth, 0.56 * box.width, (0.6 + 0.4 * k) * box.height)
            d.silhouette(own, sock, look, "z", bevel=0.2 * own.height)
            for x, y in (((0.02, 0.16), (0.06, 0.44)), ((0.84, 0.97), (0.72, 0.94))):
                d.box(own.share(x, y).inset(z=-0.0008), tip, 0.001)
    d.fit()


@draws("fabric_stack", whole=True)
def fabric_stack(d: Drawing) -> None:
    """Folded fabrics in a pile, each of another colour, their folds to the front."""
    looks = [
        "red fabric",
        "rust fabric",
        "mustard fabric",
        "green fabric",
        "blue fabric",
        "navy fabric",
        "rose fabric",
        "white fabric",
    ]
    d.material("cloth", ", ".join(looks))
    first = d.integer("first", 0, 7)
    layers = d.bounds.rows(max(4, round(d.size.height / 0.024)))
    for k, layer in enumerate(layers):
        less = d.uniform(f"less {k}", 0.0, 0.012)
        own = layer.inset(back=less, y=less, bottom=-0.001)
        d.cushion(own, looks[(first + k) % 8], 0.48 * layer.height, 0.0)
        d.print(own.front(0.0).share(y=(0.04, 0.96), z=(0.46, 0.52)), "charcoal fabric")
    d.fit()


@draws("notice", whole=True)
def notice(d: Drawing) -> None:
    """A sheet with a heading and a table, held by four pins."""
    box = d.bounds
    sheet = d.box(box.share(x=(0.0, 0.2)), d.material("paper", "paper, cream paint, yellow paint"), 0.0)
    face = sheet.front(0.0)
    d.print(
        face.share(y=(0.12, 0.88), z=(0.84, 0.92)),
        d.pick("ink", ["ink pigment", "red paint", "blue paint", "green paint"]),
    )
    rows, columns = d.integer("rows", 6, 8), d.integer("columns", 3, 5)
    table = face.share(y=(0.1, 0.9), z=(0.08, 0.78))
    for k in range(rows + 1):
        z = k / rows
        d.print(table.share(z=(max(0, z - 0.006), min(1, z + 0.006))), "grey paint")
    for k in range(columns + 1):
        y = k / columns
        d.print(table.share(y=(max(0, y - 0.008), min(1, y + 0.008))), "grey paint")
    for r in range(rows):
        for c in range(columns):
            if d.chance(f"{r} {c}", 0.7):
                long = d.uniform(f"w {r} {c}", 0.5, 0.8)
                d.print(
                    table.share(
                        y=((c + 0.15) / columns, (c + long) / columns), z=((r + 0.35) / rows, (r + 0.65) / rows)
                    ),
                    "night pigment",
                )
    for y in (0.06, 0.94):
        for z in (0.05, 0.96):
            pin = d.pick(f"pin {y} {z}", ["red plastic", "blue plastic", "yellow plastic"])
            d.cylinder(Box.around(box.point(0.6, y, z), 0.8 * box.depth, 0.011, 0.011), pin, "x", segments=10)


@draws("pencil_on_string", whole=True)
def pencil_on_string(d: Drawing) -> None:
    """A pencil that hangs by a string from a nail."""
    box = d.bounds
    x, y, _ = box.center
    look = d.material("pencil", "yellow plastic, red plastic, green plastic")
    d.cylinder(Box.around((x, y, box.z[1] - 0.007), box.depth, 0.012, 0.012), "steel", "x", segments=10)
    long = min(0.15, 0.4 * box.height)
    t = np.linspace(0, 1, 7)
    d.sweep(
        np.c_[np.full(7, x), y + 0.006 * np.sin(7 * t), box.z[1] - 0.01 - t * (box.height - long)], 0.0012, "jute", 5
    )
    with d.at(x, y, long, roll=math.pi):
        pencil(d, long, 0.0038, look)
    d.fit()


@draws("table_map", whole=True)
def table_map(d: Drawing) -> None:
    """A map on a table: flat with curling corners, half unrolled, or rolled up and tied."""
    box = d.bounds
    how = d.takes("rolled_up", "half_unrolled", "unrolled") or d.pick("how", ["half_unrolled", "unrolled"])
    paper = d.material("paper", "sand pigment, ivory silk, cream paint")
    r = box.height / 2
    if how == "rolled_up":
        with d.at(0, 0, r):
            d.cylinder(Box.around((0, 0, 0), 2 * r, box.width, 2 * r), paper, "y", segments=20)
        for s in (-1, 1):
            d.cylinder(
                Box.around((0, s * 0.5005 * box.width, r), 1.2 * r, 0.002, 1.2 * r),
                "terracotta pigment",
                "y",
                segments=14,
            )
        d.cylinder(Box.around((0, 0, r), 2.06 * r, 0.02, 2.06 * r), "red fabric", "y", segments=20)
        d.fit()
        return
    rolls = [1] if how == "half_unrolled" else [1, -1]
    flat = box.to(z=(0.0, 0.0012)).inset(front=r, back=r if len(rolls) == 2 else 0.0)
    d.box(flat, paper, 0.0)
    for s in rolls:
        small = r if how == "half_unrolled" else 0.55 * r
        x = (flat.x[1] if s > 0 else flat.x[0]) - s * 0.2 * small
        d.cylinder(Box.around((x, 0, small), 2 * small, box.width, 2 * small), paper, "y", segments=18)
        for e in (-1, 1):
            d.cylinder(
                Box.around((x, e * 0.5004 * box.width, small), 1.3 * small, 0.0016, 1.3 * small),
                "terracotta pigment",
                "y",
                segments=14,
            )
    top = flat.top(0.0).inset(x=0.012, y=0.02)
    top = top.inset(front=1.6 * r) if how == "half_unrolled" else top.inset(x=0.7 * r)
    edge = d.pick("edge", ["bark", "ink pigment"])
    for a, b in (((0, 0.012), (0, 1)), ((0.988, 1), (0, 1)), ((0, 1), (0, 0.008)), ((0, 1), (0.992, 1))):
        d.print(top.share(a, b), edge, 0.0003)
    d.print(top.inset(x=0.006, y=0.008), d.pick("sea", ["sky pigment", "sea pigment", "silver leaf"]), 0.0002)
    for k, (x, y, w, h) in enumerate(
        ((0.3, 0.3, 0.34, 0.28), (0.62, 0.66, 0.3, 0.34), (0.24, 0.76, 0.2, 0.2), (0.74, 0.22, 0.16, 0.14))
    ):
        land = top.share(x=(max(0.02, x - w / 2), min(0.98, x + w / 2)), y=(max(0.02, y - h / 2), min(0.98, y + h / 2)))
        d.print(
            land, ("sand pigment", "ochre pigment", "moss pigment", "sand pigment")[k], 0.0003 + 0.00002 * k, oval=True
        )
        d.print(land.share(x=(0.3, 0.85), y=(0.1, 0.5)), "moss pigment", 0.0004, oval=True)
    for k in range(7):
        at = top.share(x=(0.2 + 0.08 * k, 0.23 + 0.08 * k), y=(0.32 + 0.05 * k, 0.335 + 0.05 * k))
        d.print(at, "red paint", 0.00045)
    rose = top.share(x=(0.74, 0.94), y=(0.8, 0.96))
    for turn in (0.0, 0.5):
        star = [(1.0 if k % 2 == 0 else 0.2, turn + k * math.pi / 4) for k in range(8)]
        plan = [rose.point(0.5 + 0.5 * q * math.cos(a), 0.5 + 0.5 * q * math.sin(a)) for q, a in star]
        with d.no_colliders():
            d.extrude(
                [(p[0], p[1]) for p in plan], (top.z[0], top.z[0] + 0.0004), "ink pigment" if turn == 0 else "red paint"
            )
    d.fit()


@draws("pizza_box")
def pizza_box(d: Drawing) -> None:
    """A flat box with a printed lid on a hinge, a pizza in it of which a slice is gone."""
    box, wall = d.bounds, 0.003
    card = d.material("card", "cardboard, white paint")
    ink = d.pick("ink", ["red paint", "green paint"])
    with d.part("box"):
        d.box(box.bottom(wall), card, 0.0)
        tray = box.inset(top=wall)
        for side in (tray.left(wall), tray.right(wall), tray.front(wall), tray.back(wall)):
            d.box(side, card, 0.0)
        size = 0.9 * min(box.depth, box.width)
        base = Box.sized(size, size, 0.4 * box.height, (0, 0, wall))
        d.cylinder(base, "bread crust", bevel=0.004, segments=32)
        d.cylinder(base.place(0.88 * size, 0.88 * size).share(z=(0.0, 1.16)), "cheese", segments=32)
        for k in range(9):
            a, out = GOLDEN * k, 0.38 * size * ((k + 0.5) / 9) ** 0.5
            at = Box.sized(0.045, 0.045, 0.0004, (out * math.cos(a), out * math.sin(a), base.z[0] + 1.16 * base.height))
            d.cylinder(at, "tomato", segments=12)
    with (
        d.hinge("lid", (box.x[0], 0.0, box.z[1] - wall), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.9), role="lid"),
        d.part("lid"),
    ):
        lid = d.box(box.top(wall), card, 0.0).top(0.0)
        d.print(lid.share(x=(0.16, 0.3), y=(0.2, 0.8)), ink)
        d.print(lid.place(0.42 * box.depth, 0.42 * box.depth).move(x=0.06), ink, oval=True)
        d.print(lid.place(0.34 * box.depth, 0.34 * box.depth).move(x=0.06), "yellow paint", 0.0004, oval=True)
        d.grasp("edge", (box.x[1], 0.0, box.z[1]), (-1, 0, 0), (0, 0, 1), width=wall, length=0.1)


@draws("bin_bag", whole=True)
def bin_bag(d: Drawing) -> None:
    """A full bag of thin plastic, tied at its neck, with bulges and creases."""
    box = d.bounds
    look = d.material("bag", "black plastic, black plastic, grey plastic, blue plastic")
    turns = np.linspace(0, 2 * math.pi, 25)[:-1]
    a = d.uniform("a", 0, 6)
    rings = []
    for r, z in (
        (0.72, 0.0),
        (0.94, 0.1),
        (1.0, 0.3),
        (0.92, 0.52),
        (0.66, 0.7),
        (0.26, 0.82),
        (0.12, 0.86),
        (0.16, 0.92),
        (0.3, 1.0),
    ):
        wave = r * (1 - 0.09 * (1 + np.sin(5 * turns + a + 3 * z)) * (0.4 + 0.6 * z))
        rings.append(
            np.c_[
                0.5 * box.depth * wave * np.cos(turns),
                0.5 * box.width * wave * np.sin(turns),
                np.full(24, z * box.height),
            ]
        )
    d.loft(rings, look)
    d.cylinder(
        Box.around((0, 0, 0.865 * box.height), 0.15 * box.depth, 0.15 * box.width, 0.02), "yellow plastic", segments=12
    )
    d.fit()


@draws("bedroll", whole=True)
def bedroll(d: Drawing) -> None:
    """A sleeping bag or blanket rolled up, held by two straps."""
    box = d.bounds
    cloth = d.material("cloth", "green fabric, rust fabric, navy fabric, grey fabric, red fabric")
    r = box.height / 2
    d.cylinder(Box.around((0, 0, r), box.depth, box.width, box.height), cloth, "y", bevel=0.2 * r, segments=26)
    for s in (-1, 1):
        d.cylinder(
            Box.around((0, s * 0.28 * box.width, r), 1.02 * box.depth, 0.03, 1.02 * box.height),
            "tan leather",
            "y",
            segments=26,
        )
        t = np.linspace(0.4, 7 * math.pi, 60)
        q = (0.42 * min(box.depth, box.height) * t / t[-1])[:, None]
        line = np.c_[q[:, 0] * np.cos(t), np.full(60, s * (0.5 * box.width + 0.0005)), r + q[:, 0] * np.sin(t)]
        with d.no_colliders():
            d.sweep(line, 0.0025, "charcoal fabric", 4)
    d.fit()


@draws("cobweb", whole=True)
def cobweb(d: Drawing) -> None:
    """A web in a corner: threads from its corner, and rings that sag between them."""
    box = d.bounds
    look = d.material("threads", "chalk pigment, silver leaf")
    ends = [(0.02, 1.0 - s) if s > 1 else (s, 0.02) for s in (1.0, 0.72, 0.42)]
    ends = [(1.0, 0.98), (0.96, 0.66), (0.78, 0.34), (0.5, 0.1), (0.16, 0.0), (0.02, 0.04)]
    x = box.center[0]
    spokes = [np.array([box.point(0.5, 0.0, 1.0), box.point(0.5, y, z)]) for y, z in ends]
    for spoke in spokes:
        d.bar(tuple(spoke[0]), tuple(spoke[1]), 0.0016, look, 5)
    for k in range(1, 8):
        t = k / 8
        for a, b in zip(spokes[:-1], spokes[1:], strict=True):
            p, q = a[0] + t * (a[1] - a[0]), b[0] + t * (b[1] - b[0])
            mid = 0.5 * (p + q) + 0.1 * (a[0] - 0.5 * (p + q))
            d.sweep([p, mid, q], 0.0012, look, 5)
    with d.no_colliders():
        d.ball(
            Box.around((x, *spokes[2][0][1:] + 0.5 * (spokes[2][1] - spokes[2][0])[1:]), 0.012, 0.016, 0.02),
            "black plastic",
            8,
        )
    d.fit()


@draws("paper_lantern", whole=True)
def paper_lantern(d: Drawing) -> None:
    """A globe of paper with ribs, on a cord from the ceiling."""
    box = d.bounds
    look = d.material("paper", "white paint, red paint, yellow paint, lit shade")
    ball = box.bottom(min(box.depth, 0.9 * box.height))
    d.ball(ball.inset(x=0.002, y=0.002, z=0.002), look, 22)
    for k in range(1, 8):
        z = k / 8
        r = math.sqrt(max(0.0, 1 - (2 * z - 1) ** 2))
        level = ball.share(z=(z, z))
        d.hoop(
            Box.around(level.center, r * (ball.depth - 0.003), r * (ball.width - 0.003), 0.0), 0.0015, "beech", "z", 24
        )
    x, y, top = ball.anchor("top")
    d.bar((x, y, top - 0.004), (x, y, box.z[1]), 0.002, "black plastic", 6)
    d.fit()


@draws("dirty_dishes", whole=True)
def dirty_dishes(d: Drawing) -> None:
    """Used plates piled askew with crumbs and sauce, a bowl on top, cutlery across and a cup beside."""
    box = d.bounds
    china = d.material("china", "white ceramic, cream ceramic, blue ceramic")
    size = min(box.depth, 0.7 * box.width)
    y0 = box.y[0] + size / 2
    count = 4
    step = 0.1 * box.height
    for k in range(count):
        dx, dy = (0.0, 0.0) if k == 0 else (d.uniform(f"x{k}", -0.012, 0.012), d.uniform(f"y{k}", -0.004, 0.012))
        own = Box.sized(size * (0.94 - 0.05 * k), size * (0.94 - 0.05 * k), 1.6 * step, (dx, y0 + dy, k * step))
        d.turned(
            own,
            [(0.55, 0), (0.62, 0.1), (1.0, 0.8), (1.0, 1.0), (0.7, 0.5), (0.0, 0.4)],
            china,
            28,
            hollow=True,
            holds=False,
        )
    top = (count + 0.4) * step
    bowl = Box.sized(0.55 * size, 0.55 * size, box.height - top, (0.0, y0, top - 0.3 * step))
    d.turned(
        bowl,
        [(0.4, 0), (0.8, 0.4), (1.0, 1.0), (0.92, 1.0), (0.7, 0.45), (0.0, 0.3)],
        china,
        24,
        hollow=True,
        holds=False,
    )
    d.cylinder(
        Box.sized(0.36 * size, 0.36 * size, 0.003, (0, y0, bowl.z[0] + 0.42 * bowl.height)), "tomato", segments=18
    )
    for k in range(9):
        a = GOLDEN * k
        d.ball(
            Box.around(
                (0.34 * size * math.cos(a), y0 + 0.34 * size * math.sin(a), top - 0.1 * step), 0.02, 0.012, 0.006
            ),
            ("tomato", "bread crumb", "coffee")[k % 3],
            6,
        )
    for s, tone in ((-1, "stainless steel"), (1, "stainless steel")):
        d.bar(
            (-0.4 * size, y0 + s * 0.1 * size, top + 0.003),
            (0.42 * size, y0 + s * 0.18 * size, top + 0.02),
            (0.014, 0.003),
            tone,
        )
    cup = Box.sized(0.08, 0.08, 0.085, (0.1 * box.depth, box.y[1] - 0.045, 0.0))
    d.turned(cup, [(0.7, 0), (1, 0.15), (1, 1), (0.92, 1), (0.9, 0.15), (0, 0.1)], china, 20, hollow=True, holds=False)
    with d.no_colliders():
        d.cylinder(Box.sized(0.07, 0.07, 0.002, (*cup.center[:2], 0.02)), "coffee", segments=14)
    d.fit()


@draws("jigsaw_begun", whole=True)
def jigsaw_begun(d: Drawing) -> None:
    """A jigsaw puzzle half laid: a part of the picture joined, the edge begun, loose pieces around."""
    box = d.bounds
    looks = [
        "sky pigment",
        "sky pigment",
        "moss pigment",
        "sea pigment",
        "ochre pigment",
        "forest pigment",
        "blush pigment",
    ]
    d.material("pieces", "sky pigment")
    n, m = 7, 10
    cells = [[cell for cell in row.columns(m)] for row in box.inset(x=0.03, y=0.04).split("x", n)]
    for r in range(n):
        for c in range(m):
            edge = r in (0, n - 1) or c in (0, m - 1)
            laid = (r > 1 and c < 6) or (edge and (c < 8 or r == n - 1))
            look = looks[0 if r < 2 else 2 + (r + c // 3) % 5]
            own = cells[r][c]
            if laid:
                piece = own.inset(x=0.0006, y=0.0006)
                d.box(piece, look, 0.0003)
                if c + 1 < m:
                    d.cylinder(
                        Box.around(
                            (*own.share(y=(1, 1)).center[:2], box.center[2]),
                            0.3 * own.depth,
                            0.3 * own.depth,
                            box.height,
                        ),
                        look,
                        segments=8,
                    )
            elif d.chance(f"loose {r} {c}", 0.45):
                x, y, _ = own.center
                with d.at(
                    x + d.uniform(f"x {r} {c}", -0.01, 0.01),
                    y + d.uniform(f"y {r} {c}", -0.01, 0.01),
                    yaw=d.uniform(f"t {r} {c}", 0, 3),
                ):
                    mine = Box.sized(0.8 * own.depth, 0.7 * own.width, box.height)
                    d.box(mine, d.pick(f"look {r} {c}", looks), 0.0003)
                    d.cylinder(
                        Box.sized(0.3 * own.depth, 0.3 * own.depth, box.height, (0, 0.35 * own.width, 0)),
                        looks[(r + c) % 7],
                        segments=8,
                    )
    d.fit()


@draws("knitting", whole=True)
def knitting(d: Drawing) -> None:
    """A begun piece of knitting on two needles, its thread from a ball of wool."""
    box = d.bounds
    wool = d.material("wool", "rust fabric, mustard fabric, blue fabric, rose fabric, green fabric, cream wool")
    r = 0.5 * min(box.height, 0.4 * box.width)
    ball = Box.around((0.1 * box.depth, box.y[0] + r, r), 2 * r, 2 * r, 2 * r)
    d.ball(ball, wool, 18)
    with d.no_colliders():
        for k in range(9):
            t = np.linspace(0, 2 * math.pi, 17)
            a, q = 0.7 * k, 1.006 * r
            u = np.array([math.cos(a), math.sin(a), 0.0])
            v = np.array([-math.sin(a) * math.cos(0.5 * k), math.cos(a) * math.cos(0.5 * k), math.sin(0.5 * k)])
            d.sweep(np.array(ball.center) + q * (np.cos(t)[:, None] * u + np.sin(t)[:, None] * v), 0.003, wool, 5)
    piece = box.share(x=(0.1, 0.9), y=(0.5, 0.96)).to(z=(0.0, 0.014))
    for k, row in enumerate(piece.split("x", 9)):
        d.cushion(row.inset(top=0.002 * (k % 2)), wool, 0.3 * row.height)
    for s in (-1, 1):
        start = piece.point(0.94, 0.1 if s > 0 else 0.9, 1.4)
        end = (start[0] + 0.05 * s, start[1] + s * 0.52 * box.width, start[2] + 0.01)
        d.bar(start, end, 0.0035, "bamboo", 8)
        d.ball(Box.around(start, 0.012, 0.012, 0.012), "red plastic", 8)
    d.fit()


@draws("hot_water_bottle", whole=True)
def hot_water_bottle(d: Drawing) -> None:
    """A flat rubber bottle with ribs, a neck and a stopper."""
    box = d.bounds
    look = d.material("rubber", "red plastic, blue plastic, green plastic, rubber")
    body = box.share(x=(0.0, 0.8))
    d.cushion(body, look, 0.45 * box.height, 0.5)
    for k in range(7):
        d.box(body.share(x=(0.15, 0.85), y=(0.2 + 0.09 * k, 0.23 + 0.09 * k), z=(0.9, 1.0)).move(z=0.001), look, 0.001)
    d.hull(
        [box.point(x, y, z) for x, w in ((0.74, 0.3), (0.9, 0.1)) for y in (0.5 - w, 0.5 + w) for z in (0.25, 0.75)],
        look,
    )
    d.cylinder(box.share(x=(0.88, 1.0), y=(0.4, 0.6), z=(0.2, 0.8)), "black plastic", "x", segments=14)
    d.fit()


@draws("draped_jacket", whole=True)
def draped_jacket(d: Drawing) -> None:
    """A jacket laid over something: its shoulders over the edge, its sleeves hanging, its lining at the collar."""
    box = d.bounds
    cloth = d.material("cloth", "navy fabric, charcoal fabric, tan suede, green fabric, brown leather, black leather")
    across = np.linspace(-1, 1, 15)
    for back in (False, True):
        rows = []
        for share, wide in ((0.0, 0.72), (0.06, 0.94), (0.5, 0.86), (1.0, 0.9)):
            out = (0.5 if not back else -0.5) * box.depth * (0.35 + 0.55 * min(1.0, 3 * share))
            wave = 0.006 * np.sin(6 * across + 2 * share)
            drop = share * box.height
            rows.append(
                np.c_[
                    out + wave,
                    0.5 * wide * box.width * across,
                    box.z[1] - 0.004 - drop - 0.02 * np.abs(across) * (share == 0),
                ]
            )
        grid = np.array(rows)
        d.sheet(grid if not back else grid[:, ::-1], 0.012, cloth, (1, 3))
    d.bar(
        (0, -0.36 * box.width, box.z[1] - 0.012),
        (0, 0.36 * box.width, box.z[1] - 0.012),
        (0.36 * box.depth, 0.02),
        cloth,
    )
    with d.mirror("y"):
        y = 0.44 * box.width
        path = [
            (0.1 * box.depth, y - 0.02, box.z[1] - 0.04),
            (0.3 * box.depth, y + 0.01, 0.7 * box.height),
            (0.34 * box.depth, y, 0.42 * box.height),
            (0.36 * box.depth, y - 0.01, 0.18 * box.height),
        ]
        d.sweep(path, (0.05, 0.09), cloth)
        d.hull(
            [
                (0.46 * box.depth, 0.02, box.z[1] - 0.02),
                (0.5 * box.depth, 0.1, box.z[1] - 0.05),
                (0.5 * box.depth, 0.02, box.z[1] - 0.22),
                (0.4 * box.depth, 0.12, box.z[1] - 0.01),
            ],
            "charcoal fabric",
        )
    d.fit()


@draws("brick_stack", "tile_stack", whole=True)
def brick_stack(d: Drawing) -> None:
    """Bricks or tiles stacked crosswise, the top row begun."""
    box = d.bounds
    tiles = d.category.name == "tile_stack"
    look = d.material(
        "body", "white ceramic, blue ceramic, terracotta, grey ceramic" if tiles else "terracotta, rust fabric"
    )
    high = 0.009 if tiles else 0.065
    layers = box.rows(max(2, round(box.height / high)))
    for k, layer in enumerate(layers):
        if tiles:
            d.box(layer.inset(x=d.uniform(f"x{k}", 0, 0.006), y=d.uniform(f"y{k}", 0, 0.006), top=0.0005), look, 0.0008)
            continue
        axis, n = ("y", max(2, round(box.width / 0.11))) if k % 2 else ("x", max(2, round(box.depth / 0.11)))
        for j, cell in enumerate(layer.split(axis, n)):
            if k < len(layers) - 1 or j < n / 2:
                d.box(cell.inset(x=0.003, y=0.003, top=0.002 * (k < len(layers) - 1)), look, 0.003)
    d.fit()


@draws("open_letter", "banknotes", whole=True)
def sheets_that_lie(d: Drawing) -> None:
    """A letter unfolded with lines of script on its envelope, or banknotes fanned out."""
    box = d.bounds
    if d.category.name == "open_letter":
        sheet = d.material("paper", "paper, cream paint")
        d.box(
            box.share(x=(0.3, 0.95), y=(0.45, 1.0), z=(0.0, 0.5)),
            d.pick("envelope", ["sand pigment", "white paint", "sky pigment"]),
            0.0,
        )
        with d.at(yaw=0.18):
            page = d.box(
                Box.sized(0.8 * box.depth, 0.6 * box.width, box.height)
                .inset(bottom=0.5 * box.height)
                .move(y=-0.1 * box.width),
                sheet,
                0.0,
            )
            ruled(d, page.top(0.0), 12, "night pigment", head=False)
        d.fit()
        return
    note = d.material("notes", "silver leaf, moss pigment, blush pigment, sky pigment")
    for k in range(7):
        with d.at(0, 0, 0, yaw=-0.5 + 0.16 * k):
            own = Box.sized(0.07, 0.15, box.height / 7, (0.0, 0.012 * (k - 3), k * box.height / 7))
            top = d.box(own, note, 0.0).top(0.0)
            d.print(top.place(0.05, 0.05), "forest pigment", 0.0001, oval=True)
            d.print(top.share(x=(0.1, 0.3), y=(0.06, 0.2)), "forest pigment", 0.0001)
    d.fit()


@draws("open_umbrella", whole=True)
def open_umbrella(d: Drawing) -> None:
    """An open umbrella that stands on the rim of its cloth and the end of its stick."""
    box = d.bounds
    cloth = d.material("cloth", "black fabric, navy fabric, red fabric, green fabric, charcoal fabric")
    wood = d.material("handle", "walnut, oak, black plastic")
    with d.at(pitch=0.8):
        turns = np.linspace(0, 2 * math.pi, 17)
        rows = []
        for share in (0.05, 0.35, 0.7, 1.0):
            r = 0.5 * share * box.width * (1 - 0.08 * share * np.abs(np.sin(4 * turns)))
            rows.append(
                np.c_[r * np.cos(turns), r * np.sin(turns), np.full(17, 0.3 * box.width * math.cos(1.35 * share))]
            )
        d.sheet(np.array(rows), 0.005, cloth, (1, 8))
        for k in range(8):
            a = 2 * math.pi * (k + 0.5) / 8
            end = (0.48 * box.width * math.cos(a), 0.48 * box.width * math.sin(a), 0.07 * box.width)
            d.bar((0, 0, 0.28 * box.width), end, 0.0025, "steel", 5)
        top = 0.38 * box.width
        d.bar((0, 0, -0.4 * box.width), (0, 0, top), 0.006, "steel", 8)
        d.bar((0, 0, -0.44 * box.width), (0, 0, -0.34 * box.width), 0.013, wood, 10)
    d.fit()


@draws("open_newspaper", whole=True)
def open_newspaper(d: Drawing) -> None:
    """A newspaper opened flat: two pages with headlines, pictures and columns, their fold between."""
    box = d.bounds
    look = d.material("body", "paper")
    with d.mirror("y"):
        page = d.box(box.share(y=(0.502, 1.0)), look, 0.0).top(0.0)
        d.print(page.share((0.05, 0.11), (0.08, 0.9)), "ink pigment")
        d.print(
            page.share((0.15, 0.42), (0.08, 0.5)), d.pick("photo", ["night pigment", "sea pigment", "plum pigment"])
        )
        for c in range(4):
            for line in range(16):
                x, y = 0.15 + 0.05 * line, 0.08 + 0.21 * c
                if x > 0.44 or y > 0.5:
                    d.print(page.share((x, x + 0.018), (y, y + 0.18)), "grey paint")
