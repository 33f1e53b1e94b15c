"""Values of files that others wrote, checked as they are taken: errors are one line that names file, field and fix.

``where`` is the place of a value as errors name it: ``house.json: scene.room[2].pos``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.io import InputError, load_json
from sceneweaver.io.messages import clean, is_number, show, suggest

if TYPE_CHECKING:
    import numpy as np

MAX_JSON = 2**28
"""Largest JSON file [bytes] of a house or of many rooms."""

LARGEST = 1e6
"""Largest number of a file that is believed, in metres or pixels."""

_KEY = re.compile(rb'"([^"\\]{1,60})"\s*:')


def loaded(path: Path) -> Any:
    """The data of a JSON file.

    Raises:
        InputError: as `sceneweaver.io.load_json`.
    """
    return load_json(path, max_bytes=MAX_JSON)


def keys_seen(head: bytes) -> set[str]:
    """Keys of objects in the first bytes of a JSON file, at any depth."""
    return {key.decode("utf-8", "replace") for key in _KEY.findall(head)}


def member(data: Any, key: str, where: str, fix: str = "add it") -> Any:
    """The value of a key of an object.

    Raises:
        InputError: where there is no object, or no such key.
    """
    found = mapping(data, where)
    if key not in found:
        raise InputError(f"{where}: '{key}' is missing; {fix}{suggest(key, map(str, found), what='keys')}")
    return found[key]


def mapping(value: Any, where: str) -> Mapping[str, Any]:
    """The value, where it is an object.

    Raises:
        InputError: where it is none.
    """
    if not isinstance(value, Mapping):
        raise InputError(
            f"{where}: {show(value)} stands where an object {{...}} is needed; is this file of that format?"
        )
    return value


def sequence(value: Any, where: str) -> Sequence[Any]:
    """The value, where it is a list.

    Raises:
        InputError: where it is none.
    """
    if not isinstance(value, list | tuple):
        raise InputError(f"{where}: {show(value)} stands where a list [...] is needed; is this file of that format?")
    return value


def number(value: Any, where: str) -> float:
    """The value, where it is a finite number.

    Raises:
        InputError: where it is none.
    """
    if not is_number(value):
        raise InputError(f"{where}: {show(value)} stands where a number is needed")
    if not math.isfinite(value):
        raise InputError(f"{where}: {show(float(value))}; numbers must be finite")
    return float(value)


def numbers(value: Any, shape: tuple[int | None, ...], where: str) -> np.ndarray:
    """Finite numbers as a float64 array.

    Args:
        value: nested lists, or an array.
        shape: length of each axis; None: any.
        where: place of the value.

    Raises:
        InputError: for another shape, what is no number, NaN and infinity.
    """
    import numpy as np

    try:
        array = np.asarray(value)
    except (ValueError, OverflowError):
        array = np.asarray(None)
    wanted = " x ".join("n" if n is None else str(n) for n in shape)
    if array.size == 0 and shape[0] is None:
        return np.zeros([n or 0 for n in shape])
    if array.dtype.kind not in "iuf":
        raise InputError(f"{where}: {wanted} numbers are needed; write plain numbers in lists of equal length")
    if array.ndim != len(shape) or any(n is not None and n != m for n, m in zip(shape, array.shape, strict=True)):
        raise InputError(f"{where}: {wanted} numbers are needed, not {' x '.join(map(str, array.shape)) or 'one'}")
    array = array.astype(float)
    if not np.isfinite(array).all():
        raise InputError(f"{where}: NaN or infinity; numbers must be finite")
    if array.size and np.abs(array).max() > LARGEST:
        raise InputError(f"{where}: {np.abs(array).max():g} is too large; is the unit right?")
    return array


def positive(value: Any, where: str) -> np.ndarray:
    """Three positive numbers: a size [m].

    Raises:
        InputError: as `numbers`, and for zero and negative ones.
    """
    size = numbers(value, (3,), where)
    if (size <= 0).any():
        raise InputError(f"{where}: {size.min():g} is no length; sizes must be positive")
    return size


def word(value: Any, otherwise: str = "") -> str:
    """A text as it stands, a number as text, anything else as ``otherwise``."""
    if isinstance(value, str):
        return clean(value.strip()) or otherwise
    return str(value) if is_number(value) else otherwise
