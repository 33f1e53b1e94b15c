"""RoboCasa: half lengths of walls and floors, full ones of fixtures, alignment, groups; what is built in is cut out."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import compass, require_error, require_pose, rooms_of, things_of, written

DATA = Path(__file__).parent / "data"

LAYOUT = """
room:
  walls:
    - {name: wall, type: wall, size: [2.5, 1.4, 0.02], pos: [2.5, 0, 1.4]}
    - {name: wall_back, type: wall, backing: true, size: [2.5, 1.4, 0.1], pos: [2.5, 0, 1.4]}
    - {name: wall_left, type: wall, wall_side: left, size: [1.6, 1.4, 0.02], pos: [0, -1.6, 1.4]}
  floor:
    - {name: floor, type: floor, size: [2.5, 1.6, 0.02], pos: [2.5, -1.6, 0]}
    - {name: nook, type: floor, size: [0.5, 0.4, 0.02], pos: [5.5, -0.4, 0]}
  wall_accessories:
    - {name: window, type: window, size: [1.2, 0.03, 0.9], attach_to: wall_left, pos: [null, -1.1, 1.6]}
  floor_accessories:
    - {name: stool, type: stool, size: [0.3, 0.35, 0.6], attach_to: floor, z_rot: 0.4, pos: [3.1, -2.2, null]}
main_group:
  bottom_row:
    - {name: sink, type: sink, size: [0.5, 0.4, 0.2]}
    - {name: counter, type: counter, interior_obj: sink, obj_x_percent: 0.3, obj_y_percent: 0.5,
       size: [1.9, 0.65, 0.92], pos: [1.2, -0.325, 0.46]}
    - {name: stove, type: stove, size: [0.7, 0.6, 0.9], align_to: counter, side: right, alignment: top_back,
       offset: [0.01, -0.02, -0.01]}
    - {name: fridge, type: fridge_french_door, size: [0.8, 0.7, 1.7]}
    - {name: housing, type: housing_cabinet, interior_obj: fridge, padding: [[0.03, 0.02], [-0.04, 0.05], [0, 0.02]],
       align_to: stove, side: right, alignment: bottom_back}
    - {name: toaster, type: toaster, placement: {fixture: counter_main_group, size: [0.5, 0.4]}}
    - {name: unused, type: blender, enable: false}
  cabinets:
    - {name: stack, type: stack, levels: [drawer], percentages: [1], size: [0.9, 0.6, 0.84], pos: [0.75, -0.3, 0.47]}
    - {name: cab, type: hinge_cabinet, size: [stove, 0.4, null], align_to: stove, side: top, alignment: back,
       stack_height: 2.3, stack_fixtures: [stove]}
side_group:
  group_origin: [0.5, -0.25]
  group_pos: [4.0, -2.0]
  group_z_rot: -1.2
  row:
    - {name: box, type: box, size: [0.6, 0.4, 0.8], pos: [1.5, -0.2, 0.4]}
