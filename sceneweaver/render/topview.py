"""The annotated top view: an architect's plan of a scene, drawn with Pillow alone."""

from __future__ import annotations

import io
import re
import unicodedata
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import numpy as np
from PIL import Image

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.io import write_atomic
from sceneweaver.render import labels, palette, plan_objects, plan_room, sheet
from sceneweaver.render.canvas import Text
from sceneweaver.render.plan_objects import Item
from sceneweaver.render.shapes import Plan, View, bounds_of, content
from sceneweaver.scene import InputError, Scene

MIN_WIDTH, MAX_WIDTH = 200, 8192
SOFT = ("soft_relation", "narrow_path")  # the kinds of violations that leave a scene valid
_MAX_LISTED = 8  # violations that the sheet spells out
_PLAIN = str.maketrans(
    {"ß": "ss", "ø": "o", "Ø": "O", "ł": "l", "Ł": "L", "æ": "ae", "œ": "oe", "đ": "d", "–": "-", "—": "-"}
)


class ViolationLike(Protocol):
    """What a drawing needs of a violation; ``sceneweaver.verify`` makes them."""

    @property
    def kind(self) -> str:
        """What is violated: collision, out_of_bounds ..."""
        ...

    @property
    def objects(self) -> Sequence[str]:
        """Ids of the objects and openings concerned."""
        ...

    @property
    def detail(self) -> str:
        """The rest in words."""
        ...


def draw_top(
    scene: Scene,
    *,
    width: int = 1600,
    annotated: bool = True,
    violations: Sequence[ViolationLike] = (),
    valid: bool | None = None,
) -> Image.Image:
    """Draw a scene from above.

    Args:
        scene: The scene.
        width: Width of the picture in pixels; the height follows from the room.
        annotated: With title, axes, grid, labels, arrows and zones; without, the furnished room alone.
        violations: What ``check`` found; the objects concerned are outlined red, those of soft relations excepted.
        valid: What ``check`` decided, for the title; None: not checked (though with violations it is not valid).

    The picture depends on the scene alone, not on the order of its objects, and is the same on every run.

    Raises:
        InputError: a width out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> picture = sw.draw_top(sw.Scene.example("bedroom"), width=400, annotated=False)
        >>> picture.width, picture.mode
        (400, 'RGB')
    """
    if not MIN_WIDTH <= width <= MAX_WIDTH:
        raise InputError(f"width: {width} is not between {MIN_WIDTH} and {MAX_WIDTH} pixels")
    hard = sorted((v for v in violations if v.kind not in SOFT), key=_order)
    if not annotated:
        return _draw_plain(scene, width, hard)
    soft = sum(v.kind == SOFT[0] for v in violations)
    return _draw_sheet(scene, width, hard, soft, valid)


def save_top(
    scene: Scene,
    path: str | Path,
    *,
    width: int = 1600,
    annotated: bool = True,
    violations: Sequence[ViolationLike] = (),
    valid: bool | None = None,
) -> None:
    """Draw a scene from above into a PNG file, written under a temporary name and renamed."""
    image = draw_top(scene, width=width, annotated=annotated, violations=violations, valid=valid)
    content = io.BytesIO()
    image.save(content, format="PNG")
    write_atomic(path, content.getvalue())


def _draw_plain(scene: Scene, width: int, violations: Sequence[ViolationLike]) -> Image.Image:
    items = plan_objects.items_of(scene)
    plan = _plan(scene, items, width, (30, 30, 30, 30))
    plan_room.draw_floor(plan, scene.room)
    plan_objects.draw_items(plan, items, scene.room)
    plan_room.draw_openings(plan, scene.room)
    _draw_alarms(plan, items, violations)
    return plan.finish()


