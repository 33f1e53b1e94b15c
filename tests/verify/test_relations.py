"""Relations on both sides of each threshold: those that the oracle lacks, parameters, what is said when they fail."""

import math

import pytest

from sceneweaver.io import InputError
from sceneweaver.scene import catalogue
from sceneweaver.scene.catalogue import CATALOGUE, RelationSpec
from sceneweaver.verify import register_judge
from sceneweaver.verify.relations import JUDGES
from tests.verify.build import beside, box, judge, only, rectangle, relation

DOOR = {"id": "door-0", "wall": 0, "offset": 1.0, "width": 0.9, "height": 2.0, "swing": "in-left"}
WINDOWS = [
    {"id": "window-0", "wall": 1, "offset": 2.0, "width": 1.2, "sill": 0.9, "height": 1.2},
    {"id": "window-1", "wall": 2, "offset": 2.0, "width": 1.2, "sill": 0.9, "height": 1.2},
]


def holds(objects, rel, **room) -> bool:
    tally = judge(objects, [rel], **room).relations.hard
    assert tally.total == 1
    return tally.satisfied == 1


def test_every_type_has_a_judge():
    assert all(CATALOGUE[name].ways for name in catalogue.BUILT_IN) and not JUDGES


@pytest.mark.parametrize("yaw", [0.0, 30.0, 205.0])
@pytest.mark.parametrize(
    ("beyond", "aside", "expected"),
    [
        (0.5, 0.0, True),
        (-0.0008, 0.0, True),
        (-0.0015, 0.0, False),
        (1.5008, 0.0, True),
        (1.5015, 0.0, False),
        (0.5, 0.749, True),
        (0.5, 0.751, False),
        (0.5, -0.749, True),
        (0.5, -0.751, False),
    ],
)
@pytest.mark.parametrize("kind", ["left_of", "right_of", "in_front_of", "behind"])
def test_beside_a_face(kind, beyond, aside, expected, yaw):
    target = box("t", (1.0, 1.4, 0.7), 4.0, 4.0, yaw)
    if kind in ("left_of", "right_of"):  # these faces are 1.0 m wide, the others 1.4 m
        ahead, left = aside, (0.7 + beyond) * (1 if kind == "left_of" else -1)
    else:
        ahead, left = (0.5 + beyond) * (1 if kind == "in_front_of" else -1), aside * 1.4
    subject = box("s", (0.3, 0.3, 0.3), *beside(target, ahead, left), 77.0)
    assert holds([target, subject], relation(kind, "s", "t")) is expected


def test_beside_a_face_params():
    target, subject = box("t", (1.0, 1.0, 0.7), 4.0, 4.0), box("s", (0.3, 0.3, 0.3), 4.9, 6.0)
    assert not holds([target, subject], relation("left_of", "s", "t"))
    assert holds([target, subject], relation("left_of", "s", "t", max=1.6, band=1.9))
    assert not holds([target, subject], relation("left_of", "s", "t", min=1.502, max=1.6, band=1.9))


@pytest.mark.parametrize(
    ("ahead", "left", "expected"),
    [
        (0.0, 1.2, True),
        (0.0, -1.2, True),
        (0.7, 1.2, True),
        (0.8, 1.2, False),
        (0.0, 0.99, False),
        (0.0, -1.41, False),
        (1.2, 0.0, False),
    ],
)
def test_beside(ahead, left, expected):
    """The target's sides are 0.7 m from its middle and 1.0 m wide."""
    target = box("t", (1.0, 1.4, 0.7), 4.0, 4.0, 30.0)
    subject = box("s", (0.3, 0.3, 0.3), *beside(target, ahead, left), 77.0)
    assert holds([target, subject], relation("beside", "s", "t", min=0.3, max=0.7)) is expected


