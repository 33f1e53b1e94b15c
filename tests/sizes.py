"""Sizes of tests: a few cases in the usual run, all of them in `make bench`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest
from hypothesis import settings

WHOLE = "whole"
"""Profile of hypothesis that `make bench` chooses."""


def sizes(name: str, usual: Any, whole: Any) -> pytest.MarkDecorator:
    """The test with a small size, and again as a long one with the whole."""
    return pytest.mark.parametrize(
        name, [pytest.param(usual, id="some"), pytest.param(whole, id="all", marks=pytest.mark.slow)]
    )


def often(names: Iterable[str], usual: Iterable[str]) -> list[Any]:
    """Parameters of which only the usual ones are no long tests."""
    chosen = set(usual)
    found = [pytest.param(name, marks=[] if name in chosen else [pytest.mark.slow]) for name in names]
    assert chosen and chosen <= {param.values[0] for param in found}
    return found


def share(cases: Iterable[Any], one_in: int) -> list[Any]:
    """Parameters of which each but the first of every ``one_in`` is a long test; a tuple has several values."""
    return [
        pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=[pytest.mark.slow] if k % one_in else [])
        for k, case in enumerate(cases)
    ]


def examples(usual: int, whole: int, **more: Any) -> settings:
    """So many examples that hypothesis draws; each may take long."""
    many = settings.get_current_profile_name() == WHOLE
    return settings(max_examples=whole if many else usual, deadline=None, **more)
