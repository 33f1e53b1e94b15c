"""The account of a design: one list of demands, with what was not understood, and the mark for all of it."""

import json
from types import SimpleNamespace
from typing import Any

import pytest

from sceneweaver.furnish.asked import Asked
from sceneweaver.furnish.deliver import metrics_of
from sceneweaver.furnish.result import HomeResult
from sceneweaver.home import Home
from sceneweaver.language.homes.things import _wished
from sceneweaver.plans import Programme, check_plan
from sceneweaver.report.home import HomePage, home_report
from sceneweaver.verify.home import check_home

FLAT = Home.example("flat")


def result(text, **changed):
    demands = Asked.of(text, None, None, None).demands(FLAT)
    plan, programme = check_plan(FLAT), Programme.example("flat-2-bedrooms")
    return HomeResult(FLAT, check_home(FLAT), plan, programme, {}, demands=demands, **changed)


def test_what_is_not_understood_is_a_demand():
    made = result("a flat with a living room, the ceiling should be of glass")
    assert made.shares == {"met": 0.5, "partly": 0.0, "not met": 0.0, "not understood": 0.5}
    assert not made.satisfied and made.alignment == 5.0
    row = made.to_dict()["demands"][-1]
    assert (row["words"], row["kind"], row["status"]) == ("ceiling should be of glass", "words", "not understood")


@pytest.mark.parametrize(
    ("text", "unmet", "most"),
    [
        ("a flat with a living room", (), 10.0),
        ("a flat with a living room", ("living: no sofa",), 8.0),
        ("a flat with a living room, a kitchen, a bathroom and a garden gnome on stilts", (), 8.0),
    ],
)
def test_no_full_mark_where_anything_is_not_so(text, unmet, most):
    made = result(text, unmet=unmet)
    assert made.alignment <= most and (made.alignment == 10.0) == (most == 10.0)
    assert made.satisfied == (most == 10.0 and made.valid)


def test_metrics_and_page_have_the_list():
    made = result("a flat of at most 20 m2 with two bedrooms, the stairs must be gentle", remarks=("hello",))
    design = json.loads(json.dumps(metrics_of(made)))["design"]
    assert [row["status"] for row in design["demands"]] == ["met", "not met", "not understood"]
    assert design["demands"][1]["words"] == "at most 20 m2 in all" and 0 < design["alignment"] <= 8
    page = home_report(HomePage(FLAT, metrics=metrics_of(made)))
    for words in (
        "at most 20 m2 in all",
        "stairs must be gentle",
        "not understood",
        "of 10 for what was asked",
        "hello",
    ):
        assert words in page


def test_limits_are_hard_bounds_of_the_programme():
    asked = Asked.of("a flat of at most 70 m2 with two bedrooms, a bathroom of at most 5 m2", None, None, None)
    programme, _ = asked.possible()
    bath = next(room for room in programme.rooms if room.type == "bathroom")
    assert bath.area[2] == 5.0
    more = programme.model_copy(
        update={"rooms": tuple(r.model_copy(update={"area": tuple(2 * a for a in r.area)}) for r in programme.rooms)}
    )
    kept = asked.within(more)
    assert kept.room(bath.id).area[2] == bath.area[0] * 2  # what it needs at least it keeps
    for own in (False, True):
        import shapely

        for seed in range(4):
            inner = shapely.Polygon(asked.envelope_of(kept, seed, own).inner).area
            assert inner < 70 * 1.12  # walls between rooms take the rest


def test_a_programme_has_no_demands_in_words():
    asked = Asked.of("", Programme.example("flat-2-bedrooms"), None, None)
    assert asked.demands(FLAT) == () and asked.remarks == ()
    assert asked.within(asked.programme) is asked.programme


@pytest.mark.parametrize(("showers", "status"), [(0, "not met"), (1, "partly"), (2, "met")])
def test_as_many_things_as_are_told(showers, status):
    """Two showers are met by two, and one is a part of them."""
    have = ["toilet", *["shower"] * showers]
    room: Any = SimpleNamespace(id="bathroom")
    there: Any = SimpleNamespace(scene=SimpleNamespace())
    (demand,) = _wished(room, "with two showers", there, have)
    assert demand.status == status and demand.detail == f"{showers} shower"
