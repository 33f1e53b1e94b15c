"""Time limits of commands: what is needed is done or refused in one line, what is not is left out, and codes tell."""

from __future__ import annotations

import json
import signal
import time

import pytest

from sceneweaver.cli.clock import LEAST, PATIENT, OutOfTime, clock, keep_for
from sceneweaver.runtime.deadline import TimeUp, checkpoint
from sceneweaver.scene import Scene
from tests.cli import engine
from tests.cli.test_refine import listing


def endless() -> None:
    """Work that does not end by itself while the test may run."""
    end = time.monotonic() + 60.0
    while time.monotonic() < end:
        time.sleep(0.001)
        checkpoint()
    pytest.fail("nothing ended it")


def late(*_: object, **__: object) -> None:
    """Work for which time is up."""
    raise TimeUp


def test_what_is_needed_is_refused_in_one_line_when_there_was_no_time():
    with (
        clock(0.001, time.monotonic()) as until,
        pytest.raises(OutOfTime, match="^check: 0.001 s were not enough; give"),
    ):
        until.needed("check", endless)
    assert OutOfTime.exit_code == 5


def test_what_is_needed_gets_a_little_time_however_late_it_is():
    with clock(1.0, time.monotonic() - 100.0) as until:
        assert until.needed("check", lambda: checkpoint() or "done") == "done"
        assert until.for_search(5.0) == LEAST < PATIENT * LEAST


def test_extras_are_left_out_and_told(capsys):
    with clock(3.0, time.monotonic() - 100.0) as until:
        assert until.extra("a", checkpoint) and until.code(0) == 0
        assert not until.extra("b", endless) and until.code(3) == 5
        assert not until.extra("c", lambda: pytest.fail("begun"))
    until.tell()
    assert capsys.readouterr().out == "  left out (3 s are over): b, c\n"


@pytest.fixture
def heard():
    """Signals as a program in the foreground has them; one in the background may be told to ignore Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize(("number", "error"), [(signal.SIGINT, KeyboardInterrupt), (signal.SIGTERM, SystemExit)])
def test_a_signal_with_nothing_to_write_ends_the_process_as_ever(number, error, heard):
    with clock(None, time.monotonic()) as until:
        until.deadline.stop.allowance = 0.01
        with pytest.raises(error):
            until.needed("refine", lambda: signal.raise_signal(number) or endless())


def test_a_search_leaves_time_for_the_rest():
    with clock(100.0, time.monotonic()) as until:
        assert 80.0 < until.for_search(2.0) <= 98.0 and 50.0 < until.for_search(80.0) <= 60.0
    with clock(None, time.monotonic()) as until:
        assert until.for_search(2.0) is None
    assert keep_for(Scene.example("bedroom")) < 1.0


@pytest.mark.parametrize("command", ["refine", "repair", "check", "render", "export"])
def test_every_command_that_takes_long_has_a_time_limit(run, command):
    assert "--time-limit" in run(command, "--help").out


def test_a_scene_that_was_not_judged_in_time_is_written_and_that_is_said(run, bedroom, tmp_path, monkeypatch):
    engine.use(monkeypatch, engine.keeps)
    monkeypatch.setattr("sceneweaver.verify.check", late)
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--time-limit", 50)
    assert (
        ended.code == 5
        and "not judged  bedroom" in ended.out
        and "left out (50 s are over): the judgement" in ended.out
    )
    assert "scene.json" in listing(tmp_path / "out") and "metrics.json" not in listing(tmp_path / "out")
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--time-limit", 50, "--json")
    assert ended.code == ended.json["exit_code"] == 5 and ended.json["metrics"] is None


@pytest.mark.parametrize("command", ["refine", "repair"])
def test_a_picture_that_was_not_drawn_in_time_is_named(run, bedroom, tmp_path, monkeypatch, command):
    engine.use(monkeypatch, engine.keeps)
    monkeypatch.setattr("sceneweaver.render.save_top", late)
    ended = run(command, bedroom, "-o", tmp_path / "out", "--time-limit", 50, "--json")
    assert ended.code == 5 and ended.json["left_out"] == ["views/top_annotated.png"]
    assert set(ended.json["files"]) == {"scene", "metrics"} and ended.json["metrics"]["valid"] is True


def test_check_and_render_say_that_time_was_up(run, bedroom, tmp_path, monkeypatch):
    monkeypatch.setattr("sceneweaver.verify.check", late)
    monkeypatch.setattr("sceneweaver.render.save_top", late)
    for command in (["check", bedroom], ["render", bedroom, "-o", tmp_path / "a.png"]):
        ended = run(*command, "--time-limit", 2)
        assert ended.code == 5 and ended.err.endswith(
            f"{command[0]}: 2 s were not enough; give more with --time-limit\n"
        )


def test_formats_that_there_is_no_time_for_are_named(run, bedroom, tmp_path, monkeypatch):
    import sceneweaver.export as export

    real = export.export_scene
    monkeypatch.setattr(export, "export_scene", lambda *a, **k: late() if a[2] == ["mjcf"] else real(*a, **k))
    ended = run("export", bedroom, "-o", tmp_path / "out", "--to", "scenestate,mjcf", "--time-limit", 60, "--json")
    assert ended.code == 5 and ended.json["left_out"] == ["mjcf"] and set(ended.json["files"]) == {"scenestate"}


def test_a_file_with_too_much_in_it_is_refused_by_all_in_one_line(run, bedroom, tmp_path):
    data = json.loads(bedroom.read_text())
    data["objects"] = [{**data["objects"][0], "id": f"o{k}"} for k in range(2001)]
    data["relations"] = []
    bedroom.write_text(json.dumps(data))
    out = ["-o", tmp_path / "out"]
    commands = (["refine", *out], ["repair", *out], ["check"], ["render", "-o", tmp_path / "a.png"], ["export", *out])
    said = {run(name, bedroom, *more).err for name, *more in commands}
    assert said == {f"sceneweaver: {bedroom}: objects has 2001 entries; give at most 2000\n"}
