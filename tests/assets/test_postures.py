"""Things on their side, upside down, with doors or drawers open, curtains drawn, lamps off."""

import numpy as np
import pytest

from sceneweaver.assets import Wish
from sceneweaver.assets.sources.parametric import ParametricSource
from sceneweaver.assets.states import state_of, states


def made(category, posture=None):
    source = ParametricSource()
    (card,) = source.find(category, Wish(count=1, posture=posture))
    return source.load(card.id)


def test_a_chair_on_its_side_is_as_high_as_it_was_wide_and_rests_on_the_floor():
    upright, lying = made("chair"), made("chair", "on_side")
    assert lying.size == pytest.approx((upright.size[0], upright.size[2], upright.size[1]))
    assert lying.mesh.bounds[0, 2] == pytest.approx(0.0, abs=1e-9)
    assert min(hull.vertices[:, 2].min() for hull in lying.hulls) == pytest.approx(0.0, abs=0.01)
    assert lying.attributes["posture"] == "on_side"
    assert not lying.surfaces and not lying.zones


def test_an_open_drawer_stands_out_of_the_front_and_can_go_back_in():
    closed, open_ = made("dresser"), made("dresser", "drawer_out")
    assert open_.size[0] > closed.size[0] + 0.15
    assert open_.size[1:] == closed.size[1:]
    assert sum(link.limits[0] < -0.1 for link in open_.links if link.role == "drawer") == 1


def test_all_of_an_opened_body_is_inside_its_prisms():
    asset = made("wardrobe", "half_opened")
    top = max(part.z[1] for part in asset.parts)
    assert top == pytest.approx(asset.size[2], abs=2e-3)
    corners = np.concatenate([np.array(part.polygon) for part in asset.parts])
    assert corners[:, 0].max() == pytest.approx(asset.size[0] / 2, abs=2e-3)


def test_a_posture_that_a_thing_has_no_part_for_is_not_claimed():
    assert "posture" not in made("stool", "drawer_out").attributes
    assert "posture" not in made("chair", "closed").attributes


def test_a_lamp_that_is_off_does_not_shine():
    assert max(m.emission for m in made("table_lamp").mesh.materials) > 0.5
    assert max(m.emission for m in made("table_lamp", "unlit").mesh.materials) == 0.0


def test_an_unmade_bed_keeps_its_size():
    made_, unmade = made("bed"), made("bed", "unmade")
    assert unmade.size == pytest.approx(made_.size, abs=0.02)
    assert unmade.geometry != made_.geometry


def test_a_word_means_what_it_can_mean_of_the_thing():
    assert state_of("curtain", "open").posture == "drawn_back"
    assert state_of("fridge", "open", "door").posture == "opened"
    assert state_of("rug", "knocked over") is None
    assert state_of("wardrobe", "upside down") is None
    assert all(row.posture or row.measure for row in states())


def detailed(category, *details):
    source = ParametricSource()
    (card,) = source.find(category, Wish(count=1, details=details))
    return source.load(card.id).attributes


def test_parts_have_the_finish_that_is_asked_for():
    shown = detailed("coffee_table", ("top", "black marble"), ("legs", "brass"))
    assert "marble" in shown["top finish"] and "brass" in shown["legs finish"]


def test_a_finish_that_nobody_knows_is_not_claimed():
    assert "top finish" not in detailed("coffee_table", ("top", "moonstone"))
