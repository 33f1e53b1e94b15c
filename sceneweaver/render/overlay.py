"""What is written over a picture from above: axes, a grid, boxes with names and fronts, and a key of small things."""

from __future__ import annotations

import colorsys
import math
from collections.abc import Sequence

import numpy as np
from PIL import Image

from sceneweaver.io.messages import shorten
from sceneweaver.scene import Scene, SceneObject

from . import labels, palette
from .canvas import Text, text_width
from .palette import Rgb
from .plan_objects import items_of, label_of, owner_grid
from .shapes import Plan, View, bounds_of, step_for, to_world
from .topview import printable

X_AXIS: Rgb = (204, 44, 40)
Y_AXIS: Rgb = (40, 150, 62)
Z_AXIS: Rgb = (44, 92, 208)
FREE: Rgb = (0, 118, 128)
_GRID = (30, 34, 42)
_LONGEST = 40  # characters of an id that are written


class Overlay(Plan):
    """A canvas that begins with a picture on paper; ``view`` brings metres to pixels of the picture.

    Attributes:
        left, right, low: The edges of the picture on the canvas [pixels].
    """

    def __init__(self, picture: Image.Image, view: View, unit: float, key: int) -> None:
        """Paste the picture; ``key`` [pixels] is kept free at the right."""
        self.left, self.low = round(40 * unit), picture.height
        self.right = self.left + picture.width
        shifted = View(view.scale, view.left - self.left / view.scale, view.top)
        super().__init__(self.right + key, self.low + round(38 * unit), shifted, unit)
        size = (picture.width * self._s, picture.height * self._s)
        self._image.paste(picture.resize(size, Image.Resampling.NEAREST), (self.left * self._s, 0))


def annotated(picture: Image.Image, scene: Scene, view: View, text: float = 1.0) -> Image.Image:
    """The picture with its notes; ``view`` brings metres to pixels of the picture.

    Things on the floor carry their id; small and hanging ones a number that the key at the right explains. ``text``
    makes what is written larger.
    """
    unit = text * picture.height / 960
    size = max(9, round(13 * unit))
    large = [o for o in scene.objects if o.mount == "floor"]
    small = sorted((o for o in scene.objects if o.mount != "floor"), key=lambda o: (o.mount, _support(o), o.id))
    columns, wide = _key_columns(small, picture.height, size)
    plan = Overlay(picture, view, unit, round(14 * unit) + sum(wide))
    _grid(plan, scene)
    for thing in sorted(large, key=lambda o: (-o.size[0] * o.size[1], o.id)):
        _box(plan, thing, 1.0, dashed=False)
    for thing in small:
        _box(plan, thing, 0.7, dashed=thing.mount != "surface")
    discs, radius = _discs(plan, small)
    _free_floor(plan, scene)
    _names(plan, scene, large, discs, radius)
    _numbers(plan, small, discs, radius)
    _key(plan, columns, wide, plan.right + 14 * unit, size)
    _axes(plan)
    return plan.finish()


def _name(text: str) -> str:
    """An id as it is written: in letters that the font has, and not so long that the key outgrows the picture."""
    return shorten(printable(text) or "?", _LONGEST)


def color_of(category: str) -> Rgb:
    """A strong colour for a category: the hue of its family."""
    r, g, b = (c / 255 for c in palette.category_color(category))
    hue, _, strength = colorsys.rgb_to_hls(r, g, b)
    r, g, b = colorsys.hls_to_rgb(hue, 0.38, min(0.85, 0.45 + strength))
    return round(255 * r), round(255 * g), round(255 * b)


def _support(thing: SceneObject) -> str:
    return thing.support.object if thing.support is not None else ""


def _grid(plan: Overlay, scene: Scene) -> None:
    """Lines every metre (more in large rooms) inside the room's bounds, with coordinates at the picture's edge."""
    box = bounds_of(scene.room.outline)
    unit, left, low = plan.unit, plan.left, plan.low
    step, size = step_for(plan.scale, 34 * unit), plan.font_size(14, 9)
    plan.text(Text(("[m]",), (left / 2, low + 19 * unit), size, palette.MUTED))
    for value in range(math.ceil(box.x0 / step) * step, math.floor(box.x1 + 1e-6) + 1, step):
        (x, y0), (_, y1) = plan.point((value, box.y0)), plan.point((value, box.y1))
        plan.line(((x, y0), (x, y1)), (*_GRID, 62), 1.1)
        plan.text(Text((str(value),), (x, low + 19 * unit), size, X_AXIS))
    for value in range(math.ceil(box.y0 / step) * step, math.floor(box.y1 + 1e-6) + 1, step):
        (x0, y), (x1, _) = plan.point((box.x0, value)), plan.point((box.x1, value))
        plan.line(((x0, y), (x1, y)), (*_GRID, 62), 1.1)
        plan.text(Text((str(value),), (left - 8 * unit, y), size, Y_AXIS, anchor="r"))


