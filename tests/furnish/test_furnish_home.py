"""All rooms of a home furnished together: shells that stay, one look, the same on any number of processes."""

from __future__ import annotations

import pytest

import sceneweaver as sw
from sceneweaver.furnish import room_requests
from sceneweaver.furnish.home import room_jobs
from sceneweaver.furnish.jobs import FurnishedRoom, furnish_room
from sceneweaver.furnish.kinds import kind_of
from sceneweaver.furnish.requests import least_side
from sceneweaver.furnish.side_by_side import RoomPool
from sceneweaver.furnish.windows import with_sills

FAST = {"steps": 1, "candidates": 8, "draws": 1}


def _flat(*names: str) -> sw.Home:
    """Some rooms of the example, with what joins them."""
    flat = sw.Home.example("flat")
    rooms = tuple(room for room in flat.rooms if room.id in names)
    doors = tuple(d for d in flat.doors if d.room in names and (d.to is None or d.to in names))
    windows = tuple(w for w in flat.windows if w.room in names)
    return flat.with_changes(rooms=rooms, doors=doors, windows=windows)


def test_each_room_is_asked_for_once() -> None:
    texts = room_requests(sw.Home.example("flat"))
    assert [name for name, text in texts.items() if "dining table" in text and "without" not in text] == ["kitchen"]
    assert "double bed" in texts["bedroom"]
    told = room_requests(sw.Home.example("flat"), {"living": "a living room with a dining table for 6 people"})
    assert told["kitchen"] == "a kitchen without a dining table"
    assert told["living"] == "a living room with a dining table for 6 people"


def test_types_of_plans_have_kinds() -> None:
    from sceneweaver.plans import room_types

    kinds = {name: kind_of(name) for name in room_types()}
    assert [name for name, kind in kinds.items() if kind is None] == [
        name for name, row in room_types().items() if row.furnish is None
    ]
    unknown = kind_of("bureau of a wizard")
    assert unknown is not None and unknown.items


def test_least_side_of_a_room_that_is_no_rectangle() -> None:
    room = sw.Home.example("flat").room("hall")
    ell = room.model_copy(update={"outline": ((0, 0), (4, 0), (4, 1.2), (1.5, 1.2), (1.5, 5), (0, 5))})
    assert least_side(room) == pytest.approx(1.6, abs=0.02)
    assert least_side(ell) == pytest.approx(1.5, abs=0.02)


def test_one_look_for_all_rooms() -> None:
    scheme, jobs = room_jobs(sw.Home.example("flat"), seed=3)
    finish = {job.room_id: job.shell.finish for job in jobs}
    dry = {(finish[n].floor.material, finish[n].floor.tone) for n in ("living", "hall", "bedroom", "bedroom-2")}
    assert len(dry) == 1 and not {material for material, _ in dry} & {"tile", "stone"}
    assert finish["bath"].floor.material == "tile"
    assert finish["kitchen"].floor == finish["living"].floor  # a passage without a leaf joins them
    assert len({f.trim for f in finish.values()}) == 1
    palettes = {job.palette.woods + job.palette.metals for job in jobs if job.palette is not None}
    assert len(palettes) == 1
    assert {job.palette.style for job in jobs if job.palette is not None} == {scheme.style}
    rustic = room_jobs(sw.Home.example("flat"), seed=3, prompt="a rustic home")[0]
    assert rustic.style == "rustic"


def test_a_request_of_a_room_has_its_own_look() -> None:
    _, jobs = room_jobs(sw.Home.example("flat"), {"bedroom": "a bedroom with blue walls and a tiled floor"}, seed=3)
    own = next(job for job in jobs if job.room_id == "bedroom")
    assert "blue" in own.shell.finish.walls and own.shell.finish.floor.material == "tile"


def test_sills_of_kitchens_are_over_the_tap() -> None:
    flat = sw.Home.example("flat")
    raised = {w.id: w for w in with_sills(flat).windows}
    for window in flat.windows:
        other = raised[window.id]
        if window.room == "kitchen":
            assert other.sill >= 1.3 and other.sill + other.height >= window.sill + window.height - 1e-9
        if window.room.startswith("bedroom"):
            assert other == window


