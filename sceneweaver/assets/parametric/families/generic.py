"""The bodies of what is not known: plain shapes of typical size, each class with a form of its own."""

from __future__ import annotations

import numpy as np

from ..builder import Builder
from ..registry import draws
from .small_kit import slab, small, spun

PLAIN = ("light grey paint", "beige fabric", "cardboard", "sage paint", "grey plastic", "white plastic")


@draws("object")
def generic(b: Builder) -> None:
    """A plain block with cut edges and a band around it, so that nobody takes it for furniture."""
    d, w, h = b.size
    body = b.material("body", "cardboard", "light grey paint", "beige fabric")
    t = min(0.002, 0.1 * min(d, w))
    with b.solid("all"):
        b.box((-d / 2 + t, d / 2 - t), (-w / 2 + t, w / 2 - t), (0.0, h), body, bevel=0.04 * min(b.size))
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.42 * h, 0.58 * h), "grey plastic", bevel=0.0)
    b.surface("top", (-0.4 * d, 0.4 * d), (-0.4 * w, 0.4 * w), h)


@small("generic_item", "generic_device")
def case(b: Builder) -> None:
    """A case with a darker front: a panel, a dial and two buttons."""
    d, w, h = b.size
    body = b.material("body", *PLAIN)
    b.box((-d / 2, d / 2 - 0.006), (-w / 2, w / 2), (0.0, h), body, bevel=0.05 * min(b.size))
    b.box(
        (d / 2 - 0.008, d / 2), (-0.44 * w, 0.44 * w), (0.12 * h, 0.88 * h), b.material("front", "grey plastic"), 0.002
    )


@small("generic_tool")
def tool(b: Builder) -> None:
    """A handle and a head that is broader."""
    d, w, h = b.size
    b.box(
        (-0.3 * d, 0.3 * d), (-w / 2, 0.15 * w), (0.1 * h, 0.7 * h), b.material("body", "black plastic", "oak"), 0.004
    )
    b.box((-d / 2, d / 2), (0.12 * w, w / 2), (0.0, h), b.material("head", "brushed steel"), 0.003)


@small("generic_sheet")
def sheet(b: Builder) -> None:
    """A flat board with a border."""
    d, w, h = b.size
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), b.material("body", "paper", "cardboard", "oak"), 0.006, 0.001)


@small("generic_figure")
def figure(b: Builder) -> None:
    """A body and a head on a round base."""
    body = b.material("body", "white ceramic", "terracotta", "grey ceramic", "oak")
    profile = [(0.5, 0.0), (0.5, 0.08), (0.42, 0.1), (0.4, 0.3), (0.3, 0.56), (0.16, 0.66), (0.24, 0.78), (0.22, 0.9)]
    spun(b, [*profile, (0.08, 1.0)], body, segments=20)


@small("generic_vessel", fit="round")
def vessel(b: Builder) -> None:
    """A round vessel with a lid."""
    body = b.material("body", "white ceramic", "blue ceramic", "grey ceramic", "terracotta")
    spun(b, [(0.34, 0.0), (0.5, 0.3), (0.48, 0.62), (0.36, 0.8), (0.38, 0.86), (0.2, 0.94), (0.06, 1.0)], body)


@small("generic_soft")
def soft(b: Builder) -> None:
    """A cushion."""
    d, w, h = b.size
    b.cushion((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), b.material("body", "@fabric"), radius=0.05, puff=0.6)


@draws("generic_machine", "generic_furniture")
def cabinet(b: Builder) -> None:
    """A case on a plinth with a front panel."""
    d, w, h = b.size
    body = b.material("body", "light grey paint", "white paint", "grey paint", "sage paint")
    with b.solid("all"):
        b.box((-d / 2 + 0.02, d / 2 - 0.05), (-w / 2 + 0.02, w / 2 - 0.02), (0.0, 0.08), "black plastic", 0.0)
        b.box((-d / 2, d / 2 - 0.01), (-w / 2, w / 2), (0.08, h), body, 0.01)
        b.box(
            (d / 2 - 0.012, d / 2), (-0.42 * w, 0.42 * w), (0.14, 0.9 * h), b.material("front", "grey plastic"), 0.003
        )
    b.surface("top", (-0.46 * d, 0.44 * d), (-0.46 * w, 0.46 * w), h)


