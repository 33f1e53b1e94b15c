"""Electronics that stand on desks, tables and media furniture."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import Look, decal, dome, hoop, loft, rect, slab, small, spot, target


def window(b: Builder, x: float, y: tuple[float, float], z: tuple[float, float]) -> None:
    """A lit picture on a front at depth x: title bar, a panel, lines of text."""
    w, h = y[1] - y[0], z[1] - z[0]
    xs = (x - 0.001, x)
    decal(b, xs, y, z, "screen")
    for a, c, e, f, look in [
        (0.04, 0.6, 0.1, 0.9, "night pigment"),
        (0.04, 0.6, 0.8, 0.9, "sea pigment"),
        (0.66, 0.96, 0.5, 0.9, "sea pigment"),
        (0.66, 0.96, 0.1, 0.44, "night pigment"),
    ]:
        decal(b, (xs[0], x + 0.0001), (y[1] - c * w, y[1] - a * w), (z[0] + e * h, z[0] + f * h), look)
    for k in range(5):
        decal(
            b,
            (xs[0], x + 0.00015),
            (y[1] - (0.36 + 0.07 * (k * 7 % 3)) * w, y[1] - 0.08 * w),
            (z[0] + (0.66 - 0.11 * k) * h, z[0] + (0.69 - 0.11 * k) * h),
            "sky pigment",
        )


@small("monitor")
def monitor(b: Builder) -> None:
    """A flat screen with a thin frame, a neck and a foot."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "black plastic", "grey plastic", "white plastic", "aluminium")
    stand = b.material("stand", "black plastic", "aluminium", "grey plastic") if b.chance("other stand", 0.5) else look
    tall = min(w * b.uniform("ratio", 0.56, 0.62), h - 0.09)
    z0 = h - tall
    x = 0.12 * d
    slab(b, (x - 0.008, x + 0.012), (-w / 2, w / 2), (z0, h), look, 0.004, 0.002)
    b.hull(
        [(x - 0.007, s * 0.42 * w, z) for s in (-1, 1) for z in (z0 + 0.08 * tall, z0 + 0.85 * tall)]
        + [(x - 0.035, s * 0.25 * w, z) for s in (-1, 1) for z in (z0 + 0.25 * tall, z0 + 0.65 * tall)],
        look,
    )
    decal(b, (x, x + 0.0122), (-w / 2 + 0.008, w / 2 - 0.008), (z0 + 0.016, h - 0.008), "black glass")
    window(b, x + 0.0123, (-w / 2 + 0.01, w / 2 - 0.01), (z0 + 0.02, h - 0.01))
    decal(b, (x, x + 0.0123), (0.44 * w, 0.45 * w), (z0 + 0.006, z0 + 0.01), "lamp glow")
    neck = 0.03 if b.chance("slim", 0.5) else 0.05
    b.hull(
        [
            (px, s * neck, z)
            for s in (-1, 1)
            for px, z in (
                (-0.32 * d, 0.01),
                (-0.2 * d, 0.01),
                (x - 0.03, z0 + 0.55 * tall),
                (x - 0.05, z0 + 0.55 * tall),
            )
        ],
        stand,
    )
    if b.chance("round foot", 0.4):
        n = 24
        t = (np.arange(n) + 0.5) * 2 * np.pi / n
        b.extrude(np.c_[0.5 * d * np.cos(t), min(0.16, 0.28 * w) * np.sin(t)], (0.0, 0.012), stand)
    else:
        slab(b, (-d / 2, d / 2), (-min(0.15, 0.25 * w), min(0.15, 0.25 * w)), (0.0, 0.012), stand, 0.02, 0.003)


@small("laptop")
def laptop(b: Builder) -> None:
    """An open laptop: keys, touch pad, a bright screen that leans back."""
    d, w, h = b.size
    look = b.material("body", "aluminium", "grey plastic", "black plastic", "white plastic")
    keys = b.material("keys", "black plastic", "grey plastic")
    lean = b.uniform("lean", 0.22, 0.42)
    t = 0.014
    panel = (h - 0.008) / np.cos(lean)
    back = (h - 0.008) * np.tan(lean) + 0.006
    x0, x1 = -d / 2 + back, d / 2
    slab(b, (x0, x1), (-w / 2, w / 2), (0.0, t), look, 0.012, 0.003)
    deep = x1 - x0
    kx, ky = (x0 + 0.08 * deep, x0 + 0.56 * deep), (-0.45 * w, 0.45 * w)
    decal(b, kx, ky, (t - 0.002, t + 0.0002), "black steel")
    for i in range(5):
        for j in range(12):
            if i == 4 and 3 <= j <= 7:
                if j == 3:
                    y = ky[0] + 3 * (ky[1] - ky[0]) / 12
                    decal(
                        b,
                        (kx[0] + 4 * (kx[1] - kx[0]) / 5 + 0.002, kx[1] - 0.002),
                        (y + 0.001, y + 5 * (ky[1] - ky[0]) / 12 - 0.001),
                        (t - 0.001, t + 0.0004),
                        keys,
                    )
                continue
            x, y = kx[0] + i * (kx[1] - kx[0]) / 5, ky[0] + j * (ky[1] - ky[0]) / 12
            decal(
                b,
                (x + 0.002, x + (kx[1] - kx[0]) / 5 - 0.001),
                (y + 0.0015, y + (ky[1] - ky[0]) / 12 - 0.001),
                (t - 0.001, t + 0.0004),
                keys,
            )
    decal(b, (x0 + 0.62 * deep, x0 + 0.94 * deep), (-0.17 * w, 0.17 * w), (t - 0.001, t + 0.0003), "grey plastic")
    b.bar((x0 + 0.004, -0.4 * w, t - 0.004), (x0 + 0.004, 0.4 * w, t - 0.004), 0.005, "black plastic", 8)
    with b.frame(x0 + 0.004, 0, 0.008, pitch=-lean):
        b.box((-0.007, 0.0), (-w / 2, w / 2), (0.0, panel - 0.002), look, 0.002)
        decal(b, (-0.002, 0.0002), (-0.485 * w, 0.485 * w), (0.03 * panel, 0.97 * panel), "black glass")
        window(b, 0.0003, (-0.47 * w, 0.47 * w), (0.07 * panel, 0.94 * panel))


