"""Derivatives by parameters, second ones, and of solved layouts, beside differences of what is made and solved anew.

``python -m benchmarks derivatives`` compares twenty problems.
"""

from __future__ import annotations

import functools

import numpy as np
import pytest

import sceneweaver as sw
from benchmarks.families import derivatives as twin
from sceneweaver.layout.parameters import KINDS
from tests.layout.made import BED, BOX, CUP, OTHER, PICTURE, TELLY, relation, scene, table

LAYOUTS = 3


@functools.cache
def mixed() -> sw.Problem:
    """Every kind of row in one small room: lines, angles, extents, windows, heights, distances, spreads."""
    relations = [
        relation("against_wall", "bed"),
        relation("near", "box", "bed", max=0.4),
        relation("facing", "other", "table", degrees=20),
        relation("above", "picture", "bed"),
        relation("in_corner", "other"),
        relation("at_window", "table", "window"),
        relation("away_from_door", "box"),
        relation("near", "other", "table"),
    ]
    return sw.compile(scene([BED, BOX, OTHER, table(), CUP, PICTURE, TELLY], relations), device="cpu")


@pytest.mark.parametrize("kind", ["size", "outline", "opening", "relation", "weight"])
def test_slopes_are_those_of_problems_compiled_anew(kind):
    problem = mixed()
    poses = twin.layouts(problem, 6, 1)
    found = twin.compare("mixed", problem, kind, poses, 12)
    assert (np.abs(found.expected) > twin.LEAST).sum() >= 5 and found.kinks < 2 * found.errors.size
    assert found.errors.max() < twin.BOUND


@pytest.mark.slow
@pytest.mark.parametrize("name", twin.ZOO[:5])
def test_slopes_in_rooms_of_the_zoo(name):
    problem = sw.compile(twin.scenes()[name], device="cpu")
    for kind in ("size", "outline", "opening", "relation", "weight"):
        found = twin.compare(name, problem, kind, twin.layouts(problem, 3, 0), 8)
        assert found.errors.max(initial=0.0) < twin.BOUND, kind


def test_weights_of_users_terms():
    with twin.user_term():
        problem = sw.compile(sw.Scene.example("study"), device="cpu")
        poses = twin.layouts(problem, LAYOUTS, 0)
        assert twin.compare("study", problem, "term", poses, 4).errors.max() < 1e-5
        assert problem.parameters.labels["term"] == (("term/near the middle",),)


def test_the_energy_is_the_sum_of_what_weights_say():
    """The energy is linear in weights: with all of relations at zero, what is missing is their slopes."""
    problem = mixed()
    poses = twin.layouts(problem, LAYOUTS, 2)
    slope = problem.parameter_gradient(poses, of="weight")["weight"]
    rest = problem.energy_at(poses, {"weight": np.zeros_like(problem.parameters.values["weight"])})
    np.testing.assert_allclose(problem.energy(poses), rest + slope.sum(1), rtol=1e-5)


def test_scenes_side_by_side_have_the_slopes_that_they_have_alone():
    alone = [mixed(), sw.compile(scene([BOX, OTHER], [relation("near", "box", "other")]), device="cpu")]
    both = sw.compile([p.scenes[0] for p in alone], device="cpu")
    which = np.array([1, 0, 1], dtype=np.int32)
    poses = both.sample(0, 3)[:3]
    found = both.parameter_gradient(poses, which)
    for b, s in enumerate(which):
        one = alone[s].parameter_gradient(poses[b : b + 1, : alone[s].objects])
        for kind in KINDS:
            part = found[kind][b][tuple(slice(0, n) for n in one[kind].shape[1:])]
            np.testing.assert_allclose(part, one[kind][0], atol=1e-5)
            assert np.abs(found[kind][b]).sum() == pytest.approx(np.abs(one[kind]).sum(), rel=1e-4, abs=1e-5)


