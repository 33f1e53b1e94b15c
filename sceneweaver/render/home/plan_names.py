"""Names and clear areas of rooms in a plan: on free floor where there is some, else where they cover least."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from PIL import Image, ImageDraw

from sceneweaver.home import Home, HomeRoom

from .. import palette
from ..canvas import Point, Text, line_height, text_width
from ..labels import CELL, window_sums
from ..shapes import Plan

Polygon = Sequence[tuple[float, float]]

_SIZES = (19.0, 17.0, 15.0, 13.0, 11.5, 10.0)  # of names [units]
_SMALL = 0.82  # size of areas, in sizes of names
_SQUARE = "2"  # raised: the font has no sign for it
_PAD = 5.0  # free around a label [units]


def room_titles(home: Home) -> dict[str, str]:
    """What each room is called: its kind, with a number where there are several."""
    kinds = Counter(room.type for room in home.rooms)
    seen: Counter[str] = Counter()
    titles = {}
    for room in home.rooms:
        seen[room.type] += 1
        words = " ".join(palette.words_of(room.type)) or room.id
        name = words[:1].upper() + words[1:]
        several = kinds[room.type] > 1 and room.type != "stairs"
        titles[room.id] = f"{name} {seen[room.type]}" if several else name
    return titles


def clear_area(room: HomeRoom) -> float:
    """The clear floor of a room [m2]."""
    return float(shapely.Polygon(room.outline).area)


@dataclass(frozen=True)
class _Form:
    """A way to write a label: size of the name [px], on how many lines, upright or level, with the area or without."""

    size: int
    lines: int
    upright: bool
    area: bool = True


def draw_name(plan: Plan, room: HomeRoom, title: str, obstacles: Iterable[Polygon]) -> None:
    """Write the name and the area of a room where neither walls nor the obstacles [m] are in the way, if it can be."""
    area = f"{clear_area(room):.1f} m"
    outline = plan.points(room.outline)
    left, top = min(x for x, _ in outline), min(y for _, y in outline)
    free, floor = _masks(plan, outline, [plan.points(polygon) for polygon in obstacles], (left, top))
    forms = list(_forms(plan, free.shape[0] > 1.25 * free.shape[1]))
    for form in forms:
        spot = _spot(free, floor, _extent(plan, form, title, area))
        if spot is not None:
            _write(plan, form, title, area, (left + spot[0] * CELL, top + spot[1] * CELL))
            return
    for form in forms[-4:]:
        spot = _least(free, floor, _extent(plan, form, title, area))
        if spot is not None:
            _write(plan, form, title, area, (left + spot[0] * CELL, top + spot[1] * CELL), halo=True)
            return


def _forms(plan: Plan, tall: bool) -> Iterable[_Form]:
    ways = ((2, False), (1, False), (2, True), (1, True)) if tall else ((2, False), (1, False))
    for units in _SIZES:
        for lines, upright in ways:
            yield _Form(plan.font_size(units), lines, upright)
    for upright in (False, True) if tall else (False,):
        yield _Form(plan.font_size(_SIZES[-2]), 1, upright, area=False)


def _extent(plan: Plan, form: _Form, title: str, area: str) -> tuple[int, int]:
    """Rows and columns of cells that a label takes."""
    small = round(form.size * _SMALL)
    name, figure = text_width(title, form.size), text_width(area, small) + 0.62 * small
    if not form.area:
        long, short = name, line_height(form.size)
    elif form.lines == 2:
        long, short = max(name, figure), line_height(form.size) + line_height(small)
    else:
        long, short = name + 0.6 * form.size + figure, line_height(form.size)
    # A tenth more than by the built-in font: a written plan is shown in whatever font there is.
    long, short = 1.1 * long + 2 * _PAD * plan.unit, short + _PAD * plan.unit
    rows, columns = (long, short) if form.upright else (short, long)
    return max(1, math.ceil(rows / CELL)), max(1, math.ceil(columns / CELL))


def _masks(
    plan: Plan, outline: list[Point], obstacles: list[list[Point]], corner: Point
) -> tuple[np.ndarray, np.ndarray]:
    """The free floor and the whole floor, bool [rows, columns] from the corner [px] on."""
    right, bottom = max(x for x, _ in outline), max(y for _, y in outline)
    size = (max(1, math.ceil((right - corner[0]) / CELL)), max(1, math.ceil((bottom - corner[1]) / CELL)))

    def cells(points: Iterable[Point]) -> list[Point]:
        return [((x - corner[0]) / CELL, (y - corner[1]) / CELL) for x, y in points]

    image = Image.new("L", size, 0)
    draw = ImageDraw.Draw(image)
    draw.polygon(cells(outline), fill=255)
    floor = np.array(image, dtype=bool)
    for polygon in obstacles:
        if len(polygon) > 2:
            draw.polygon(cells(polygon), fill=0, outline=0)
    return np.array(image, dtype=bool), floor


def _spot(free: np.ndarray, floor: np.ndarray, extent: tuple[int, int]) -> Point | None:
    """The middle [cells] of the free window that is nearest to the middle of the floor and of what is free of it."""
    rows, columns = extent
    if rows > free.shape[0] or columns > free.shape[1]:
        return None
    ys, xs = np.nonzero(window_sums(free.astype(np.float32), rows, columns) > rows * columns - 0.5)
    if not xs.size:
        return None
    middles = [np.argwhere(mask).mean(axis=0) for mask in (floor, free)]
    y, x = 0.5 * middles[0] + 0.5 * middles[1]
    best = int(np.argmin((xs + columns / 2 - x) ** 2 + (ys + rows / 2 - y) ** 2))
    return float(xs[best]) + columns / 2, float(ys[best]) + rows / 2


def _least(free: np.ndarray, floor: np.ndarray, extent: tuple[int, int]) -> Point | None:
    """The middle of the window within the floor that covers least."""
    rows, columns = extent
    if rows > free.shape[0] or columns > free.shape[1]:
        return None
    inside = window_sums(floor.astype(np.float32), rows, columns)
    covered = inside - window_sums(free.astype(np.float32), rows, columns)
    covered = covered + 10.0 * (rows * columns - inside)
    row, column = np.unravel_index(int(np.argmin(covered)), covered.shape)
    return float(column) + columns / 2, float(row) + rows / 2


def _write(plan: Plan, form: _Form, title: str, area: str, at: Point, halo: bool = False) -> None:
    small = round(form.size * _SMALL)
    name, figure, raised = text_width(title, form.size), text_width(area, small), round(0.66 * small)
    around = (max(2, round(2.6 * plan.unit)), (255, 255, 255)) if halo else (0, None)

    def put(text: str, along: float, across: float, size: int, color: palette.Rgb, bold: bool = False) -> None:
        """Text centred so many pixels along and across the direction of reading."""
        dx, dy = (across, -along) if form.upright else (along, across)
        place = (at[0] + dx, at[1] + dy)
        plan.text(Text((text,), place, size, color, around[1], around[0], upright=form.upright, bold=bold))

    if not form.area:
        put(title, 0.0, 0.0, form.size, palette.INK, True)
        return
    if form.lines == 2:
        shift, drop = 0.0, 0.5 * line_height(form.size)
        put(title, 0.0, -0.5 * line_height(small), form.size, palette.INK, True)
    else:
        whole = name + 0.6 * form.size + figure + 0.6 * raised
        put(title, -whole / 2 + name / 2, 0.0, form.size, palette.INK, True)
        shift, drop = whole / 2 - (figure + 0.6 * raised) / 2, 0.0
    tone = palette.darker(palette.MUTED, 0.35)
    put(area, shift - 0.3 * raised, drop, small, tone)
    put(_SQUARE, shift + figure / 2 + 0.05 * raised, drop - 0.32 * small, raised, tone)
