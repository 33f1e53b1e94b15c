"""The program itself with a model that misbehaves or is not there: exit codes, output, files, and the key nowhere."""

from __future__ import annotations

import socket
import subprocess
import sys
from pathlib import Path

import pytest

from tests.agent.by_model.hostile import assert_sound
from tests.agent.by_model.obliging import ROOM, obliging
from tests.llm.asking import strict_json
from tests.llm.misbehaviour import always, catalogue, misbehaving, seeded
from tests.llm.model_server import MODEL, ModelServer
from tests.llm.planted_key import Planted, planted

ARGUMENTS = ["--planner", "llm", "--steps", "2", "--candidates", "8", "--device", "cpu", "--seed", "1"]
QUICK = ["--critic", "symbolic", "--no-pictures", "--export", "none"]
VALID, NOT_VALID, MISSING = 0, 3, 4
PATIENCE = 300


def program(key: Planted, folder: Path, url: str, *more: str) -> subprocess.CompletedProcess[str]:
    """`sceneweaver design`, with the key under all its names and every library at its most talkative."""
    own = {name: str(folder / name.lower()) for name in ("SCENEWEAVER_ASSETS", "SCENEWEAVER_ROOMS")}
    environment = key.environment | own | {"SCENEWEAVER_MODEL_TIMEOUT": "2", "SCENEWEAVER_DEBUG": "1"}
    command = [sys.executable, "-m", "sceneweaver", "design", ROOM, *ARGUMENTS, "--out", str(folder / "run")]
    command += ["--model", f"openai:{MODEL}", "--base-url", url, *more]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False)


def nowhere() -> str:
    """The URL of a port on which nobody listens."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return f"http://127.0.0.1:{free.getsockname()[1]}/v1"


@pytest.mark.slow
def test_a_strict_run_ends_where_the_model_is_not_reachable(tmp_path: Path) -> None:
    with planted() as key:
        ended = program(key, tmp_path, nowhere(), "--strict", *QUICK)
        key.assert_nowhere(tmp_path, ended.stdout, ended.stderr)
    assert ended.returncode == MISSING, ended.stderr
    assert "no connection" in ended.stderr and not list(tmp_path.rglob("*.tmp"))


@pytest.mark.slow
def test_without_a_model_the_rules_do_it_and_say_so(tmp_path: Path) -> None:
    with planted() as key:
        ended = program(key, tmp_path, nowhere(), *QUICK[2:])
        key.assert_nowhere(tmp_path, ended.stdout, ended.stderr)
    assert ended.returncode in (VALID, NOT_VALID), ended.stderr
    assert "no connection" in ended.stdout
    assert_sound(tmp_path / "run")
    metrics = strict_json((tmp_path / "run" / "metrics.json").read_text())
    assert set(metrics["models"]["planned"]) == {"rules"} and "no connection" in metrics["models"]["lost"]


MIXED = [*range(4)]
ONE = ["broken_json", "key_in_error", "key_in_arguments", "key_in_halves", "hidden_instructions", "paths_for_names"]
ONE += ["control_characters", "equal_ids", "huge_numbers", "lists_of_10000", "dripped_events", "unauthorized"]


@pytest.mark.slow
@pytest.mark.parametrize("how", [*ONE, *MIXED])
def test_a_model_that_misbehaves(how: str | int, tmp_path: Path) -> None:
    pick = always(how) if isinstance(how, str) else seeded(how, 0.5, catalogue("answers", "shapes", "echoes", "broken"))
    with planted() as key, ModelServer(misbehaving(obliging, pick)) as server:
        stream = ["--stream"] if how in MIXED[::2] else []
        ended = program(key, tmp_path, server.url, *stream, *(QUICK if isinstance(how, str) else []))
        key.assert_nowhere(tmp_path, ended.stdout, ended.stderr)
    assert ended.returncode in (VALID, NOT_VALID), (ended.returncode, ended.stderr[-2000:])
    assert "Traceback" not in ended.stderr
    assert_sound(tmp_path / "run")
    metrics = strict_json((tmp_path / "run" / "metrics.json").read_text())
    if "rules" in metrics["models"]["planned"]:
        assert "rules" in ended.stdout
