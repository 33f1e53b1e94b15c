"""What surrounds a plan on its sheet: title, axes, scale bar, key of symbols, categories and violations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from PIL import Image

from sceneweaver.render import palette
from sceneweaver.render.canvas import Canvas, Point, Text, text_width
from sceneweaver.render.labels import shortened
from sceneweaver.render.shapes import Bounds, Plan, step_for


@dataclass(frozen=True)
class Badge:
    """What the title says about the scene; ``good`` None: nobody checked it."""

    text: str
    good: bool | None


def draw_title(plan: Plan, title: str, facts: str, prompt: str, badge: Badge) -> Image.Image:
    """The head of the sheet."""
    width, unit = plan.width, plan.unit
    margin = 60 * unit
    canvas = Canvas(width, round((118 if not prompt else 148) * unit), palette.PAPER, unit)
    room = width - 2 * margin
    if badge.text:
        size = canvas.font_size(20)
        color = {True: palette.GOOD, False: palette.ALARM, None: palette.MUTED}[badge.good]
        wide = text_width(badge.text, size) + 44 * unit
        right, middle = width - margin, 58 * unit
        box = (right - wide, middle - 20 * unit, right, middle + 20 * unit)
        canvas.pill(box, 20 * unit, palette.mixed(palette.PAPER, color, 0.1), (*color, 120))
        canvas.disc((right - wide + 20 * unit, middle), 5 * unit, color)
        canvas.text(Text((badge.text,), (right - wide + 32 * unit, middle), size, color, anchor="l"))
        room -= wide + 20 * unit
    size = canvas.font_size(34, 9)
    canvas.text(Text((shortened(title, size, room),), (margin, 50 * unit), size, palette.INK, anchor="l", bold=True))
    size = canvas.font_size(18)
    canvas.text(Text((shortened(facts, size, room),), (margin, 88 * unit), size, palette.MUTED, anchor="l"))
    if prompt:
        line = shortened(f"“{prompt}”", size, width - 2 * margin)
        grey = palette.mixed(palette.MUTED, palette.FAINT, 0.5)
        canvas.text(Text((line,), (margin, 118 * unit), size, grey, anchor="l"))
    return canvas.finish()


def axes_at(plan: Plan, bounds: Bounds) -> Point:
    """Where the rules cross: the pixel column of the left one and the row of the lower one."""
    left, bottom = plan.point((bounds.x0, bounds.y0))
    return left - 56 * plan.unit, bottom + 34 * plan.unit


def draw_axes(plan: Plan, inner: Bounds, bounds: Bounds) -> None:
    """Rules with metre ticks below and to the left of the room."""
    size, unit = plan.font_size(15), plan.unit
    step = step_for(plan.scale, 34 * unit)
    left, bottom = axes_at(plan, bounds)
    x0, x1 = plan.point((inner.x0, 0))[0], plan.point((inner.x1, 0))[0]
    y0, y1 = plan.point((0, inner.y0))[1], plan.point((0, inner.y1))[1]
    plan.line(((x0, bottom), (x1, bottom)), palette.FAINT, 1.2)
    plan.line(((left, y0), (left, y1)), palette.FAINT, 1.2)
    # The exact ends of the room, as short strokes.
    for x in (x0, x1):
        plan.line(((x, bottom - 5 * unit), (x, bottom + 5 * unit)), palette.FAINT, 1.2)
    for y in (y0, y1):
        plan.line(((left - 5 * unit, y), (left + 5 * unit, y)), palette.FAINT, 1.2)
    for k in _ticks(inner.x0, inner.x1, step):
        x = plan.point((k, 0))[0]
        plan.line(((x, bottom), (x, bottom + 7 * unit)), palette.MUTED, 1.4)
        plan.text(Text((str(k),), (x, bottom + 21 * unit), size, palette.MUTED))
    for k in _ticks(inner.y0, inner.y1, step):
        y = plan.point((0, k))[1]
        plan.line(((left, y), (left - 7 * unit, y)), palette.MUTED, 1.4)
        plan.text(Text((str(k),), (left - 13 * unit, y), size, palette.MUTED, anchor="r"))
    plan.text(Text(("x [m]",), (x1 + 14 * unit, bottom), size, palette.MUTED, anchor="l"))
    plan.text(Text(("y [m]",), (left, y1 - 18 * unit), size, palette.MUTED))


def _ticks(low: float, high: float, step: int) -> range:
    return range(math.ceil(low / step - 1e-6) * step, math.floor(high / step + 1e-6) * step + 1, step)


@dataclass(frozen=True)
class Key:
    """Which signs a plan uses, for the line that explains them."""

    arrows: bool
    zones: bool
    openings: bool
    hanging: bool
    alarms: bool


def draw_footer(
    plan: Plan,
    key: Key,
    categories: Sequence[tuple[str, palette.Rgb, int]],
    notes: Sequence[str],
    alarms: Sequence[str],
) -> Image.Image:
    """The foot of the sheet: scale bar and key, then categories, then notes and violations."""
    width, unit = plan.width, plan.unit
    margin, row, size = 60 * unit, 30 * unit, plan.font_size(16)
    lines = _wrap_categories(categories, size, width - 2 * margin, unit)
    rows = len(lines) + 0.4 * bool(lines) + len(notes) + len(alarms) + 0.4 * bool(alarms)
    height = 86 * unit + row * rows
    canvas = Canvas(width, math.ceil(height), palette.PAPER, unit)
    canvas.line(((margin, 8 * unit), (width - margin, 8 * unit)), palette.GRID, 1.2)
    y = 42 * unit
    _draw_scale_bar(canvas, plan.scale, margin, y, size)
    _draw_key(canvas, key, width - margin, y, size)
    y += row * 1.2
    for line in lines:
        for x, name, color in line:
            canvas.pill((x, y - 8 * unit, x + 16 * unit, y + 8 * unit), 4 * unit, color, palette.darker(color, 0.5))
            canvas.text(Text((name,), (x + 24 * unit, y), size, palette.INK, anchor="l"))
        y += row
    y += 0.4 * row if lines else 0.0
    for note in notes:
        text = shortened(note, size, width - 2 * margin)
        canvas.text(Text((text,), (margin, y), size, palette.MUTED, anchor="l"))
        y += row
    y += 0.2 * row if alarms else 0.0
    for alarm in alarms:
        canvas.disc((margin + 4 * unit, y), 4 * unit, palette.ALARM)
        text = shortened(alarm, size, width - 2 * margin - 20 * unit)
        canvas.text(Text((text,), (margin + 18 * unit, y), size, palette.ALARM, anchor="l"))
        y += row
    return canvas.finish()


def _draw_scale_bar(canvas: Canvas, scale: float, x: float, y: float, size: int) -> None:
    """A bar of a round length of a quarter of the picture at most, in four alternating pieces."""
    metres = 0.1
    for candidate in (0.1, 0.2, 0.5, 1, 2, 4, 5, 10, 20, 40, 50, 100, 200, 400, 1000, 2000, 5000, 10000):
        if candidate * scale <= 0.23 * canvas.width:
            metres = candidate
    piece = metres * scale / 4
    tall = 4 * canvas.unit
    for k in range(4):
        box = _rectangle(x + k * piece, x + (k + 1) * piece, y, tall)
        canvas.polygon(box, palette.INK if k % 2 == 0 else palette.PAPER, palette.INK, 1.2)
    canvas.text(Text((f"{metres:g} m",), (x + 4 * piece + 12 * canvas.unit, y), size, palette.INK, anchor="l"))


def _rectangle(left: float, right: float, middle: float, tall: float) -> tuple[Point, ...]:
    return ((left, middle - tall), (right, middle - tall), (right, middle + tall), (left, middle + tall))


def _draw_key(canvas: Canvas, key: Key, right: float, y: float, size: int) -> None:
    """The signs in use, from the right edge leftward."""
    unit, dash = canvas.unit, (5, 3.5)
    wide, tall = 26 * unit, 9 * unit
    signs = (
        (key.alarms, "alarm", "violation"),
        (key.hanging, "hanging", "on wall, ceiling or shelf"),
        (key.openings, "opening", "door or window zone"),
        (key.zones, "zone", "keep free"),
        (key.arrows, "arrow", "front"),
    )
    x = right
    for used, sign, text in signs:
        if not used:
            continue
        x -= text_width(text, size)
        canvas.text(Text((text,), (x, y), size, palette.MUTED, anchor="l"))
        x -= 10 * unit
        box = _rectangle(x - wide, x, y, tall)
        if sign == "arrow":
            middle, h = x - wide / 2, 6 * unit
            canvas.line(((middle - 9 * unit, y), (middle + 4 * unit, y)), palette.INK, 2.4)
            canvas.polygon(((middle + 11 * unit, y), (middle + unit, y + h), (middle + unit, y - h)), fill=palette.INK)
        elif sign == "hanging":
            canvas.polygon(box, fill=(*palette.FAINT, 90))
            canvas.dashed(box, palette.MUTED, 1.3, dash, closed=True)
        elif sign == "alarm":
            canvas.polygon(box, fill=(*palette.ALARM, 40), line=palette.ALARM, width=2.4)
        else:
            color, angle = (palette.ZONE, 45) if sign == "zone" else (palette.OPENING, -45)
            canvas.hatch(box, (*color, 110), 1.0, 7, angle)
            canvas.dashed(box, (*color, 200), 1.1, dash, closed=True)
        x -= wide + 30 * unit


def _wrap_categories(
    categories: Sequence[tuple[str, palette.Rgb, int]], size: int, width: float, unit: float
) -> list[list[tuple[float, str, palette.Rgb]]]:
    """Rows of swatches with names and counts: (x, text, colour)."""
    rows: list[list[tuple[float, str, palette.Rgb]]] = []
    x = math.inf
    for name, color, count in categories:
        text = shortened(f"{name.replace('_', ' ')}  {count}", size, width / 3)
        wide = 24 * unit + text_width(text, size) + 30 * unit
        if x + wide > width + 60 * unit:
            if len(rows) == 4:
                break
            rows.append([])
            x = 60 * unit
        rows[-1].append((x, text, color))
        x += wide
    return rows
