"""Pieces of one suite match: kitchen units of different categories and seeds look like one kitchen."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library, Wish
from sceneweaver.assets.body import Material
from tests.sizes import share

UNITS = ("kitchen_cabinet", "kitchen_counter", "corner_cabinet", "sink_cabinet", "wall_cabinet")
TOPPED = ("kitchen_cabinet", "kitchen_counter", "corner_cabinet", "sink_cabinet", "dishwasher")
APPLIANCES = ("fridge", "stove", "dishwasher", "range_hood")


def finishes_of(category: str, suite: int | None, seed: int, style: str) -> frozenset[Material]:
    wish = Wish(size=(None, 0.6, None), style=style, seed=seed, suite=suite)
    return frozenset(Library().choose(category, 1, wish)[0].mesh.materials)


@pytest.mark.parametrize("suite", share(range(5), 3))
@pytest.mark.parametrize("style", ["modern", "rustic"])
@pytest.mark.parametrize("group", [UNITS, TOPPED, APPLIANCES])
def test_pieces_of_a_suite_share_their_finish(group, style, suite):
    drawn = [finishes_of(name, suite, 17 * k, style) for k, name in enumerate(group)]
    trifles = {"black plastic", "grey plastic", "white plastic", "black glass", "screen", "lamp glow", "rubber"}
    assert [m for m in frozenset.intersection(*drawn) if m.name not in trifles]


def test_suites_differ_and_what_is_in_none_does_as_well():
    assert len({finishes_of("kitchen_counter", suite, 0, "modern") for suite in range(8)}) > 3
    assert len({finishes_of("kitchen_counter", None, seed, "modern") for seed in range(8)}) > 3


def test_an_id_keeps_its_suite():
    asset = Library().choose("kitchen_counter", 1, Wish(suite=5))[0]
    again = Library().load(asset.id)
    assert again.mesh.materials == asset.mesh.materials and again.id == asset.id
