"""Furniture of a plan: shadows, parts from the lowest to the highest, symbols, zones, arrows and what is hidden."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.shell import outer_outline
from sceneweaver.render import labels, palette
from sceneweaver.render.canvas import Point
from sceneweaver.render.palette import Rgb
from sceneweaver.render.shapes import Plan, Prism, bounds_of, cut, inside, layers, prisms, to_world
from sceneweaver.render.symbols import strokes_of
from sceneweaver.scene import Room, Scene, SceneObject

_VEIL = 105  # opacity, of 255, of what is drawn translucent
HANGING = 100  # layers from here on hang on a wall or from the ceiling


@dataclass(frozen=True)
class Item:
    """An object ready to draw."""

    obj: SceneObject
    layer: int
    fill: Rgb
    solids: tuple[Prism, ...]
    enclosed: bool  # inside its supporter, such as on a shelf of a bookcase
    under: Rgb  # the colour of what it stands on or hangs before

    @property
    def id(self) -> str:
        """The object's id."""
        return self.obj.id

    @property
    def top(self) -> float:
        """Height of its highest point."""
        return max(p.top for p in self.solids)

    @property
    def translucent(self) -> bool:
        """Whether it is drawn dashed, with what is below it shining through."""
        return self.enclosed or self.obj.mount in ("wall", "ceiling")

    @property
    def ground(self) -> Rgb:
        """The colour that text on it stands on."""
        return palette.mixed(self.under, self.fill, _VEIL / 255) if self.translucent else self.fill

    @property
    def line(self) -> Rgb:
        """The colour of its outlines."""
        return palette.darker(self.fill, 0.6)


def items_of(scene: Scene) -> list[Item]:
    """All objects in an order that does not depend on the order in the scene."""
    layer = layers(scene)
    solids = {o.id: tuple(prisms(o)) for o in scene.objects}
    fills = {o.id: palette.fill_of(o) for o in scene.objects}
    out = []
    for obj in scene.objects:
        own = solids[obj.id]
        enclosed, under = False, palette.FLOOR
        if obj.mount == "surface" and obj.support is not None and obj.support.object in solids:
            under = fills[obj.support.object]
            x, y, _ = obj.pose.position
            top = max(p.top for p in own)
            enclosed = any(p.top > top + 1e-3 and inside(p.polygon, x, y) for p in solids[obj.support.object])
        out.append(Item(obj, layer[obj.id], fills[obj.id], own, enclosed, under))
    return sorted(out, key=lambda i: (i.layer, round(i.top, 4), i.id))


def painted(items: Sequence[Item]) -> list[tuple[Item, int]]:
    """Parts in painting order: by layer, then by height."""
    parts = [(item, k) for item in items for k in range(len(item.solids))]
    return sorted(parts, key=lambda p: (p[0].layer, round(p[0].solids[p[1]].top, 4), p[0].id, p[1]))


def draw_zones(plan: Plan, items: Sequence[Item], alarmed: frozenset[str]) -> None:
    """Space that objects keep free: hard zones hatched, soft ones only outlined."""
    for item in items:
        color = palette.ALARM if item.id in alarmed else palette.ZONE
        for zone in item.obj.zones:
            points = plan.points(to_world(item.obj.pose, zone.polygon))
            if zone.hard:
                plan.polygon(points, fill=(*color, 14))
                plan.hatch(points, (*color, 62), 1.0, 9, 45)
            plan.dashed(points, (*color, 140), 1.1, closed=True)


def draw_items(plan: Plan, items: Sequence[Item], room: Room, shadows: bool = True) -> None:
    """All objects, lowest first; with ``shadows`` each layer throws a soft one on what lies under it."""
    floor = plan.points(room.outline)
    floor_level = [i for i in items if i.layer == 0]
    on_top = [i for i in items if 0 < i.layer < HANGING and not i.translucent]
    if shadows:
        _draw_shadows(plan, floor_level, floor)
    _draw_layer(plan, floor_level)
    if on_top and shadows:
        _draw_shadows(plan, on_top, floor)
    _draw_layer(plan, [i for i in items if 0 < i.layer < HANGING])
    _draw_hidden(plan, floor_level)
    _draw_layer(plan, [i for i in items if i.layer >= HANGING])


