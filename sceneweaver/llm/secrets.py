"""Takes keys out of everything that is kept or said: records, errors, logs, and what a model answers.

All secret values of the environment count, not only the key of the endpoint: a server may echo any of them.
"""

from __future__ import annotations

import logging
import os
import re
from collections.abc import Iterator
from typing import Any, TypeVar
from urllib.parse import unquote, urlsplit

from .encodings import HIDDEN as HIDDEN
from .encodings import SHORTEST, Cleaner

SECRET_NAMES = re.compile(r"(API_?KEY|_TOKEN|_SECRET|PASSWORD|PASSWD|(ADMIN|ACCESS|SECRET|SIGNING|PRIVATE)_KEY)$", re.I)
"""Variables of the environment that hold secrets."""

PROXY_NAMES = re.compile(r"_proxy$", re.I)
"""Variables that may hold a URL with a password."""

LOGGERS = ("httpx2", "httpcore2", "httpx", "httpcore", "openai", "anthropic", "pydantic_ai", "sceneweaver")
"""Libraries whose log records are looked at, with all that is below them."""

Value = TypeVar("Value")

_cleaners: dict[int, Cleaner] = {}


def redact(value: Value) -> Value:
    """A value without any secret of the environment: text, or lists, tuples and dictionaries of such.

    `sceneweaver.llm.encodings` says in which forms they are found; also in parts, from text to text.
    """
    names: list[str] = []
    said: list[str] = []
    _leaves(value, names, said)
    cleaner = _cleaner()
    clean_names, clean_said = cleaner.clean(names), cleaner.clean(said)
    if clean_names == names and clean_said == said:
        return value
    return _filled(value, iter(clean_names), iter(clean_said))


def line(text: object, most: int = 300) -> str:
    """One line of what a server or a library says, without secrets, for an error."""
    words = " ".join(redact(str(text)).split())
    return words if len(words) <= most else words[: most - 3] + "..."


def guard_logs() -> None:
    """Let no log record of the libraries that talk to models hold a secret; call it again when more are loaded."""
    known = [name for name in list(logging.root.manager.loggerDict) if name.partition(".")[0] in LOGGERS]
    deeper = ("httpcore2.connection", "httpcore2.http11", "httpcore2.http2", "httpcore2.proxy", "httpcore2.socks")
    for name in {*LOGGERS, *deeper, *known}:
        logging.getLogger(name).addFilter(_FILTER)


class _LogFilter(logging.Filter):
    def filter(self, record: logging.LogRecord) -> bool:
        said = record.getMessage()
        if (clean := redact(said)) != said:
            record.msg, record.args = clean, None
        if record.exc_info:
            record.exc_text = redact(logging.Formatter().formatException(record.exc_info))
            record.exc_info = None
        return True


_FILTER = _LogFilter()


def _cleaner() -> Cleaner:
    found = hash(frozenset(_secrets()))
    if found not in _cleaners:
        _cleaners.clear()
        _cleaners[found] = Cleaner(_secrets())
    return _cleaners[found]


def _secrets() -> Iterator[str]:
    for name in os.environ:
        if SECRET_NAMES.search(name):
            yield from (part for part in {os.environ[name], os.environ[name].strip()} if len(part) >= SHORTEST)
        elif PROXY_NAMES.search(name):
            yield from (part for part in _passwords(name) if len(part) >= SHORTEST)


def _passwords(name: str) -> Iterator[str]:
    try:
        yield from {urlsplit(os.environ[name]).password or "", unquote(urlsplit(os.environ[name]).password or "")}
    except ValueError:
        yield os.environ[name]


def _leaves(value: Any, names: list[str], said: list[str]) -> None:
    """Texts and whole numbers of a value, in order; names of fields apart, as they stand between the parts of a key."""
    if isinstance(value, str):
        said.append(value)
    elif isinstance(value, int) and not isinstance(value, bool):
        said.append(str(value))
    elif isinstance(value, dict):
        for key, held in value.items():
            _leaves(key, names, names)
            _leaves(held, names, said)
    elif isinstance(value, list | tuple):
        for held in value:
            _leaves(held, names, said)


def _filled(value: Any, names: Iterator[str], said: Iterator[str]) -> Any:
    """The value with cleaned texts in the place of its own, in the order of `_leaves`."""
    if isinstance(value, str):
        return next(said)
    if isinstance(value, int) and not isinstance(value, bool):
        return value if (text := next(said)) == str(value) else text
    if isinstance(value, dict):
        return {_filled(key, names, names): _filled(held, names, said) for key, held in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(_filled(held, names, said) for held in value)
    return value
