"""YAML that somebody else wrote: bounded before it is built, so that no text takes the process, memory or time."""

from __future__ import annotations

import re
from typing import Any

from .errors import InputError
from .messages import clean, path_name
from .reading import Place, read_bytes

MAX_BYTES = 2**20
"""Largest file [bytes]."""

MAX_DEPTH = 40
"""Lists and mappings within each other."""

MAX_NODES = 200_000
"""Lists, mappings and values of a file."""

MAX_WORD = 100_000
"""Characters of a value."""

MAX_DIGITS = 300
"""Digits of a number, more than any float has."""


_NUMBER = re.compile(r"[-+]?[0-9][0-9a-fA-FxXo_.:]*")


def load_yaml(path: Place, *, max_bytes: int = MAX_BYTES) -> Any:
    """The data of a YAML file.

    Raises:
        InputError: as `sceneweaver.io.read_bytes` and `parse_yaml`, naming the file.
    """
    return parse_yaml(read_bytes(path, max_bytes=max_bytes), path_name(path))


def parse_yaml(text: str | bytes, name: str) -> Any:
    """The data of a YAML text with plain values only: no aliases, no tags.

    Events come one by one without recursion, so that depth and size are known before anything is built: the reader in
    C ends the process on 50,000 brackets.

    Args:
        text: the text; bytes are UTF-8 or UTF-16, as YAML says.
        name: stands in errors.

    Raises:
        InputError: one line with the place and the fix.
    """
    import yaml

    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    depth = nodes = 0
    try:
        for event in yaml.parse(text, Loader=loader):
            if isinstance(event, yaml.AliasEvent) or getattr(event, "tag", None) or getattr(event, "anchor", None):
                raise InputError(f"{name}: {_line(event)}: anchors, aliases and tags are not read; write all of it out")
            if isinstance(event, yaml.CollectionStartEvent):
                depth += 1
            elif isinstance(event, yaml.CollectionEndEvent):
                depth -= 1
                continue
            elif isinstance(event, yaml.ScalarEvent) and len(event.value) > MAX_DIGITS:
                most = MAX_DIGITS if _NUMBER.fullmatch(event.value) else MAX_WORD
                if len(event.value) > most:
                    size = len(event.value)
                    raise InputError(f"{name}: {_line(event)}: a value of {size} characters; at most {most}")
            nodes += 1
            if depth > MAX_DEPTH:
                raise InputError(f"{name}: {_line(event)}: nested more than {MAX_DEPTH} deep")
            if nodes > MAX_NODES:
                raise InputError(f"{name}: more than {MAX_NODES} values; split it into smaller files")
        return yaml.load(text, Loader=loader)
    except InputError:
        raise
    except (yaml.YAMLError, ValueError, OverflowError) as error:  # also a date such as 2001-99-99, or 5,000 digits
        said = getattr(error, "problem", None) or str(error)
        mark = getattr(error, "problem_mark", None)
        where = f"line {mark.line + 1}: " if mark is not None else ""
        raise InputError(f"{name}: cannot be read as YAML ({where}{clean(' '.join(said.split()))[:120]})") from None


def dump_yaml(data: Any, **style: Any) -> str:
    """Plain data as YAML, keys in their order; ``style`` as ``yaml.safe_dump`` takes it."""
    import yaml

    return yaml.safe_dump(data, **{"sort_keys": False, "allow_unicode": True, **style})


def _line(event: Any) -> str:
    return f"line {event.start_mark.line + 1}"
