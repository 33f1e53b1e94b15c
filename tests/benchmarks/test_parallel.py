"""Calls side by side."""

import os

import pytest

from benchmarks.parallel import core_shares, each


def _where(k: int) -> tuple[int, frozenset[int]]:
    return k, frozenset(os.sched_getaffinity(0))


def _fail(k: int) -> int:
    if k == 1:
        raise ValueError(f"call {k}")
    return k


@pytest.mark.skipif(not hasattr(os, "sched_getaffinity"), reason="processes can't be bound to cores here")
def test_results_come_in_order_and_processes_share_no_core():
    shares = {frozenset(share) for share in core_shares(2)}
    found = each(_where, [(k,) for k in range(4)], jobs=2)
    assert [k for k, _ in found] == list(range(4))
    assert {cores for _, cores in found} <= shares
    assert sum(len(share) for share in shares) <= len(os.sched_getaffinity(0))


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_a_call_raises_reaches_the_caller(jobs):
    with pytest.raises(ValueError, match="call 1"):
        each(_fail, [(k,) for k in range(3)], jobs)


def test_no_calls_need_no_process():
    assert each(_fail, [], jobs=4) == []


def test_more_shares_than_cores_are_not_made():
    shares = core_shares(10_000)
    assert 1 <= len(shares) <= (os.cpu_count() or 1)
    assert all(len(share) == len(shares[0]) for share in shares)
