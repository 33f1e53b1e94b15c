"""What a finished design leaves in its folder: everything, whole or not at all."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest
from PIL import Image

from sceneweaver import render
from sceneweaver.agent.deliver import deliver
from sceneweaver.agent.memory import Call, Step
from sceneweaver.agent.request_file import RequestFile
from sceneweaver.agent.result import Result
from sceneweaver.assets import Library, make
from sceneweaver.critic import CRITERIA, Alignment, ItemOutcome, Review
from sceneweaver.export import FORMATS, formats_named
from sceneweaver.language import SceneGraph
from sceneweaver.runtime.deadline import Deadline, Stop, checkpoint
from sceneweaver.scene import InputError, Pose, Room, Scene, Support
from sceneweaver.verify import check

EYE_LEVEL = {"eye-door", "eye-corner", "eye-corner2"}
ALWAYS = {"scene.json", "metrics.json", "request.json"}
PICTURES = {"top.png", "top_annotated.png", "corner.png", *(f"{view}.png" for view in EYE_LEVEL)}


class QuickEyeLevel:
    """Pictures at eye level that cost nothing; ``seconds`` a picture of 640 x 480 pixels by ``clock``."""

    seconds, clock = 0.0, [0.0]

    def __init__(self, scene: Scene, load: object, device: str) -> None:
        self.cameras = dict.fromkeys(sorted(EYE_LEVEL))
        self.hero = "eye-corner"

    def draw(self, view: str, width: int, height: int, quality: render.Quality) -> Image.Image:
        slower = 3.4 if quality == render.Quality.normal() else 1.0
        self.clock[0] += slower * self.seconds * width * height / (640 * 480)
        return Image.new("RGB", (width, height), (quality.rays, 0, 0))


def at_once(scene: Scene, load: object, views: tuple[str, ...], *_: object, **__: object) -> dict[str, Image.Image]:
    """Pictures from above that cost nothing."""
    return {view: Image.new("RGB", (4, 4)) for view in views}


@pytest.fixture(autouse=True)
def eye_level(monkeypatch) -> type[QuickEyeLevel]:
    """Light takes long: none is cast in these tests."""
    monkeypatch.setattr("sceneweaver.render.EyeLevel", QuickEyeLevel)
    monkeypatch.setattr(QuickEyeLevel, "clock", [0.0])
    monkeypatch.setattr(QuickEyeLevel, "seconds", 0.0)
    return QuickEyeLevel


@pytest.fixture
def ours(monkeypatch) -> None:
    """What stands here for code of ours counts as such where time is up."""
    monkeypatch.setitem(globals(), "__name__", "sceneweaver")


@pytest.fixture(scope="module")
def result() -> Result:
    table = make("coffee_table", seed=1).object("coffee_table-0", pose=Pose.from_yaw(1.5, 1.5, 0.0, 0.3))
    top = table.surfaces[0]
    on = Support(object=table.id, surface=top.name)
    book = make("book", seed=1).object("book-0", pose=Pose.from_yaw(1.5, 1.5, top.z, 0.3), support=on)
    room = Room(type="lounge", outline=((0, 0), (3, 0), (3, 3), (0, 3)))
    scene = Scene(id="lounge", prompt="a table", room=room, objects=(table, book))
    report = check(scene)
    assert report.valid
    return Result(
        scene=scene,
        report=report,
        review=Review(
            grades=dict.fromkeys(CRITERIA, 7.0),
            alignment=Alignment(items=(ItemOutcome(item="lamp", kind="entity", status="unmet", reason="no lamp"),)),
        ),
        brief=SceneGraph(text="a table with a book on it"),
        steps=(
            Step(number=1, call=Call(tool="init_prior", reason="there is no scene yet"), accepted=True),
            Step(number=2, call=Call(tool="add_crowd", instruction="fill the shelf"), accepted=False, note="full"),
        ),
        notes=("a note of the agent",),
        unmet=("a shelf",),
        seconds=2.0,
        finished="2 steps",
    )


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_scene_and_metrics_alone(result, tmp_path):
    done = deliver(result, tmp_path, Library(), "cpu", "none", ())
    assert files(tmp_path) == {"scene.json", "metrics.json", "request.json"}
    assert Scene.load(tmp_path / "scene.json") == result.scene
    metrics = json.loads((tmp_path / "metrics.json").read_text("utf-8"))
    assert metrics == json.loads(done.report.to_json())
    assert metrics["seconds"]["total"] >= metrics["seconds"]["files"] >= 0
    assert done.seconds >= 2.0 and done.scene is result.scene
    kept = RequestFile.load(tmp_path / "request.json")
    assert kept.graph == result.brief and kept.outcomes == result.review.alignment.items
    assert kept.summary == {
        "total": 1,
        "met": 0,
        "partly": 0,
        "substituted": 0,
        "assumed": 0,
        "not_understood": 0,
        "unmet": 1,
    }


def test_a_damaged_request_file_is_one_line(tmp_path):
    for damaged, named in ((b'{"schema": "sceneweaver.request/2"}', "schema"), (b'{"schema": "\xff"}', "UTF-8")):
        (tmp_path / "request.json").write_bytes(damaged)
        with pytest.raises(InputError, match=f"request.json: .*{named}"):
            RequestFile.load(tmp_path / "request.json")


def test_pictures_report_and_model(result, tmp_path, monkeypatch):
    draw = render.draw_rooms
    small = {"width": 240, "height": 180}  # rays, not files, are what takes long
    monkeypatch.setattr(render, "draw_rooms", lambda *given, device: draw(*given[:3], **small, device=device))
    kept = tmp_path / "steps" / "01"
    kept.mkdir(parents=True)
    result.scene.save(kept / "scene.json")
    deliver(result, tmp_path, Library(), "cpu", "full", ("glb",))
    expected = {"scene.json", "metrics.json", "request.json", "scene.glb", "report.html", "steps/01/scene.json"}
    assert files(tmp_path) == expected | {f"views/{name}" for name in PICTURES}
    for name in PICTURES:
        assert (tmp_path / "views" / name).read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "scene.glb").read_bytes().startswith(b"glTF")
    page = (tmp_path / "report.html").read_text("utf-8")
    for said in ("a table with a book on it", "a note of the agent", "a shelf", "init_prior", "fill the shelf", "full"):
        assert said in page
    # Readable for others, as a file that was opened and written would be.
    assert all((tmp_path / name).stat().st_mode & 0o044 == 0o044 for name in ("report.html", "views/top.png"))


def test_what_was_there_stays_when_a_picture_or_the_report_fails(result, tmp_path, monkeypatch):
    (tmp_path / "views").mkdir()
    for name in ("views/top.png", "report.html"):
        (tmp_path / name).write_bytes(b"old")

    class Torn:
        """A picture that breaks off while it is written."""

        def save(self, path: Path, *_: object, **__: object) -> None:
            path.write_bytes(b"half")
            raise OSError("disk full")

    monkeypatch.setattr("sceneweaver.render.draw_rooms", lambda *_, **__: {"top": Torn()})
    with pytest.raises(InputError, match="top.png: cannot be written .disk full."):
        deliver(result, tmp_path, Library(), "cpu", "full", ())
    assert (tmp_path / "views/top.png").read_bytes() == b"old"
    assert files(tmp_path) == {
        "scene.json",
        "metrics.json",
        "request.json",
        "views/top.png",
        "report.html",
    }  # nothing half written

    def broken(path: Path, data: object) -> None:
        path.write_text("<html>")
        raise InputError("no page")

    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    monkeypatch.setattr("sceneweaver.report.write_report", broken)
    with pytest.raises(InputError, match="no page"):
        deliver(result, tmp_path, Library(), "cpu", "full", ())
    assert (tmp_path / "report.html").read_bytes() == b"old"
    assert files(tmp_path) == {*ALWAYS, "report.html", *(f"views/{name}" for name in PICTURES)}


def test_when_time_is_up_the_scene_and_its_metrics_are_written_and_the_rest_is_noted(result, tmp_path):
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb", "usd"), Deadline(0.0))
    assert files(tmp_path) == ALWAYS == set(done.files)
    assert done.undone == ("glb", "usd", "pictures", "report") and not done.broken
    missing = ("scene.glb", "scene.usdc", *(f"views/{name}" for name in PICTURES), "report.html")
    assert set(done.left_out) == set(missing) and len(done.left_out) == len(missing)
    assert done.notes[-1] == f"time was up before these were written: {', '.join(done.left_out)}"
    assert json.loads((tmp_path / "metrics.json").read_text("utf-8"))["left_out"] == list(done.left_out)


def test_all_that_was_written_is_named_and_nothing_else(result, tmp_path, monkeypatch):
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    formats = formats_named("all")
    done = deliver(result, tmp_path, Library(), "cpu", "full", formats)
    assert {FORMATS[name].file for name in formats} < set(done.files) <= files(tmp_path) and not done.left_out
    assert done.files[0] == "report.html" and len(set(done.files)) == len(done.files)
    beside = {name for name in files(tmp_path) - set(done.files) if "/" not in name}
    assert beside == {"scene-sleep.xml"}  # which belongs to the MJCF, as meshes and textures do
    assert "left_out" not in json.loads((tmp_path / "metrics.json").read_text("utf-8"))


def test_what_a_signal_left_out_says_so(result, tmp_path):
    stop = Stop(allowance=0.0)
    stop.request("SIGTERM")
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb",), Deadline(stop=stop))
    assert files(tmp_path) == ALWAYS and done.notes[-1].startswith("SIGTERM came before these were written: scene.glb")


@pytest.mark.usefixtures("ours")
@pytest.mark.parametrize("asked", [True, False])
def test_pictures_go_before_formats_that_nobody_asked_for(result, tmp_path, monkeypatch, asked):
    def endless(*_: object) -> None:
        while True:
            time.sleep(0.01)
            checkpoint()

    order: list[str] = []
    monkeypatch.setattr("sceneweaver.export.export_scene", lambda *given: order.append("file") or endless())
    monkeypatch.setattr("sceneweaver.render.draw_rooms", lambda *a, **k: order.append("above") or at_once(*a, **k))
    draw = QuickEyeLevel.draw
    monkeypatch.setattr(QuickEyeLevel, "draw", lambda *given: order.append("eye level") or draw(*given))
    end = time.monotonic() + 3.0
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb",), Deadline(end), asked=asked)
    assert order[:2] == ["above", "above"] and order.index("file") == (2 if asked else 5)
    assert done.undone == ("glb",) and done.left_out == ("scene.glb",)
    assert {f"views/{name}" for name in PICTURES} <= files(tmp_path)  # as drafts


@pytest.mark.usefixtures("ours")
def test_a_report_that_takes_too_long_is_left_out(result, tmp_path, monkeypatch):
    def endless(*_: object) -> None:
        while True:
            time.sleep(0.01)
            checkpoint()

    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    monkeypatch.setattr("sceneweaver.report.write_report", endless)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(time.monotonic() + 1.5))
    assert done.left_out == ("report.html",) and done.undone == ("report",) and "report.html" not in done.files
    assert json.loads((tmp_path / "metrics.json").read_text("utf-8"))["left_out"] == ["report.html"]


@pytest.mark.usefixtures("ours")
def test_a_file_that_takes_too_long_is_left_out_and_the_pictures_are_there(result, tmp_path, monkeypatch):
    def endless(scene: Scene, folder: Path, names: tuple[str, ...], load: object) -> None:
        if names == ("usd",):
            while True:
                time.sleep(0.01)
                checkpoint()
        (folder / "scene.glb").touch()

    monkeypatch.setattr("sceneweaver.export.export_scene", endless)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    end = time.monotonic() + 2.5
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb", "usd", "mjcf"), Deadline(end))
    assert time.monotonic() < end + 1.0
    assert files(tmp_path) == {*ALWAYS, "scene.glb", "report.html", *(f"views/{name}" for name in PICTURES)}
    assert done.undone == ("usd", "mjcf") and not done.satisfied
    assert done.notes[-1] == "time was up before these were written: scene.usdc, scene.xml"


@pytest.mark.usefixtures("ours")
def test_pictures_that_take_too_long_are_left_out(result, tmp_path, monkeypatch):
    def endless(*_: object, **__: object) -> None:
        while True:
            time.sleep(0.01)
            checkpoint()

    monkeypatch.setattr("sceneweaver.render.draw_rooms", endless)
    monkeypatch.setattr(QuickEyeLevel, "draw", endless)
    end = time.monotonic() + 1.0
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(end))
    assert time.monotonic() < end + 1.0 and done.undone == ("pictures",)
    assert files(tmp_path) == {"scene.json", "metrics.json", "request.json", "report.html"}


@pytest.mark.usefixtures("ours")
@pytest.mark.parametrize("call", ["sceneweaver.render.draw_rooms", "sceneweaver.export.export_scene"])
def test_what_never_comes_back_is_given_up_and_the_report_is_written(result, tmp_path, monkeypatch, call):
    def hanging(*_: object, **__: object) -> None:
        while True:  # no checkpoint
            time.sleep(0.01)

    monkeypatch.setattr(call, hanging)
    end = time.monotonic() + 2.0
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb",), Deadline(end))
    assert time.monotonic() < end + 0.5 and done.undone
    assert (tmp_path / "report.html").exists() and "report" not in done.undone


def test_the_pictures_that_there_was_time_for_are_kept_and_the_report_shows_them(result, tmp_path, monkeypatch):
    def drawn(scene: Scene, load: object, views: tuple[str, ...], *_: object, **__: object) -> dict[str, Image.Image]:
        while "corner" in views:
            time.sleep(0.01)
            checkpoint()
        return {view: Image.new("RGB", (4, 4)) for view in views}

    monkeypatch.setattr("sceneweaver.render.draw_rooms", drawn)
    end = time.monotonic() + 2.0
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("usd",), Deadline(end))
    assert time.monotonic() < end + 1.0 and done.undone == ("usd", "pictures")
    assert {"report.html", "views/top.png", "views/top_annotated.png"} <= files(tmp_path)
    assert "views/corner.png" not in files(tmp_path)


@pytest.mark.filterwarnings("ignore:.*unexpected:RuntimeWarning")
@pytest.mark.parametrize("part", ["sceneweaver.export.export_scene", "sceneweaver.render.draw_rooms"])
def test_what_breaks_down_costs_only_itself(result, tmp_path, monkeypatch, part):
    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("no size")

    monkeypatch.setattr("sceneweaver.export.export_scene", lambda *_: None)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    monkeypatch.setattr(part, broken)
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb",))
    assert {"scene.json", "metrics.json", "report.html"} <= files(tmp_path)
    name = "glb" if "export" in part else "pictures"
    assert len(done.undone) == 1 and not done.satisfied and done.undone[0] in done.notes
    assert done.undone[0].startswith(f"{name}: unexpected ZeroDivisionError: no size (test_deliver.py:")


@pytest.mark.parametrize(("left", "size"), [(1.5, (320, 240)), (59.0, (1280, 960))])
def test_pictures_are_as_large_as_there_is_time_for(result, tmp_path, monkeypatch, left, size):
    """Each size takes a tenth of a second for each 320 x 240 pixels, by a clock of our own."""
    clock = [100.0]
    monkeypatch.setattr("sceneweaver.agent.deliver.time.monotonic", lambda: clock[0])

    def drawn(scene, load, views, width=1280, height=960, device=""):
        clock[0] += 0.1 * width * height / (320 * 240) * len(views)
        return {view: Image.new("RGB", (width, height)) for view in views}

    monkeypatch.setattr("sceneweaver.render.draw_rooms", drawn)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(100.0 + left))
    with Image.open(tmp_path / "views" / "top.png") as picture:
        assert picture.size == size
    short = "time was short, so the pictures have 320 x 240 pixels"
    assert (short in done.notes) == (size == (320, 240)) and clock[0] <= 100.0 + left


def test_a_first_picture_that_waits_for_its_kernels_is_not_dropped(result, tmp_path, monkeypatch):
    """On a first start kernels are compiled for the first picture, by a clock of our own."""
    clock, compiled = [100.0], []
    monkeypatch.setattr("sceneweaver.agent.deliver.time.monotonic", lambda: clock[0])

    def drawn(scene, load, views, *_, **__):
        clock[0] += 0.2 if compiled else 40.0
        compiled.append(1)
        checkpoint()
        return at_once(scene, load, views)

    monkeypatch.setattr("sceneweaver.render.draw_rooms", drawn)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(159.0))
    assert {f"views/{name}" for name in PICTURES} <= set(done.files) and not done.undone


@pytest.mark.parametrize(
    ("left", "seconds", "size", "rays"),
    [
        (100.0, 1.0, (960, 720), render.Quality.normal().rays),
        (20.0, 1.0, (960, 720), render.Quality.draft().rays),
        (14.0, 2.0, (640, 480), render.Quality.draft().rays),
        (4.0, 2.0, (320, 240), render.Quality.draft().rays),
    ],
)
def test_pictures_at_eye_level_are_as_good_as_there_is_time_for(
    result, tmp_path, monkeypatch, eye_level, left, seconds, size, rays
):
    clock = eye_level.clock
    monkeypatch.setattr("sceneweaver.agent.deliver.time.monotonic", lambda: clock[0])
    monkeypatch.setattr(eye_level, "seconds", seconds)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(left))
    for view in EYE_LEVEL:
        with Image.open(tmp_path / "views" / f"{view}.png") as picture:
            assert picture.size == size and picture.getpixel((0, 0)) == (rays, 0, 0)
    assert not done.undone and clock[0] <= left


@pytest.mark.usefixtures("ours")
def test_without_time_for_all_pictures_at_eye_level_the_others_are_there(result, tmp_path, monkeypatch, eye_level):
    def slow(self, view: str, *_: object) -> Image.Image:
        while view == "eye-door":
            time.sleep(0.01)
            checkpoint()
        return Image.new("RGB", (4, 4))

    monkeypatch.setattr(eye_level, "draw", slow)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    end = time.monotonic() + 2.0
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(end))
    assert time.monotonic() < end + 1.0 and done.undone == ("pictures",) and done.left_out == ("views/eye-door.png",)
    assert {"views/corner.png", "views/eye-corner.png", "report.html"} <= files(tmp_path)
    assert "views/eye-door.png" not in files(tmp_path)


def test_what_breaks_at_eye_level_is_told(result, tmp_path, monkeypatch, eye_level):
    def broken(*_: object) -> None:
        raise ZeroDivisionError("no light")

    monkeypatch.setattr(eye_level, "draw", broken)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    with pytest.warns(RuntimeWarning, match="unexpected"):
        done = deliver(result, tmp_path, Library(), "cpu", "full", ())
    assert done.undone[0].startswith("pictures at eye level: unexpected ZeroDivisionError")
    assert "views/corner.png" in files(tmp_path)


@pytest.fixture
def order(monkeypatch) -> list[str]:
    """What is made, in order."""
    made: list[str] = []
    draw = QuickEyeLevel.draw

    def drawn(self, view: str, *given: object) -> Image.Image:
        made.append(view)
        return draw(self, view, *given)

    monkeypatch.setattr(QuickEyeLevel, "draw", drawn)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", lambda *a, **k: made.append("above") or at_once(*a, **k))
    monkeypatch.setattr("sceneweaver.report.write_report", lambda path, data: made.append("report") or path.touch())
    monkeypatch.setattr("sceneweaver.export.export_scene", lambda *given: made.append("file"))
    return made


def test_with_plenty_of_time_one_can_look_before_the_rest_is_made(result, tmp_path, order):
    told: list[tuple[str, ...]] = []

    def ready(first: Result, names: tuple[str, ...]) -> None:
        assert first.scene == result.scene and all((tmp_path / name).exists() for name in names)
        told.append(tuple(names))
        order.append("ready")

    until = Deadline(time.monotonic() + 600.0)
    done = deliver(result, tmp_path, Library(), "cpu", "full", ("glb",), until, ready=ready)
    assert order[:6] == ["ready", "eye-corner", "report", "ready", "above", "above"] and order[-1] == "report"
    assert told == [("scene.json", "metrics.json", "request.json"), ("report.html", "views/eye-corner.png")]
    assert {f"views/{name}" for name in PICTURES} <= set(done.files) and not done.undone
    assert order.count("eye-corner") == 2 == order.count("eye-door")  # a draft, and as good as there is time for


def test_only_the_hero_is_drawn_at_eye_level_where_no_more_is_asked_for(result, tmp_path, order):
    for until in (Deadline(), Deadline(time.monotonic() + 600.0)):
        done = deliver(result, tmp_path, Library(), "cpu", "hero", (), until)
        assert {name for name in done.files if "eye" in name} == {"views/eye-corner.png"} and not done.left_out
        assert {"views/top.png", "views/corner.png", "report.html"} <= set(done.files)
    assert not {"eye-door", "eye-corner2"} & set(order)


def test_a_hero_without_time_is_left_out(result, tmp_path):
    done = deliver(result, tmp_path, Library(), "cpu", "hero", (), Deadline(0.0))
    assert [name for name in done.left_out if "eye" in name] == ["views/eye-door.png"]


def test_a_report_that_there_is_no_time_to_write_again_stays(result, tmp_path, monkeypatch, order):
    clock = [0.0]
    monkeypatch.setattr("sceneweaver.agent.deliver.time.monotonic", lambda: clock[0])

    def slow(path: Path, data: object) -> None:
        order.append("report")
        if order.count("report") > 1:
            clock[0] = 1000.0
            checkpoint()
        path.touch()

    monkeypatch.setattr("sceneweaver.report.write_report", slow)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(600.0))
    assert done.files[0] == "report.html" and not done.left_out
    assert done.notes[-1] == "time was short, so the report shows the first picture alone"


@pytest.mark.filterwarnings("ignore:.*unexpected:RuntimeWarning")
def test_what_broke_down_is_not_tried_again(result, tmp_path, monkeypatch, eye_level):
    def broken(*_: object) -> None:
        raise ZeroDivisionError("no light")

    monkeypatch.setattr(eye_level, "draw", broken)
    monkeypatch.setattr("sceneweaver.render.draw_rooms", at_once)
    done = deliver(result, tmp_path, Library(), "cpu", "full", (), Deadline(time.monotonic() + 600.0))
    assert len(done.broken) == 1 and done.broken[0].startswith("pictures at eye level")
