"""Every seat that a request has at a table, in a row or before a mirror has its place there in a first draft."""

from __future__ import annotations

from collections import Counter

from sceneweaver.assets import Library
from sceneweaver.generate.people import with_people
from sceneweaver.generate.room import first_draft
from sceneweaver.generate.setup import Setup
from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Room, Scene
from tests.generate.drafts import drawn

EMPTY = Scene(id="empty", room=Room(outline=((0, 0), (4, 0), (4, 3), (0, 3))))


def draft(text: str, kind: str) -> Scene:
    room = room_type(kind)
    brief = with_people(read_request(text), room)
    scene = first_draft(Setup(brief=brief, room_type=room, scene=EMPTY, library=Library(), seed=2)).scene
    assert scene is not None
    return scene


def test_each_table_has_its_own_chairs_on_free_sides():
    scene = draft("a bistro with four tables for two at the window and a table for six in the middle", "restaurant")
    at = [r for r in scene.relations if r.type == "seated_at" and r.hard]
    assert sorted(Counter(r.target for r in at).values()) == [2, 2, 2, 2, 6]
    small = {t for t, n in Counter(r.target for r in at).items() if n == 2}
    assert {r.params["side"] for r in at if r.target in small} == {"left", "right"}


def test_a_u_of_tables_is_sat_at_from_outside_and_takes_the_place_of_desks():
    scene = draft("a course room for 12 people, tables in a U that opens to the whiteboard", "classroom")
    at = [r for r in scene.relations if r.type == "seated_at" and r.hard]
    assert len(at) == 12
    assert {r.params["side"] for r in at} == {"back"}
    assert not [o.id for o in scene.objects if o.category == "school_desk"]


def test_guests_sit_before_a_counter():
    scene = draft("a bar with a counter and six bar stools at the counter", "bar")
    at = [r for r in scene.relations if r.type == "seated_at" and r.hard and str(r.target).startswith("bar_counter")]
    assert len(at) == 6
    assert {r.params["side"] for r in at} == {"front"}


def test_stations_are_in_line_each_with_its_own_mirror():
    scene = draft("three barber chairs with centres 1.7 m apart, each in front of its own mirror", "hair_salon")
    arranged = {r.subject: r for r in scene.relations if r.type == "arranged"}
    chairs = [o.id for o in scene.objects if o.category == "barber_chair"]
    mirrors = [o.id for o in scene.objects if o.category == "wall_mirror"]
    steps = sorted(abs(float(arranged[c].params["left"])) for c in chairs if c in arranged)
    assert [round(s, 2) for s in steps] == [1.7, 1.7]
    assert sorted(str(arranged[m].target) for m in mirrors) == sorted(chairs)
    assert not [o.id for o in scene.objects if o.category == "barber_station"]


def test_benches_are_long_enough_for_their_people():
    scene = draft("a changing room for 16 players, benches along the two long walls", "changing_room")
    benches = [o for o in scene.objects if o.category == "changing_bench"]
    assert sum(int(max(o.size[:2]) / 0.55) for o in benches) >= 16


def test_a_row_of_stools_is_along_the_front_of_a_counter_that_is_long_enough():
    scene = draft("a noodle shop with one counter and nine stools in a row along it", "sushi_bar")
    at = [r for r in scene.relations if r.type == "seated_at" and r.hard]
    counter = scene.object(at[0].targets[0])
    assert len(at) == 9 and {r.targets[0] for r in at} == {counter.id} and {r.params["side"] for r in at} == {"front"}
    assert counter.size[1] >= 9 * 0.6
    # its front is kept clear for guests, and its back for who serves them: neither for these stools nor at a wall
    tied = {r.subject for r in scene.relations if r.type == "front_against" and r.target == counter.id}
    assert tied == {r.subject for r in at}
    walled = [r for r in scene.relations if r.type == "against_wall" and r.subject == counter.id]
    assert not any(r.hard for r in walled) and all(r.params["gap"][0] >= 0.7 for r in walled)


def test_a_half_circle_goes_over_half_a_circle_with_what_it_looks_at_before_its_open_side():
    for text in (
        "seven chairs in a half circle facing a small stage",
        "a half circle of six chairs around a fireplace",
    ):
        scene = draft(text, "living_room")
        chairs = [r for r in scene.relations if r.type == "arranged" and r.subject.startswith("chair")]
        focus = [r for r in scene.relations if r.type == "arranged" and not r.subject.startswith("chair")]
        turns = [0.0, *(float(r.params["turn"]) for r in chairs)]
        assert 140 <= max(turns) - min(turns) <= 200
        assert len(focus) == 1 and focus[0].params["ahead"] > 1.0


def test_what_is_below_a_window_has_its_back_to_that_wall_and_a_window_of_its_own(library: Library) -> None:
    scene = drawn("a living room with a sofa under the window and a bench under the other window", library)
    panes = {r.subject: r.target for r in scene.relations if r.type == "at_window" and r.asked}
    walls = {r.subject: r.target for r in scene.relations if r.type == "against_wall" and r.asked}
    windows = {window.id: f"wall:{window.wall}" for window in scene.room.windows}
    below = [o.id for o in scene.objects if o.category in ("sofa", "bench")]
    assert len({panes[name] for name in below}) == min(2, len(windows))
    assert all(walls[name] == windows[str(panes[name])] for name in below)
