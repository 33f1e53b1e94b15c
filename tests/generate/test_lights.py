"""The lighting plan: lamps over tables, the others on a grid, none in the way."""

from __future__ import annotations

import pytest

from sceneweaver.generate.hanging import OVER, hanging_height
from sceneweaver.geometry.spread import even_count
from sceneweaver.knowledge import room_type, room_types
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior
from tests.for_each import for_each

ROOMS = room_types()


@pytest.fixture
def propose(library):
    def run(words: str):
        brief = read_request(words)
        empty = Scene(id="empty", room={"outline": ((0, 0), (3, 0), (3, 3), (0, 3))})
        return InitPrior().propose(Context(brief, room_type(brief.room_type or ""), empty, library, 1)).scene

    return run


def test_pendants_end_above_the_table_or_let_people_pass():
    assert hanging_height("pendant", 2.8, 0.75) == pytest.approx(2.8 - 0.75 - 0.7)
    assert hanging_height("pendant", 2.8, None) == pytest.approx(0.7)
    assert hanging_height("pendant", 6.0, None) == 2.2, "as long as they are made"
    assert hanging_height("ceiling_light", 2.8, None) is None


def test_ceiling_lights_are_on_a_full_grid(propose):
    scene = propose("a classroom")
    lamps = [o.id for o in scene.objects if o.category == "ceiling_light"]
    placed = {r.subject: r.params for r in scene.relations if r.type == "on_grid"}
    assert set(placed) == set(lamps) and len(lamps) >= 4
    assert sorted(p["k"] for p in placed.values()) == list(range(len(lamps)))
    assert {p["n"] for p in placed.values()} == {len(lamps)}
    assert even_count(scene.room.outline, len(lamps)) == len(lamps)


def test_two_lamps_share_the_length_of_a_table(propose):
    scene = propose("a meeting room")
    table = next(o for o in scene.objects if o.category == "conference_table")
    over = [r for r in scene.relations if r.type == "over" and r.subject.startswith("pendant")]
    assert [(r.target, r.params["left"]) for r in over] == [(table.id, -0.25), (table.id, 0.25)]
    for r in over:
        lamp = scene.object(r.subject)
        assert 0.65 <= scene.room.height - lamp.size[2] - table.size[2] <= 0.75


def test_each_table_of_a_restaurant_has_its_lamp(propose):
    scene = propose("a restaurant for 20 people")
    tables = {o.id for o in scene.objects if o.intent.program_item in ("four_table", "two_table")}
    assert tables and tables == {r.target for r in scene.relations if r.type == "over"}


@for_each(ROOMS)
def test_no_ceiling_lamp_is_merely_near_something(name):
    """A lamp hangs over something, on the grid, in the middle, or along a counter."""
    for item in ROOMS[name].items:
        if {"ceiling_light", "pendant", "chandelier"} & set(item.what):
            types = {p.type for p in item.place if not (p.soft and p.type == "near")}
            assert types & (OVER | {"on_grid", "in_middle"}), f"{item.id}: {types}"