def _draw_sheet(
    scene: Scene, width: int, violations: Sequence[ViolationLike], soft: int, valid: bool | None
) -> Image.Image:
    room = scene.room
    items = plan_objects.items_of(scene)
    alarmed = frozenset(name for v in violations for name in v.objects)
    plan = _plan(scene, items, width, (124, 68, 44, 84))
    plan_room.draw_floor(plan, room)
    plan_room.draw_grid(plan, room)
    plan_room.draw_opening_zones(plan, room, alarmed)
    plan_objects.draw_zones(plan, items, alarmed)
    plan_objects.draw_items(plan, items, room)
    plan_room.draw_openings(plan, room)
    owners, edges = plan_objects.owner_grid(plan, items, room)
    plan_objects.draw_arrows(plan, items, owners)
    _draw_alarms(plan, items, violations)
    plan_room.name_walls(plan, room)
    shown = content(room, [p for i in items for p in i.solids])
    left, bottom = sheet.axes_at(plan, shown)
    owners[:, : round((left + 8 * plan.unit) / labels.CELL)] = labels.MARK_OWNER
    owners[round((bottom - 8 * plan.unit) / labels.CELL) :] = labels.MARK_OWNER
    labelling = _draw_labels(plan, items, (owners, edges), alarmed)
    sheet.draw_axes(plan, bounds_of(room.outline), shown)

    badge = _badge(scene, violations, valid)
    head = sheet.draw_title(plan, printable(scene.id), _facts(scene), printable(scene.prompt), badge)
    parts = (head, plan.finish(), _foot(plan, scene, items, violations, soft, labelling))
    image = Image.new("RGB", (width, sum(p.height for p in parts)), palette.PAPER)
    y = 0
    for part in parts:
        image.paste(part, (0, y))
        y += part.height
    return image


def _plan(scene: Scene, items: Sequence[Item], width: int, margins: tuple[int, int, int, int]) -> Plan:
    """A canvas on which the plan is as large as it can be; ``margins`` left, right, above and below are in units."""
    unit = width / 1600
    left, right, top, bottom = (margin * unit for margin in margins)
    shown = content(scene.room, [p for i in items for p in i.solids])
    wide, high = width - left - right, 0.9 * width
    scale = min(wide / max(shown.width, 1e-3), high / max(shown.height, 1e-3))
    spare = wide - shown.width * scale
    view = View(scale, shown.x0 - (left + spare / 2) / scale, shown.y1 + top / scale)
    return Plan(width, round(top + shown.height * scale + bottom), view, unit)


def _facts(scene: Scene) -> str:
    box = bounds_of(scene.room.outline)
    floor = signed_area(scene.room.outline)
    parts = [
        _count(len(scene.objects), "object"),
        _count(len(scene.relations), "relation"),
        f"{box.width:.2f} x {box.height:.2f} m, {floor:.1f} sq m",
    ]
    if scene.dropped:
        parts.insert(1, f"{len(scene.dropped)} dropped")
    return "  ·  ".join(parts)


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")


def _badge(scene: Scene, violations: Sequence[ViolationLike], valid: bool | None) -> sheet.Badge:
    if violations:
        return sheet.Badge(f"not valid  ·  {_count(len(violations), 'violation')}", False)
    if valid is False or scene.dropped:
        return sheet.Badge("not valid", False)
    return sheet.Badge("valid", True) if valid else sheet.Badge("not checked", None)


def _draw_alarms(plan: Plan, items: Sequence[Item], violations: Sequence[ViolationLike]) -> None:
    """Red outlines around the objects of violations; what two colliding objects share is filled."""
    shapes = {i.id: [plan.points(p.polygon) for p in i.solids] for i in items}
    for name in sorted({name for v in violations for name in v.objects} & shapes.keys()):
        plan.outline(shapes[name], palette.ALARM, 3.2)
    for v in violations:
        pair = [shapes[name] for name in v.objects if name in shapes]
        if v.kind == "collision" and len(pair) == 2:
            plan.overlap(pair[0], pair[1], palette.ALARM)


def _order(violation: ViolationLike) -> tuple[str, tuple[str, ...], str]:
    return (violation.kind, tuple(violation.objects), violation.detail)


