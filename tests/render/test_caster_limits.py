"""What the ray caster refuses, and what edges of things look like."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.render.camera import Camera
from sceneweaver.render.caster import Instance, Lighting, Quality, cast
from sceneweaver.scene import InputError, MissingDependencyError

CAMERA = Camera.look_at((4.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.6)
EMPTY = Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32), *[np.zeros(0, np.int32)] * 2, (Material("m", (1, 1, 1)),))


def wall(material: Material, size: float = 0.5) -> Mesh:
    """A square at x = 0 that faces the camera."""
    v = np.array([[0, -size, -size], [0, size, -size], [0, size, size], [0, -size, size]])
    zeros = np.zeros(2, np.int32)
    return Mesh(v, np.array([[0, 1, 2], [0, 2, 3]], np.int32), zeros, zeros, (material,))


def drawn(mesh: Mesh, transform=None, **more):
    return cast([Instance(mesh, np.eye(4) if transform is None else transform)], CAMERA, 65, 65, **more)


def test_depth_and_object_are_those_of_the_middle_of_a_pixel():
    picture = drawn(wall(Material("red", (0.8, 0.1, 0.1))))
    axis = ((np.arange(65) + 0.5) / 32.5 - 1) * math.tan(0.3)
    u, v = np.meshgrid(axis, -axis)
    inside = (np.abs(u * 4) < 0.5) & (np.abs(v * 4) < 0.5)
    assert (picture.objects == np.where(inside, 0, -1)).all()
    assert np.allclose(picture.depth[inside], 4 * np.sqrt(1 + u**2 + v**2)[inside], atol=1e-4)
    assert np.isinf(picture.depth[~inside]).all()


def test_edges_are_no_darker_than_both_of_their_sides():
    lighting = Lighting(background=(0.6, 0.6, 0.6))
    rgb = drawn(wall(Material("white", (0.95, 0.95, 0.95))), lighting=lighting, quality=Quality(rays=16)).rgb
    row = rgb[32].astype(int).sum(axis=1)
    assert row.min() >= min(row[0], row[32]) - 3


def test_half_shaded_surfaces_have_next_to_no_noise():
    grey = Material("grey", (0.5, 0.5, 0.5))
    roof = np.array([[0.0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 1.3], [0, 0, 0, 1]])  # level, above what is seen
    picture = cast([Instance(wall(grey, 40.0), np.eye(4)), Instance(wall(grey, 3.0), roof)], CAMERA, 65, 65)
    inner = picture.rgb[8:-8, 8:-8, 1].astype(float)
    assert (picture.objects == 0).all() and np.ptp(inner.mean(axis=1)) > 5, "it is shaded"
    assert np.std(inner - inner.mean(axis=1, keepdims=True)) < 0.2, "of 255: the roof shades all of a row alike"


def test_a_mesh_without_triangles_is_not_there():
    assert (drawn(EMPTY).objects == -1).all()
    both = [Instance(EMPTY, np.eye(4)), Instance(wall(Material("m", (1, 0, 0))), np.eye(4))]
    assert cast(both, CAMERA, 9, 9).objects[4, 4] == 1


@pytest.mark.parametrize("transform", [np.eye(3), np.zeros((4, 4)), np.full((4, 4), np.nan), np.diag([1, 1, 0, 1])])
def test_bad_transforms(transform):
    with pytest.raises(InputError, match=r"instances\[0\].transform"):
        drawn(wall(Material("m", (1, 1, 1))), transform)


@pytest.mark.parametrize("quality", [Quality(rays=0), Quality(shades=0), Quality(radius=-1)])
def test_bad_quality(quality):
    with pytest.raises(InputError, match="quality"):
        drawn(EMPTY, quality=quality)


@pytest.mark.parametrize("sun", [(0.0, 0.0, 0.0), (math.nan, 0.0, 1.0)])
def test_bad_sun(sun):
    with pytest.raises(InputError, match="lighting.sun"):
        drawn(EMPTY, lighting=replace(Lighting(), sun=sun))


@pytest.mark.parametrize("device", ["cuda:99", "tpu", ""])
def test_devices_that_are_not_there(device):
    with pytest.raises(MissingDependencyError, match="device"):
        drawn(EMPTY, device=device)


@pytest.mark.parametrize(
    ("field", "more"),
    [
        ("target", {"target": (1.0, 0.0, 0.0)}),
        ("target", {"target": (math.nan, 0.0, 0.0)}),
        ("eye", {"target": (0.0, 0.0)}),
        ("fov", {"fov": 0.0}),
        ("fov", {"fov": 4.0}),
        ("fov", {"fov": math.nan}),
        ("aspect", {"aspect": 0.0}),
    ],
)
def test_bad_cameras(field, more):
    with pytest.raises(InputError, match=rf"camera.*{field}"):
        Camera.look_at(**{"eye": (1.0, 0.0, 0.0), "target": (0.0, 0.0, 0.0), **more})


def test_flat_cameras_have_a_height():
    with pytest.raises(InputError, match="camera.height"):
        Camera.orthographic((1.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