@pytest.mark.parametrize(
    ("ahead", "left", "params", "expected"),
    [
        (0.9, 0.05, {}, True),
        (0.9, 0.2, {}, False),
        (0.9, 0.05, {"axis": "width"}, True),
        (0.05, 0.9, {"axis": "width"}, False),
        (0.9, 0.05, {"axis": "both"}, False),
        (0.05, 0.09, {"axis": "both"}, True),
        (0.9, 0.05, {"ahead": [0.8, 1.0]}, True),
        (0.7, 0.05, {"ahead": [0.8, 1.0]}, False),
        (-0.9, 0.05, {"ahead": [0.8, 1.0]}, False),
        (0.9, 0.2, {"ahead": [0.8, 1.0]}, False),
    ],
)
def test_centered_on_axes(ahead, left, params, expected):
    target = box("t", (2.0, 1.4, 0.7), 4.0, 4.0, 30.0)
    subject = box("s", (0.3, 0.3, 0.3), *beside(target, ahead, left), 77.0)
    assert holds([target, subject], relation("centered_on", "s", "t", **params)) is expected


@pytest.mark.parametrize(
    ("kind", "ahead", "params"), [("front_to_front", 1.0, {"gap": [0.3, 0.5]}), ("facing", 3.0, {})]
)
@pytest.mark.parametrize(
    ("left", "offset", "expected"), [(0.3, None, True), (0.3, 0.1, False), (0.09, 0.1, True), (-0.11, 0.1, False)]
)
def test_on_the_axis_of_the_target(kind, ahead, params, left, offset, expected):
    target = box("t", (0.8, 2.0, 0.7), 4.0, 4.0, 30.0)
    subject = box("s", (0.4, 1.0, 0.4), *beside(target, ahead, left), 210.0)
    params = params | ({} if offset is None else {"offset": offset})
    assert holds([target, subject], relation(kind, "s", "t", **params)) is expected


@pytest.mark.parametrize(("ahead", "turned", "backs", "expected"), [
    (0.3, 0.0, None, True),
    (0.3, 0.0, 0.05, False),
    (-0.56, 0.0, 0.05, False),
    (-0.46, 0.0, 0.05, True),
    (-0.46, 180.0, None, True),
    (-0.46, 180.0, 0.05, False),
])  # fmt: skip
def test_side_by_side_with_the_backs_in_line(ahead, turned, backs, expected):
    """The target's back is 0.7 m behind its middle, the subject's 0.2 m."""
    target = box("t", (1.4, 1.0, 0.7), 4.0, 4.0, 30.0)
    subject = box("s", (0.4, 0.6, 0.4), *beside(target, ahead, 0.82), 30.0 + turned)
    params = {} if backs is None else {"backs": backs}
    assert holds([target, subject], relation("leftright_to_leftright", "s", "t", **params)) is expected


@pytest.mark.parametrize(("wall", "expected"), [(1, False), (3, True)])
def test_against_a_wall_without_a_door(wall, expected):
    """The box stands at wall 3."""
    thing = box("s", (0.4, 1.0, 1.0), 0.2, 4.0)
    doors = [{"id": "door-0", "wall": 4 - wall, "offset": 1.0, "width": 0.9, "height": 2.0}]
    assert holds([thing], relation("against_wall", "s"), doors=doors)
    assert holds([thing], relation("against_wall", "s", door_walls="avoided"), doors=doors) is expected


@pytest.mark.parametrize(("off", "expected"), [(0.15, True), (-0.15, True), (0.25, False)])
def test_against_the_middle_of_a_wall(off, expected):
    """Wall 3 is 8 m long."""
    thing = box("s", (0.4, 1.0, 1.0), 0.2, 4.0 + off)
    assert holds([thing], relation("against_wall", "s"))
    assert holds([thing], relation("against_wall", "s", "wall:3", middle=0.2)) is expected


@pytest.mark.parametrize(
    ("along", "aside", "expected"),
    [
        (2.0, 0.0, True),
        (0.801, 0.0, True),
        (0.799, 0.0, False),
        (3.199, 0.0, True),
        (3.201, 0.0, False),
        (2.0, 0.499, True),
        (2.0, 0.501, False),
        (2.0, -0.501, False),
    ],
)
def test_between(along, aside, expected):
    a = box("a", (0.4, 0.4, 0.4), 2.0, 2.0)
    angle = math.radians(35)
    b = box("b", (0.4, 0.4, 0.4), 2.0 + 4 * math.cos(angle), 2.0 + 4 * math.sin(angle))
    x = 2.0 + along * math.cos(angle) - aside * math.sin(angle)
    y = 2.0 + along * math.sin(angle) + aside * math.cos(angle)
    assert holds([a, b, box("s", (0.2, 0.2, 0.2), x, y)], relation("between", "s", ["a", "b"])) is expected
    assert holds([a, b, box("s", (0.2, 0.2, 0.2), x, y)], relation("between", "s", ["b", "a"])) is expected


