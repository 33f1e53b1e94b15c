"""Every relation of the catalogue, from random starts to a layout that the judge calls valid."""

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.scene import CATALOGUE
from tests.layout.made import ONE_OF_EACH, PARAMS


def test_each_type_has_a_scene():
    assert set(ONE_OF_EACH) == {name for name in CATALOGUE if "made_by_test" not in name}


@pytest.mark.parametrize("name", [*ONE_OF_EACH, *PARAMS])
@pytest.mark.parametrize("init", ["random", "sample"])
def test_relation_is_reached_and_the_judge_agrees(name, init):
    scene = (ONE_OF_EACH | PARAMS)[name]
    solution = sw.refine(scene, candidates=16, seed=3, init=init, device="cpu")
    assert np.mean(solution.status == 0) >= 0.9
    for i in range(solution.candidates):
        report = sw.check(solution.scene(i), walkable=False)
        if solution.status[i] == 0:
            assert report.valid, report.violations
        broken = {tuple(v.objects) for v in report.violations if v.kind == "relation"}
        if solution.relations[i].all():
            assert not broken


def test_relations_reported_match_the_judge_on_loose_layouts():
    """The engine's list of relations that hold never claims one that the judge denies."""
    claimed = 0
    for scene in (*ONE_OF_EACH.values(), *PARAMS.values()):
        start = np.random.default_rng(0).uniform((0.5, 0.5, 0, -3), (4.5, 3.5, 0, 3), (4, len(scene.objects), 4))
        start[..., 2] = [o.pose.position[2] for o in scene.objects]
        solution = sw.refine(scene, init=start, optimizer="adam", steps=2, seed=1, device="cpu")
        for i in range(solution.candidates):
            report = sw.check(solution.scene(i), walkable=False)
            bad = [v.detail for v in report.violations if v.kind == "relation"]
            for relation, holds in zip(scene.relations, solution.relations[i], strict=True):
                claimed += bool(holds)
                if holds:
                    assert not any(f"{relation.subject} {relation.type}" in text for text in bad), (relation, bad)
    assert claimed > 20
