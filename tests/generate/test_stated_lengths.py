"""Heights that a request states, of things of a kind that it may not name."""

from __future__ import annotations

from sceneweaver.assets import Library
from tests.generate.drafts import drawn


def test_all_of_a_kind_stay_below_a_limit() -> None:
    scene = drawn("a study with a desk and two bookcases, no bookcase taller than 1.2 m", Library())
    cases = [o for o in scene.objects if o.category == "bookcase"]
    assert len(cases) == 2 and all(o.size[2] <= 1.2 + 1e-3 for o in cases)


def test_knees_have_the_room_that_is_asked() -> None:
    scene = drawn("a canteen with a table with knee room 72", Library())
    tables = [o for o in scene.objects if o.category == "dining_table"]
    assert tables and all(o.size[2] >= 0.76 for o in tables)
