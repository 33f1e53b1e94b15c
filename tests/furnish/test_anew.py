"""Plans to choose from, and rooms of a home furnished anew while the others stay."""

from __future__ import annotations

import pytest

import sceneweaver as sw
from sceneweaver.furnish import propose_plans, refurnish
from sceneweaver.plans import Envelope, Programme, check_plan

TINY = Programme.from_graph(
    {
        "hall": ("entrance_hall", 5),
        "bed": ("guest_room", 14),
        "store": ("storage_room", 3),
        "wc": ("guest_toilet", 2.4),
    },
    [("hall", "bed"), ("hall", "store"), ("hall", "wc")],
)
FAST = {"workers": 1, "steps": 1, "candidates": 8, "clutter": 0.0}


@pytest.fixture(scope="module")
def found():
    return propose_plans(programme=TINY, plans=64, count=3, seed=4, device="cpu")


@pytest.fixture(scope="module")
def furnished(found):
    """The best plan with its store and its toilet furnished."""
    return refurnish(found.plans[0].home, {"store": "", "wc": ""}, **FAST)


def test_proposals_are_valid_and_differ(found):
    assert 1 <= len(found.plans) <= 3 and found.programme == TINY and found.profile.name == "base"
    assert all(check_plan(plan.home, TINY, found.profile).valid for plan in found.plans)
    assert len({plan.home.dumps() for plan in found.plans}) == len(found.plans)
    again = propose_plans(programme=TINY, plans=64, count=3, seed=4, device="cpu")
    assert [plan.home for plan in again.plans] == [plan.home for plan in found.plans]


def test_words_say_profile_and_prompt():
    found = propose_plans("a one-bedroom flat for somebody in a wheelchair", plans=128, count=1, device="cpu")
    assert found.profile.name == "accessible" and found.plans[0].home.prompt.startswith("a one-bedroom flat")


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({}, "prompt: is empty"),
        ({"programme": TINY, "count": 0}, "count: 0"),
        ({"programme": TINY, "profile": "royal"}, "royal"),
        ({"programme": TINY, "envelope": Envelope.rectangle(3, 3), "plans": 8}, "programme|envelope"),
    ],
)
def test_bad_proposals_are_refused(options, match):
    with pytest.raises(sw.InputError, match=match) as caught:
        propose_plans(device="cpu", **options)
    assert "\n" not in str(caught.value)


def test_rooms_that_are_not_named_stay(furnished):
    home = furnished.home
    assert set(furnished.rooms) == {"store", "wc"} and home.room("bed").scene is None
    after = refurnish(home, {"store": "a store room with only one shelf"}, seed=9, **FAST)
    assert set(after.rooms) == {"store"} and after.rooms["store"].request == "a store room with only one shelf"
    assert after.home.room("wc").scene == home.room("wc").scene
    assert after.home.room("store").scene != home.room("store").scene
    assert (after.style, after.palette) == (furnished.style, furnished.palette)


def test_without_words_and_seed_a_room_is_what_it_was(furnished):
    again = refurnish(furnished.home, {"store": ""}, **FAST)
    assert again.home.room("store").scene == furnished.home.room("store").scene
    other = refurnish(furnished.home, {"store": ""}, seed=77, **FAST)
    assert other.rooms["store"].request == again.rooms["store"].request
    assert other.home.room("store").scene != again.home.room("store").scene


def test_only_rooms_that_are_furnished_can_be_named(found):
    home = found.plans[0].home
    with pytest.raises(sw.InputError, match="ballroom"):
        sw.furnish_home(home, only=["ballroom"])
    house = sw.Home.of_rooms({"stairs": (0, 0, 3, 2), "bedroom": (3.1, 0, 7, 4)})
    with pytest.raises(sw.InputError, match="only: stairs is of type stairs, which stays empty"):
        sw.furnish_home(house, only=["stairs"])
