"""Where the search of a first draft begins: at poses that the learned prior draws, where its weights are installed."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

import numpy as np

from sceneweaver.io import SceneWeaverError
from sceneweaver.io.messages import shorten
from sceneweaver.scene import Scene

Starts = Callable[[Scene, int, int], np.ndarray | None]
"""Poses [candidates, objects, 4] of x, y, z, yaw for a scene, a number of candidates and a seed; or None."""

NONE = "init prior: the learned prior is not installed; poses are drawn as usual"


def learned_starts() -> tuple[Starts | None, str]:
    """What draws poses, or None and why there is nothing."""
    # The prior stands on a floor of its own and brings weights that an install may be without: it is looked for by its
    # public name.
    found = getattr(import_module("sceneweaver"), "LayoutPrior", None)
    if found is None:
        return None, NONE
    try:
        prior = found.load()
    except (SceneWeaverError, OSError, ValueError) as error:
        return None, f"{NONE} ({shorten(str(error), 120)})"

    def starts(scene: Scene, candidates: int, seed: int) -> np.ndarray | None:
        try:
            return np.asarray(prior.sample(scene, candidates=candidates, seed=seed), dtype=np.float64)
        except SceneWeaverError:  # more walls or things than it looks at
            return None

    return starts, ""