def test_between_params_and_one_place():
    a, b = box("a", (0.4, 0.4, 0.4), 2.0, 2.0), box("b", (0.4, 0.4, 0.4), 6.0, 2.0)
    s = box("s", (0.2, 0.2, 0.2), 2.4, 2.8)
    assert not holds([a, b, s], relation("between", "s", ["a", "b"]))
    assert holds([a, b, s], relation("between", "s", ["a", "b"], along=[0.0, 0.5], aside=1.0))
    report = judge([a, {**b, "pose": a["pose"]}, s], [relation("between", "s", ["a", "b"])])
    assert "one place" in only(report, "relation").detail


def around(angles, radius=0.85, sides=8, turn=None, **params):
    """Chairs at these angles about a round table 1.2 m wide, and the table; ``turn`` turns the first."""
    r = 0.6 / math.cos(math.pi / sides)
    ring = [
        [r * math.cos(math.tau * (k + 0.5) / sides), r * math.sin(math.tau * (k + 0.5) / sides)] for k in range(sides)
    ]
    table = box("t", (1.2, 1.2, 0.74), 4.0, 4.0, parts=[{"polygon": ring, "z": [0.7, 0.74]}])
    chairs = []
    for k, angle in enumerate(angles):
        x, y = 4 + radius * math.cos(math.radians(angle)), 4 + radius * math.sin(math.radians(angle))
        yaw = angle + 180 + (turn or 0.0) * (k == 0)
        seat = [{"polygon": rectangle(-0.2, -0.2, 0.2, 0.2), "z": [0.0, 0.45]}]
        chairs.append(box(f"c{k}", (0.45, 0.45, 0.6), x, y, yaw, parts=seat))
    report = judge([table, *chairs], [relation("around", c["id"], "t", **params) for c in chairs])
    return report.relations.hard.satisfied, report


@pytest.mark.parametrize(
    ("angles", "satisfied"),
    [
        ([0, 90, 180, 270], 4),
        ([0, 90, 180, 246], 4),
        ([0, 90, 180, 244], 1),
        ([45, 225], 2),
        ([45, 201], 2),
        ([45, 199], 0),
        ([135], 1),
        ([0, 60, 120, 180, 240, 300], 6),
        ([0, 114, 180, 270], 4),
        ([0, 116, 180, 270], 1),
        ([350, 80, 170, 260], 4),
    ],
)
def test_around_is_even(angles, satisfied):
    assert around(angles, sides=24)[0] == satisfied


def test_around_an_octagon():
    """An edge for every 45 degrees: 15 degrees off its normal will do, 22 will not."""
    assert around([0, 60, 120, 180, 240, 300])[0] == 6
    assert around([0, 90, 180, 247])[0] == 3


def test_around_has_the_front_to_an_edge():
    assert around([0, 180], turn=14.0)[0] == 2
    found, report = around([0, 180], turn=16.0)
    assert found == 1
    assert only(report, "relation").detail == "c0 around t: turned 16 deg, allowed 15"
    assert only(report, "relation").amount == pytest.approx(1.0)
    assert around([0, 180], radius=0.6 + 0.225 + 0.0505)[0] == 2  # gap 0.0505
    assert around([0, 180], radius=0.6 + 0.225 + 0.0515)[0] == 0
    assert around([0, 180], radius=0.6 + 0.225 - 0.3605)[0] == 2  # 0.8 of the depth is 0.36
    assert around([0, 180], radius=0.6 + 0.225 - 0.3615)[0] == 0


def test_around_n_and_spread():
    assert around([0, 90, 180])[0] == 0  # gaps of 90, 90 and 180 where 120 are even
    assert around([0, 90, 180], spread=70)[0] == 3
    assert around([0, 90, 180], n=4)[0] == 1
    assert around([0, 90], n=4)[0] == 0
    assert around([10], n=4)[0] == 1


