"""Corners of triangles that are alike are one vertex."""

import numpy as np
import pytest

from sceneweaver.export.corners import first_of_each


@pytest.mark.parametrize("scale", [1, 2**30])
def test_different_rows_are_found_in_their_order(scale: int) -> None:
    """Small numbers are packed into one, large ones are compared as rows."""
    rng = np.random.default_rng(3)
    rows = rng.integers(0, 4, (200, 3)) * scale
    first, which = first_of_each(list(rows.T))
    different = np.unique(rows, axis=0)
    np.testing.assert_array_equal(rows[first], different)
    np.testing.assert_array_equal(different[which], rows)
    assert all((rows[:k] != rows[k]).any(axis=1).all() for k in first)
