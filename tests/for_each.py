"""One test for many values: a few thousand small checks take longer to report as tests of their own than to run."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

Value = TypeVar("Value")


def for_each(values: Iterable[Value]) -> Callable[[Callable[[Value], None]], Callable[[], None]]:
    """Make a test of one value a test of all: it fails with each value that fails, each named."""
    values = list(values)
    assert values

    def decorate(check: Callable[[Value], None]) -> Callable[[], None]:
        def test() -> None:
            failed: list[Exception] = []
            for value in values:
                try:
                    check(value)
                except Exception as error:
                    error.add_note(f"for {value!r}")
                    failed.append(error)
            if failed:
                raise ExceptionGroup(f"{len(failed)} of {len(values)} fail", failed)

        test.__name__, test.__qualname__, test.__doc__ = check.__name__, check.__qualname__, check.__doc__
        test.__module__ = check.__module__
        return test

    return decorate