@pytest.mark.parametrize(("gap", "expected"), [(0.9995, True), (0.9985, False), (2.0, True), (0.0, False)])
def test_away_from_door(gap, expected):
    other = {**DOOR, "id": "door-1", "wall": 2}
    s = box("s", (0.4, 0.4, 0.4), 1.45, 0.9 + gap + 0.2)
    assert holds([s], relation("away_from_door", "s", "door-0"), doors=[DOOR, other]) is expected
    assert holds([s], relation("away_from_door", "s"), doors=[DOOR, other]) is expected
    assert holds([s], relation("away_from_door", "s", "door-1"), doors=[DOOR, other])
    assert holds([s], relation("away_from_door", "s"))
    assert holds([s], relation("away_from_door", "s", min=gap), doors=[DOOR])


def test_away_from_door_measures_parts():
    """An L whose notch holds the zone is not near it, though its box would be."""
    s = box("s", (4.0, 4.0, 0.4), 3.0, 2.05, parts=[{"polygon": rectangle(1.0, -2.0, 2.0, 2.0), "z": [0.0, 0.4]}])
    assert holds([s], relation("away_from_door", "s", min=2.0), doors=[DOOR])
    assert not holds([s], relation("away_from_door", "s", min=2.2), doors=[DOOR])


@pytest.mark.parametrize(
    ("dx", "dz", "expected"),
    [
        (0.0, 0.0, True),
        (0.0, -0.0008, True),
        (0.0, -0.0012, False),
        (0.7008, 0.3, True),
        (-0.7008, 0.3, True),
        (0.7012, 0.3, False),
        (-0.7012, 0.3, False),
    ],
)
def test_above_and_below(dx, dz, expected):
    target = box("t", (0.5, 1.4, 0.8), 4.0, 0.25, 90.0)
    mirror = box("s", (0.05, 0.6, 0.5), 4.0 + dx, 0.03, 90.0, 0.8 + dz, mount="wall")
    assert holds([target, mirror], relation("above", "s", "t")) is expected
    same = (0.5, 1.4, 0.8)
    low, high = box("t", same, 4.0, 0.25, 90.0, 0.8 + dz), box("s", same, 4.0 + dx, 0.25, 90.0)
    assert holds([low, high], relation("below", "s", "t")) is expected


def test_above_param():
    target, s = box("t", (0.5, 1.4, 0.8), 4.0, 4.0), box("s", (0.5, 1.4, 0.8), 4.0, 5.0, z=1.0)
    assert not holds([target, s], relation("above", "s", "t"))
    assert holds([target, s], relation("above", "s", "t", lateral=0.8))


@pytest.mark.parametrize(("dz", "expected"), [(0.0, True), (0.0308, True), (-0.0308, True), (0.0312, False)])
def test_same_height(dz, expected):
    a = box("a", (0.05, 0.6, 0.5), 2.0, 0.03, 90.0, 1.0, mount="wall")
    b = box("b", (0.05, 0.6, 0.9), 4.0, 0.03, 90.0, 1.0 + dz, mount="wall")
    assert holds([a, b], relation("same_height", "a", "b")) is expected
    assert holds([a, b], relation("same_height", "a", "b", tolerance=0.05))


@pytest.mark.parametrize(("z", "expected"), [(0.0, True), (0.0019, True), (-0.0019, True), (0.0021, False)])
def test_on_floor(z, expected):
    assert holds([box("s", (1, 1, 1), 4, 4, z=z)], relation("on_floor", "s")) is expected


def shelf(headroom=0.4):
    boards = [
        {"name": "top", "polygon": rectangle(-0.2, -0.5, 0.2, 0.5), "z": 1.0, "headroom": None},
        {"name": "board", "polygon": rectangle(-0.2, -0.5, 0.2, 0.5), "z": 0.5, "headroom": headroom},
    ]
    parts = [{"polygon": rectangle(-0.2, -0.5, 0.2, 0.5), "z": z} for z in ([0.0, 0.5], [0.98, 1.0])]
    return box("t", (0.4, 1.0, 1.0), 4.0, 4.0, 30.0, parts=parts, surfaces=boards)


