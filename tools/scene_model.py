"""Models that make scenes: the protocol that any of them fits, where one is found, and how one is asked in time."""

from __future__ import annotations

import ctypes
import math
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module, metadata
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

from sceneweaver.io.messages import shorten, suggest
from sceneweaver.scene import InputError, Room

GROUP = "sceneweaver.scene_models"
"""Entry points that name models: ``name = "package.module:attribute"``."""

SECONDS, POLL = 60.0, 0.1
"""Time [s] that a model has for one answer, and between two looks whether there is time left."""


@dataclass(frozen=True)
class SceneRequest:
    """What a model is asked for.

    Attributes:
        text: the request, in the words of whoever asks.
        kind: the kind of room that it means, such as "living_room".
        room: its shell, where the request fixes the floor; None: the model chooses one.
        categories: the things that it names, by category, with the least number of each.
        seed: equal seeds should give equal answers.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.SceneRequest("a bedroom with two lamps", kind="bedroom", categories={"table_lamp": 2}).seed
        0
    """

    text: str
    kind: str = "room"
    room: Room | None = None
    categories: Mapping[str, int] = field(default_factory=dict)
    seed: int = 0


@runtime_checkable
class SceneModel(Protocol):
    """Anything that answers a request with a scene: a network, a program, a service, a folder of its outputs.

    Examples:
        >>> import sceneweaver as sw
        >>> class Bare:
        ...     def generate(self, request):
        ...         bed = {"label": "bed", "size": [2.0, 1.6, 0.5], "position": [1.1, 2.0, 0.25], "yaw": 0.0}
        ...         return {"room": {"outline": [[0, 0], [4, 0], [4, 4], [0, 4]]}, "objects": [bed]}
        >>> isinstance(Bare(), sw.SceneModel)
        True
    """

    def generate(self, request: SceneRequest) -> Any:
        """A scene for a request.

        Returns:
            A `sceneweaver.Scene`, what a reader of `sceneweaver.importers` yields, or plain data: ``{"room":
            {"outline": [[x, y], ...], "height": 2.7}, "objects": [{"label", "size": [depth, width, height],
            "position": [x, y, z] of the box's centre, "yaw"}, ...]}`` in metres and radians, z up, yaw
            counter-clockwise from +x, which is where a thing's front looks at yaw 0. None: it has none.
        """
        ...


def scene_model(named: Any, source: str = "auto") -> SceneModel:
    """The model that a name or an object stands for.

    Args:
        named: a model, a class of one, the name of an entry point of the group ``sceneweaver.scene_models``,
            "package.module:attribute", or a path: a folder of a model's outputs, or a file with some.
        source: the format of outputs at a path; "auto" looks at each file.

    Raises:
        InputError: nothing is there, it does not load, or it is no model.
    """
    if not isinstance(named, str | Path):
        return _checked(named, f"scene_model: {type(named).__name__}")
    if Path(named).exists():
        from .model_outputs import ModelOutputs

        return ModelOutputs(Path(named), source)
    text = str(named)
    points = {point.name: point for point in metadata.entry_points(group=GROUP)}
    target = points[text].value if text in points else text
    module, colon, path = target.partition(":")
    if not colon or not path or not all(part.isidentifier() for part in (*module.split("."), *path.split("."))):
        hint = suggest(text, points) if points else ""
        raise InputError(
            f'scene_model: "{shorten(text)}" is no folder or file, no "module:attribute" and no entry point of '
            f"{GROUP}{hint}"
        )
    try:
        found = import_module(module)
        for part in path.split("."):
            found = getattr(found, part)
    except Exception as error:
        raise InputError(f"scene_model: {target} does not load: {_line(error)}") from error
    return _checked(found, f"scene_model: {target}")


def name_of(named: Any) -> str:
    """What a model is called in reports and states: its path or target, or the class of an object."""
    if isinstance(named, str | Path):
        return str(named)
    kind = named if isinstance(named, type) else type(named)
    return f"{kind.__module__}:{kind.__qualname__}"


def _checked(found: Any, label: str) -> SceneModel:
    if isinstance(found, type):
        try:
            found = found()
        except Exception as error:
            raise InputError(f"{label} cannot be made without arguments: {_line(error)}; give an object") from error
    if not callable(getattr(found, "generate", None)):
        raise InputError(f"{label} is no model; it needs a method generate(request) that returns a scene")
    return found


def asked(model: SceneModel, request: SceneRequest, seconds: float, left: Callable[[], float] = lambda: math.inf) -> Any:
    """What a model answers, in time.

    It runs in a thread of its own, which is left to itself when its time is over: an exception ends it at the next line
    of Python that it runs, and nothing waits for one that runs none.

    Args:
        model: any.
        request: what it is asked.
        seconds: how long it may take [s].
        left: seconds that the caller has left, looked at again and again.

    Raises:
        InputError: it fails, says nothing, or takes too long.
    """
    box: dict[str, Any] = {}

    def work() -> None:
        try:
            box["answer"] = model.generate(request)
        except BaseException as error:  # of a thread that nobody hears; told below
            box["error"] = error

    thread = threading.Thread(target=work, name="scene-model", daemon=True)
    thread.start()
    began = time.monotonic()
    while thread.is_alive() and (wait := min(began + seconds - time.monotonic(), left(), POLL)) > 0:
        thread.join(wait)
    if thread.is_alive():
        _broken_off(thread)
        raise InputError(f"it gave no answer within {time.monotonic() - began:.3g} s")
    error = box.get("error")
    if isinstance(error, InputError):
        raise InputError(shorten(str(error), 300)) from error
    if error is not None:
        raise InputError(f"it failed: {shorten(_line(error), 200)}") from error
    if box.get("answer") is None:
        raise InputError("it has no scene for this request")
    return box["answer"]


def _broken_off(thread: threading.Thread) -> None:
    """Have a thread end at the next line of Python that it runs."""
    if thread.ident is not None:
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread.ident), ctypes.py_object(SystemExit))


def _line(error: BaseException) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split()) if str(error) else type(error).__name__
