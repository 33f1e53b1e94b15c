"""Values of files that others wrote, checked as they are taken: errors are one line that names file, field and fix.

``where`` is the place of a value as errors name it: ``house.json: scene.room[2].pos``. An `Entry` is a value that knows
its place, for files that are read field by field; the functions are for those that are read by arrays.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.io import InputError, load_json
from sceneweaver.io.messages import clean, is_number, path_name, quote, show, suggest

if TYPE_CHECKING:
    import numpy as np

MAX_JSON = 2**28
"""Largest JSON file [bytes] of a house or of many rooms."""

LARGEST = 1e6
"""Largest number of a file that is believed, in metres or pixels."""

FARTHEST = 1e4
"""Largest coordinate [m] of a scene: beyond it a file is in another unit, or damaged."""

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
        raise _missing(found, key, where, fix)
    return found[key]


def mapping(value: Any, where: str) -> Mapping[str, Any]:
    """The value, where it is an object.

    Raises:
        InputError: where it is none.
    """
    if not isinstance(value, Mapping):
        raise InputError(f'{where}: must be an object {{"...": ...}}, not {show(value)}; is this file of that format?')
    return value


def sequence(value: Any, where: str) -> Sequence[Any]:
    """The value, where it is a list.

    Raises:
        InputError: where it is none.
    """
    if not isinstance(value, list | tuple):
        raise InputError(f"{where}: must be a list [...], not {show(value)}; is this file of that format?")
    return value


def number(value: Any, where: str, low: float = -math.inf, high: float = math.inf) -> float:
    """The value, where it is a finite number within limits.

    Raises:
        InputError: where it is none.
    """
    if not is_number(value):
        raise InputError(f"{where}: must be a number, not {show(value)}")
    if not math.isfinite(value):
        raise InputError(f"{where}: {show(float(value))}; numbers must be finite")
    if not low <= value <= high:
        raise InputError(f"{where}: must lie in {low:g} .. {high:g}, not {show(value)}")
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
    _lengths(size.tolist(), where)
    return size


def word(value: Any, otherwise: str = "") -> str:
    """A text as it stands, a number as text, anything else as ``otherwise``."""
    if isinstance(value, str):
        return clean(value.strip()) or otherwise
    return str(value) if is_number(value) else otherwise


def _missing(found: Mapping[str, Any], key: str, where: str, fix: str = "add it") -> InputError:
    others = [str(other) for other, value in found.items() if value is not None]
    return InputError(f"{where}: {quote(key)} is missing; {fix}{suggest(key, others, what='keys')}")


def _lengths(values: Sequence[float], where: str) -> tuple[float, float, float]:
    if not all(value > 0 for value in values):
        raise InputError(f"{where}: {min(values):g} is no length; sizes must be positive, above 0")
    a, b, c = values
    return a, b, c


@dataclass(frozen=True, slots=True)
class Entry:
    """A value of a file's data, with the name of the file and the place of the value in it."""

    value: Any
    file: str
    place: str = ""

    @classmethod
    def of(cls, path: Path, data: Any, place: str = "") -> Entry:
        """The data of a file as an entry."""
        return cls(data, path_name(path), place)

    @property
    def where(self) -> str:
        """Its place as errors name it."""
        return f"{self.file}: {self.place}" if self.place else self.file

    def error(self, text: str) -> InputError:
        """An error that names the file and this place: ``text`` says what is wrong and the fix."""
        return InputError(f"{self.where}: {text}")

    def has(self, key: str) -> bool:
        """Whether it is an object that holds more than null under a key."""
        return isinstance(self.value, dict) and self.value.get(key) is not None

    def find(self, key: str) -> Entry | None:
        """What stands under a key, or None where that is missing or null."""
        return self[key] if self.mapping().get(key) is not None else None

    def __getitem__(self, key: str) -> Entry:
        """What has to stand under a key."""
        if (found := self.mapping()).get(key) is None:
            raise _missing(found, key, self.where)
        return Entry(self.value[key], self.file, f"{self.place}.{key}" if self.place else key)

    def get(self, key: str) -> Any:
        """The plain value under a key of an object, None where that is missing."""
        return self.mapping().get(key)

    def kept(self, *keys: str) -> dict[str, Any]:
        """The plain values under those keys that it has, for what is kept as it is."""
        return {key: self.value[key] for key in keys if key in self.mapping()}

    def words(self, key: str) -> list[str]:
        """The texts in the list under a key, whatever else is in it; a text alone is a list of one."""
        found = self.get(key)
        return [
            w
            for w in ([found] if isinstance(found, str) else found if isinstance(found, list) else [])
            if isinstance(w, str) and w
        ]

    def mapping(self) -> dict[str, Any]:
        """It as an object."""
        found = mapping(self.value, self.where)
        return found if isinstance(found, dict) else dict(found)

    def items(self) -> Iterator[tuple[str, Entry]]:
        """Names and values of an object."""
        for key, value in self.mapping().items():
            yield key, Entry(value, self.file, f"{self.place}.{key}" if self.place else key)

    def entries(self) -> Iterator[Entry]:
        """The values of a list."""
        for i, value in enumerate(sequence(self.value, self.where)):
            yield Entry(value, self.file, f"{self.place}[{i}]")

    def listed(self, key: str) -> Iterator[Entry]:
        """The values of the list under a key, none where that is missing."""
        found = self.find(key)
        return iter(()) if found is None else found.entries()

    def text(self) -> str:
        """It as text."""
        if not isinstance(self.value, str):
            raise self.error(f"must be text, not {show(self.value)}")
        return self.value

    def word(self, key: str, default: str = "") -> str:
        """The text under a key, or a default where that is missing or no text."""
        found = self.value.get(key) if isinstance(self.value, dict) else None
        return found if isinstance(found, str) and found else default

    def number(self, low: float = -FARTHEST, high: float = FARTHEST) -> float:
        """It as a finite number within limits."""
        return number(self.value, self.where, low, high)

    def length(self) -> float:
        """It as a length [m] of at least 0."""
        return self.number(0.0)

    def numbers(self, count: int, low: float = -FARTHEST, high: float = FARTHEST) -> list[float]:
        """It as a list of finite numbers."""
        values = [entry.number(low, high) for entry in self.entries()]
        if len(values) != count:
            raise self.error(f"must hold {count} numbers, not {len(values)}")
        return values

    def named(self, keys: Sequence[str], low: float = -FARTHEST, high: float = FARTHEST) -> list[float]:
        """The numbers under keys, such as x, y and z."""
        return [self[key].number(low, high) for key in keys]

    def matrix(self, rows: int, columns: int) -> np.ndarray:
        """It as rows of finite numbers, or all of them in one list, row after row."""
        import numpy as np

        listed = list(self.entries())
        if listed and isinstance(listed[0].value, list):
            found = [entry.numbers(columns) for entry in listed]
            if len(found) != rows:
                raise self.error(f"must hold {rows} rows, not {len(found)}")
            return np.array(found)
        return np.array(self.numbers(rows * columns)).reshape(rows, columns)

    def sides(self, values: Sequence[float]) -> tuple[float, float, float]:
        """Three lengths of it as a size; one of 0 is refused."""
        return _lengths(values, self.where)
