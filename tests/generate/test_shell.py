"""Empty rooms: what a request fixes stays, the rest varies with the seed, and openings leave room for curtains."""

from __future__ import annotations

import math
import random

import pytest
import shapely

from sceneweaver.generate.openings import BESIDE
from sceneweaver.generate.outline import asked_outline, outline, sides_of, turned
from sceneweaver.generate.relations import wall_named
from sceneweaver.generate.shell import floor_area, shell
from sceneweaver.knowledge import room_type, room_types
from sceneweaver.knowledge.shells import shells
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.verify import check
from tests.for_each import for_each

SEEDS = range(30)


def rooms(text: str, seeds=SEEDS):
    brief = read_request(text)
    kind = room_type(brief.room_type or "bedroom")
    return [shell(kind, brief, floor_area(kind, brief, seed)[0], seed)[0] for seed in seeds]


def signature(room):
    door = room.doors[0]
    wall = room.walls[door.wall]
    place = round(2 * (door.offset + door.width / 2) / wall.length)
    return len(room.outline), door.wall, place, tuple((w.wall, round(2 * w.offset)) for w in room.windows)


def test_rooms_of_a_kind_vary():
    made = rooms("Design me a bedroom")
    assert len({signature(room) for room in made}) >= 27
    assert len({len(room.outline) for room in made}) >= 3
    assert len({room.doors[0].wall for room in made}) >= 4
    assert len({room.height for room in made}) >= 3
    assert len({room.windows[0].sill < 0.55 for room in made}) == 2
    assert made == rooms("Design me a bedroom")


@for_each(sorted(room_types()))
def test_empty_rooms_are_valid_and_have_the_area_that_was_asked_for(name):
    kind, brief = room_type(name), read_request(f"a {name.replace('_', ' ')}")
    for seed in range(2):
        area = floor_area(kind, brief, seed)[0]
        room = shell(kind, brief, area, seed)[0]
        assert shapely.Polygon(room.outline).area == pytest.approx(area, rel=0.02)
        assert check(Scene(id="empty", room=room)).valid
        assert min(room.outline)[0] == 0.0 and min(y for _, y in room.outline) == 0.0
        windows = sorted((w.wall, w.offset) for w in room.windows)
        for window in room.windows:
            after = window.offset + window.width
            end = min([w.offset for w in room.windows if w.wall == window.wall and w.offset > window.offset] or [99.0])
            assert after < min(end, room.walls[window.wall].length)
        assert len(set(windows)) == len(windows)


def test_windows_leave_room_for_their_curtains():
    for room in rooms("Design me a living room"):
        for window in room.windows:
            wall = room.walls[window.wall]
            assert window.offset >= BESIDE - 1e-3 and wall.length - window.offset - window.width >= BESIDE - 1e-3


def test_what_a_request_fixes_stays():
    for room in rooms("a 5 x 4 m bedroom with two windows"):
        assert room.outline == ((0, 0), (5, 0), (5, 4), (0, 4)) and len(room.windows) == 2
    assert all(len(room.outline) == 6 for room in rooms("an L-shaped bedroom"))
    assert {room.height for room in rooms("a bedroom with a ceiling height of 3 m")} == {3.0}
    assert all(len(room.outline) == 4 for room in rooms("a bedroom with the bed against the left wall"))


def test_walls_keep_their_names_as_seen_from_the_door():
    for room in rooms("Design me a bedroom"):
        ahead = room.walls[room.doors[0].wall].inward
        far = room.walls[wall_named("far", room)].outward
        assert far[0] * ahead[0] + far[1] * ahead[1] > 0.7


def test_nothing_is_asked_to_stand_against_a_wall_of_windows():
    brief = read_request("a bedroom with a wardrobe against the left wall")
    kind = room_type("bedroom")
    for seed in range(8):
        room = shell(kind, brief, 15.0, seed)[0]
        assert wall_named("left", room) not in {w.wall for w in room.windows}


@pytest.mark.parametrize("shape", ["rectangle", "notch", "cut", "bay", "L", "T", "U"])
@pytest.mark.parametrize("quarters", range(4))
def test_outlines_keep_their_area_however_they_are_turned(shape, quarters):
    width, depth = sides_of(shape, 20.0, 1.3)
    drawn = asked_outline if shape in ("T", "U") else outline
    plan = turned(drawn(shape, width, depth, random.Random(quarters)), quarters)
    ring = shapely.Polygon(plan.corners)
    assert ring.is_valid and ring.exterior.is_ccw
    assert ring.area == pytest.approx(20.0, rel=0.01)
    walls = list(zip(plan.corners, plan.corners[1:] + plan.corners[:1], strict=True))
    assert all(abs(a[0] - b[0]) + abs(a[1] - b[1]) > 0.2 for a, b in walls)
    if plan.bay is not None:
        assert 2.0 <= math.dist(*walls[plan.bay]) <= 2.75 and plan.bay not in plan.entries


def test_every_shape_of_every_group_can_be_drawn():
    for shares in shells().shapes.values():
        assert all(outline(shape, 6.0, 5.0, random.Random(0)).corners for shape in shares)
