"""Boards, screens and stands to show things on, and what guides people."""

from __future__ import annotations

import math

from ..builder import Builder, Interval, span
from .gym_kit import Look, castors, disc, gear, inlay

_INKS = ("blue plastic", "red plastic", "black plastic", "green plastic")


def _board(b: Builder, x: float, y: Interval, z: Interval, sheet: Look, frame: Look, edge: float = 0.02) -> None:
    """A framed panel whose face is at x + 0.014 and whose frame ends at x + 0.02."""
    b.box((x, x + 0.014), (y[0] + edge, y[1] - edge), (z[0] + edge, z[1] - edge), sheet, 0)
    b.box((x, x + 0.02), y, (z[0], z[0] + edge), frame, 0.002)
    b.box((x, x + 0.02), y, (z[1] - edge, z[1]), frame, 0.002)
    b.box((x, x + 0.02), (y[0], y[0] + edge), z, frame, 0.002)
    b.box((x, x + 0.02), (y[1] - edge, y[1]), z, frame, 0.002)


def _tray(b: Builder, x: float, y: Interval, z: float, metal: Look, chalk: bool = False) -> None:
    b.box((x, x + 0.07), y, (z - 0.012, z), metal, 0.003)
    b.box((x + 0.063, x + 0.07), y, (z - 0.012, z + 0.012), metal, 0.002)
    m = (y[0] + y[1]) / 2
    for k in range(3):
        c = m - 0.3 + 0.16 * k
        b.bar(
            (x + 0.035, c, z + 0.008),
            (x + 0.035, c + (0.08 if chalk else 0.12), z + 0.008),
            0.008,
            ("white plastic", "yellow plastic", "pink plastic")[k] if chalk else _INKS[k],
            8,
        )
    b.box(
        (x + 0.012, x + 0.055),
        (m + 0.2, m + 0.32),
        (z, z + 0.03),
        "charcoal fabric" if chalk else "blue plastic",
        0.004,
    )


def _scribble(b: Builder, x: float, y: Interval, z: Interval, looks: tuple[str, ...]) -> None:
    """Lines of writing and a little bar chart."""
    w, h = y[1] - y[0], z[1] - z[0]
    for k in range(b.whole("lines", 3, 6)):
        zz = z[1] - h * 0.14 - k * h * 0.11
        a = y[1] - w * 0.08
        for j in range(b.whole(f"words {k}", 2, 4)):
            long = w * b.uniform(f"word {k} {j}", 0.04, 0.1)
            inlay(b, (x - 0.002, x + 0.0003), (a - long, a), (zz, zz + 0.012), looks[k % len(looks)])
            a -= long + 0.02
    for k in range(4):
        c = y[0] + w * (0.12 + 0.07 * k)
        tall = h * b.uniform(f"bar {k}", 0.12, 0.4)
        inlay(
            b,
            (x - 0.002, x + 0.0003),
            (c, c + w * 0.04),
            (z[0] + h * 0.25, z[0] + h * 0.25 + tall),
            looks[(k + 1) % len(looks)],
        )


@gear("whiteboard")
def whiteboard(b: Builder) -> None:
    """A white panel in a metal frame with a pen tray; written on in most."""
    d, w, h = b.size
    frame = b.material("frame", "aluminium", "grey plastic", "white steel", "light oak")
    x = -d / 2
    _board(b, x, (-w / 2, w / 2), (0.02, h), "white plastic", frame)
    _tray(b, x + 0.015, (-w * 0.3, w * 0.3), 0.03, frame)
    for sy in (-1, 1):
        for z in (0.02 + 0.015, h - 0.015):
            b.box(
                (x, x + 0.024),
                (sy * (w / 2 - 0.02) - 0.018, sy * (w / 2 - 0.02) + 0.018),
                (z - 0.015, z + 0.015),
                "grey plastic",
                0.004,
            )
    if b.chance("written", 0.75):
        _scribble(b, x + 0.014, (-w / 2 + 0.1, w / 2 - 0.1), (0.1, h - 0.05), _INKS[:3])


