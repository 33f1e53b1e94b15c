"""Takes keys out of everything that is kept or said: records, errors, logs, and what a model answers.

All secret values of the environment count, not only the key of the endpoint: a server may echo any of them.
"""

from __future__ import annotations

import base64
import html
import json
import logging
import os
import re
from collections.abc import Iterable, Iterator
from itertools import groupby
from operator import itemgetter
from typing import Any, TypeVar
from urllib.parse import quote, quote_plus, unquote, urlsplit

HIDDEN = "[secret]"
"""What stands where a secret was."""

SHORTEST = 8
"""Characters from which on a value is taken for a secret: local servers are given keys such as "EMPTY"."""

SECRET_NAMES = re.compile(r"(API_?KEY|_TOKEN|_SECRET|PASSWORD|PASSWD|(ADMIN|ACCESS|SECRET|SIGNING|PRIVATE)_KEY)$", re.I)
"""Variables of the environment that hold secrets."""

PROXY_NAMES = re.compile(r"_proxy$", re.I)
"""Variables that may hold a URL with a password."""

LOGGERS = ("httpx2", "httpcore2", "httpx", "httpcore", "openai", "anthropic", "pydantic_ai", "sceneweaver")
"""Libraries whose log records are looked at, with all that is below them."""

PIECE = 12
"""Characters of a key in a row that are hidden as well: half of one in one field, and half in the next."""

BREAKS = r"(?:\s|\x00|\\[nrt]|\\u000[0ad9]|[\u00ad\u200b-\u200d\u2060\ufeff])*"
"""What may stand between two characters of a secret that is still to be read: white space, plain or escaped."""

Value = TypeVar("Value")

_first = itemgetter(0)


class _Cleaner:
    """Takes certain secrets out of text. Shows none of them, wherever it is printed."""

    __slots__ = ("_pattern", "_pieces")

    def __init__(self, secrets: Iterable[str]) -> None:
        kept = list(secrets)
        forms = sorted({form for secret in kept for form in _forms(secret)}, key=len, reverse=True)
        self._pattern = re.compile("|".join(forms)) if forms else None
        self._pieces = frozenset(piece for secret in kept for piece in _pieces(secret))

    def clean(self, text: str) -> str:
        if self._pattern is None:
            return text
        text = self._pattern.sub(HIDDEN, text)
        if not any(text[at : at + PIECE] in self._pieces for at in range(len(text) - PIECE + 1)):
            return text
        hidden = bytearray(len(text))
        for at in range(len(text) - PIECE + 1):
            if text[at : at + PIECE] in self._pieces:
                hidden[at : at + PIECE] = b"\x01" * PIECE
        runs = groupby(zip(hidden, text, strict=True), _first)
        parts = ((bool(flag), "".join(letter for _, letter in run)) for flag, run in runs)
        return "".join(HIDDEN if flag else part for flag, part in parts)


_cleaners: dict[int, _Cleaner] = {}


def redact(value: Value) -> Value:
    """A value without any secret of the environment: text, or lists, tuples and dictionaries of such.

    Found as they stand, with white space in between, and in URLs, JSON, HTML, base64 and hexadecimal form.
    """
    return _redacted(value, _cleaner())


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


def _cleaner() -> _Cleaner:
    found = hash(frozenset(_secrets()))
    if found not in _cleaners:
        _cleaners.clear()
        _cleaners[found] = _Cleaner(_secrets())
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


def _pieces(secret: str) -> Iterator[str]:
    """Parts that give a key away. Paths and sentences, which some such variables hold, are words of others as well."""
    if not secret.startswith(("/", ".", "~")) and not re.search(r"\s", secret):
        yield from (secret[at : at + PIECE] for at in range(len(secret) - PIECE + 1))


def _forms(secret: str) -> Iterator[str]:
    """Regular expressions of the ways in which a secret may be written."""
    yield BREAKS.join(re.escape(character) for character in secret)
    yield re.escape(secret[::-1])
    raw = secret.encode(errors="surrogateescape")
    escaped = json.dumps(secret)[1:-1]
    yield from map(re.escape, (quote(secret, safe=""), quote_plus(secret), html.escape(secret)))
    yield from map(re.escape, (escaped, escaped.replace("/", "\\/"), json.dumps(escaped)[1:-1]))
    yield f"(?i:{raw.hex()})"
    yield "(?i:" + "".join(f"\\\\u{ord(character):04x}" for character in secret) + ")"
    for shift in range(3):  # the same bytes look different in base64 by what stands before them
        code = base64.b64encode(bytes(shift) + raw).decode().rstrip("=")
        inner = code[-(-shift * 8 // 6) : len(code) - (1 if (shift + len(raw)) % 3 else 0)]
        if len(inner) >= SHORTEST:
            yield re.escape(inner)
            yield re.escape(inner.replace("+", "-").replace("/", "_"))


def _redacted(value: Any, cleaner: _Cleaner) -> Any:
    if isinstance(value, str):
        return cleaner.clean(value)
    if isinstance(value, dict):
        return {_redacted(key, cleaner): _redacted(held, cleaner) for key, held in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(_redacted(held, cleaner) for held in value)
    return value
