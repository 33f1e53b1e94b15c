"""Floors, surfaces, walls, ceilings and the outline, upright and tilted, on both sides of each threshold."""

import math

import pytest

from tests.verify.build import box, judge, only, rectangle, times, turned

TOP = {"name": "top", "polygon": rectangle(-0.3, -0.6, 0.3, 0.6), "z": 0.7, "headroom": None}


def table(**more):
    board = {**TOP, **more}
    legs = [{"polygon": rectangle(-0.3, -0.6, 0.3, 0.6), "z": [0.65, 0.7]}]
    return box("table", (0.6, 1.2, 0.7), 4.0, 4.0, parts=legs, surfaces=[board])


def cup(x=4.0, y=4.0, z=0.7, height=0.1, **more):
    support = {"object": "table", "surface": "top"}
    return box("cup", (0.1, 0.1, height), x, y, z=z, mount="surface", support=support, **more)


@pytest.mark.parametrize(("z", "count"), [(0.0, 0), (0.0019, 0), (-0.0019, 0), (0.0021, 1), (-0.0021, 1)])
def test_floor(z, count):
    assert judge([box("s", (1, 1, 1), 4, 4, z=z)]).unsupported == count


@pytest.mark.parametrize(
    ("x", "z", "count"),
    [
        (4.0, 0.7, 0),
        (4.0, 0.7018, 0),
        (4.0, 0.7022, 1),
        (4.0, 0.6982, 0),
        (4.0, 0.6978, 1),
        (4.2508, 0.7, 0),
        (4.2512, 0.7, 1),
    ],
)
def test_surface(x, z, count):
    assert judge([table(), cup(x, z=z)]).unsupported == count


@pytest.mark.parametrize(("height", "count"), [(0.3, 0), (0.3009, 0), (0.3011, 1), (0.5, 1)])
def test_head_room(height, count):
    report = judge([table(headroom=0.3), cup(height=height)])
    assert report.unsupported == count
    assert judge([table(), cup(height=height)]).unsupported == 0


def test_what_is_said_of_surfaces():
    found = only(judge([table(headroom=0.3), cup(4.28, z=0.734, height=0.3)]), "unsupported")
    assert found.objects == ("cup", "table")
    assert found.detail == (
        "cup floats 3.4 cm above top of table and reaches 3.0 cm over the edge of top of table"
        " and is 3.4 cm too tall for the head room of top of table"
    )
    assert found.amount == pytest.approx(0.034)
    found = only(judge([box("s", (1, 1, 1), 4, 4, z=-0.01)]), "unsupported")
    assert found.detail == "s sinks 1.0 cm into the floor"
    assert found.objects == ("s",)


def test_every_part_must_be_on_the_surface():
    feet = [{"polygon": rectangle(x, -0.05, x + 0.1, 0.05), "z": [0.0, 0.1]} for x in (-0.25, 0.15)]
    wide = {**cup(4.1), "size": [0.5, 0.1, 0.1], "parts": feet}
    assert judge([table(), wide]).unsupported == 1
    assert judge([table(), {**wide, "parts": feet[:1]}]).unsupported == 0


def test_a_surface_with_a_notch():
    corner = [[-0.3, -0.6], [0.3, -0.6], [0.3, 0.0], [0.0, 0.0], [0.0, 0.6], [-0.3, 0.6]]
    assert judge([table(polygon=corner), cup(3.85, 4.3)]).unsupported == 0
    assert judge([table(polygon=corner), cup(4.15, 4.3)]).unsupported == 1


def on_wall(gap, y=4.0, yaw=0.0, z=1.2):
    return box("tv", (0.08, 1.0, 0.6), 0.04 + gap, y, yaw, z, mount="wall")


