"""Habitat: y up, w first, translations of the centre of mass or of the asset's origin, fronts along -z."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.meshes import box_obj
from tests.importers.reading import changed, compass, require_error, rooms_of, things_of, without, written

# x, y (of Habitat, up), z, angle about +y
SEEN = {"sofa": (1.2, 0.4, -2.3, 0.3), "desk": (-0.7, 0.0, 0.9, -1.2), "lamp": (2.0, 0.9, 1.1, 2.4)}


def scene():
    things = [
        {
            "template_name": f"objects/{name}",
            "translation": [x, y, z],
            "rotation": [math.cos(a / 2), 0.0, math.sin(a / 2), 0.0],
            "motion_type": "STATIC",
        }
        for name, (x, y, z, a) in SEEN.items()
    ]
    things[1]["translation_origin"] = "asset_local"
    things[1]["uniform_scale"] = 2.0
    return {"translation_origin": "COM", "stage_instance": {"template_name": "s"}, "object_instances": things}


def test_poses(tmp_path):
    """-z of Habitat is +y of ours, so what is turned by a about the upright faces a + 90 degrees."""
    (room,) = rooms_of("habitat", written(tmp_path, "a.scene_instance.json", scene())).values()
    things = things_of(room)
    for name, (x, y, z, angle) in SEEN.items():
        np.testing.assert_allclose(things[name].position, (x, -z, y), atol=1e-9)
        np.testing.assert_allclose(things[name].rotation @ (1, 0, 0), compass(angle + math.pi / 2), atol=1e-9)
        np.testing.assert_allclose(things[name].rotation @ (0, 0, 1), (0, 0, 1), atol=1e-9)
    assert [things[name].anchor for name in SEEN] == ["centre", "origin", "centre"]
    assert any("stage" in note for note in room.notes) and any("no sizes" in note for note in room.notes)


def test_meshes_configurations_and_regions(tmp_path):
    folder = tmp_path / "data"
    box_obj(folder, "desk", (-0.3, 0.0, -0.5), (0.5, 0.8, 0.1))
    box_obj(folder, "sofa", (0.0, -0.2, 0.0), (0.9, 2.0, 0.8))  # lies on its side: z is up in it, and +y its front
    box_obj(folder, "lamp", (-0.1, 0.0, -0.1), (0.1, 0.6, 0.1))
    config = {"render_asset": "../sofa/raw_model.obj", "up": [0, 0, 1], "front": [0, 1, 0], "COM": [0.1, 0.2, 0.3]}
    written(folder, "configs/sofa.object_config.json", config)
    loop = [[-3, 0.1, -4], [4, 0.1, -4], [4, 0.1, 2], [-3, 0.1, 2]]
    region = {
        "name": "living_0",
        "label": "living room",
        "poly_loop": loop,
        "floor_height": 0.1,
        "extrusion_height": 2.4,
    }
    written(folder, "semantics/scenes/a.semantic_config.json", {"region_annotations": [region]})
    path = written(tmp_path, "a.scene_instance.json", scene())
    (room,) = rooms_of("habitat", path, folder).values()
    assert (room.name, room.type, room.height) == ("living_0", "living room", 2.4)
    np.testing.assert_allclose(room.outline, [(-3, 4), (4, 4), (4, -2), (-3, -2)], atol=1e-9)
    (found,) = sw.read_scenes(path, assets="boxes", folder=folder)
    # the desk, twice as large: 1.2 deep (z), 1.6 wide (x), 1.6 high; the middle 0.2 to the right, 0.4 to the front
    x, y, z, angle = SEEN["desk"]
    front, right = np.array(compass(angle + math.pi / 2)), np.array(compass(angle))
    desk = found.scene.object("desk")
    np.testing.assert_allclose(desk.size, (1.2, 1.6, 1.6), atol=1e-6)
    np.testing.assert_allclose(desk.pose.position, np.array((x, -z, y - 0.1)) + 0.2 * right + 0.4 * front, atol=1e-6)
    # the sofa: its +y becomes -z (the front), its z becomes y; x of it is to the right, as seen along the front
    x, y, z, angle = SEEN["sofa"]
    front, right = np.array(compass(angle + math.pi / 2)), np.array(compass(angle))
    sofa = found.scene.object("sofa")
    np.testing.assert_allclose(sofa.size, (2.2, 0.9, 0.8), atol=1e-6)
    off = np.array((0.45, 0.9, 0.0)) - (0.1, 0.2, 0.3)  # bottom centre from the centre of mass, in the asset's frame
    at = np.array((x, -z, y - 0.1)) + off[0] * right + off[1] * front + (0, 0, off[2])
    np.testing.assert_allclose(sofa.pose.position, at, atol=1e-6)
    lamp = found.scene.object("lamp")
    np.testing.assert_allclose(lamp.pose.position, (2.0, -1.1, 0.9 - 0.3 - 0.1), atol=1e-6)


def test_the_real_file():
    data = Path(__file__).parent / "data" / "dataset_test_scene_0.scene_instance.json"
    (room,) = rooms_of("habitat", data).values()
    first, second = room.objects
    np.testing.assert_allclose((*first.position, *second.position), (0.1, -0.3, 0.2, 0.3, -0.5, 0.4), atol=1e-9)
    assert first.anchor == "origin" and room.outline is None
    (found,) = sw.read_scenes(data, assets="boxes")
    assert found.boundary == "objects"


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (json.dumps(scene())[:-60], ("cut off",)),
        ("", ("empty",)),
        ({"other": 1}, ("object_instances",)),
        (changed(scene(), {}, "object_instances"), ("object_instances", "list")),
        (without(scene(), "object_instances", 1, "template_name"), ("object_instances[1]", "missing")),
        (changed(scene(), math.nan, "object_instances", 1, "translation", 2), ("NaN",)),
        (changed(scene(), [0, 0, 0, 0], "object_instances", 0, "rotation"), ("length 0",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "b.scene_instance.json", broken), "habitat", *words)