@small("keyboard")
def keyboard(b: Builder) -> None:
    """Rows of keys, a block of numbers, on a board that rises to the back."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "white plastic", "grey plastic", "aluminium")
    keys = b.material("keys", "black plastic", "white plastic", "grey plastic", "mint plastic")
    low, key = 0.4 * h, 0.24 * h
    high = h - key - 0.001
    b.hull(
        [(x, y, z) for y in (-w / 2, w / 2) for x, z in ((-d / 2, 0.0), (d / 2, 0.0), (d / 2, low), (-d / 2, high))],
        look,
    )
    tilt = float(np.arctan2(high - low, d))
    rows, cols = 5, 19
    step, pitch = (w - 0.016) / cols, (d - 0.014) / (rows + 0.3)
    accent = b.pick("accent", ["orange plastic", "grey plastic", "teal paint"])
    with b.frame(-d / 2, 0, high, pitch=tilt):
        for i in range(rows):
            x = 0.007 + i * pitch + (0.3 * pitch if i else 0.0)
            j = 0
            while j < cols:
                if j == 14:
                    j += 1
                    continue
                wide = 6 if i == rows - 1 and j == 4 else 2 if (i, j) in ((1, 12), (2, 12), (3, 0), (3, 12)) else 1
                y = -w / 2 + 0.008 + j * step
                c = accent if (i, j) in ((0, 0), (2, 12)) else keys
                decal(b, (x + 0.001, x + pitch - 0.0015), (y + 0.0008, y + wide * step - 0.0008), (-0.001, 0.0004), c)
                b.add(
                    shapes.box((x + 0.0025, x + pitch - 0.003), (y + 0.002, y + wide * step - 0.002), (0.0, key), 0.0),
                    c,
                    [],
                )
                j += wide
        # One part for all keys.
        shape = shapes.box((0.007, d - 0.004), (-w / 2 + 0.007, w / 2 - 0.007), (0.0, key + 0.0002), 0.0)
        b.add(shapes.box((0.01, d - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), (-0.002, 0.0001), 0.0), look, [shape])


@small("mouse")
def mouse(b: Builder) -> None:
    """A rounded mouse with two buttons and a wheel."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "white plastic", "grey plastic", "pink plastic")
    # Its buttons point away from the user, to -x.
    rings = []
    for z, e, f in (
        (0.0, 0.9, 0.86),
        (0.15, 1.0, 1.0),
        (0.45, 0.97, 0.96),
        (0.72, 0.84, 0.8),
        (0.92, 0.56, 0.5),
        (1.0, 0.25, 0.22),
    ):
        t = (np.arange(20) + 0.5) * 2 * np.pi / 20
        rings.append(
            np.c_[
                (0.06 * d * z) + e * d / 2 * np.cos(t),
                f * w / 2 * np.sign(np.sin(t)) * np.abs(np.sin(t)) ** 0.85,
                np.full(20, z * h),
            ]
        )
    loft(b, rings, look, convex=True)
    shape = shapes.hull(np.concatenate(rings))
    normal = np.cross(
        shape[0][shape[1][:, 1]] - shape[0][shape[1][:, 0]], shape[0][shape[1][:, 2]] - shape[0][shape[1][:, 0]]
    )
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    offset = np.einsum("ij,ij->i", normal, shape[0][shape[1][:, 0]])
    up = normal[:, 2] > 0.05

    def roof(x: float, y: float) -> float:
        return float(((offset[up] - normal[up, :2] @ [x, y]) / normal[up, 2]).min())

    xs = np.linspace(-0.44, -0.02, 8) * d
    for a, c in zip(xs[:-1], xs[1:], strict=True):
        za, zc = roof(a, 0), roof(c, 0)
        b.add(
            shapes.hull(
                np.array(
                    [
                        (px, y, z + e)
                        for px, z in ((a, za), (c, zc))
                        for y in (-0.0008, 0.0008)
                        for e in (-0.002, 0.0003)
                    ]
                )
            ),
            "rubber",
            [],
        )
    wx = -0.26 * d
    with b.frame(wx, 0, roof(wx, 0) - 0.006, roll=np.pi / 2):
        b.frustum(0.008, 0.008, (-0.0035, 0.0035), "rubber", 14)


@small("mouse_pad")
def mouse_pad(b: Builder) -> None:
    """A thin mat with round corners and a stitched edge."""
    d, w, h = b.size
    look = b.material(
        "body", "charcoal fabric", "black fabric", "grey fabric", "navy fabric", "brown leather", "green fabric"
    )
    slab(
        b,
        (-d / 2, d / 2),
        (-w / 2, w / 2),
        (0.0, h),
        b.material("edge", "black fabric", "red fabric", "grey fabric"),
        0.015,
        0.0006,
    )
    b.add(
        shapes.extrusion(
            rect((-d / 2 + 0.004, d / 2 - 0.004), (-w / 2 + 0.004, w / 2 - 0.004), 0, 0.012)[:, :2], (h / 2, h + 0.0003)
        ),
        look,
        [],
    )


