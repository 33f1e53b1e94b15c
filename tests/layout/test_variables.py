"""Lengths as variables: known optima are reached, scenes stay valid, bad input is refused."""

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout.cross_entropy import CrossEntropy
from sceneweaver.layout.variables import with_values

QUICK = {"device": "cpu", "population": 8, "candidates": 6, "generations": 6}


def box(name, size, at=(1.0, 1.0), **more):
    pose = {"position": [*at, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0]}
    return {"id": name, "category": "box", "size": list(size), "pose": pose, **more}


def scene(objects, outline=(4.0, 3.0), **room):
    x, y = outline
    corners = [[0, 0], [x, 0], [x, y], [0, y]]
    return sw.Scene.from_json(
        {
            "schema": "sceneweaver.scene/1",
            "id": "boxes",
            "room": {"outline": corners, "height": 2.5, **room},
            "objects": objects,
            "relations": [],
        }
    )


DOOR = {"id": "door", "wall": 0, "offset": 0.3, "width": 0.8, "height": 2.0, "swing": "out"}


def test_the_narrowest_room_for_what_must_stand_side_by_side():
    depths = {"a": 1.2, "b": 0.7, "c": 0.5}
    given = scene([box(k, (d, 1.8, 0.5), (0.7 + i, 1.0), yaw_domain=[0.0]) for i, (k, d) in enumerate(depths.items())])
    room = scene(given.to_json()["objects"], (4.0, 2.0))
    found = sw.optimize_variables(room, [sw.Variable("room", "", "x", 2.0, 5.0, cost=1.0)], **QUICK)
    assert found.valid and sw.check(found.scene).valid
    assert found.values[0] == pytest.approx(2.4, rel=0.03)  # the sum of the depths
    assert found.scene.room.outline[1][0] == found.values[0] and found.objective == found.values[0]
    assert (np.diff(found.best) <= 0).all() and found.tried.shape == (48, 1) and found.worth.shape == (48,)
    again = sw.optimize_variables(room, [sw.Variable("room", "", "x", 2.0, 5.0, cost=1.0)], **QUICK)
    assert (again.tried == found.tried).all() and again.scene == found.scene


def test_the_largest_box_between_fixed_ones():
    walls = [box("l", (1.0, 2.0, 0.5), (0.5, 1.0), fixed=True), box("r", (1.0, 2.0, 0.5), (3.5, 1.0), fixed=True)]
    room = scene([*walls, box("d", (0.9, 0.6, 0.5), (2.0, 1.0), yaw_domain=[0.0])], (4.0, 2.0))
    depth = sw.Variable("size", "d", "depth", 0.5, 3.0, cost=-1.0)
    found = sw.optimize_variables(room, [depth], **QUICK)
    assert found.valid and sw.check(found.scene).valid and found.values[0] == pytest.approx(2.0, rel=0.03)
    assert found.scene.object("d").size == (found.values[0], 0.6, 0.5)


def test_a_door_moves_to_where_the_objective_is_least():
    room = scene([box("l", (1.0, 1.0, 0.5), (2.8, 2.4), fixed=True)], doors=[DOOR])
    offset = sw.Variable("opening", "door", "offset", 0.0, 3.2)
    terms = [sw.ObjectiveTerm("flow", ("door", "l"))]
    found = sw.optimize_variables(room, [offset], objective=terms, **QUICK)
    assert found.valid and found.objective == pytest.approx(2.4, abs=0.01)  # straight across
    assert abs(found.values[0] - 2.4) < 0.2
    own = sw.optimize_variables(room, [offset], objective=lambda s: abs(s.room.doors[0].offset - 1.7), **QUICK)
    assert own.objective < 0.02 and own.values[0] == pytest.approx(1.7, abs=0.02)


