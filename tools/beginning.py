"""What an initialiser may begin with, as whoever asks for a design says it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from .scene_model import SceneModel


def _unlimited() -> float:
    return math.inf


@dataclass(frozen=True)
class Beginning:
    """Where scenes to begin with come from.

    Attributes:
        scenes: the folder that `init_library` chooses among; None: the scenes that come with the library.
        model: what `init_model` asks; None: there is none.
        name: what that is called.
        left: seconds that there are for an answer.
    """

    scenes: Path | None = None
    model: SceneModel | None = None
    name: str = ""
    left: Callable[[], float] = _unlimited
