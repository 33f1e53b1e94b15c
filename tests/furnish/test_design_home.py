"""From words to a folder: the run, its feedback, and going on after a kill."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest

import sceneweaver as sw
from sceneweaver.assets import Library
from sceneweaver.furnish import asks_for_home, design, side_by_side
from sceneweaver.furnish.asked import Asked
from sceneweaver.furnish.folder import HomeFolder, room_folder
from sceneweaver.furnish.home import FurnishedHome, room_jobs
from sceneweaver.furnish.jobs import FurnishedRoom, RoomJob
from sceneweaver.furnish.result import unmet_of
from sceneweaver.plans import Programme

TINY = Programme.from_graph(
    {
        "hall": ("entrance_hall", 5),
        "bed": ("guest_room", 14),
        "store": ("storage_room", 3),
        "wc": ("guest_toilet", 2.4),
    },
    [("hall", "bed"), ("hall", "store"), ("hall", "wc")],
)
FAST = {
    "plans": 32,
    "steps": 1,
    "candidates": 8,
    "draws": 1,
    "workers": 1,
    "device": "cpu",
    "pictures": "none",
    "export": "none",
}


def test_a_home_in_a_folder(tmp_path: Path) -> None:
    lines: list[str] = []
    result = sw.design_home(programme=TINY, seed=2, out=tmp_path, said=lines.append, **FAST)
    assert result.plan_report.valid and set(result.rooms) >= {"hall", "bed", "store", "wc"}
    home = sw.Home.load(tmp_path / "home.json")
    assert home == result.home and all(room.scene is not None for room in home.rooms)
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["valid"] == result.report.valid and metrics["design"]["style"] == result.style
    assert metrics["plan"]["valid"] and set(metrics["design"]["grades"]) == set(result.rooms)
    assert (tmp_path / "plan.svg").read_text().startswith("<")
    assert sorted(path.parent.name for path in tmp_path.glob("rooms/*/scene.json")) == sorted(result.rooms)
    assert any("plan 1" in line for line in lines)

    before = {path: path.stat().st_mtime_ns for path in tmp_path.glob("rooms/*/scene.json")}
    (tmp_path / "rooms/hall/scene.json").unlink()  # as if it had been killed before it came to the hall
    again = sw.design_home(programme=TINY, seed=2, out=tmp_path, **FAST)
    assert again.home == result.home
    after = {path: path.stat().st_mtime_ns for path in tmp_path.glob("rooms/*/scene.json")}
    anew = [name for line in lines if line.startswith("not all can be walked to in ") for name in line[28:].split(", ")]
    remade = {path.parent.name for path in before if after[path] != before[path]}
    assert "hall" in remade and remade <= {"hall", *(name.partition(":")[0] for name in anew)}

    with pytest.raises(sw.InputError, match="another place"):
        sw.design_home(programme=TINY, seed=3, out=tmp_path, **FAST)


def _furnished(home: sw.Home, failing: dict[str, int]) -> FurnishedHome:
    fine = SimpleNamespace(valid=True)
    rooms = {
        r.id: FurnishedRoom(r.id, "a room", report=fine, unmet=("no place",) * failing.get(r.id, 0)) for r in home.rooms
    }
    return FurnishedHome(home, rooms)


def _home() -> sw.Home:
    flat = sw.Home.example("flat")
    rooms = tuple(r.model_copy(update={"id": "store"}) if r.id == "bath" else r for r in flat.rooms)
    doors = tuple(d for d in flat.doors if "bath" not in (d.room, d.to))
    windows = tuple(w for w in flat.windows if w.room != "bath")
    return flat.with_changes(rooms=rooms, doors=doors, windows=windows)


def test_a_programme_without_a_plan_says_what_stands_against_it() -> None:
    bare = Programme.from_graph({"hall": ("entrance_hall", 5), "bed": ("guest_room", 14)}, [("hall", "bed")])
    with pytest.raises(sw.InputError, match="no plan keeps all rules: .*toilet"):
        sw.design_home(programme=bare, **FAST)


def test_demands_go_back_to_the_plan_at_most_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []

    def planned(programme: Programme, envelope: object, **options: object) -> object:
        asked.append(programme.room("store").area[0])
        return SimpleNamespace(home=_home(), valid=1, distinct=1, lacking={}, report=SimpleNamespace(soft=()))

    monkeypatch.setattr(design, "plan_home", planned)
    monkeypatch.setattr(design, "furnish_home", lambda home, *_, **__: _furnished(home, {"store": 4 - len(asked)}))
    result = sw.design_home(programme=TINY, **FAST)
    assert len(asked) == 1 + design.AGAIN and asked == sorted(asked) and asked[0] < asked[1] < asked[2]
    assert sum("had no place" in line for line in result.log) == design.AGAIN
    assert any(text.startswith("store: ") for text in result.unmet)
    asked.clear()
    monkeypatch.setattr(design, "furnish_home", lambda home, *_, **__: _furnished(home, {"store": 1}))
    stuck = sw.design_home(programme=TINY, **FAST)
    assert len(asked) == 2 and "more floor does not help store" in stuck.log
    asked.clear()
    monkeypatch.setattr(design, "furnish_home", lambda home, *_, **__: _furnished(home, {}))
    sw.design_home(programme=TINY, **FAST)
    assert len(asked) == 1


def test_only_what_is_in_the_way_is_furnished_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """A room is made once for a job, whatever becomes of the others; and all rooms have the library that is given."""
    made, library = list[RoomJob](), Library()

    def room(job: RoomJob, seconds: float | None = None, stop: object = None) -> FurnishedRoom:
        made.append(job)
        scene = sw.Scene(id=job.room_id, prompt=job.request, room=job.shell)
        return FurnishedRoom(job.room_id, job.request, scene, report=sw.check(scene))

    monkeypatch.setattr(side_by_side, "furnish_room", room)
    monkeypatch.setattr(design, "_in_the_way", lambda home, report: {"hall"})
    result = sw.design_home(programme=TINY, library=library, **FAST)
    counts = Counter(job.room_id for job in made)
    assert counts.pop("hall") == 1 + design.WALKS and set(counts.values()) == {1} and set(counts) < set(result.rooms)
    assert len({job.seed for job in made if job.room_id == "hall"}) == 1 + design.WALKS
    assert all(job.options["library"] is library for job in made)


@pytest.mark.slow
def test_a_home_is_the_same_on_any_number_of_processes() -> None:
    one, two = (sw.design_home(programme=TINY, seed=2, **{**FAST, "workers": workers}) for workers in (1, 2))
    assert one.home.dumps() == two.home.dumps() and one.unmet == two.unmet


def test_a_room_that_was_cut_off_is_made_again(monkeypatch: pytest.MonkeyPatch) -> None:
    made = list[str]()

    def room(job: RoomJob, seconds: float | None = None, stop: object = None) -> FurnishedRoom:
        made.append(job.room_id)
        cut = "time was up" if job.room_id == "bed" and made.count("bed") == 1 else ""
        scene = sw.Scene(id=job.room_id, prompt=job.request, room=job.shell)
        return FurnishedRoom(job.room_id, job.request, scene, report=sw.check(scene), cut_off=cut)

    monkeypatch.setattr(side_by_side, "furnish_room", room)
    monkeypatch.setattr(design, "_in_the_way", lambda home, report: {"hall"})
    sw.design_home(programme=TINY, **FAST)
    assert Counter(made)["bed"] == 2 and Counter(made)["store"] == 1


def test_rooms_are_kept_by_what_decides_them(tmp_path: Path) -> None:
    folder = HomeFolder(tmp_path)
    _, jobs = room_jobs(sw.Home.example("flat"), seed=1, steps=1, candidates=8)
    job = next(job for job in jobs if job.room_id == "hall")
    assert folder.kept(job) is None
    scene = sw.Scene(id="hallway", prompt=job.request, room=job.shell)
    (tmp_path / "rooms").mkdir()
    folder.keep(job, FurnishedRoom("hall", job.request, scene, unmet=("a rack",), cut_off="time was up"))
    assert folder.kept(job) is None  # what was cut off is made again
    folder.keep(job, FurnishedRoom("hall", job.request, scene, unmet=("a rack",)))
    kept = folder.kept(job)
    assert kept is not None and kept.scene == scene and kept.unmet == ("a rack",)
    other = type(job)(job.room_id, job.request, job.shell, job.palette, job.seed + 1, job.options)
    assert folder.kept(other) is None
    (tmp_path / "rooms/hall/room.json").write_text("{")
    assert folder.kept(job) is None


def test_names_of_folders_stay_inside() -> None:
    assert room_folder("bedroom-2") == "bedroom-2"
    for name in ("../up", "a/b", "a b", "ä"):
        assert "/" not in room_folder(name) and ".." not in room_folder(name) and room_folder(name) != name


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"prompt": ""}, "prompt"),
        ({"prompt": "a flat", "time_limit": -1.0}, "time_limit"),
        ({"prompt": "a flat", "time_limit": "soon"}, "time_limit"),
        ({"prompt": "a flat", "pictures": "some"}, "pictures"),
        ({"prompt": "a flat", "export": "scenestate"}, "export"),
        ({"prompt": "a flat", "profile": "royal"}, "profile"),
        ({"prompt": "a flat", "workers": 0}, "workers"),
    ],
)
def test_bad_arguments_are_named(options: dict, named: str) -> None:
    with pytest.raises(sw.InputError, match=named):
        sw.design_home(**options)


def test_a_folder_of_a_room_is_no_place_for_a_home(tmp_path: Path) -> None:
    (tmp_path / "state.json").write_text("{}")
    with pytest.raises(sw.InputError, match="of a room"):
        sw.design_home("a two-bedroom flat", out=tmp_path, **FAST)


def test_what_is_a_home() -> None:
    assert asks_for_home("a two-bedroom flat with a big kitchen")
    assert not asks_for_home("a bedroom with a desk by the window")


def test_what_was_asked_for_is_measured_in_the_finished_home() -> None:
    asked = Asked.of("a flat with three bedrooms and two bathrooms", None, None, None)
    said = unmet_of(asked.demands(sw.Home.example("flat")))
    assert any("bath" in line and ("not met" in line or "partly" in line) for line in said)
    two = Asked.of("a flat with two bedrooms", None, None, None)
    assert unmet_of(two.demands(sw.Home.example("flat"))) == []
