"""What gives way where a programme has no plan, and that a plan comes out."""

import time

import pytest

from sceneweaver.furnish.asked import Asked
from sceneweaver.furnish.design import _Run
from sceneweaver.furnish.giving_way import areas_asked, missed, softer
from sceneweaver.furnish.outside import has_outside_door
from sceneweaver.furnish.side_by_side import RoomPool
from sceneweaver.language.homes import demands, read_home
from sceneweaver.plans import Adjacency, Programme, check_plan
from sceneweaver.runtime.deadline import Deadline, Stop


def planned(text, plans=96):
    """A request's plan, the programme it was solved for, and the run."""
    asked = Asked.of(text, None, None, None)
    limit = Deadline(time.monotonic() + 60, stop=Stop())
    run = _Run(asked, 0, "cpu", RoomPool(1), plans, {}, {}, limit, None, None)
    home, programme = run._planned(asked.possible()[0], 0)
    return home, programme, run


def test_the_order_in_which_things_give_way():
    programme = Programme.example("flat-2-bedrooms")
    a, b = programme.rooms[1].id, programme.rooms[2].id
    pairs = {frozenset((x.a, x.b)) for x in programme.adjacencies}
    if frozenset((a, b)) not in pairs:
        wish = Adjacency(a=a, b=b, kind="near", hard=False)
        programme = programme.model_copy(update={"adjacencies": (*programme.adjacencies, wish)})
    steps = list(softer(programme))
    lines = [step.line for step in steps]
    assert lines[0].startswith("what is wished") and lines[1:3] == ["areas give way by 10 %", "areas give way by 20 %"]
    assert all(x.hard for x in steps[0].programme.adjacencies)
    for before, step in zip(steps, steps[1:], strict=False):
        for old, new in zip(before.programme.rooms, step.programme.rooms, strict=True):
            assert new.area[0] <= old.area[0] and new.area[2] >= old.area[2]


def test_assumed_doors_give_way_before_those_that_were_asked_for():
    request = read_home("doctor's practice, two exam rooms, a sterilisation room between them with a door to both")
    lines = [step.line for step in softer(request.programme, request)]
    assert lines.index("doors that were assumed give way") < lines.index("doors that were asked for give way")
    steps = {step.line: step.programme for step in softer(request.programme, request)}
    kept = {(x.a, x.b) for x in steps["doors that were assumed give way"].adjacencies}
    assert kept == {("sterilisation", "examination_room"), ("sterilisation", "examination_room-2")}


@pytest.mark.parametrize(
    "text",
    [
        "a wheelchair accessible flat with one bedroom, a bathroom of 3 m2 and a kitchen",
        pytest.param("a flat 7 m x 5 m with two bedrooms of 15 m2 each and a kitchen", marks=pytest.mark.slow),
        "an office of 40 m2 with a meeting room of 25 m2, two private offices of 15 m2 each and a toilet",
    ],
)
def test_a_request_that_contradicts_itself_gets_a_plan_and_is_told(text):
    home, programme, run = planned(text)
    assert check_plan(home, programme, run.asked.profile).valid
    wanted, _ = missed(run.asked.programme, home, run.asked.profile, run.asked.areas)
    told = [d for d in demands(read_home(text), home) if d.status != "met"]
    assert wanted or told


def test_what_nobody_asked_for_is_no_want():
    request = read_home("a two-bedroom flat with a kitchen of 9 m2")
    assert areas_asked(request, request.programme) == {"kitchen"}
    assert areas_asked(None, request.programme) == {room.id for room in request.programme.rooms}


def test_widths_that_are_asked_for_are_kept():
    text = "a flat with one bedroom and a kitchen, all doors 95 cm wide, corridors of 1.3 m"
    home, _, run = planned(text)
    assert min(door.width for door in home.doors) >= 0.95
    assert {d.words: d.status for d in demands(read_home(text), home)}["doors of 0.95 m"] == "met"
    narrow = home.with_changes(
        doors=tuple(d.model_copy(update={"width": 0.8}) if d.to is not None else d for d in home.doors)
    )
    broken = {v.rule for v in check_plan(narrow, None, run.asked.profile).violations}
    assert "asked-doors" in broken


def test_a_door_outside_where_it_is_asked_for():
    home, programme, run = planned("house with a workshop with its own entrance, one bedroom and a kitchen")
    assert has_outside_door(home, "workshop") and check_plan(home, programme, run.asked.profile).valid
    door = next(d for d in home.doors if d.room == "workshop" and d.to is None)
    assert check_plan(home.with_changes(doors=tuple(d for d in home.doors if d != door)), programme).valid
