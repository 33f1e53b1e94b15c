"""The critic beside strict eyes, on rooms of kinds to which its grades were not fitted, and the fit itself."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.critic_fit import agreement, fit, means, predicted
from benchmarks.judged_rooms import Measured, judged_rooms, measured
from benchmarks.strict_eyes import GRADED
from sceneweaver.critic.grade import Lost
from sceneweaver.rules.grades import TRAITS, Traits, grade_weights


@pytest.fixture(scope="module")
def held_out():
    rooms = judged_rooms("held_out")
    return rooms, measured(rooms)


def test_kinds_that_are_held_out_have_no_part_in_the_fit() -> None:
    fitted, held = judged_rooms("fit"), judged_rooms("held_out")
    assert (len(fitted), len(held)) == (240, 60)
    assert {room.kind for room in fitted}.isdisjoint(room.kind for room in held)
    assert {len(room.grades) for room in held} == {2}, "each has two judges"


def test_grades_follow_strict_eyes_on_kinds_that_they_were_not_fitted_to(held_out) -> None:
    rooms, rows = held_out
    found = agreement(means(rooms), np.array([row.grades for row in rows]))
    for name, rank, error, bias in found:
        least = 0.75 if name == "mean" else 0.6
        assert rank >= least and error <= 0.7 and abs(bias) <= 0.3, (name, rank, error, bias)


def test_what_the_fit_predicts_is_what_the_critic_says(held_out) -> None:
    _, rows = held_out
    assert predicted(rows, grade_weights()) == pytest.approx(np.array([row.grades for row in rows]), abs=2e-3)


def test_a_fit_finds_planted_weights(held_out) -> None:
    _, rows = held_out
    wanted = predicted(rows, grade_weights())
    found = fit(rows, wanted)
    assert np.abs(predicted(rows, found) - wanted).max() < 0.5
    assert set(found.criteria) == set(GRADED) and found.lid == grade_weights().lid


def test_no_grade_of_a_fit_rises_with_a_fault(held_out) -> None:
    _, rows = held_out
    weights = grade_weights()
    one = rows[0]
    before = predicted([one], weights)[0]
    for c in range(len(GRADED)):
        for field in Lost._fields:
            lost = tuple(
                row._replace(**{field: getattr(row, field) + 1.0}) if k == c and field != "defined" else row
                for k, row in enumerate(one.lost)
            )
            after = predicted([Measured(lost, one.traits, one.grades)], weights)[0]
            assert (after <= before + 1e-12).all()
    less = Traits(**{name: 0.0 for name in TRAITS})
    assert (predicted([Measured(one.lost, less, one.grades)], weights)[0] <= before + 1e-12).all()