@small("computer")
def computer(b: Builder) -> None:
    """A tower with a grille or a window, a power button and ports."""
    d, w, h = b.size
    look = b.material("body", "black steel", "white steel", "grey paint", "aluminium")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    for px in (x[0] + 0.06, x[1] - 0.06):
        for s in (-1, 1):
            b.box(
                (px - 0.02, px + 0.02), (s * (w / 2 - 0.03) - 0.015, s * (w / 2 - 0.03) + 0.015), (0.0, 0.015), "rubber"
            )
    b.box((x[0], x[1] - 0.015), y, (0.015, h), look, 0.003)
    b.box((x[1] - 0.015, x[1]), (y[0] + 0.003, y[1] - 0.003), (0.02, h - 0.004), "black plastic", 0.004)
    front = x[1] + 0.0003
    style = b.pick("front", ["mesh", "bars", "lit"])
    if style == "lit":
        r = min(w, 0.33 * h)  # three fans above each other fit the front
        for k in range(3):
            with b.frame(x[1], 0, (0.27 + 0.23 * k) * h, pitch=np.pi / 2):
                b.add(
                    shapes.frustum(0.34 * r, 0.34 * r, (-0.002, 0.0002), 24),
                    b.pick("glow", ["sea pigment", "plum pigment", "red plastic"]),
                    [],
                )
                b.add(shapes.frustum(0.3 * r, 0.3 * r, (-0.002, 0.0003), 24), "black plastic", [])
                for j in range(5):
                    with b.frame(yaw=j * 2 * np.pi / 5):
                        b.add(
                            shapes.box((0.03 * r, 0.28 * r), (-0.03 * r, 0.03 * r), (-0.001, 0.0004)),
                            "grey plastic",
                            [],
                        )
    else:
        n = 14 if style == "bars" else 26
        for k in range(n):
            z = 0.1 * h + 0.58 * h * k / n
            decal(b, (x[1] - 0.002, front), (-0.38 * w, 0.38 * w), (z, z + 0.3 * 0.58 * h / n), "grey plastic")
        for z in (0.8, 0.88):
            decal(b, (x[1] - 0.002, front), (-0.42 * w, 0.42 * w), (z * h, (z + 0.055) * h), "black steel")
            decal(
                b,
                (x[1] - 0.002, front + 0.0001),
                (0.24 * w, 0.36 * w),
                ((z + 0.01) * h, (z + 0.02) * h),
                "grey plastic",
            )
    with b.frame(x[1], -0.32 * w, 0.75 * h, pitch=np.pi / 2):
        b.add(shapes.frustum(0.01, 0.01, (-0.002, 0.0004), 16), "steel", [])
        b.add(shapes.frustum(0.004, 0.004, (-0.002, 0.00045), 12), "lamp glow", [])
    for k in range(3):
        decal(
            b,
            (x[1] - 0.002, front),
            (-0.14 * w + 0.14 * k * w, -0.06 * w + 0.14 * k * w),
            (0.744 * h, 0.756 * h),
            "grey plastic",
        )
    if b.chance("window", 0.5):
        decal(b, (x[0] + 0.1 * d, x[1] - 0.12 * d), (y[1] - 0.002, y[1] + 0.0003), (0.12 * h, 0.92 * h), "black glass")
    for k in range(9):
        decal(
            b,
            (-0.2 * d + 0.04 * k * d, -0.18 * d + 0.04 * k * d),
            (-0.36 * w, 0.36 * w),
            (h - 0.002, h + 0.0003),
            "black plastic",
        )


def _handheld(b: Builder, d: float, w: float, h: float, look: Look, radius: float) -> None:
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), look, radius, 0.0022, 4)
    e = 0.0035
    b.add(
        shapes.extrusion(
            rect((-d / 2 + e, d / 2 - e), (-w / 2 + e, w / 2 - e), 0, radius - e, 4)[:, :2], (h / 2, h + 0.0002)
        ),
        "black glass",
        [],
    )


@small("tablet")
def tablet(b: Builder) -> None:
    """A flat screen with icons, in some in a cover."""
    d, w, h = b.size
    look = b.material("body", "aluminium", "black plastic", "grey plastic", "pink plastic")
    _handheld(b, d, w, h, look, 0.012)
    z = (h - 0.001, h + 0.0003)
    decal(b, (-d / 2 + 0.01, d / 2 - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), z, "screen")
    for i in range(3):
        for j in range(6):
            if b.chance(f"icon {i} {j}", 0.85):
                x, y = (-0.32 + 0.2 * i) * d, (-0.36 + 0.13 * j) * w
                c = b.pick(
                    f"colour {i} {j}",
                    [
                        "sea pigment",
                        "sky pigment",
                        "ochre pigment",
                        "moss pigment",
                        "terracotta pigment",
                        "chalk pigment",
                    ],
                )
                decal(b, (x, x + 0.1 * d), (y, y + 0.065 * w), (h - 0.001, h + 0.0004), c)


