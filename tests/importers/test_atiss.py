"""ATISS: boxes.npz of an L-shaped room in a house, with half extents, angles and the centroid checked by hand."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import about_y, corners, only, refused, rooms, same_ring, y_up_corners

CLASSES = ["double_bed", "nightstand", "wardrobe", "pendant_lamp", "start", "end"]
L_SHAPE = [(3.1, 1.2), (7.3, 1.2), (7.3, 3.4), (5.6, 3.4), (5.6, 6.0), (3.1, 6.0)]  # x, z in the house
TRIANGLES = [(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)]
CENTRE = np.array([5.2, 0.0, 3.6])
THINGS = [  # class, translation from the centre, half extents along x, y, z, angle
    (0, (-1.1, 0.45, -1.2), (0.85, 0.45, 1.05), 0.3),
    (1, (1.6, 0.28, -1.9), (0.22, 0.28, 0.2), -1.2),
    (2, (-1.5, 1.1, 1.7), (0.9, 1.1, 0.3), 2.4),
    (3, (-0.4, 2.3, -0.9), (0.25, 0.3, 0.26), 1.0),
]


def data() -> dict:
    return {
        "uids": np.array([f"u{k}" for k in range(4)]),
        "jids": np.array([f"j{k}" for k in range(4)]),
        "scene_id": np.array("MasterBedroom-77"),
        "scene_type": np.array("masterbedroom"),
        "room_layout": np.zeros((8, 8, 1), dtype=np.uint8),
        "floor_plan_vertices": np.array([(x, 0.0, z) for x, z in L_SHAPE]),
        "floor_plan_faces": np.array(TRIANGLES),
        "floor_plan_centroid": CENTRE,
        "class_labels": np.eye(6, dtype=np.float32)[[k for k, *_ in THINGS]],
        "translations": np.array([t for _, t, _, _ in THINGS]),
        "sizes": np.array([s for _, _, s, _ in THINGS]),
        "angles": np.array([[a] for *_, a in THINGS]),
    }


def write(folder: Path, room: str = "house_MasterBedroom-77", **changes: object) -> Path:
    kept = {key: value for key, value in {**data(), **changes}.items() if value is not None}
    (folder / room).mkdir(parents=True)
    np.savez(folder / room / "boxes.npz", **kept)
    (folder / "dataset_stats.txt").write_text(json.dumps({"class_labels": CLASSES}))
    return folder / room / "boxes.npz"


def test_poses_by_an_independent_route(tmp_path: Path) -> None:
    room = only(rooms(write(tmp_path), "atiss"))
    assert (room.name, room.type) == ("house_MasterBedroom-77", "masterbedroom")
    same_ring(room.outline, [(x, -z) for x, z in L_SHAPE])
    assert [o.label for o in room.objects] == ["double_bed", "nightstand", "wardrobe", "pendant_lamp"]
    for thing, (_, translation, half, angle) in zip(room.objects, THINGS, strict=True):
        expected = y_up_corners(CENTRE + translation, 2 * np.array(half), about_y(angle))
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)
    assert [o.asset for o in room.objects] == ["j0", "j1", "j2", "j3"]
    assert room.objects[3].mount == "ceiling"


def test_a_quarter_turn_by_hand(tmp_path: Path) -> None:
    """At a quarter turn the front, +z, is +x: 1.4 m deep, 1.8 m wide, 1.0 m high."""
    bed = {
        "class_labels": np.eye(6)[[0]],
        "translations": np.array([[0.5, 0.5, -0.25]]),
        "sizes": np.array([[0.9, 0.5, 0.7]]),
        "angles": np.array([[np.pi / 2]]),
    }
    thing = only(rooms(write(tmp_path, **bed), "atiss")).objects[0]
    assert thing.position == pytest.approx((5.7, -3.35, 0.5))
    assert thing.size == pytest.approx((1.4, 1.8, 1.0))
    np.testing.assert_allclose(thing.rotation, np.eye(3), atol=1e-12)


def test_a_floor_above_zero_is_moved_down(tmp_path: Path) -> None:
    vertices = data()["floor_plan_vertices"] + (0, 3.0, 0)
    raised = write(tmp_path, floor_plan_vertices=vertices, floor_plan_centroid=CENTRE + (0, 3.0, 0))
    room = only(rooms(raised, "atiss"))
    assert room.objects[0].position[2] == pytest.approx(0.45)
    assert any("3 m" in note for note in room.notes)


def test_a_folder_is_read_room_after_room(tmp_path: Path) -> None:
    for k in (3, 1, 2):
        write(tmp_path, f"house_Bedroom-{k}")
    found = rooms(tmp_path, "atiss")
    assert [room.name for room in found] == [f"house_Bedroom-{k}" for k in (1, 2, 3)]
    assert [room.type for room in found] == ["masterbedroom"] * 3


def test_classes_come_from_the_users_folder(tmp_path: Path) -> None:
    file = write(tmp_path / "set")
    (tmp_path / "set" / "dataset_stats.txt").rename(tmp_path / "dataset_stats.txt")
    lonely = tmp_path / "far" / "away" / "deep" / "boxes.npz"
    lonely.parent.mkdir(parents=True)
    file.rename(lonely)
    refused("atiss", lonely, match="dataset_stats.txt")
    assert only(rooms(lonely, "atiss", folder=tmp_path)).objects[0].label == "double_bed"


def test_to_a_scene_and_the_judge(tmp_path: Path) -> None:
    (imported,) = sw.read_scenes(write(tmp_path))
    assert imported.boundary == "file" and len(imported.scene.objects) == 4
    bed = next(o for o in imported.scene.objects if o.category == "bed")
    expected = y_up_corners(CENTRE + THINGS[0][1], 2 * np.array(THINGS[0][2]), about_y(0.3))
    np.testing.assert_allclose(bed.pose.position[:2], expected.mean(axis=0)[:2], atol=1e-5)
    assert bed.pose.position[2] == pytest.approx(0.0, abs=1e-9)
    assert set(imported.sizes_from.values()) == {"file"}
    sw.check(imported.scene)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"sizes": np.zeros((4, 2))}, "sizes: 4 x 3 numbers"),
        ({"translations": np.full((4, 3), np.nan)}, "translations: NaN"),
        ({"angles": None}, "'angles' is missing"),
        ({"class_labels": np.eye(9)[:4]}, "class_labels: 9 columns"),
        ({"floor_plan_faces": np.array([[0, 1, 9]])}, "floor_plan_faces"),
        ({"angles": np.array([["a"]] * 4)}, "angles"),
        ({"jids": np.array([{"a": 1}], dtype=object)}, "pickle"),
    ],
)
def test_broken_arrays_are_one_line(tmp_path: Path, change: dict, match: str) -> None:
    refused("atiss", write(tmp_path, **change), match=match)


def test_broken_files_are_one_line(tmp_path: Path) -> None:
    file = write(tmp_path)
    whole = file.read_bytes()
    for content in (whole[: len(whole) // 2], b"", b"PK\x03\x04 not at all", b"{}"):
        file.write_bytes(content)
        refused("atiss", file)
    file.write_bytes(whole)
    (tmp_path / "dataset_stats.txt").write_text('{"class_labels": 3}')
    with pytest.raises(sw.InputError, match="class_labels"):
        rooms(file, "atiss")