def test_equal_layouts_have_equal_slopes():
    problem, other = mixed(), sw.compile(mixed().scenes[0], device="cpu")
    poses = problem.sample(0, 4)
    for kind in KINDS:
        first, second = (p.parameter_gradient(poses, of=kind)[kind] for p in (problem, other))
        np.testing.assert_array_equal(first, second)


def test_products_are_differences_of_gradients():
    problem = sw.compile(scene([BED, BOX], [relation("near", "box", "bed")]), device="cpu")
    poses = (problem.sample(5, 3) + np.random.default_rng(0).normal(0, 0.05, (3, 2, 4)) * problem.free).astype("f4")
    along = np.random.default_rng(1).normal(size=poses.shape).astype("f4")
    step = 2e-3 / np.abs(along).max()
    ahead, behind = (problem.energy_and_grad(poses + s * step * along)[1] for s in (1, -1))
    product = problem.hessian_product(poses, along)
    close = np.isclose(product, (ahead - behind) / (2 * step), rtol=0.05, atol=0.2)
    assert close.mean() > 0.8 and np.abs(product).max() > 1.0
    residual, slope = problem.residuals(poses)
    jacobian = np.zeros((3, problem.items, 2, 4))
    for m, objects in enumerate(problem.item_objects[0]):
        for k, obj in enumerate(objects):
            if obj >= 0:
                jacobian[:, m, obj] += slope[:, m, k]
    pushed = np.einsum("bmnc,bnc->bm", jacobian, along)
    wanted = np.einsum("bmnc,bm->bnc", jacobian, pushed) / 0.05
    np.testing.assert_allclose(problem.gauss_newton_product(poses, along), wanted, rtol=1e-4, atol=1e-4)


def test_mixed_products_are_differences_of_slopes():
    problem = mixed()
    poses = twin.layouts(problem, 2, 4)
    along = np.random.default_rng(1).normal(size=poses.shape).astype("f4")
    found = problem.mixed_product(poses, along, of=("weight", "size"))
    step = 2e-3 / np.abs(along).max()
    ahead, behind = (problem.parameter_gradient(poses + s * step * along, of="weight")["weight"] for s in (1, -1))
    close = np.isclose(found["weight"], (ahead - behind) / (2 * step), rtol=0.05, atol=0.02)
    assert close.mean() > 0.8 and np.abs(found["weight"]).max() > 0.1 and found["size"].shape[1:] == (7, 3)


def anchors(problem: sw.Problem, count: int) -> np.ndarray:
    noise = np.random.default_rng(0).normal(0.0, (0.15, 0.15, 0.0, 0.15), (count, problem.objects, 4))
    return problem.carry((problem.home + noise * problem.free).astype(np.float32))


@pytest.mark.parametrize("kind", ["outline", pytest.param("size", marks=pytest.mark.slow)])
def test_projections_move_as_they_do_when_solved_anew(kind):
    """A parameter is moved by 2 cm either way and all is projected again; where both sides agree, so do we, to 5 %."""
    problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
    given = anchors(problem, 2)
    solved = problem.project(given)
    moves = problem.sensitivity(solved, of=kind, anchors=given)[kind]
    labels, errors = problem.parameters.labels[kind][0], []
    places = [tuple(at) for at in np.argwhere(problem.parameters.mask[kind]).tolist()]
    for place, _ in zip(places[:24], labels, strict=False):
        sides = []
        for h in (0.02, -0.02):
            values = problem.parameters.values[kind].copy()
            values[place] += h
            sides.append((problem.at({kind: values}).project(given).astype(float) - solved) / h)
        for b in range(2):
            wanted, found = 0.5 * (sides[0][b] + sides[1][b]), moves[(b, slice(None), slice(None), *place[1:])]
            size = max(np.abs(wanted).max(), np.abs(found).max())
            if size > 0.1 and np.abs(sides[0][b] - sides[1][b]).max() < 0.1 * size:
                errors.append(np.abs(found - wanted).max() / size)
    assert len(errors) >= 5 and np.median(errors) < 0.02 and np.quantile(errors, 0.9) < 0.05


