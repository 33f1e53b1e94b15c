"""The plan of a storey as architects draw it, to scale: SVG, or a picture drawn with Pillow alone."""

from __future__ import annotations

import html
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import shapely
from PIL import Image

from sceneweaver.home import Home, HomeDoor, HomeRoom, wall_openings, wall_polygons
from sceneweaver.home.treads import treads
from sceneweaver.scene import InputError

from .. import palette, plan_objects
from ..plan_objects import HANGING, Item
from ..shapes import Bounds, Plan, View
from ..svg import SvgPlan
from ..topview import MAX_WIDTH, MIN_WIDTH, printable
from . import plan_dimensions, plan_frame, plan_names, plan_stairs, plan_walls

MM = 0.16
"""What a unit of the drawing is on paper [mm]: lines of 0.15 to 0.3 mm, names of 3 mm."""

_SCALES = (20, 25, 50, 75, 100, 150, 200, 250, 500, 1000)
_MOST = 250.0  # length of a plan on paper [mm] up to which a larger scale is taken
_PALE, _PALER = 0.55, 0.72  # how much paler than in plans of single rooms furniture is, and rugs
_LEAST = 0.03  # what is lower is a rug: names may lie on it [m]
_CUT = 1.2  # height at which a plan cuts a storey [m]
_DEEP = 0.25  # what hangs on a wall and is less deep is left out [m]
_SHOWN = 0.4  # things on furniture with a smaller side are left out [m] ...
_BUILT_IN = frozenset(["sink", "basin", "hob", "cooktop", "stove", "oven", "microwave", "lamp", "tv", "monitor"])
"""... but for these."""


def draw_plan(
    home: Home,
    storey: str | None = None,
    *,
    furniture: bool = True,
    dimensions: bool = True,
    links: Mapping[str, str] | None = None,
) -> str:
    """Draw the plan of a storey as SVG: walls, doors with their swings, windows, stairs, areas of rooms, dimensions.

    The sheet is to scale on paper (1:50, 1:100 ...): the SVG has its size in millimetres.

    Args:
        home: The home.
        storey: Its id; None: the lowest one.
        furniture: Whether what stands in furnished rooms is drawn.
        dimensions: Whether there are dimension chains around the plan.
        links: For rooms by id, where a click on them leads.

    Raises:
        InputError: no such storey, or one without rooms.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import draw_plan
        >>> draw_plan(sw.Home.example("flat"))[:4]
        '<svg'
    """
    sheet = _sheet(home, _storey(home, storey), dimensions)
    drawing = SvgPlan(round(sheet.width), round(sheet.height), sheet.view(1.0), 1.0)
    _draw(drawing, home, sheet, furniture, dimensions)
    titles = plan_names.room_titles(home)
    for room in home.rooms_of(sheet.storey) if links else ():
        _link(drawing, room, titles[room.id], (links or {}).get(room.id))
    return drawing.document(f"{home.id}: {sheet.storey}", (sheet.width * MM, sheet.height * MM))


def plan_picture(
    home: Home,
    storey: str | None = None,
    *,
    width: int | None = None,
    furniture: bool = True,
    dimensions: bool = True,
) -> Image.Image:
    """The drawing of `draw_plan` as a picture, drawn with Pillow alone.

    Args:
        home: The home.
        storey: Its id; None: the lowest one.
        width: Width in pixels; None: that of 160 dots an inch. ``info["dpi"]`` is the resolution at which it prints to
            scale.
        furniture: Whether what stands in furnished rooms is drawn.
        dimensions: Whether there are dimension chains around the plan.

    Raises:
        InputError: no such storey, one without rooms, or a width out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import plan_picture
        >>> plan_picture(sw.Home.example("flat"), width=600).size[0]
        600
    """
    if width is not None and not MIN_WIDTH <= width <= MAX_WIDTH:
        raise InputError(f"width: {width} is not between {MIN_WIDTH} and {MAX_WIDTH} pixels")
    sheet = _sheet(home, _storey(home, storey), dimensions)
    share = 1.0 if width is None else width / sheet.width
    plan = Plan(round(sheet.width * share), round(sheet.height * share), sheet.view(share), share)
    _draw(plan, home, sheet, furniture, dimensions)
    picture = plan.finish()
    picture.info["dpi"] = (25.4 * share / MM, 25.4 * share / MM)
    return picture


def _storey(home: Home, storey: str | None) -> str:
    """The id of the storey that is meant."""
    one = home.storeys[0].id if storey is None else home.storey(storey).id
    if not home.rooms_of(one):
        raise InputError(f"storey: '{one}' has no rooms to draw")
    return one


@dataclass(frozen=True)
class _Sheet:
    """A sheet [units]: of which storey, its size, the scale on paper 1 : ``denominator``, where the plan lies on it,
    what it shows [m], and the building without balconies [m]."""

    storey: str
    width: float
    height: float
    denominator: int
    left: float
    top: float
    whole: Bounds
    bare: Bounds

    def view(self, share: float) -> View:
        """The way from metres to pixels, of which there are ``share`` to a unit."""
        scale = 1000.0 / self.denominator / MM
        return View(scale * share, self.whole.x0 - self.left / scale, self.whole.y1 + self.top / scale)


