"""What stands around a plan on its sheet: its title, the scale with a bar, and an arrow to the north."""

from __future__ import annotations

import math

from .. import palette
from ..canvas import Text, text_width
from ..labels import shortened
from ..shapes import Plan
from .plan_walls import LINE, POCHE

HEIGHT = 104.0
"""Height [units] of the strip under a plan."""

MARGIN = 44.0
"""Free at the edges of a sheet [units]."""

_BARS = (0.5, 1, 2, 4, 5, 10, 20, 40, 50)


def draw_frame(plan: Plan, title: str, line: str, facts: str, denominator: int, sheet_scale: bool = True) -> None:
    """The strip along the lower edge.

    Args:
        plan: What is drawn on.
        title: Set in bold, such as the name of the storey.
        line: Under it, such as the request; shortened where it is too long.
        facts: On the right, such as the area of the storey.
        denominator: Of the scale of the sheet on paper: 50 for 1:50.
        sheet_scale: Whether to write it.
    """
    unit, margin = plan.unit, MARGIN * plan.unit
    top = plan.height - HEIGHT * unit
    plan.line(((margin, top), (plan.width - margin, top)), palette.FAINT, 1.0)
    radius = 23 * unit
    north = (plan.width - margin - radius, top + 50 * unit)
    draw_north(plan, north, radius)
    size = plan.font_size(15)
    bar, wide = _scale_bar(plan.scale, 0.24 * plan.width)
    right = north[0] - radius - 34 * unit
    y = top + 58 * unit
    x = right - wide
    _draw_bar(plan, x, y, bar, wide)
    words = f"1:{denominator}" if sheet_scale else "Scale"
    plan.text(Text((words,), (x, top + 28 * unit), size, palette.INK, anchor="l", bold=True))
    plan.text(Text((facts,), (right, top + 28 * unit), size, palette.INK, anchor="r"))
    room = max(x, margin) - margin - 30 * unit
    big = plan.font_size(25)
    plan.text(Text((shortened(title, big, room),), (margin, top + 34 * unit), big, palette.INK, anchor="l", bold=True))
    if line:
        small = plan.font_size(15)
        text = shortened(line, small, room)
        plan.text(Text((text,), (margin, top + 67 * unit), small, palette.MUTED, anchor="l"))


def least_width(facts: str) -> float:
    """The least width of a sheet [units] on which title, bar and arrow have room."""
    return 2 * MARGIN + 560.0 + 0.5 * text_width(facts, 15)


def _scale_bar(scale: float, most: float) -> tuple[float, float]:
    """The length of the bar [m] and in pixels."""
    metres = max((bar for bar in _BARS if bar * scale <= most), default=_BARS[0])
    return metres, metres * scale


def _draw_bar(plan: Plan, x: float, y: float, metres: float, wide: float) -> None:
    pieces = 4 if metres in (2, 4, 20, 40) else 5
    tall, size = 4 * plan.unit, plan.font_size(13)
    for k in range(pieces):
        a, b = x + k * wide / pieces, x + (k + 1) * wide / pieces
        box = ((a, y - tall), (b, y - tall), (b, y + tall), (a, y + tall))
        plan.polygon(box, POCHE if k % 2 == 0 else (255, 255, 255), POCHE, 1.0)
    for share in (0.0, 0.5, 1.0):
        text = f"{share * metres:g}" + (" m" if share == 1.0 else "")
        plan.text(Text((text,), (x + share * wide, y + 18 * plan.unit), size, LINE))


def draw_north(plan: Plan, at: tuple[float, float], radius: float) -> None:
    """A needle in a circle that points up, which is north (+y)."""
    x, y = at
    ring = [(x + radius * math.cos(k * math.tau / 64), y + radius * math.sin(k * math.tau / 64)) for k in range(65)]
    plan.line(ring, LINE, 1.1)
    tip, tail, side = (x, y - 0.86 * radius), (x, y + 0.42 * radius), 0.42 * radius
    plan.polygon((tip, tail, (x - side, y + 0.72 * radius)), fill=POCHE, line=POCHE, width=1.0)
    plan.polygon((tip, tail, (x + side, y + 0.72 * radius)), fill=(255, 255, 255), line=POCHE, width=1.0)
    plan.text(Text(("N",), (x, y - radius - 11 * plan.unit), plan.font_size(15), palette.INK, bold=True))
