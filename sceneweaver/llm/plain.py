"""What a model says as data that any file, terminal and parser can hold, or words about why it is not."""

from __future__ import annotations

import json
import math
import re
from typing import Any

from sceneweaver.scene import InputError

DEEPEST = 32
"""Levels of lists and objects in an answer at most."""

LARGEST = 2**63
"""Whole numbers of an answer are smaller."""

UNFIT = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff]"
)
"""Characters that XML cannot hold, that steer terminals, that turn the direction of writing, or halves of pairs."""


def plain(data: Any, level: int = 0) -> Any:
    """The same data without characters of `UNFIT`.

    Args:
        data: as JSON gives it.
        level: how deep inside a value it stands.

    Raises:
        InputError: for numbers that are not finite or too large, and for data that is nested too deep.
    """
    if level > DEEPEST:
        raise InputError(f"the answer is nested more than {DEEPEST} levels deep; make it flat")
    if isinstance(data, str):
        return UNFIT.sub("", data)
    if isinstance(data, dict):
        return {plain(name, level): plain(value, level + 1) for name, value in data.items()}
    if isinstance(data, list | tuple):
        return [plain(value, level + 1) for value in data]
    if isinstance(data, float) and not math.isfinite(data):
        raise InputError("the answer holds a number that is not finite; give a usual number or leave it out")
    if isinstance(data, int) and not -LARGEST < data < LARGEST:
        raise InputError("the answer holds a number of too many digits; give a usual number or leave it out")
    return data


def sendable(arguments: Any) -> Any:
    """Text, or arguments of a call as data or text, with null where `plain` would raise and without halves of pairs:
    a model that is asked again is sent what it said."""
    if not isinstance(arguments, str):
        return _sendable(arguments)
    arguments = arguments.encode("utf-8", "replace").decode()
    if "NaN" not in arguments and "Infinity" not in arguments:
        return arguments
    try:
        return json.dumps(_sendable(json.loads(arguments)))
    except (ValueError, RecursionError):
        return arguments


def _sendable(data: Any, level: int = 0) -> Any:
    if isinstance(data, dict | list) and level > DEEPEST:
        return None
    if isinstance(data, dict):
        return {_sendable(name): _sendable(value, level + 1) for name, value in data.items()}
    if isinstance(data, list):
        return [_sendable(value, level + 1) for value in data]
    if isinstance(data, str):
        return data.encode("utf-8", "replace").decode()
    if isinstance(data, float):
        return data if math.isfinite(data) else None
    return None if isinstance(data, int) and not -LARGEST < data < LARGEST else data
