"""Frames of the plane and rotations of space: inverse, composition, round trips, and what each is by definition."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sceneweaver.geometry import rotations
from sceneweaver.geometry.angles import bearing, heading, wrap_angle
from sceneweaver.geometry.se2 import SE2, absolute, relative

metres = st.floats(-20, 20)
radians = st.floats(-10, 10)
frames = st.builds(SE2, metres, metres, radians)
points = st.tuples(metres, metres)
axes = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: math.hypot(*v) > 0.1)
quaternions = st.builds(
    lambda axis, angle: (*(math.sin(angle / 2) / math.hypot(*axis) * np.array(axis)).tolist(), math.cos(angle / 2)),
    axes,
    radians,
)


def hamilton(a, b):
    """The product of two quaternions (x, y, z, w), written out."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


@given(radians, st.integers(-5, 5), st.sampled_from([math.tau, math.pi, math.pi / 2]))
def test_a_wrapped_angle_differs_by_whole_periods_and_is_within_half_of_one(angle, turns, period):
    found = wrap_angle(angle + turns * period, period)
    assert abs(found) <= period / 2 + 1e-12
    assert math.remainder(found - angle, period) == pytest.approx(0, abs=1e-12)
    array = wrap_angle(np.array([[angle + turns * period]]), period)
    assert array.shape == (1, 1) and math.remainder(array[0, 0] - found, period) == pytest.approx(0, abs=1e-12)


@given(radians, st.floats(0.1, 9), points)
def test_the_bearing_of_a_heading_is_its_yaw(yaw, far, start):
    c, s = heading(yaw)
    found = bearing(start, (start[0] + far * c, start[1] + far * s))
    assert wrap_angle(found - yaw) == pytest.approx(0, abs=1e-12)


def test_a_frame_that_looks_left_has_its_left_behind():
    frame = SE2(1.0, 2.0, math.pi / 2)
    assert frame.world(3.0, 0.5) == pytest.approx((0.5, 5.0))
    assert frame.local(0.5, 5.0) == pytest.approx((3.0, 0.5))
    np.testing.assert_allclose(frame.to_world([[[3.0, 0.5]]]), [[[0.5, 5.0]]])


@given(frames, points)
def test_into_a_frame_and_out_again(frame, point):
    assert frame.world(*frame.local(*point)) == pytest.approx(point, abs=1e-12)
    np.testing.assert_allclose(frame.to_local(frame.to_world([point, point])), [point, point], atol=1e-12)
    np.testing.assert_allclose(frame.to_local([point]), [frame.local(*point)], atol=0)


@given(frames, frames, points)
def test_a_frame_in_a_frame(outer, inner, point):
    both = outer @ inner
    assert both.world(*point) == pytest.approx(outer.world(*inner.world(*point)), abs=1e-11)
    assert abs(both.yaw) <= math.pi
    back = outer.inverse() @ both
    assert (back.x, back.y) == pytest.approx((inner.x, inner.y), abs=1e-11)
    assert wrap_angle(back.yaw - inner.yaw) == pytest.approx(0, abs=1e-12)


@given(st.lists(st.tuples(metres, metres, metres, radians), min_size=1, max_size=4), frames, metres)
def test_poses_seen_from_a_frame_and_back(poses, frame, height):
    poses, at = np.array(poses), np.array([frame.x, frame.y, height, frame.yaw])
    seen = relative(poses, at)
    np.testing.assert_allclose(seen[:, :2], frame.to_local(poses[:, :2]), atol=1e-12)
    back = absolute(seen, at)
    np.testing.assert_allclose(back[:, :3], poses[:, :3], atol=1e-12)
    np.testing.assert_allclose(wrap_angle(back[:, 3] - poses[:, 3]), 0, atol=1e-12)


@settings(deadline=None)  # the first call loads scipy
@given(radians)
def test_a_yaw_as_a_quaternion_and_back(yaw):
    turn = rotations.from_yaw(yaw)
    assert wrap_angle(rotations.yaw_of(turn) - yaw) == pytest.approx(0, abs=1e-12)
    assert rotations.is_upright(turn, 0.0) and rotations.tilt_of(turn) == 0.0
    assert rotations.rotate(turn, (2.0, 0.5, 3.0)) == pytest.approx((*SE2(0, 0, yaw).world(2.0, 0.5), 3.0), abs=1e-12)


