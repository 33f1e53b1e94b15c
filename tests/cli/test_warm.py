"""``sceneweaver warm``, and what a terminal shows while kernels are compiled."""

from __future__ import annotations

import json
import os
import select
import subprocess
import sys
from pathlib import Path

import pytest

from sceneweaver.cli import streams
from sceneweaver.runtime.compiling import Compiling

ROOT = Path(__file__).parents[2]
FEW = """
import sys
from sceneweaver.kernels import variants_of
from sceneweaver.layout import warming
from sceneweaver.plans import solve_run
from sceneweaver.render.tracing import tracer
warming.kernel_modules = lambda device: [*variants_of("bookkeeping"), *variants_of("chains")]
tracer.kernel_modules = solve_run.kernel_modules = lambda: []
from sceneweaver.cli import main
sys.exit(main(sys.argv[1:]))
"""


def warm(cache: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", FEW, "warm", "--device", "cpu", *arguments]
    environment = {**os.environ, "WARP_CACHE_PATH": str(cache)}
    return subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=240, check=False)


@pytest.mark.slow
def test_it_compiles_once_and_says_where_the_cache_is(tmp_path):
    done = warm(tmp_path)
    (folder,) = tmp_path.iterdir()
    assert done.returncode == 0
    assert done.stdout.startswith("cpu: 2 of 2 modules of kernels compiled in ")
    assert done.stdout.endswith(f" s; the cache is {folder}\n")
    first, *_, last = done.stderr.splitlines()
    assert first.startswith("compiling kernels, once (about ") and first.endswith("): 0 of 2 modules")
    assert last.startswith("compiled 2 modules of kernels in ")
    again = warm(tmp_path, "--json")
    assert again.returncode == 0 and again.stderr == ""
    told = json.loads(again.stdout)
    assert (told["modules"], told["compiled"], told["folder"], told["exit_code"]) == (2, 0, str(folder), 0)


@pytest.mark.slow
def test_it_compiles_for_a_gpu_that_is_not_here(tmp_path):
    done = warm(tmp_path, "--arch", "90")
    assert done.returncode == 0 and done.stdout.startswith("sm_90: 2 of 2 modules of kernels compiled in ")
    assert len([*tmp_path.rglob("*.sm90.cubin")]) == 2
    wrong = warm(tmp_path, "--arch", "12")
    assert wrong.returncode == 2 and wrong.stderr.startswith("sceneweaver: arch: 12 is not one of ")


def test_it_is_said_while_libraries_are_kept_quiet(capfd):
    line = streams.CompilingLine()
    with streams.no_chatter():
        line(Compiling(0, 3, 0.0, 10.0))
        assert capfd.readouterr().err == "compiling kernels, once (about 10 s): 0 of 3 modules\n"
        line(Compiling(1, 3, 5.0, 10.0))  # too soon
        assert capfd.readouterr().err == ""
        line(Compiling(2, 3, 16.0, 20.0))
        line(Compiling(3, 3, 17.0, 20.0))
    said = capfd.readouterr().err.splitlines()
    assert said == ["compiling kernels, once (about 20 s): 2 of 3 modules", "compiled 3 modules of kernels in 17.0 s"]


def test_a_terminal_has_one_line_that_moves():
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    line, before = streams.CompilingLine(), streams._kept
    streams._kept = 1, theirs, sys.stdout
    try:
        for done in range(3):
            line(Compiling(done, 2, float(done), 4.0))
    finally:
        streams._kept = before
    said = b""
    while b"\n" not in said:  # a terminal hands on what was written piece by piece
        assert select.select([ours], [], [], 30.0)[0], said
        said += os.read(ours, 10_000)
    os.close(ours)
    os.close(theirs)
    said = said.decode()
    assert said.count("\r\x1b[K") == 3 and said.count("\n") == 1 and "(about 5 s): 1 of 2" in said


def test_what_is_spoken_is_shown_at_once_and_chatter_is_not(capfd):
    with streams.no_chatter():
        print("chatter")
        os.write(1, b"more of it\n")
        with streams.spoken():
            print("a verdict")
            print("a step", file=sys.stderr)
        print("chatter again")
        said = capfd.readouterr()
        assert said.out == "a verdict\n" and said.err == "a step\n"
    said = capfd.readouterr()
    assert said.out == "" and said.err == ""
