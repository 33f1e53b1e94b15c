"""Floor, walls, doors and windows of a plan."""

from __future__ import annotations

import math

from sceneweaver.geometry.shell import WALL_THICKNESS, clear_zone, outer_outline
from sceneweaver.geometry.walls import Wall
from sceneweaver.render import palette
from sceneweaver.render.canvas import Color, Text, text_width
from sceneweaver.render.shapes import Plan, bounds_of, step_for
from sceneweaver.scene import Door, Room, Vec2, Window


def draw_floor(plan: Plan, room: Room) -> None:
    """The floor and, around it, the walls as one solid ring."""
    plan.polygon(plan.points(outer_outline(room.walls)), fill=palette.WALL)
    plan.polygon(plan.points(room.outline), fill=palette.FLOOR)


def draw_grid(plan: Plan, room: Room) -> None:
    """The one metre grid on the floor; where it would be too fine, a coarser one."""
    box = bounds_of(room.outline)
    step = step_for(plan.scale, 9 * plan.unit)
    outline = list(room.outline)
    for axis, low, high in ((0, box.x0, box.x1), (1, box.y0, box.y1)):
        for k in range(math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6) + 1):
            for a, b in _clipped(outline, axis, k * step):
                strong = k % 5 == 0 and step == 1 and plan.scale < 90 * plan.unit
                plan.line(plan.points((a, b)), palette.darker(palette.GRID, 0.06 if strong else 0.0), 1.1)


def _clipped(outline: list[Vec2], axis: int, value: float) -> list[tuple[Vec2, Vec2]]:
    """The pieces inside an outline of the line on which coordinate ``axis`` has a value."""
    other = 1 - axis
    hits = sorted(
        a[other] + (value - a[axis]) / (b[axis] - a[axis]) * (b[other] - a[other])
        for a, b in zip(outline, outline[1:] + outline[:1], strict=True)
        if (a[axis] <= value) != (b[axis] <= value)
    )
    ends = zip(hits[::2], hits[1::2], strict=False)
    return [((value, u), (value, v)) if axis == 0 else ((u, value), (v, value)) for u, v in ends]


def draw_opening_zones(plan: Plan, room: Room, alarmed: frozenset[str]) -> None:
    """The floor that doors and windows need free."""
    for opening in room.openings:
        color = palette.ALARM if opening.id in alarmed else palette.OPENING
        points = plan.points(clear_zone(opening, room.walls))
        plan.polygon(points, fill=(*color, 16))
        plan.hatch(points, (*color, 70), 1.0, 9, -45)
        plan.dashed(points, (*color, 130), 1.1, closed=True)


def draw_openings(plan: Plan, room: Room) -> None:
    """Windows in the walls; doors with their leaves and the arcs of their swing."""
    for window in room.windows:
        _draw_window(plan, room.walls[window.wall], window)
    for door in room.doors:
        _draw_door(plan, room.walls[door.wall], door)


def _draw_window(plan: Plan, wall: Wall, window: Window) -> None:
    t = WALL_THICKNESS
    frame = plan.points(wall.strip(window.offset, window.width, 0.0, -t))
    plan.polygon(frame, fill=palette.PAPER, line=palette.WALL, width=1.4)
    pane = plan.points(wall.strip(window.offset, window.width, -0.34 * t, -0.66 * t))
    plan.polygon(pane, fill=palette.GLASS, line=palette.darker(palette.OPENING, 0.2), width=1.2)


def _draw_door(plan: Plan, wall: Wall, door: Door) -> None:
    """The opening, its jambs and the leaf.

    ``left`` and ``right`` are those of somebody who comes in: an ``in-left`` door hangs at its offset.
    """
    t = WALL_THICKNESS
    start, end, width = door.offset, door.offset + door.width, door.width
    gap = plan.points(wall.strip(start, width, 0.002, -t - 0.002))
    plan.polygon(gap, fill=palette.lighter(palette.FLOOR, 0.45))
    for near, far in ((gap[0], gap[3]), (gap[1], gap[2])):
        plan.line((near, far), palette.WALL, 1.6)
    plan.line((gap[3], gap[2]), palette.FAINT, 1.0)
    leaf = min(0.045, width / 12)
    if door.swing == "slide":
        in_room = wall.strip(start + width * 0.5, width * 0.62, 0.02, 0.02 + leaf)
        in_wall = wall.strip(start, width * 0.5, -t / 2 - leaf / 2, -t / 2 + leaf / 2)
        for panel in (in_room, in_wall):
            plan.polygon(plan.points(panel), fill=palette.PAPER, line=palette.WALL, width=1.3)
        return
    side = 1.0 if door.swing == "in-right" else -1.0
    hinge = end if side > 0 else start
    into = -1.0 if door.swing == "out" else 1.0
    face = -t if door.swing == "out" else 0.0
    arc = []
    for step in range(41):
        angle = math.pi / 2 * step / 40
        arc.append(wall.point(hinge - side * width * math.cos(angle), face + into * width * math.sin(angle)))
    plan.line(plan.points(arc), (*palette.WALL, 150), 1.2)
    near, far = sorted((face, face + into * width))
    panel = plan.points(wall.strip(hinge - (leaf if side > 0 else 0.0), leaf, near, far))
    plan.polygon(panel, fill=palette.PAPER, line=palette.WALL, width=1.5)


def name_walls(plan: Plan, room: Room) -> None:
    """The ids of doors and windows beside them, and the numbers of the walls."""
    size = plan.font_size(13)
    for wall in room.walls:
        openings = room.openings_of(wall.index)
        taken = [(o.offset, o.offset + o.width) for o in openings]
        for opening in openings:
            out = opening.width if isinstance(opening, Door) and opening.swing == "out" else 0.0
            middle = opening.offset + opening.width / 2
            _beside(plan, wall, middle, out, opening.id, size, palette.MUTED)
        place = _free_middle(wall.length, taken)
        thick = WALL_THICKNESS * plan.scale
        text = f"wall:{wall.index}"
        if place is None or place[1] * plan.scale < text_width(text, size) + 12 * plan.unit:
            continue
        if thick >= size * 1.25:
            upright = abs(wall.along[1]) > abs(wall.along[0])
            at = plan.point(wall.point(place[0], -WALL_THICKNESS / 2))
            plan.text(Text((text,), at, size, palette.WALL_TEXT, upright=upright))
        else:
            _beside(plan, wall, place[0], 0.0, text, size, palette.FAINT)


def _free_middle(length: float, taken: list[tuple[float, float]]) -> tuple[float, float] | None:
    """Middle and length of the longest piece of a wall without openings."""
    at, best = 0.0, None
    for start, end in [*sorted(taken), (length, length)]:
        if best is None or start - at > best[1]:
            best = ((at + start) / 2, start - at)
        at = max(at, end)
    return best if best is not None and best[1] > 0 else None


def _beside(plan: Plan, wall: Wall, offset: float, out: float, text: str, size: int, color: Color) -> None:
    """Text on the outer side of a wall, along it where the wall is level or plumb."""
    x, y = plan.point(wall.point(offset, -WALL_THICKNESS - out))
    nx, ny = wall.outward[0], -wall.outward[1]  # outward, in the picture
    upright = abs(wall.along[1]) > 0.98
    half = size * 0.62 if upright or abs(wall.along[0]) > 0.98 else size * 0.62 + text_width(text, size) / 2 * abs(nx)
    at = (x + nx * (half + size * 0.35), y + ny * (half + size * 0.35))
    plan.text(Text((text,), at, size, color, palette.PAPER, 2, upright))
