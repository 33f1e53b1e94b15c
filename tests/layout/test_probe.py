"""Relations and terms of the user's own are tried when they are defined: what is wrong is told, and at which poses.

Nothing here is laid out, so the kernels are not built anew.
"""

from __future__ import annotations

import math

import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.scene.catalogue import CATALOGUE


@wp.func
def near_circle(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + 1.0e-6)
    return wp.abs(d - p[0]) - p[1]


@wp.func
def whole_metres(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.floor(wp.length(wp.vec2(a[0] - b[0], a[1] - b[1])))


@wp.func
def magnitude(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.log(wp.length(wp.vec2(a[0] - b[0], a[1] - b[1])))


@wp.func
def below_the_floor(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return -1.0 - a[2]


@wp.func
def at_line(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.abs(a[0] - p[0]) - 0.01


PARAMS = {"radius": 2.0, "slack": 0.1}


def distance(a, b):
    return math.dist(a.pose.position[:2], b.pose.position[:2])


def holds(a, b, p):
    return abs(distance(a, b) - p["radius"]) <= p["slack"]


def nothing(a, b, p):
    holds(a, b, p)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (
            {"holds": lambda a, b, p: False},
            r"disagree at 100% of \d+ .* that it holds, `holds` says False, as at a at \(",
        ),
        ({"holds": lambda a, b, p: True}, r"disagree at 100% of \d+ sample .* does not, `holds` says True"),
        ({"holds": lambda a, b, p: not holds(a, b, p)}, "that it holds, `holds` says False"),
        ({"holds": lambda a, b, p: abs(distance(a, b) - 1.0) < 0.1}, "engine and judge disagree"),
        ({"holds": nothing}, "holds returns None of type NoneType; return True or False"),
        ({"holds": lambda a, b, p: p["size"]}, r"holds raises KeyError: 'size', with a at \("),
        (
            {"params": {"radius": 2.0, "slack": 0.0}},
            r"nothing satisfies its residual: .* below -0.0001; give it some slack",
        ),
        ({"residual": whole_metres, "holds": lambda a, b, p: distance(a, b) < 1.0}, "flat: its gradient is 0 at 1"),
        ({"residual": magnitude, "holds": lambda a, b, p: distance(a, b) < 1.0}, r"not finite with a at \("),
    ],
    ids=["never", "always", "turned round", "another", "None", "raises", "no slack", "floor", "log"],
)
def test_a_relation_that_can_not_work_is_refused(given, says):
    with pytest.raises(sw.InputError, match='relation "tried": ') as told:
        sw.define_relation("tried", **{"residual": near_circle, "holds": holds, "params": PARAMS, **given})
    assert told.match(says) and "\n" not in str(told.value)
    assert "tried" not in CATALOGUE


@pytest.mark.parametrize(
    "given",
    [
        {"residual": near_circle, "holds": holds, "params": PARAMS},
        {"residual": near_circle, "holds": holds, "params": {"radius": 2.0, "slack": 0.003}},
        {"residual": near_circle, "holds": holds, "params": PARAMS, "scale": 3.0},
        {
            "residual": at_line,
            "holds": lambda a, b, p: abs(a.pose.position[0] - p["x"]) <= 0.01,
            "params": {"x": 1.0},
            "target": "none",
        },
    ],
    ids=["wide", "narrow", "scaled", "alone"],
)
def test_what_works_is_taken(given):
    sw.define_relation("tried", **given)
    sw.undefine_relation("tried")


def test_a_predicate_that_asks_for_more_than_poses_is_taken_unchecked():
    def on_its_surface(a, b, p):
        return holds(a, b, p) and b.surfaces[0].z > 0.5

    given = {"residual": near_circle, "holds": on_its_surface, "params": PARAMS}
    with pytest.raises(sw.InputError, match="holds raises IndexError"):
        sw.define_relation("tried", **given)
    sw.define_relation("tried", **given, check=False)
    sw.undefine_relation("tried")


@pytest.mark.parametrize(
    ("residual", "says"),
    [
        (whole_metres, "flat"),
        (magnitude, "not finite"),
        (below_the_floor, "at most 0 at all 256 sample poses, so it costs nothing"),
    ],
)
def test_a_term_that_can_not_work_is_refused(residual, says):
    with pytest.raises(sw.InputError, match=f'term "tried": .*{says}'):
        sw.define_term("tried", residual=residual, subjects=["box"], targets=["bed"])


def test_the_same_is_said_twice():
    said = []
    for _ in range(2):
        with pytest.raises(sw.InputError) as told:
            sw.define_relation("tried", residual=near_circle, holds=lambda a, b, p: False, params=PARAMS)
        said.append(str(told.value))
    assert said[0] == said[1]
