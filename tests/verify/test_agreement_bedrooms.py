"""The judge and the oracle agree on disturbed bedrooms; see agreement.py."""

import pytest

from tests.verify.agreement import CATEGORIES, ORACLE_TYPES, Agreement, compare

ROOMS = {
    "bedroom-full-wall": 450,
    "bedroom-small": 500,
    "bedroom-tight": 450,
    "bedroom": 450,
    "children-twin": 450,
    "dining-round": 450,
    "lockers-wall-full": 450,
}


@pytest.fixture(scope="module", params=[30, pytest.param(1, marks=pytest.mark.slow)], ids=["some", "all"])
def agreement(request: pytest.FixtureRequest) -> Agreement:
    return compare({name: count // request.param for name, count in ROOMS.items()}, moves=6)


def test_same_verdicts(agreement):
    print(f"{agreement.layouts} layouts, {len(agreement.near)} verdicts differ at a threshold")
    assert not agreement.wrong
    assert len(agreement.near) <= agreement.layouts / 100


@pytest.mark.parametrize("kind", [*CATEGORIES, *ORACLE_TYPES])
def test_every_verdict_occurs(agreement, kind):
    assert min(agreement.seen[kind, False], agreement.seen[kind, True]) >= agreement.layouts // 64
