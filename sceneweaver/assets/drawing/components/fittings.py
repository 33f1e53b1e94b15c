"""Small fittings: knobs, buttons, taps, screens."""

from __future__ import annotations

import math
from contextlib import ExitStack

from ..box import Box
from ..drawing import PROUD, Drawing, Look

TURN = math.radians(270.0)
"""How far a knob turns [rad]."""


def knob(
    d: Drawing,
    face: Box,
    material: Look,
    radius: float = 0.02,
    reach: float = 0.02,
    mark: Look | None = None,
    name: str | None = None,
) -> None:
    """A turned knob in the middle of a box's front, with a mark at its top where one is asked for.

    One with a ``name`` is a control that a hand can turn clockwise.
    """
    x, y, z = face.anchor("front")
    with ExitStack() as stack:
        if name:
            stack.enter_context(d.hinge(name, (x, y, z), (-1.0, 0.0, 0.0), (0.0, TURN), "control"))
            grip = (x + max(0.011, 0.5 * reach), y, z)
            d.grasp("knob", grip, (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 2 * radius, 2 * radius)
        with d.at(x, y, z, pitch=math.pi / 2):
            profile = [(1.0, 0.0), (1.0, 0.3), (0.8, 0.4), (0.72, 1.0)]
            d.revolve([(radius * r, reach * s) for r, s in profile], material, 16)
        if mark:
            d.print(Box.around((x + reach, y, z + 0.42 * radius), 0.0, 0.12 * radius, 0.45 * radius), mark)


def button(d: Drawing, face: Box, material: Look, radius: float = 0.006, reach: float = 0.002) -> None:
    """A round button in the middle of a box's front."""
    x, y, z = face.anchor("front")
    d.cylinder(Box.around((x + reach / 2, y, z), reach, 2 * radius, 2 * radius), material, "x", segments=12)


def tap(
    d: Drawing,
    material: Look,
    reach: float = 0.14,
    height: float = 0.2,
    radius: float = 0.012,
    lever: bool = True,
    square: bool = False,
    name: str = "tap",
) -> None:
    """A mixer tap that stands at the frame's origin: its spout bends forward (+x) by ``reach`` at ``height`` [m].

    A ``square`` one is made of flat bars. Its lever is a control that is lifted.
    """
    d.cylinder(Box.sized(3.4 * radius, 3.4 * radius, 0.012), material, segments=16)
    if lever:
        end = (0.3 * reach, 3.2 * radius, 0.36 * height)
        share = (1.7 if square else 1.4) * radius / math.hypot(*end[:2])  # from the face of the stem
        foot = (share * end[0], share * end[1], (0.25 + 0.11 * share) * height)
        pivot = (foot[0], foot[1], foot[2] + 0.5 * radius)
        with d.hinge(name, pivot, (end[1], -end[0], 0.0), (0.0, 0.4), "control"):
            d.bar(foot, end, 0.5 * radius, material, segments=8)
    if square:
        stem = d.box(Box.sized(2.2 * radius, 2.6 * radius, height), material)
        spout = d.box(stem.top(1.6 * radius).to(x=(stem.x[0], reach)), material)
        d.box(spout.front(2 * radius).bottom(-radius).inset(all=0.001, top=-0.002), material, bevel=0.0)
        return
    d.cylinder(Box.sized(2.4 * radius, 2.4 * radius, 0.35 * height), material, segments=16)
    bend = min(0.5 * reach, 0.4 * height)
    steps = [k * math.pi / 8 for k in range(5)]
    over = [(bend - bend * math.cos(a), 0.0, height - bend + bend * math.sin(a)) for a in steps]
    drop = [(reach, 0.0, height - 0.25 * bend), (reach, 0.0, height - bend)]
    flat = [(reach - 0.4 * bend, 0.0, height)] if reach - 0.4 * bend > bend + 1e-3 else []
    d.sweep([(0.0, 0.0, 0.3 * height), *over, *flat, *drop], radius, material, segments=10)


def screen(d: Drawing, face: Box, picture: Look = "screen", rim: float = 0.008) -> Box:
    """A picture on the front of a box, inside a rim; returns its place."""
    place = face.front(0.0).inset(y=rim, z=rim)
    return d.print(place, picture)


def band(d: Drawing, box: Box, material: Look, ends: tuple[float, float] = (1.0, 1.0), proud: float = PROUD) -> None:
    """A printed band or label around a round body that fills a box, as wide as `Drawing.cylinder` with these ends."""
    with d.no_colliders():
        d.cylinder(box.inset(x=-proud, y=-proud), material, ends=ends)
