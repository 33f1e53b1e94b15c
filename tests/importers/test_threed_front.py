"""3D-FRONT: a house of two rooms with floor meshes, doors, quaternions and scales, with and without the models."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import about_y, corners, refused, rooms, same_ring, y_up_corners

L_SHAPE = [(0.0, 0.0), (5.2, 0.0), (5.2, 2.3), (3.1, 2.3), (3.1, 4.4), (0.0, 4.4)]  # x, z
TRIANGLES = [0, 1, 2, 0, 2, 3, 0, 3, 5, 3, 4, 5]
THINGS = [  # uid, jid, title, full size before scale, pos of the origin, angle, scale
    ("1/model", "jid-bed", "bed/king-size bed", (1.8, 1.0, 2.1), (1.3, 0.0, 1.4), 0.3, (1.0, 1.1, 0.9)),
    ("2/model", "jid-desk", "table/desk", (1.2, 0.75, 0.6), (4.2, 0.0, 0.9), -1.2, (0.8, 1.0, 1.2)),
    ("3/model", "jid-lamp", "lighting/pendant lamp", (0.4, 0.5, 0.3), (1.5, 2.1, 3.2), 2.4, (1.0, 1.0, 1.0)),
]


def turn(angle: float) -> list[float]:
    """A quaternion x, y, z, w about y."""
    return [0.0, float(np.sin(angle / 2)), 0.0, float(np.cos(angle / 2))]


def box_mesh(uid: str, kind: str, low: tuple[float, ...], high: tuple[float, ...]) -> dict[str, Any]:
    xyz = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    return {"uid": uid, "jid": "", "type": kind, "xyz": [v for p in xyz for v in p], "faces": [0, 1, 2, 5, 6, 7]}


def house() -> dict[str, Any]:
    floor = {"uid": "f", "jid": "", "type": "Floor", "faces": TRIANGLES}
    other = [(5.4, 0.0), (8.0, 0.0), (8.0, 3.0), (5.4, 3.0)]
    still = {"pos": [0, 0, 0], "rot": [0, 0, 0, 1], "scale": [1, 1, 1]}
    return {
        "uid": "house-1",
        "jobid": "j",
        "design_version": "0.1",
        "north_vector": [0, 1, 0],
        "furniture": [
            {"uid": uid, "jid": jid, "title": title, "size": list(size), "valid": True}
            for uid, jid, title, size, *_ in THINGS
        ]
        + [{"uid": "9/model", "jid": "broken", "title": "cabinet/wardrobe", "size": [1, 1, 1], "valid": False}],
        "mesh": [
            {**floor, "xyz": [v for x, z in L_SHAPE for v in (x, 0.0, z)]},
            {**floor, "uid": "g", "xyz": [v for x, z in other for v in (x, 0.0, z)], "faces": [0, 1, 2, 0, 2, 3]},
            box_mesh("w", "WallInner", (0.0, 0.0, 0.0), (5.2, 2.6, 0.0)),
            box_mesh("d", "Door", (5.2, 0.0, 0.5), (5.4, 2.1, 1.4)),
            box_mesh("n", "Window", (-0.2, 0.9, 1.0), (0.0, 2.2, 2.8)),
        ],
        "scene": {
            "room": [
                {
                    "type": "MasterBedroom",
                    "instanceid": "MasterBedroom-31",
                    "children": [
                        *(
                            {"ref": uid, "pos": list(pos), "rot": turn(angle), "scale": list(scale)}
                            for uid, _, _, _, pos, angle, scale in THINGS
                        ),
                        *({"ref": uid, **still} for uid in ("f", "w", "d", "n", "9/model", "nowhere")),
                    ],
                },
                {"type": "Balcony", "instanceid": "Balcony-2", "children": [{"ref": u, **still} for u in ("g", "d")]},
            ]
        },
    }


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "house-1.json"
    path.write_text(json.dumps(house()))
    return path


def test_poses_by_an_independent_route(file: Path) -> None:
    """Without the models, a model stands on its origin and has the house's size times its scale."""
    bedroom, balcony = rooms(file, "3dfront")
    assert (bedroom.name, bedroom.type, bedroom.height) == ("MasterBedroom-31", "masterbedroom", 2.6)
    same_ring(bedroom.outline, [(x, -z) for x, z in L_SHAPE])
    same_ring(balcony.outline, [(5.4, 0.0), (8.0, 0.0), (8.0, -3.0), (5.4, -3.0)])
    assert [o.label for o in bedroom.objects] == ["king-size bed", "desk", "pendant lamp"]
    for thing, (_, jid, _, size, pos, angle, scale) in zip(bedroom.objects, THINGS, strict=True):
        full = np.array(size) * scale
        expected = y_up_corners(np.array(pos) + (0, full[1] / 2, 0), full, about_y(angle))
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)
        assert thing.asset == jid
    assert bedroom.objects[2].mount == "ceiling" and bedroom.objects[0].mount is None
    assert any("1 pieces of furniture" in note for note in bedroom.notes)
    assert any("1 children left out" in note for note in bedroom.notes)


