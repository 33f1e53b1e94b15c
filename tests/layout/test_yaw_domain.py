"""Domains of yaw: any yaw, quarter turns or a set of angles, honoured by every way a pose is found."""

import json
import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout.yaw_domain import into_domain, into_domains, turns_along

SET = (10.0, 100.0, 235.0)


def room(yaw_domain=None, *, relations=(), yaw=0.4, **more):
    """A room of three movable boxes; the first has a domain of yaw."""
    objects = [
        {"id": "a", "category": "box", "size": [0.6, 1.2, 0.5], "yaw_domain": yaw_domain, **more},
        {"id": "b", "category": "box", "size": [0.5, 0.5, 0.5]},
        {"id": "c", "category": "box", "size": [0.4, 0.9, 0.5]},
    ]
    half = yaw / 2
    for i, obj in enumerate(objects):
        obj["pose"] = {"position": [1.0 + 1.2 * i, 1.0, 0.0], "quaternion": [0.0, 0.0, math.sin(half), math.cos(half)]}
    return sw.Scene.from_json(
        {
            "schema": "sceneweaver.scene/1",
            "id": "boxes",
            "room": {"outline": [[0, 0], [4.4, 0], [4.4, 3.2], [0, 3.2]], "height": 2.5},
            "objects": objects,
            "relations": list(relations),
        }
    )


def off(yaws, allowed):
    """Angles [rad] from yaws to the nearest that are allowed [deg]."""
    d = np.asarray(yaws, dtype=float)[..., None] - np.radians(allowed)
    return np.abs(d - math.tau * np.round(d / math.tau)).min(axis=-1)


@pytest.mark.parametrize("domain", ["quarter_turns", SET])
@pytest.mark.parametrize(
    "how",
    [
        {"optimizer": "search"},
        {"optimizer": "search", "init": "random", "snap": True},
        {"optimizer": "search", "init": "current"},
        {"optimizer": "projection", "init": "current"},
        {"optimizer": "adam", "steps": 40},
        {"optimizer": "lbfgs", "steps": 40},
        {"optimizer": "tempering", "steps": 40},
    ],
    ids=lambda how: "-".join(map(str, how.values())),
)
def test_every_layout_is_in_the_domain(domain, how):
    solution = sw.refine(room(domain), candidates=12, device="cpu", seed=1, **how)
    allowed = (0, 90, 180, 270) if domain == "quarter_turns" else domain
    assert off(solution.poses[:, 0, 3], allowed).max() < 1e-3
    valid = [i for i in range(solution.candidates) if solution.status[i] == 0]
    assert valid and all(sw.check(solution.scene(i), walkable=False).valid for i in valid[:4])


def test_all_values_of_a_domain_are_found():
    solution = sw.refine(room(SET), candidates=64, device="cpu", seed=2)
    nearest = np.abs(np.degrees(solution.poses[:, 0, 3])[:, None] % 360.0 - SET).argmin(axis=1)
    assert set(nearest) == {0, 1, 2}


def test_a_scene_without_domains_says_nothing_of_them_and_one_with_keeps_them():
    assert "yaw_domain" not in json.dumps(room().to_json())
    scene = room((90, 0.0))
    assert scene.to_json()["objects"][0]["yaw_domain"] == [90.0, 0.0] and scene.objects[0].yaws == (0.0, 90.0)
    assert sw.Scene.loads(scene.dumps()) == scene
    assert sw.Scene.loads(room("quarter_turns").dumps()).objects[0].yaws == (0.0, 90.0, 180.0, 270.0)


@pytest.mark.parametrize("wrong", [[], [float("nan")], "eighths", [True], list(range(100)), 90])
def test_wrong_domains_are_refused(wrong):
    with pytest.raises(sw.InputError, match="yaw_domain"):
        room(wrong)


