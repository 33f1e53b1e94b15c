"""InstructScene: arrays with a scene graph or an instruction, and its networks' objs and boxes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import about_y, corners, only, refused, rooms, same_ring, y_up_corners

TYPES = ["armchair", "coffee_table", "multi_seat_sofa"]
THINGS = [
    (2, (-0.4, 0.41, 1.5), (1.1, 0.41, 0.46), 2.4),
    (1, (-0.3, 0.2, 0.1), (0.6, 0.2, 0.35), 0.3),
    (0, (1.6, 0.44, -0.2), (0.38, 0.44, 0.41), -1.2),
]


def graph() -> dict[str, Any]:
    """As the networks have it: indices (the fourth is empty) and translation, half size, cos, sin."""
    boxes = [[*t, *s, np.cos(a), np.sin(a)] for _, t, s, a in THINGS]
    return {
        "objs": [*(k for k, *_ in THINGS), 3],
        "boxes": [*boxes, [0.0] * 3 + [0.1] * 3 + [1.0, 0.0]],
        "edges": [[0] * 4] * 4,
        "object_types": TYPES,
    }


def check(objects: Any) -> None:
    assert [o.label for o in objects] == [TYPES[k] for k, *_ in THINGS]
    for thing, (_, centre, half, angle) in zip(objects, THINGS, strict=True):
        expected = y_up_corners(centre, 2 * np.array(half), about_y(angle))
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)


def test_objs_and_boxes(tmp_path: Path) -> None:
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(graph()))
    check(only(rooms(file, "instructscene")).objects)


def test_many_rooms_as_npz(tmp_path: Path) -> None:
    file = tmp_path / "scenes.npz"
    both: dict[str, Any] = {key: np.array([value, value]) for key, value in graph().items() if key != "object_types"}
    np.savez(file, **both, object_types=np.array(TYPES))
    found = rooms(file, "instructscene")
    assert len(found) == 2
    check(found[1].objects)


def test_joined_arrays_with_the_instruction(tmp_path: Path) -> None:
    folder = tmp_path / "0007@abc_LivingRoom-12_cfg1.0_1.0"
    folder.mkdir()
    (folder / "description.txt").write_text("Put a sofa behind a coffee table.\n")
    data = {
        "class_labels": np.eye(4)[[k for k, *_ in THINGS]].tolist(),
        "translations": [t for _, t, _, _ in THINGS],
        "sizes": [s for _, _, s, _ in THINGS],
        "angles": [[a] for *_, a in THINGS],
        "object_types": TYPES,
    }
    (folder / "boxes.json").write_text(json.dumps(data))
    room = only(rooms(folder / "boxes.json", "instructscene"))
    check(room.objects)
    assert room.text == "Put a sofa behind a coffee table."
    (imported,) = sw.read_scenes(folder / "boxes.json")
    assert imported.scene.prompt == room.text
    sw.check(imported.scene)


def test_the_floor_plan_that_the_folders_name_has_in_it(tmp_path: Path) -> None:
    for name, x in (("abc_LivingRoom-1", 100.0), ("abc_LivingRoom-12", 0.0)):
        (tmp_path / "set" / name).mkdir(parents=True)
        floor = np.array([(x, 0, 0), (x + 5, 0, 0), (x + 5, 0, 4), (x, 0, 4)])
        faces = np.array([[0, 1, 2], [0, 2, 3]])
        np.savez(tmp_path / "set" / name / "boxes.npz", floor_plan_vertices=floor, floor_plan_faces=faces)
    folder = tmp_path / "0007@abc_LivingRoom-12_cfg1.0_1.0"
    folder.mkdir()
    (folder / "scene.json").write_text(json.dumps(graph()))
    room = only(rooms(folder / "scene.json", "instructscene", folder=tmp_path / "set"))
    same_ring(room.outline, [(0, 0), (5, 0), (5, -4), (0, -4)])
    assert room.type == "livingroom"
    np.testing.assert_allclose(room.objects[0].position, np.array((-0.4, -1.5, 0.41)) + (2.5, -2.0, 0), atol=1e-9)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"objs": [0, 1, 9, 3]}, "no index"),
        ({"objs": [0, 1]}, "class_labels"),
        ({"boxes": [[0.0] * 5] * 4}, "boxes: 8 numbers"),
        ({"boxes": [[float("nan")] * 8] * 4}, "NaN"),
        ({"object_types": None}, "names of the classes|nothing names"),
        ({"boxes": "none"}, "boxes"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, change: dict, match: str) -> None:
    file = tmp_path / "scene.json"
    file.write_text(json.dumps({**graph(), **change}))
    refused("instructscene", file, match=match)


def test_missing_keys_cut_off_and_empty(tmp_path: Path) -> None:
    file = tmp_path / "scene.json"
    without = {key: value for key, value in graph().items() if key != "objs"}
    for text in (json.dumps(without), json.dumps(graph())[:150], "", "[]"):
        file.write_text(text)
        refused("instructscene", file)