def test_what_is_pulled_to_an_anchor_moves_as_when_solved_anew():
    """A box near a bed against the energy and a pull, by gradient descent with a bed of either length."""
    problem = sw.compile(scene([BED, BOX], [relation("near", "box", "bed", max=0.3)]), device="cpu")
    anchor = np.array([[[2.0, 2.0, 0.0, 0.1], [4.3, 2.2, 0.0, 0.3]]], dtype=np.float32)
    pull = 1.0

    def solved(at: sw.Problem, start: np.ndarray, steps: int) -> np.ndarray:
        x = start.astype(np.float64)
        for _ in range(steps):
            gradient = at.energy_and_grad(x.astype(np.float32))[1] + pull * (x - anchor)
            x -= 0.02 * gradient * problem.free
        return x

    here = solved(problem, anchor, 600).astype(np.float32)
    values = problem.parameters.values["size"]
    moves = problem.sensitivity(here, of="size", objective="energy", pull=pull)["size"][0]
    up, down = values.copy(), values.copy()
    up[0, 0, 0] += 0.01
    down[0, 0, 0] -= 0.01
    longer, shorter = (solved(problem.at({"size": v}), here, 400) for v in (up, down))
    wanted = (longer - shorter)[0] / 0.02
    assert np.abs(wanted).max() > 0.05
    np.testing.assert_allclose(moves[:, :, 0, 0], wanted, atol=0.05 * np.abs(wanted).max())


def test_what_touches_a_wall_goes_with_it():
    """Without an anchor contacts are kept: a corner's wall moves out by a metre, and what stands at it does."""
    problem = sw.compile(scene([BOX], [relation("against_wall", "box", "wall:1")]), device="cpu")
    solved = problem.project(np.array([[[4.6, 2.0, 0.0, np.pi]]], dtype=np.float32))
    moves = problem.sensitivity(solved, of="outline")["outline"][0, 0, 0]
    np.testing.assert_allclose(moves[1, 0] + moves[2, 0], 1.0, atol=0.02)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda p: p.at({"colour": 1.0}), "parameters: no kind 'colour'"),
        (lambda p: p.at({"size": np.zeros(5)}), r"parameters: size is not an array of numbers of shape \[1, 7, 3\]"),
        (lambda p: p.at({"size": -1.0}), r"parameters: size\[0, 0, 0\] is -1"),
        (lambda p: p.at({"outline": 0.0}), "outline"),
        (lambda p: p.parameter_gradient(p.home, of="colour"), "of: no kind of parameters 'colour'"),
        (lambda p: p.sensitivity(p.home, of="size", objective="luck"), "objective: 'luck'"),
        (lambda p: p.surfaces[0].parameters, "parameters: this problem is that of a surface"),
        (lambda p: p.hessian_product(p.home, np.zeros((2, 7, 4))), "along: an array of shape"),
    ],
)
def test_bad_input_says_what_is_wrong(call, text):
    with pytest.raises(sw.InputError, match=text) as found:
        call(mixed())
    assert "\n" not in str(found.value)


def test_values_make_the_scene_that_they_are_of():
    problem = mixed()
    values = problem.parameters.values
    sizes, walls, openings = values["size"].copy(), values["outline"].copy(), values["opening"].copy()
    sizes[0, 1], walls[0, 1:3, 0], openings[0, 0, 1] = (0.7, 0.8, 0.9), 5.5, 1.0
    made = problem.at({"size": sizes, "outline": walls, "opening": openings, "weight": values["weight"] * 2}).scenes[0]
    assert made.objects[1].size == (0.7, 0.8, 0.9) and made.room.outline[1] == (5.5, 0.0)
    assert made.room.doors[0].width == 1.0 and all(r.weight == 2.0 for r in made.relations)
    assert problem.at({}) is problem and problem.at(values) is problem