@gear("blackboard")
def blackboard(b: Builder) -> None:
    """A green or black slate in a wooden frame with a chalk ledge."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "beech", "walnut", "pine")
    x = -d / 2
    _board(b, x, (-w / 2, w / 2), (0.02, h), b.material("slate", "forest pigment", "ink pigment"), wood, 0.045)
    _tray(b, x + 0.015, (-w / 2, w / 2), 0.035, wood, chalk=True)
    if b.chance("written", 0.8):
        _scribble(
            b,
            x + 0.014,
            (-w / 2 + 0.1, w / 2 - 0.1),
            (0.1, h - 0.05),
            ("chalk pigment", "chalk pigment", "yellow petal"),
        )


@gear("notice_board")
def notice_board(b: Builder) -> None:
    """Cork or felt in a frame with pinned papers."""
    d, w, h = b.size
    frame = b.material("frame", "light oak", "aluminium", "white paint", "walnut")
    x = -d / 2
    _board(
        b, x, (-w / 2, w / 2), (0, h), b.material("board", "cork", "cork", "blue fabric", "green fabric"), frame, 0.028
    )
    looks = ("paper", "yellow plastic", "pink plastic", "mint plastic", "sky pigment", "paper")
    n, m = max(2, int((w - 0.15) / 0.24)), 2
    for k in range(n):
        for j in range(m):
            if b.chance(f"no note {k} {j}", 0.2):
                continue
            cy = -w / 2 + 0.07 + (k + 0.5) * (w - 0.14) / n + b.uniform(f"y {k} {j}", -0.02, 0.02)
            cz = 0.06 + (j + 0.5) * (h - 0.12) / m + b.uniform(f"z {k} {j}", -0.02, 0.02)
            p, q = b.uniform(f"p {k} {j}", 0.05, 0.08), min(0.1, (h - 0.2) / 5)
            b.box((x + 0.013, x + 0.0155), (cy - p, cy + p), (cz - q, cz + q), b.pick(f"note {k} {j}", looks), 0)
            disc(b, (x + 0.018, cy, cz + q - 0.015), 0.007, 0.008, _INKS[(k + j) % 4], "x", 10)


def _frame_feet(b: Builder, d: float, w: float, h: float, metal: Look) -> None:
    for s in (-1, 1):
        y = s * (w / 2 - 0.025)
        b.box((-d / 2 + 0.02, d / 2 - 0.02), (y - 0.02, y + 0.02), (0.07, 0.11), metal, 0.006)
        b.box((-0.02, 0.02), (y - 0.018, y + 0.018), (0.09, h), metal, 0.004)
    castors(b, (-d / 2 + 0.04, d / 2 - 0.04), (-w / 2 + 0.025, w / 2 - 0.025), r=0.03)


@gear("mobile_whiteboard")
def mobile_whiteboard(b: Builder) -> None:
    """A whiteboard that turns between two uprights on castors."""
    d, w, h = b.size
    metal = b.material("frame", "aluminium", "white steel", "black steel", "grey paint")
    _frame_feet(b, d, w, h * 0.66, metal)
    low = h - min(1.25, (h - 0.5))
    i = w / 2 - 0.05
    _board(b, -0.01, (-i, i), (low, h), "white plastic", metal)
    b.box((-0.014, -0.009), (-i + 0.02, i - 0.02), (low + 0.02, h - 0.02), "white plastic", 0)
    for s in (-1, 1):
        disc(b, (0, s * (w / 2 - 0.028), h * 0.64), 0.03, 0.056, "black plastic", "y", 16, 0.004)
    _tray(b, 0.008, (-i * 0.6, i * 0.6), low + 0.012, metal)
    b.box((-0.012, 0.012), (-i, i), (0.2, 0.23), metal, 0.003)
    if b.chance("written", 0.7):
        _scribble(b, 0.004, (-i + 0.1, i - 0.1), (low + 0.1, h - 0.05), _INKS[:3])


@gear("flip_chart")
def flip_chart(b: Builder) -> None:
    """A pad of paper on a board with three legs."""
    d, w, h = b.size
    metal = b.material("legs", "aluminium", "black steel", "grey plastic")
    lean = math.atan2(d * 0.42, h)
    for s in (-1, 1):
        b.bar((d / 2 - 0.015, s * (w / 2 - 0.02), 0.0), (-d * 0.05, s * w * 0.3, h * 0.9), 0.014, metal, 8)
        b.box(
            (d / 2 - 0.03, d / 2), (s * (w / 2 - 0.02) - 0.016, s * (w / 2 - 0.02) + 0.016), (0, 0.04), "rubber", 0.004
        )
    b.bar((-d / 2 + 0.015, 0, 0.0), (-d * 0.06, 0, h * 0.8), 0.014, metal, 8)
    z0 = h - 1.02
    with b.frame(d / 2 - 0.02 - math.tan(lean) * z0 * 1.05, 0, z0, pitch=-lean):
        t = 1.02 / math.cos(lean)
        b.box((-0.02, 0), (-w / 2, w / 2), (0, t), "white plastic", 0.004)
        b.box((0, 0.02), (-w / 2 + 0.03, w / 2 - 0.03), (t * 0.1, t - 0.03), "paper", 0)
        b.box((0, 0.035), (-w / 2 + 0.02, w / 2 - 0.02), (t - 0.06, t - 0.02), metal, 0.006)
        b.box((0, 0.06), (-w / 2 + 0.02, w / 2 - 0.02), (0.0, 0.02), metal, 0.004)
        _scribble(b, 0.02, (-w / 2 + 0.06, w / 2 - 0.06), (t * 0.12, t - 0.08), _INKS[:3])


@gear("projector_screen")
def projector_screen(b: Builder) -> None:
    """A long case with a white sheet with black borders let down from it."""
    d, w, h = b.size
    case = b.material("case", "white steel", "black steel", "aluminium")
    r = d / 2
    b.box((-r, r), (-w / 2, w / 2), (h - 2 * r, h), case, r * 0.5)
    for s in (-1, 1):
        b.box((-r, r), span(s * w / 2, s * (w / 2 - 0.03)), (h - 2 * r, h), "grey plastic", r * 0.4)
    b.box((-0.003, 0.003), (-w / 2 + 0.05, w / 2 - 0.05), (0.02, h - r), "black plastic", 0)
    inlay(b, (0, 0.0033), (-w / 2 + 0.1, w / 2 - 0.1), (0.07, h - 2 * r - 0.12), "white plastic")
    b.box((-0.012, 0.012), (-w / 2 + 0.05, w / 2 - 0.05), (0, 0.025), case, 0.004)


@gear("projector")
def projector(b: Builder) -> None:
    """A projector under the ceiling on a pole, its lens to the front."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "black plastic", "grey plastic")
    t = 0.13
    x1 = d / 2 - 0.015
    b.box((-d / 2, x1), (-w / 2, w / 2), (0, t), body, 0.02)
    y = w * 0.22
    disc(b, (x1, y, t * 0.55), 0.048, 0.03, "black plastic", "x", 24, 0.004)
    disc(b, (x1 + 0.012, y, t * 0.55), 0.035, 0.008, "screen", "x", 24)
    for k in range(6):
        inlay(b, (x1 - 0.01, x1 + 0.0003), (-w * 0.4, -w * 0.05), (0.03 + 0.013 * k, 0.036 + 0.013 * k), "grey plastic")
    b.box((-0.09, 0.09), (-0.09, 0.09), (t - 0.001, t + 0.018), "grey plastic", 0.004)
    b.frustum(0.022, 0.022, (t, h - 0.02), "aluminium", 16)
    b.frustum(0.07, 0.08, (h - 0.025, h), "aluminium", 24)