@pytest.mark.parametrize(
    ("thing", "count"),
    [
        (on_wall(0.0), 0),
        (on_wall(-0.0009), 0),
        (on_wall(-0.0011), 1),
        (on_wall(0.0709), 0),
        (on_wall(0.0711), 1),
        (on_wall(0.05, yaw=4.9), 0),
        (on_wall(0.05, yaw=5.1), 1),
        (on_wall(0.0, y=0.41), 0),
        (on_wall(0.0, y=0.39), 1),
        (on_wall(0.0, yaw=180.0), 1),
        (box("tv", (0.08, 1.0, 0.6), 4.0, 4.0, mount="wall"), 1),
    ],
)
def test_wall(thing, count):
    assert judge([thing]).unsupported == count


def test_what_is_said_of_walls():
    assert only(judge([on_wall(0.2)]), "unsupported").detail == (
        "tv does not hang on a wall: gap 0.2 m, allowed 0 to 0.07 m"
    )


@pytest.mark.parametrize(("z", "count"), [(2.4, 0), (2.4018, 0), (2.3982, 0), (2.4022, 1), (2.3978, 1)])
def test_ceiling(z, count):
    report = judge([box("lamp", (0.4, 0.4, 0.3), 4, 4, z=z, mount="ceiling")])
    assert report.unsupported == count
    assert report.out_of_bounds == (z > 2.401)


def test_what_hangs_stays_above_the_floor():
    low = {**on_wall(0.0, z=-0.1)}
    assert only(judge([low]), "out_of_bounds").detail == "tv sinks 10.0 cm into the floor"
    assert judge([on_wall(0.0, z=0.0)]).valid


def test_what_hangs_on_walls_may_stand_before_openings():
    door = {"id": "door-0", "wall": 3, "offset": 3.5, "width": 0.9, "height": 2.0}
    assert judge([on_wall(0.0)], doors=[door]).valid
    stood = judge([box("s", (0.08, 1.0, 0.6), 0.04, 4.0)], doors=[door])
    assert only(stood, "blocked_opening").objects == ("s", "door-0")
    assert only(stood, "blocked_opening").detail == "s stands 8.0 cm inside the clear space of door-0"


@pytest.mark.parametrize(("x", "count"), [(0.4995, 0), (0.4985, 1), (7.5005, 0), (7.5015, 1)])
def test_bounds(x, count):
    assert judge([box("s", (1, 1, 1), x, 4)]).out_of_bounds == count


def test_bounds_of_parts_not_of_the_box():
    half = [{"polygon": rectangle(0.0, -0.5, 0.5, 0.5), "z": [0.0, 1.0]}]
    assert judge([box("s", (1, 1, 1), 0.1, 4, parts=half)]).valid


@pytest.mark.parametrize(("height", "count"), [(2.7, 0), (2.7009, 0), (2.7011, 1)])
def test_ceiling_bounds(height, count):
    assert judge([box("s", (1, 1, height), 4, 4)]).out_of_bounds == count


def test_what_is_said_of_bounds():
    found = only(judge([box("s", (1, 1, 3), 0.4, 4)]), "out_of_bounds")
    assert found.detail == "s reaches 10.0 cm out of the room and rises 30.0 cm above the ceiling"
    assert found.amount == pytest.approx(0.3)


def test_a_reflex_corner_in_an_object():
    """All corners of the box are inside, and yet it holds the corner of the walls."""
    outline = [[0, 0], [8, 0], [8, 8], [4.1, 8], [4.0, 4.0], [3.9, 8], [0, 8]]
    found = only(judge([box("s", (1, 1, 1), 4.0, 3.8)], outline=outline), "out_of_bounds")
    assert found.amount == pytest.approx(0.3, abs=0.01)


# ---- tilted


def leaning(degrees, x=4.0, z=0.0, **more):
    """A column 0.4 x 0.4 x 2 m that leans forward about its bottom centre."""
    return box("s", (0.4, 0.4, 2.0), x, 4.0, z=z, quaternion=turned(degrees, "y"), **more)