def resting(surface, z, left=0.0, height=0.3, mount="surface"):
    support = {"object": "t", "surface": surface} if mount == "surface" else None
    return box("s", (0.2, 0.2, height), *beside(shelf(), 0.0, left), 30.0, z, mount=mount, support=support)


@pytest.mark.parametrize(
    ("kind", "thing", "expected"),
    [
        ("on_top", resting("top", 1.0), True),
        ("on_top", resting("top", 1.0025), False),
        ("on_top", resting("top", 1.0, 0.4005), True),
        ("on_top", resting("top", 1.0, 0.4015), False),
        ("inside", resting("top", 1.0), False),
        ("inside", resting("board", 0.5), True),
        ("inside", resting("board", 0.4975), False),
        ("inside", resting("board", 0.5, height=0.4008), True),
        ("inside", resting("board", 0.5, height=0.4012), False),
        ("on_top", resting("board", 0.5), True),
        ("on_top", resting("", 1.0, mount="floor"), True),
        ("inside", resting("", 1.0, mount="floor"), False),
        ("inside", resting("", 0.5, mount="floor"), True),
        ("on_top", resting("", 0.7, mount="floor"), False),
    ],
)
def test_on_top_and_inside(kind, thing, expected):
    assert holds([shelf(), thing], relation(kind, "s", "t")) is expected


def test_on_top_of_another_thing():
    other = {**shelf(), "id": "u"}
    report = judge([shelf(), other, resting("top", 1.0)], [relation("on_top", "s", "u")])
    assert only(report, "relation").detail == "s on_top u: stands on t"
    bare = judge([box("t", (1, 1, 1), 4, 4), box("s", (0.2, 0.2, 0.2), 4, 4, z=1.0)], [relation("inside", "s", "t")])
    assert only(bare, "relation").detail == "s inside t: t has no inner surface for it"


@pytest.mark.parametrize("target", ["window-0", "window-1"])
def test_at_window(target):
    s = box("s", (0.5, 1.0, 0.7), 7.6, 2.6, 180.0)
    assert holds([s], relation("at_window", "s", target), windows=WINDOWS) is (target == "window-0")
    assert not holds([s], relation("at_window", "s", "window-0", max=0.1), windows=WINDOWS)


@pytest.mark.parametrize(
    ("off", "expected"), [(0.0, True), (0.029, True), (-0.029, True), (0.035, False), (-0.2, False)]
)
def test_before_the_middle_of_a_window(off, expected):
    window = {"id": "window-0", "wall": 0, "offset": 2.0, "width": 1.4, "sill": 0.9, "height": 1.2}
    curtain = box("c", (0.1, 1.8, 2.2), 2.7 + off, 0.06, 90.0)
    assert holds([curtain], relation("at_window", "c", "window-0", offset=0.03), windows=[window]) is expected
    assert holds([curtain], relation("at_window", "c", "window-0"), windows=[window])


@pytest.mark.parametrize(
    ("x", "y", "inset", "expected"),
    [
        (4.6, 4.3, 0.0, True),
        (4.99, 4.49, 0.0, True),
        (5.01, 4.0, 0.0, False),
        (4.0, 4.51, 0.0, False),
        (4.89, 4.39, 0.1, True),
        (4.92, 4.0, 0.1, False),
        (4.0, 3.58, 0.1, False),
        (4.0, 4.0, 0.9, True),
    ],
)
def test_over(x, y, inset, expected):
    rug = box("t", (2.0, 1.0, 0.01), 4.0, 4.0)
    assert holds([rug, box("s", (0.3, 0.3, 0.3), x, y, z=1.0)], relation("over", "s", "t", inset=inset)) is expected


def test_over_a_place():
    """The second of two lamps over a table: a quarter of its width to the left of its middle."""
    params = {"left": 0.25, "offset": 0.1}
    for turned, (dx, dy) in ((0.0, (0.0, 0.5)), (90.0, (-0.5, 0.0))):
        table = box("t", (1.0, 2.0, 0.7), 4.0, 4.0, turned)
        for aside, expected in ((0.0, True), (0.09, True), (0.12, False)):
            lamp = box("s", (0.3, 0.3, 0.3), 4.0 + dx + aside, 4.0 + dy, z=2.0)
            assert holds([table, lamp], relation("over", "s", "t", **params)) is expected
        assert not holds([table, box("s", (0.3, 0.3, 0.3), 4.0, 4.0, z=2.0)], relation("over", "s", "t", **params))