def _sheet(home: Home, storey: str, dimensions: bool) -> _Sheet:
    walls = wall_polygons(home, storey)
    rooms = home.rooms_of(storey)
    bare = Bounds(*shapely.union_all(walls or [shapely.Polygon(r.outline) for r in rooms]).bounds)
    shown = [*walls, *(shapely.Polygon(r.outline) for r in rooms)]
    shown += [shapely.Polygon(leaf) for found in wall_openings(home, storey) for leaf in plan_walls.swept(home, found)]
    whole = Bounds(*shapely.union_all(shown).bounds)
    long = 1000.0 * max(whole.width, whole.height)
    denominator = next((n for n in _SCALES if long / n <= _MOST), _SCALES[-1])
    scale = 1000.0 / denominator / MM
    near = plan_dimensions.SECOND + 30.0 if dimensions else 24.0
    north, east = plan_dimensions.far_sides(home, storey, bare) if dimensions else (False, False)
    beyond = [plan_dimensions.FIRST + 26.0 if there else 24.0 for there in (north, east)]
    margin = plan_frame.MARGIN
    needed = near + whole.width * scale + beyond[1] + 2 * (margin - 20.0)
    width = max(needed, plan_frame.least_width(storey))
    left = near + margin - 20.0 + (width - needed) / 2
    top = beyond[0] + margin - 20.0
    height = top + whole.height * scale + near + 10.0 + plan_frame.HEIGHT
    return _Sheet(storey, width, height, denominator, left, top, whole, bare)


def _draw(plan: Plan, home: Home, sheet: _Sheet, furniture: bool, dimensions: bool) -> None:
    storey = sheet.storey
    rooms = home.rooms_of(storey)
    plan_walls.draw_walls(plan, home, storey)
    plan_walls.draw_floors(plan, rooms)
    plan_walls.draw_railings(plan, home, storey)
    items = {room.id: _items(room) if furniture else [] for room in rooms}
    for room in rooms:
        if room.scene is not None and furniture:
            plan_objects.draw_items(plan, items[room.id], room.scene.room, shadows=False)
    plan_stairs.draw_stairs(plan, home, storey)
    plan_walls.draw_openings(plan, home, storey)
    plan_walls.draw_entrances(plan, home, storey)
    titles = plan_names.room_titles(home)
    for room in rooms:
        plan_names.draw_name(plan, room, printable(titles[room.id]) or "?", _obstacles(home, room, items[room.id]))
    if dimensions:
        plan_dimensions.draw_dimensions(plan, home, storey, sheet.whole, sheet.bare)
    several = len(home.storeys) > 1
    facts = f"{sum(plan_names.clear_area(room) for room in rooms if not room.outdoor):.1f} sq m clear"
    title = printable(storey.replace("_", " ").replace("-", " ").capitalize()) if several else "Floor plan"
    title = f"{title} floor" if title.lower() in ("ground", "first", "second", "third", "upper", "top") else title
    plan_frame.draw_frame(plan, title, printable(home.prompt), facts, sheet.denominator)


def _items(room: HomeRoom) -> list[Item]:
    """What is drawn of a furnished room, paler than by itself: what stands on the floor, what is built into furniture
    or lights it, and cupboards on walls."""
    if room.scene is None:
        return []
    found = []
    for item in plan_objects.items_of(room.scene):
        side, words = min(item.obj.size[:2]), palette.words_of(item.obj.category)
        if item.obj.mount == "ceiling" or item.enclosed:
            continue
        if item.layer >= HANGING and (side < _DEEP or "curtain" in words or "curtains" in words):
            continue
        if 0 < item.layer < HANGING and side < _SHOWN and not (_BUILT_IN & set(words)):
            continue
        if item.layer >= HANGING and item.obj.pose.position[2] < _CUT:  # a basin or a toilet on a wall is cut no less
            obj = item.obj.model_copy(update={"mount": "floor", "support": None})
            item = replace(item, obj=obj, layer=0)
        pale = _PALE if item.top > _LEAST else _PALER
        fill = palette.mixed(item.fill, (255, 255, 255), pale)
        found.append(replace(item, fill=fill, under=palette.mixed(item.under, (255, 255, 255), pale)))
    return found


def _obstacles(home: Home, room: HomeRoom, items: list[Item]) -> Iterator[list[tuple[float, float]]]:
    """What names in a room keep clear of [m]: furniture but rugs, the ways of leaves, stairs."""
    for item in items:
        if item.top > _LEAST:
            for solid in item.solids:
                yield list(solid.polygon)
    for found in wall_openings(home, room.storey):
        door = found.opening
        if isinstance(door, HomeDoor) and room.id in (door.room, door.to):
            yield from plan_walls.swept(home, found)
    for stair in home.stairs:
        if room.id in (stair.lower, stair.upper):
            for step in treads(stair):
                yield [(float(x), float(y)) for x, y in step.plan]


def _link(plan: SvgPlan, room: HomeRoom, title: str, target: str | None) -> None:
    """A link over a room, with a name for those who do not see it."""
    if target is None:
        return
    label = html.escape(f"{title}, {plan_names.clear_area(room):.1f} m\u00b2")
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in plan.points(room.outline))
    shape = f'<polygon class="room" points="{points}" fill="#fff" fill-opacity="0"/>'
    plan.raw(f'<a href="{html.escape(target)}" aria-label="{label}"><title>{label}</title>{shape}</a>')