@pytest.mark.slow
def test_the_same_on_one_process_and_on_two() -> None:
    home = _flat("hall", "bath")
    one = sw.furnish_home(home, workers=1, seed=4, **FAST)
    with RoomPool(2) as pool:
        two = sw.furnish_home(home, pool=pool, seed=4, **FAST)
        used = set(pool._pool._processes)
        bath = two.rooms["bath"]  # the hall alone is made again, by those that are there
        kept = {"kept": lambda job: bath if job.room_id == "bath" else None}
        again = sw.furnish_home(home, pool=pool, seed=4, **kept, **FAST)
        assert len(used) == 2 and set(pool._pool._processes) == used
    assert one.home.dumps() == two.home.dumps()
    assert again.home.room("hall").scene == one.home.room("hall").scene
    for room in one.home.rooms:
        shell = home.shell(room.id)
        assert (room.scene.room.outline, room.scene.room.doors, room.scene.room.windows) == (
            shell.outline,
            shell.doors,
            shell.windows,
        )


def test_the_same_room_whatever_is_beside_it_and_its_shell_stays() -> None:
    flat = sw.Home.example("flat")
    found = []
    for home in (flat, flat.with_changes(rooms=flat.rooms[::-1])):
        _, jobs = room_jobs(home, seed=4, steps=1, candidates=8)
        found.append({job.room_id: job.key for job in jobs})
    assert found[0] == found[1]
    done = furnish_room(next(job for job in jobs if job.room_id == "hall"))
    shell = flat.shell("hall")
    assert done.valid
    assert (done.scene.room.outline, done.scene.room.doors, done.scene.room.windows) == (
        shell.outline,
        shell.doors,
        shell.windows,
    )
    assert flat.with_scene("hall", done.scene).room("hall").scene is not None


def test_rooms_that_are_kept_are_not_made_again() -> None:
    home, made = _flat("hall"), list[str]()
    first = sw.furnish_home(home, workers=1, seed=4, said=lambda room: made.append(room.room_id), **FAST)
    kept = first.rooms["hall"]
    again = sw.furnish_home(
        home,
        workers=1,
        seed=4,
        kept=lambda job: kept if job.key == first.jobs["hall"].key else None,
        finished=lambda job, room: made.append("again"),
        **FAST,
    )
    assert again.rooms["hall"] is kept and made == ["hall"]


def test_of_two_draws_the_better_one_is_taken() -> None:
    lacks = FurnishedRoom("a", "a bathroom", lacking=("toilet",))
    asked = FurnishedRoom("a", "a bathroom", unmet=("a bathtub",))
    assert max([asked, lacks], key=lambda room: room.worth) is lacks  # what was asked for comes first
    assert not lacks.satisfied and not lacks.valid


@pytest.mark.parametrize(
    ("options", "named"),
    [({"workers": 0}, "workers"), ({"time_limit": 0.0}, "time_limit"), ({"requests": {"attic": "an attic"}}, "attic")],
)
def test_bad_arguments_are_named(options: dict, named: str) -> None:
    with pytest.raises(sw.InputError, match=named):
        sw.furnish_home(_flat("hall"), **options)


def test_a_room_that_cannot_be_made_says_why() -> None:
    _, jobs = room_jobs(_flat("hall"), seed=1)
    broken = furnish_room(jobs[0].__class__("hall", "", jobs[0].shell, None, 0, {"steps": -1}))
    assert broken.failed and broken.scene is None


@pytest.mark.slow
def test_a_whole_flat_is_valid_and_walked_through() -> None:
    from sceneweaver.verify.home import check_home

    done = sw.furnish_home(with_sills(sw.Home.example("flat")), seed=1)
    assert all(room.report.valid for room in done.rooms.values())
    assert not check_home(done.home).access.unreached_rooms
