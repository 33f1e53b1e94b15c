"""A stand-in for the layout engine, so that tests of the command line need neither Warp nor time."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any

import numpy as np

from sceneweaver.scene import Pose, Scene


@dataclass
class FakeSolution:
    """What ``refine`` returns."""

    best: Scene
    candidates: int
    seed: int
    device: str = "cpu"
    elapsed: float = 0.5
    timed_out: bool = False
    explanation: str | None = None
    objective: np.ndarray | None = None
    order: np.ndarray = field(default_factory=lambda: np.arange(4))
    status: np.ndarray = field(default_factory=lambda: np.array([0, 0, 1, 2], dtype=np.int8))


def moved(scene: Scene) -> Scene:
    """The scene with its first object outside of the room."""
    return scene.replace_poses({scene.objects[0].id: Pose.from_yaw(-3.0, -3.0, 0.0, 0.3)})


def use(monkeypatch, refine: Callable[..., Any]) -> list[dict[str, Any]]:
    """Put an engine in place of the real one; returns the list of calls that it gets."""
    calls: list[dict[str, Any]] = []

    def recorded(scene: Scene, **options: Any) -> Any:
        calls.append({"scene": scene, **options})
        return refine(scene, **options)

    module = ModuleType("sceneweaver.explain")
    module.refine = recorded  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "sceneweaver.explain", module)
    return calls


def keeps(scene: Scene, *, candidates: int, seed: int, progress: Any, **_: Any) -> FakeSolution:
    """An engine that is content with the poses of the scene."""
    if progress is not None:
        progress(candidates, candidates, 2, 0.0)
    return FakeSolution(scene, candidates, seed)


def spoils(scene: Scene, *, candidates: int, seed: int, **_: Any) -> FakeSolution:
    """An engine that moves an object out of the room."""
    return FakeSolution(moved(scene), candidates, seed, timed_out=True, explanation="the walls are too short by 0.4 m")


def example_data(name: str = "bedroom") -> dict[str, Any]:
    """A bundled room as JSON data to change."""
    return json.loads(Scene.example(name).dumps())
