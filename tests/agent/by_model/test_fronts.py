"""The front of an asset from four views: letters are mapped to sides by code, and an unsure model changes nothing."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image
from pydantic_ai.messages import BinaryContent, ModelMessage, ModelResponse, TextPart, ToolCallPart
from pydantic_ai.models.function import AgentInfo, FunctionModel

from sceneweaver.agent.by_model.fronts import LABELS, front_by_views, order_of, side_views
from sceneweaver.agent.by_model.pictures import packed
from sceneweaver.assets import Asset, make
from sceneweaver.assets.imports.hints import Hints, SeenFront
from sceneweaver.assets.imports.prepare import prepare
from sceneweaver.cli import assets as commands
from sceneweaver.llm import ModelClient, ModelFailed
from sceneweaver.scene import InputError


def turned(asset: Asset, quarters: int) -> Asset:
    """The asset with its front that many quarter turns counter-clockwise from +x."""
    turn = np.linalg.matrix_power(np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]), quarters)  # not that of the module
    return replace(asset, mesh=replace(asset.mesh, vertices=asset.mesh.vertices @ turn.T))


class Eyes:
    """A model that knows what the front of a thing looks like: it says which picture is that one."""

    def __init__(self, wanted: bytes, **answer: Any) -> None:
        self.wanted, self.answer, self.told = wanted, answer, list[list[ModelMessage]]()
        self.client = ModelClient(FunctionModel(self.say))

    def say(self, messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        self.told.append(messages)
        content = getattr(messages[0].parts[0], "content", ())
        pictures = [part.data for part in content if isinstance(part, BinaryContent)]
        said = {"reason": "doors", "label": LABELS[pictures.index(self.wanted)], "confidence": 0.9, **self.answer}
        return _call(info, said)


def _call(info: AgentInfo, said: dict[str, Any]) -> ModelResponse:
    return ModelResponse(parts=[ToolCallPart(info.output_tools[0].name, said)])


@pytest.fixture(scope="module")
def wardrobe() -> Asset:
    return make("wardrobe", 2)


@pytest.mark.parametrize("quarters", [pytest.param(0, marks=pytest.mark.slow), 3])
def test_the_letter_is_mapped_to_the_turn(wardrobe: Asset, quarters: int) -> None:
    asset = turned(wardrobe, quarters)
    eyes = Eyes(side_views(asset)[quarters])
    found = front_by_views(eyes.client, asset)
    assert (found.quarters, found.confidence, found.reason) == (quarters, 0.9, "doors")
    assert found.by == eyes.client.name


def test_letters_go_round_by_the_shape(wardrobe: Asset) -> None:
    assert sorted(order_of(wardrobe)) == [0, 1, 2, 3] and order_of(wardrobe) == order_of(make("wardrobe", 2))
    assert len({order_of(make("wardrobe", seed)) for seed in range(6)}) > 1


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> list[bytes]:
    """Four pictures that cost nothing."""
    views = [packed(Image.new("RGB", (16, 16), (60 * k, 0, 0))) for k in range(4)]
    monkeypatch.setattr("sceneweaver.agent.by_model.fronts.side_views", lambda *_, **__: views)
    return views


@pytest.mark.parametrize("unsure", [{"confidence": 0.4}, {"label": "none"}, {"label": "none", "confidence": 0.0}])
def test_unsure_the_offline_answer_stays(wardrobe: Asset, quick: list[bytes], unsure: dict[str, Any]) -> None:
    asset = replace(turned(wardrobe, 1), origin=replace(wardrobe.origin, front_confidence=0.35))
    found = front_by_views(Eyes(quick[1], **unsure).client, asset)
    assert (found.quarters, found.confidence, found.by) == (0, 0.35, "shape")


def test_what_is_wrong_is_told_and_a_refusal_is_an_error(wardrobe: Asset, quick: list[bytes]) -> None:
    eyes = Eyes(quick[0], confidence=7)
    with pytest.raises(ModelFailed):
        front_by_views(eyes.client, wardrobe)
    assert "less than or equal to 1" in str(eyes.told[-1])
    with pytest.raises(ModelFailed):
        front_by_views(ModelClient(FunctionModel(lambda *_: ModelResponse(parts=[TextPart("I cannot.")]))), wardrobe)
    blind = ModelClient(FunctionModel(lambda *_: ModelResponse(parts=[TextPart("?")])))
    blind.pictures = False
    with pytest.raises(ModelFailed, match="takes no pictures"):
        front_by_views(blind, wardrobe)


def test_sides_go_counter_clockwise_in_one_light(wardrobe: Asset) -> None:
    def pixels(png: bytes) -> np.ndarray:
        return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(float)

    front = pixels(side_views(wardrobe)[0])
    apart = [np.abs(pixels(view) - front).mean() for view in side_views(turned(wardrobe, 1))]
    assert int(np.argmin(apart)) == 1 and min(apart) < 1.0


@pytest.fixture
def mesh(wardrobe: Asset, tmp_path: Path) -> Path:
    """A mesh file of a wardrobe that looks to +y."""
    body = turned(wardrobe, 1).mesh
    trimesh.Trimesh(body.vertices, body.faces, process=False).export(tmp_path / "w.stl")
    return tmp_path / "w.stl"


def test_an_import_turns_the_mesh_to_the_front_that_was_seen(mesh: Path, tmp_path: Path) -> None:
    hints = Hints(path=mesh, name="w", category="wardrobe", up="z", metres=1.0)
    plain = prepare(hints, cache=tmp_path)
    seen = prepare(hints.with_(seen=SeenFront(1, 0.9, "m")), cache=tmp_path)
    assert seen.origin.front_confidence == 0.9 and "front seen by m, confidence 0.90" in seen.origin.notes
    assert np.allclose(seen.mesh.vertices, turned(plain, 3).mesh.vertices, atol=1e-9)
    stated = prepare(replace(hints, front="y", seen=SeenFront(1, 0.9, "m")), cache=tmp_path)
    assert stated.origin.front_confidence == 1.0


def imported(mesh: Path, monkeypatch: pytest.MonkeyPatch, said: ModelResponse | dict[str, Any]) -> int:
    """``sceneweaver assets import --front ask`` with a model that says one thing."""

    def say(messages: list[ModelMessage], info: AgentInfo) -> ModelResponse:
        return said if isinstance(said, ModelResponse) else _call(info, said)

    monkeypatch.setattr(commands, "_client", lambda *_: ModelClient(FunctionModel(say)))
    given: dict[str, Any] = {"kind": "auto", "store": mesh.parent / "store", "category": "wardrobe", "up": "z"}
    given |= {"front": "ask", "model": None, "base_url": None, "unit": 1.0, "licence": "CC0-1.0", "allow": []}
    return commands.run_import(mesh, **given, time_limit=60.0, limit=None, as_json=False)


def test_an_import_lets_a_model_look(mesh: Path, quick: list[bytes], monkeypatch, capsys) -> None:
    assert imported(mesh, monkeypatch, {"label": "C", "confidence": 0.95}) == 0
    assert "front seen by" in (out := capsys.readouterr().out) and "confidence 0.95" in out


def test_an_import_goes_on_without_an_answer(mesh: Path, quick: list[bytes], monkeypatch, capsys) -> None:
    assert imported(mesh, monkeypatch, ModelResponse(parts=[TextPart("No.")])) == 0
    said = capsys.readouterr()
    assert "front found from the shape, as" in said.err and "front seen" not in said.out


def test_a_model_is_for_asking_only(mesh: Path, tmp_path: Path) -> None:
    given: dict[str, Any] = {"kind": "auto", "store": tmp_path, "category": None, "up": None, "front": "y"}
    with pytest.raises(InputError, match="--front ask"):
        commands.run_import(
            mesh, **given, model="m", base_url=None, unit=None, licence=None, allow=[], time_limit=1.0, limit=1,
            as_json=True,
        )  # fmt: skip
