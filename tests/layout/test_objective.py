"""Objectives: kernels against float64, what is valid stays valid, equal seeds, bad input."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from benchmarks.blocks import block_problem
from sceneweaver.layout import engine
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.minimise import measured_objective
from sceneweaver.layout.objective import ObjectiveTerm, terms_from
from sceneweaver.layout.objective_values import term_values
from sceneweaver.layout.rejudge import without_soft
from sceneweaver.scene import InputError, Scene

SCENE = Scene.example("bedroom")
NET = ObjectiveTerm("wire_length", ("bed", "wardrobe", "door"), weight=2.0)
TERMS = [
    NET,
    ObjectiveTerm("wire_length", ("bed", "armchair"), params={"pins": [[0.5, -0.3], [0.0, 0.4]]}),
    ObjectiveTerm("flow", ("bed", "armchair")),
    ObjectiveTerm("flow", ("bed", "door"), params={"metric": "manhattan"}),
    ObjectiveTerm("walking", ("bed", "door"), params={"sides": [1, 0]}),
    ObjectiveTerm("cost", ("armchair",), params={"point": [1.0, 2.0]}),
    ObjectiveTerm("cost", ("armchair",), weight=-0.5, params={"direction": [1.0, -2.0]}),
    ObjectiveTerm("exposed_wall"),
    ObjectiveTerm("exposed_wall", ("wall:1",), params={"depth": 0.8}),
    ObjectiveTerm("light", ("bed", "floor-lamp"), params={"flux": 400.0, "target": 500.0}),
    ObjectiveTerm("light", ("armchair", "floor-lamp", SCENE.room.windows[0].id), params={"target": 5000.0}),
]


def layouts(count: int, seed: int = 0) -> np.ndarray:
    """Poses [count, N, 4] anywhere around the room."""
    rng = np.random.default_rng(seed)
    home = np.array([(*o.pose.position, o.pose.yaw) for o in SCENE.objects])
    return home + rng.normal(size=(count, *home.shape)) * (1.0, 1.0, 0.1, 2.0)


def refined(scene: Scene, terms: list[ObjectiveTerm], **options: Any) -> sw.Solution:
    return sw.refine(scene, objective=terms, **({"candidates": 4, "device": "cpu", "explain": False} | options))


@pytest.mark.parametrize("term", TERMS, ids=lambda term: f"{term.kind}-{len(term.objects)}-{len(term.params or {})}")
def test_the_kernels_measure_what_float64_does(term: ObjectiveTerm) -> None:
    poses, compiled = layouts(64), compile_scene(SCENE)
    poses = poses[:12] if term.kind == "walking" else poses
    wanted = sw.objective_of(SCENE, [term], poses)
    assert np.ptp(wanted) > 0.01  # else nothing is compared
    np.testing.assert_allclose(measured_objective(compiled, [term], compiled.bodies(poses), "cpu"), wanted, atol=2e-4)


def test_values_by_hand() -> None:
    poses = layouts(1)
    a, b = (poses[0, SCENE.ids.index(name)] for name in ("bed", "armchair"))
    box = abs(a[0] - b[0]) + abs(a[1] - b[1])
    net, flow = ObjectiveTerm("wire_length", ("bed", "armchair")), ObjectiveTerm("flow", ("bed", "armchair"), 3.0)
    values = term_values(SCENE, [net, flow], poses)[0]
    assert values == pytest.approx([box, 3.0 * np.hypot(a[0] - b[0], a[1] - b[1])])
    problem = sw.compile(SCENE, device="cpu")
    assert sw.objective_of(problem, [net, flow], poses) == pytest.approx([values.sum()])


def test_a_way_goes_around_what_stands_in_it() -> None:
    """From one end of a narrow room to the other, past a wall of furniture that leaves a way at one side."""
    data = {
        "schema": SCENE.schema_,
        "id": "alley",
        "room": {"type": "hall", "outline": [[0, 0], [6, 0], [6, 3], [0, 3]]},
    }
    data["objects"] = [
        {"id": name, "category": "box", "mount": "floor", "size": list(size), "pose": {"position": [x, y, 0.0]}}
        for name, size, x, y in (
            ("a", (0.4, 0.4, 1.0), 0.5, 0.5),
            ("b", (0.4, 0.4, 1.0), 5.5, 0.5),
            ("bar", (0.5, 2.4, 1.0), 3.0, 1.22),
        )
    ]
    scene = Scene.from_json(data)
    home = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]])
    shut = home.copy()
    shut[0, 2, 1] = 1.5  # 0.3 m on both sides, where who walks needs 0.4 m
    layouts = np.concatenate([home, shut])
    term, compiled = ObjectiveTerm("walking", ("a", "b"), params={"sides": [0, 2]}), compile_scene(scene)
    found = sw.objective_of(scene, [term], layouts)
    ends = np.array([1.0, 0.5]), np.array([5.0, 0.5])
    corner = 2.42 + 0.2  # the way is above this where the bar ends
    around = 2 * np.hypot(1.75 - 0.2, corner - 0.5) + 0.9
    assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(4.0)
    assert around < found[0] < 1.15 * around
    assert found[1] == pytest.approx(4.0 + 18.0)  # no way: once around the room more
    np.testing.assert_allclose(measured_objective(compiled, [term], layouts, "cpu"), found, rtol=1e-3)


def test_light_follows_the_inverse_square_and_the_cosine() -> None:
    poses = layouts(2)
    bed, lamp = (SCENE.ids.index(name) for name in ("bed", "floor-lamp"))
    poses[:, bed], poses[:, lamp, 3] = (2.0, 2.0, 0.0, 0.0), 0.0
    rise = SCENE.objects[lamp].size[2] - 0.5
    poses[0, lamp, :3], poses[1, lamp, :3] = (2.0, 2.0, 0.0), (2.0 + np.sqrt(3.0) * rise, 2.0, 0.0)
    term = ObjectiveTerm("light", ("bed", "floor-lamp"), params={"height": 0.5, "flux": 1.0, "target": 1e3})
    lux = 1e3 * (1.0 - sw.objective_of(SCENE, [term], poses))
    assert lux[0] == pytest.approx(1.0 / (4 * np.pi * rise**2))
    assert lux[1] == pytest.approx(lux[0] / 8)  # twice as far, at 60 degrees


def test_all_of_an_empty_room_is_exposed_wall() -> None:
    far = layouts(1)
    far[..., :2] = 100.0
    length = sum(wall.length for wall in SCENE.room.walls)
    assert sw.objective_of(SCENE, [ObjectiveTerm("exposed_wall")], far) == pytest.approx([length])


def values(solution: sw.Solution) -> np.ndarray:
    assert solution.objective is not None
    return solution.objective


def test_valid_layouts_stay_valid_and_none_gets_worse() -> None:
    plain = engine.refine(SCENE, candidates=8, seed=3, device="cpu")
    before = sw.objective_of(SCENE, TERMS, plain.poses)
    found = refined(SCENE, TERMS, candidates=8, seed=3, moves=2000)
    assert (found.status <= plain.status).all()
    valid = plain.status == 0
    assert all(sw.check(found.scene(int(i))).valid for i in np.flatnonzero(valid))
    np.testing.assert_allclose(values(found)[valid], sw.objective_of(SCENE, TERMS, found.poses)[valid], atol=1e-3)
    assert values(found)[valid].mean() < before[valid].mean() - 0.5
    assert (np.diff(values(found)[found.ranked]) >= 0.0).all()


def test_a_candidate_is_the_same_whatever_stands_beside_it() -> None:
    many = refined(SCENE, [NET], candidates=6, seed=5, moves=500)
    few = refined(SCENE, [NET], candidates=3, seed=5, moves=500)
    assert (many.poses[:3] == few.poses).all()
    assert (refined(SCENE, [NET], candidates=6, seed=5, moves=500).poses == many.poses).all()
    both = sw.refine_many([SCENE, SCENE], candidates=6, seed=5, objective=[[NET], []], moves=500, device="cpu")
    assert (both[0].poses == many.poses).all() and both[1].objective is None


def test_without_an_objective_nothing_changes() -> None:
    plain = sw.refine(SCENE, candidates=4, seed=5, device="cpu", explain=False)
    assert plain.objective is None
    assert (refined(SCENE, [], seed=5).poses == plain.poses).all()


def test_blocks_are_packed() -> None:
    problem = block_problem(1, blocks=12, nets=18)
    scene, terms = problem.scene, problem.terms
    plain = sw.objective_of(scene, terms, sw.refine(scene, candidates=8, device="cpu", explain=False).poses)
    found = refined(scene, terms, candidates=8, moves=20_000)
    assert (found.status == 0).all() and sw.check(found.best).valid
    assert values(found).max() < 0.8 * plain.min()
    again = refined(scene, terms, candidates=3, moves=20_000)
    assert (again.poses == found.poses[:3]).all()


def test_a_time_limit_cuts_off() -> None:
    problem = block_problem(1)
    found = refined(problem.scene, problem.terms, candidates=8, moves=10**8, time_limit=2.0)
    assert found.timed_out and (found.status == 0).any()


def test_soft_rows_cost_no_valid_layout() -> None:
    """Soft relations that ask for overlap, weighing a thousand times what is usual."""
    problem = block_problem(2, blocks=14, nets=20)
    plain = engine.refine(problem.scene, candidates=8, device="cpu")
    data = json.loads(problem.scene.model_dump_json())
    data["relations"] = [
        {"type": "near", "subject": f"b{i}", "target": f"b{j}", "hard": False, "weight": 1e3} for i, j in problem.nets
    ]
    pulled = Scene.from_json(data)
    found = engine.refine(pulled, candidates=8, device="cpu")
    assert (found.status[plain.status == 0] == 0).all()
    assert ((refined(pulled, problem.terms, candidates=8, moves=200).status == 0) >= (plain.status == 0)).all()


def test_candidates_that_soft_rows_spoil_are_those_without_them(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled = compile_scene(SCENE)
    bare = without_soft(compiled)
    assert bare is not None and all(relation.fault for relation in bare.room.relations)
    real, calls = engine.solve, []

    def spoilt(jobs: Any, *args: Any, **options: Any) -> Any:
        found = real(jobs, *args, **options)
        if not calls:
            found[0].status[1::2] = 1
        calls.append(jobs)
        return found

    monkeypatch.setattr(engine, "solve", spoilt)
    found = engine.refine(SCENE, candidates=4, seed=2, device="cpu")
    assert len(calls) == 2 and (found.status == 0).all()
    scene = SCENE.model_copy(update={"relations": tuple(r for r in SCENE.relations if r.hard)})
    monkeypatch.undo()
    alone = engine.refine(scene, candidates=4, seed=2, device="cpu")
    assert (found.poses[1::2] == alone.poses[1::2]).all()


@wp.func
def _apart(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
    return p[0] - wp.length(wp.vec2(a[0] - b[0], a[1] - b[1]))


def test_terms_of_the_users_own() -> None:
    sw.define_term("apart", residual=_apart, subjects=["no such thing"], targets=["nothing"], params=[3.0])
    try:
        term = ObjectiveTerm("user", ("bed", "armchair"), params={"name": "apart", "values": [3.0]})
        poses, compiled = layouts(8), compile_scene(SCENE)
        way = np.linalg.norm(poses[:, SCENE.ids.index("bed"), :2] - poses[:, SCENE.ids.index("armchair"), :2], axis=1)
        np.testing.assert_allclose(sw.objective_of(SCENE, [term], poses), 3.0 - way, atol=1e-5)
        measured = measured_objective(compiled, [term], compiled.bodies(poses), "cpu")
        np.testing.assert_allclose(measured, 3.0 - way, atol=1e-5)
    finally:
        sw.undefine_term("apart")


BAD = [
    ({"kind": "length"}, "not one of"),
    ({"kind": "wire_length", "objects": ["bed"]}, "at least 2"),
    ({"kind": "wire_length", "objects": "bed"}, "list of ids"),
    ({"kind": "wire_length", "objects": ["bed", "armchair"], "params": {"pins": [[0, 0]]}}, "pins"),
    ({"kind": "wire_length", "objects": ["bed", "armchair"], "params": {"pin": []}}, "no parameter pin"),
    ({"kind": "wire_length", "objects": ["bed", "armchair"], "weight": -1.0}, "negative"),
    ({"kind": "flow", "objects": ["bed", "armchair"], "weight": float("nan")}, "finite"),
    ({"kind": "flow", "objects": ["bed", "armchair"], "params": {"metric": "taxi"}}, "metric"),
    ({"kind": "walking", "objects": ["bed", "door"], "params": {"sides": [0, 4]}}, "sides"),
    ({"kind": "cost", "objects": ["bed"]}, "point and direction"),
    ({"kind": "exposed_wall", "params": {"depth": 0.0}}, "depth"),
    ({"kind": "light", "objects": ["bed", "floor-lamp"], "params": {"flux": [1.0, 2.0]}}, "flux"),
    ({"kind": "light", "objects": ["bed", "floor-lamp"], "params": {"target": 0.0}}, "target"),
    ({"kind": "user", "objects": ["bed"]}, "name"),
    ({"kind": "flow", "objects": ["bed", "armchair"], "wieght": 1.0}, "wieght"),
    ("wire", "mapping"),
]


@pytest.mark.parametrize(("data", "words"), BAD)
def test_what_is_out_of_range_is_refused(data: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        terms_from([data])


def test_names_are_looked_up_before_anything_runs() -> None:
    with pytest.raises(InputError, match="a list of terms"):
        terms_from({"kind": "flow"})
    for term in (ObjectiveTerm("flow", ("bed", "sofa")), ObjectiveTerm("exposed_wall", ("wall:9",))):
        with pytest.raises(InputError, match="of the scene"):
            refined(SCENE, [term])
    with pytest.raises(InputError, match="not defined"):
        refined(SCENE, [ObjectiveTerm("user", ("bed",), params={"name": "nobody"})])
    with pytest.raises(InputError, match="moves"):
        refined(SCENE, [NET], moves=0)
    with pytest.raises(InputError, match="there are 2"):
        sw.refine_many([SCENE, SCENE], objective=[[NET]])
    with pytest.raises(InputError, match="poses"):
        sw.objective_of(SCENE, [NET], np.zeros((2, 1, 4)))


def test_a_term_is_the_same_after_json() -> None:
    assert terms_from(json.loads(json.dumps([term.to_dict() for term in TERMS]))) == [
        ObjectiveTerm(t.kind, t.objects, t.weight, json.loads(json.dumps(t.params))) for t in TERMS
    ]