@pytest.mark.parametrize(("x", "least", "expected"), [(4.0, 0.9, True), (1.11, 0.9, True), (1.08, 0.9, False)])
def test_off_walls(x, least, expected):
    assert holds([box("s", (0.4, 0.4, 0.7), x, 2.6)], relation("off_walls", "s", None, min=least)) is expected


def test_facing_a_door_near_its_axis():
    """The middle of the door is 1.45 m along wall 1."""
    door = {"id": "door-0", "wall": 1, "offset": 1.0, "width": 0.9, "height": 2.0}
    for y, expected in ((1.45, True), (2.4, True), (2.5, False)):
        thing = box("s", (0.4, 0.4, 0.7), 3.0, y)
        assert holds([thing], relation("facing_door", "s", None, aside=1.0), doors=[door]) is expected


@pytest.mark.parametrize(("turned", "degrees", "expected"), [(0.0, 50, True), (49.0, 50, True), (51.0, 50, False)])
def test_facing_a_door(turned, degrees, expected):
    """Wall 1 is at the side that things look to at a yaw of 0."""
    door = {"id": "door-0", "wall": 1, "offset": 1.0, "width": 0.9, "height": 2.0}
    other = {**door, "id": "door-1", "wall": 3}
    thing = box("s", (0.4, 0.4, 0.7), 3.0, 2.6, turned)
    assert holds([thing], relation("facing_door", "s", None, degrees=degrees), doors=[door]) is expected
    assert holds([thing], relation("facing_door", "s", "door-0", degrees=degrees), doors=[other, door]) is expected
    assert not holds([thing], relation("facing_door", "s", "door-1", degrees=degrees), doors=[other, door])
    assert not holds([thing], relation("facing_door", "s", None, degrees=degrees))


@pytest.mark.parametrize(("x", "low", "high", "expected"), [
    (7.5, 0.0, 0.3, True),
    (7.5, 0.31, 0.6, False),
    (7.5, 0.0, 0.29, False),
    (6.0, 1.5, 4.0, True),
])  # fmt: skip
def test_near_an_opening(x, low, high, expected):
    """A box whose right side is 0.3 m, or 1.8 m, from the wall of a window and of a door, right before both."""
    thing, params = box("s", (0.4, 0.4, 0.7), x, 2.6), {"min": low, "max": high}
    window = {**WINDOWS[0], "id": "window-0"}
    door = {"id": "door-0", "wall": window["wall"], "offset": window["offset"], "width": 0.9, "height": 2.0}
    for kind, openings in (("near_window", {"windows": [window]}), ("near_door", {"doors": [door]})):
        for target in (None, f"{kind[5:]}-0"):
            assert holds([thing], relation(kind, "s", target, **params), **openings) is expected, kind
        assert not holds([thing], relation(kind, "s", None, **params))


WALLS = [box("s", (0.4, 1.0, 1.0), 0.2 + gap, 4.0) for gap in (0.0, 0.0705, 0.072)]


@pytest.mark.parametrize(
    ("thing", "params", "expected"),
    [
        (WALLS[0], {}, True),
        (WALLS[1], {}, True),
        (WALLS[2], {}, False),
        (WALLS[2], {"gap": [0.0, 0.08]}, True),
        (box("s", (0.4, 1.0, 1.0), 0.25, 4.0, 5.5), {}, False),
        (box("s", (0.4, 1.0, 1.0), 0.25, 4.0, 5.5), {"degrees": 6, "gap": [0.0, 0.2]}, True),
        (box("s", (0.4, 1.0, 1.0), 0.2, 0.3), {}, False),
        (box("s", (0.4, 1.0, 1.0), 0.2, 0.3), {"overlap": 0.7}, True),
    ],
)
def test_against_wall_params(thing, params, expected):
    assert holds([thing], relation("against_wall", "s", **params)) is expected


