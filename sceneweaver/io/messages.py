"""Words of error messages: names and values as one printable line, and the nearest of the names that are known."""

from __future__ import annotations

import difflib
import itertools
import json
import math
import os
from collections.abc import Iterable, Mapping

_MOST_COMPARED = 5000


def clean(text: str) -> str:
    """``text`` as one printable line."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def shorten(text: str, length: int = 60) -> str:
    """``text`` cut to ``length`` characters."""
    return text if len(text) <= length else text[: length - 3] + "..."


def printable_line(text: str, length: int) -> str:
    """``text`` as one printable line of at most ``length`` characters, whatever its size and its white space."""
    return shorten(clean(" ".join(text[: 4 * length].split())), length)


def path_name(path: str | os.PathLike[str]) -> str:
    """A path as one printable line; of a long one the beginning and the end."""
    text = clean(os.fspath(path))
    return text if len(text) <= 300 else f"{text[:60]}...{text[-200:]}"


def quote(name: object) -> str:
    """An id in single quotes."""
    return f"'{clean(shorten(str(name)))}'"


def show(value: object) -> str:
    """A value as JSON would write it, or what kind of thing it is when it is long."""
    if value is None or isinstance(value, bool):
        return json.dumps(value)
    if isinstance(value, str):
        return clean(json.dumps(shorten(value), ensure_ascii=False))
    if isinstance(value, int):
        return repr(int(value)) if value.bit_length() < 200 else "a huge number"
    if isinstance(value, float):
        value = float(value)
        return repr(value) if math.isfinite(value) else "NaN" if math.isnan(value) else f"{'-' * (value < 0)}Infinity"
    if isinstance(value, Mapping):
        return "an object"
    if isinstance(value, list | tuple):
        return "a list"
    return f"of type {type(value).__name__}"


def is_number(value: object) -> bool:
    """Whether a value is a number, which True is not here."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def nearest(name: object, options: Iterable[str]) -> str | None:
    """The option most like ``name``, ignoring case, or None when none is close."""
    folded = {option.casefold(): option for option in reversed(list(itertools.islice(options, _MOST_COMPARED)))}
    word = str(name)[:80].casefold()
    found = difflib.get_close_matches(word, folded, 8, 0.6)
    first = sorted(found, key=list(folded).index, reverse=True)  # of equals, the first of the options
    return folded[max(first, key=lambda f: difflib.SequenceMatcher(None, f, word).ratio())] if found else None


def suggest(name: object, options: Iterable[str], *, what: str = "known", mark: str = '"') -> str:
    """How to mend a wrong name: ``; did you mean "x"?``, or the list of options when none is close."""
    options = list(options)
    near = nearest(name, options)
    if near is not None:
        return f"; did you mean {mark}{clean(shorten(near))}{mark}?"
    if not options:
        return f"; {what}: none"
    listed = ", ".join(clean(shorten(option)) for option in options[:8])
    return f"; {what}: {listed}{', ...' if len(options) > 8 else ''}"
