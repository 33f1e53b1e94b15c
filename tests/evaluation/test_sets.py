"""Intervals, category KL, diversity and sizes, against arithmetic done by hand or by NumPy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sceneweaver.assets import categories
from sceneweaver.evaluation import intervals, sets
from sceneweaver.evaluation.sizing import log_ratios, sizes_of
from sceneweaver.scene import Scene


def test_an_interval_covers_the_truth_about_as_often_as_it_says():
    random = np.random.default_rng(4)
    covered = 0
    for k in range(120):
        top = random.binomial(10, 0.3, size=40).astype(float)
        low, high = intervals.interval(top, np.full(40, 10.0), seed=k)
        covered += low <= 0.3 <= high
    assert 0.87 <= covered / 120 <= 1.0


def test_an_interval_is_that_of_plain_resampling():
    random = np.random.default_rng(5)
    top, bottom = random.integers(0, 5, 25).astype(float), random.integers(1, 9, 25).astype(float)
    draws = random.integers(0, 25, (20000, 25))
    plain = np.quantile(top[draws].sum(axis=1) / bottom[draws].sum(axis=1), [0.025, 0.975])
    assert intervals.interval(top, bottom) == pytest.approx(tuple(plain), abs=0.02)
    assert intervals.interval(top, bottom) == intervals.interval(top, bottom)


def test_one_scene_has_no_interval():
    assert intervals.interval(np.array([1.0]), np.array([2.0])) is None
    assert intervals.interval(np.array([1.0, 0.0]), np.array([2.0, 0.0])) is None


def test_category_kl_as_physcene_writes_it():
    reference, scenes = [{"bed": 3, "desk": 1}], [{"bed": 1}, {"bed": 1, "desk": 2}]
    p, q = np.array([0.75, 0.25]), np.array([0.5, 0.5])
    expected = (p * (np.log(p + 1e-6) - np.log(q + 1e-6))).sum()
    value, (low, high) = sets.category_kl(reference, scenes)
    assert value == pytest.approx(expected) and low <= value <= high
    assert sets.category_kl(reference, [{}]) is None and sets.category_kl([{}], scenes) is None


def test_diversity():
    assert sets.category_diversity([{"bed": 2}, {"bed": 1, "desk": 1}]) == pytest.approx(1 - 1 / 3)
    assert sets.category_diversity([{"bed": 1}]) is None
    full, half, none = [2**32 - 1] * 32, [2**32 - 1] * 16 + [0] * 16, [0] * 32
    assert sets.layout_diversity([full, half]) == pytest.approx(0.5)
    assert sets.layout_diversity([none, none]) == 0.0
    assert sets.layout_diversity([full, half, none]) == pytest.approx((0.5 + 1 + 1) / 3)


def test_pairs_are_drawn_where_there_are_many():
    assert len(sets.pairs_of(20)) == 190
    many = sets.pairs_of(500)
    assert len(many) == sets.MOST_PAIRS and (many[:, 0] < many[:, 1]).all()
    assert (many == sets.pairs_of(500)).all()


def test_sizes():
    usual = categories()["bed"].size
    (d0, d1), (w0, _), (h0, h1) = usual.ranges
    inside = ((d0 + d1) / 2, w0, h1)
    assert log_ratios(inside, usual) == pytest.approx([0, 0, 0])
    off = log_ratios((d1 * 1.5, w0 / 2, h0), usual)
    assert off == pytest.approx([math.log(1.5), math.log(2), 0])


def test_sizes_of_a_scene():
    scene = Scene.example("bedroom")
    found = sizes_of(scene)
    assert 0 < found.usual < found.known <= len(scene.objects) and found.off > 0
    assert sizes_of(scene, scene.ids) == (0, 0, 0.0)