def test_where_nothing_is_valid_it_says_so():
    room = scene([box("a", (2.0, 2.0, 0.5), fixed=True), box("b", (1.9, 1.9, 0.5))], (2.2, 2.2))
    found = sw.optimize_variables(
        room, [sw.Variable("size", "b", "depth", 1.5, 1.9)], device="cpu", population=4, candidates=2, generations=1
    )
    assert not found.valid and math.isnan(found.objective) and np.isnan(found.worth).all()
    assert found.explanation and "b.depth" in found.explanation and 1.5 <= found.values[0] <= 1.9
    none = sw.optimize_variables(
        scene([box("a", (0.5, 0.5, 0.5))], doors=[DOOR]),
        [sw.Variable("opening", "door", "offset", 3.9, 5.0)],
        device="cpu", population=4, candidates=2, generations=1,
    )  # fmt: skip
    assert not none.valid and none.solution is None and none.explanation and "openings do not fit" in none.explanation


def test_what_belongs_to_a_size_and_a_room_follows():
    surface = {"name": "top", "polygon": [[-0.4, -0.4], [0.4, -0.4], [0.4, 0.4], [-0.4, 0.4]], "z": 0.7}
    table = box("t", (1.0, 1.0, 0.7), (2.0, 1.5), surfaces=[surface])
    book = box("book", (0.2, 0.2, 0.1), (2.1, 1.5), mount="surface", support={"object": "t", "surface": "top"})
    book["pose"]["position"][2] = 0.7
    room = scene([table, book, box("f", (0.3, 0.3, 0.3), (0.5, 2.5), fixed=True)], doors=[DOOR])
    variables = [
        sw.Variable("size", "t", "depth", 0.5, 2.0),
        sw.Variable("room", "", "x", 3.0, 9.0),
        sw.Variable("room", "", "height", 2.0, 3.0),
        sw.Variable("opening", "door", "width", 0.5, 1.0),
    ]
    made = with_values(room, variables, [1.6, 8.0, 2.7, 0.9])
    assert [v.value(made) for v in variables] == [1.6, 8.0, 2.7, 0.9]
    assert made.object("t").surfaces[0].polygon[0] == pytest.approx((-0.64, -0.4))
    assert made.object("t").pose.position[0] == 4.0 and made.object("book").pose.position[0] == pytest.approx(4.1)
    assert made.object("f").pose == room.object("f").pose
    door = made.room.doors[0]
    assert door.offset + door.width / 2 == pytest.approx(1.4)  # the share of its wall that it had
    assert with_values(room, variables[:1], [1.0]) == room


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("volume", "t", "depth", 1.0, 2.0), "kind"),
        (("size", "t", "length", 1.0, 2.0), "axis"),
        (("size", "t", "depth", 2.0, 1.0), "bounds"),
        (("size", "t", "depth", 0.0, 1.0), "bounds"),
        (("size", "t", "depth", 1.0, math.inf), "high"),
        (("room", "t", "x", 1.0, 2.0), "target"),
    ],
)
def test_wrong_variables_are_refused(arguments, text):
    with pytest.raises(sw.InputError, match=text):
        sw.Variable(*arguments)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"variables": []}, "variables"),
        ({"variables": [sw.Variable("size", "x", "depth", 1.0, 2.0)]}, '"x"'),
        ({"variables": [sw.Variable("size", "a", "depth", 1.0, 2.0)] * 2}, "twice"),
        ({"population": 3}, "population"),
        ({"elite": 0.9}, "elite"),
        ({"time_limit": 0}, "time_limit"),
        ({"objective": lambda scene: math.nan}, "finite"),
    ],
)
def test_wrong_arguments_are_refused(change, text):
    arguments = {"variables": [sw.Variable("size", "a", "depth", 0.4, 0.6)], **QUICK, **change}
    with pytest.raises(sw.InputError, match=text):
        sw.optimize_variables(scene([box("a", (0.5, 0.5, 0.5))]), **arguments)


def test_cross_entropy_finds_the_least_of_a_bowl():
    at = np.array([0.2, 0.9, 0.0])
    method, best = CrossEntropy(3, 5, 0.25), None
    for _ in range(25):
        points = method.draw(24)
        assert ((points >= 0) & (points <= 1)).all()
        worth = ((points - at) ** 2).sum(axis=1)
        order = np.argsort(worth)
        if best is None or worth[order[0]] < ((best - at) ** 2).sum():
            best = points[order[0]]
        method.learn(points, order, best)
    assert np.abs(best - at).max() < 0.01