@small("phone")
def phone(b: Builder) -> None:
    """A flat phone with icons on its screen."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "aluminium", "blue plastic", "pink plastic", "mint plastic")
    _handheld(b, d, w, h, look, 0.011)
    decal(b, (-d / 2 + 0.008, d / 2 - 0.008), (-w / 2 + 0.006, w / 2 - 0.006), (h - 0.001, h + 0.0003), "screen")
    for i in range(5):
        for j in range(4):
            if i < 4 and not b.chance(f"icon {i} {j}", 0.8):
                continue
            x, y = (-0.3 + 0.15 * i) * d, (-0.38 + 0.2 * j) * w
            c = b.pick(
                f"colour {i} {j}",
                ["sea pigment", "sky pigment", "ochre pigment", "moss pigment", "terracotta pigment", "chalk pigment"],
            )
            decal(b, (x, x + 0.075 * d), (y, y + 0.15 * w), (h - 0.001, h + 0.0004), c)


@small("desk_phone")
def desk_phone(b: Builder) -> None:
    """A landline telephone: sloping body, keys, display, receiver and a curled cord."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "white plastic", "cream paint", "red plastic")
    low, high = 0.3 * h, 0.78 * h
    b.hull(
        [
            (x, y, z)
            for y in (-w / 2, w / 2)
            for x, z in ((-d / 2, 0.0), (d / 2, 0.0), (d / 2, low), (-0.3 * d, high), (-d / 2, high))
        ],
        look,
    )
    tilt = float(np.arctan2(high - low, 0.8 * d))
    with b.frame(d / 2, 0, low, pitch=tilt):
        s = 0.8 * d / np.cos(tilt)
        decal(b, (-0.95 * s, -0.74 * s), (-0.08 * w, 0.44 * w), (-0.002, 0.0003), "pale leaf")
        for i in range(4):
            for j in range(3):
                x, y = (-0.64 + 0.15 * i) * s, (-0.04 + 0.16 * j) * w
                b.box(
                    (x, x + 0.1 * s),
                    (y, y + 0.11 * w),
                    (-0.001, 0.004),
                    "white plastic" if look.name != "white plastic" else "grey plastic",
                    0.001,
                )
        # The receiver lies along x at -y, over two cradles.
        y = -0.3 * w
        for x in (-0.87 * s, -0.13 * s):
            b.box((x - 0.1 * s, x + 0.1 * s), (y - 0.13 * w, y + 0.13 * w), (-0.002, 0.012), look, 0.003)
            b.box((x - 0.12 * s, x + 0.12 * s), (y - 0.14 * w, y + 0.14 * w), (0.012, 0.034), look, 0.01)
        b.box((-0.87 * s, -0.13 * s), (y - 0.1 * w, y + 0.1 * w), (0.022, 0.042), look, 0.008)
    t = np.linspace(0, 1, 11)
    path = np.c_[0.42 * d - 0.1 * d * t, -w / 2 - 0.004 - 0.012 * np.sin(np.pi * t), 0.012 + 0.08 * h * t]
    b.tube(path[::2], 0.004, "black plastic", 6)


@small("headphones")
def headphones(b: Builder) -> None:
    """Headphones that hang on a stand."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "white plastic", "grey plastic", "brown leather", "red plastic")
    pad = b.material("pads", "black leather", "brown leather", "charcoal fabric")
    stand = b.material("stand", "oak", "walnut", "aluminium", "black steel")
    b.frustum(0.5 * d, 0.48 * d, (0.0, 0.014), stand, 28, bevel=0.003)
    b.bar((0, 0, 0.012), (0, 0, h - 0.03), 0.008, stand, 10)
    r = w / 2 - 0.02
    n = np.array([[-0.012, -0.004], [0.012, -0.004], [0.012, 0.004], [-0.012, 0.004]])
    t = np.linspace(-0.06 * np.pi, 1.06 * np.pi, 13)
    zc = h - 0.005 - 0.9 * r
    b.tube(np.c_[0 * t, r * np.cos(t), zc + 0.9 * r * np.sin(t)], n, look)
    b.bar((0, -0.02, h - 0.016), (0, 0.02, h - 0.016), 0.012, stand, 10)
    for s in (-1, 1):
        with b.frame(0, s * (r + 0.002), zc - 0.035, roll=s * np.pi / 2):
            # Along its own axis the cup points inward.
            b.lathe([(0.7 * 0.42 * d, -0.018), (0.42 * d, -0.006), (0.42 * d, 0.008)], look, 20)
            b.lathe([(0.38 * d, 0.008), (0.42 * d, 0.013), (0.42 * d, 0.022), (0.36 * d, 0.03)], pad, 20)


@small("speaker")
def speaker(b: Builder) -> None:
    """A box with a woofer and a tweeter."""
    d, w, h = b.size
    look = b.material("body", "walnut", "oak", "black paint", "white paint", "cherry")
    face = b.material("front", "black plastic", "grey plastic", "charcoal fabric")
    cone = b.pick("cone", ["black plastic", "grey plastic", "yellow plastic", "white plastic"])
    for px in (-0.38 * d, 0.38 * d):
        for py in (-0.36 * w, 0.36 * w):
            with b.frame(px, py):
                b.frustum(0.01, 0.01, (0.0, 0.008), "rubber", 10)
    b.box((-d / 2, d / 2 - 0.01), (-w / 2, w / 2), (0.006, h), look, 0.003)
    b.box((d / 2 - 0.012, d / 2 - 0.004), (-w / 2 + 0.005, w / 2 - 0.005), (0.012, h - 0.006), face, 0.002)
    for z, r in ((0.34 * h, min(0.4 * w, 0.26 * h)), (0.76 * h, 0.2 * w)):
        with b.frame(d / 2 - 0.005, 0, z, pitch=np.pi / 2):
            b.frustum(1.08 * r, 1.04 * r, (0.0, 0.004), "black plastic", 28)
            b.frustum(1.0 * r, 0.9 * r, (0.004, 0.005), "rubber", 28)
            b.add(shapes.frustum(0.8 * r, 0.3 * r, (0.0045, 0.0053), 24), cone, [])
            b.ball((0.28 * r, 0.28 * r, 0.004), (0, 0, 0.003), "black steel", 12)


@small("soundbar")
def soundbar(b: Builder) -> None:
    """A long low speaker under cloth with a display."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "white plastic", "walnut")
    cloth = b.material("cloth", "charcoal fabric", "grey fabric", "black fabric")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.006, h), cloth, 0.03, 0.008, 4)
    slab(
        b, (-d / 2 + 0.012, d / 2 - 0.012), (-w / 2 + 0.012, w / 2 - 0.012), (h - 0.004, h + 0.001), look, 0.02, 0.0005
    )
    for s in (-1, 1):
        b.box((-0.3 * d, 0.3 * d), (s * 0.4 * w - 0.04, s * 0.4 * w + 0.04), (0.0, 0.01), "rubber", 0.002)
        decal(
            b,
            (-d / 2 + 0.0001, d / 2 - 0.004),
            (s * (w / 2 - 0.05) - 0.002, s * (w / 2 - 0.05) + 0.002),
            (0.02, h - 0.01),
            look,
        )
    decal(b, (0.0, d / 2 + 0.0003), (-0.05, 0.05), (0.35 * h, 0.65 * h), "screen")
    for k in range(4):
        with b.frame(0, -0.045 + 0.03 * k, h):
            spot(b, 0.007, (0.0, 0.0013), "grey plastic", 12)


