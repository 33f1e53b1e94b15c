"""RoboCasa's kitchens as YAML: layouts (``layout001.yaml``) with the sizes of the models that a style names."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import load_yaml

from ..built_in import Box, built_into, solid
from ..fixture_models import FixtureModels
from ..fixtures import Fixture, Kitchen, label_of
from ..frames import facing, yaw_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..values import Entry

_AXES = facing("-y")
"""From a fixture's frame (x right, y back) to an object's."""


_HUNG = ("wall_accessory", "hood", "utensil_rack")
_BUILT_IN = ("stack", "panel_cabinet", "hinge_cabinet", "single_cabinet", "open_cabinet", "box", "microwave", "oven")

WALL = 0.1
"""Half of the widest gap [m] between floors that a wall fills."""


def _matches(path: Path, head: bytes) -> bool:
    if path.suffix.lower() not in (".yaml", ".yml"):
        return False
    return b"walls:" in head and b"room:" in head and b"type: wall" in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    root = Entry.of(path, load_yaml(path))
    models = FixtureModels(path, options.folder)
    kitchen = Kitchen(root, models)
    notes = list(kitchen.notes)
    if not kitchen.floors:
        raise root["room"].error("has no floor; give one with size (half lengths) and pos")
    standing = [f for f in kitchen.fixtures.values() if f.stands]
    notes.append(
        f"sizes of appliances are those of style {models.style.stem}"
        if models.style is not None and any(f.asset for f in standing)
        else "sizes of appliances are in RoboCasa's models: without them (--asset-folder robocasa/models/assets and "
        "a style) usual ones stand for what the layout leaves open, and what is aligned to them moves along"
    )
    for what, names in (
        ("of assumed size", [f.name for f in standing if not f.given]),
        ("placed by RoboCasa when it loads the kitchen, left out", kitchen.sampled),
        ("switched off in the file, left out", kitchen.disabled),
        ("placed by nothing in the file, left out", [f.name for f in kitchen.fixtures.values() if not f.stands]),
    ):
        if names:
            notes.append(f"{what}: {', '.join(names[:30])}{' ...' if len(names) > 30 else ''}")
    openings = tuple(_window(f) for f in standing if f.type.startswith("window"))
    things = [f for f in standing if not f.type.startswith("window")]
    holders = {other.name: f.name for f in things for other, _ in built_into(f, _local(f, things))}
    objects = tuple(_object(f, things, list(kitchen.walls.values()), holders.get(f.name)) for f in things)
    carved = [o.name for o in objects if o.parts]
    if carved:
        notes.append(f"hollow or cut out where others are built in: {', '.join(carved)}")
    height = max((w["pos"].numbers(3)[2] + w["size"].numbers(3)[1] for w in kitchen.walls.values()), default=None)
    yield SourceRoom("", "kitchen", _outline(kitchen.floors), height, openings, objects, notes=tuple(notes))


def _outline(floors: list[Entry]) -> tuple[tuple[float, float], ...]:
    """The corners of all floors together [m]; their sizes are half lengths."""
    import shapely

    boxes = []
    for floor in floors:
        (x, y, _), (w, d, _) = floor["pos"].numbers(3), floor["size"].numbers(3, 1e-6)
        boxes.append(shapely.box(x - w, y - d, x + w, y + d))
    shape = shapely.unary_union(boxes).buffer(WALL, join_style="mitre").buffer(-WALL, join_style="mitre")
    largest = max(getattr(shape, "geoms", [shape]), key=lambda part: part.area)
    corners = shapely.get_coordinates(shapely.Polygon(shapely.get_exterior_ring(largest)).simplify(1e-6))[:-1]
    return tuple((round(float(x), 9) + 0.0, round(float(y), 9) + 0.0) for x, y in corners[::-1])


def _window(fixture: Fixture) -> SourceOpening:
    along = np.array([np.cos(fixture.yaw), np.sin(fixture.yaw)]) * fixture.size[0] / 2
    (x0, y0), (x1, y1) = fixture.at[:2] - along, fixture.at[:2] + along
    low = float(fixture.low[2])
    ends = (float(x0), float(y0)), (float(x1), float(y1))
    return SourceOpening(fixture.name, "window", *ends, low, float(fixture.size[2]))


def _local(fixture: Fixture, things: list[Fixture]) -> list[tuple[Fixture, Box]]:
    """The other fixtures of a group with their boxes in the frame of this one."""
    turn = yaw_matrix(fixture.yaw)
    local: list[tuple[Fixture, Box]] = []
    for other in things:
        if other is not fixture and other.group == fixture.group:
            middle = turn.T @ (other.at - fixture.at)
            local.append((other, (middle - other.size / 2, middle + other.size / 2)))
    return local


def _object(fixture: Fixture, things: list[Fixture], walls: list[Entry], holder: str | None) -> SourceObject:
    turn = yaw_matrix(fixture.yaw)
    local = _local(fixture, things)
    boxes = solid(fixture, local)
    width, depth, height = (float(v) for v in fixture.size)
    full = len(boxes) == 1 and np.allclose(boxes[0], (-fixture.size / 2, fixture.size / 2))
    x, y, z = (float(v) for v in fixture.at)
    config = fixture.entry.word("config_name")
    mount: Mount | None = None
    if (
        fixture.type in _HUNG
        or (fixture.type.endswith("_cabinet") and fixture.low[2] > 1.0)
        or fixture.low[2] > 0.002
        and fixture.type in _BUILT_IN
        and _behind(fixture, walls)
    ):
        mount = "wall"
    return SourceObject(
        fixture.name,
        label_of(fixture.type, config, z),
        (x, y, z),
        turn @ _AXES.T,
        (depth, width, height),
        size_assumed=not fixture.given,
        asset=fixture.asset,
        support=holder,
        mount=None if holder else mount,
        hollows=tuple(_part(low, high, height) for _, (low, high) in built_into(fixture, local)),
        parts=() if full else tuple(_part(low, high, height) for low, high in boxes),
        keep={"type": fixture.type, "size_given": fixture.given},
    )


def _behind(fixture: Fixture, walls: list[Entry]) -> bool:
    """Whether the back of a fixture touches a wall."""
    back = fixture.at[:2] + np.array([-np.sin(fixture.yaw), np.cos(fixture.yaw)]) * fixture.size[1] / 2
    for wall in walls:
        (x, y, _), (length, _, half) = wall["pos"].numbers(3), wall["size"].numbers(3)
        dx, dy = np.abs(back - (x, y))
        along, across = (dx, dy) if wall.word("wall_side", "back") in ("back", "front") else (dy, dx)
        if along <= length and across <= half + 0.02:
            return True
    return False


def _part(
    low: np.ndarray, high: np.ndarray, height: float
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """A box about the middle of a fixture in the object's frame, from the middle of its bottom."""
    ends = np.stack((low, high)) @ _AXES.T
    (x0, y0, z0), (x1, y1, z1) = ends.min(axis=0), ends.max(axis=0)
    return (float(x0), float(y0), float(z0) + height / 2), (float(x1), float(y1), float(z1) + height / 2)


FORMAT = SourceFormat(
    "robocasa",
    "RoboCasa kitchen layouts (YAML)",
    _matches,
    _read,
    notes=(
        "Read: floors (half lengths) as the outline, wall heights, windows, fixtures (full lengths: width, depth, "
        "height; front -y) by position or by align_to, side, alignment and offset, stacks and housings, sinks and hobs "
        "in their counters, group_origin, group_pos, group_z_rot, z_rot.",
        "Sizes that the layout leaves to the model come from the model of the style (style*.yaml beside the layout or "
        "in --asset-folder, models in --asset-folder); else the usual ones, which count as assumed. RoboCasa joins "
        "styles and layouts freely: the first style there is taken.",
        "Built-in things lie within each other: a counter over cabinets is its top, sinks and hobs are cut out of "
        "counters and cabinets, housings are hollow around what they hold; that rests in them and goes with them.",
        "Lost: what RoboCasa places by chance when it loads (accessories with `placement`), doors and drawers of "
        "cabinets, textures, partition walls within the outline.",
    ),
    licence="MIT (code)",
)
