"""Demands as measured in homes: against a second count in plain numbers, and homes that are changed."""

import numpy as np
import pytest

from sceneweaver.home import Home
from sceneweaver.language.homes import demands, read_home
from sceneweaver.language.homes.measured import MeasuredHome

FLAT = Home.example("flat")


def status(text, home=FLAT):
    return {demand.words: demand.status for demand in demands(read_home(text), home)}


def shoelace(points):
    xs, ys = np.asarray(points, float).T
    return 0.5 * abs(np.dot(xs, np.roll(ys, -1)) - np.dot(ys, np.roll(xs, -1)))


def doors(home, **changed):
    return home.with_changes(doors=tuple(door.model_copy(update=changed) for door in home.doors))


def test_measures_against_plain_numbers():
    measured = MeasuredHome(FLAT)
    assert measured.total == pytest.approx(sum(shoelace(room.outline) for room in FLAT.rooms), abs=1e-9)
    for room in FLAT.rooms:
        box = np.ptp(np.asarray(room.outline), axis=0)
        if len(room.outline) == 4:
            assert measured.narrowest(room) == pytest.approx(box.min(), abs=0.02)
            assert measured.turns(room) == (box.min() >= 1.5)
    steps = measured.steps_from_entrance()
    assert (
        steps["hall"] == 0 and all(steps[name] == 1 for name in ("bath", "bedroom", "living")) and steps["kitchen"] == 2
    )
    corners = np.vstack([room.outline for room in FLAT.rooms])
    assert measured.sides() == pytest.approx(tuple(np.ptp(corners, axis=0) + 0.6))


def test_counts():
    asked = status("a two-bedroom flat with a balcony and two bathrooms")
    assert asked == {"2 to sleep in": "met", "1 balcony": "not met", "2 to bathe in": "partly"}


def test_what_is_assumed_is_no_demand():
    assert demands(read_home("a flat"), FLAT) == []


def test_areas():
    total = MeasuredHome(FLAT).total
    assert status(f"a flat of {total:.0f} m2")[f"{total:.0f} m2 in all"] == "met"
    assert status(f"a flat of {total * 1.1:.0f} m2")[f"{total * 1.1:.0f} m2 in all"] == "partly"
    assert status(f"a flat of {total * 2:.0f} m2")[f"{total * 2:.0f} m2 in all"] == "not met"
    living = next(shoelace(room.outline) for room in FLAT.rooms if room.id == "living")
    assert status(f"a flat with a living room of {living:.1f} m2")[f"living_room: {living:.1f} m2"] == "met"


def test_joints():
    text = "flat, kitchen open to the living room, a bathroom off the bedroom, bedroom far from the kitchen"
    found = [(d.words.split(":")[0], d.status) for d in demands(read_home(text), FLAT) if d.kind == "joint"]
    assert found == [("open", "met"), ("door", "partly"), ("apart", "met")]
    hinged = doors(FLAT, kind="hinged", opens_into=None)
    assert [
        d.status for d in demands(read_home("flat, kitchen open to the living room"), hinged) if d.kind == "joint"
    ] == ["partly"]


def test_entrance():
    near = "a flat with a bathroom by the entrance, kitchen by the entrance"
    assert [d.status for d in demands(read_home(near), FLAT) if d.kind == "joint"] == ["met", "not met"]


def test_accessible():
    text = "an accessible flat with two bedrooms"
    narrow = status(text)
    assert narrow["doors of 0.85 m"] == "not met" and narrow["ways of 1.2 m"] == "met"
    wide = doors(FLAT, width=0.9)
    assert status(text, wide)["doors of 0.85 m"] == "met"


def test_storeys_and_exclusions():
    asked = status("a two-storey flat without a kitchen, windows only on two sides")
    assert asked["2 storeys"] == "not met" and asked["no kitchen"] == "not met"
    assert asked["windows on 2 sides"] == "not met"
    south = FLAT.with_changes(windows=FLAT.windows[:1])
    assert status("a flat, windows only on two sides", south)["windows on 2 sides"] == "met"


def test_envelope():
    width, depth = MeasuredHome(FLAT).sides()
    assert status(f"a flat of {width:g} x {depth:g} m")[f"{width:g} x {depth:g} m"] == "met"
    assert status(f"a flat of {width + 3:g} x {depth:g} m")[f"{width + 3:g} x {depth:g} m"] == "not met"
    assert status("an L-shaped flat")["L-shaped"] == "not met"