@small("game_console")
def game_console(b: Builder) -> None:
    """A flat console in two layers with a slot, a glowing line and vents."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "grey plastic")
    dark = b.material("core", "black plastic", "grey plastic")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.004, 0.38 * h), look, 0.02, 0.004)
    slab(b, (-d / 2 + 0.01, d / 2 - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), (0.0, 0.64 * h), dark, 0.02, 0.002)
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.62 * h, h), look, 0.02, 0.004)
    x = (d / 2 - 0.014, d / 2 - 0.0097)
    decal(b, x, (-0.35 * w, 0.1 * w), (0.44 * h, 0.5 * h), "grey plastic")
    decal(
        b, x, (-0.36 * w, 0.36 * w), (0.38 * h, 0.41 * h), b.pick("glow", ["lamp glow", "sea pigment", "sea pigment"])
    )
    for k in range(3):
        decal(b, x, ((0.16 + 0.07 * k) * w, (0.2 + 0.07 * k) * w), (0.46 * h, 0.54 * h), "grey plastic")
    for k in range(8):
        decal(b, ((-0.4 + 0.05 * k) * d, (-0.375 + 0.05 * k) * d), (-0.36 * w, 0.36 * w), (h - 0.002, h + 0.0003), dark)


@small("game_controller")
def game_controller(b: Builder) -> None:
    """Two grips, two sticks, a cross and four bright buttons."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "white plastic", "grey plastic", "red plastic", "blue plastic")
    dark = b.material("sticks", "black plastic", "grey plastic")
    top = 0.72 * h
    slab(b, (-0.44 * d, 0.16 * d), (-0.4 * w, 0.4 * w), (0.3 * h, top), look, 0.03, 0.008, 4)
    for s in (-1, 1):
        loft(
            b,
            [
                np.c_[(x + e * rx * np.cos(t)), s * y + e * ry * np.sin(t), np.full(16, z)]
                for z, x, y, rx, ry, e in (
                    (0.0, 0.26 * d, 0.4 * w, 0.2 * d, 0.09 * w, 0.7),
                    (0.12 * h, 0.22 * d, 0.395 * w, 0.27 * d, 0.105 * w, 1.0),
                    (0.45 * h, 0.02 * d, 0.36 * w, 0.46 * d, 0.135 * w, 1.0),
                    (0.66 * h, -0.12 * d, 0.33 * w, 0.32 * d, 0.14 * w, 1.0),
                    (top, -0.14 * d, 0.32 * w, 0.27 * d, 0.12 * w, 0.9),
                )
                for t in [(np.arange(16) + 0.5) * np.pi / 8]
            ],
            look,
        )
        b.box((-d / 2, -0.3 * d), (s * 0.3 * w - 0.12 * w, s * 0.3 * w + 0.12 * w), (0.0, 0.66 * h), dark, 0.006)
    for px, py in ((-0.17 * d, -0.32 * w), (0.06 * d, 0.13 * w)):
        with b.frame(px, py, top - 0.002):
            b.lathe(
                [
                    (0.1 * d, 0.0),
                    (0.05 * d, 0.004),
                    (0.045 * d, 0.6 * (h - top)),
                    (0.085 * d, 0.7 * (h - top)),
                    (0.08 * d, h - top + 0.002),
                ],
                dark,
                16,
            )
    with b.frame(0.04 * d, -0.14 * w, top - 0.001):
        for x, y in ((0.09, 0.03), (0.03, 0.09)):
            b.box((-x * d, x * d), (-y * d, y * d), (0.0, 0.005), dark, 0.001)
    for k, c in enumerate(("yellow plastic", "red plastic", "green plastic", "blue plastic")):
        a = k * np.pi / 2
        with b.frame(-0.16 * d + 0.085 * d * np.cos(a), 0.32 * w + 0.085 * d * np.sin(a), top - 0.001):
            b.frustum(0.042 * d, 0.036 * d, (0.0, 0.006), c, 12)


