"""Layouts of what stands on surfaces: solved once, whoever asks."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import pools
from tests.layout.made import scene, table, thing

CUP = thing("cup", (0.1, 0.1, 0.1), mount="surface", support={"object": "table", "surface": "top"})
ROOM = scene([table(), CUP], [])


@pytest.fixture
def solved(monkeypatch):
    """How many surfaces were solved in each call; nothing is known at first."""
    counts, solve = [], pools._solved

    def counted(surfaces, device, monitor):
        counts.append(len(surfaces))
        return solve(surfaces, device, monitor)

    monkeypatch.setattr(pools, "_solved", counted)
    monkeypatch.setattr(pools, "_known", type(pools._known)())
    return counts


def test_equal_surfaces_are_solved_once_and_the_result_is_the_same(solved):
    first = sw.refine(ROOM, candidates=8, seed=1)
    second = sw.refine(ROOM, candidates=8, seed=1)
    assert solved == [1]
    np.testing.assert_array_equal(first.poses, second.poses)
    sw.refine_many([ROOM, ROOM], candidates=4, seed=2)
    assert solved == [1, 1], "another seed, and both rooms share its layouts"


def test_another_size_or_another_neighbour_is_another_surface(solved):
    larger = ROOM.model_copy(update={"objects": (ROOM.objects[0], CUP.model_copy(update={"size": (0.2, 0.1, 0.1)}))})
    more = ROOM.model_copy(update={"objects": (*ROOM.objects, CUP.model_copy(update={"id": "mug"}))})
    for room in (ROOM, larger, more):
        sw.refine(room, candidates=4, seed=1)
    assert solved == [1, 1, 1]


def test_no_more_are_kept_than_there_is_room_for(solved, monkeypatch):
    monkeypatch.setattr(pools, "KEPT", 2)
    for seed in (1, 2, 3, 1):
        sw.refine(ROOM, candidates=4, seed=seed)
    assert len(solved) == 4 and len(pools._known) == 2


def test_what_time_cut_off_is_not_kept(solved, monkeypatch):
    solve = pools._solved

    def cut_off(surfaces, device, monitor):
        monitor.break_off()
        return solve(surfaces, device, monitor)

    monkeypatch.setattr(pools, "_solved", cut_off)
    sw.refine(ROOM, candidates=4, seed=1)
    assert solved == [1] and not pools._known
