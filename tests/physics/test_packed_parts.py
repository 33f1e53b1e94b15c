"""Parts of assets as bytes."""

import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.physics.hulls import merged_hulls, packed, unpacked


@pytest.mark.parametrize("category", ["desk", "armchair", "fruit_bowl", "table_lamp"])
def test_unpacked_parts_are_those_that_were_packed(category: str) -> None:
    parts = merged_hulls(make(category, 3))
    again = unpacked(packed(parts))
    assert len(again) == len(parts)
    for one, other in zip(parts, again, strict=True):
        np.testing.assert_array_equal(one.points, other.points)
        assert (one.volume, one.link, one.handle) == (other.volume, other.link, other.handle)
        assert (one.box is None) == (other.box is None)
        if one.box is not None and other.box is not None:
            np.testing.assert_array_equal(one.box, other.box)
        np.testing.assert_array_equal(one.planes, other.planes)
