"""Every family runs at its smallest and finds nothing wrong. No time is asserted."""

from __future__ import annotations

import pytest

from benchmarks.families import FAMILIES
from benchmarks.judging import Judge
from benchmarks.markdown import WIDTH, result_lines
from benchmarks.results import Result
from benchmarks.settings import Settings

TABLES = {
    "quality": {"validity": 3, "variety": 3, "rivals": 5},
    "throughput": {"throughput": 2, "boxes": 4},
    "cold": {"cold": 3},
    "scaling": {"objects": 2, "candidates": 1},
    "memory": {"candidates": 1, "objects": 2},
    "soundness": {"soundness": 2},
    "edits": {"edits": 5, "rooms": 1, "detail": 5},
}


@pytest.fixture
def settings(tmp_path):
    rivals = ("numpy descent",)  # the others have tests of their own, and need not be installed
    return Settings(rooms=("bedroom-small",), device="cpu", quick=True, most=4, rivals=rivals, out=tmp_path)


@pytest.mark.parametrize("name", FAMILIES)
def test_family_at_its_smallest(name, settings, tmp_path):
    result = FAMILIES[name](settings, Judge(1))
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
