"""InternScenes: boxes of nine numbers whose angles turn about moving axes z, x, y, and the floor's mesh."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import SIGNS, corners, only, refused, rooms, same_ring

ROWS = [  # category, model, centre, full extents (front first), angles about z, x, y
    ("chair", "partnet_mobility/39551", (1.04, -1.26, 0.38), (0.43, 0.46, 0.76), (0.3, 0.0, 0.0)),
    ("cabinet", "hssd-models/abc", (-0.8, 0.9, 0.9), (0.5, 1.3, 1.8), (-1.2, 0.0, 0.0)),
    ("book", "objaverse/1", (0.2, 0.4, 0.95), (0.2, 0.15, 0.04), (2.4, 0.2, -0.1)),
]
FLOOR = [(-2.0, -2.5), (2.3, -2.5), (2.3, 0.7), (0.4, 0.7), (0.4, 2.1), (-2.0, 2.1)]


def layout() -> list[dict[str, Any]]:
    return [
        {"id": k + 1, "category": category, "model_uid": uid, "bbox": [*centre, *extents, *angles]}
        for k, (category, uid, centre, extents, angles) in enumerate(ROWS)
    ]


def write(folder: Path, data: Any) -> Path:
    place = folder / "scannet" / "scene0000_00"
    place.mkdir(parents=True, exist_ok=True)
    (place / "layout.json").write_text(json.dumps(data))
    return place / "layout.json"


def floor_mesh(file: Path) -> None:
    """The floor with a thickness, y up."""
    import shapely
    import trimesh

    solid = trimesh.creation.extrude_polygon(shapely.Polygon(FLOOR), 0.1)
    solid.apply_translation((0, 0, -0.1))
    solid.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))
    (file.parent / "StructureMesh").mkdir(exist_ok=True)
    solid.export(file.parent / "StructureMesh" / "floor.glb")


def expected(centre: Any, extents: Any, angles: Any) -> np.ndarray:
    """Corners [8, 3]: Rz Rx Ry, since the axes move."""
    (cz, cx, cy), (sz, sx, sy) = np.cos(angles), np.sin(angles)
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    return np.array(centre) + (SIGNS * np.array(extents) / 2) @ (about_z @ about_x @ about_y).T


def test_poses_by_an_independent_route(tmp_path: Path) -> None:
    room = only(rooms(write(tmp_path, layout()), "internscenes"))
    assert room.outline is None and room.name == "scannet_scene0000_00"
    for thing, (category, uid, centre, extents, angles) in zip(room.objects, ROWS, strict=True):
        np.testing.assert_allclose(corners(thing), expected(centre, extents, angles), atol=1e-5)
        assert (thing.label, thing.asset) == (category, uid)


def test_the_floors_mesh_is_the_outline(tmp_path: Path) -> None:
    door = {"id": 9, "category": "door", "model_uid": "", "bbox": [2.35, -1.0, 1.0, 0.1, 0.9, 2.0, 0, 0, 0]}
    wall = {"id": 10, "category": "wall", "model_uid": "", "bbox": [0, 0, 1.0, 0.1, 4, 2.0, 0, 0, 0]}
    file = write(tmp_path, [*layout(), door, wall])
    floor_mesh(file)
    room = only(rooms(file, "internscenes"))
    same_ring(room.outline, FLOOR)
    assert len(room.objects) == 3 and any("1 walls" in note for note in room.notes)
    (opening,) = room.openings
    np.testing.assert_allclose(sorted([opening.start, opening.end]), [(2.35, -1.45), (2.35, -0.55)], atol=1e-5)
    (imported,) = sw.read_scenes(file)
    assert imported.boundary == "file" and len(imported.scene.room.doors) == 1
    sw.check(imported.scene)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda d: d[1].update(bbox=[0.0] * 6), r"\[1\]: bbox: 9 numbers"),
        (lambda d: d[0].update(bbox=[0.0, 0, 0, 1, 0, 1, 0, 0, 0]), "no extent"),
        (lambda d: d[2].update(bbox=[float("nan")] * 9), "NaN"),
        (lambda d: d[2].pop("category"), "'category' is missing"),
        (lambda d: d.append("chair"), "object"),
        (lambda d: d[0].update(bbox=["a"] * 9), "plain numbers"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, change: Any, match: str) -> None:
    data = layout()
    change(data)
    refused("internscenes", write(tmp_path, data), match=match)


def test_a_file_cut_off_and_an_empty_one(tmp_path: Path) -> None:
    file = write(tmp_path, layout())
    for text in (json.dumps(layout())[:150], "", "{}"):
        file.write_text(text)
        refused("internscenes", file)


def test_a_broken_floor_is_one_line(tmp_path: Path) -> None:
    file = write(tmp_path, layout())
    (file.parent / "StructureMesh").mkdir()
    (file.parent / "StructureMesh" / "floor.glb").write_bytes(b"glTF no")
    with pytest.raises(sw.InputError, match=r"floor\.glb"):
        list(rooms(file, "internscenes"))
