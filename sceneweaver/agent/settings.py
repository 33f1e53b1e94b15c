"""What a run of the agent may use and spend."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import Field

from sceneweaver.knowledge.small_things import CLUTTER
from sceneweaver.runtime.options import Init
from sceneweaver.scene import Palette, Room
from sceneweaver.scene.base import FrozenModel

ASKED = 4.0
"""What a point of what is not as asked weighs beside its grade, in points of the mean of all grades: more than breaches
of design rules can make up for, so what was asked for comes first."""


ON_CPU, ON_GPU = 64, 256
"""Layouts that are refined for each call where no number is given. More take longer and are not better to people's
eyes: docs/gpu.md has the figures."""


class Begin(FrozenModel):
    """What a room begins with: objects but its shell and its look as text, by the names of their classes."""

    init: Init = "auto"
    scenes: str | None = Field(default=None, description="Folder of the scenes that a library is; null: our own")
    scene_model: str | None = Field(default=None, description="What makes scenes")
    start: str | None = Field(default=None, description="The scene that is gone on from")
    source: str = Field(default="auto", description="Format of that scene, or of the outputs of the model")
    room: Room | None = Field(default=None, description="The shell that is furnished; null: one is drawn")
    palette: Palette | None = Field(default=None, description="The look of what stands in it; null: one is chosen")

    def given(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """These as arguments; of those that are given as objects the objects."""
        kept = {name: getattr(self, name) for name in type(self).model_fields}
        return {name: value if isinstance(given[name], str | None) else given[name] for name, value in kept.items()}


class Settings(FrozenModel):
    """Budgets and switches of a run; equal settings and seed give equal scenes unless a time limit cuts them off.

    ``tools`` names the only tools to use (None: all that their cards allow). The others are for ablations. Without
    ``choice`` the critic sees layouts that the engine ranks by relations alone. Without ``rules`` neither that choice
    nor the critic that the agent hears knows the design rules. Without ``reflect`` the plan is fixed
    beforehand and nothing is taken back; with ``one_shot`` the critic is heard once, after the first step, and what it
    asks for is done without looking again; without ``physics`` layouts are drawn from the relations and not optimised.
    ``begin`` says what the room begins with. ``memory_length`` and ``replans`` matter where a model plans.
    """

    seed: int = Field(default=0, ge=0, le=2**32 - 1)
    steps: int = Field(default=10, ge=1, le=100, description="Steps at most")
    side_by_side: int = Field(default=2, ge=1, le=8, description="Calls that are tried in one step")
    candidates: int | None = Field(
        default=None, ge=1, description="Layouts that are refined for each call; None: by the kind of device"
    )
    finalists: int = Field(default=10, ge=1, description="Layouts of these that the critic compares")
    generations: int = Field(
        default=4, ge=0, description="Times that the best layouts of a room are recombined to better ones"
    )
    device: str = "auto"
    seconds: float | None = Field(default=120.0, gt=0, description="Time limit [s]; None: none")
    attempts: tuple[int, int] = Field(
        default=(2, 6), description="Times that a layout is begun anew when it fails, at first and at last"
    )
    work: int = Field(default=240, ge=1, description="Attempts at a layout after which no step begins")
    to_gain: float = Field(
        default=0.3, ge=0.0, description="Stop where mending every fault would raise the mean grade by no more"
    )
    patience: int = Field(default=2, ge=1, description="Steps without progress after which to stop")
    memory_length: int = Field(default=1, ge=0, le=100, description="Last steps that a model is told of")
    replans: int = Field(
        default=3, ge=0, le=100, description="Times in a run that a model is asked again after a step in vain"
    )
    clutter: float = Field(
        default=CLUTTER, ge=0, le=1, description="How lived-in the room looks, from 0, a show room, to 1"
    )
    settle: bool = Field(default=False, description="Prefer what physics leaves alone, and keep its settled poses")
    begin: Begin = Begin()
    choice: bool = True
    rules: bool = True
    reflect: bool = True
    physics: bool = True
    one_shot: bool = False
    tools: tuple[str, ...] | None = None

    @property
    def layouts(self) -> int:
        """Layouts that are refined for each call."""
        if self.candidates is not None:
            return self.candidates
        from sceneweaver.layout.devices import pick_devices

        return ON_CPU if pick_devices(self.device)[0] == "cpu" else ON_GPU

    @property
    def children(self) -> int:
        """Layouts of a generation."""
        return max(1, self.layouts // 2)
