"""Cracks, sheets over furniture, spills and age: what a posture adds to a drawing or does to its finishes."""

import numpy as np
import pytest

from sceneweaver.assets import Wish
from sceneweaver.assets.drawing.aged import aged
from sceneweaver.assets.drawing.marks import levels
from sceneweaver.assets.materials import finish
from sceneweaver.assets.sources.parametric import ParametricSource


def made(category, posture=None, size=(None, None, None)):
    source = ParametricSource()
    (card,) = source.find(category, Wish(count=1, posture=posture, size=size, beyond=True))
    return source.load(card.id)


@pytest.mark.parametrize("category", ["wall_mirror", "vase", "plate"])
def test_cracks_lie_on_what_is_seen_of_a_thing(category):
    whole, cracked = made(category), made(category, "cracked")
    assert len(cracked.mesh.faces) > len(whole.mesh.faces) + 40
    assert cracked.size == pytest.approx(whole.size, abs=2e-3)
    assert cracked.attributes["posture"] == "cracked"


def test_a_sheet_covers_a_sofa_down_to_the_floor():
    bare, sheeted = made("sofa"), made("sofa", "sheeted")
    new = sheeted.mesh.vertices[len(bare.mesh.vertices) :]
    assert new[:, 2].min() == pytest.approx(0.0, abs=0.02)
    assert new[:, 2].max() > bare.size[2]
    assert np.ptp(new[:, 1]) > bare.size[1]
    assert sheeted.hulls and sheeted.attributes["posture"] == "sheeted"


def test_what_is_spilled_lies_flat_beside_its_vessel():
    lying = made("wine_glass", "spilled")
    low = lying.mesh.vertices[lying.mesh.vertices[:, 2] < 1e-3]
    assert np.ptp(low[:, 1]) > 0.05
    assert lying.attributes["posture"] == "spilled"


def test_dust_makes_a_bookcase_paler_and_rust_takes_metal_alone():
    clean, dusty = made("bookcase"), made("bookcase", "dusty")
    assert dusty.mesh.materials != clean.mesh.materials
    assert all(m.roughness >= 0.9 for m in dusty.mesh.materials)
    steel, oak = finish("brushed steel").material, finish("oak").material
    assert aged([oak], "rusty") == [oak]
    assert aged([steel], "rusty")[0].metallic < 0.5
    assert aged([oak], None) == [oak]


def test_what_shines_stays_clean():
    flame = finish("flame").material
    assert aged([flame], "dirty") == [flame]


def test_a_candle_that_is_out_has_no_flame():
    assert any(m.called("flame") for m in made("candle").mesh.materials)
    assert not any(m.emission > 0 for m in made("candle", "unlit").mesh.materials)


@pytest.mark.parametrize("posture", ["rolled_up", "half_unrolled", "unrolled"])
def test_a_map_is_as_far_unrolled_as_is_said(posture):
    size = (0.05, 0.7, 0.05) if posture == "rolled_up" else (None, None, None)
    assert made("table_map", posture, size).attributes["posture"] == posture


def test_levels_are_those_of_the_highest_triangle():
    low = np.array([[[0, 0, 0], [2, 0, 0], [0, 2, 0]]], dtype=float)
    both = np.concatenate([low, low + (0, 0, 1)])
    found = levels(both, np.array([[0.5, 0.5], [3.0, 3.0]]), 2)
    assert found[0] == pytest.approx(1.0)
    assert found[1] == -np.inf