def _draw_labels(
    plan: Plan, items: Sequence[Item], grids: tuple[np.ndarray, np.ndarray], alarmed: frozenset[str]
) -> labels.Labelling:
    number = {item.id: k + 1 for k, item in enumerate(items)}

    def wanted(item: Item) -> labels.Wanted:
        text = printable(item.id) or printable(item.obj.category) or "?"
        below = number.get(item.obj.support.object, 0) if item.obj.support is not None else 0
        return plan_objects.label_of(plan, item, number[item.id], text, below)

    result = labels.place([wanted(item) for item in items], *grids, [plan.font_size(s, 7) for s in (20, 16, 13)])
    by_id = {i.id: i for i in items}
    for label in result.placed:
        if label.leader is not None:
            plan.leader(label.leader, palette.INK, (*palette.FLOOR, 150), 1.2)
    for label in result.placed:
        item = by_id[label.key]
        color = palette.INK if label.beside else palette.ink_on(item.ground)
        halo = plan.font_size(2.6 if label.beside else 1.8, 1)
        if label.key in alarmed:
            color = palette.ALARM
        ground = palette.FLOOR if label.beside else item.ground
        plan.text(Text(label.lines, label.at, label.size, color, ground, halo, label.upright))
    return result


def _foot(
    plan: Plan,
    scene: Scene,
    items: Sequence[Item],
    violations: Sequence[ViolationLike],
    soft: int,
    labelling: labels.Labelling,
) -> Image.Image:
    key = sheet.Key(
        arrows=bool(items),
        zones=any(i.obj.zones for i in items),
        openings=bool(scene.room.doors or scene.room.windows),
        hanging=any(i.translucent for i in items),
        alarms=bool(violations),
    )
    notes = []
    if labelling.numbered:
        notes.append("A number alone is the end of the object's id; its colour says the category.")
    if labelling.left_out:
        notes.append(f"{labelling.left_out} of {_count(len(items), 'object')} had no room for a label.")
    outside = sum(not _in_picture(plan, item) for item in items)
    if outside:
        notes.append(f"{_count(outside, 'object')} outside of the picture.")
    notes += [f"dropped: {printable(d.id)} ({printable(d.category)}): {printable(d.reason)}" for d in scene.dropped[:4]]
    if soft:
        notes.append(f"{_count(soft, 'soft relation')} {'does' if soft == 1 else 'do'} not hold.")
    alarms = [f"{printable(v.kind.replace('_', ' '))}:  {_sentence(v)}" for v in violations[:_MAX_LISTED]]
    if len(violations) > _MAX_LISTED:
        alarms.append(f"and {len(violations) - _MAX_LISTED} more")
    named = labelling.numbered + labelling.left_out == 0
    return sheet.draw_footer(plan, key, () if named else _categories(items), notes, alarms)


def _sentence(violation: ViolationLike) -> str:
    return printable(violation.detail) or ", ".join(map(printable, violation.objects))


def _categories(items: Sequence[Item]) -> list[tuple[str, palette.Rgb, int]]:
    """Categories with their mean colour and how often they occur, the most frequent first."""
    fills: dict[str, list[palette.Rgb]] = defaultdict(list)
    for item in items:
        fills[item.obj.category].append(item.fill)
    out = []
    for name, colors in fills.items():
        r, g, b = (sum(channel) // len(colors) for channel in zip(*colors, strict=True))
        out.append((printable(name), (r, g, b), len(colors)))
    return sorted(out, key=lambda c: (-c[2], c[0]))


def _in_picture(plan: Plan, item: Item) -> bool:
    points = [p for s in item.solids for p in plan.points(s.polygon)]
    return any(0 <= x <= plan.width and 0 <= y <= plan.height for x, y in points)


def printable(text: str) -> str:
    """The text in letters that the built-in font has: accents are dropped, other scripts become question marks."""
    text = unicodedata.normalize("NFKD", text.translate(_PLAIN))
    kept = (c for c in text if not unicodedata.combining(c))
    line = re.sub(r"\s+", " ", "".join(c if c.isascii() or c in "°·…“”" else "?" for c in kept)).strip()
    line = "".join(c if c.isprintable() else "?" for c in line)
    return line if any(c.isalnum() for c in line) else ""
