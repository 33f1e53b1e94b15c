"""Running the kernels on layouts, and layouts to run them on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import warp as wp

from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.kernels.cells import CELLS, CROWD, fill_cells
from sceneweaver.kernels.evaluator import evaluate
from sceneweaver.kernels.step import choose
from sceneweaver.kernels.tables import Problems, State
from sceneweaver.layout.batch import make_batch
from sceneweaver.layout.compile import CompiledScene, LayoutProblem, compile_scene
from sceneweaver.layout.pack import weights as make_weights
from sceneweaver.optimizers.batch import Batch, load_poses
from sceneweaver.optimizers.descent import threads
from sceneweaver.optimizers.verdict import Verdict, judge
from sceneweaver.scene import Scene

ZOO = Path(__file__).parents[1] / "zoo"
ROOMS = tuple(sorted(p.stem for p in ZOO.glob("*.json")))
USUAL = ("bedroom-small", "dining-round", "living-dining-L", "lockers-wall-full", "restaurant-dense", "studio-U")
"""Rooms of the usual run: every shape, what is round, what is full, and a crowd."""
LARGE = ("hall-300", "library-100", "restaurant-60", "restaurant-dense")


@cache
def zoo(name: str) -> CompiledScene:
    """A compiled zoo room."""
    return compile_scene(Scene.load(ZOO / f"{name}.json"))


@dataclass
class Energies:
    """What ``evaluate`` gives: shares [B, N], soft parts [B, N] and gradients [B, N, 4], as float64."""

    share: np.ndarray
    soft: np.ndarray
    gradient: np.ndarray

    @property
    def total(self) -> np.ndarray:
        return self.share.sum(axis=1)


def batch_of(
    problems: Sequence[LayoutProblem],
    which: Sequence[int],
    layouts: Sequence[np.ndarray],
    device: str,
    options: Sequence[np.ndarray] | None = None,
    anchors: Sequence[np.ndarray] | None = None,
    weights: Mapping[str, float] | None = None,
) -> Batch:
    """A batch of layouts [n, 4], each of the problem that ``which`` says; options number from 0 for each relation.

    All pairs are looked at; ``use_cells`` makes it look at those nearby only.
    """
    batch = replace(make_batch(problems, np.asarray(which), device), weights=make_weights(**(weights or {})))
    _set_cells(batch, 1)
    shape = (batch.size, max(batch.objects, 1), 4)
    load_poses(batch, _padded(layouts, shape))
    if anchors is not None:
        batch.state.anchors.assign(_padded(anchors, shape))
    if options is not None:
        first, start = batch.keep.option_start.numpy(), batch.keep.relation_start.numpy()
        chosen = np.zeros(batch.state.options.shape, dtype=np.int32)
        for c, p in enumerate(which):
            chosen[c, : len(options[c])] = first[start[p] : start[p + 1]] + options[c]
        batch.state.options.assign(chosen)
    return batch


def _padded(layouts: Sequence[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    padded = np.zeros(shape, dtype=np.float32)
    for c, layout in enumerate(layouts):
        padded[c, : len(layout)] = layout
    return padded


def _set_cells(batch: Batch, cells: int) -> None:
    """Cells of a new state; one cell means none."""
    state, shape = batch.state, (batch.size, max(batch.objects, 1) if cells > 1 else 1)
    state.cell_head = wp.full((batch.size, cells), -1, dtype=wp.int32, device=batch.device)
    state.cell_next = wp.full(shape, -1, dtype=wp.int32, device=batch.device)
    state.cell_of = wp.zeros(shape, dtype=wp.int32, device=batch.device)


@wp.kernel(enable_backward=False)
def _fill(b: Problems, s: State):
    candidate = wp.tid()
    fill_cells(b.tables, b.problem[candidate], candidate, s)


def use_cells(batch: Batch) -> Batch:
    """Let a batch of a crowd look at pairs nearby only, as the search does."""
    assert batch.objects > CROWD
    _set_cells(batch, int(CELLS))
    wp.launch(_fill, batch.size, [batch.problems, batch.state], device=batch.device)
    return batch


def best_options(batch: Batch) -> None:
    """Give every relation of every candidate its best option."""
    other = batch.scratch().options
    inputs = [batch.problems, batch.state]
    wp.launch(choose, threads(batch, batch.relations), inputs, [batch.state.options, other], device=batch.device)


def run_energy(batch: Batch) -> Energies:
    """Energy of every candidate; the outputs hold garbage beforehand, as they may in use."""
    shape = (batch.size, max(batch.objects, 1))
    share = wp.full(shape, float("nan"), dtype=wp.float32, device=batch.device)
    soft = wp.full(shape, float("nan"), dtype=wp.float32, device=batch.device)
    gradient = wp.full(shape, wp.vec4(float("nan")), dtype=wp.vec4, device=batch.device)
    inputs = [batch.problems, batch.state]
    wp.launch(evaluate, (batch.size, batch.objects), inputs, [share, soft, gradient], device=batch.device)
    return Energies(*(a.numpy().astype(np.float64) for a in (share, soft, gradient)))


def energies(problem: LayoutProblem, layouts: np.ndarray, device: str, **more) -> Energies:
    """Energy of layouts [B, N, 4] of one problem."""
    return run_energy(batch_of([problem], [0] * len(layouts), layouts, device, **more))


def verdict(problem: LayoutProblem, layouts: np.ndarray, device: str) -> Verdict:
    """Verdict on layouts [B, N, 4] of one problem."""
    return judge(batch_of([problem], [0] * len(layouts), layouts, device))


# ---- layouts


def as_float32(layouts: np.ndarray) -> np.ndarray:
    """The nearest layouts that a device can hold, as float64."""
    return np.asarray(layouts, dtype=np.float32).astype(np.float64)


def noisy(problem: LayoutProblem, rng: np.random.Generator, scale: float, rigid: bool = False) -> np.ndarray:
    """The scene's own layout, disturbed: metres in the plane, twice that in radians, half in height.

    ``rigid`` moves what is carried along with its supporter, and heights only where they are free.
    """
    noise = rng.normal(size=(problem.size, 4)) * scale * (1.0, 1.0, 0.5, 2.0)
    if not rigid:
        return as_float32(problem.home + noise)
    noise[:, 2] *= (problem.free & 4) > 0
    moved = problem.home + noise
    local = relative(problem.home, problem.home[problem.roots])
    carried = absolute(local, moved[problem.roots])
    return as_float32(np.where((problem.roots == np.arange(problem.size))[:, None], moved, carried))


def scattered(problem: LayoutProblem, rng: np.random.Generator) -> np.ndarray:
    """Poses anywhere in the room and a little outside, any yaw, heights a little off."""
    x0, y0, x1, y1 = problem.region.box
    layout = problem.home.copy()
    layout[:, 0] = rng.uniform(x0 - 0.2, x1 + 0.2, problem.size)
    layout[:, 1] = rng.uniform(y0 - 0.2, y1 + 0.2, problem.size)
    layout[:, 2] += rng.normal(0.0, 0.03, problem.size)
    layout[:, 3] = rng.uniform(-np.pi, np.pi, problem.size)
    return as_float32(layout)


def any_options(problem: LayoutProblem, rng: np.random.Generator) -> np.ndarray:
    """A random option for every relation."""
    return np.array([rng.integers(len(r.options)) for r in problem.relations], dtype=np.int64)
