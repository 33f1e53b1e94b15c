"""Programmes that contradict the rules of a profile, and such whose floor is told."""

import pytest

from sceneweaver.plans import Programme, feasible, totalled


def _programme(**rooms):
    return Programme.from_graph({"hall": "entrance_hall", **rooms}, [("hall", name) for name in rooms])


def test_what_contradicts_nothing_stays():
    programme = Programme.example("flat-2-bedrooms")
    asked = [room.id for room in programme.rooms]
    assert feasible(programme, "base", asked) == (programme, ())


def test_a_default_gives_way_to_a_row_and_what_is_asked_by_as_little_as_can_be():
    programme = _programme(
        toilet={"type": "washroom", "area": (2.5, 3.0, 4.0)}, bed={"type": "bedroom", "area": (4, 5, 6)}
    )
    free, told = feasible(programme, "accessible")
    assert free.room("toilet").area[0] >= 5 and free.room("bed").area[0] >= 6.5
    assert [line.partition(":")[0] for line in told] == ["toilet", "bed"]
    firm, _ = feasible(programme, "accessible", ["toilet", "bed"])
    for name in ("toilet", "bed"):
        assert firm.room(name).area[0] == free.room(name).area[0]
        assert firm.room(name).area[2] < free.room(name).area[2]


def test_a_default_without_choice_gets_some():
    narrow = _programme(archive={"type": "archive", "area": (9.0, 9.0, 9.0)})
    assert feasible(narrow)[0].room("archive").area[2] > 9
    assert feasible(narrow, "base", ["archive"])[0] == narrow


@pytest.mark.parametrize("total", [1.0, 55.0, 70.0, 85.0, 500.0])
def test_targets_reach_a_total_as_far_as_bounds_allow(total):
    programme = Programme.example("flat-2-bedrooms")
    indoors = [room.id for room in programme.rooms if "outdoor" not in room.kind.roles]
    after = totalled(programme, total)
    found = sum(after.room(name).area[1] for name in indoors)
    low, high = (sum(after.room(name).area[k] for name in indoors) for k in (0, 2))
    assert all(room.area[0] <= room.area[1] <= room.area[2] for room in after.rooms)
    if low < total < high:
        assert found == pytest.approx(total, abs=0.1)
    else:
        assert found <= high + 1e-6 if total > high else found < sum(programme.room(n).area[1] for n in indoors)


def test_what_was_asked_stays_in_a_total():
    programme = Programme.example("flat-2-bedrooms")
    name = programme.rooms[1].id
    assert totalled(programme, 60, [name]).room(name) == programme.room(name)
