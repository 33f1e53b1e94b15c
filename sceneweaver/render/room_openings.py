"""Doors with frame, leaf and handle; windows with frame, bars, panes, sill and the daylight behind them."""

from __future__ import annotations

import numpy as np

from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Door, Window

from .room_blocks import Builder, Range, wall_block
from .room_finish import Finishes

_AJAR = 0.42  # how far a leaf stands open [rad]
_BAR = 0.055


def add_door(builder: Builder, wall: Wall, door: Door, look: Finishes) -> None:
    """A door in its opening; leaves that swing in stand ajar."""
    start, end, top = door.offset, door.offset + door.width, door.height
    bar = min(_BAR, door.width / 5, top / 8)
    deep = (-0.015, WALL_THICKNESS + 0.012)
    for s in ((start - 0.03, start + bar), (end - bar, end + 0.03)):
        builder.prism(wall_block(wall, s, deep), (0.0, top + 0.03), look.trim)
    builder.prism(wall_block(wall, (start + bar, end - bar), deep), (top - bar, top + 0.03), look.trim)
    builder.prism(wall_block(wall, (start, end), (0.0, WALL_THICKNESS)), (-0.002, 0.006), look.leaf)
    inner, wide = start + bar, door.width - 2 * bar
    if door.swing == "slide":
        _leaf(builder, wall, (inner, -0.05), 0.0, wide, 0.0, top - bar, look, 1.0)
        return
    # Left and right are those of somebody who comes in: an in-left door hangs at its offset.
    at_end = door.swing == "in-right"
    angle = _AJAR if door.swing != "out" else 0.0
    hinge = (inner + wide if at_end else inner, 0.004)
    _leaf(builder, wall, hinge, angle, wide, 0.008, top - bar, look, -1.0 if at_end else 1.0)


def _leaf(
    builder: Builder,
    wall: Wall,
    hinge: tuple[float, float],
    angle: float,
    width: float,
    low: float,
    high: float,
    look: Finishes,
    way: float,
) -> None:
    """A leaf from its hinge (s, t) toward ``way`` along the wall, turned into the room by ``angle``."""
    along = np.array([way * np.cos(angle), -np.sin(angle)])
    across = np.array([way * np.sin(angle), np.cos(angle)])

    def block(a: Range, b: Range) -> np.ndarray:
        corners = [
            np.asarray(hinge) + along * u + across * v
            for u, v in ((a[0], b[1]), (a[1], b[1]), (a[1], b[0]), (a[0], b[0]))
        ]
        plan = np.array([wall.point(offset, -out) for offset, out in corners])
        return plan if way > 0 else plan[::-1]

    builder.prism(block((0.0, width), (0.0, 0.04)), (low, high), look.leaf)
    # Two sunk panels, as thin raised frames would be: a lighter field with a shadow line around it.
    if width > 0.5 and high > 1.4:
        for z in ((0.12, 0.45 * high), (0.52 * high, high - 0.14)):
            builder.prism(block((0.12, width - 0.12), (-0.006, 0.046)), z, look.leaf)
        for side in ((-0.055, -0.04), (0.08, 0.095)):
            builder.prism(block((width - 0.19, width - 0.05), side), (1.0, 1.022), look.metal)
        builder.prism(block((width - 0.07, width - 0.05), (-0.055, 0.095)), (1.0, 1.022), look.metal)


def add_window(builder: Builder, wall: Wall, window: Window, look: Finishes) -> None:
    """A window in its opening, with a board on its sill and daylight outside."""
    start, end = window.offset, window.offset + window.width
    low, high = window.sill, window.sill + window.height
    bar = min(_BAR, window.width / 6, window.height / 6)
    deep = (0.35 * WALL_THICKNESS, 0.35 * WALL_THICKNESS + 0.05)
    for s in ((start, start + bar), (end - bar, end)):
        builder.prism(wall_block(wall, s, deep), (low, high), look.trim)
    for z in ((low, low + bar), (high - bar, high)):
        builder.prism(wall_block(wall, (start + bar, end - bar), deep), z, look.trim)
    panes = max(1, round(window.width / 0.85))
    thin = (deep[0] + 0.008, deep[1] - 0.008)
    for k in range(1, panes):
        at = start + window.width * k / panes
        builder.prism(wall_block(wall, (at - 0.02, at + 0.02), thin), (low + bar, high - bar), look.trim)
    if window.height > 1.1:
        rail = high - 0.3 * window.height
        builder.prism(wall_block(wall, (start + bar, end - bar), thin), (rail - 0.016, rail + 0.016), look.trim)
    middle = (deep[0] + deep[1]) / 2
    builder.prism(
        wall_block(wall, (start + bar, end - bar), (middle, middle + 0.004)), (low + bar, high - bar), look.glass
    )
    if low > 0.1:  # one down to the floor has no board
        builder.prism(wall_block(wall, (start - 0.04, end + 0.04), (-0.07, deep[0])), (low - 0.028, low), look.trim)
    builder.prism(wall_block(wall, (start, end), (deep[1] + 0.01, deep[1] + 0.012)), (low, high), look.daylight)
