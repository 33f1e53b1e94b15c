"""What the agent remembers of its calls, and how far it trusts a tool after them."""

from __future__ import annotations

import pytest

from sceneweaver.agent.memory import FORGIVING, Call, Memory, Step
from sceneweaver.scene import InputError


def step(number: int, tool: str = "add_objects", accepted: bool = True, seconds: float = 1.0) -> Step:
    return Step(number=number, call=Call(tool=tool), accepted=accepted, seconds=seconds)


def test_calls_are_the_same_when_they_ask_for_the_same():
    one = Call(tool="add_crowd", inputs={"supports": ["a"], "density": 1.0}, seed=1, instruction="fill it")
    same = Call(tool="add_crowd", inputs={"density": 1.0, "supports": ["a"]}, seed=2, confidence=0.3, reason="empty")
    assert one.signature == same.signature
    assert len({one.signature, *(Call(tool=t, inputs=i).signature for t, i in OTHERS)}) == 1 + len(OTHERS)


OTHERS = [
    ("add_tabletop", {"supports": ["a"], "density": 1.0}),
    ("add_crowd", {"supports": ["b"], "density": 1.0}),
    ("add_crowd", {}),
]


def test_each_loss_lowers_the_trust_and_a_win_gives_half_a_loss_back():
    call = Call(tool="add_objects")
    memory = Memory()
    for k in range(3):
        memory = memory.after(step(k + 1, accepted=False), [call], (), ())
    assert memory.confidence == {"add_objects": pytest.approx(FORGIVING**3)}
    memory = memory.after(step(4), [], (), ())
    assert memory.confidence == {"add_objects": pytest.approx(FORGIVING**2.5)}
    for k in range(9):
        memory = memory.after(step(5 + k), [], (), ())
    assert memory.confidence == {"add_objects": 1.0}


def test_all_calls_that_brought_nothing_are_kept_and_count_on_their_own_tools():
    losers = [Call(tool="add_crowd", inputs={"supports": ["a"]}), Call(tool="add_objects"), Call(tool="add_objects")]
    memory = Memory().after(step(1, "update_size", accepted=False), losers, (), ())
    assert memory.failed == tuple(c.signature for c in losers)
    assert memory.confidence == {
        "add_crowd": pytest.approx(FORGIVING),
        "add_objects": pytest.approx(FORGIVING**2),
    }


def test_steps_without_progress_are_counted_until_one_succeeds():
    memory = Memory()
    for k, (accepted, stale) in enumerate([(True, 0), (False, 1), (False, 2), (True, 0), (False, 1)]):
        memory = memory.after(step(k + 1, accepted=accepted), [], (), ())
        assert memory.stale == stale
    assert [s.number for s in memory.steps] == [1, 2, 3, 4, 5] and memory.seconds == pytest.approx(5.0)


def test_what_was_said_is_said_once_and_in_order():
    memory = Memory().after(step(1), [], ("b", "a", "b"), ("x",)).after(step(2), [], ("a", "c"), ("y", "x"))
    assert memory.notes == ("b", "a", "c") and memory.unmet == ("x", "y")


def test_a_memory_does_not_change_and_survives_json():
    first = Memory()
    second = first.after(step(1), [Call(tool="add_crowd", inputs={"supports": [], "n": 2})], ("a",), ())
    second = second.model_copy(update={"plan": (Call(tool="add_tabletop"),), "finished": "2 steps"})
    assert first == Memory()
    assert Memory.model_validate(second.model_dump(mode="json")) == second
    with pytest.raises(InputError, match="confidense"):
        Memory.model_validate({"confidense": {}})