def test_doors_and_windows(file: Path) -> None:
    bedroom, balcony = rooms(file, "3dfront")
    door, window = bedroom.openings
    np.testing.assert_allclose(sorted([door.start, door.end]), [(5.3, -1.4), (5.3, -0.5)], atol=1e-5)
    np.testing.assert_allclose(sorted([window.start, window.end]), [(-0.1, -2.8), (-0.1, -1.0)], atol=1e-5)
    assert (door.kind, door.bottom, door.height) == ("door", 0.0, pytest.approx(2.1))
    assert (window.kind, window.bottom, window.height) == ("window", pytest.approx(0.9), pytest.approx(1.3))
    assert [o.kind for o in balcony.openings] == ["door"]
    assert [r.name for r in rooms(file, "3dfront", room="Balcony-2")] == ["Balcony-2"]


def test_models_of_the_users_folder(file: Path, tmp_path: Path) -> None:
    """A model whose box is not centred on its origin: the pose is that of the mesh, not of a guess."""
    folder = tmp_path / "future"
    (folder / "jid-bed").mkdir(parents=True)
    low, high = np.array([-0.8, 0.02, -1.2]), np.array([1.0, 1.0, 0.8])
    points = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    faces = [(1, 2, 4), (1, 4, 3), (5, 8, 6), (5, 7, 8), (1, 5, 6), (1, 6, 2), (3, 4, 8), (3, 8, 7)]
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in points) + "".join("f {} {} {}\n".format(*f) for f in faces)
    (folder / "jid-bed" / "raw_model.obj").write_text(text)
    (folder / "model_info.json").write_text(
        json.dumps([{"model_id": "jid-bed", "category": "King-size Bed / Queen Bed", "super-category": "Bed"}])
    )
    bed = rooms(file, "3dfront", folder=folder)[0].objects[0]
    assert bed.label == "king-size bed" and bed.mesh == folder / "jid-bed" / "raw_model.obj"
    imported = next(iter(sw.read_scenes(file, "3dfront", folder=folder)))
    thing = imported.scene.objects[0]
    _, _, _, _, pos, angle, scale = THINGS[0]
    centre = about_y(angle) @ ((low + high) / 2 * scale) + pos
    expected = y_up_corners(centre, (high - low) * scale, about_y(angle))
    assert imported.sizes_from[thing.id] == "mesh"
    np.testing.assert_allclose(thing.size, ((high - low) * scale)[[2, 0, 1]], atol=1e-5)  # front, left, up: z, x, y
    front = about_y(angle) @ (0, 0, 1)
    np.testing.assert_allclose(
        thing.pose.frame.world(1, 0), thing.pose.position[:2] + front[[0, 2]] * (1, -1), atol=1e-5
    )
    np.testing.assert_allclose(thing.pose.position[:2], expected.mean(axis=0)[:2], atol=1e-5)
    assert thing.pose.position[2] == pytest.approx(expected[:, 2].min(), abs=1e-5)


def test_a_model_may_not_lie_outside_of_the_folder(tmp_path: Path) -> None:
    data = house()
    data["furniture"][0]["jid"] = "../outside"
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside" / "raw_model.obj").write_text("v 0 0 0\n")
    (tmp_path / "in").mkdir()
    path = tmp_path / "house-1.json"
    path.write_text(json.dumps(data))
    assert rooms(path, "3dfront", folder=tmp_path / "in")[0].objects[0].mesh is None


def test_to_scenes_and_the_judge(file: Path) -> None:
    bedroom, balcony = sw.read_scenes(file)
    assert len(bedroom.scene.room.doors) == 1 and len(bedroom.scene.room.windows) == 1
    assert len(balcony.scene.objects) == 0 and len(balcony.scene.room.doors) == 1
    sw.check(bedroom.scene)


def _set(data: dict, value: object, *keys: object) -> dict:
    changed = copy.deepcopy(data)
    at: Any = changed
    for key in keys[:-1]:
        at = at[key]
    at[keys[-1]] = value
    return changed


CHILD = ("scene", "room", 0, "children", 0)


@pytest.mark.parametrize(
    ("where", "value", "match"),
    [
        ((*CHILD, "pos"), [0, float("nan"), 0], r"children\[0\]: pos: NaN"),
        ((*CHILD, "rot"), [0, 0, 0, 0], "length 0"),
        ((*CHILD, "rot"), [0, 0, 1], "rot: 4 numbers"),
        ((*CHILD, "scale"), [1, 0, 1], "flattens"),
        (("furniture",), {}, "list"),
        (("scene",), {}, "'room' is missing"),
        (("mesh", 0, "faces"), [0, 1, 77], "faces of its mesh"),
        (("mesh", 0, "xyz"), "none", "xyz"),
    ],
)
def test_broken_files_are_one_line(file: Path, where: tuple, value: object, match: str) -> None:
    file.write_text(json.dumps(_set(house(), value, *where)))
    refused("3dfront", file, match=match)


def test_a_file_cut_off_and_an_empty_one(file: Path) -> None:
    text = file.read_text()
    for broken in (text[: len(text) // 2], "", "[]"):
        file.write_text(broken)
        refused("3dfront", file)
