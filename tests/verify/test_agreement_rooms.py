"""The judge and the oracle agree on disturbed living rooms, offices and a gym; see agreement.py."""

import pytest

from tests.verify.agreement import CATEGORIES, ORACLE_TYPES, Agreement, compare

ROOMS = {
    "living": 450,
    "living-dining-L": 450,
    "studio-U": 450,
    "office-20": 400,
    "office-dense": 400,
    "gym-30": 350,
}


@pytest.fixture(scope="module", params=[20, pytest.param(1, marks=pytest.mark.slow)], ids=["some", "all"])
def agreement(request: pytest.FixtureRequest) -> Agreement:
    return compare({name: count // request.param for name, count in ROOMS.items()}, moves=10)


def test_same_verdicts(agreement):
    print(f"{agreement.layouts} layouts, {len(agreement.near)} verdicts differ at a threshold")
    assert not agreement.wrong
    assert len(agreement.near) <= agreement.layouts / 100


@pytest.mark.parametrize("kind", [*CATEGORIES, *ORACLE_TYPES])
def test_every_verdict_occurs(agreement, kind):
    assert min(agreement.seen[kind, False], agreement.seen[kind, True]) >= agreement.layouts // 64
