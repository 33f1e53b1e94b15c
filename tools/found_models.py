"""Where a model of scenes is found: an object, a name in Python, or a folder of what it has made."""

from __future__ import annotations

from importlib import import_module, metadata
from pathlib import Path
from typing import Any

from sceneweaver.io.messages import shorten, suggest
from sceneweaver.scene import InputError

from .model_outputs import ModelOutputs
from .scene_model import SceneModel, line_of

GROUP = "sceneweaver.scene_models"
"""Entry points that name models: ``name = "package.module:attribute"``."""


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
        raise InputError(f"scene_model: {target} does not load: {line_of(error)}") from error
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
            raise InputError(f"{label} cannot be made without arguments: {line_of(error)}; give an object") from error
    if not callable(getattr(found, "generate", None)):
        raise InputError(f"{label} is no model; it needs a method generate(request) that returns a scene")
    return found