def _draw_shadows(plan: Plan, items: Sequence[Item], floor: Sequence[Point]) -> None:
    cast = []
    for item in items:
        base = min(p.bottom for p in item.solids)
        for p in item.solids:
            reach = min(0.025 + 0.03 * max(p.top - base, 0.0), 0.08) * plan.scale
            cast.append((plan.points(p.polygon), (reach * 0.75, reach)))
    blur = min(max(0.022 * plan.scale, 0.6 * plan.unit), 10 * plan.unit)
    plan.shadow(cast, floor, (70, 55, 40, 92), blur)


def _draw_layer(plan: Plan, items: Sequence[Item]) -> None:
    for item, k in painted(items):
        p = item.solids[k]
        points = plan.points(p.polygon)
        fine = _line_width(plan, item)
        if item.translucent:
            plan.polygon(points, fill=(*item.fill, _VEIL))
            plan.dashed(points, item.line, fine, (5, 3.5), closed=True)
            continue
        # Seats are a shade lighter than backs, shelves darker than tops: height reads at a glance.
        rise = (item.top - p.top) / max(item.top - item.solids[0].bottom, 1e-6) if len(item.solids) > 1 else 0.0
        plan.polygon(points, fill=palette.lighter(item.fill, 0.22 * min(max(rise, 0.0), 1.0)))
        plan.line([*points, *points[:2]], item.line, fine)
        if k == _symbol_part(item):
            _draw_symbol(plan, item)


def _line_width(plan: Plan, item: Item) -> float:
    """Thinner lines for small things, in units."""
    small = min(item.obj.size[0], item.obj.size[1]) * plan.scale
    return min(max(0.9 + small / (130 * plan.unit), 1.0), 1.9)


def _symbol_part(item: Item) -> int:
    """The part that carries the plan symbol: the only one, or the highest of those that make up most of the box."""
    whole = item.obj.size[0] * item.obj.size[1]
    large = [k for k, p in enumerate(item.solids) if abs(signed_area(p.polygon)) > 0.7 * whole]
    return max(large, key=lambda k: (item.solids[k].top, k), default=-1)


def _draw_symbol(plan: Plan, item: Item) -> None:
    depth, width, _ = item.obj.size
    if min(depth, width) * plan.scale < 16 * plan.unit:
        return
    fine = max(0.7, 0.55 * _line_width(plan, item))
    for stroke in strokes_of(item.obj.category, depth, width):
        points = plan.points(to_world(item.obj.pose, stroke.points))
        if stroke.tone is None:
            plan.line(points, (*item.line, 150), fine * stroke.weight)
            continue
        tone = palette.lighter(item.fill, stroke.tone) if stroke.tone > 0 else palette.darker(item.fill, -stroke.tone)
        plan.polygon(points, fill=tone)
        plan.line([*points, *points[:2]], (*item.line, 120), fine * stroke.weight)


def _draw_hidden(plan: Plan, items: Sequence[Item]) -> None:
    """Dashed lines for what stands under something higher, such as a chair tucked under a table."""
    if plan.scale < 55 * plan.unit:
        return
    for item in items:
        x, y, reach = _disc(item)
        above = []
        for other in items:
            ox, oy, oreach = _disc(other)
            if other.id != item.id and math.hypot(ox - x, oy - y) < reach + oreach:
                above += [(other, p) for p in other.solids]
        p = max(item.solids, key=lambda s: (abs(signed_area(s.polygon)), s.top))
        for a, b in zip(p.polygon, [*p.polygon[1:], p.polygon[0]], strict=True):
            for other, q in above:
                share = cut(a, b, q.polygon) if q.bottom > p.top - 1e-3 else None
                if share is not None:
                    ends = [(a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t) for t in share]
                    plan.dashed(plan.points(ends), (*other.line, 120), 1.0, (4.5, 3.5))


def _disc(item: Item) -> tuple[float, float, float]:
    """A circle around an object: its centre and radius in metres."""
    x, y, _ = item.obj.pose.position
    return x, y, max(math.hypot(px - x, py - y) for p in item.solids for px, py in p.polygon)