def _axes(plan: Plan) -> None:
    """Half a metre of each axis from the origin; z comes out of the picture."""
    unit, origin, size, halo = plan.unit, plan.point((0.0, 0.0)), plan.font_size(16, 10), plan.font_size(2, 1)
    long, head = min(0.6 * plan.scale, 70 * unit), 9 * unit
    for (dx, dy), color, name in (((1, 0), X_AXIS, "X"), ((0, -1), Y_AXIS, "Y")):
        tip = (origin[0] + dx * long, origin[1] + dy * long)
        base = (tip[0] - dx * head, tip[1] - dy * head)
        wing = 0.5 * head
        plan.line((origin, base), (255, 255, 255, 210), 5.5)
        plan.line((origin, base), color, 3.2)
        barbs = ((base[0] + side * dy * wing, base[1] + side * dx * wing) for side in (1, -1))
        plan.polygon([tip, *barbs], fill=color)
        at = (tip[0] + dx * 10 * unit, tip[1] + dy * 10 * unit)
        plan.text(Text((name,), at, size, color, palette.PAPER, halo, bold=True))
    plan.disc(origin, 8 * unit, (255, 255, 255), Z_AXIS)
    plan.disc(origin, 3 * unit, Z_AXIS)
    at = (origin[0] - 14 * unit, origin[1] + 14 * unit)
    plan.text(Text(("Z",), at, size, Z_AXIS, palette.PAPER, halo, bold=True))


def _box(plan: Plan, thing: SceneObject, bold: float, dashed: bool) -> None:
    """The rotated box of an object, and an arrow from its middle over its front edge; ``bold`` are its lines."""
    unit = bold * plan.unit
    d, w, _ = thing.size
    color = color_of(thing.category)
    corners = plan.points(to_world(thing.pose, ((d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2), (-d / 2, -w / 2))))
    if dashed:
        plan.dashed(corners, (*color, 235), 1.6 * bold, (7 * bold, 4 * bold), closed=True)
    else:
        plan.polygon(corners, fill=(*color, 12))
        plan.line([*corners, corners[0], corners[1]], (255, 255, 255, 120), 4.0 * bold)
        plan.line([*corners, corners[0], corners[1]], (*color, 255), 2.2 * bold)
    if min(d, w) * plan.scale < 14 * unit or dashed:
        return
    # Outside of the box, where it hides nothing of it: a short stem with a head.
    out, head = 15 * unit / plan.scale, 8 * unit / plan.scale
    tip = d / 2 + out
    stem = plan.points(to_world(thing.pose, ((d / 2, 0.0), (tip - head, 0.0))))
    barb = plan.points(to_world(thing.pose, ((tip, 0.0), (tip - head, 0.6 * head), (tip - head, -0.6 * head))))
    plan.line(stem, color, 2.6 * bold)
    plan.polygon(barb, fill=color)


def _free_floor(plan: Plan, scene: Scene) -> None:
    """The dashed outline of each rectangle and circle of free floor, with its size."""
    for area in scene.free_areas:
        if area.kind not in ("rectangle", "circle"):
            continue
        depth, width = area.size
        if area.kind == "circle":
            turns = np.linspace(0.0, 2 * math.pi, 48, endpoint=False)
            outline = [(depth / 2 * math.cos(turn), depth / 2 * math.sin(turn)) for turn in turns]
            size = f"{depth:.2f} m"
        else:
            outline = [
                (depth / 2, -width / 2),
                (depth / 2, width / 2),
                (-depth / 2, width / 2),
                (-depth / 2, -width / 2),
            ]
            size = f"{depth:.2f} x {width:.2f} m"
        plan.dashed(plan.points(to_world(area.pose, outline)), (*FREE, 235), 1.8, (7, 4), closed=True)
        at, halo = plan.point(area.pose.position[:2]), plan.font_size(2.6, 2)
        plan.text(Text(("free", size), at, plan.font_size(13, 9), FREE, (255, 255, 255), halo))


