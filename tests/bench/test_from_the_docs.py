"""Three optimisers written from docs/research.md alone run through `sw.refine` and the harness."""

from __future__ import annotations

import os

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import sceneweaver as sw
import sceneweaver.jax as swj
from sceneweaver.bench import Method, Settings, read_runs, run
from sceneweaver.bench.entries import SceneTask
from tests.layout.made import BOX, CUP, relation, scene, table, thing

ROOM = scene([table(), CUP, BOX, thing("other")], [relation("near", "box", "other", max=0.4)])
DEVICE = os.environ.get("SCENEWEAVER_TEST_DEVICE", "cpu")


@pytest.fixture(autouse=True)
def arrays_where_the_problem_is():
    """JAX's arrays on the device of the problem: where there is a GPU, JAX would take that."""
    with jax.default_device(jax.devices("cpu" if DEVICE == "cpu" else "cuda")[0]):
        yield


class Momentum:
    """Gradient descent with momentum."""

    steps = 120

    def init(self, problem, poses, key):
        x = poses.numpy()
        return problem, x, np.zeros_like(x), x

    def step(self, state):
        problem, x, speed, given = state
        _, gradient = problem.energy_and_grad(x)
        speed = 0.9 * speed - 0.01 * gradient * problem.free[problem.scene_of(len(x))]
        return problem, problem.carry(x + speed, like=given), speed, given

    def best(self, state):
        return state[1]


class CmaEs:
    """CMA-ES of evosax; each layout is the mean of a population."""

    steps = 25

    def init(self, problem, poses, key):
        from evosax.algorithms import CMA_ES

        given = jnp.asarray(poses.numpy())
        start = swj.ravel(problem, given)
        strategy = CMA_ES(16, start[0])
        params = strategy.default_params.replace(std_init=0.3)

        def generation(key, state, like):
            ask, tell = jax.random.split(key)
            found, state = strategy.ask(ask, state, params)
            layouts = jax.vmap(lambda vector: swj.unravel(problem, vector, like))(found)
            return strategy.tell(tell, found, swj.energy(problem, layouts), state, params)[0]

        keys = jax.random.split(jax.random.key(key), len(given))
        states = jax.vmap(lambda key, mean: strategy.init(key, mean, params))(keys, start)
        return problem, given, jax.jit(jax.vmap(generation)), keys, states

    def step(self, state):
        problem, given, generation, keys, states = state
        keys = jax.vmap(lambda key: jax.random.split(key)[0])(keys)
        return problem, given, generation, keys, generation(keys, states, given)

    def best(self, state):
        return swj.unravel(state[0], state[4].best_solution, state[1])


class LevenbergMarquardt:
    """Levenberg-Marquardt of optimistix on the residuals, each layout on its own."""

    steps = 3

    def init(self, problem, poses, key):
        import optimistix

        def solve(given, vector):
            def residuals(vector, _):
                return swj.residuals(problem, swj.unravel(problem, vector, given))

            solver = optimistix.LevenbergMarquardt(rtol=1e-4, atol=1e-5)
            return optimistix.least_squares(residuals, solver, vector, max_steps=15, throw=False).value

        given = jnp.asarray(poses.numpy())
        return problem, given, jax.jit(jax.vmap(solve)), swj.ravel(problem, given)

    def step(self, state):
        problem, given, solve, vector = state
        return problem, given, solve, solve(given, vector)

    def best(self, state):
        problem, given, _, vector = state
        return swj.unravel(problem, vector, given)


@pytest.mark.parametrize(
    ("library", "optimizer", "least"),
    [
        ("numpy", Momentum, 0.5),
        pytest.param("evosax", CmaEs, 0.25, marks=pytest.mark.slow),  # long to compile
        pytest.param("optimistix", LevenbergMarquardt, 0.25, marks=pytest.mark.slow),  # the same
    ],
)
def test_it_runs_through_refine_and_the_harness(tmp_path, library, optimizer, least):
    pytest.importorskip(library)
    given = SceneTask(ROOM, "room").start("random", 8, 1)
    before = sw.compile(ROOM, device=DEVICE).energy(given)
    solution = sw.refine(ROOM, init=given, optimizer=optimizer(), device=DEVICE, explain=False)
    assert np.median(solution.energy) < 0.5 * np.median(before) and (solution.status == 0).mean() >= least
    assert sw.check(solution.best, walkable=False).valid
    settings = Settings(candidates=8, seconds=60.0, restarts=False, start="random", device=DEVICE)
    method = Method(library, optimizer())
    (found,) = read_runs(run([method], [ROOM], tmp_path, seeds=[1], settings=settings))
    assert found.last("outcome") == "ended" and found.last("steps") == optimizer.steps
    assert found.last("valid") >= least and found.last("median_energy") < found["median_energy"][0]
    assert found.last("evaluations") >= 8 * optimizer.steps
