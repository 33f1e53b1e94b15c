"""Caches that keep a number of bytes count what they keep about as large as it is."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterable
from types import FunctionType, ModuleType
from typing import Any

import numpy as np
import pytest

from sceneweaver.assets.parametric import Request
from sceneweaver.assets.parametric.drawings import Drawings
from sceneweaver.physics import hulls

SAMPLE = ("desk", "chair", "bookcase", "floor_lamp", "wardrobe", "toddler_bed", "mug", "potted_plant", "sofa")


def deep_size(values: Iterable[Any]) -> int:
    """Bytes of some values with all that they refer to, but for code."""
    seen, rest, total = set[int](), list(values), 0
    while rest:
        value = rest.pop()
        if id(value) in seen or isinstance(value, type | ModuleType | FunctionType):
            continue
        seen.add(id(value))
        total += sys.getsizeof(value)
        rest += [value.base] if isinstance(value, np.ndarray) else gc.get_referents(value)
    return total


@pytest.fixture(scope="module")
def drawn() -> Drawings:
    drawings = Drawings(2**30)
    for name in SAMPLE:
        for seed in range(4):
            drawings.get(name, seed, Request())
    return drawings


def test_drawings(drawn: Drawings):
    assert drawn.nbytes == pytest.approx(deep_size([drawn._assets]), rel=0.3)


def test_what_leads_to_drawings(drawn: Drawings):
    assert drawn._steps.nbytes == pytest.approx(deep_size([drawn._steps._values]), rel=0.4)


def test_parts_of_assets(drawn: Drawings):
    merged = [tuple(hulls.merged_hulls(asset)) for asset, _ in drawn._assets.values()]
    assert sum(map(hulls._MERGED._size, merged)) == pytest.approx(deep_size(merged), rel=0.4)