@small("remote_control")
def remote_control(b: Builder) -> None:
    """A slim remote with a red power key, a ring, and rows of keys."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "white plastic")
    top = h - 0.003
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, top), look, 0.35 * w, 0.005, 5)

    def key(x: float, y: float, r: float, look: Look) -> None:
        with b.frame(x, y, top - 0.001):
            b.add(shapes.frustum(r, 0.9 * r, (0.0, 0.0013), 10), look, [])

    key(-0.405 * d, 0.25 * w, 0.08 * w, "red plastic")
    with b.frame(-0.2 * d, 0, top - 0.001):
        b.frustum(0.36 * w, 0.33 * w, (0.0, 0.0034), "black steel", 24)
        b.frustum(0.14 * w, 0.12 * w, (0.0, 0.004), "grey plastic", 16)
    for i in range(5):
        for j in range(3):
            c = "white plastic" if look.name != "white plastic" else "grey plastic"
            if i == 4:
                c = ("green plastic", "yellow plastic", "blue plastic")[j]
            key((0.03 + 0.082 * i) * d, (j - 1) * 0.26 * w, 0.1 * w, c)
    for j in (-1, 0, 1):
        key(-0.33 * d, j * 0.27 * w, 0.08 * w, "grey plastic")


@small("router")
def router(b: Builder) -> None:
    """A flat box with lights and two to four aerials."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "grey plastic")
    body = 0.034
    slab(b, (-d / 2 + 0.012, d / 2), (-w / 2, w / 2), (0.004, body), look, 0.018, 0.006, 4)
    slab(b, (-d / 2 + 0.03, d / 2 - 0.02), (-0.4 * w, 0.4 * w), (0.0, 0.01), "rubber", 0.01)
    for k in range(6):
        decal(
            b,
            (d / 2 - 0.028, d / 2 - 0.022),
            ((-0.25 + 0.1 * k) * w, (-0.25 + 0.1 * k) * w + 0.006),
            (body - 0.001, body + 0.0003),
            "lamp glow" if k < 3 else "green plastic",
        )
    for k in range(5):
        decal(
            b,
            (-0.1 * d + 0.02 * k * d * 2, -0.08 * d + 0.02 * k * d * 2),
            (-0.3 * w, 0.3 * w),
            (body - 0.001, body + 0.0002),
            "grey plastic",
        )
    count = b.whole("aerials", 2, 4)
    for k in range(count):
        y = (k / (count - 1) - 0.5) * 0.86 * w
        with b.frame(-d / 2 + 0.008, y, 0.02, roll=-0.18 * (k / (count - 1) - 0.5)):
            b.bar((0, 0, 0), (0.012, 0, 0), 0.006, "black plastic", 8)
            b.box((-0.006, 0.006), (-0.007, 0.007), (0.0, h - 0.022), look, 0.004)


