"""Models that make scenes: the protocol that any of them fits, and how one is asked in time."""

from __future__ import annotations

import ctypes
import math
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol, runtime_checkable

from sceneweaver.io.messages import shorten
from sceneweaver.scene import InputError, Room

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


def asked(
    model: SceneModel, request: SceneRequest, seconds: float, left: Callable[[], float] = lambda: math.inf
) -> Any:
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
        raise InputError(f"it failed: {shorten(line_of(error), 200)}") from error
    if box.get("answer") is None:
        raise InputError("it has no scene for this request")
    return box["answer"]


def _broken_off(thread: threading.Thread) -> None:
    """Have a thread end at the next line of Python that it runs."""
    if thread.ident is not None:
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread.ident), ctypes.py_object(SystemExit))


def line_of(error: BaseException) -> str:
    """An error as one line."""
    return " ".join(f"{type(error).__name__}: {error}".split()) if str(error) else type(error).__name__