def test_a_tilted_object_stands_on_its_lowest_corner():
    sunk = 0.2 * math.sin(math.radians(10))
    assert judge([leaning(10.0)]).unsupported == 1
    assert only(judge([leaning(10.0)]), "unsupported").detail == "s sinks 3.5 cm into the floor"
    assert judge([leaning(10.0, z=sunk)]).unsupported == 0
    assert judge([leaning(10.0, z=sunk + 0.0018)]).unsupported == 0
    assert judge([leaning(10.0, z=sunk + 0.0022)]).unsupported == 1


def test_a_tilt_of_half_a_degree_counts_as_upright():
    assert judge([leaning(0.45)]).valid
    assert judge([leaning(0.75)]).unsupported == 1


def test_a_tilted_object_leaves_the_room_by_its_top():
    a = math.radians(10)
    reach, sunk = 2.0 * math.sin(a) + 0.2 * math.cos(a), 0.2 * math.sin(a)
    assert judge([leaning(10.0, 8.0 - reach - 0.001, sunk)]).valid
    found = only(judge([leaning(10.0, 8.0 - reach + 0.05, sunk)]), "out_of_bounds")
    assert found.amount == pytest.approx(0.05)
    top = 2.7 - 2.0 * math.cos(a) - sunk
    assert judge([leaning(10.0, z=top)]).out_of_bounds == 0
    assert judge([leaning(10.0, z=top + 0.0015)]).out_of_bounds == 1


def test_a_tilted_object_blocks_by_its_shadow():
    door = {"id": "door-0", "wall": 1, "offset": 3.5, "width": 1.0, "height": 2.0}
    sunk = 0.2 * math.sin(math.radians(10))
    assert judge([leaning(0.0, 6.7)], doors=[door]).blocked_openings == 0
    assert judge([leaning(10.0, 6.7, sunk)], doors=[door]).blocked_openings == 1


@pytest.mark.parametrize(("tilt", "count"), [(0.0, 0), (3.0, 0), (20.0, 0)])
def test_a_thing_tilts_with_what_carries_it(tilt, count):
    """A cup on a tilted table, moved in the table's frame; the table itself hovers, tilted."""
    lean = turned(tilt, "x")
    a = math.radians(tilt)
    tilted = {**table(), "pose": {"position": [4.0, 4.0, 0.0], "quaternion": lean}}

    def at(left, up, **more):
        return cup(4.0, 4.0 + left * math.cos(a) - up * math.sin(a), left * math.sin(a) + up * math.cos(a), **more)

    def wrong(thing):
        return any(v.kind == "unsupported" and v.objects[0] == "cup" for v in judge([tilted, thing]).violations)

    assert wrong(at(0.2, 0.7, quaternion=lean)) == count
    assert wrong(at(0.2, 0.7025, quaternion=lean))
    assert wrong(at(0.2, 0.6975, quaternion=lean))
    assert not wrong(at(0.5505, 0.7, quaternion=lean))
    assert wrong(at(0.5515, 0.7, quaternion=lean))
    if tilt:
        assert wrong(at(0.2, 0.7))


def test_head_room_of_a_tilted_thing():
    """A cup of 0.30 m that leans 2 degrees on its edge reaches 0.3016 m up."""
    a = math.radians(2)
    thing = cup(z=0.7 + 0.05 * math.sin(a), height=0.3, quaternion=turned(2.0, "x"))
    assert judge([table(headroom=0.304), thing]).unsupported == 0
    assert judge([table(headroom=0.302), thing]).unsupported == 1


def test_yaw_of_a_tilted_object_is_its_heading():
    lean = times(turned(90.0), turned(3.0, "y"))
    report = judge(
        [box("s", (0.4, 0.4, 0.4), 4, 4, quaternion=lean), box("t", (0.4, 0.4, 0.4), 4, 6)],
        [{"type": "facing", "subject": "s", "target": "t", "params": {"degrees": 0.1}}],
    )
    assert report.relations.hard.satisfied == 1