@draws("generic_table")
def table(b: Builder) -> None:
    """A top on four legs."""
    d, w, h = b.size
    body = b.material("body", "@wood", "white paint")
    with b.solid("top"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.035, h), body, 0.004)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (d / 2 - 0.05), sy * (w / 2 - 0.05)
            with b.solid(f"leg{sx}{sy}"):
                b.box((x - 0.025, x + 0.025), (y - 0.025, y + 0.025), (0.0, h - 0.035), body)
    b.surface("top", (-0.48 * d, 0.48 * d), (-0.48 * w, 0.48 * w), h)


@draws("generic_stand")
def stand(b: Builder) -> None:
    """A post on a foot, with a plate on it."""
    d, w, h = b.size
    body = b.material("body", "black steel", "oak", "white steel", "brass")
    r = min(d, w) / 2
    with b.solid("foot"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.03), body, 0.005)
    with b.solid("post"):
        b.frustum(0.12 * r, 0.12 * r, (0.03, h - 0.02), body, segments=16)
    with b.solid("plate"):
        b.box((-0.7 * r, 0.7 * r), (-0.7 * r, 0.7 * r), (h - 0.02, h), body, 0.003)
    b.surface("top", (-0.66 * r, 0.66 * r), (-0.66 * r, 0.66 * r), h)


@draws("generic_rack")
def rack(b: Builder) -> None:
    """Four posts and three boards."""
    d, w, h = b.size
    body = b.material("body", "black steel", "white steel", "oak", "pine")
    count, t = 3, 0.018
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (d / 2 - 0.015), sy * (w / 2 - 0.015)
            b.box((x - 0.015, x + 0.015), (y - 0.015, y + 0.015), (0.0, h), body, 0.001)
    step = (h - 0.1) / count
    for k in range(count):
        z = 0.1 + k * step
        with b.solid(f"board{k}"):
            b.box((-d / 2 + 0.03, d / 2 - 0.03), (-w / 2 + 0.03, w / 2 - 0.03), (z - t, z), body, 0.001)
        room = None if k == count - 1 else step - t
        b.surface(f"board-{k}", (-d / 2 + 0.035, d / 2 - 0.035), (-w / 2 + 0.035, w / 2 - 0.035), z, room)


@small("generic_mat")
def mat(b: Builder) -> None:
    """A mat."""
    d, w, h = b.size
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), b.material("body", "@fabric", "rubber"), 0.03, 0.002)


@small("generic_panel")
def panel(b: Builder) -> None:
    """A board in a frame."""
    d, w, h = b.size
    b.box((-d / 2, 0.3 * d), (-w / 2, w / 2), (0.0, h), b.material("frame", "oak", "black paint", "white paint"), 0.003)
    b.box(
        (0.2 * d, d / 2),
        (-0.46 * w, 0.46 * w),
        (0.05 * h, 0.95 * h),
        b.material("body", "chalk pigment", "paper"),
        0.001,
    )


@small("generic_fixture")
def fixture(b: Builder) -> None:
    """A box on a plate."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "grey plastic", "light grey paint", "brushed steel")
    b.box((-d / 2, -0.4 * d), (-w / 2, w / 2), (0.0, h), body, 0.003)
    b.box((-0.42 * d, d / 2), (-0.4 * w, 0.4 * w), (0.12 * h, 0.88 * h), body, 0.01)


@small("generic_hanging")
def hanging(b: Builder) -> None:
    """A body on a cord."""
    d, w, h = b.size
    body = b.material("body", "oak", "white plastic", "brass", "paper")
    r = min(d, w) / 2
    b.frustum(0.16 * r, 0.16 * r, (h - 0.02, h), "white plastic", 16)
    b.bar((0, 0, 0.5 * h), (0, 0, h - 0.01), 0.004, "black plastic", 8)
    t = np.linspace(0, np.pi, 9)
    spun(b, [(float(max(0.02, r * np.sin(a))), float(0.26 * h * (1 - np.cos(a)))) for a in t], body)
