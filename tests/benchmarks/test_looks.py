"""A vision critic beside strict eyes: what counts as found, and a whole run with a scripted model."""

from __future__ import annotations

from typing import Any

import pytest

from benchmarks.families import looks
from benchmarks.judging import Judge
from benchmarks.settings import Settings
from benchmarks.strict_eyes import Label, labels
from sceneweaver.agent.by_model.look_reply import Look
from sceneweaver.critic import Fault
from tests.llm.model_server import MODEL, Asked, ModelServer, answering

BED = Label(("bed_off_door_wall",), frozenset({"bed-0"}))
RUG = Label(("rug_on_bed_axis",), frozenset({"rug-0"}))
WALLS = Label(("wall_covered",), frozenset())


def fault(*objects: str, criterion: str = "layout") -> Fault:
    return Fault(criterion=criterion, kind="seen", objects=objects, reason="so")


def test_each_label_needs_a_fault_of_its_own() -> None:
    assert looks.matched([BED, RUG], [fault("bed-0"), fault("rug-0", "bed-0")]) == 2
    assert looks.matched([BED, RUG], [fault("bed-0", "rug-0", "lamp-0")]) == 1, "naming everything finds one"
    assert looks.matched([BED, RUG], [fault("lamp-0"), fault()]) == 0
    assert looks.matched([], [fault("bed-0")]) == looks.matched([BED], []) == 0


def test_faults_of_the_room_have_to_be_of_the_same_criterion() -> None:
    (criterion,) = {looks.design_rules()[name].criterion for name in WALLS.rules}
    other = "realism" if criterion != "realism" else "layout"
    assert looks.matched([WALLS], [fault(criterion=criterion)]) == 1
    assert looks.matched([WALLS], [fault(criterion=other)]) == 0
    assert looks.matched([WALLS], [fault("picture-0", criterion=criterion)]) == 0


@pytest.fixture
def settings(tmp_path) -> Settings:
    return Settings(device="cpu", quick=True, out=tmp_path, count=2)


def test_a_model_is_scored_beside_the_symbolic_critic(settings: Settings, monkeypatch) -> None:
    """The scripted model names the labelled objects of the first scene, and grades as strict eyes do."""
    graded = {one.name: one for one in labels()[: looks.QUICK]}

    def answer(asked: Asked) -> dict[str, Any]:
        one = [*graded.values()][asked.ordinal // 2]  # two answers a scene
        about = {"criterion": "layout", "wrong": "it is wrong", "severity": 2}
        faults = [{**about, "objects": sorted(label.objects)} for label in one.labels if label.objects]
        grades = {name: {"comment": "so", "grade": grade} for name, grade in one.grades.items()}
        return {"faults": faults, **grades}

    with ModelServer(answering({Look: answer})) as server:
        monkeypatch.setenv("SCENEWEAVER_MODEL", f"openai:{MODEL}")
        monkeypatch.setenv("SCENEWEAVER_BASE_URL", server.url)
        monkeypatch.setenv("SCENEWEAVER_MODEL_PICTURES", "false")
        result = looks.run(settings, Judge(1))
    rows = {row["critic"]: row for row in result.table("critics").rows}
    symbolic = rows.pop("symbolic")
    (seen,) = rows.values()
    assert seen["scenes"] == symbolic["scenes"] == 3 and seen["labelled"] == symbolic["labelled"]
    assert seen["error"] == 0 and seen["spread"] == 0 and symbolic["spread"] is None
    assert seen["found"] > 0 and seen["precision"] > 0.5 and seen["eyes"] > 0
    assert symbolic["recall"] > 0.5
    assert len(server.requests) == 6


def test_a_scene_without_an_answer_is_left_out_of_both(settings: Settings, monkeypatch) -> None:
    with ModelServer(answering({}, otherwise="I will not.")) as server:
        monkeypatch.setenv("SCENEWEAVER_MODEL", f"openai:{MODEL}")
        monkeypatch.setenv("SCENEWEAVER_BASE_URL", server.url)
        monkeypatch.setenv("SCENEWEAVER_MODEL_PICTURES", "false")
        result = looks.run(settings, Judge(1))
    assert [row["critic"] for row in result.table("critics").rows] == ["symbolic"]
    assert sum("is left out" in note for note in result.notes) == 3


def test_without_a_model_the_symbolic_critic_is_measured_alone(settings: Settings, monkeypatch) -> None:
    monkeypatch.delenv("SCENEWEAVER_MODEL", raising=False)
    result = looks.run(settings, Judge(1))
    assert [row["critic"] for row in result.table("critics").rows] == ["symbolic"]
    assert any("No model looked" in note for note in result.notes)
