"""MetaScenes: meshes in the scan's frame, matrices row by row after centring, least boxes."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.meshes import box_obj
from tests.importers.reading import compass, require_error, require_pose, rooms_of, things_of, written


def data_set(folder):
    """Three boxes: one along the axes, one turned by 0.3 in its mesh, and a small one on it."""
    scan = folder / "Annotation_scenes" / "scene0001_00"
    for name, low, high in (("1", (2.0, -0.6, 0.0), (2.5, 1.0, 0.8)), ("2-1", (-2.1, 1.0, 0.7), (-1.9, 1.1, 1.0))):
        box_obj(scan, name, low, high)
        (scan / name / "raw_model.obj").rename(scan / name / f"{name}.obj")
    c, s = math.cos(0.3), math.sin(0.3)
    rows = [(-2 + c * x - s * y, 1 + s * x + c * y, z) for x in (-0.5, 0.5) for y in (-0.2, 0.2) for z in (0.0, 0.7)]
    text = "\n".join(f"v {x} {y} {z}" for x, y, z in rows) + "\nf 1 2 3\nf 4 5 6\nf 7 8 1\nf 2 5 7\n"
    written(scan, "2/2.obj", text)
    return scan


def matrices():
    """A turn about z by -1.2 to a place; for the turned one a shift only."""
    c, s = math.cos(-1.2), math.sin(-1.2)
    return {"matrix": {"1": [[c, -s, 0, 1.5], [s, c, 0, -0.7], [0, 0, 1, 0.5], [0, 0, 0, 1]]}}


def test_annotated_scenes(tmp_path):
    scan = data_set(tmp_path)
    written(
        tmp_path,
        "Layout/Heuristic/scene0001_00.json",
        {"vert": [[-3, -2, 0], [3, -2, 0], [3, 2, 0], [-3, 2, 0]], "quads": []},
    )
    (room,) = rooms_of("metascenes", scan).values()
    things = things_of(room)
    assert room.outline == ((-3, -2), (3, -2), (3, 2), (-3, 2))
    require_pose(things["1"], (2.25, 0.2, 0.4), (-1, 0, 0))
    np.testing.assert_allclose(things["1"].size, (0.5, 1.6, 0.8), atol=1e-6)
    # least box along 0.3; the middle of all lies to the right of and below it: of its sides that along +x + 0.3
    require_pose(things["2"], (-2, 1, 0.35), compass(0.3))
    np.testing.assert_allclose(things["2"].size, (1.0, 0.4, 0.7), atol=1e-6)
    assert things["2-1"].support == "2"


def test_physical_matrices(tmp_path):
    data_set(tmp_path)
    path = written(tmp_path, "Physical_simu/scene0001_00.json", matrices())
    (room,) = rooms_of("metascenes", path).values()
    thing = things_of(room)["1"]
    np.testing.assert_allclose(thing.position, (1.5, -0.7, 0.5), atol=1e-6)
    axes = {round(math.atan2(thing.rotation[1, 0], thing.rotation[0, 0]) - k * math.pi / 2, 6) for k in range(-3, 4)}
    assert round(-1.2, 6) in axes
    assert sorted(thing.size) == pytest.approx([0.5, 0.8, 1.6])
    (whole,) = sw.read_scenes(tmp_path, assets="boxes")
    assert whole.room == "scene0001_00" and len(whole.scene.objects) == 3
    assert sw.check(whole.scene) is not None


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        ("", ("empty",)),
        ('{"matrix": {"1": [[1, 0, 0', ("cut off",)),
        ({"matrix": []}, ("matrix", "object")),
        ({"matrix": {"1": [[1, 0, 0], [0, 1, 0]]}}, ("matrix.1",)),
        ({"matrix": {"1": [[math.nan, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}}, ("NaN",)),
        ({"matrix": {"1": [[0, 0, 0, 0]] * 4}}, ("flattens",)),
        ({}, ("'matrix' is missing",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    data_set(tmp_path)
    require_error(written(tmp_path, "Physical_simu/scene0001_00.json", broken), "metascenes", *words)


def test_no_scan_and_a_broken_mesh(tmp_path):
    path = written(tmp_path, "Physical_simu/scene0002_00.json", matrices())
    require_error(path, "metascenes", "--asset-folder")
    scan = data_set(tmp_path)
    written(scan, "1/1.obj", "v 1 2")
    with pytest.raises(sw.InputError, match=r"1\.obj"):
        list(sw.read_scenes(scan))
