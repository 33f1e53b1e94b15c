"""Checks of the user's own."""

from __future__ import annotations

import pytest

import sceneweaver as sw
from sceneweaver.critic import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request

SCENE = sw.Scene.example("bedroom")


def review():
    return review_scene(SCENE, sw.check(SCENE), room_type("bedroom"), read_request("a bedroom"))


def crowded(scene: sw.Scene):
    for thing in scene.objects[:2]:
        yield sw.Fault(
            criterion="layout",
            kind="hemmed_in",
            objects=(thing.id,),
            reason=f"{thing.id} is hemmed in",
            points=1.5,
            tool="update_layout",
            inputs={"ids": [thing.id]},
        )


@pytest.fixture
def defined():
    sw.define_check("hemmed_in", crowded)
    yield
    sw.undefine_check("hemmed_in")


def test_what_it_finds_lowers_its_grade_and_no_other_and_brings_its_call(defined):
    with_check = review()
    sw.undefine_check("hemmed_in")
    before = review()
    sw.define_check("hemmed_in", crowded)
    found = [fault for fault in with_check.faults if fault.kind == "hemmed_in"]
    assert [fault.objects for fault in found] == [(thing.id,) for thing in SCENE.objects[:2]]
    assert found[0].tool == "update_layout" and not any(f.kind == "hemmed_in" for f in before.faults)
    assert with_check.grades["layout"] < before.grades["layout"]
    assert {k: v for k, v in with_check.grades.items() if k != "layout"} == {
        k: v for k, v in before.grades.items() if k != "layout"
    }


@pytest.mark.parametrize(
    ("check", "says"),
    [
        (lambda scene: [1 / 0], 'check "x": ZeroDivisionError: division by zero'),
        (lambda scene: ["too dark"], 'check "x": gave str, not a Fault'),
        (
            lambda scene: [sw.Fault(criterion="mood", kind="dark", reason="it is dark")],
            'criterion "mood" is none of realism',
        ),
    ],
)
def test_one_that_fails_is_named_in_one_line(check, says):
    sw.define_check("x", check)
    try:
        with pytest.raises(sw.InputError, match=says):
            review()
    finally:
        sw.undefine_check("x")


def test_a_name_is_used_once(defined):
    with pytest.raises(sw.InputError, match="there already"):
        sw.define_check("hemmed_in", crowded)
    with pytest.raises(sw.InputError, match="unknown"):
        sw.undefine_check("dim")
