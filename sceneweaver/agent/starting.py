"""What a design begins with, from the arguments that say it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

from sceneweaver.io.messages import quote, suggest
from sceneweaver.runtime.options import Init
from sceneweaver.scene import InputError, Scene
from sceneweaver.tools.beginning import Beginning
from sceneweaver.tools.model_outputs import ModelOutputs
from sceneweaver.tools.scene_files import GivenScene, scenes_in
from sceneweaver.tools.scene_model import SceneModel, SceneRequest, name_of, scene_model

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
        init: the way; "auto" where nobody said.
        scenes: a folder to choose among.
        model: what is asked for a scene.
        settings: what of it the settings of a run keep, as text.
    """

    init: Init = "auto"
    scenes: Path | None = None
    model: SceneModel | None = None
    settings: Mapping[str, Any] | None = None

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> Starting:
        """As the arguments of a design say: ``init``, ``scenes``, ``scene_model``, ``start``, ``source``.

        Raises:
            InputError: words that are unknown, arguments that exclude each other, or what is not there.
        """
        init, start, source = given["init"], given["start"], given["source"]
        if init not in get_args(Init):
            raise InputError(f"init: {quote(str(init))} is unknown{suggest(str(init), get_args(Init))}")
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
            raise InputError('init: model needs scene_model: "module:attribute", an entry point, or a folder of outputs')
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
        kept = {
            "init": init,
            "scenes": str(scenes) if scenes is not None else None,
            "scene_model": name_of(given["scene_model"]) if given["scene_model"] is not None else None,
            "start": _name(start) if start is not None else None,
            "source": source,
        }
        return cls(init, scenes, model, kept)

    @property
    def name(self) -> str:
        """What the model, or the scene to go on from, is called."""
        kept = self.settings or {}
        return kept.get("start") or kept.get("scene_model") or ""

    @property
    def tool(self) -> str | None:
        """The initialiser that begins; None: whichever the planner likes."""
        return tool_of(self.init, (self.settings or {}).get("start"))

    def beginning(self, left: Callable[[], float]) -> Beginning:
        """What tools are told of it."""
        return Beginning(self.scenes, self.model, self.name, left)

    def prompt(self, prompt: str) -> str:
        """The request; without one that for which the scene to go on from was made.

        Raises:
            InputError: the file of that scene is damaged, or holds none.
        """
        if (self.settings or {}).get("start") is None or self.model is None:
            return prompt
        made = self.model.generate(SceneRequest(prompt or ""))
        return prompt or (made.scene.prompt if isinstance(made, GivenScene) else "")


def tool_of(init: str, start: str | None) -> str | None:
    """The initialiser that a way to begin, or a scene to go on from, calls."""
    return TOOLS["start"] if start is not None else TOOLS.get(init)


def check_tools(starting: Starting, tools: Sequence[str]) -> None:
    """InputError where the tool that is to begin may not be used."""
    if starting.tool is not None and starting.tool not in tools:
        raise InputError(f"init: {starting.init} needs the tool {starting.tool}, which tools leaves out")


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
    if path.is_file() and not name:
        found = list(_few(path, source))
        if len(found) == 1:
            return _Same(found[0])
    return ModelOutputs(path, source, name)


def _few(path: Path, source: str) -> Sequence[GivenScene]:
    """The scenes of a file, two at most."""
    from itertools import islice

    return list(islice(scenes_in(path, source), 2))


def _name(start: Any) -> str:
    return f"scene {start.id}" if isinstance(start, Scene) else str(start)
