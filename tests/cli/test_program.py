"""The program as a user starts it: in a process of its own."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import sceneweaver
from sceneweaver.cli import main
from sceneweaver.cli.app import COLLECT

ROOT = Path(__file__).parents[2]
EXAMPLE = Path(sceneweaver.__file__).parent / "scene" / "examples" / "bedroom.json"
MODULE = [sys.executable, "-m", "sceneweaver.cli"]


def start(*args, cwd, **env):
    full = {k: v for k, v in os.environ.items() if k != "SCENEWEAVER_DEBUG"} | env
    return subprocess.run([*MODULE, *args], cwd=cwd, capture_output=True, text=True, timeout=120, env=full, check=False)


def test_help_is_quick_and_lists_the_commands(tmp_path):
    began = time.perf_counter()
    ended = start("--help", cwd=tmp_path)
    assert ended.returncode == 0 and ended.stderr == ""
    assert time.perf_counter() - began < 5  # well under one second on an idle machine
    for command in ("refine", "repair", "check", "render", "design", "view", "demo", "examples"):
        assert command in ended.stdout


def test_help_loads_nothing_heavy(tmp_path):
    code = (
        "import sys; from sceneweaver.cli import main; main(['--help']);"
        "heavy = {'numpy', 'pydantic', 'PIL', 'warp', 'shapely', 'jax', 'mujoco', 'pxr', 'trimesh'};"
        "print(sorted(heavy & set(sys.modules)))"
    )
    ended = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert ended.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize(("arguments", "own"), [("", True), ("['--version']", False)])
def test_the_garbage_collector_is_set_for_a_process_of_its_own_alone(arguments, own):
    code = f"import gc; from sceneweaver.cli import main; main({arguments}); print(*gc.get_threshold())"
    ended = subprocess.run(
        [sys.executable, "-c", code, "--version"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert (tuple(map(int, ended.stdout.splitlines()[-1].split())) == COLLECT) == own


def test_version(capfd):
    assert main(["--version"]) == 0
    assert capfd.readouterr().out == f"sceneweaver {sceneweaver.__version__}\n"


def test_without_a_command_there_is_help(capfd):
    assert main([]) == 0
    assert "refine" in capfd.readouterr().out


@pytest.mark.parametrize("command", ["refine", "repair", "check", "render", "design", "view", "demo", "examples"])
def test_every_command_has_help(capfd, command):
    assert main([command, "--help"]) == 0
    out = re.sub(r"\x1b\[[0-9;]*m", "", capfd.readouterr().out)
    assert "Usage" in out and ("--json" in out or command == "view")


def test_refine_with_the_real_engine(tmp_path):
    name = next(
        r["path"]
        for r in json.loads(start("examples", "--json", cwd=tmp_path).stdout)["examples"]
        if r["name"] == "study"
    )
    ended = start("refine", name, "-o", "out", "--candidates", "8", "--device", "cpu", "--json", cwd=tmp_path)
    assert ended.stderr == "" and ended.returncode in (0, 3)
    data = json.loads(ended.stdout)
    assert data["exit_code"] == ended.returncode and data["candidates"] == 8
    assert start("check", "out/scene.json", cwd=tmp_path).returncode == ended.returncode
    metrics = json.loads((tmp_path / "out" / "metrics.json").read_text())
    assert metrics["valid"] is (ended.returncode == 0) and metrics["device"] == "cpu"
    assert metrics["valid"] or data["valid_candidates"] == 0  # whatever the engine calls valid, the judge calls valid


def test_bad_input_in_a_process_is_one_line(tmp_path):
    (tmp_path / "scene.json").write_text('{"schema": "sceneweaver.scene/1", "id": "x", "rom": {}}')
    ended = start("check", "scene.json", cwd=tmp_path)
    assert ended.returncode == 2 and ended.stdout == "" and ended.stderr.count("\n") == 1
    assert "rom" in ended.stderr and "room" in ended.stderr


def test_a_crash_of_native_code_says_where_also_while_libraries_are_kept_quiet(tmp_path):
    program = (
        "import ctypes, sys\n"
        "from sceneweaver.cli.app import app, main\n"
        "from sceneweaver.cli.streams import no_chatter\n"
        "@app.command('crash')\n"
        "def crash():\n"
        "    with no_chatter():\n"
        "        ctypes.string_at(0)\n"
        "main()\n"
    )
    ended = subprocess.run([sys.executable, "-c", program, "crash"], cwd=tmp_path, capture_output=True, text=True)
    assert ended.returncode == -signal.SIGSEGV and "in crash" in ended.stderr


@pytest.mark.parametrize(
    ("number", "code"), [pytest.param(signal.SIGINT, 130, marks=pytest.mark.slow), (signal.SIGTERM, 143)]
)
def test_signals_leave_nothing_behind(tmp_path, number, code):
    program = (
        "import sys, time, types\n"
        "from sceneweaver.cli import main\n"
        "def refine(scene, **options):\n"
        "    open('started', 'w').close()\n"
        "    time.sleep(60)\n"
        "sys.modules['sceneweaver.explain'] = types.SimpleNamespace(refine=refine)\n"
        f"sys.exit(main(['refine', {str(EXAMPLE)!r}, '--out', 'out']))\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # jobs in the background begin without it
    )
    try:
        for _ in range(600):
            if (tmp_path / "started").exists():
                break
            time.sleep(0.05)
        process.send_signal(number)
        _, err = process.communicate(timeout=30)
    finally:
        process.kill()
    assert process.returncode == code
    assert "Traceback" not in err
    assert [p.name for p in tmp_path.iterdir()] == ["started"]


def test_progress_is_shown_on_a_terminal(tmp_path):
    program = (
        "import sys, types\n"
        "from sceneweaver.cli import main\n"
        "from tests.cli import engine\n"
        "sys.modules['sceneweaver.explain'] = types.SimpleNamespace(refine=engine.keeps)\n"
        f"sys.exit(main(['refine', {str(EXAMPLE)!r}, '--out', {str(tmp_path / 'out')!r}, '--json']))\n"
    )
    terminal, end = os.openpty()
    command = [sys.executable, "-c", program]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=end, text=True) as process:
        os.close(end)
        shown = b""
        with contextlib.suppress(OSError):  # so a terminal says that its other end was closed
            while chunk := os.read(terminal, 4096):
                shown += chunk
        out = process.stdout.read()
    os.close(terminal)
    assert process.returncode == 0 and json.loads(out)["valid"] is True
    assert b"refining bedroom" in shown and b"2 valid" in shown


def test_a_reader_that_goes_away_is_no_error(tmp_path):
    read, write = os.pipe()
    os.close(read)
    ended = subprocess.run(
        [*MODULE, "examples"], cwd=tmp_path, stdout=write, stderr=subprocess.PIPE, text=True, check=False
    )
    os.close(write)
    assert ended.returncode == 1 and ended.stderr == ""