@pytest.mark.parametrize(
    ("kind", "pose", "loose"),
    [
        ("front_to_front", (4.8, 4.4, 160.0), {"degrees": 25, "gap": [-0.5, 0.5], "overlap": 0.1}),
        ("leftright_to_leftright", (4.1, 5.3, 0.0), {"gap": [0.0, 0.6]}),
        ("side_by_side", (4.1, 5.3, 0.0), {"gap": [0.0, 0.6]}),
        ("back_to_back", (3.1, 4.0, 180.0), {"gap": [0.0, 0.5]}),
        ("facing", (6.0, 4.0, 160.0), {"degrees": 21}),
        ("aligned", (6.0, 4.0, 94.0), {"degrees": 5}),
        ("parallel", (6.0, 4.0, 184.0), {"degrees": 5}),
        ("centered_on", (6.0, 4.2, 0.0), {"offset": 0.3}),
        ("near", (6.0, 4.0, 0.0), {"max": 2.0}),
    ],
)
def test_params_loosen(kind, pose, loose):
    things = [box("t", (1.0, 1.0, 0.7), 4.0, 4.0), box("s", (0.4, 0.6, 0.7), *pose)]
    assert not holds(things, relation(kind, "s", "t"))
    assert holds(things, relation(kind, "s", "t", **loose))


def test_in_corner_params():
    s = box("s", (0.4, 0.4, 1.0), 0.45, 0.4)
    assert not holds([s], relation("in_corner", "s"))
    assert holds([s], relation("in_corner", "s", to_corner=0.4, to_wall=0.3))


def test_what_is_said():
    bed, stand = box("bed", (2.0, 1.6, 0.5), 1.0, 4.0), box("stand", (0.4, 0.4, 0.5), 0.2, 5.31)
    found = only(judge([bed, stand], [relation("leftright_to_leftright", "stand", "bed")]), "relation")
    assert found.detail == "stand leftright_to_leftright bed: gap 0.31 m, allowed 0 to 0.05 m"
    assert found.objects == ("stand", "bed")
    assert found.amount == pytest.approx(0.26)
    turn = {**stand, "pose": box("stand", (0.4, 0.4, 0.5), 0.2, 5.02, 24.0)["pose"]}
    found = only(judge([bed, turn], [relation("leftright_to_leftright", "stand", "bed")]), "relation")
    assert found.detail == "stand leftright_to_leftright bed: turned 24 deg, allowed 10"
    assert found.amount == pytest.approx(14.0)
    found = only(judge([bed], [relation("against_wall", "bed", "wall:1")]), "relation")
    assert found.objects == ("bed", "wall:1")
    assert found.detail.startswith("bed against_wall wall:1: turned 180 deg, allowed 5; gap 8 m, allowed 0 to 0.07 m")
    found = only(judge([bed, stand], [relation("near", "bed", "stand", hard=False, max=0.1)]), "soft_relation")
    assert found.detail == "bed near stand: distance 0.31 m, allowed 0 to 0.1 m"


def test_values_shown_are_outside_the_limits():
    things = [box("t", (1, 1, 1), 4, 4), box("s", (1, 1, 1), 6.00102, 4.0)]
    assert only(judge(things, [relation("near", "s", "t")]), "relation").detail.endswith("1.001 m, allowed 0 to 1 m")


def test_registered_types():
    spec = RelationSpec(type="taller", description="The subject is taller.")
    catalogue.register_relation(spec)
    try:
        things = [box("t", (1, 1, 1), 4, 4), box("s", (1, 1, 2), 6, 4)]
        with pytest.raises(InputError, match="taller"):
            judge(things, [relation("taller", "s", "t")])
        register_judge("taller", lambda case: case.subject.size[2] > case.other.size[2])
        assert holds(things, relation("taller", "s", "t"))
        report = judge(things, [relation("taller", "t", "s")])
        assert not report.valid
        assert only(report, "relation").detail == "t taller s: does not hold"
    finally:
        JUDGES.pop("taller", None)
        catalogue.unregister_relation("taller")
    with pytest.raises(InputError, match="built in"):
        register_judge("near", lambda case: True)
    assert "taller" not in CATALOGUE