"""

FACING = compass(-math.pi / 2)


def test_alignment_and_groups(tmp_path):
    (room,) = rooms_of("robocasa", written(tmp_path, "layout.yaml", LAYOUT)).values()
    assert room.height == pytest.approx(2.8)
    corners = {(round(x, 6), round(y, 6)) for x, y in room.outline}
    assert corners == {(0, 0), (6, 0), (6, -0.8), (5, -0.8), (5, -3.2), (0, -3.2)}
    things = {name.removesuffix("_main_group"): thing for name, thing in things_of(room).items()}
    expected = {
        "counter": ((1.2, -0.325, 0.46), (0.65, 1.9, 0.92)),
        "sink": ((1.2 - 0.2 * 1.9, -0.325, 0.82), (0.4, 0.5, 0.2)),
        # right of the counter, which ends at 2.15; its back at 0 and its top at 0.92 before the offset
        "stove": ((2.15 + 0.35 + 0.01, -0.3 - 0.02, 0.47 - 0.01), (0.6, 0.7, 0.9)),
        # 0.8 + 0.05 wide, 0.7 + 0.01 deep, 1.7 + 0.02 high; bottom and back flush with the stove's
        "housing": ((2.86 + 0.425, -0.02 - 0.355, 0.01 + 0.86), (0.71, 0.85, 1.72)),
        "fridge": ((2.86 + 0.03 + 0.4, -0.73 - 0.04 + 0.35, 0.01 + 0.85), (0.7, 0.8, 1.7)),
        "stack": ((0.75, -0.3, 0.47), (0.6, 0.9, 0.84)),
        "cab": ((2.51, -0.02 - 0.2, 0.91 + 0.7), (0.4, 0.7, 1.4)),
    }
    for name, (centre, size) in expected.items():
        require_pose(things[name], centre, FACING)
        np.testing.assert_allclose(things[name].size, size, atol=1e-9, err_msg=name)
    c, s = math.cos(-1.2), math.sin(-1.2)
    require_pose(things["box_side_group"], (4 + c - s * 0.05, -2 + s + c * 0.05, 0.4), compass(-1.2 - math.pi / 2))
    require_pose(things["stool_room"], (3.1, -2.2, 0.3 + 0.0), compass(0.4 - math.pi / 2))
    (window,) = room.openings
    np.testing.assert_allclose(sorted((window.start[1], window.end[1])), (-1.7, -0.5), atol=1e-9)
    assert (window.bottom, window.height) == (pytest.approx(1.15), pytest.approx(0.9))
    assert any("toaster" in note for note in room.notes) and any("unused_main_group" in note for note in room.notes)


def test_built_in_things_do_not_collide(tmp_path):
    path = written(tmp_path, "layout.yaml", LAYOUT.replace("[0.01, -0.02, -0.01]", "[0, 0, 0]"))
    (room,) = rooms_of("robocasa", path).values()
    counter = things_of(room)["counter_main_group"]
    assert counter.parts and min(low[2] for low, _ in counter.parts) == pytest.approx(0.89)
    area = sum((x1 - x0) * (y1 - y0) for (x0, y0, _), (x1, y1, _) in counter.parts)
    assert area == pytest.approx(1.9 * 0.65 - 0.5 * 0.4)
    (found,) = sw.read_scenes(path, assets="boxes")
    assert sw.check(found.scene).collisions == 0


def test_built_in_things_rest_in_what_holds_them_and_go_with_it(tmp_path):
    path = written(tmp_path, "layout.yaml", LAYOUT.replace("[0.01, -0.02, -0.01]", "[0, 0, 0]"))
    (room,) = sw.read_scenes(path, assets="boxes")
    held = {o.id: o.support for o in room.scene.objects if o.support is not None}
    assert {name: support.object for name, support in held.items()} == {
        "sink_main_group": "counter_main_group",
        "fridge_main_group": "housing_main_group",
    }
    for name, support in held.items():
        holder, obj = room.scene.object(support.object), room.scene.object(name)
        (hollow,) = (s for s in holder.surfaces if s.name == support.surface)
        assert hollow.name.startswith("hollow")
        assert holder.pose.position[2] + hollow.z == pytest.approx(obj.pose.position[2], abs=1e-9)
    wrong = {v.objects[0] for v in sw.check(room.scene).violations if v.kind == "unsupported"}
    assert not wrong & set(held)


def test_sizes_of_the_models_of_a_style(tmp_path):
    folder = tmp_path / "assets"
    sites = {"p0": "-0.2 -0.3 0", "px": "0.4 -0.3 0", "py": "-0.2 0.1 0", "pz": "-0.2 -0.3 0.8"}
    rows = "".join(f'<site name="ext_{end}" pos="{pos}"/>' for end, pos in sites.items())
    written(folder, "fixtures/stoves/Stove7/model.xml", f"<mujoco><worldbody><body>{rows}</body></worldbody></mujoco>")
    written(tmp_path, "style001.yaml", "stove: Stove7\ncabinet: {default: [gray]}\n")
    layout = LAYOUT.replace(
        "size: [0.7, 0.6, 0.9], align_to: counter, side: right", "pos: [3, -1, 0.1], size: [null, 0.8, null]"
    )
    layout = layout.replace(", alignment: top_back,\n       offset: [0.01, -0.02, -0.01]", "")
    (room,) = rooms_of("robocasa", written(tmp_path, "layout001.yaml", layout), folder).values()
    stove = things_of(room)["stove_main_group"]
    assert stove.asset == "Stove7"
    # twice as large as the model: 1.2 x 0.8 x 1.6, its middle 0.2, -0.2, 0.8 from the origin
    np.testing.assert_allclose(stove.size, (0.8, 1.2, 1.6), atol=1e-9)
    require_pose(stove, (3.2, -1.2, 0.9), FACING)


@pytest.mark.parametrize("number", ["001", "004", "011"])
def test_real_kitchens(number):
    (found,) = sw.read_scenes(DATA / f"robocasa_layout{number}.yaml", assets="boxes", relations=False)
    report = sw.check(found.scene)
    assert len(found.scene.objects) > 20 and report.collisions <= 1 and report.valid == (number == "001")
    assert found.scene.room.height == pytest.approx(3.0) and found.scene.room.type == "kitchen"


def test_sizes_that_the_reader_assumes_are_not_the_files(tmp_path):
    layout = LAYOUT.replace("{name: sink, type: sink, size: [0.5, 0.4, 0.2]}", "{name: sink, type: sink}")
    layout = layout.replace("size: [0.7, 0.6, 0.9], align_to", "size: [0.7, null, null], align_to")
    (found,) = sw.read_scenes(written(tmp_path, "layout.yaml", layout), assets="boxes", relations=False)
    assumed = {name.removesuffix("_main_group") for name, origin in found.sizes_from.items() if origin == "category"}
    assert assumed == {"sink", "stove", "cab"}  # the cabinet is as wide as the stove, and begins at its top
    assert set(found.sizes_from.values()) == {"file", "category"}
    told = found.scene.provenance["imported"]["objects"]
    assert told["stove_main_group"]["size_from"] == "category" and told["fridge_main_group"]["size_from"] == "file"


def test_poses_of_a_real_kitchen():
    """By hand from layout001: sizes are in the file from the counter to the cabinets above."""
    (room,) = rooms_of("robocasa", DATA / "robocasa_layout001.yaml").values()
    things = things_of(room)
    require_pose(things["counter_main_main_group"], (1.5, -0.325, 0.46), FACING)
    require_pose(things["cab_2_main_group"], (1.25, -0.2, 1.85), FACING)
    require_pose(things["cab_main_main_group"], (2.25, -0.2, 1.85), FACING)
    require_pose(things["dishwasher_main_group"], (1.75 + 0.325, -0.3, 0.89 - 0.445), FACING)


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (LAYOUT[:1200], ("YAML",)),
        (LAYOUT.replace("type: stove,", ""), ("'type' is missing",)),
        (LAYOUT.replace("align_to: stove, side: top", "align_to: nothing, side: top"), ("not before it",)),
        (LAYOUT.replace("pos: [0.75, -0.3, 0.47]", "pos: [0.75, .nan, 0.47]"), ("finite",)),
        (LAYOUT.replace("side: top", "side: above"), ("must be one of",)),
        ("room:\n  walls:\n    - {name: wall, type: wall, size: [1, 1, 1], pos: [0, 0, 0]}\n", ("no floor",)),
        ("", ("object",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "broken.yaml", broken), "robocasa", *words)
