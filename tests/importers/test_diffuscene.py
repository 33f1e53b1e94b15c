"""DiffuScene: arrays of many rooms, after its post-processing and as its network gives them."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.importers.formats import formats
from sceneweaver.importers.model import ReadOptions
from tests.importers.boxes import about_y, corners, only, refused, rooms, same_ring, y_up_corners

CLASSES = ["desk", "bookshelf", "floor_lamp", "start", "end"]
LOW, HIGH = np.array([-2.8, 0.05, -2.7]), np.array([2.9, 3.1, 2.6])
LEAST, MOST = np.array([0.04, 0.02, 0.03]), np.array([2.9, 1.8, 1.7])
THINGS = [  # class, centre, half extents, angle
    ("desk", (-1.1, 0.38, -1.3), (0.7, 0.38, 0.33), 0.3),
    ("bookshelf", (1.7, 0.95, 0.4), (0.41, 0.95, 0.17), -1.2),
    ("floor_lamp", (0.2, 0.8, 2.1), (0.2, 0.8, 0.24), 2.4),
]


def statistics(folder: Path) -> None:
    bounds = {"bounds_translations": [*LOW, *HIGH], "bounds_sizes": [*LEAST, *MOST], "bounds_angles": [-3.14, 3.14]}
    (folder / "dataset_stats.txt").write_text(json.dumps({"class_labels": CLASSES, **bounds}))


def arrays() -> dict[str, Any]:
    """Two rooms: the three things with an empty slot between them, and the last thing alone."""
    names = [name for name in CLASSES if name != "start"]  # DiffuScene's columns: "start" is taken away
    slots = [[0, 1, None, 2], [2, None, None, None]]
    found: dict[str, Any] = {"class_labels": [], "translations": [], "sizes": [], "angles": []}
    for room in slots:
        picked: Any = [THINGS[k] if k is not None else ("end", (0, 0, 0), (0.1, 0.1, 0.1), 0.0) for k in room]
        found["class_labels"].append([[1.0 if n == name else -1.0 for n in names] for name, *_ in picked])
        for key, column in (("translations", 1), ("sizes", 2)):
            found[key].append([list(row[column]) for row in picked])
        found["angles"].append([[row[3]] for row in picked])
    return found


def check(thing: Any, expected: Any, tolerance: float = 1e-5) -> None:
    name, centre, half, angle = expected
    assert thing.label == name
    np.testing.assert_allclose(corners(thing), y_up_corners(centre, 2 * np.array(half), about_y(angle)), atol=tolerance)


@pytest.mark.parametrize("suffix", ["npz", "json"])
def test_poses_by_an_independent_route(tmp_path: Path, suffix: str) -> None:
    statistics(tmp_path)
    file = tmp_path / f"sampled.{suffix}"
    if suffix == "npz":
        given: dict[str, Any] = {key: np.array(value) for key, value in arrays().items()}
        np.savez(file, **given)
    else:
        file.write_text(json.dumps(arrays()))
    first, second = rooms(file, "diffuscene")
    assert first.outline is None and len(first.objects) == 3 and len(second.objects) == 1
    for thing, expected in zip(first.objects, THINGS, strict=True):
        check(thing, expected)
    check(second.objects[0], THINGS[2])


def test_the_networks_own_output(tmp_path: Path) -> None:
    """(cos, sin) in that order, and centres and half sizes scaled to [-1, 1]."""
    statistics(tmp_path)
    given = arrays()
    raw: dict[str, Any] = {
        "class_labels": np.array(given["class_labels"]),
        "translations": 2 * (np.array(given["translations"]) - LOW) / (HIGH - LOW) - 1,
        "sizes": 2 * (np.array(given["sizes"]) - LEAST) / (MOST - LEAST) - 1,
        "angles": np.concatenate([np.cos(given["angles"]), np.sin(given["angles"])], axis=-1),
    }
    np.savez(tmp_path / "raw.npz", **raw)
    first = rooms(tmp_path / "raw.npz", "diffuscene")[0]
    assert any("[-1, 1]" in note for note in first.notes)
    for thing, expected in zip(first.objects, THINGS, strict=True):
        check(thing, expected)


def test_a_scaled_output_needs_the_bounds(tmp_path: Path) -> None:
    (tmp_path / "dataset_stats.txt").write_text(json.dumps({"class_labels": CLASSES}))
    data = arrays()
    data["sizes"] = [[[-0.9, -0.8, -0.7]] * 4] * 2
    data["translations"] = [[[-0.9, 0.8, -0.7]] * 4] * 2
    file = tmp_path / "raw.json"
    file.write_text(json.dumps(data))
    refused("diffuscene", file, match="network's output")


def test_names_in_the_file_and_one_room_alone(tmp_path: Path) -> None:
    data = {key: value[0] for key, value in arrays().items()}
    data["class_labels"] = ["desk", "bookshelf", "empty", "floor_lamp"]
    file = tmp_path / "one.json"
    file.write_text(json.dumps(data))
    room = only(rooms(file, "diffuscene"))
    assert [o.label for o in room.objects] == ["desk", "bookshelf", "floor_lamp"]
    (imported,) = sw.read_scenes(file)
    assert imported.boundary == "objects"
    sw.check(imported.scene)


def test_floor_plans_of_the_users_folder(tmp_path: Path) -> None:
    """Boxes move to where the floor plan is in its house."""
    corners_of_floor = np.array([(7.0, 0.5, 1.0), (13.0, 0.5, 1.0), (13.0, 0.5, 7.0), (7.0, 0.5, 7.0)])
    for name in ("house_Library-8", "house_Library-88"):
        (tmp_path / name).mkdir()
        np.savez(
            tmp_path / name / "boxes.npz",
            floor_plan_vertices=corners_of_floor,
            floor_plan_faces=np.array([[0, 1, 2], [0, 2, 3]]),
            floor_plan_centroid=np.array([10.0, 0.5, 4.0]),
        )
    statistics(tmp_path)
    file = tmp_path / "sampled.json"
    file.write_text(json.dumps({**arrays(), "scene_ids": ["Library-8", "Bedroom-3"]}))
    first, second = formats()["diffuscene"].read(file, ReadOptions(folder=tmp_path))
    same_ring(first.outline, [(7, -1), (13, -1), (13, -7), (7, -7)])
    assert (first.type, second.type, second.outline) == ("library", "bedroom", None)
    for thing, (name, centre, half, angle) in zip(first.objects, THINGS, strict=True):
        check(thing, (name, np.array(centre) + (10.0, 0.0, 4.0), half, angle))


class _Evil:
    def __reduce__(self) -> tuple:
        return (Path.touch, (Path("/tmp/sceneweaver_was_here"),))


def test_pickles_are_never_loaded(tmp_path: Path) -> None:
    for file in (tmp_path / "results.pkl", tmp_path / "results.bin"):
        file.write_bytes(pickle.dumps(_Evil()))
        with pytest.raises(sw.InputError, match="numpy.savez"):
            list(sw.read_scenes(file))
    refused("diffuscene", tmp_path / "results.pkl", match="numpy.savez")
    inside = tmp_path / "inside.npz"
    given: dict[str, Any] = {key: np.array(value) for key, value in arrays().items()}
    np.savez(inside, **{**given, "sizes": np.array([_Evil()], dtype=object)})
    refused("diffuscene", inside, match="numpy.savez")
    assert not Path("/tmp/sceneweaver_was_here").exists()


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda d: {**d, "angles": d["angles"][:1]}, "angles: 1 rooms"),
        (lambda d: {**d, "sizes": [[[0.1, float("nan"), 1]] * 4] * 2}, "sizes: NaN"),
        (lambda d: {k: v for k, v in d.items() if k != "sizes"}, "'sizes' is missing"),
        (lambda d: {**d, "translations": [[["x", 0, 0]] * 4] * 2}, "translations"),
        (lambda d: {**d, "translations": []}, "no room|translations|missing|numbers"),
        (lambda d: {**d, "sizes": [[[0.1, -3, 1]] * 4] * 2}, "half extent"),
        (lambda d: [d], "object"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, change: Any, match: str) -> None:
    statistics(tmp_path)
    file = tmp_path / "sampled.json"
    file.write_text(json.dumps(change(arrays())))
    refused("diffuscene", file, match=match)


def test_a_file_cut_off_and_an_empty_one(tmp_path: Path) -> None:
    statistics(tmp_path)
    file = tmp_path / "sampled.json"
    for text in (json.dumps(arrays())[:200], ""):
        file.write_text(text)
        refused("diffuscene", file)
