"""How calls are chosen, and what the memory makes of their outcome."""

from __future__ import annotations

import ast
from dataclasses import replace
from pathlib import Path

import pytest

from sceneweaver import agent
from sceneweaver.agent.design import usable
from sceneweaver.agent.memory import Call, Memory, Step
from sceneweaver.agent.planner import RulesPlanner, Situation
from sceneweaver.agent.settings import Settings
from sceneweaver.critic import CRITERIA, Fault, Review
from sceneweaver.knowledge import room_type
from sceneweaver.language import SceneGraph
from sceneweaver.scene import InputError, Scene
from sceneweaver.tools.registry import tools

CARDS = {name: tool.card for name, tool in tools().items()}


def _situation(faults=(), memory=None, scene=True, **settings):
    review = Review(grades=dict.fromkeys(CRITERIA, 8.0), faults=tuple(faults))
    return Situation(
        SceneGraph(text="a bedroom", room_type="bedroom"),
        room_type("bedroom"),
        Scene.example("bedroom") if scene else None,
        review if scene else None,
        memory or Memory(),
        CARDS,
        Settings(**settings),
    )


def _fault(tool, points, **inputs):
    reason = f"{tool} {points}"
    return Fault(criterion="completion", kind="test", reason=reason, tool=tool, inputs=inputs, points=points)


def test_a_run_begins_with_initialisers_and_draws_of_their_own():
    calls = RulesPlanner().plan(_situation(scene=False, side_by_side=3))
    assert calls[0].tool == "init_prior" and calls[0].seed == 0
    assert len({(c.tool, c.seed) for c in calls}) == 3
    assert all(CARDS[c.tool].role == "initializer" for c in calls)


def test_the_gravest_faults_come_first_and_those_of_a_tool_together():
    faults = [
        _fault("add_tabletop", 1.0, supports=["desk-0"]),
        _fault("add_tabletop", 1.5, supports=["nightstand-0"]),
        _fault("update_rotation", 0.5, ids=["chair-0"]),
    ]
    calls = RulesPlanner().plan(_situation(faults))
    assert calls[0].tool == "add_tabletop"
    assert set(calls[0].inputs["supports"]) == {"desk-0", "nightstand-0"}
    assert 0 < calls[0].confidence <= 1 and "2.5 points" in calls[0].reason


def test_what_was_asked_for_comes_before_polish_and_in_a_call_of_its_own():
    polish = [_fault("add_objects", 3.0, objects=[{"category": "plant"}]), _fault("update_rotation", 4.0, ids=["a"])]
    asked = [
        Fault(criterion="alignment", kind="k", reason=f"{p} points", tool=tool, inputs=inputs, points=p)
        for tool, p, inputs in (
            ("add_objects", 1.0, {"objects": [{"category": "lamp"}]}),
            ("add_objects", 1.2, {"objects": [{"category": "desk"}]}),
            ("add_relation", 1.0, {"relations": [{"type": "near", "subject": "a", "target": "b"}]}),
        )
    ]
    calls = RulesPlanner().plan(_situation([*polish, *asked], side_by_side=8))
    order = [(c.tool, len(c.inputs.get("objects", ()))) for c in calls]
    assert order[:2] == [("add_objects", 3), ("add_objects", 2)]
    assert order.index(("add_relation", 0)) < order.index(("update_rotation", 0))
    assert "5.2 points" in calls[0].reason


def test_what_was_asked_for_stays_in_the_call_for_several_tables():
    faults = [
        _fault("add_tabletop", 1.0, supports=["nightstand-0"]),
        _fault("add_tabletop", 3.0, supports=["desk-0"], objects=[{"category": "monitor", "count": 2}]),
    ]
    call = RulesPlanner().plan(_situation(faults))[0]
    assert call.inputs["objects"] == [{"category": "monitor", "count": 2}] and len(call.inputs["supports"]) == 2


def test_shelves_are_not_filled_that_are_to_be_arranged():
    faults = [
        _fault("add_tabletop", 1.0, supports=["desk-0"]),
        _fault("add_crowd", 3.0, supports=["desk-0", "shelf-0"]),
    ]
    calls = RulesPlanner().plan(_situation(faults))
    crowd = next(c for c in calls if c.tool == "add_crowd")
    assert crowd.inputs["supports"] == ["shelf-0"]


def test_what_brought_nothing_is_not_tried_again():
    fault = _fault("add_objects", 2.0, objects=[{"category": "plant"}])
    call = RulesPlanner().plan(_situation([fault]))[0]
    step = Step(number=1, call=call, accepted=False)
    memory = Memory().after(step, [call], (), ())
    assert memory.confidence["add_objects"] < 1 and memory.stale == 1
    assert RulesPlanner().plan(_situation([fault], memory)) == []


def test_trust_comes_back_with_success_and_a_memory_survives_json():
    call = Call(tool="add_objects", inputs={"objects": [{"category": "plant"}]})
    lost = Memory().after(Step(number=1, call=call, accepted=False), [call], ("a",), ("b",))
    won = lost.after(Step(number=2, call=call, accepted=True), [], ("a", "c"), ())
    assert won.confidence["add_objects"] > lost.confidence["add_objects"]
    assert won.notes == ("a", "c") and won.unmet == ("b",) and won.stale == 0
    assert Memory.model_validate(won.model_dump(mode="json")) == won


def test_settings_out_of_range_are_refused():
    with pytest.raises(InputError, match="steps"):
        Settings(steps=0)
    with pytest.raises(InputError, match="seed"):
        Settings(seed=-1)


def test_every_setting_is_read_somewhere():
    folder = Path(agent.__file__).parent
    read = {
        node.attr
        for file in folder.rglob("*.py")
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load)
    }
    assert set(Settings.model_fields) <= read


def test_a_tool_is_used_in_the_rooms_of_its_card_alone():
    crowd = tools()["add_crowd"]
    only_shops = replace(crowd, card=crowd.card.model_copy(update={"rooms": ("shop",)}))
    shop, bedroom = room_type("shop"), room_type("bedroom")
    assert [usable("add_crowd", only_shops, Settings(), room) for room in (shop, bedroom)] == [True, False]
    assert not usable("add_crowd", crowd, Settings(tools=("add_objects",)), shop)


def test_a_room_is_laid_out_anew_once_and_when_nothing_cheaper_is_left():
    anew, cheap = _fault("update_layout", 3.0), _fault("update_rotation", 0.5, ids=["chair-0"])
    some = _fault("update_layout", 1.0, ids=["desk-0"])
    assert [c.tool for c in RulesPlanner().plan(_situation([anew, cheap]))] == ["update_rotation"]
    (call,) = RulesPlanner().plan(_situation([anew]))
    assert call.tool == "update_layout" and not call.inputs.get("ids")
    done = Memory(steps=(Step(number=1, call=call, accepted=True),))
    failed = Memory(failed=(call.model_copy(update={"inputs": {"ids": []}}).signature,))
    for memory in (done, failed):
        assert RulesPlanner().plan(_situation([_fault("update_layout", 3.0, near="desk-0")], memory)) == []
        assert RulesPlanner().plan(_situation([some], memory))
    assert Call.of(call.signature).signature == call.signature