@small("webcam")
def webcam(b: Builder) -> None:
    """A camera with a big lens on a small stand."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "white plastic")
    b.frustum(0.36 * w, 0.34 * w, (0.0, 0.008), look, 20, bevel=0.002)
    b.bar((0, 0, 0.006), (0, 0, 0.62 * h), 0.006, look, 8)
    b.cushion((-0.3 * d, 0.3 * d), (-w / 2, w / 2), (0.55 * h, h), look, radius=0.2 * h)
    with b.frame(0.28 * d, 0, 0.775 * h, pitch=np.pi / 2):
        b.frustum(0.19 * h, 0.18 * h, (0.0, 0.16 * d), "black plastic", 20)
        b.frustum(0.14 * h, 0.14 * h, (0.16 * d, 0.18 * d), "steel", 20)
        spot(b, 0.12 * h, (0.1 * d, 0.18 * d + 0.0003), "black glass")
    with b.frame(0.3 * d, 0.36 * w, 0.78 * h, pitch=np.pi / 2):
        b.frustum(0.004, 0.004, (-0.004, 0.001), "lamp glow", 8)


@small("camera")
def camera(b: Builder) -> None:
    """A photo camera: body with a leather band, lens, shutter, dials and finder."""
    d, w, h = b.size
    trim = b.material("top", "aluminium", "black plastic", "chrome")
    skin = b.material("skin", "black leather", "brown leather", "rubber", "tan leather")
    deep = 0.48 * d
    x = (-d / 2, -d / 2 + deep)
    slab(b, x, (-w / 2, w / 2), (0.0, 0.16 * h), trim, 0.018, 0.002)
    slab(b, (x[0] + 0.001, x[1] - 0.001), (-w / 2 + 0.001, w / 2 - 0.001), (0.14 * h, 0.66 * h), skin, 0.018, 0.001)
    slab(b, x, (-w / 2, w / 2), (0.62 * h, 0.8 * h), trim, 0.018, 0.003)
    slab(b, (x[0] + 0.004, x[1] - 0.002), (-0.2 * w, 0.2 * w), (0.78 * h, h), trim, 0.01, 0.006)
    for y, r, hi, c in ((-0.34, 0.012, 0.9, trim), (-0.26, 0.006, 0.94, "steel"), (0.34, 0.011, 0.88, "black plastic")):
        with b.frame(x[0] + deep / 2, y * w):
            b.frustum(r, 0.95 * r, (0.78 * h, hi * h), c, 16)
    r = 0.34 * h
    with b.frame(x[1] - 0.002, 0, 0.36 * h, pitch=np.pi / 2):
        long = d - deep + 0.002
        b.frustum(1.05 * r, r, (0.0, 0.25 * long), trim, 24)
        b.frustum(0.92 * r, 0.92 * r, (0.25 * long, 0.5 * long), "black plastic", 24)
        b.frustum(0.97 * r, 0.97 * r, (0.5 * long, 0.75 * long), "rubber", 20)
        b.frustum(0.9 * r, 0.95 * r, (0.75 * long, long), "black plastic", 24)
        spot(b, 0.72 * r, (0.9 * long, long + 0.0003), "black glass", 24)
        spot(b, 0.3 * r, (0.9 * long, long + 0.0004), "night pigment", 16)
    decal(b, (x[1] - 0.004, x[1] + 0.0003), (0.22 * w, 0.32 * w), (0.68 * h, 0.76 * h), "glass")


@small("radio")
def radio(b: Builder) -> None:
    """A retro radio: wooden case, cloth before the speaker, a dial, two knobs, a handle."""
    d, w, h = b.size
    look = b.material("body", "walnut", "oak", "cherry", "mint plastic", "cream paint", "red plastic")
    cloth = b.material("cloth", "beige fabric", "charcoal fabric", "rust fabric")
    top = 0.84 * h
    for px in (-0.3 * d, 0.3 * d):
        for py in (-0.4 * w, 0.4 * w):
            b.box((px - 0.008, px + 0.008), (py - 0.008, py + 0.008), (0.0, 0.014), "rubber")
    b.box((-d / 2, d / 2 - 0.014), (-w / 2, w / 2), (0.012, top), look, 0.014)
    x = d / 2 - 0.014
    decal(b, (x - 0.004, x + 0.0003), (-0.43 * w, 0.06 * w), (0.19 * h, 0.74 * h), cloth)
    for k in range(6):
        z = (0.2 + 0.09 * k) * h
        decal(b, (x - 0.004, x + 0.0004), (-0.43 * w, 0.06 * w), (z, z + 0.008), look)
    decal(b, (x - 0.004, x + 0.0003), (0.12 * w, 0.43 * w), (0.5 * h, 0.73 * h), "cream paint")
    for k in range(9):
        y = (0.15 + 0.032 * k) * w
        decal(b, (x - 0.004, x + 0.0004), (y, y + 0.0015), (0.62 * h, (0.7 if k % 2 else 0.67) * h), "ink pigment")
    decal(b, (x - 0.004, x + 0.00045), (0.27 * w, 0.275 * w), (0.52 * h, 0.72 * h), "red plastic")
    for y in (0.2, 0.37):
        with b.frame(x - 0.002, y * w, 0.3 * h, pitch=np.pi / 2):
            b.lathe([(0.085 * h, 0.0), (0.085 * h, 0.006), (0.07 * h, 0.013), (0.065 * h, 0.016)], "brass", 20)
    n = np.array([[-0.009, -0.003], [0.009, -0.003], [0.009, 0.003], [-0.009, 0.003]])
    b.tube(
        [
            (-0.01, -0.36 * w, top - 0.006),
            (-0.01, -0.32 * w, h - 0.003),
            (-0.01, 0.32 * w, h - 0.003),
            (-0.01, 0.36 * w, top - 0.006),
        ],
        n,
        b.material("handle", "tan leather", "brass", "black leather"),
    )


@small("charger")
def charger(b: Builder) -> None:
    """A charging stand with a phone leaning on it."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "oak", "aluminium")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.012), look, 0.02, 0.003)
    lean = 0.35
    with b.frame(0.22 * d, 0, 0.012, pitch=-lean):
        b.box((-0.01, -0.002), (-0.36 * w, 0.36 * w), (-0.004, 0.72 * h), look, 0.003)
        b.box((-0.002, 0.014), (-0.3 * w, 0.3 * w), (-0.002, 0.008), look, 0.002)
        long = (h - 0.022) / np.cos(lean)
        b.box((-0.002, 0.006), (-0.036, 0.036), (0.008, long), "black plastic", 0.003)
        decal(b, (0.0, 0.0063), (-0.033, 0.033), (0.012, long - 0.004), "screen")
        decal(b, (0.0, 0.0064), (-0.015, 0.015), (0.62 * long, 0.7 * long), "sky pigment")
        decal(b, (0.0, 0.0064), (-0.011, 0.011), (0.3 * long, 0.36 * long), "green plastic")


@small("smart_speaker", fit="round")
def smart_speaker(b: Builder) -> None:
    """A round speaker in cloth with a ring of light on top."""
    d, _, h = target(b)
    r = d / 2
    cloth = b.material("cloth", "grey fabric", "charcoal fabric", "white fabric", "blue fabric")
    dark = b.material("trim", "white plastic", "black plastic")
    b.lathe(
        [(0.8 * r, 0.0), (0.9 * r, 0.01), (r, 0.2 * h), (r, 0.8 * h), (0.94 * r, 0.92 * h), (0.84 * r, 0.985 * h)],
        cloth,
        28,
    )
    b.frustum(0.8 * r, 0.78 * r, (0.97 * h, h), dark, 28)
    spot(b, 0.74 * r, (0.98 * h, h + 0.0003), b.pick("glow", ["sky pigment", "lamp glow"]), 28)
    spot(b, 0.68 * r, (0.98 * h, h + 0.0004), dark, 28)
    for a in range(4):
        with b.frame(0.4 * r * np.cos(a * np.pi / 2), 0.4 * r * np.sin(a * np.pi / 2)):
            spot(b, 0.05 * r, (0.98 * h, h + 0.00045), "grey plastic", 10)


