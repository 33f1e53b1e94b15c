"""Tables are as long as the seats that a request puts at them need it."""

from __future__ import annotations

import pytest

from sceneweaver.agent.design import chosen_room
from sceneweaver.assets import Library
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


def drawn(text: str) -> Scene:
    brief = read_request(text)
    room = chosen_room(brief)[0]
    from sceneweaver.agent.loop import empty_scene

    context = Context(brief, room, empty_scene(brief, room), Library(), 0, text, {}, lambda: False)
    scene = InitPrior().propose(context).scene
    assert scene is not None
    return scene


def table(scene: Scene) -> float:
    return max(max(o.size[:2]) for o in scene.objects if "table" in o.category and o.intent.request is not None)


def chairs(scene: Scene) -> list[float]:
    return [o.size[1] for o in scene.objects if "chair" in o.category and o.intent.request is not None]


@pytest.mark.parametrize("many", [6, 8])
def test_a_round_table_has_room_for_its_chairs(many: int) -> None:
    scene = drawn(f"a dining room with a round dining table and {many} chairs around it")
    assert len(chairs(scene)) == many
    assert table(scene) >= max(chairs(scene)) / 0.4142 + 0.15  # an edge of the octagon is as wide as a chair


def test_a_table_is_as_long_as_the_chairs_along_it() -> None:
    scene = drawn("a dining room with a dining table flanked by ten chairs")
    assert len(chairs(scene)) == 10
    assert table(scene) >= 5 * max(chairs(scene))
    sides = [r.params["side"] for r in scene.relations if r.type == "seated_at" and r.asked]
    assert len(sides) == 10 and len(set(sides)) == 2


def test_a_size_that_was_asked_for_stays() -> None:
    scene = drawn("a dining room with a dining table 1.2 m long flanked by ten chairs")
    assert table(scene) == pytest.approx(1.2, abs=0.02)


def test_two_chairs_flank_a_table_at_its_ends() -> None:
    scene = drawn("a dining room with a dining table flanked by two chairs")
    assert {r.params["side"] for r in scene.relations if r.type == "seated_at" and r.asked} == {"left", "right"}


def test_seats_share_the_side_that_their_room_gives_them() -> None:
    scene = drawn("an interrogation room")
    chosen = {o.id: o.intent.program_item for o in scene.objects}
    sides = {(chosen[r.subject], r.params["side"]) for r in scene.relations if r.type == "seated_at"}
    assert sides == {("officer", "front"), ("suspect", "back")}


@pytest.mark.parametrize("table_", ["tables", "bolted tables"])
def test_tables_are_as_long_as_the_seats_that_are_asked_for_need(table_: str) -> None:
    scene = drawn(f"a canteen with two long {table_} and 24 chairs")
    tables = [o for o in scene.objects if o.category in ("dining_table", "interview_table")]
    seated = {r.subject: r.target for r in scene.relations if r.type == "seated_at"}
    assert len(tables) == 2 and len(seated) == 24
    for one in tables:  # all but those at its ends along both sides
        assert max(one.size[:2]) >= 0.6 * (sum(host == one.id for host in seated.values()) - 2) / 2
