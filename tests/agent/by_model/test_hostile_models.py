"""From a request to a room with a model that misbehaves: a valid scene, an honest report, and the key nowhere."""

from __future__ import annotations

import ssl
from pathlib import Path

import pytest

from sceneweaver.agent.by_model.plan_reply import Plan
from sceneweaver.llm import attempts
from tests.agent.by_model.hostile import assert_honest, assert_sound, designed
from tests.agent.by_model.obliging import call, obliging
from tests.llm.misbehaviour import Misbehaviour, always, catalogue, misbehaving, seeded
from tests.llm.model_server import Asked, ModelServer, Said, says
from tests.llm.planted_key import planted

PASSING = catalogue("answers", "shapes", "large", "echoes", "broken")


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """No long waits, no certificates, and nothing of this user."""
    monkeypatch.setattr(attempts, "FIRST_WAIT", 0.01)
    monkeypatch.setattr(attempts, "LONGEST_WAIT", 0.1)
    monkeypatch.setattr(ssl.SSLContext, "load_verify_locations", lambda *_, **__: None)
    monkeypatch.setenv("SCENEWEAVER_MODEL_TIMEOUT", "1.5")
    monkeypatch.setenv("SCENEWEAVER_ASSETS", str(tmp_path / "assets"))
    monkeypatch.setenv("SCENEWEAVER_ROOMS", str(tmp_path / "rooms"))


@pytest.mark.slow
def test_a_model_that_does_its_best_plans_every_step(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SCENEWEAVER_MODEL_TIMEOUT", "60")
    with planted() as key, ModelServer(obliging) as server:
        result = designed(server, tmp_path / "run", key, steps=2)
        key.assert_nowhere(tmp_path)
    assert_sound(tmp_path / "run")
    assert_honest(result, tmp_path / "run")
    assert result.models is not None and "rules" not in result.models.planned and not result.models.lost


@pytest.mark.slow
@pytest.mark.parametrize("tool", ["init_library", "init_llm"])
def test_a_beginning_that_fails_in_the_only_step(tool: str, tmp_path: Path) -> None:
    def script(asked: Asked) -> Said:
        return says({"calls": [call(tool)]}, asked) if asked.wants(Plan) else obliging(asked)

    with planted() as key, ModelServer(script) as server:
        result = designed(server, tmp_path / "run", key, steps=1, critic="symbolic")
    assert_sound(tmp_path / "run")
    assert_honest(result, tmp_path / "run")


SEEDS = [pytest.param(seed, marks=[] if seed < 1 else pytest.mark.slow) for seed in range(24)]


@pytest.mark.parametrize("seed", SEEDS)
def test_misbehaviour_among_good_answers(seed: int, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    api, stream, critic = ("chat", "messages")[seed % 2], seed % 4 > 1, ("symbolic", "vlm")[seed % 3 == 2]
    script = misbehaving(obliging, seeded(seed, share=0.5, among=PASSING if seed % 3 else catalogue()))
    with planted() as key, ModelServer(script) as server:
        result = designed(server, tmp_path / "run", key, api, stream=stream, pictures=seed % 8 == 7, critic=critic)
        key.assert_nowhere(tmp_path, capfd.readouterr(), repr(result))
    assert_sound(tmp_path / "run")
    assert_honest(result, tmp_path / "run")


@pytest.mark.slow
@pytest.mark.parametrize("misbehaviour", catalogue(), ids=lambda one: one.name)
def test_nothing_but_misbehaviour(
    misbehaviour: Misbehaviour, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    with planted() as key, ModelServer(misbehaving(obliging, always(misbehaviour.name))) as server:
        result = designed(server, tmp_path / "run", key, steps=2, critic="symbolic")
        key.assert_nowhere(tmp_path, capfd.readouterr(), repr(result))
    assert_sound(tmp_path / "run")
    assert_honest(result, tmp_path / "run")
