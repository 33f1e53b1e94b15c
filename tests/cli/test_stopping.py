"""Signals and time limits, sent to real processes: there is always a scene, its metrics say so, and nothing is late."""

from __future__ import annotations

import json
import os
import resource
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
    given = [f"--{name.replace('_', '-')}={value}" for name, value in options.items() if value != "false"]
    given += [f"--no-{name}" for name, value in options.items() if value == "false"]
    command = [*MODULE, "design", prompt, f"--out={out}", "--device=cpu", "--json", *given]
    return subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # jobs in the background begin without it
    )


def wait_for(path: Path, process: subprocess.Popen[str]) -> None:
    until = time.monotonic() + WAIT
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


SECONDS = 2.0
"""Of work, within which a signal ends a run."""

WAIT, LOADED = 240.0, 60.0
"""Seconds for a file to appear, and for a run to end: what is more is no machine that is busy."""


def worked(process: subprocess.Popen[str]) -> float:
    """Seconds of work of a process and its threads: on a busy machine a second takes longer."""
    fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def signalled(process: subprocess.Popen[str], number: signal.Signals) -> tuple[int, dict]:
    """Exit code and what was said of a run that a signal ends; it does little more work."""
    before, spent = worked(process), resource.getrusage(resource.RUSAGE_CHILDREN)
    process.send_signal(number)
    code, said = ended(process, LOADED)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert after.ru_utime + after.ru_stime - spent.ru_utime - spent.ru_stime - before < SECONDS
    return code, said


def as_it_says(out: Path, code: int, said: dict) -> None:
    """Whether a run that was ended early left what it says that it left."""
    scene, metrics = written(out)
    assert code == said["exit_code"] == (5 if said["valid"] and not said["unmet"] else 3) and said["undone"]
    assert said["metrics"] == metrics and metrics.get("left_out", []) == [
        str(Path(name).relative_to(out)) for name in said["left_out"]
    ]
    assert {"scene.json", "metrics.json"} <= {Path(name).name for name in said["files"]}
    assert all(Path(name).exists() for name in said["files"])
    assert not {*said["files"]} & {*said["left_out"]}


def test_a_signal_ends_it_with_what_there_is(tmp_path):
    process = begin(tmp_path, time_limit="300", export="all", candidates="8")
    wait_for(tmp_path / "steps/01/scene.json", process)
    code, said = signalled(process, signal.SIGTERM)
    as_it_says(tmp_path, code, said)
    assert said["finished"] == said["metrics"]["cut_off"] == "SIGTERM" and said["objects"]


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("moment", range(10))
def test_a_signal_ends_it_in_every_phase(tmp_path, number, moment):
    process = begin(tmp_path, time_limit="300", export="all")
    while process.poll() is None and worked(process) < 1.0 + 1.5 * moment:
        time.sleep(0.01)
    early = not (tmp_path / "metrics.json").exists()
    if early:
        process.send_signal(number)
        process.communicate(timeout=LOADED)
        assert process.returncode in (128 + number, -number) and not list(tmp_path.rglob(".sceneweaver-*"))
        return
    code, said = signalled(process, number)
    as_it_says(tmp_path, code, said)


@pytest.mark.slow
def test_what_a_signal_ended_goes_on(tmp_path):
    process = begin(tmp_path, time_limit="300", pictures="false")
    wait_for(tmp_path / "scene.json", process)
    signalled(process, signal.SIGTERM)
    code, said = ended(begin(tmp_path, time_limit="300"), 300)
    assert code == 0 and said["finished"] not in ("", "SIGTERM") and written(tmp_path)[1]["cut_off"] is None


def test_a_killed_one_leaves_the_last_scene_and_says_that_it_did_not_end(tmp_path):
    process = begin(tmp_path, time_limit="300", candidates="8")
    wait_for(tmp_path / "metrics.json", process)
    seen = 0
    until = time.monotonic() + WAIT
    while seen < 2 and time.monotonic() < until:  # whenever one looks, there is a whole scene
        scene = Scene.load(tmp_path / "scene.json")
        seen = max(seen, len(scene.objects))
        time.sleep(0.05)
    process.kill()
    process.communicate()
    scene = Scene.load(tmp_path / "scene.json")
    assert len(scene.objects) >= 2 and check(scene).valid
    assert "killed" in json.loads((tmp_path / "metrics.json").read_text("utf-8"))["cut_off"]


@pytest.mark.slow  # in this process, below, one is heard and the next is as before
def test_signals_after_the_first_end_it_at_once(tmp_path):
    process = begin(tmp_path, time_limit="300", candidates="8")
    wait_for(tmp_path / "metrics.json", process)
    until = time.monotonic() + LOADED
    while process.poll() is None and time.monotonic() < until:  # two that come close together may be heard as one
        process.send_signal(signal.SIGTERM)
        time.sleep(0.1)
    process.communicate(timeout=LOADED)
    # While an interpreter ends it has no handlers any more; a shell calls both 143.
    assert process.returncode in (128 + signal.SIGTERM, -signal.SIGTERM)
    Scene.load(tmp_path / "scene.json")


@pytest.mark.slow
@pytest.mark.parametrize(("prompt", "limit"), [(BEDROOM, 6.0), (HEAP, 6.0), (HEAP, 15.0)])
def test_a_time_limit_is_kept_and_leaves_a_scene(tmp_path, prompt, limit):
    began = time.monotonic()
    code, said = ended(begin(tmp_path, prompt, time_limit=str(limit)), limit + 30)
    assert time.monotonic() - began < limit + 2.0
    assert code in (0, 3, 5)
    scene, metrics = written(tmp_path)
    assert (code == 0) == said["satisfied"]
    assert prompt == BEDROOM or (code == 3 and metrics["cut_off"].startswith(f"{limit:g} seconds"))


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


def test_before_there_is_something_to_end_with_a_signal_ends_the_process():
    heard = []
    before = signal.signal(signal.SIGTERM, lambda *_: heard.append(1))
    try:
        with stoppable(ready=False) as stop:
            stop.ready = True
            signal.raise_signal(signal.SIGTERM)
            assert stop.reason == "SIGTERM" and not heard
        with stoppable(ready=False) as stop:
            signal.raise_signal(signal.SIGTERM)
            assert heard == [1]
    finally:
        signal.signal(signal.SIGTERM, before)


def test_a_signal_that_is_ignored_stays_so():
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with stoppable() as stop:
            signal.raise_signal(signal.SIGINT)
            assert not stop.reason
    finally:
        signal.signal(signal.SIGINT, before)
