"""Words of place hold when a person would say so: what is loosely so is not told as met."""

from __future__ import annotations

from typing import Any

from sceneweaver.knowledge.kin import is_one
from sceneweaver.language import SceneGraph
from tests.critic import rooms
from tests.critic.measuring import SOFA, aligned, box, carrier, holds, on
from tests.critic.rooms import Case, put


def test_what_leans_touches() -> None:
    near = box("sofa-0", SOFA, SOFA[0] / 2 + 0.12, 2.5)
    said: dict[str, Any] = {"subject": "sofa", "targets": ("wall",)}
    assert holds(near, **said, type="against") and not holds(near, **said, type="leaning_on")


def test_what_touches_a_wall_with_one_end_is_not_against_it() -> None:
    said: dict[str, Any] = {"type": "against", "subject": "sofa", "targets": ("wall",)}
    assert not holds(box("sofa-0", SOFA, SOFA[1] / 2 + 0.02, 2.5, 90), **said)


def test_a_seat_at_a_table_reaches_its_top() -> None:
    said: dict[str, Any] = {"type": "at", "subject": "stool", "targets": ("dining_table",)}
    low, high = box("dining_table-0", (0.9, 1.8, 0.75), 3.0, 2.5), box("dining_table-0", (0.9, 1.8, 1.1), 3.0, 2.5)
    stool = box("stool-0", (0.4, 0.4, 0.45), 2.2, 2.5)
    assert holds(low, stool, **said) and not holds(high, stool, **said)


def test_between_two_of_a_kind_is_near_both() -> None:
    said: dict[str, Any] = {"type": "between", "subject": "stool", "targets": ("sofa",)}
    pair = box("sofa-0", SOFA, 0.6, 2.5), box("sofa-1", SOFA, 5.4, 2.5, 180)
    stool = box("stool-0", (0.4, 0.4, 0.45), 1.6, 2.5)
    assert not holds(*pair, stool, **said), "it is at one of two that are far apart"


def test_a_row_looks_one_way() -> None:
    case = rooms.living()
    row = [put(f"filing_cabinet-{k}", 1.0 + 0.5 * k, 2.0, 90 if k else -90, size=(0.5, 0.45, 1.3)) for k in range(3)]
    entity = {"id": "filing_cabinet", "noun": "filing cabinets", "category": "filing_cabinet", "count": (3, 3)}
    row_of = {"entity": "filing_cabinet", "pattern": "row"}
    brief = SceneGraph.model_validate({"text": "", "entities": [entity], "arrangements": [row_of]})
    found = Case(case.plus(*row).scene, case.room_type, brief).review().alignment
    assert found.of("arrangement-0").status == "unmet"
    even = [put(o.id, *o.pose.position[:2], 90, size=o.size) for o in row]
    assert Case(case.plus(*even).scene, case.room_type, brief).review().alignment.of("arrangement-0").status == "met"


def test_only_what_people_call_by_the_noun_is_one() -> None:
    assert is_one("folding_table", "dining_table", "tables") and is_one("sofa_bed", "sofa", "sofa")
    assert not is_one("side_table", "massage_table", "table") and not is_one("desk", "dining_table", "tables")


def test_a_seat_that_carries_a_basket_is_nobodys_place() -> None:
    data = {"text": "", "capacities": [{"people": 1, "activity": "sit", "words": "one sits"}]}
    seat = box("bench-0", (0.4, 0.6, 0.45), 3.0, 2.5)
    laden = carrier(seat), on(seat, "storage_box-0", (0.35, 0.5, 0.3))
    free = aligned((seat,), SceneGraph.model_validate(data)).of("capacity-0")
    taken = aligned(laden, SceneGraph.model_validate(data)).of("capacity-0")
    assert (free.status, taken.status) == ("met", "unmet")
