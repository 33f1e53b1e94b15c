"""The zoo is what its command makes, and its page says what was measured."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from benchmarks.problem_list import FEASIBLE, made
from benchmarks.problems import BEGIN, END, PAGE, measure, page_lines, zoo_names
from sceneweaver import problems
from sceneweaver.problems import layout_bench, store
from sceneweaver.scene import InputError


def test_the_page_has_the_tables_of_today():
    text = PAGE.read_text("utf-8")
    assert text.partition(BEGIN)[2].partition(END)[0].strip().splitlines() == page_lines()


@pytest.mark.slow
def test_the_frozen_problems_are_those_of_the_list():
    """By name: what the generator rounds may differ on another machine, and so do hashes."""
    assert sorted(case.name for case in made()) == sorted(problems.names())


def test_every_family_has_rows():
    rows = {name.partition("/")[0] for name in layout_bench.names()}
    assert {*FEASIBLE, "bedrooms", "designs", "infeasible"} | rows == set(problems.families())


def test_every_problem_was_measured():
    known = store.measured()
    for name in zoo_names():
        row = store.manifest()[name]
        assert known[name]["hash"] == row["hash"], f"measure {name} again"
        assert ("best_energy" in known[name]) == row["feasible"]


def test_measuring_finds_what_the_zoo_says_of_a_small_problem():
    case = problems.load("preferences/n005-t40")
    row = measure(case, 8, "cpu")
    assert row["hash"] == case.hash and row["difficulty"]["search"]["valid"] == 1.0
    assert case.best_energy - 1e-6 <= row["best_energy"] < float(case.compile("cpu").energy(case.witness[None])[0])
    assert case.compile("cpu").feasible(np.float32(row["best"])[None])[0]


def test_no_optimiser_finds_a_layout_where_there_is_none():
    for name in problems.names(feasible=False):
        assert all(row["valid"] == 0 for row in problems.load(name).difficulty.values())


def test_a_best_layout_that_is_none_is_noticed():
    case = problems.load("preferences/n005-t40")
    assert case.best is not None
    for change in ({"best_energy": case.best_energy / 2}, {"best": case.start("random", 1, 0)[0]}):
        with pytest.raises(InputError, match="best layout"):
            problems.verify(dataclasses.replace(case, **change))
