"""Rows of a projection: their gradients, and that they miss nothing that the verdict looks at."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels.inequality import CONTENT, ROWS, SLACK
from sceneweaver.kernels.linearise import linearise
from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.optimizers.base import Monitor
from sceneweaver.optimizers.batch import Batch
from sceneweaver.optimizers.projection import new_system
from sceneweaver.optimizers.verdict import judge
from tests.kernels.harness import as_float32, batch_of, best_options, noisy, zoo

MARGIN = 1e-4  # [m] by which the rows may be stricter than the verdict


@dataclass
class Rows:
    """Rows of one candidate by key: gradient for each root [N, 4] and what is missing [m]; what its objects miss."""

    gradient: dict[tuple[int, int], np.ndarray]
    want: dict[tuple[int, int], float]
    missed: np.ndarray


def gather(batch: Batch) -> list[Rows]:
    """Rows of every candidate at its poses, which count as its anchors."""
    system, _best = new_system(batch, Monitor(batch.size))
    system.live.fill_(1)
    selected = wp.array(np.arange(batch.size, dtype=np.int32), dtype=wp.int32, device=batch.device)
    best_options(batch)
    inputs = [batch.problems, selected, batch.state]
    wp.launch(linearise, (batch.size, batch.objects), inputs, [system], device=batch.device)
    rows, keys, count, missed = (a.numpy() for a in (system.rows, system.keys, system.count, system.missed))
    found = []
    for c in range(batch.size):
        one = Rows({}, {}, missed[c].astype(np.float64))
        for obj in range(batch.objects):
            for slot in range(obj * int(ROWS), obj * int(ROWS) + count[c, obj]):
                row, key = rows[c, slot], (obj, int(keys[c, slot]))
                g = np.zeros((batch.objects, 4))
                for body, part in zip(row["body"], row["jacobian"], strict=True):
                    if body >= 0:
                        g[body] += part
                one.gradient[key], one.want[key] = g, float(row["goal"])
        found.append(one)
    return found


def moved(problem: LayoutProblem, layout: np.ndarray, root: int, d: np.ndarray) -> np.ndarray:
    """A layout with a root, and what it carries, moved by d."""
    out = layout.copy()
    c, s = np.cos(d[3]), np.sin(d[3])
    for i in np.flatnonzero(problem.roots == root):
        x, y = layout[i, :2] - layout[root, :2]
        out[i, :2] = layout[root, :2] + d[:2] + (c * x - s * y, s * x + c * y)
        out[i, 2:] += d[2:]
    return out


@pytest.mark.parametrize("name", ["living-dining-L", "bedroom-small", "office-20", "dining-round"])
def test_gradients_are_those_of_the_clearance(name, device):
    """What a violated row wants falls by J . d when a root moves by d."""
    problem, step = zoo(name).room, 1e-3
    layout = noisy(problem, np.random.default_rng(5), 0.1, rigid=True)
    roots = [r for r in range(problem.size) if problem.roots[r] == r and problem.free[r]]
    layouts, ways = [layout], []
    for root in roots:
        for axis in (0, 1, 3):
            d = np.zeros(4)
            d[axis] = step
            ways.append((root, axis))
            layouts += [moved(problem, layout, root, d), moved(problem, layout, root, -d)]
    found = gather(batch_of([problem], [0] * len(layouts), layouts, device))
    base, compared, off = found[0], 0, []
    for k, (root, axis) in enumerate(ways):
        up, down = found[1 + 2 * k], found[2 + 2 * k]
        for key, g in base.gradient.items():
            violated = all(key in f.want and f.want[key] > SLACK - CONTENT + 2 * step for f in (up, down, base))
            if violated and abs(g[root, axis]) > 1e-3:
                slope = (down.want[key] - up.want[key]) / (2 * step)
                compared += 1
                off.append(abs(slope - g[root, axis]) > 0.02 * (1.0 + abs(g[root, axis])))
    assert compared > 25
    assert np.mean(off) < 0.02, "but for the kinks of a few features"


@pytest.mark.parametrize("scale", [0.0, 0.003, 0.02, 0.2])
@pytest.mark.parametrize("name", ["living-dining-L", "bedroom-small", "studio-U", "office-20", "children-twin"])
def test_what_misses_nothing_is_valid(name, scale, device):
    problem, rng = zoo(name).room, np.random.default_rng(11)
    layouts = [noisy(problem, rng, scale * rng.uniform(), rigid=True) for _ in range(24)]
    batch = batch_of([problem], [0] * len(layouts), layouts, device)
    lack = np.array([rows.missed.sum() for rows in gather(batch)])
    status = judge(batch).status
    assert (status[lack == 0] == 0).all()
    assert (lack[status == 0] <= MARGIN * problem.size).all()
    assert scale > 0 or (status == 0).all()


def test_no_object_has_more_rows_than_slots(device):
    problem = zoo("restaurant-dense").room
    pile = np.repeat(as_float32(problem.home)[None], 2, axis=0)
    pile[1, :, :2] = pile[0, 0, :2]  # everything in one place
    batch = batch_of([problem], [0, 0], pile, device)
    found = gather(batch)
    assert found[1].missed.sum() > 1.0
    assert max(sum(key[0] == obj for key in found[1].want) for obj in range(problem.size)) <= int(ROWS)
