"""What is written over a picture from above: axes, a grid, boxes with names and fronts, and a key of small things."""

from __future__ import annotations

import colorsys
import math
from collections.abc import Sequence

import numpy as np
from PIL import Image

from sceneweaver.geometry.shell import outer_outline
from sceneweaver.scene import Scene, SceneObject
from sceneweaver.scene.messages import shorten

from . import labels, palette
from .canvas import Canvas, Text, text_width
from .palette import Rgb
from .plan_objects import items_of, owner_grid
from .shapes import View, bounds_of, step_for, to_world
from .topview import printable

X_AXIS: Rgb = (204, 44, 40)
Y_AXIS: Rgb = (40, 150, 62)
Z_AXIS: Rgb = (44, 92, 208)
_GRID = (30, 34, 42)
_LONGEST = 40  # characters of an id that are written


class Overlay(Canvas):
    """A canvas that begins with a picture on paper."""

    def __init__(self, picture: Image.Image, left: int, right: int, bottom: int) -> None:
        super().__init__(picture.width + left + right, picture.height + bottom, palette.PAPER)
        size = (picture.width * self._s, picture.height * self._s)
        self._image.paste(picture.resize(size, Image.Resampling.NEAREST), (left * self._s, 0))


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
    left, bottom = round(40 * unit), round(38 * unit)
    right = round(14 * unit) + sum(wide)
    canvas = Overlay(picture, left, right, bottom)
    view = View(view.scale, view.left - left / view.scale, view.top)
    _grid(canvas, scene, view, unit, (left, picture.width + left, picture.height))
    for thing in sorted(large, key=lambda o: (-o.size[0] * o.size[1], o.id)):
        _box(canvas, view, thing, unit, dashed=False)
    for thing in small:
        _box(canvas, view, thing, 0.7 * unit, dashed=thing.mount != "surface")
    discs, radius = _discs(view, small, unit, (left, picture.width + left, picture.height))
    _names(canvas, scene, view, large, discs, radius, unit)
    _numbers(canvas, view, small, discs, radius, unit)
    _key(canvas, columns, wide, picture.width + left + 14 * unit, size)
    _axes(canvas, view, unit)
    return canvas.finish()


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


def _grid(canvas: Canvas, scene: Scene, view: View, unit: float, frame: tuple[int, int, int]) -> None:
    """Lines every metre (more in large rooms) inside the room's bounds, with coordinates at the picture's edge."""
    box = bounds_of(scene.room.outline)
    left, _, low = frame
    step, size = step_for(view.scale, 34 * unit), max(9, round(14 * unit))
    canvas.text(Text(("[m]",), (left / 2, low + 19 * unit), size, palette.MUTED))
    for value in range(math.ceil(box.x0 / step) * step, math.floor(box.x1 + 1e-6) + 1, step):
        (x, y0), (_, y1) = view.point((value, box.y0)), view.point((value, box.y1))
        canvas.line(((x, y0), (x, y1)), (*_GRID, 62), 1.1 * unit)
        canvas.text(Text((str(value),), (x, low + 19 * unit), size, X_AXIS))
    for value in range(math.ceil(box.y0 / step) * step, math.floor(box.y1 + 1e-6) + 1, step):
        (x0, y), (x1, _) = view.point((box.x0, value)), view.point((box.x1, value))
        canvas.line(((x0, y), (x1, y)), (*_GRID, 62), 1.1 * unit)
        canvas.text(Text((str(value),), (left - 8 * unit, y), size, Y_AXIS, anchor="r"))


def _axes(canvas: Canvas, view: View, unit: float) -> None:
    """Half a metre of each axis from the origin; z comes out of the picture."""
    origin, size = view.point((0.0, 0.0)), max(10, round(16 * unit))
    long, head = min(0.6 * view.scale, 70 * unit), 9 * unit
    for (dx, dy), color, name in (((1, 0), X_AXIS, "X"), ((0, -1), Y_AXIS, "Y")):
        tip = (origin[0] + dx * long, origin[1] + dy * long)
        base = (tip[0] - dx * head, tip[1] - dy * head)
        wing = 0.5 * head
        canvas.line((origin, base), (255, 255, 255, 210), 5.5 * unit)
        canvas.line((origin, base), color, 3.2 * unit)
        canvas.polygon(
            [tip, (base[0] + dy * wing, base[1] + dx * wing), (base[0] - dy * wing, base[1] - dx * wing)], fill=color
        )
        at = (tip[0] + dx * 10 * unit, tip[1] + dy * 10 * unit)
        canvas.text(Text((name,), at, size, color, palette.PAPER, max(1, round(2 * unit)), bold=True))
    canvas.disc(origin, 8 * unit, (255, 255, 255), Z_AXIS)
    canvas.disc(origin, 3 * unit, Z_AXIS)
    at = (origin[0] - 14 * unit, origin[1] + 14 * unit)
    canvas.text(Text(("Z",), at, size, Z_AXIS, palette.PAPER, max(1, round(2 * unit)), bold=True))


