"""What names say that something is, boxes along axes, and holes in walls."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sceneweaver.importers.frames import yaw_matrix
from sceneweaver.importers.shells import box_along, inner_rectangle, opening_of, shell_of, shell_of_walls, upright


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("Wall_3", "wall"),
        ("room:wall:0", "wall"),
        ("floor_backing", "floor"),
        ("WallNorth", "wall"),
        ("Ceiling", "ceiling"),
        ("room_door_2", "door"),
        ("window", "window"),
        ("Room", "room"),
        ("floor_lamp", None),
        ("door_mat", None),
        ("wall_cabinet", None),
        ("ceiling-light", None),
        ("sofa", None),
        ("", None),
    ],
)
def test_names(name, part):
    assert shell_of(name) == part


def test_boxes_along_axes():
    points = np.array([(1.0, 2.0, 0.0), (3.0, 2.5, 1.0), (2.0, 4.0, 0.5)])
    turn = yaw_matrix(0.7)
    centre, size = box_along(points @ turn.T, turn)
    np.testing.assert_allclose(size, (2.0, 2.0, 1.0), atol=1e-12)
    np.testing.assert_allclose(centre, turn @ (2.0, 3.0, 0.5), atol=1e-12)


@pytest.mark.parametrize("up", [(0, 1, 0), (0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -1, 0)])
def test_what_points_up_is_up(up):
    """A frame in which one axis points up becomes one whose z does, right-handed, whatever the front is."""
    z = np.array(up, dtype=float)
    x = np.roll(z, 1)
    turn = np.linalg.inv(np.stack((x, np.cross(z, x), z), axis=1))  # of the file: its axis `up` is z of the room
    for front in np.eye(3):
        made = upright(turn, front)
        np.testing.assert_allclose(made[:, 2], (0, 0, 1), atol=1e-12)
        assert np.linalg.det(made) == pytest.approx(1.0)


def test_walls_with_holes():
    half = np.array
    walls = []
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    for k, (x, y) in enumerate(corners):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = yaw_matrix(k * math.pi / 2), (x, y, 0.0)
        walls.append((matrix, [(half((2.0, -0.05, 1.2)), half((2.0, 0.05, 1.2)))]))
    # the first wall: solid to 1.0, a door of 0.9 x 2.0, solid on
    walls[0][1][:] = [
        (half((0.5, -0.05, 1.2)), half((0.5, 0.05, 1.2))),
        (half((1.45, -0.05, 2.2)), half((0.45, 0.05, 0.2))),
        (half((2.95, -0.05, 1.2)), half((1.05, 0.05, 1.2))),
    ]
    made = shell_of_walls(walls)
    assert made is not None and made.outline == tuple(corners) and made.height == pytest.approx(2.4)
    (door,) = made.openings
    assert door.kind == "door" and door.height == pytest.approx(2.0)
    np.testing.assert_allclose((*door.start, *door.end), (1.0, 0.0, 1.9, 0.0), atol=1e-9)


def test_openings_and_rectangles():
    box = np.array([[x, y, z] for x in (-0.6, 0.6) for y in (-0.02, 0.02) for z in (0.9, 2.1)])
    turned = box @ yaw_matrix(0.4).T + (2.0, 1.0, 0.0)
    found = opening_of("w", "window", turned)
    ends = {tuple(np.round(p, 6)) for p in (found.start, found.end)}
    c, s = 0.6 * math.cos(0.4), 0.6 * math.sin(0.4)
    assert ends == {tuple(np.round((2 + c, 1 + s), 6)), tuple(np.round((2 - c, 1 - s), 6))}
    assert (found.bottom, found.height) == (pytest.approx(0.9), pytest.approx(1.2))
    assert inner_rectangle([box]) is None