def _names(plan: Plan, scene: Scene, large: Sequence[SceneObject], discs: np.ndarray, radius: float) -> None:
    """The id of each thing on the floor, inside its outline or beside it, never over another name or a disc."""
    items = items_of(scene.model_copy(update={"objects": tuple(large)}))
    owners, edges = owner_grid(plan, items, scene.room)
    for x, y in discs:
        owners[labels.cells(x - radius, y - radius, x + radius, y + radius)] = labels.MARK_OWNER
    wanted = [label_of(plan, item, k, _name(item.id)) for k, item in enumerate(items, 1)]
    category = {o.id: o.category for o in large}
    for label in labels.place(wanted, owners, edges, [plan.font_size(s) for s in (17, 14, 12)]).placed:
        color = palette.darker(color_of(category[label.key]), 0.35)
        if label.leader is not None:
            plan.leader(label.leader, color, (255, 255, 255, 180), 1.3)
        halo = plan.font_size(2.6, 2)
        plan.text(Text(label.lines, label.at, label.size, color, (255, 255, 255), halo, label.upright))


def _discs(plan: Overlay, small: Sequence[SceneObject]) -> tuple[np.ndarray, float]:
    """Where the discs of small things go, [N, 2] pixels, and how large they are: moved apart where they would meet."""
    radius = (8.5 if len(small) <= 60 else 7.0) * plan.unit
    true = np.array([plan.point(o.pose.position[:2]) for o in small]).reshape(-1, 2)
    low, high = np.array([plan.left, 0.0]) + radius, np.array([plan.right, plan.low]) - radius
    return (_apart(true, 2 * radius + 1.0, low, high) if len(true) else true), radius


def _numbers(plan: Plan, small: Sequence[SceneObject], discs: np.ndarray, radius: float) -> None:
    """A numbered disc at each small thing, with a line to it where the disc had to move."""
    spots = [(float(x), float(y)) for x, y in discs]
    for spot, thing in zip(spots, small, strict=True):
        at = plan.point(thing.pose.position[:2])
        if math.dist(at, spot) > radius:
            plan.line((at, spot), (*palette.INK, 170), 1.1)
            plan.disc(at, 2.0 * plan.unit, color_of(thing.category))
    size = max(7, round(1.22 * radius))
    for number, (spot, thing) in enumerate(zip(spots, small, strict=True), start=1):
        plan.disc(spot, radius, color_of(thing.category), (255, 255, 255))
        plan.text(Text((str(number),), spot, size, (255, 255, 255)))


def _apart(points: np.ndarray, gap: float, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Points [N, 2] moved until all are ``gap`` pixels apart, or nearly so; each stays close to where it was."""
    # A tiny spiral tells points that coincide apart, the same way on every run.
    turn = 2.399963 * np.arange(len(points))
    places = points + 0.5 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    for _ in range(120):
        delta = places[:, None] - places[None]
        distance = np.linalg.norm(delta, axis=2) + np.eye(len(points)) * 1e9
        close = np.maximum(gap - distance, 0.0)
        if close.max() < 0.3:
            break
        push = (delta / np.maximum(distance, 1e-6)[..., None] * close[..., None] / 2).sum(axis=1)
        places = np.clip(places + 0.8 * push, low, high)
    return places


def _key_columns(
    small: Sequence[SceneObject], height: int, size: int
) -> tuple[list[list[tuple[int | None, str, Rgb]]], list[int]]:
    """The rows of the key in columns as high as the picture, and the width [pixels] of each column."""
    rows: list[tuple[int | None, str, Rgb]] = []
    heading = None
    for number, thing in enumerate(small, start=1):
        over = _support(thing) or {"wall": "on the walls", "ceiling": "on the ceiling"}.get(thing.mount, thing.mount)
        if over != heading:
            rows.append((None, _name(over), palette.MUTED))
            heading = over
        rows.append((number, _name(thing.id), color_of(thing.category)))
    most = max(4, int(height / (1.45 * size)) - 1)
    columns = [rows[k : k + most] for k in range(0, len(rows), most)]
    return columns, [round(max(text_width(text, size) for _, text, _ in c) + 3.4 * size) for c in columns]


def _key(
    plan: Plan, columns: Sequence[Sequence[tuple[int | None, str, Rgb]]], wide: Sequence[int], x: float, size: int
) -> None:
    for rows, width in zip(columns, wide, strict=True):
        for k, (number, text, color) in enumerate(rows):
            y = (k + 1) * 1.45 * size
            if number is None:
                plan.text(Text((text,), (x, y), size, palette.MUTED, anchor="l", bold=True))
                continue
            plan.text(Text((str(number),), (x + 1.6 * size, y), size, color, anchor="r", bold=True))
            plan.text(Text((text,), (x + 2.1 * size, y), size, palette.INK, anchor="l"))
        x += width
