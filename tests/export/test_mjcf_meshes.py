"""Numbers of meshes as short text."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.export.mjcf_meshes import decimals


@pytest.mark.parametrize("digits", [4, 5])
def test_numbers_come_back_as_near_as_their_digits(digits: int) -> None:
    values = np.concatenate(
        [[0.0, -0.0, 1.0, -3.5, 0.05, 12.0, 1e-9, -1e-9], np.random.default_rng(3).normal(size=300)]
    )
    written = decimals(values, digits)
    assert np.abs(np.array(written.split(), dtype=float) - values).max() <= 0.5 * 10**-digits + 1e-12
    assert written.split()[:8] == ["0", "0", "1", "-3.5", ".05", "12", "0", "0"]
