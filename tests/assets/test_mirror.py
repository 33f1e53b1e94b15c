"""Assets in a mirror: left is right, all else is as it was."""

import numpy as np
import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.mirror import mirrored
from sceneweaver.assets.sources.parametric import other_hand

FRIDGE = "parametric:fridge?seed=3"


@pytest.mark.parametrize("asset_id", [FRIDGE, "parametric:washing_machine?seed=0", "parametric:toilet?seed=0"])
def test_mirror(asset_id):
    plain = Library().load(asset_id)
    other_id = other_hand(asset_id)
    assert other_id is not None and other_hand(other_id) == asset_id
    other = Library().load(other_id)
    assert other.id == other_id and other.size == plain.size and other.masses == plain.masses
    for a, b in zip(plain.hulls, other.hulls, strict=True):
        np.testing.assert_allclose(b.vertices, a.vertices * [1, -1, 1])
        assert signed_volume(b) == pytest.approx(signed_volume(a)) and signed_volume(b) > 0
    for a, b in zip(plain.parts, other.parts, strict=True):
        assert area(b.polygon) == pytest.approx(area(a.polygon)) and area(b.polygon) > 0
    for number, (a, b) in enumerate(zip(plain.links, other.links, strict=True), start=1):
        points = np.concatenate([h.vertices for h in plain.hulls if h.link == number])
        np.testing.assert_allclose(moved(b, points * [1, -1, 1]), moved(a, points) * [1, -1, 1], atol=1e-9)
    for a, b in zip(plain.interiors, other.interiors, strict=True):
        np.testing.assert_allclose(np.add(b.low, b.high)[[0, 2]], np.add(a.low, a.high)[[0, 2]])
        assert np.all(np.less(b.low, b.high)) and b.low[1] == -a.high[1]
    again = mirrored(other)
    np.testing.assert_allclose(again.mesh.vertices, plain.mesh.vertices)
    np.testing.assert_array_equal(again.mesh.faces, plain.mesh.faces)
    assert again.links == plain.links and again.grasps == plain.grasps and again.zones == plain.zones


def moved(link, points):
    """Points [N, 3] of a link, opened."""
    from scipy.spatial.transform import Rotation

    low, high = link.limits
    far = high if abs(high) >= abs(low) else low
    if link.joint == "slide":
        return points + far * np.array(link.axis)
    turn = Rotation.from_rotvec(far * np.array(link.axis)).as_matrix()
    return (points - link.anchor) @ turn.T + link.anchor


def signed_volume(hull):
    a, b, c = (hull.vertices[hull.faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def area(polygon):
    xy = np.array(polygon)
    after = np.roll(xy, -1, axis=0)
    return float((xy[:, 0] * after[:, 1] - xy[:, 1] * after[:, 0]).sum() / 2)
