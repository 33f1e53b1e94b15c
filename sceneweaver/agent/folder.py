"""A run as a folder: every step's scene, review and calls, the state to go on from, and no secrets."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import Any

from sceneweaver.brief import Brief
from sceneweaver.critic import Review
from sceneweaver.scene import InputError, Scene
from sceneweaver.verify import Report

from .memory import Memory
from .settings import Settings

SCHEMA = "sceneweaver.run/1"
STATE = "state.json"
RELEVANT = (
    "seed",
    "side_by_side",
    "candidates",
    "finalists",
    "reflect",
    "physics",
    "one_shot",
    "settle",
    "tools",
)
"""Settings that must be the same for a run to go on; budgets may grow."""


class RunFolder:
    """Writes a run step by step; what is in ``state.json`` is always a whole state."""

    def __init__(self, path: Path):
        self.path = path

    def begin(self, brief: Brief, settings: Settings) -> tuple[Memory, Scene] | None:
        """Make the folder; the memory and scene of the run that stopped here, if one of the same request did.

        Raises:
            InputError: when the folder cannot be written, or holds a run of another request or other settings.
        """
        try:
            (self.path / "steps").mkdir(parents=True, exist_ok=True)
            handle, probe = tempfile.mkstemp(dir=self.path)
            os.close(handle)
            os.unlink(probe)
        except OSError as error:
            raise InputError(f"--out: {self.path} cannot be written ({error.strerror}); choose another place") from None
        kept = self._state()
        if kept is None:
            return None
        if kept.get("prompt") != brief.text:
            asked = str(kept.get("prompt"))
            raise InputError(
                f"--out: {self.path} holds a run of another request ({asked[:60]!r}); choose another place"
            )
        old = Settings(**kept["settings"])
        for name in RELEVANT:
            if getattr(old, name) != getattr(settings, name):
                raise InputError(
                    f"--out: {self.path} holds a run with {name} {getattr(old, name)!r}, not "
                    f"{getattr(settings, name)!r}; choose another place"
                )
        memory = Memory(**kept["memory"])
        if not memory.steps:
            return None
        return memory, Scene.load(self.path / kept["scene"])

    def step(
        self,
        number: int,
        scene: Scene,
        report: Report,
        review: Review,
        memory: Memory,
        brief: Brief,
        settings: Settings,
    ) -> None:
        """Write what a step led to, and then the state that points to it."""
        name = f"steps/{number:02d}"
        folder = self.path / name
        folder.mkdir(exist_ok=True)
        scene.save(folder / "scene.json")
        report.save(folder / "metrics.json")
        write(folder / "review.json", review.model_dump(mode="json"))
        write(folder / "step.json", memory.steps[-1].model_dump(mode="json") if memory.steps else {})
        self.state(f"{name}/scene.json", memory, brief, settings)

    def state(self, scene: str, memory: Memory, brief: Brief, settings: Settings) -> None:
        """Write the state to go on from; ``scene`` is a path inside the folder."""
        write(
            self.path / STATE,
            {
                "schema": SCHEMA,
                "prompt": brief.text,
                "brief": brief.model_dump(mode="json"),
                "settings": settings.model_dump(mode="json"),
                "scene": scene,
                "memory": memory.model_dump(mode="json"),
            },
        )

    def kept_scene(self) -> str:
        """The path, inside the folder, of the scene that the state points to; empty when there is none."""
        kept = self._state()
        return str(kept["scene"]) if kept else ""

    def _state(self) -> dict[str, Any] | None:
        path = self.path / STATE
        if not path.exists():
            return None
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
            if data["schema"] != SCHEMA:
                raise ValueError(data["schema"])
            return data
        except (OSError, ValueError, KeyError, TypeError):
            raise InputError(f"{path}: this is no state of a run; remove it or choose another folder") from None


def write(path: Path, data: Any) -> None:
    """Write JSON under a temporary name and rename it."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            json.dump(data, file, indent=1, ensure_ascii=False)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise
