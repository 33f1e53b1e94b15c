"""Every family runs at its smallest and finds nothing wrong. No time is asserted."""

from __future__ import annotations

from dataclasses import replace

import pytest

from benchmarks import rooms
from benchmarks.families import FAMILIES
from benchmarks.judging import Judge
from benchmarks.markdown import WIDTH, result_lines
from benchmarks.results import Result
from benchmarks.settings import Settings

TABLES = {
    "quality": {"validity": 3, "variety": 3, "rivals": 5},
    "optimizers": {"overall": 10, "rates": 4, "rooms": 10, "detail": 10},
    "throughput": {"throughput": 2, "boxes": 4},
    "large": {"large": 1, "memory": 1},
    "cold": {"cold": 3},
    "scaling": {"objects": 2, "candidates": 1},
    "memory": {"candidates": 1, "objects": 2, "designs": 1},
    "soundness": {"soundness": 2},
    "edits": {"edits": 5, "rooms": 1, "detail": 5},
    "live": {"sizes": 2, "edits": 5, "rooms": 1, "detail": 5},
    "tight": {"tight": 2},
    "soft_rows": {"mixes": 2, "objectives": 1},
    "weights": {"sets": 2},
    "projection": {"bodies": 1, "scenes": 2},
    "design": {"rooms": 1, "seeds": 1},
    "critic": {"grades": 5, "scenes": 3},
    "looks": {"critics": 1, "grades": 5, "scenes": 3},
    "patterns": {"patterns": 29},
    "choice": {"curve": 2, "agreement": 0},
    "objectives": {"blocks": 3, "rooms": 1},
    "ablations": {"parts": 6, "tools": 4, "each": 9},
    "variety": {"rooms": 2, "variety": 11},
    "jax": {"calls": 1},
    "derivatives": {"kinds": 6},
    "requests": {"requests": 1, "reported": 0},
    "home_requests": {"read": 16},
    "plans": {"plans": 3},
    "odd": {"odd": 3},
    "physics": {"worlds": 2},
    "environments": {"worlds": 1},
    "navigation": {"homes": 1},
    "pictures": {"pictures": 1},
    "stability": {"rooms": 2, "seeds": 1},
    "openable": {"rooms": 2, "seeds": 1},
    "by_model": {"rooms": 2},
    "variables": {"optima": 1, "fronts": 1},
    "field_repair": {"shares": 0, "violations": 0, "left": 0},  # without a folder of scenes there is nothing to repair
    "prior": {"prior": 4, "equal": 6, "grades": 4, "detail": 12},
}


@pytest.fixture
def settings(tmp_path):
    rivals = ("numpy descent",)  # the others have tests of their own, and need not be installed
    return Settings(rooms=("bedroom-small",), device="cpu", quick=True, most=4, rivals=rivals, out=tmp_path)


SLOW = (
    *("openable", "odd", "pictures", "ablations", "by_model", "requests", "stability", "variety"),
    *("cold", "memory", "throughput", "design", "quality", "patterns", "large", "soft_rows", "weights", "derivatives"),
    *("prior", "navigation", "plans"),
)
"""Families whose design is one that another family makes as well, and what takes longest."""


SMALL = {"design": ("bathroom",), "choice": ("bathroom",)}
"""The kind of room to design, where one does for the tables."""


@pytest.mark.parametrize("name", [pytest.param(n, marks=[pytest.mark.slow] if n in SLOW else []) for n in FAMILIES])
def test_family_at_its_smallest(name, settings, tmp_path):
    result = FAMILIES[name](replace(settings, kinds=SMALL.get(name, ())), Judge(1))
    assert result.family == name
    assert result.failures == []
    for table, rows in TABLES[name].items():
        assert len(result.table(table).rows) == rows, table
    for table in result.tables:
        for row in table.rows:
            assert row.get("exceptions") in (None, 0)
            assert all(row.get(c.key) is not None for c in table.columns[: table.keys])
    for plot in result.plots:
        table = result.table(plot.table)
        assert {plot.x, *plot.y} <= {c.key for c in table.columns}
    assert Result.load(result.save(tmp_path)) == result
    assert max(map(len, result_lines(result))) <= WIDTH


def test_projection_beside_a_rival(settings, monkeypatch):
    def witness(scene, start, seconds):
        return rooms.witness(scene), True

    monkeypatch.setattr("benchmarks.families.projection._rival", lambda *_: witness)
    (row,) = FAMILIES["projection"](settings, Judge(1)).table("drake").rows
    assert row["theirs"] == row["both"] == 1 and row["their_feasible"] == 1.0
    assert 0 < row["ratio"] <= 1.0, "the nearest feasible layout is no further away than another feasible one"


def test_projection_without_a_rival_says_so(settings, monkeypatch):
    monkeypatch.setattr("benchmarks.families.projection.RIVAL", "benchmarks.rivals.nobody")
    result = FAMILIES["projection"](replace(settings, rivals=None), Judge(1))
    assert any("nobody cannot be imported" in note for note in result.notes)
