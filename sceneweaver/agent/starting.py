"""What a design begins with, from the arguments that say it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast, get_args

from sceneweaver.io.messages import quote, suggest
from sceneweaver.runtime.options import Init
from sceneweaver.scene import InputError, Palette, Room, Scene
from sceneweaver.tools.beginning import Beginning
from sceneweaver.tools.found_models import name_of, scene_model
from sceneweaver.tools.model_outputs import ModelOutputs
from sceneweaver.tools.scene_files import GivenScene
from sceneweaver.tools.scene_model import SceneModel, SceneRequest

from .settings import Begin

TOOLS: Mapping[str, str] = {
    "library": "init_library",
    "model": "init_model",
    "llm": "init_llm",
    "prior": "init_prior",
    "start": "init_model",
}
"""The initialiser that each way to begin calls."""

GOES_WITH = {"scenes": "library", "scene_model": "model"}
"""Arguments that go with one way to begin, and mean it."""


@dataclass(frozen=True)
class Starting:
    """What a design begins with.

    Attributes:
        scenes: a folder to choose among.
        model: what is asked for a scene.
        kept: what of it the settings of a run keep.
    """

    scenes: Path | None = None
    model: SceneModel | None = None
    kept: Begin = Begin()

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> Starting:
        """As the arguments of a design say: ``init``, ``scenes``, ``scene_model``, ``start``, ``source``, ``room``,
        ``palette``.

        Raises:
            InputError: words that are unknown, arguments that exclude each other, or what is not there.
        """
        init, start, source = given["init"], given["start"], given["source"]
        if init not in get_args(Init):
            raise InputError(f"init: {quote(init)} is unknown{suggest(str(init), get_args(Init))}")
        for name, way in GOES_WITH.items():
            if given[name] is None:
                continue
            if start is not None:
                raise InputError(f"start: a scene to go on from leaves no choice of a beginning; leave out {name}")
            if init not in ("auto", way):
                raise InputError(f"init: {init} does not go with {name}; leave one of them out, or give init {way}")
            init = way
        if start is not None and init != "auto":
            raise InputError(f"start: a scene to go on from leaves no choice of a beginning; leave out init {init}")
        if init == "model" and given["scene_model"] is None:
            raise InputError(
                'init: model needs scene_model: "module:attribute", an entry point, or a folder of outputs'
            )
        if not isinstance(source, str):
            raise InputError(f"source: {source!r} is no name of a format")
        scenes = Path(given["scenes"]) if given["scenes"] is not None else None
        if scenes is not None and not scenes.is_dir():
            raise InputError(f"scenes: '{scenes}' is no folder; give one that holds scenes")
        model = None
        if start is not None:
            model = _gone_on_from(start, source)
        elif given["scene_model"] is not None:
            model = scene_model(given["scene_model"], source)
        room, palette = _shell(given, init), given["palette"]
        if not isinstance(palette, Palette | None):
            raise InputError(f"palette: {type(palette).__name__} is no palette; give scene.palette of some scene")
        kept = Begin(
            init=cast("Init", init),
            scenes=str(scenes) if scenes is not None else None,
            scene_model=name_of(given["scene_model"]) if given["scene_model"] is not None else None,
            start=_name(start) if start is not None else None,
            source=source,
            room=room,
            palette=palette,
        )
        return cls(scenes, model, kept)

    @property
    def name(self) -> str:
        """What the model, or the scene to go on from, is called."""
        return self.kept.start or self.kept.scene_model or ""

    @property
    def tool(self) -> str | None:
        """The initialiser that begins; None: whichever the planner likes."""
        return TOOLS["start"] if self.kept.start is not None else TOOLS.get(self.kept.init)

    @property
    def alone(self) -> bool:
        """Whether a draft of our own is all that can begin: a shell that is given takes no other scene's furniture."""
        return self.kept.room is not None

    @property
    def by_model(self) -> bool:
        """Whether a language model writes the room down."""
        return self.kept.init == "llm"

    def beginning(self, left: Callable[[], float]) -> Beginning:
        """What tools are told of it."""
        return Beginning(self.scenes, self.model, self.name, left)

    def prompt(self, prompt: str) -> str:
        """The request; without one that for which the scene to go on from was made.

        Raises:
            InputError: the file of that scene is damaged, or holds none.
        """
        if self.kept.room is not None and not prompt.strip():
            kind = self.kept.room.type.replace("_", " ")
            return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}"
        if self.kept.start is None or self.model is None:
            return prompt
        made = self.model.generate(SceneRequest(prompt or ""))
        return prompt or (made.scene.prompt if isinstance(made, GivenScene) else "")


def check_tools(starting: Starting, tools: Collection[str]) -> None:
    """InputError where the tool that is to begin may not be used."""
    if starting.tool is not None and starting.tool not in tools:
        raise InputError(f"init: {starting.kept.init} needs the tool {starting.tool}, which tools leaves out")


@dataclass(frozen=True)
class _Same:
    """A scene that is there already, as a model."""

    given: GivenScene

    def generate(self, request: SceneRequest) -> GivenScene:
        """That scene."""
        return self.given


def _gone_on_from(start: Any, source: str) -> SceneModel:
    if isinstance(start, Scene):
        return _Same(GivenScene(start))
    if not isinstance(start, str | Path):
        raise InputError(f"start: {type(start).__name__} is no scene; give a Scene or a path")
    path, name = Path(start), ""
    if not path.exists() and "#" in path.name:
        text, _, name = str(start).rpartition("#")
        path = Path(text)
    if not path.exists():
        raise InputError(f"start: '{path}' is not there; give the file of a scene")
    if path.is_dir() and (path / "scene.json").is_file():
        path = path / "scene.json"
    return ModelOutputs(path, source, name)


def _shell(given: Mapping[str, Any], init: str) -> Room | None:
    """The room that is to be furnished; None: one is drawn."""
    room = given["room"]
    if not isinstance(room, Room | None):
        raise InputError(f"room: {type(room).__name__} is no room; give a Room, such as scene.room of some scene")
    if room is not None:
        told = "start" if given["start"] is not None else f"init {init}" if init not in ("auto", "prior") else ""
        if told:
            raise InputError(f"room: a shell that is given is furnished from a draft of our own; leave out {told}")
    return room


def _name(start: Any) -> str:
    return f"scene {start.id}" if isinstance(start, Scene) else str(start)