def test_a_quarter_turn_about_x_lies_on_its_side():
    turn = (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))
    assert rotations.rotate(turn, (1.0, 2.0, 3.0)) == pytest.approx((1.0, -3.0, 2.0))
    assert rotations.tilt_of(turn) == pytest.approx(math.pi / 2) and not rotations.is_upright(turn, 0.1)
    assert rotations.is_upright((0.01, 0.0, 0.0, 0.99995), 0.011)


def test_the_real_part_goes_to_the_front_and_back():
    assert rotations.wxyz((1.0, 2.0, 3.0, 4.0)) == (4.0, 1.0, 2.0, 3.0)
    assert rotations.xyzw([(4.0, 1.0, 2.0, 3.0)]).tolist() == [[1.0, 2.0, 3.0, 4.0]]


@settings(deadline=None)  # the first call loads scipy
@given(quaternions, quaternions)
def test_products_are_hamiltons(a, b):
    assert rotations.multiply(a, b) == pytest.approx(hamilton(a, b), abs=1e-12)
    np.testing.assert_allclose(rotations.matrix(hamilton(a, b)), rotations.matrix(a) @ rotations.matrix(b), atol=1e-12)
    assert rotations.multiply(a, rotations.inverse(a)) == pytest.approx((0.0, 0.0, 0.0, 1.0), abs=1e-12)


@settings(deadline=None)  # the first call loads scipy
@given(quaternions, quaternions, st.floats(0.1, 9))
def test_one_rotation_is_scipys_in_every_bit(a, b, long):
    from scipy.spatial.transform import Rotation

    a = tuple((long * np.array(a)).tolist())
    assert rotations.matrix(a).tolist() == Rotation.from_quat(a).as_matrix().tolist()
    product = Rotation.from_quat(a) * Rotation.from_quat(b)
    assert list(rotations.multiply(a, b)) == product.as_quat().tolist()


def test_no_quaternion_of_length_0_is_a_rotation():
    with pytest.raises(ValueError, match="length 0"):
        rotations.matrix((0.0, 0.0, 0.0, 0.0))


@settings(deadline=None)  # the first call loads scipy
@given(quaternions, axes)
def test_vectors_turn_as_the_product_with_both_sides_of_a_quaternion(turn, vector):
    expected = hamilton(hamilton(turn, (*vector, 0.0)), rotations.inverse(turn))[:3]
    assert rotations.rotate(turn, vector) == pytest.approx(expected, abs=1e-12)
    assert rotations.rotate(tuple(3 * np.array(turn)), vector) == pytest.approx(expected, abs=1e-12)
    ahead, up = rotations.matrix(turn)[:, 0], rotations.matrix(turn)[:, 2]
    if math.hypot(*ahead[:2]) > 1e-6:
        assert wrap_angle(rotations.yaw_of(turn) - bearing((0, 0), ahead)) == pytest.approx(0, abs=1e-9)
    assert math.cos(rotations.tilt_of(turn)) == pytest.approx(up[2], abs=1e-12)


@settings(deadline=None)  # the first call loads scipy
@given(st.lists(quaternions, min_size=4, max_size=4), axes, points)
def test_many_poses_at_once(turns, vector, place):
    poses = np.array([(*place, k, *turn) for k, turn in enumerate(turns)]).reshape(2, 2, 7)
    found = rotations.transform(poses, np.broadcast_to(vector, (2, 2, 3))).reshape(4, 3)
    for k, turn in enumerate(turns):
        np.testing.assert_allclose(found[k] - (*place, k), rotations.rotate(turn, vector), atol=1e-12)
    assert rotations.matrix(poses[..., 3:]).shape == (2, 2, 3, 3)
    poses[..., 3:] *= 2.0
    poses[1, 1, 4] = math.nan
    again = rotations.transform(poses, np.array(vector)).reshape(4, 3)
    np.testing.assert_allclose(again[:3], found[:3], atol=1e-12)
    assert np.isnan(again[3]).all()


def test_turns_about_moving_axes():
    turns = (0.3, -0.7, 1.1)
    x, y, z = (rotations.matrix((*(math.sin(turns[k] / 2) * np.eye(3)[k]), math.cos(turns[k] / 2))) for k in range(3))
    np.testing.assert_allclose(rotations.euler(turns), x @ y @ z, atol=1e-12)
    np.testing.assert_allclose(rotations.euler(turns, "xyz"), z @ y @ x, atol=1e-12)
