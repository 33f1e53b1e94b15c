"""Vessels with something in them."""

import numpy as np
import pytest

from sceneweaver.assets import Library, Wish


def drawn(category, posture=None):
    library = Library()
    return library.load(library.choose(category, 1, Wish(posture=posture))[0].id)


@pytest.mark.parametrize("category", ["mug", "bucket", "carafe", "jar"])
def test_what_is_in_a_vessel_reaches_as_high_as_told(category):
    empty, half, full = drawn(category), drawn(category, "half_full"), drawn(category, "full")
    assert half.attributes["posture"] == "half_full" and half.size == empty.size
    tops = [made.mesh.vertices[len(empty.mesh.vertices) :, 2].max() / empty.size[2] for made in (half, full)]
    assert 0.3 < tops[0] < 0.65 < tops[1] < 1.0


def test_a_bin_overflows_over_its_rim():
    empty, made = drawn("trash_can"), drawn("trash_can", "overflowing")
    more = made.mesh.vertices[len(empty.mesh.vertices) :]
    assert more[:, 2].max() > empty.size[2]
    assert np.abs(more[:, :2]).max() < 0.5 * max(empty.size[:2])


def test_what_holds_nothing_is_not_filled():
    assert "posture" not in drawn("chair", "half_full").attributes
