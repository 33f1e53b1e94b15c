"""Definitions that are wrong in ways that a few samples do not show are refused, with a line; right ones are taken."""

from __future__ import annotations

import math

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw


def apart(a, b):
    return math.dist(a.pose.position[:2], b.pose.position[:2])


def turned(a, b):
    return a.pose.yaw - b.pose.yaw


@wp.func
def distance(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return x - p[0]


@wp.func
def whole_metres(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return wp.floor(x - p[0])


@wp.func
def stairs(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return wp.floor((x - p[0]) * 4.0) * 0.25 + 0.01 * (x - p[0])


@wp.func
def wrong_sign(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return p[0] - x


@wp.func
def centimetres(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return 100.0 * x - p[0]


@wp.func
def no_number_at_contact(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    return wp.dot(d, d) / wp.sqrt(wp.dot(d, d)) - p[0]


@wp.func
def steep(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return 1.0e6 * (x - p[0])


@wp.func
def faint(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return 1.0e-3 * (x - p[0])


@wp.func
def two_values(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return wp.where(x > p[0], 1.0, -0.5)


@wp.func
def gap_by_depth(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return x - 0.5 * (size_a[0] + size_b[0]) - p[0]


@wp.func
def waves(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    total = float(0.0)  # noqa: UP018 - a variable of Warp's, not a constant
    for k in range(60):
        total += wp.sin(float(k) * a[0]) * wp.cos(float(k) * b[1])
    return total


@wp.func
def ring(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    d = wp.vec2(a[0] - b[0], a[1] - b[1])
    x = wp.sqrt(wp.dot(d, d) + 1.0e-6)
    return wp.abs(x - p[0]) - p[1]


@wp.func
def east_of_line(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - a[0]


@wp.func
def higher(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return b[2] + size_b[2] + p[0] - a[2]


@wp.func
def square_to(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    s = wp.sin(2.0 * (a[3] - b[3]))
    return s * s - p[0]


@wp.func
def same_way(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return 1.0 - wp.cos(a[3] - b[3]) - p[0]


@wp.func
def in_box(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.max(wp.abs(a[0] - b[0]), wp.abs(a[1] - b[1])) - p[0]


@wp.func
def in_front(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - (wp.cos(b[3]) * (a[0] - b[0]) + wp.sin(b[3]) * (a[1] - b[1]))


@wp.func
def ellipse(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    u = (a[0] - b[0]) / p[0]
    v = (a[1] - b[1]) / p[1]
    return wp.sqrt(u * u + v * v + 1.0e-6) - 1.0


@wp.func
def block(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return wp.abs(a[0] - b[0]) + wp.abs(a[1] - b[1]) - p[0]


MOST = {"most": 1.0}


def within(a, b, p):
    return apart(a, b) <= p["most"]


WRONG = {
    "holds is always False": (distance, lambda a, b, p: False, MOST, "`holds` says False"),
    "holds is always True": (distance, lambda a, b, p: True, MOST, "`holds` says True"),
    "a floor": (whole_metres, within, MOST, "flat"),
    "stairs with a slope": (stairs, within, MOST, "the residual jumps: 5 cm change it by"),
    "two values": (two_values, within, MOST, "flat"),
    "the sign": (wrong_sign, within, MOST, "disagree at 100%"),
    "centimetres": (centimetres, lambda a, b, p: 100 * apart(a, b) <= p["most"], {"most": 100.0}, "give scale=0.01"),
    "no number at contact": (no_number_at_contact, within, MOST, "not finite"),
    "a huge slope": (steep, within, MOST, "give scale=1e-06"),
    "a slope of a thousandth": (faint, within, MOST, "give scale=1e"),
    "looser by 5 cm": (distance, lambda a, b, p: apart(a, b) <= p["most"] + 0.05, MOST, "just beyond its edge"),
    "tighter by 2 cm": (distance, lambda a, b, p: apart(a, b) <= p["most"] - 0.02, MOST, "engine and judge"),
    "depth for width": (
        gap_by_depth,
        lambda a, b, p: apart(a, b) - 0.5 * (a.size[1] + b.size[1]) <= p["most"],
        MOST,
        "engine and judge",
    ),
    "the order of ids": (distance, lambda a, b, p: a.id < b.id and within(a, b, p), MOST, "called z and y"),
    "a param that is not read": (distance, lambda a, b, p: apart(a, b) <= 1.0, MOST, "with other params (most 0.8)"),
    "degrees for radians": (
        same_way,
        lambda a, b, p: math.cos(turned(a, b)) >= math.cos(math.radians(p["most"])),
        {"most": 0.5},
        "engine and judge",
    ),
}

RIGHT = {
    "within": (distance, within, MOST),
    "on a ring": (ring, lambda a, b, p: abs(apart(a, b) - p["radius"]) <= p["slack"], {"radius": 2.0, "slack": 0.1}),
    "beyond": (wrong_sign, lambda a, b, p: apart(a, b) >= p["least"], {"least": 1.5}),
    "east of a line": (east_of_line, lambda a, b, p: a.pose.position[0] >= p["x"], {"x": 1.0}),
    "higher": (higher, lambda a, b, p: a.pose.position[2] >= b.pose.position[2] + b.size[2] + p["by"], {"by": 0.1}),
    "square to": (square_to, lambda a, b, p: math.sin(2 * turned(a, b)) ** 2 <= p["slack"], {"slack": 0.05}),
    "the same way": (same_way, lambda a, b, p: 1 - math.cos(turned(a, b)) <= p["slack"], {"slack": 0.05}),
    "in a box": (
        in_box,
        lambda a, b, p: float(np.abs(np.subtract(a.pose.position, b.pose.position))[:2].max()) <= p["half"],
        {"half": 0.8},
    ),
    "in front": (
        in_front,
        lambda a, b, p: (
            math.cos(b.pose.yaw) * (a.pose.position[0] - b.pose.position[0])
            + math.sin(b.pose.yaw) * (a.pose.position[1] - b.pose.position[1])
            >= p["least"]
        ),
        {"least": 0.5},
    ),
    "in an ellipse": (
        ellipse,
        lambda a, b, p: (
            math.hypot(
                (a.pose.position[0] - b.pose.position[0]) / p["x"], (a.pose.position[1] - b.pose.position[1]) / p["y"]
            )
            <= 1.0
        ),
        {"x": 1.5, "y": 0.7},
    ),
    "by blocks": (
        block,
        lambda a, b, p: (
            sum(abs(u - v) for u, v in zip(a.pose.position[:2], b.pose.position[:2], strict=True)) <= p["most"]
        ),
        {"most": 1.2},
    ),
    "by depth": (
        gap_by_depth,
        lambda a, b, p: apart(a, b) - 0.5 * (a.size[0] + b.size[0]) <= p["most"],
        {"most": 0.5},
    ),
}


def some(cases, first):
    """The first ones, and the others as slow tests: each compiles a kernel of its own."""
    return [pytest.param(c, marks=() if k < first else pytest.mark.slow) for k, c in enumerate(cases)]


@pytest.mark.parametrize("case", some(WRONG, 5))
def test_what_is_wrong_is_refused_with_one_line(case):
    residual, holds, params, says = WRONG[case]
    with pytest.raises(sw.InputError) as error:
        sw.define_relation("made_by_test_wrong", residual=residual, holds=holds, params=params)
    text = str(error.value)
    assert says in text and "\n" not in text and text.startswith('relation "made_by_test_wrong"')


@pytest.mark.parametrize("case", some(RIGHT, 3))
def test_what_is_right_is_taken(case):
    residual, holds, params = RIGHT[case]
    sw.define_relation("made_by_test_right", residual=residual, holds=holds, params=params)
    sw.undefine_relation("made_by_test_right")


def test_a_scale_makes_another_unit_right():
    holds = lambda a, b, p: 100 * apart(a, b) <= p["most"]  # noqa: E731
    sw.define_relation("made_by_test_cm", residual=centimetres, holds=holds, params={"most": 100.0}, scale=0.01)
    sw.undefine_relation("made_by_test_cm")


def test_what_it_costs_is_measured_and_logged(caplog):
    heavy, light = sw.residual_cost(waves, device="cpu"), sw.residual_cost(east_of_line, device="cpu")
    assert heavy.nanoseconds > 3 * light.nanoseconds > 0 and heavy.built_in > 0 and heavy.compile_seconds > 0
    with caplog.at_level("INFO", logger="sceneweaver.extend"):
        sw.define_relation("made_by_test_cost", residual=distance, holds=within, params=MOST)
    sw.undefine_relation("made_by_test_cost")
    (line,) = (r.getMessage() for r in caplog.records if r.name == "sceneweaver.extend")
    assert line.startswith('relation "made_by_test_cost": ') and " ns an evaluation, " in line and "compiled in" in line
    with pytest.raises(sw.InputError, match="not a wp.func"):
        sw.residual_cost(apart)
