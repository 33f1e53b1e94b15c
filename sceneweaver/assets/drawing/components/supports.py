"""What furniture stands on: legs, feet, castors, star bases."""

from __future__ import annotations

import math

import numpy as np

from ..box import Box, Vec3
from ..drawing import Drawing, Look

SHADOW = "black paint"


def leg(d: Drawing, foot: Vec3, head: Vec3, low: float, high: float, material: Look, sides: int = 12) -> None:
    """A leg between two points, ``low`` and ``high`` wide at its ends, which are cut level; round, or of four sides."""
    angle = (np.arange(sides) + 0.5) * (2 * np.pi / sides)
    ring = np.c_[np.cos(angle), np.sin(angle), np.zeros(sides)] / math.cos(math.pi / sides) / 2
    d.loft([np.asarray(foot) + low * ring, np.asarray(head) + high * ring], material, convex=True)


def beam(d: Drawing, start: Vec3, end: Vec3, material: Look, wide: float, deep: float | None = None) -> None:
    """A straight bar of rectangular section between two points: ``wide`` across, ``deep`` (or as much) upward."""
    half = np.array([[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]]) / 2
    d.bar(start, end, half * (wide, wide if deep is None else deep), material)


def legs(
    d: Drawing, box: Box, material: Look, style: str = "square", width: float = 0.045, splay: float | None = None
) -> Box:
    """Four legs, or what stands for them, in the corners of a box, as high as it is.

    Args:
        d: The drawing.
        box: Where they stand.
        material: What they are of.
        style: "square", "round", "tapered", "splayed" (feet in the corners, heads drawn in by ``splay``, a tenth of
            the height unless told), "turned", "hairpin", "sled" (front and back leg joined at the floor), "panel"
            (each side is one board) or "trestle".
        width: Width of a leg [m].
        splay: How far the heads of splayed legs are drawn in [m].
    """
    h, w = box.height, width
    if style in ("sled", "panel", "trestle"):
        thick = {"sled": 0.6 * w, "panel": max(0.018, 0.6 * w), "trestle": w}[style]
        with d.at(y=box.center[1]), d.mirror("y"):
            side = box.move(y=-box.center[1]).left(thick)
            if style == "panel":
                d.box(side, material)
            elif style == "sled":
                d.box(side.back(thick), material)
                d.box(side.front(thick), material)
                d.box(side.bottom(thick).inset(x=thick), material)
            else:
                d.box(side.bottom(0.05), material)
                d.box(side.inset(bottom=0.05, top=0.04).place(depth=thick), material)
                d.box(side.top(0.04).inset(x=0.05), material)
        return box
    with d.corners(box):
        own = Box((0.0, w), (0.0, w), (0.0, h))
        if style == "square":
            d.box(own, material)
        elif style == "round":
            d.cylinder(own, material, segments=16)
        elif style == "tapered":
            d.cylinder(own, material, ends=(0.6, 1.0), segments=16)
        elif style == "splayed":
            by = 0.1 * h if splay is None else splay
            foot, half = 0.3 * w, w / 2
            leg(d, (foot, foot, 0.0), (foot + by, foot + by, h), 0.6 * w, 2 * half, material)
        elif style == "turned":
            with d.at(w / 2, w / 2):
                shape = ((0.5, 0.0), (0.62, 0.02), (0.7, 0.06), (0.5, 0.1), (0.62, 0.14), (0.95, 0.55), (0.6, 0.7))
                d.revolve([(0.5 * w * r, h * z) for r, z in (*shape, (0.9, 0.72), (0.9, 0.75))], material, 16)
                d.box(Box.sized(w, w, 0.25 * h, (0.0, 0.0, 0.75 * h)), material)
        elif style == "hairpin":
            at, spread = 0.011, min(0.09, 0.3 * box.width)
            for head in (0.3 * spread, spread):
                d.bar((at, at, 0.0), (at, at + head, h), 0.006, material, segments=8)
        else:
            raise ValueError(f"no legs of style {style}")
    return box


def feet(d: Drawing, box: Box, material: Look, style: str = "plinth") -> Box:
    """What a case stands on: "plinth" (set back, dark), "bracket" (boards cut out between the corners), or legs."""
    if style == "plinth":
        d.box(box.inset(back=0.01, front=0.04, y=0.02), SHADOW, bevel=0.0)
    elif style == "bracket":
        t, high = 0.02, box.height
        for side in (box.left(t), box.right(t)):
            d.box(side.inset(front=t), material)
        d.box(box.front(t).inset(bottom=0.55 * high), material)
        for end in (box.left(0.12), box.right(0.12)):
            d.box(end.front(t).bottom(0.55 * high), material, bevel=0.002)
    else:
        legs(d, box.inset(x=0.03, y=0.03), material, style)
    return box


def wheel(d: Drawing, box: Box, tyre: Look = "rubber", hub: Look = "steel") -> Box:
    """A wheel that turns about y and fills a box: a tyre, and a hub that shows on both sides."""
    d.cylinder(box, tyre, "y", bevel=0.15 * min(box.width, box.height), segments=20)
    with d.no_colliders():
        d.cylinder(box.inset(x=0.22 * box.depth, z=0.22 * box.height, y=-0.0003), hub, "y", segments=14)
    return box


def castors(d: Drawing, box: Box, fork: Look = "steel", wheel: Look = "black plastic") -> Box:
    """Four castors in the corners of a box, as high as it is: wheels along x in forks under plates."""
    r = 0.4 * box.height
    with d.corners(box, inset=r):
        d.cylinder(Box.around((0.0, 0.0, r), 2 * r, 0.6 * r, 2 * r), wheel, "y", bevel=0.1 * r, segments=16)
        d.cylinder(Box.around((0.0, 0.0, r), r, 0.7 * r, r), fork, "y", segments=10)
        d.hull([(s * 0.35 * r, t * 0.45 * r, z) for s in (-1, 1) for t in (-1, 1) for z in (1.1 * r, 2.4 * r)], fork)
        d.box(Box.sized(1.6 * r, 1.4 * r, 0.12 * r, (0.0, 0.0, 2.38 * r)), fork, bevel=0.0)
    return box


def star_base(d: Drawing, reach: float, top: float, metal: Look, castors: bool = True) -> None:
    """Five arms of ``reach`` about the frame's origin on castors or glides, and a gas lift up to a height."""
    tip, dark = reach - 0.03, "black plastic"
    with d.ring(5, 0.0, math.pi / 5):
        d.bar((0.03, 0.0, 0.11), (tip, 0.0, 0.078), 0.016, metal, segments=8)
        if castors:
            with d.at(tip, 0.0), d.mirror("x"):
                d.cylinder(Box((0.005, 0.023), (-0.028, 0.028), (0.0, 0.056)), dark, "x", bevel=0.003, segments=14)
            d.bar((tip, 0.0, 0.03), (tip, 0.0, 0.075), 0.008, dark, segments=6)
        else:
            d.bar((tip, 0.0, 0.0), (tip, 0.0, 0.075), 0.014, dark, segments=8)
    lift = 0.14 + 0.5 * (top - 0.14)
    d.cylinder(Box.sized(0.09, 0.09, 0.07, (0.0, 0.0, 0.07)), metal, ends=(1.0, 0.7), segments=16)
    d.cylinder(Box.sized(0.052, 0.052, lift - 0.14, (0.0, 0.0, 0.14)), dark, segments=14)
    d.cylinder(Box.sized(0.03, 0.03, top - lift, (0.0, 0.0, lift)), metal, segments=12)
