"""A design that is made again from the records of one: its request, roles and settings, unless they are given."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sceneweaver.io import parse_json, read_bytes
from sceneweaver.scene import InputError

from .folder import RunFolder, State
from .roles import Roles
from .settings import Settings

FREE = ("device", "seconds")
"""Settings that may differ from those of the recorded run."""


def recorded(folder: Path) -> State:
    """The state of a recorded run.

    Raises:
        InputError: when the folder holds none, one in which no model was asked, or one that was cut off.
    """
    state = RunFolder(folder).kept()
    if state is None:
        raise InputError(f"replay: {folder} holds no run; give the folder of a design that asked a model")
    if not state.roles.by_model and state.settings.begin.init != "llm":
        raise InputError(f"replay: no model was asked in the run in {folder}; it needs none to be made again")
    if cut_off := _cut_off(folder):
        raise InputError(
            f"replay: the run in {folder} was cut off ({cut_off}), which no replay does at the same moment; "
            "let it go on there to its end first"
        )
    return state


def _cut_off(folder: Path) -> str:
    """What ended a run before it was done; empty where nothing did, or its results were never written."""
    try:
        metrics = parse_json(read_bytes(folder / "metrics.json"))
    except InputError:
        return ""
    return str(metrics.get("cut_off") or "") if isinstance(metrics, dict) else ""


def prompt_of(state: State, prompt: str) -> str:
    """The request; one that is given has to be that of the record."""
    if prompt and prompt != state.prompt:
        raise InputError(
            f"replay: the recorded run is of another request ({state.prompt[:60]!r}); leave the request out"
        )
    return state.prompt


def settings_of(state: State, given: Mapping[str, Any]) -> Settings:
    """The settings of the record; one that is given and not at its default has to be the same there."""
    wanted = Settings(**given)
    update: dict[str, Any] = {}
    for name, field in Settings.model_fields.items():
        value, kept = getattr(wanted, name), getattr(state.settings, name)
        if value == field.get_default():
            update[name] = kept
        elif name not in FREE and value != kept:
            raise InputError(f"replay: the recorded run has {name} {kept!r}, not {value!r}; leave it out")
    return wanted.model_copy(update=update)


def roles_of(state: State, planner: str, reader: str | None, critic: str | None, samples: int) -> Roles:
    """The roles of the record; those that are given have to be the same there."""
    kept = state.roles
    given = {
        "planner": None if planner == "rules" else planner,
        "reader": reader,
        "critic": critic,
        "samples": None if samples == 1 else samples,
    }
    for name, value in given.items():
        if value is not None and value != getattr(kept, name):
            raise InputError(f"replay: the recorded run has {name} {getattr(kept, name)}, not {value}; leave it out")
    return kept
