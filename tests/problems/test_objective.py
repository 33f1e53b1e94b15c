"""Objectives of problems: values against a reading of their own, bad terms, witnesses."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sceneweaver import problems
from sceneweaver.layout import ObjectiveTerm, objective_of
from sceneweaver.problems.nets import members
from sceneweaver.scene import InputError

SMALL = {"chips": (12, 0.8, "mcnc"), "facilities": (8, 0.8, "unequal"), "floor_plans": (8, 0.8, "L")}
SMALL |= {"warehouses": (14, 0.8, "rows")}


def by_hand(case: problems.ProblemCase, poses: np.ndarray) -> float:
    """The objective of one layout, term by term, with complex numbers in place of the library's arrays."""
    at = {o.id: (complex(*map(float, p[:2])), float(p[3])) for o, p in zip(case.scene.objects, poses, strict=True)}
    total = 0.0
    for term in case.objective:
        points = []
        for k, name in enumerate(term.objects):
            if name in at:
                dx, dy = term.pins[k] if term.kind == "wire_length" else (0.0, 0.0)
                where, yaw = at[name]
                points.append(where + complex(dx, dy) * complex(math.cos(yaw), math.sin(yaw)))
            else:
                window = next(w for w in case.scene.room.windows if w.id == name)
                outline = [complex(*p) for p in case.scene.room.outline]
                a, b = outline[window.wall], outline[(window.wall + 1) % len(outline)]
                points.append(a + (b - a) / abs(b - a) * (window.offset + window.width / 2))
        spans = [max(part) - min(part) for part in ([z.real for z in points], [z.imag for z in points])]
        total += term.weight * sum(spans)
    return total


@pytest.mark.parametrize("family", SMALL)
def test_values_are_those_of_another_reading_and_witnesses_verify(family):
    objects, tightness, shape = SMALL[family]
    case = problems.generate(family, objects, tightness, 3, shape=shape)
    problems.verify(case)
    poses = case.start("random", 3, 1)
    values = case.objective_of(poses)
    assert values.dtype == np.float64
    assert values == pytest.approx([by_hand(case, p.astype(float)) for p in poses], rel=1e-9)
    assert case.hash == problems.generate(family, objects, tightness, 3, shape=shape).hash
    assert case.hash != problems.generate(family, objects, tightness, 4, shape=shape).hash
    valid, value = case.judge(case.witness)
    assert valid and value == pytest.approx(by_hand(case, case.witness.astype(float)))
    assert not case.judge(poses[0])[0]


def test_a_flow_may_be_along_the_straight_line():
    case = problems.generate("facilities", 6, 0.7, 0)
    a, b = case.scene.ids[:2]
    (value,) = objective_of(case.scene, [ObjectiveTerm("flow", (a, b), 2.0)], case.witness[None])
    assert value == pytest.approx(2.0 * float(np.linalg.norm(case.witness[0, :2].astype(float) - case.witness[1, :2])))


def test_turning_a_block_moves_its_pins():
    case = problems.generate("facilities", 6, 0.7, 0)
    term = ObjectiveTerm("wire_length", case.scene.ids[:2], 1.0, {"pins": [[0.5, 0.0], [0.0, 0.0]]})
    poses = np.zeros((2, 6, 4))
    poses[1, 0, 3] = math.pi / 2
    poses[:, 1, 0] = 2.0
    assert objective_of(case.scene, [term], poses) == pytest.approx([1.5, 2.5])


def test_ties_stay_in_parts_of_the_order_more_often_than_by_chance():
    rng, order = np.random.default_rng(0), np.arange(64)
    spans = [max(m) - min(m) for m in (members(order, 2, rng) for _ in range(2000))]
    assert np.mean(spans) < 0.6 * 64 / 3, "two places of a line are a third of it apart by chance"
    assert max(spans) > 40


@pytest.mark.parametrize("arguments", [("chips", 3, 0.8), ("chips", 10, 0.99), ("warehouses", 15, 0.8)])
def test_plans_that_cannot_be_are_one_line(arguments):
    with pytest.raises(InputError, match="objects|tightness"):
        problems.generate(*arguments)
    with pytest.raises(InputError, match="shape"):
        problems.generate("chips", 10, 0.8, shape="round")