@small("hard_drive")
def hard_drive(b: Builder) -> None:
    """A small box with a light and a cable."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "aluminium", "blue plastic", "orange plastic", "grey plastic")
    slab(b, (-0.4 * d, d / 2), (-w / 2, w / 2), (0.0, h), look, 0.01, 0.003)
    decal(b, (0.4 * d, 0.43 * d), (-0.04 * w, 0.04 * w), (h / 2, h + 0.0003), "lamp glow")
    for k in range(5):
        x = (-0.2 + 0.09 * k) * d
        decal(
            b,
            (x, x + 0.03 * d),
            (-0.4 * w, 0.4 * w),
            (h / 2, h + 0.0003),
            "black plastic" if look.name != "black plastic" else "grey plastic",
        )
    b.box((-0.46 * d, -0.39 * d), (-0.008, 0.008), (0.25 * h, 0.7 * h), "black plastic", 0.001)
    b.tube(
        [(-0.44 * d, 0, 0.5 * h), (-0.49 * d, 0.1 * w, 0.3 * h), (-0.48 * d, 0.35 * w, 0.16 * h)],
        0.0025,
        "black plastic",
        6,
    )


@small("desk_microphone", fit="round")
def desk_microphone(b: Builder) -> None:
    """A studio microphone on a round foot."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "black steel", "aluminium", "white plastic", "brass")
    b.frustum(r, 0.97 * r, (0.0, 0.014), "black steel", 28, bevel=0.004)
    b.bar((-0.35 * r, 0, 0.012), (-0.35 * r, 0, 0.5 * h), 0.006, "steel", 8)
    b.bar((-0.35 * r, 0, 0.5 * h), (0.0, 0, 0.56 * h), 0.008, "black steel", 8)
    q = 0.42 * r
    b.frustum(0.8 * q, q, (0.42 * h, 0.46 * h), look, 20)
    b.frustum(q, q, (0.46 * h, 0.66 * h), look, 20)
    b.frustum(1.06 * q, 1.06 * q, (0.66 * h, 0.685 * h), "steel", 20)
    b.lathe([(q, 0.68 * h), (1.02 * q, 0.84 * h), *dome(q, 0.86 * h, h, 4, 0.2 * q)], "grey fabric", 20)
    for z in (0.74, 0.82):
        hoop(b, 0.98 * q, z * h, 0.0025, "steel", 14)
    decal(b, (0.9 * q, 0.985 * q), (-0.1 * q, 0.1 * q), (0.54 * h, 0.57 * h), "red plastic")


@small("conference_phone")
def conference_phone(b: Builder) -> None:
    """A three-armed phone for meetings, with keys, a display and lights."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "black steel")
    r = 0.5 * min(d, w)
    for k in range(3):
        with b.frame(yaw=k * 2 * np.pi / 3):
            b.hull(
                [
                    (x * r, s * y * r, z * h)
                    for s in (-1, 1)
                    for x, y, z in (
                        (0.0, 0.5, 0.0),
                        (1.1, 0.22, 0.0),
                        (1.12, 0.2, 0.2),
                        (1.08, 0.18, 0.4),
                        (0.2, 0.45, 0.85),
                        (-0.2, 0.4, 0.85),
                    )
                ],
                look,
            )
            with b.frame(0.72 * r, 0, 0.61 * h, pitch=0.28):
                b.box((-0.24 * r, 0.24 * r), (-0.17 * r, 0.17 * r), (-0.1 * h, 0.04 * h), "charcoal fabric", 0.004)
            with b.frame(1.09 * r, 0, 0.3 * h):
                b.box((-0.02, 0.004), (-0.02, 0.02), (0.0, 0.08 * h), "green plastic", 0.001)
    b.frustum(
        0.46 * r, 0.42 * r, (0.8 * h, 0.92 * h), "grey plastic" if look.name != "grey plastic" else "black plastic", 24
    )
    b.box((-0.34 * r, -0.08 * r), (-0.26 * r, 0.26 * r), (0.88 * h, 0.96 * h), "screen", 0.002)
    for i in range(2):
        for j in range(3):
            b.box(
                ((0.0 + 0.16 * i) * r, (0.12 + 0.16 * i) * r),
                ((-0.24 + 0.17 * j) * r, (-0.12 + 0.17 * j) * r),
                (0.9 * h, h),
                "white plastic",
                0.001,
            )


@small("vr_headset")
def vr_headset(b: Builder) -> None:
    """Goggles with a strap over and around the head."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "grey plastic")
    strap = b.material("strap", "charcoal fabric", "grey fabric", "black fabric")
    loft(
        b,
        [
            rect((0.5 * d - 0.09 + e, 0.5 * d - e), (-w / 2 + e, w / 2 - e), z, 0.035, 4)
            for e, z in ((0.012, 0.0), (0.0, 0.018), (0.0, 0.8 * h - 0.015), (0.012, 0.8 * h))
        ],
        look,
        convex=True,
    )
    for k in (-1, 1):
        with b.frame(0.5 * d - 0.002, k * 0.22 * w, 0.4 * h, pitch=np.pi / 2):
            b.add(shapes.frustum(0.012, 0.012, (-0.002, 0.0023), 14), "black glass", [])
    slab(b, (0.5 * d - 0.11, 0.5 * d - 0.085), (-0.45 * w, 0.45 * w), (0.04 * h, 0.76 * h), "black fabric", 0.01, 0.008)
    n = np.array([[-0.0025, -0.013], [0.0025, -0.013], [0.0025, 0.013], [-0.0025, 0.013]])
    t = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 9)
    xc = 0.5 * d - 0.06
    b.tube(np.c_[xc - (d - 0.065) * np.cos(t), 0.46 * w * np.sin(t), 0.4 * h + 0 * t], n, strap)
    m = np.array([[-0.013, -0.0025], [0.013, -0.0025], [0.013, 0.0025], [-0.013, 0.0025]])
    b.tube(
        [
            (0.5 * d - 0.05, 0, 0.79 * h),
            (0.2 * d, 0, 0.96 * h),
            (-0.1 * d, 0, h - 0.003),
            (-0.35 * d, 0, 0.85 * h),
            (-0.485 * d, 0, 0.45 * h),
        ],
        m,
        strap,
    )
