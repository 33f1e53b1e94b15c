"""SpatialLM: walls that enclose two rooms, openings by their centres, boxes by centre and angle about z."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import SIGNS, corners, only, refused, rooms, same_ring

WALLS = """\
wall_0=Wall(1.0,1.0,0.0,7.5,1.0,0.0,2.7,0.0)
wall_1=Wall(7.5,1.0,0.0,7.5,4.0,0.0,2.7,0.0)
wall_2=Wall(7.5,4.0,0.0,3.2,4.0,0.0,2.7,0.0)
wall_3=Wall(3.2,4.0,0.0,3.2,6.2,0.0,2.7,0.0)
wall_4=Wall(3.2,6.2,0.0,1.0,6.2,0.0,2.7,0.0)
wall_5=Wall(1.0,6.2,0.0,1.0,1.0,0.0,2.7,0.0)
wall_6=Wall(5.6,1.0,0.0,5.6,4.0,0.0,2.7,0.0)
"""
REST = """\
door_0=Door(wall_6,5.6,2.2,1.0,0.9,2.0)
window_0=Window(wall_0,2.5,1.0,1.5,1.4,1.2)
bbox_0=Bbox(dining_table,3.9,2.4,0.37,0.3,1.6,0.9,0.74)
bbox_1=Bbox(wardrobe,7.0,2.9,1.0,-1.2,1.4,0.6,2.0)
bbox_2=Bbox(sofa,1.9,5.4,0.42,2.4,1.8,0.8,0.84)
"""
BOXES = {
    "dining_table": ((3.9, 2.4, 0.37), 0.3, (1.6, 0.9, 0.74)),
    "wardrobe": ((7.0, 2.9, 1.0), -1.2, (1.4, 0.6, 2.0)),
    "sofa": ((1.9, 5.4, 0.42), 2.4, (1.8, 0.8, 0.84)),
}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "scene0000_00.txt"
    path.write_text(WALLS + REST)
    return path


def test_poses_by_an_independent_route(file: Path) -> None:
    """A box's own -y is the front: its extent along y is the depth, and +x is its left, seen from inside the box."""
    found = [thing for room in rooms(file, "spatiallm") for thing in room.objects]
    assert {thing.label for thing in found} == set(BOXES)
    for thing in found:
        centre, angle, (sx, sy, sz) = BOXES[thing.label]
        c, s = np.cos(angle), np.sin(angle)
        local = [(left * sx / 2, -front * sy / 2, up * sz / 2) for front, left, up in SIGNS]
        expected = [(centre[0] + c * x - s * y, centre[1] + s * x + c * y, centre[2] + z) for x, y, z in local]
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)


def test_walls_enclose_two_rooms(file: Path) -> None:
    """The largest is the L; the other is behind wall 6, which ends in the middle of two walls."""
    large, small = rooms(file, "spatiallm")
    same_ring(large.outline, [(1, 1), (5.6, 1), (5.6, 4), (3.2, 4), (3.2, 6.2), (1, 6.2)])
    same_ring(small.outline, [(5.6, 1), (7.5, 1), (7.5, 4), (5.6, 4)])
    assert [o.label for o in large.objects] == ["dining_table", "sofa"] and large.height == 2.7
    assert [o.label for o in small.objects] == ["wardrobe"]


def test_openings_lie_along_their_wall(file: Path) -> None:
    large, small = rooms(file, "spatiallm")
    door, window = large.openings
    np.testing.assert_allclose(sorted([door.start, door.end]), [(5.6, 1.75), (5.6, 2.65)], atol=1e-5)
    np.testing.assert_allclose(sorted([window.start, window.end]), [(1.8, 1.0), (3.2, 1.0)], atol=1e-5)
    assert (door.bottom, door.height) == (0.0, 2.0)
    assert (window.bottom, window.height) == (pytest.approx(0.9), 1.2)
    assert [o.name for o in small.openings] == ["door_0"]


def test_ends_that_nearly_meet(tmp_path: Path) -> None:
    """Ends of the grid of 2.5 cm meet in their mean."""
    file = tmp_path / "room.txt"
    file.write_text(
        "wall_0=Wall(0,0,0.5,4.0,0,0.5,2.5,0)\nwall_1=Wall(4.04,0,0.5,4.0,3,0.5,2.5,0)\n"
        "wall_2=Wall(4.0,3.04,0.5,0,3,0.5,2.5,0)\nwall_3=Wall(0,3,0.5,0,0.04,0.5,2.5,0)\n"
        "bbox_0=Bbox(bed,2,1.5,0.8,0,1.5,2,0.6)\n"
    )
    room = only(rooms(file, "spatiallm"))
    same_ring(room.outline, [(0, 0.02), (4.02, 0), (4.0, 3.02), (0, 3)])
    assert room.objects[0].position == pytest.approx((2, 1.5, 0.3))


def test_boxes_without_walls(tmp_path: Path) -> None:
    file = tmp_path / "boxes.txt"
    file.write_text("bbox_0=Bbox(bed,2,1.5,0.3,0,1.5,2,0.6)\n")
    room = only(rooms(file, "spatiallm"))
    assert room.outline is None and len(room.objects) == 1


def test_to_scenes_and_the_judge(file: Path) -> None:
    large, small = sw.read_scenes(file)
    assert len(large.scene.room.doors) == 1 and len(large.scene.room.windows) == 1
    assert [o.category for o in small.scene.objects] == ["wardrobe"]
    sw.check(large.scene)


@pytest.mark.parametrize(
    ("line", "match"),
    [
        ("bbox_3=Bbox(bed,1,2,0.3,0,1.5,2)", "line 13: 7 values"),
        ("bbox_3=Bbox(bed,1,nan,0.3,0,1.5,2,1)", "finite"),
        ("bbox_3=Bbox(bed,1,__import__('os'),0.3,0,1.5,2,1)", "no entity"),
        ("bbox_3=Bbox(bed,1,one,0.3,0,1.5,2,1)", "no number"),
        ("wall_0=Wall(0,0,0,1,1,0,2.5,0)", "stands twice"),
        ("door_1=Door(5,1,1,1,1,1)", "no wall"),
        ("bbox_3=Bbox(bed,1,1,0.3,0,0,2,1)", "extent is 0"),
        ("here are the walls", "no entity"),
    ],
)
def test_broken_lines_are_one_line(file: Path, line: str, match: str) -> None:
    file.write_text(WALLS + REST + line + "\n")
    refused("spatiallm", file, match=match)


def test_a_file_cut_off_an_empty_one_and_no_text(file: Path) -> None:
    for content in ((WALLS + REST)[:70].encode(), b"", b"\n\n", b"\xff\xfe\x00"):
        file.write_bytes(content)
        refused("spatiallm", file)