def test_the_judge_says_when_a_yaw_is_off_and_the_engine_agrees():
    scene = room("quarter_turns", yaw=0.0)
    assert sw.check(scene).valid
    turned = room("quarter_turns", yaw=math.radians(3.0), fixed=True)
    report = sw.check(turned)
    found = [v for v in report.violations if v.kind == "yaw_domain"]
    assert not report.valid and [v.objects for v in found] == [("a",)] and found[0].amount == pytest.approx(3.0)
    assert not sw.refine(turned, candidates=4, device="cpu").ranked.size  # fixed where it may not be
    problem = sw.compile(scene, device="cpu")
    poses = np.array(problem.home)
    assert problem.feasible(poses).all()
    poses[0, 0, 3] = 0.01
    assert not problem.feasible(poses).any()


def test_what_a_surface_carries_turns_in_the_frame_of_what_carries_it():
    plate = {"name": "top", "polygon": [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]], "z": 0.7}
    data = room().to_json()
    data["objects"] = [
        {**data["objects"][0], "id": "table", "size": [1.0, 1.0, 0.7], "surfaces": [plate]},
        {
            "id": "book", "category": "book", "size": [0.2, 0.3, 0.05], "mount": "surface",
            "support": {"object": "table", "surface": "top"}, "yaw_domain": [90.0, 180.0],
            "pose": {"position": [1.0, 1.0, 0.7], "quaternion": [0, 0, 0, 1]},
        },
    ]  # fmt: skip
    scene = sw.Scene.from_json(data)
    assert [v.objects for v in sw.check(scene).violations if v.kind == "yaw_domain"] == [("book",)]
    for init in ("sample", "current"):
        solution = sw.refine(scene, candidates=8, device="cpu", init=init)
        assert len(solution.ranked) == 8
        assert off(solution.poses[:, 1, 3] - solution.poses[:, 0, 3], (90, 180)).max() < 1e-3
        assert sw.check(solution.best).valid


def test_problem_tells_of_domains():
    problem = sw.compile(room(SET), device="cpu")
    info = problem.metadata[0].objects[0]
    assert not problem.free[0, 0, 3] and problem.free[0, 1, 3]
    assert np.degrees(info.yaws) % 360.0 == pytest.approx(np.array(SET))
    assert info.lower[3] == pytest.approx(math.radians(-125.0)) and info.upper[3] == pytest.approx(math.radians(100.0))
    assert off(problem.home[0, 0, 3], SET) < 1e-6
    drawn = problem.sample(3, 16)
    assert off(drawn[:, 0, 3], SET).max() < 1e-3
    assert problem.metadata[0].objects[1].yaws == ()
    projected = problem.project(drawn)
    assert off(projected[:, 0, 3], SET).max() < 1e-3


def test_a_child_is_carried_along_by_turns_that_keep_its_domain_only():
    quarters = tuple(math.radians(a) for a in (0, 90, 180, -90))
    assert turns_along((), (0.1,)) and turns_along((0.2,), (0.7,)) and turns_along(quarters, quarters)
    assert not turns_along(quarters, ()) and not turns_along((0.0, math.pi / 2), quarters)
    chair = {"type": "facing", "subject": "a", "target": "b"}
    solution = sw.refine(room("quarter_turns", relations=[chair]), candidates=16, device="cpu", seed=4)
    assert off(solution.poses[:, 0, 3], (0, 90, 180, 270)).max() < 1e-3


def test_given_layouts_go_to_the_nearest_yaw_with_what_they_carry():
    assert into_domain((), 0.3) == 0.3 and into_domain((0.0, 3.0), 1.6) == 3.0
    world = np.array([[[1.0, 1.0, 0.0, 0.1], [1.5, 1.0, 0.7, 0.3]]])
    moved = into_domains([(0.0, math.pi / 2), ()], [True, False], np.array([0, 0]), world)
    assert moved[0, 0, 3] == pytest.approx(0.0) and moved[0, 1, 3] == pytest.approx(0.2)
    assert moved[0, 1, :2] == pytest.approx([1.0 + 0.5 * math.cos(0.1), 1.0 - 0.5 * math.sin(0.1)])
    untouched = np.zeros((2, 1, 4))
    assert into_domains([()], [True], np.array([0]), untouched) is untouched
