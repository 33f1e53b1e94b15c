"""The judge and the oracle agree on disturbed halls of 64 to 293 objects, and on all zoo rooms as they are."""

import pytest

from sceneweaver.scene import Scene
from sceneweaver.verify import check
from tests.verify.agreement import ZOO, Agreement, by_check, by_oracle, compare, zoo

ROOMS = {"restaurant-60": 60, "restaurant-dense": 60, "library-100": 50, "hall-300": 20}


@pytest.fixture(scope="module", params=[10, pytest.param(1, marks=pytest.mark.slow)], ids=["some", "all"])
def agreement(request: pytest.FixtureRequest) -> Agreement:
    return compare({name: count // request.param for name, count in ROOMS.items()}, moves=25)


def test_same_verdicts(agreement):
    print(f"{agreement.layouts} layouts, {len(agreement.near)} verdicts differ at a threshold")
    assert not agreement.wrong
    assert len(agreement.near) <= agreement.layouts / 38


@pytest.mark.parametrize("name", sorted(path.stem for path in ZOO.glob("*.json")))
def test_zoo_is_valid(name):
    scene = zoo(name)
    report = check(Scene.model_validate(scene))
    assert report.valid, [v.detail for v in report.violations]
    assert report.relations.hard.total == report.relations.hard.satisfied
    assert 0.0 < report.walkable_share <= 1.0
    assert 0.0 < report.reachable_share <= 1.0
    assert by_check(scene) == by_oracle(scene) == set()