def owner_grid(plan: Plan, items: Sequence[Item], room: Room) -> tuple[np.ndarray, np.ndarray]:
    """Who is on top in each cell of the picture (an index in ``items`` plus one), and which cells are edges."""
    scale = 1 / labels.CELL
    shape = (math.ceil(plan.width * scale), math.ceil(plan.height * scale))
    grid = Image.new("I", shape, labels.PAPER_OWNER)
    edges = Image.new("L", shape, 0)
    draw, draw_edge = ImageDraw.Draw(grid), ImageDraw.Draw(edges)

    def fill(points: Sequence[Point], value: int) -> None:
        small = [(x * scale, y * scale) for x, y in points]
        draw.polygon(small, fill=value)
        draw_edge.polygon(small, fill=0, outline=1)

    fill(plan.points(outer_outline(room.walls)), labels.WALL_OWNER)
    fill(plan.points(room.outline), labels.FLOOR_OWNER)
    index = {item.id: k + 1 for k, item in enumerate(items)}
    for item, k in painted(items):
        fill(plan.points(item.solids[k].polygon), index[item.id])
    return np.array(grid, dtype=np.int32), np.array(edges, dtype=bool)


def label_of(plan: Plan, item: Item, owner: int, text: str, below: int = 0) -> labels.Wanted:
    """The label that an object wants, which is number ``owner`` in the grid, on number ``below``."""
    box = bounds_of([p for solid in item.solids for p in plan.points(solid.polygon)])
    middle = ((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
    return labels.Wanted(item.id, owner, item.obj.category, text, middle, box.width * box.height, below)


def draw_arrows(plan: Plan, items: Sequence[Item], owners: np.ndarray) -> None:
    """An arrow at the front of each object, where the object is visible; its cells are kept free of labels."""
    unit = plan.unit
    for k, item in enumerate(items):
        depth, width, _ = item.obj.size
        small = min(depth, width) * plan.scale
        if small < 24 * unit or _is_round(item):
            continue
        head = min(0.15 * small, 8.5 * unit) / plan.scale  # metres, as all that follows
        front = _front_edge(item) - min(0.35 * head, 3 * unit / plan.scale)
        long = 1.1 * head if small > 110 * unit else 0.0
        # As far forward as it can be seen: with a stem, else without one, else further back.
        places = [(0.0, long), *((0.06 * step * depth, 0.0) for step in range(9))]
        for back, stem in places:
            tip = front - back
            base, tail = tip - 1.25 * head, tip - 1.25 * head - stem
            if tail < -depth / 2 or not _is_visible(plan, item, owners, k + 1, (tip - 0.2 * head, tail)):
                continue
            local = ((tip, 0.0), (base, 0.72 * head), (base, -0.72 * head), (tail, 0.0), (base, 0.0))
            points = plan.points(to_world(item.obj.pose, local))
            color = palette.darker(item.fill, 0.72) if palette.ink_on(item.ground) == palette.INK else palette.PAPER
            if stem:
                plan.line((points[3], points[4]), color, max(1.0 / unit, 0.26 * head * plan.scale / unit))
            plan.polygon(points[:3], fill=color)
            xs, ys = zip(*points, strict=True)
            owners[labels.cells(min(xs), min(ys), max(xs), max(ys))] = labels.MARK_OWNER
            break


def _is_round(item: Item) -> bool:
    """Whether an object looks the same from all sides, so that it has no front to speak of."""
    for p in item.obj.solids:
        reach = [math.hypot(x, y) for x, y in p.polygon]
        if len(reach) < 6 or max(reach) > 1.05 * min(reach):
            return False
    return True


def _front_edge(item: Item) -> float:
    """How far the front of an object reaches on its middle line: less than half its depth for an L-shaped one."""
    half = item.obj.size[0] / 2
    reach = []
    for part in item.obj.solids:
        share = cut((-half, 0.0), (half, 0.0), part.polygon)
        if share is not None:
            reach.append(-half + 2 * half * share[1])
    return max(reach, default=half)


def _is_visible(plan: Plan, item: Item, owners: np.ndarray, owner: int, along: Sequence[float]) -> bool:
    """Whether points on the middle line of an object, at these distances before its centre, are uncovered."""
    for x, y in plan.points(to_world(item.obj.pose, [(at, 0.0) for at in along])):
        row, col = int(y / labels.CELL), int(x / labels.CELL)
        if not (0 <= row < owners.shape[0] and 0 <= col < owners.shape[1] and owners[row, col] == owner):
            return False
    return True
