"""Curves, targets, profiles, tables and plots of made-up runs, against what pen and paper give."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.bench import Run, Target, compare, data_profile, markdown, performance_profile, plot
from sceneweaver.bench.curves import best_found, cost_to, gap_at, in_common, interval, left_at, value_at
from sceneweaver.bench.results import COLUMNS
from sceneweaver.bench.tables import by_family, failures

NAN = float("nan")


def made(
    method, problem, seed=0, *, seconds, valid, best, lowest=None, outcome="ended", reason="", family="f", known=NAN
):
    """A run; ``best`` are energies of its best valid layout, ``lowest`` those of any."""
    n = len(seconds)
    columns = {
        "method": [method] * n,
        "problem": [problem] * n,
        "family": [family] * n,
        "seed": [seed] * n,
        "variables": [9] * n,
        "best_known": [known] * n,
        "steps": range(n),
        "seconds": seconds,
        "setup_seconds": [0.5] * n,
        "energy_calls": [10 * s for s in seconds],
        "evaluations": [100 * s for s in seconds],
        "valid": valid,
        "distinct": [round(4 * v) for v in valid],
        "best_energy": best if lowest is None else lowest,
        "best_valid_energy": best,
        "outcome": ["running"] * (n - 1) + [outcome],
        "reason": [""] * (n - 1) + [reason],
    }
    assert set(columns) < set(COLUMNS)
    return Run({name: np.array(values) for name, values in columns.items()})


FAST = made("fast", "p", seconds=[0.0, 1.0, 4.0], valid=[0.0, 0.5, 0.6], best=[NAN, 2.0, 1.0], lowest=[11.0, 2.0, 1.0])
SLOW = made("slow", "p", seconds=[0.0, 4.0, 8.0], valid=[0.0, 0.25, 1.0], best=[NAN, 6.0, 0.5], lowest=[11.0, 5.0, 0.5])
OTHER = made("fast", "q", seconds=[0.0, 2.0], valid=[0.0, 0.0], best=[NAN, NAN], lowest=[3.0, 2.0], family="g")
LATER = made("slow", "q", seconds=[0.0, 6.0], valid=[0.0, 0.5], best=[NAN, 1.0], lowest=[3.0, 1.0], family="g")
RUNS = [FAST, SLOW, OTHER, LATER]
BEST = {"p": 0.5, "q": 1.0}


def test_a_value_is_that_of_the_last_look():
    at = np.array([0.0, 0.5, 1.0, 3.9, 4.0, 99.0])
    np.testing.assert_array_equal(value_at(FAST, "valid", "seconds", at), [0, 0, 0.5, 0.5, 0.6, 0.6])
    np.testing.assert_array_equal(gap_at(FAST, "seconds", at, BEST), [np.inf, np.inf, 1.5, 1.5, 0.5, 0.5])
    np.testing.assert_allclose(left_at(FAST, "seconds", at[[0, 2, 4]], BEST), [1, 1.5 / 10.5, 0.5 / 10.5])
    assert np.isnan(left_at(OTHER, "seconds", at, {"q": np.inf})).all()


def test_what_methods_have_in_common():
    alone = made("fast", "r", seconds=[0.0, 1.0], valid=[0, 1], best=[NAN, 2.0])
    assert in_common([*RUNS, alone]) == RUNS and in_common([FAST, LATER]) == []


def test_the_best_is_what_is_known_or_found():
    assert best_found(RUNS) == BEST
    known = made("fast", "p", seconds=[0.0, 1.0], valid=[0, 1], best=[NAN, 2.0], lowest=[9.0, 2.0], known=0.25)
    assert best_found([known, SLOW]) == {"p": 0.25}
    assert best_found([OTHER]) == {"q": np.inf}


@pytest.mark.parametrize(
    ("target", "fast", "slow"),
    [("valid:0.25", 1.0, 4.0), ("valid:0.6", 4.0, 8.0), ("valid:1", np.inf, 8.0), ("objective:0.2", 1.0, 8.0)]
    + [("objective:0.05", 4.0, 8.0), ("objective:0.01", np.inf, 8.0)],
)
def test_costs_to_a_target(target, fast, slow):
    for cost, unit in (("seconds", 1.0), ("evaluations", 100.0), ("energy_calls", 10.0)):
        found = [cost_to(run, Target.parse(target), cost, BEST) for run in (FAST, SLOW)]
        assert found == [fast * unit, slow * unit]


def test_what_nobody_counted_is_not_free():
    FREE = Run({**FAST.columns, "evaluations": np.zeros(3)})
    assert cost_to(FREE, Target("valid", 0.25), "evaluations", BEST) == np.inf


@pytest.mark.parametrize("text", ["valid", "valid:x", "valid:0", "valid:1.5", "speed:0.5", "objective:-1"])
def test_what_is_no_target(text):
    with pytest.raises(sw.InputError, match="target: "):
        Target.parse(text)


def test_a_performance_profile():
    """Of p, fast takes 1 s and slow 4 s; of q slow alone reaches a quarter."""
    profile = performance_profile(RUNS, Target("valid", 0.25))
    assert profile.methods == ("fast", "slow") and profile.at[0] == 1.0
    fast, slow = profile.shares
    assert fast[0] == 0.5 and fast[-1] == 0.5
    assert slow[0] == 0.5 and slow[profile.at < 4.0].max() == 0.5 and slow[profile.at > 4.01].min() == 1.0
    assert (np.diff(profile.shares, axis=1) >= 0).all()


def test_a_data_profile():
    """Evaluations for each of nine variables and one more."""
    profile = data_profile(RUNS, Target("valid", 0.25))
    np.testing.assert_allclose(profile.at[[0, -1]], [10.0, 60.0])
    fast, slow = profile.shares
    assert fast[0] == 0.5 and slow[profile.at < 40].max(initial=0.0) == 0.0
    assert slow[(profile.at > 40.1) & (profile.at < 59)].max() == 0.5 and slow[-1] == 1.0


def test_nobody_reaches_a_target():
    for profile in (performance_profile([OTHER], Target("valid", 0.5)), data_profile([OTHER], Target("valid", 0.5))):
        assert (profile.shares == 0).all()


def test_an_interval_covers_the_mean_and_shrinks():
    rng, covered = np.random.default_rng(1), 0
    for trial in range(60):
        low, high = interval(rng.normal(0.3, 0.1, (30, 2)), seed=trial)
        covered += low <= 0.3 <= high
    assert covered >= 52  # 57 are to be expected
    many, few = (interval(rng.normal(0.0, 1.0, (n, 2))) for n in (400, 25))
    assert many[1] - many[0] < 0.5 * (few[1] - few[0])
    assert interval(np.full((4, 3), 0.5)) == (0.5, 0.5)
    alike = np.repeat(rng.normal(0.0, 1.0, (25, 1)), 40, axis=1)  # seeds of a problem say nothing new
    assert np.subtract(*interval(alike)[::-1]) > 0.5


def test_tables_say_quality_next_to_time():
    broken = made("broken", "p", seconds=[0.0], valid=[0.0], best=[NAN], outcome="failed", reason="ValueError: no")
    broken.columns["best_energy"] = np.array([11.0])
    slow, fast, none = compare([*RUNS, broken], Target("valid", 0.25))
    assert [line.method for line in (slow, fast, none)] == ["slow", "fast", "broken"]
    assert (slow.valid, slow.solved, slow.distinct, slow.gap, slow.failed, slow.runs) == (0.75, 1.0, 3.0, 0.0, 0, 2)
    assert (slow.seconds, slow.evaluations, slow.energy_calls, slow.reached) == (6.0, 600.0, 60.0, 1.0)
    assert (fast.valid, fast.solved, fast.gap, fast.reached, fast.seconds) == (0.3, 0.5, 0.5, 0.5, np.inf)
    assert fast.low == 0.0 and fast.high == 0.6 and fast.to_dict()["seconds"] is None
    assert (none.failed, none.runs, none.valid) == (1, 1, 0.0)
    assert failures([*RUNS, broken]) == ["broken: ValueError: no (1 runs: p)"]
    assert by_family(RUNS) == {"fast": {"f": 0.6, "g": 0.0}, "slow": {"f": 1.0, "g": 0.5}}
    text = markdown([*RUNS, broken], Target("valid", 0.25))
    assert "| slow | 75.0% |" in text and "| fast | 60% | 0% |" in text and "ValueError: no" in text


def test_plots_are_drawn_with_the_lines_of_the_numbers(tmp_path, monkeypatch):
    from matplotlib import figure

    drawn, kept = [], figure.Figure
    monkeypatch.setattr(figure, "Figure", lambda **options: drawn.append(kept(**options)) or drawn[-1])
    paths = plot(RUNS, tmp_path, form="png")
    assert [path.name for path in paths] == ["curves.png", "profiles.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") and path.stat().st_size > 10_000 for path in paths)
    with pytest.raises(sw.InputError, match="format: "):
        plot(RUNS, tmp_path, form="gif")
    valid = drawn[0].axes[0]
    lines = {line.get_label(): line.get_ydata() for line in valid.get_lines()}
    assert lines["slow"][-1] == 0.75 and lines["fast"][-1] == 0.3 and lines["fast"][0] == 0.25


def test_plots_need_matplotlib(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "matplotlib.figure", None)
    with pytest.raises(sw.MissingDependencyError, match="matplotlib is not installed"):
        plot(RUNS, tmp_path)
