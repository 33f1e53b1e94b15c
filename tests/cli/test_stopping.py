"""Signals and time limits, sent to real processes: there is always a scene, its metrics say so, and nothing is late."""

from __future__ import annotations

import json
import signal
import subprocess
import time
from pathlib import Path

import pytest

from sceneweaver.runtime.deadline import stoppable
from sceneweaver.scene import Scene
from sceneweaver.verify import check
from tests.cli.test_program import MODULE

BEDROOM = "a bedroom with a desk by the window"
HEAP = "ten beds in front of the bookcase, forty wardrobes and ten desks in a tiny garage"
CONTENT = {"scene.json", "metrics.json", "state.json", "report.html", "views", "scene.glb", "scene.usdc", "scene.xml"}


def begin(out: Path, prompt: str = BEDROOM, **options: str) -> subprocess.Popen[str]:
    given = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
    command = [*MODULE, "design", prompt, f"--out={out}", "--device=cpu", "--json", *given]
    return subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # jobs in the background begin without it
    )


def wait_for(path: Path, process: subprocess.Popen[str]) -> None:
    until = time.monotonic() + 60
    while not path.exists() and process.poll() is None and time.monotonic() < until:
        time.sleep(0.01)
    assert path.exists(), process.communicate(timeout=10)


def ended(process: subprocess.Popen[str], seconds: float) -> tuple[int, dict]:
    """Exit code and what was said, after at most so many seconds."""
    try:
        out, err = process.communicate(timeout=seconds)
    finally:
        process.kill()
    assert not err, err
    return process.returncode, json.loads(out)


def written(out: Path) -> tuple[Scene, dict]:
    """The scene of a folder, which has no other faults than what was given up, and its metrics."""
    scene, metrics = Scene.load(out / "scene.json"), json.loads((out / "metrics.json").read_text("utf-8"))
    assert {v.kind for v in check(scene).violations if v.hard} <= {"dropped"}
    assert metrics["placed"] == len(scene.objects)
    assert not list(out.rglob(".sceneweaver-*"))
    return scene, metrics


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("after", ["scene.json", "steps/01/scene.json"])
def test_a_signal_ends_it_with_what_there_is(tmp_path, number, after):
    process = begin(tmp_path, time_limit="300")
    wait_for(tmp_path / after, process)
    process.send_signal(number)
    code, said = ended(process, 20)
    name = signal.Signals(number).name
    assert code == said["exit_code"] == 3 and said["finished"] == name and said["undone"]
    scene, metrics = written(tmp_path)
    assert metrics["cut_off"] == name and (after == "scene.json" or scene.objects)
    assert (tmp_path / "report.html").stat().st_size and len(list((tmp_path / "views").glob("*.png"))) == 3
    assert f"the work was cut off: {name}" in (tmp_path / "report.html").read_text("utf-8")
    code, said = ended(begin(tmp_path, time_limit="300"), 300)  # and it goes on
    assert code == 0 and said["finished"] not in ("", name) and written(tmp_path)[1]["cut_off"] is None


def test_a_killed_one_leaves_the_last_scene_and_says_that_it_did_not_end(tmp_path):
    process = begin(tmp_path, time_limit="300")
    wait_for(tmp_path / "metrics.json", process)
    seen = 0
    until = time.monotonic() + 60
    while seen < 2 and time.monotonic() < until:  # whenever one looks, there is a whole scene
        scene = Scene.load(tmp_path / "scene.json")
        seen = max(seen, len(scene.objects))
        time.sleep(0.05)
    process.kill()
    process.communicate()
    scene = Scene.load(tmp_path / "scene.json")
    assert len(scene.objects) >= 2 and check(scene).valid
    assert "killed" in json.loads((tmp_path / "metrics.json").read_text("utf-8"))["cut_off"]


def test_a_second_signal_ends_it_at_once(tmp_path):
    process = begin(tmp_path, time_limit="300")
    wait_for(tmp_path / "scene.json", process)
    process.send_signal(signal.SIGTERM)
    time.sleep(0.2)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=10)
    assert process.returncode == 143
    Scene.load(tmp_path / "scene.json")


@pytest.mark.slow
@pytest.mark.parametrize(("prompt", "limit"), [(BEDROOM, 6.0), (HEAP, 6.0), (HEAP, 15.0)])
def test_a_time_limit_is_kept_and_leaves_a_scene(tmp_path, prompt, limit):
    began = time.monotonic()
    code, said = ended(begin(tmp_path, prompt, time_limit=str(limit)), limit + 30)
    assert time.monotonic() - began < limit + 2.0
    assert code in (0, 3)
    scene, metrics = written(tmp_path)
    assert (code == 0) == said["satisfied"]
    assert prompt == BEDROOM or (code == 3 and metrics["cut_off"] == f"{limit:g} seconds")


def test_signals_are_heard_once_and_then_as_before():
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    heard = []
    signal.signal(signal.SIGTERM, lambda *_: heard.append(1))
    try:
        with stoppable() as stop:
            assert not stop.reason
            signal.raise_signal(signal.SIGTERM)
            assert stop.reason == "SIGTERM" and not heard
            signal.raise_signal(signal.SIGTERM)
            assert heard == [1]
    finally:
        signal.signal(signal.SIGTERM, before[1])
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before


def test_a_signal_that_is_ignored_stays_so():
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with stoppable() as stop:
            signal.raise_signal(signal.SIGINT)
            assert not stop.reason
    finally:
        signal.signal(signal.SIGINT, before)
