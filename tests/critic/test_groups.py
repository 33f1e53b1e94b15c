"""Whether groups are measured as people mean them: aisles, both walls, corners, gaps, sides of a table."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.language.model import Arrangement, Entity, StatedRelation
from sceneweaver.scene import SceneObject
from tests.critic.measuring import CHAIR, TABLE, aligned, box, graph

SOFA, BED, LOW, BENCH = (0.9, 2.0, 0.85), (2.0, 1.0, 0.9), (0.6, 1.0, 0.42), (0.45, 1.4, 0.9)


def arranged(pattern: Any, name: str, **more: Any) -> Arrangement:
    return Arrangement(id="arrangement-0", entity=name, pattern=pattern, words=pattern, **more)


def status(objects: list[SceneObject], said: Arrangement) -> str:
    brief = graph(tuple(objects), arrangements=(said.model_dump(),))
    named = tuple(e.model_copy(update={"count": None}) for e in brief.entities)
    return aligned(tuple(objects), brief.model_copy(update={"entities": named})).of("arrangement-0").status


def sofa(k: int, x: float, y: float, yaw: float) -> SceneObject:
    return box(f"sofa-{k}", SOFA, x, y, yaw)


def benches(gap: float) -> list[SceneObject]:
    """Six benches in three rows with a way of a width [m] between their halves, all looking along x."""
    return [
        box(f"bench-{k}", BENCH, 1.5 + 1.0 * (k // 2), 2.5 + (0.7 + gap / 2) * (1 if k % 2 else -1), 0)
        for k in range(6)
    ]


AISLE = arranged("rows", "bench", rows=3, columns=2, aisle=1.2)


def test_an_aisle_is_as_wide_as_asked_and_free():
    assert status(benches(1.25), AISLE) == "met"
    assert status(benches(0.7), AISLE) == "unmet"
    assert status([*benches(1.25), box("crate-0", (0.4, 0.4, 0.4), 2.5, 2.5, 0)], AISLE) == "unmet"


@pytest.mark.parametrize(
    ("second", "wanted"),
    [((2.45, 3.4, -90), "met"), ((2.45, 3.4, 0), "unmet"), ((5.2, 4.2, -90), "unmet"), ((2.45, 3.4, 90), "unmet")],
    ids=["at right angles", "parallel", "far", "its back to the first"],
)
def test_right_angles_meet_at_a_corner(second: tuple[float, float, float], wanted: str):
    first = sofa(0, 1.2, 1.6, 0)
    assert status([first, sofa(1, *second)], arranged("right_angle", "sofa")) == wanted


def bed(k: int, x: float, y: float, yaw: float) -> SceneObject:
    return box(f"single_bed-{k}", BED, x, y, yaw)


def test_beds_stand_along_two_walls_across_from_each_other():
    said = arranged("walls", "single_bed", sides=(2, 2), around="wall")
    one, other = [bed(0, 1.0, 1.0, 90), bed(1, 3.0, 1.0, 90)], [bed(2, 1.0, 4.0, -90), bed(3, 3.0, 4.0, -90)]
    assert status([*one, *other], said) == "met"
    assert status([*one, other[0], bed(3, 3.0, 2.9, -90)], said) == "unmet"


def test_one_in_each_gap():
    beds = [bed(0, 1.0, 1.0, 0), bed(1, 1.0, 2.7, 0)]
    said = arranged("between", "crate", around="single_bed")
    assert status([*beds, box("crate-0", (0.4, 0.4, 0.4), 0.4, 1.85, 0)], said) == "met"
    assert status([*beds, box("crate-0", (0.4, 0.4, 0.4), 4.0, 1.85, 0)], said) == "unmet"


def test_one_on_each_side_of_a_table():
    table = box("dining_table-0", TABLE, 3.0, 2.5)
    x, y = TABLE[0] / 2 + 0.2, TABLE[1] / 2 + 0.2
    spots = [(3 - x, 2.5, 0), (3 + x, 2.5, 180), (3, 2.5 - y, 90), (3, 2.5 + y, -90)]
    chairs = [box(f"dining_chair-{k}", CHAIR, *spot) for k, spot in enumerate(spots)]
    said = arranged("sides", "dining_chair", sides=(1, 1, 1, 1), around="dining_table")
    assert status([table, *chairs], said) == "met"
    moved = box("dining_chair-3", CHAIR, 3 + x, 3.1, 180)
    assert status([table, *chairs[:3], moved], said) == "unmet"


def between(objects: list[SceneObject], subject: str, target: str) -> str:
    said = StatedRelation(id="relation-0", type="between", subject=subject, targets=(target,))
    brief = graph(tuple(objects), relations=(said.model_dump(),))
    entities = tuple(Entity(id=e.id, noun=e.noun, category=e.category) for e in brief.entities)
    return aligned(tuple(objects), brief.model_copy(update={"entities": entities})).of("relation-0").status


def test_what_is_anywhere_in_the_middle_is_not_between():
    table = box("coffee_table-0", LOW, 3.0, 2.5, 0)
    assert between([table, sofa(0, 1.8, 2.5, 0), sofa(1, 4.2, 2.5, 180)], "coffee_table", "sofa") == "met"
    assert between([table, sofa(0, 0.6, 2.5, 0), sofa(1, 5.4, 2.5, 180)], "coffee_table", "sofa") == "unmet"
