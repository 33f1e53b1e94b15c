"""JSON that somebody else wrote: one reading, bounded before it takes memory, with errors that name the place."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from .errors import InputError
from .messages import path_name, quote, show
from .reading import MAX_BYTES, MAX_UNPACKED, Place, lines_unpacked, read_bytes, read_unpacked

MAX_CONTAINERS = 10_000_000
"""Lists and objects of a text: in memory they take far more than in the file."""

WANTED = "JSON, such as {...}"

MAX_LINE = 64 * 2**20
"""Largest line [bytes] of a file with an object a line."""


def parse_json(text: str | bytes, *, wanted: str = WANTED, unique: bool = True) -> Any:
    """JSON text as data.

    Args:
        text: the text; bytes are UTF-8.
        wanted: what to give, where there is nothing.
        unique: whether a key twice in one object is refused; looking takes longer than reading.

    Raises:
        InputError: not UTF-8, not JSON (with line and column), cut off, a key twice, nested too deep, too large.
    """
    if isinstance(text, bytes):
        try:
            text = text.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise InputError(f"not UTF-8 text (byte {error.start}); save the file as UTF-8") from None
    if not text.strip():
        raise InputError(f"the file is empty; give {wanted}")
    if text.count("{") + text.count("[") > MAX_CONTAINERS:
        raise InputError(f"invalid JSON: over {MAX_CONTAINERS} lists and objects; split it into smaller files")
    try:
        return json.loads(text, object_pairs_hook=_unique if unique else None)
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        if error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated string"):
            text = f"invalid JSON: it ends too early, at {where} ({error.msg}); is the file cut off?"
            raise InputError(text) from None
        raise InputError(f"invalid JSON at {where}: {error.msg}") from None
    except RecursionError:
        raise InputError("invalid JSON: nested too deep; fewer than 40 levels are needed") from None
    except InputError:
        raise
    except ValueError:  # Python refuses to convert integers of thousands of digits
        raise InputError("invalid JSON: a number has too many digits; numbers must fit a double") from None


def load_json(path: Place, *, max_bytes: int = MAX_BYTES, wanted: str = WANTED) -> Any:
    """The data of a JSON file.

    Raises:
        InputError: as `read_bytes` and `parse_json`, naming the file.
    """
    return _named(path, read_bytes(path, max_bytes=max_bytes), wanted, True)


def load_packed_json(path: Place, *, max_bytes: int = MAX_UNPACKED) -> Any:
    """The data of a large JSON file, unpacked where its name ends in ``.gz``; as `load_json`, but keys may repeat."""
    return _named(path, read_unpacked(path, max_bytes=max_bytes), WANTED, False)


def load_json_lines(path: Place, *, max_bytes: int = MAX_UNPACKED) -> Iterator[Any]:
    """The values of a file with one a line, one by one; errors as `load_json`, with the number of the line."""
    for number, row in enumerate(lines_unpacked(path, max_bytes=max_bytes), 1):
        if len(row) > MAX_LINE:
            raise InputError(f"{path_name(path)}: line {number} has over {MAX_LINE >> 20} MB")
        if row.strip():
            try:
                yield parse_json(row, unique=False)
            except InputError as error:
                raise InputError(f"{path_name(path)}: line {number}: {error}") from None


def _named(path: Place, text: bytes, wanted: str, unique: bool) -> Any:
    try:
        return parse_json(text, wanted=wanted, unique=unique)
    except InputError as error:
        raise InputError(f"{path_name(path)}: {error}") from None


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    data = dict(pairs)
    if len(data) < len(pairs):
        keys = [key for key, _ in pairs]
        twice = next(key for key in keys if keys.count(key) > 1)
        name = data.get("id")
        where = f" of {quote(name)}" if isinstance(name, str) else ""
        raise InputError(f"invalid JSON: key {show(twice)} stands twice in one object{where}; remove one")
    return data
