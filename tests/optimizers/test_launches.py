"""Blocks of launches: how often they run, what time limits do, that graphs give the same."""

from __future__ import annotations

import time

import numpy as np
import pytest
import warp as wp

from sceneweaver.optimizers import Monitor
from sceneweaver.optimizers.launches import Launches


@wp.kernel(enable_backward=False)
def _append(digit: wp.int32, number: wp.array(dtype=wp.int64)):
    number[wp.tid()] = number[wp.tid()] * wp.int64(10) + wp.int64(digit)


@pytest.fixture
def block(device):
    """A block that writes 1, 2, 3, and the number that it writes to."""
    number = wp.zeros(4, dtype=wp.int64, device=device)
    made = Launches(device)
    for digit in (1, 2, 3):
        made.add(_append, 4, [digit], [number])
    return made, number


def test_nothing_runs_before_it_is_played(block):
    made, number = block
    assert len(made) == 3 and (number.numpy() == 0).all()


@pytest.mark.parametrize(
    ("times", "rest", "written"), [(0, 0, 0), (1, 0, 123), (0, 2, 12), (1, 1, 1231), (3, 2, 12312312312)]
)
def test_order_and_number(block, times, rest, written):
    made, number = block
    assert made.play(Monitor(1), times, rest)
    np.testing.assert_array_equal(number.numpy(), written)


@pytest.mark.parametrize(("times", "written"), [(1, 5), (3, 555), (4, 5555), (7, 5555555)])
def test_unrolled(device, times, written):
    number = wp.zeros(4, dtype=wp.int64, device=device)
    made = Launches(device, unroll=3)
    made.add(_append, 4, [5], [number])
    assert made.play(Monitor(1), times)
    np.testing.assert_array_equal(number.numpy(), written)


def test_playing_again_goes_on(block):
    made, number = block
    assert made.play(Monitor(1), 2) and made.play(Monitor(1), 2)
    assert number.numpy()[0] == 123123123123


def test_a_deadline_stops_it(block):
    made, number = block
    monitor = Monitor(1, deadline=time.monotonic() - 1.0)
    assert not made.play(monitor, 5, 1)
    assert monitor.timed_out and (number.numpy() == 0).all()
