"""Drawings that have to fit others: a curtain its sill, a child's seat its table."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets.parametric import make

SILL = 0.07
"""How far [m] the board of a window sill stands out of the wall."""


@pytest.mark.parametrize("category", ["curtain", "sheer_curtain"])
@pytest.mark.parametrize("seed", range(6))
def test_a_curtain_hangs_clear_of_the_sill_and_of_the_glass(category, seed):
    asset = make(category, seed)
    depth, width, height = asset.size
    points = asset.mesh.vertices
    cloth = points[points[:, 2] < 0.8 * height]
    assert cloth[:, 0].min() + depth / 2 > SILL + 0.01
    middle = cloth[np.abs(cloth[:, 1]) < 0.2 * width]
    assert not len(middle), "drawn open in daylight"


@pytest.mark.parametrize("seed", range(8))
def test_a_child_sits_right_at_its_table(seed):
    chair, table = make("kids_chair", seed), make("kids_table", 3 * seed + 1)
    seat = 0.52 * chair.size[2]
    assert 0.2 <= table.size[2] - seat <= 0.28
