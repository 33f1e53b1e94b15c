"""A run as a folder: every step's scene, review and calls, the state to go on from, and no secrets."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, Literal

from pydantic import Field

from sceneweaver.critic import Review
from sceneweaver.io import locked, own_folder, parse_json, read_bytes, require_no_link, sweep, write_atomic
from sceneweaver.language import SceneGraph
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.base import FrozenModel
from sceneweaver.verify import Report

from .memory import Memory
from .roles import Roles
from .settings import Settings

STATE, SCENE, ORIGIN = "state.json", "scene.json", "start.json"
MAX_STATE = 16 * 2**20
"""Most bytes of a state file that are read; a run of a hundred steps writes about one million."""

UNDONE = "it goes on, or it was killed"
"""What the metrics of a scene say of its run as long as that has not ended."""

RELEVANT = (
    "seed",
    "side_by_side",
    "candidates",
    "finalists",
    "reflect",
    "physics",
    "one_shot",
    "settle",
    "clutter",
    "memory_length",
    "tools",
    "begin",
)
"""Settings that must be the same for a run to go on; budgets may grow."""


class State(FrozenModel):
    """What ``state.json`` holds: all that a run needs to go on, besides the scene that it points to."""

    _noun: ClassVar[str] = "state"

    schema_: Literal["sceneweaver.run/1"] = Field(alias="schema")
    prompt: str
    brief: dict[str, Any] = Field(default={}, description="How the request was read; for readers of the file")
    settings: Settings
    scene: str = Field(
        pattern=r"^(steps/\d+/)?scene\.json$",
        description="Path of the scene, inside the folder; of one that no step led to the run does not go on",
    )
    memory: Memory
    roles: Roles = Roles()
    read_by: str = Field(default="rules", description="Who read the request: rules, or the name of a model")
    disagreements: tuple[str, ...] = Field(default=(), description="Where a model read the request otherwise")


class RunFolder:
    """Writes a run step by step; what is in ``state.json`` is always a whole state.

    ``roles``, ``read_by`` and ``disagreements`` are written into it as well.
    """

    def __init__(self, path: Path):
        self.path = path
        self.roles, self.read_by, self.disagreements = Roles(), "rules", tuple[str, ...]()
        self._dumped: tuple[Scene, str] | None = None

    @contextmanager
    def held(self) -> Iterator[None]:
        """Make the folder, keep other processes from writing to it, and clear away what a killed run left half written.

        Raises:
            InputError: when the folder cannot be written, or another process writes to it.
        """
        try:
            self.path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"--out: {self.path} cannot be written ({error.strerror}); choose another place") from None
        own_folder(self.path / "steps")
        for place in (self.path / "views", *self.path.glob("steps/*")):
            require_no_link(place)
        with locked(self.path / SCENE, f"--out: {self.path}"):
            for folder in (self.path, self.path / "views", *self.path.glob("steps/*")):
                sweep(folder)
            yield

    def check_roles(self, roles: Roles) -> None:
        """InputError when steps of the run that stopped here were planned, read or graded by someone else."""
        kept = self.kept()
        if kept is None or not kept.memory.steps:
            return
        for name in Roles.model_fields:
            if (old := getattr(kept.roles, name)) != (new := getattr(roles, name)):
                raise InputError(f"--out: {self.path} holds a run with {name} {old}, not {new}; choose another place")

    def resume(self, brief: SceneGraph, settings: Settings) -> tuple[Memory, Scene] | None:
        """The memory and scene of the run that stopped here, if one of the same request did.

        Raises:
            InputError: when the folder holds a run of another request or other settings, or a damaged state.
        """
        kept = self.kept()
        if kept is None:
            return None
        if kept.prompt != brief.text:
            raise InputError(
                f"--out: {self.path} holds a run of another request ({kept.prompt[:60]!r}); choose another place"
            )
        for name in RELEVANT:
            if getattr(kept.settings, name) != getattr(settings, name):
                raise InputError(
                    f"--out: {self.path} holds a run with {name} {getattr(kept.settings, name)!r}, not "
                    f"{getattr(settings, name)!r}; choose another place"
                )
        led_to = kept.memory.steps and kept.scene != SCENE
        return (kept.memory, self.scene(kept.scene)) if led_to else None

    def scene(self, name: str) -> Scene:
        """The scene of a path inside the folder; InputError for one that is damaged, or lies elsewhere."""
        return Scene.load(self.path / name, within=self.path)

    def step(
        self,
        number: int,
        scene: Scene,
        report: Report,
        review: Review,
        memory: Memory,
        brief: SceneGraph,
        settings: Settings,
    ) -> None:
        """Write what a step led to, and then the state that points to it."""
        name = f"steps/{number:02d}"
        folder = self.path / name
        own_folder(folder)
        self._save(scene, folder / "scene.json")
        self._write(folder / "metrics.json", report.to_json() + "\n")
        self._write(folder / "review.json", _text(review.model_dump(mode="json")))
        last = memory.steps[-1] if memory.steps else None
        self._write(folder / "step.json", _text(last.model_dump(mode="json", exclude={"plan"}) if last else {}))
        if last is not None and last.plan is not None:
            self._write(folder / "plan.json", _text(last.plan.model_dump(mode="json")))
        self.state(f"{name}/scene.json", memory, brief, settings)

    def keep(self, scene: Scene, report: Report) -> None:
        """Write the best valid scene so far as the scene of the folder: it is there however the run ends."""
        self._save(scene, self.path / SCENE)
        self._write(self.path / "metrics.json", replace(report, cut_off=report.cut_off or UNDONE).to_json() + "\n")

    def began(self, scene: Scene) -> None:
        """Write the scene of somebody else that the run began with, as it was."""
        self._write(self.path / ORIGIN, scene.dumps())

    def origin(self) -> Scene | None:
        """That scene; None where the run began with none."""
        return self.scene(ORIGIN) if (self.path / ORIGIN).exists() else None

    def _save(self, scene: Scene, path: Path) -> None:
        """Write a scene. What a step leads to is most often what the folder keeps too: its text is made once."""
        if self._dumped is None or self._dumped[0] is not scene:
            self._dumped = (scene, scene.dumps())
        self._write(path, self._dumped[1])

    def _write(self, path: Path, text: str) -> None:
        """Write a file of the run, in its own folder."""
        write_atomic(path, text, within=self.path)

    def state(self, scene: str, memory: Memory, brief: SceneGraph, settings: Settings) -> None:
        """Write the state to go on from; ``scene`` is a path inside the folder."""
        state = State(
            schema="sceneweaver.run/1",
            prompt=brief.text,
            brief=brief.model_dump(mode="json"),
            settings=settings,
            scene=scene,
            memory=memory,
            roles=self.roles,
            read_by=self.read_by,
            disagreements=self.disagreements,
        )
        self._write(self.path / STATE, _text(state.model_dump(mode="json")))

    def kept_scene(self) -> str:
        """The path, inside the folder, of the scene that the state points to; without a state the folder's own."""
        kept = self.kept()
        return kept.scene if kept else SCENE

    def kept(self) -> State | None:
        """The state that is there, if any; InputError names the file, the field and the fix."""
        path = self.path / STATE
        if not path.exists() and not path.is_symlink():
            return None
        try:
            return State.model_validate(parse_json(read_bytes(path, max_bytes=MAX_STATE, within=self.path)))
        except InputError as error:
            reason = str(error).removeprefix(f"{path}: ").partition("; ")[0]
            raise InputError(
                f"{path}: this is no state of a run ({reason}); remove it or choose another folder"
            ) from None


def _text(data: Any) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"