@gear("partition")
def partition(b: Builder) -> None:
    """A felt screen in a thin frame on two flat feet, glazed above in some."""
    d, w, h = b.size
    cloth = b.material("cloth", "@fabric")
    metal = b.material("frame", "aluminium", "black steel", "white steel", "light oak")
    t = 0.02
    glazed = h > 1.5 and b.chance("glazed", 0.6)
    z1 = h - 0.4 if glazed else h - 0.03
    b.box((-t, t), (-w / 2 + 0.025, w / 2 - 0.025), (0.08, z1), cloth, 0.004)
    for s in (-1, 1):
        ys = span(s * w / 2, s * (w / 2 - 0.03))
        b.box((-t - 0.004, t + 0.004), ys, (0.03, h), metal, 0.003)
        b.box((-d / 2, d / 2), (s * (w / 2 - 0.1) - 0.03, s * (w / 2 - 0.1) + 0.03), (0, 0.02), metal, 0.004)
        b.box((-0.015, 0.015), (s * (w / 2 - 0.1) - 0.02, s * (w / 2 - 0.1) + 0.02), (0.015, 0.085), metal, 0.002)
    for zs in ((0.06, 0.09), (h - 0.03, h)) + (((z1 - 0.02, z1 + 0.01),) if glazed else ()):
        b.box((-t - 0.003, t + 0.003), (-w / 2, w / 2), zs, metal, 0.003)
    if glazed:
        b.box((-0.004, 0.004), (-w / 2 + 0.03, w / 2 - 0.03), (z1, h - 0.02), "frosted glass", 0)
    else:
        n = b.whole("seams", 1, 3)
        for k in range(1, n + 1):
            z = 0.08 + k * (z1 - 0.08) / (n + 1)
            inlay(b, (-t - 0.0003, t + 0.0003), (-w / 2 + 0.03, w / 2 - 0.03), (z - 0.002, z + 0.002), metal)


@gear("stanchion")
def stanchion(b: Builder) -> None:
    """Two posts with a belt or a velvet rope between them."""
    d, w, h = b.size
    rope = b.chance("rope", 0.5)
    metal = b.material("posts", "brass" if rope else "black steel", "chrome")
    band = b.material("band", "red fabric", "navy fabric", "black fabric")
    r = d / 2
    for s in (-1, 1):
        with b.solid(f"post {s}"), b.frame(0, s * (w / 2 - r)):
            b.lathe(
                [
                    (r, 0),
                    (r, 0.012),
                    (r * 0.6, 0.035),
                    (0.03, 0.06),
                    (0.024, 0.08),
                    (0.024, h - 0.08),
                    (0.036, h - 0.07),
                    (0.036, h - 0.02),
                    (0.018, h),
                ],
                metal,
                24,
            )
    e = w / 2 - r - 0.03
    with b.solid("band"):
        if rope:
            n = 8
            path = [(0, -e + 2 * e * k / n, h - 0.07 - 0.22 * (1 - (2 * k / n - 1) ** 2)) for k in range(n + 1)]
            b.tube(path, 0.018, band, 10)
        else:
            b.box((-0.0015, 0.0015), (-e, e), (h - 0.07, h - 0.022), band, 0)


@gear("kiosk")
def kiosk(b: Builder) -> None:
    """An information terminal: a tilted touch screen on a slim column, or an upright panel."""
    d, w, h = b.size
    body = b.material("body", "white steel", "black steel", "grey paint", "aluminium")
    accent = b.material("accent", "blue plastic", "red plastic", "teal paint", "orange plastic")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0, 0.03), body, 0.008)
    if h > 1.45:
        b.box((-0.07, 0.05), (-w / 2 + 0.01, w / 2 - 0.01), (0.03, h), body, 0.012)
        b.box((0.04, 0.054), (-w / 2 + 0.04, w / 2 - 0.04), (0.55, h - 0.06), "screen", 0.002)
        x, z = 0.054, h - 0.16
        inlay(b, (0.04, 0.0503), (-w / 2 + 0.06, w / 2 - 0.06), (0.1, 0.13), accent)
    else:
        b.box((-0.09, 0.03), (-0.14, 0.14), (0.03, h - 0.2), body, 0.02)
        inlay(b, (0.0, 0.0303), (-0.05, 0.05), (0.2, h * 0.55), accent)
        with b.frame(-0.02, 0, h - 0.3, pitch=-0.75):
            b.box((-0.05, 0.03), (-w / 2, w / 2), (-0.06, 0.36), body, 0.012)
            b.box((0.025, 0.034), (-w / 2 + 0.03, w / 2 - 0.03), (-0.03, 0.33), "screen", 0.002)
            for k in range(3):
                inlay(
                    b,
                    (0.03, 0.0343),
                    (-w / 2 + 0.06, w / 2 - 0.06),
                    (0.02 + 0.08 * k, 0.07 + 0.08 * k),
                    (accent, "white plastic", "sky pigment")[k],
                )
        return
    inlay(b, (x - 0.004, x + 0.0003), (-w / 2 + 0.08, w / 2 - 0.08), (z - 0.06, z), accent)
    for k in range(4):
        zz = z - 0.2 - 0.13 * k
        inlay(
            b,
            (x - 0.004, x + 0.0003),
            (-w / 2 + 0.08, w / 2 - 0.08),
            (zz, zz + 0.08),
            ("white plastic", "sky pigment")[k % 2],
        )


@gear("lectern")
def lectern(b: Builder) -> None:
    """A speaker's desk with a sloping top and, on some, a microphone; the speaker stands behind."""
    d, w, h = b.size
    wood = b.material("wood", "walnut", "oak", "mahogany", "light oak", "black paint")
    top = h - 0.2
    if b.chance("closed", 0.6):
        b.box((-d * 0.2, d * 0.4), (-w * 0.4, w * 0.4), (0.05, top - 0.1), wood, 0.006)
        b.box((-d * 0.3, d * 0.46), (-w * 0.46, w * 0.46), (0, 0.06), wood, 0.01)
        b.box((d * 0.4 - 0.002, d * 0.4 + 0.012), (-w * 0.28, w * 0.28), (0.18, top - 0.22), wood, 0.008)
        disc(b, (d * 0.4 + 0.012, 0, top * 0.6), 0.09, 0.006, "brass", "x", 24)
    else:
        b.box((-d * 0.36, d * 0.36), (-w * 0.4, w * 0.4), (0, 0.045), wood, 0.012)
        b.box((-0.06, 0.06), (-0.08, 0.08), (0.04, top - 0.1), wood, 0.012)
    with b.frame(0, 0, top - 0.02, pitch=-0.3):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (-0.09, 0), wood, 0.008)
        b.box((-d / 2, -d / 2 + 0.02), (-w / 2, w / 2), (-0.02, 0.025), wood, 0.004)
        b.box((-d * 0.36, d * 0.2), (-0.22, -0.005), (0, 0.003), "paper", 0)
        b.box((-d * 0.36, d * 0.2), (0.005, 0.22), (0, 0.003), "paper", 0)
    z = top - 0.02 + 0.3 * d * 0.4
    b.tube([(d * 0.38, 0, z - 0.03), (d * 0.36, 0, z + 0.12), (d * 0.2, 0, h - 0.015)], 0.005, "black steel", 6)
    b.bar((d * 0.2, 0, h - 0.015), (d * 0.08, 0, h - 0.012), 0.012, "black plastic", 10)