def _box(canvas: Canvas, view: View, thing: SceneObject, unit: float, dashed: bool) -> None:
    """The rotated box of an object, and an arrow from its middle over its front edge."""
    d, w, _ = thing.size
    color = color_of(thing.category)
    corners = view.points(to_world(thing.pose, ((d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2), (-d / 2, -w / 2))))
    if dashed:
        canvas.dashed(corners, (*color, 235), 1.6 * unit, (7 * unit, 4 * unit), closed=True)
    else:
        canvas.polygon(corners, fill=(*color, 12))
        canvas.line([*corners, corners[0], corners[1]], (255, 255, 255, 120), 4.0 * unit)
        canvas.line([*corners, corners[0], corners[1]], (*color, 255), 2.2 * unit)
    if min(d, w) * view.scale < 14 * unit or dashed:
        return
    # Outside of the box, where it hides nothing of it: a short stem with a head.
    out, head = 15 * unit / view.scale, 8 * unit / view.scale
    tip = d / 2 + out
    stem = view.points(to_world(thing.pose, ((d / 2, 0.0), (tip - head, 0.0))))
    barb = view.points(to_world(thing.pose, ((tip, 0.0), (tip - head, 0.6 * head), (tip - head, -0.6 * head))))
    canvas.line(stem, color, 2.6 * unit)
    canvas.polygon(barb, fill=color)


def _names(
    canvas: Canvas,
    scene: Scene,
    view: View,
    large: Sequence[SceneObject],
    discs: np.ndarray,
    radius: float,
    unit: float,
) -> None:
    """The id of each thing on the floor, inside its outline or beside it, never over another name or a disc."""
    plain = scene.model_copy(update={"objects": tuple(large)})
    items = items_of(plain)
    outline, outer = view.points(scene.room.outline), view.points(outer_outline(scene.room.walls))
    owners, edges = owner_grid((canvas.width, canvas.height), view, items, outline, outer)
    for x, y in discs:
        rows, cols = (
            slice(max(0, int((v - radius) / labels.CELL)), max(0, math.ceil((v + radius) / labels.CELL)))
            for v in (y, x)
        )
        owners[rows, cols] = labels.MARK_OWNER
    wanted = []
    for k, item in enumerate(items):
        box = bounds_of([p for solid in item.solids for p in view.points(solid.polygon)])
        middle = ((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
        wanted.append(labels.Wanted(item.id, k + 1, item.obj.category, _name(item.id), middle, box.width * box.height))
    category = {o.id: o.category for o in large}
    sizes = [max(8, round(s * unit)) for s in (17, 14, 12)]
    for label in labels.place(wanted, owners, edges, sizes).placed:
        color = palette.darker(color_of(category[label.key]), 0.35)
        if label.leader is not None:
            start, end = label.leader
            canvas.line((start, end), (255, 255, 255, 180), 3.0 * unit)
            canvas.line((start, end), color, 1.3 * unit)
            canvas.disc(end, 2.6 * unit, color)
        halo = max(2, round(2.6 * unit))
        canvas.text(Text(label.lines, label.at, label.size, color, (255, 255, 255), halo, label.upright))


def _discs(
    view: View, small: Sequence[SceneObject], unit: float, frame: tuple[int, int, int]
) -> tuple[np.ndarray, float]:
    """Where the discs of small things go, [N, 2] pixels, and how large they are: moved apart where they would meet."""
    radius = (8.5 if len(small) <= 60 else 7.0) * unit
    true = np.array([view.point((o.pose.position[0], o.pose.position[1])) for o in small]).reshape(-1, 2)
    low, high = np.array([frame[0], 0.0]) + radius, np.array(frame[1:]) - radius
    return (_apart(true, 2 * radius + 1.0, low, high) if len(true) else true), radius


def _numbers(
    canvas: Canvas, view: View, small: Sequence[SceneObject], discs: np.ndarray, radius: float, unit: float
) -> None:
    """A numbered disc at each small thing, with a line to it where the disc had to move."""
    for spot, thing in zip(discs, small, strict=True):
        at = view.point((thing.pose.position[0], thing.pose.position[1]))
        if math.dist(at, spot) > radius:
            canvas.line((at, (float(spot[0]), float(spot[1]))), (*palette.INK, 170), 1.1 * unit)
            canvas.disc(at, 2.0 * unit, color_of(thing.category))
    size = max(7, round(1.22 * radius))
    for number, (spot, thing) in enumerate(zip(discs, small, strict=True), start=1):
        at = (float(spot[0]), float(spot[1]))
        canvas.disc(at, radius, color_of(thing.category), (255, 255, 255))
        canvas.text(Text((str(number),), at, size, (255, 255, 255)))


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
    canvas: Canvas, columns: Sequence[Sequence[tuple[int | None, str, Rgb]]], wide: Sequence[int], x: float, size: int
) -> None:
    for rows, width in zip(columns, wide, strict=True):
        for k, (number, text, color) in enumerate(rows):
            y = (k + 1) * 1.45 * size
            if number is None:
                canvas.text(Text((text,), (x, y), size, palette.MUTED, anchor="l", bold=True))
                continue
            canvas.text(Text((str(number),), (x + 1.6 * size, y), size, color, anchor="r", bold=True))
            canvas.text(Text((text,), (x + 2.1 * size, y), size, palette.INK, anchor="l"))
        x += width
