"""Predicates of tasks: true within their bounds and false beyond, in turned frames, for many at once."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from sceneweaver.envs import predicates as p

LOW, HIGH = np.array([-0.3, -0.2, 0.0]), np.array([0.3, 0.2, 0.5])


def poses(count: int, seed: int = 0) -> np.ndarray:
    """Poses [count, 7] anywhere, turned anyhow."""
    rng = np.random.default_rng(seed)
    turns = Rotation.random(count, random_state=seed).as_quat()
    return np.column_stack([rng.normal(size=(count, 3)), np.roll(turns, 1, axis=1)])


def rotations(quaternions: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(quaternions, -1, axis=-1))


def test_frames_are_those_of_scipy_and_there_and_back_is_nothing():
    frames, points = poses(50), np.random.default_rng(1).normal(size=(50, 3))
    world = p.to_world(frames, points)
    assert world == pytest.approx(rotations(frames[:, 3:]).apply(points) + frames[:, :3], abs=1e-12)
    assert p.to_local(frames, world) == pytest.approx(points, abs=1e-12)
    a, b = poses(50, 2)[:, 3:], poses(50, 3)[:, 3:]
    assert p.rotate(p.product(a, b), points) == pytest.approx(p.rotate(a, p.rotate(b, points)), abs=1e-12)
    assert p.turned(np.array([1.0, 2.0]), 0.3) == pytest.approx(Rotation.from_rotvec([0, 0, 0.3]).apply([1, 2, 0])[:2])


@pytest.mark.parametrize(
    ("local", "box", "oval"),
    [
        ((0.0, 0.0, 0.25), True, True),
        ((0.29, 0.19, 0.49), True, False),
        ((0.29, 0.0, 0.01), True, True),
        ((0.31, 0.0, 0.25), False, False),
        ((0.0, -0.21, 0.25), False, False),
        ((0.0, 0.0, 0.51), False, False),
        ((0.0, 0.0, -0.01), False, False),
    ],
)
def test_inside_a_box_or_an_ellipse_whatever_its_frame(local, box, oval):
    frames = poses(20)
    points = p.to_world(frames, np.broadcast_to(local, (20, 3)))
    assert (p.is_inside(points, frames, LOW, HIGH) == box).all()
    assert (p.is_inside(points, frames, LOW, HIGH, oval=True) == oval).all()


@pytest.mark.parametrize(
    ("bottom", "on"),
    [((0.0, 0.0, 0.5), True), ((0.29, 0.19, 0.519), True), ((0.0, 0.0, 0.521), False), ((0.0, 0.21, 0.5), False)],
)
def test_on_a_surface(bottom, on):
    frame = np.array([1.0, 2.0, 0.3, np.cos(0.4), 0, 0, np.sin(0.4)])
    assert p.is_on(p.to_world(frame, np.array(bottom)), frame, LOW[:2], HIGH[:2], 0.5) == on


@pytest.mark.parametrize(("yaw", "looks"), [(0.52, True), (0.53, False), (-0.52, True), (2 * np.pi + 0.1, True)])
def test_a_base_looks_at_a_point_to_thirty_degrees(yaw, looks):
    for bearing in (0.0, 3.0, -3.1):  # across the seam of angles, too
        point = np.array([np.cos(bearing), np.sin(bearing)])
        base = np.array([0.0, 0.0, bearing + yaw])
        assert p.faces(base, point) == looks
        assert p.bearing_off(base, point) == pytest.approx(abs(yaw) % (2 * np.pi))


def test_distances_and_shares():
    frame = np.array([1.0, 1.0, 0.0, np.cos(np.pi / 8), 0, 0, np.sin(np.pi / 8)])  # turned by 45 degrees
    for local, far in (((0.5, 0.0), 0.2), ((0.6, 0.6), 0.5), ((0.1, 0.1), 0.0)):
        point = p.to_world(frame, np.array([*local, 0.0]))[:2]
        assert p.distance_to_box(point, frame, LOW, HIGH) == pytest.approx(far)
    assert p.open_share([-0.2, 0.0, 0.5, 3.0], 2.0).tolist() == [0.0, 0.0, 0.25, 1.0]
    assert p.open_share(0.5, -2.0) == 0.0, "the other way"
    assert p.is_near(np.zeros(3), np.array([0.0, 0.3, 0.4]), 0.5) and not p.is_near(np.zeros(3), np.ones(3), 1.7)
