"""A key that must turn up nowhere: planted in the environment, then looked for in all that a run leaves behind.

    with planted() as key:
        try:
            design(..., out=folder)
        except Exception as error:
            key.raised(error)
        key.assert_nowhere(folder, capfd.readouterr())

`key.environment` is for runs in a process of their own. Log records of all loggers at DEBUG are kept from `with` on.
"""

from __future__ import annotations

import contextlib
import logging
import os
import traceback
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any
from unittest import mock

from tests.llm.hiding_places import blobs, forms, found_in

KEY = "sk-plant/QZ7+x9Vw3kR8tY2mB6nL4pD1sF5hJ0cA_gE-uXoI=="
"""Looks like one, and differs in each form: in URLs, base64, JSON."""

NAMES = ("SCENEWEAVER_API_KEY", "OPENAI_API_KEY", "ANTHROPIC_API_KEY")
TALKATIVE = {"OPENAI_LOG": "debug", "ANTHROPIC_LOG": "debug"}
LOGGERS = ("openai", "anthropic", "httpx2", "httpcore2", "httpx", "httpcore", "pydantic_ai", "sceneweaver", "asyncio")


@dataclass
class Planted:
    """A planted key and what was gathered since.

    Attributes:
        key: the key.
        environment: what a process of its own is to be given.
        said: all log records and tracebacks, as text.

    None of it is shown by `repr`, as it is a local variable of the tests whose tracebacks are looked at.
    """

    key: str = field(default=KEY, repr=False)
    environment: dict[str, str] = field(default_factory=dict, repr=False)
    said: list[str] = field(default_factory=list, repr=False)

    def raised(self, error: BaseException) -> BaseException:
        """Keeps an exception's traceback with the local variables of every frame, and of all that led to it."""
        known: set[int] = set()
        chain: list[BaseException | None] = [error]
        while chain:
            one = chain.pop()
            if one is None or id(one) in known:
                continue
            known.add(id(one))
            told = traceback.TracebackException.from_exception(one, capture_locals=True)
            self.said += [*told.format(), str(one), repr(one), repr(one.args), repr(vars(one))]
            chain += [one.__cause__, one.__context__, *getattr(one, "exceptions", ())]
        return error

    def assert_nowhere(self, *places: Any) -> None:
        """Fails when the key, or a good part of it, is in a file of a folder, in captured output or in what was said.

        Args:
            *places: folders and files (`Path`), texts, bytes, and tuples of texts such as `capfd.readouterr()`.
        """
        wanted = forms(self.key)
        for i, text in enumerate(self.said):
            assert (form := found_in(text.encode(errors="replace"), wanted)) is None, (
                f"the key ({form}) is in what was said, number {i}: ...{text[-400:]}"
            )
        for place in places:
            for where, data in blobs(place):
                assert (form := found_in(data, wanted)) is None, f"the key ({form}) is in {where}"


@contextlib.contextmanager
def planted(key: str = KEY) -> Iterator[Planted]:
    """The key under every name that an endpoint knows, and every library told to log all it can."""
    found = Planted(key, {**os.environ, **dict.fromkeys(NAMES, key), **TALKATIVE})
    handler = _Keeper(found)
    loggers = [logging.getLogger(), *map(logging.getLogger, LOGGERS)]
    levels = [logger.level for logger in loggers]
    with mock.patch.dict(os.environ, {**dict.fromkeys(NAMES, key), **TALKATIVE}):
        logging.getLogger().addHandler(handler)
        for logger in loggers:
            logger.setLevel(logging.DEBUG)
        try:
            yield found
        finally:
            logging.getLogger().removeHandler(handler)
            for logger, level in zip(loggers, levels, strict=True):
                logger.setLevel(level)


class _Keeper(logging.Handler):
    def __init__(self, kept: Planted) -> None:
        super().__init__(logging.DEBUG)
        self.kept = kept

    def emit(self, record: logging.LogRecord) -> None:
        self.kept.said.append(self.format(record))
        if record.exc_info and record.exc_info[1]:
            self.kept.raised(record.exc_info[1])
