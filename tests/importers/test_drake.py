"""Drake directives: frames within frames, welds and free bodies, AngleAxis and Rpy, boxes of SDF files."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import compass, require_error, require_pose, rooms_of, things_of, written

HOUSE = """directives:
- add_frame:
    name: house_frame
    X_PF:
      base_frame: world
      translation: [1.0, 2.0, 0.0]
- add_frame:
    name: room_study_frame
    X_PF:
      base_frame: house_frame
      translation: [3.0, -1.5, 0.0]
      rotation: !Rpy
        deg: [0, 0, 90]
- add_model:
    name: room_geometry_study
    file: package://scene/geometry/room.sdf
- add_weld:
    parent: room_study_frame
    child: room_geometry_study::room_geometry_body_link
- add_model:
    name: desk_0
    file: package://scene/assets/desk.sdf
- add_weld:
    parent: room_study_frame
    child: desk_0::base_link
    X_PC:
      translation: [0.4, -0.7, 0.0]
      rotation: !AngleAxis
        angle_deg: 68.75493541569878
        axis: [0.0, 0.0, -2.0]
- add_model:
    name: mug_0
    file: package://scene/assets/mug.sdf
    default_free_body_pose:
      base_link:
        base_frame: desk_0::base_link
        translation: [0.1, 0.05, 0.74]
        rotation: !AngleAxis
          angle_deg: 90.0
          axis: [1.0, 0.0, 0.0]
"""

DESK = """<sdf version="1.9"><model name="desk"><link name="base_link">
<visual name="top"><pose>0.2 0.1 0.72 0 0 0</pose><geometry><box><size>1.4 0.6 0.04</size></box></geometry></visual>
<visual name="leg"><pose degrees="true">0 0 0.35 0 0 90</pose><geometry><box><size>0.5 0.1 0.7</size></box></geometry>
</visual></link></model></sdf>"""

MUG = """<sdf version="1.9"><model name="mug"><link name="base_link"><pose>0 0 0.05 0 0 0</pose><collision name="c">
<geometry><cylinder><radius>0.04</radius><length>0.1</length></cylinder></geometry></collision></link></model></sdf>"""

ROOM = """<sdf version="1.9"><model name="room"><static>true</static><link name="room_geometry_body_link">
<visual name="floor"><pose>0 0 1.3 0 0 0</pose><geometry><box><size>5 3 2.6</size></box></geometry></visual>
</link></model></sdf>"""


def house(folder):
    for name, text in (("assets/desk.sdf", DESK), ("assets/mug.sdf", MUG), ("geometry/room.sdf", ROOM)):
        written(folder, name, text)
    return written(folder, "house.dmd.yaml", HOUSE)


def test_a_house(tmp_path):
    """The room's frame: (x, y) there is (4 - y, 0.5 + x) of the world."""
    (room,) = rooms_of("drake", house(tmp_path)).values()
    assert room.name == "study" and room.height == pytest.approx(2.6)
    np.testing.assert_allclose(room.outline, [(5.5, -2.0), (5.5, 3.0), (2.5, 3.0), (2.5, -2.0)], atol=1e-9)
    things = things_of(room)
    assert set(things) == {"desk_0", "mug_0"} and things["mug_0"].support == "desk_0"
    # the desk: boxes x from -0.5 to 0.9, y from -0.25 to 0.4, z from 0 to 0.74; turned by -1.2 in the room
    yaw = -1.2 + math.pi / 2
    c, s = math.cos(yaw), math.sin(yaw)
    origin = np.array((4.0 + 0.7, 0.5 + 0.4, 0.0))
    middle = np.array((0.2, 0.075, 0.37))
    centre = origin + (c * middle[0] - s * middle[1], s * middle[0] + c * middle[1], middle[2])
    require_pose(things["desk_0"], centre, compass(yaw + math.pi / 2))
    np.testing.assert_allclose(things["desk_0"].size, (0.65, 1.4, 0.74), atol=1e-9)
    # the mug lies on its side: its own z is the desk's -y, its own y is up
    at = origin + (c * 0.1 - s * 0.05, s * 0.1 + c * 0.05, 0.74)
    aside = np.array((s, -c, 0.0))
    require_pose(things["mug_0"], at + 0.05 * aside, (0, 0, 1), aside)
    np.testing.assert_allclose(things["mug_0"].size, (0.08, 0.08, 0.1), atol=1e-9)


def test_directives_within_directives_and_no_sdf(tmp_path):
    written(tmp_path, "sub/desk.dmd.yaml", HOUSE.replace("package://scene/", "package://other/"))
    top = "directives:\n- add_directives:\n    file: sub/desk.dmd.yaml\n    model_namespace: in\n"
    rooms = rooms_of("drake", written(tmp_path, "top.dmd.yaml", top))
    things = things_of(rooms["study"])
    assert things["in::desk_0"].size is None and things["in::desk_0"].label == "desk_0"
    np.testing.assert_allclose(things["in::desk_0"].position, (4.7, 0.9, 0.0), atol=1e-9)
    assert any("SDF" in note for note in rooms["study"].notes)


def test_end_to_end(tmp_path):
    (found,) = sw.read_scenes(house(tmp_path), assets="boxes")
    assert {o.category for o in found.scene.objects} == {"desk", "mug"} and sw.check(found.scene) is not None


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        (HOUSE[:-100] + ": [", ("YAML",)),
        ("", ("must be an object",)),
        ("directives: {}\n", ("directives", "list")),
        (HOUSE.replace("    file: package://scene/assets/desk.sdf\n", ""), ("'file' is missing",)),
        (HOUSE.replace("[0.4, -0.7, 0.0]", "[0.4, .nan, 0.0]"), ("finite",)),
        (
            HOUSE.replace("parent: room_study_frame\n    child: desk_0", "parent: nowhere\n    child: desk_0"),
            ("nowhere",),
        ),
        (HOUSE.replace("base_frame: house_frame", "base_frame: room_study_frame"), ("hangs on itself",)),
        (HOUSE.replace("package://scene/assets/desk.sdf", "../../etc/passwd"), ("outside",)),
    ],
)
def test_broken_files_are_one_line(tmp_path, broken, words):
    require_error(written(tmp_path, "broken.dmd.yaml", broken), "drake", *words)
