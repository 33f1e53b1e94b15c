"""The tables of a problem and the state of candidates are what their declarations say."""

from __future__ import annotations

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels.tables import STATE, TABLES, State, Tables
from sceneweaver.layout.pack import pack
from sceneweaver.optimizers import new_state
from tests.kernels.harness import zoo

ROOMS = ("living-dining-L", "office-20", "bedroom-small")


@pytest.fixture(scope="module")
def packed():
    return pack([zoo(name).room for name in ROOMS], "cpu")


def test_names_are_declared_once():
    for tables, struct in ((TABLES, Tables), (STATE, State)):
        names = [table.name for table in tables]
        assert len(set(names)) == len(names) and set(names) <= set(struct.vars)
        assert all(table.meaning for table in tables)
    assert set(Tables.vars) - {table.name for table in TABLES} == {"pool_size"}


def test_tables_have_the_declared_lengths(packed):
    """What counts the same has the same length, and a range more has one element more."""
    counts = {
        "problem": len(ROOMS),
        "object": sum(zoo(name).room.size for name in ROOMS),
        "relation": sum(len(zoo(name).room.relations) for name in ROOMS),
        "pair": sum(zoo(name).room.size ** 2 for name in ROOMS),
    }
    counts["2 object"] = 2 * counts["object"]
    for table in TABLES:
        (dimension,) = table.shape
        what, _, more = dimension.partition(" + ")
        length = getattr(packed.keep, table.name).shape[0] - int(more or 0)
        assert counts.setdefault(what, length) == length, table.name


def test_ranges_cover_their_tables(packed):
    columns = {table.name: getattr(packed.keep, table.name).numpy() for table in TABLES}
    for name, start in columns.items():
        if name.endswith("_start") and name != "pair_start":
            assert (np.diff(start) >= 0).all(), name
            covered = columns.get(name.removesuffix("_start"))
            if covered is not None:
                assert start[0] == 0 and start[-1] == len(covered), name
    assert (columns["row_start"][-1] == columns["snap_start"][0]) and len(columns["row_feature"]) == columns[
        "snap_start"
    ][-1]


def test_a_new_state_has_the_declared_shapes(device):
    state = new_state(5, 3, 4, device)
    counts = {"candidate": 5, "object": 3, "relation": 4, "1": 1}
    for table in STATE:
        array = getattr(state, table.name)
        assert array.dtype == table.dtype and not array.numpy().any()
        for dimension, length in zip(table.shape, array.shape, strict=True):
            assert counts.setdefault(dimension, length) == length
    assert isinstance(state.poses, wp.array)
