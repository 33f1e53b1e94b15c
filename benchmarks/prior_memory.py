"""Does the prior repeat what it was trained on? Distances of layouts of unseen rooms to training layouts of their kind.

Compared are layouts that the engine found from its own starts (`sample`), from the prior's (`prior`), and those that
the prior draws (`drawn`), in units of the room (half its longer side). Were the prior to repeat what it was trained on,
its layouts would be nearer to that than those of the engine are.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from benchmarks.console import say
from benchmarks.drafts import draft
from benchmarks.prior_data import all_words, read_parts
from benchmarks.prior_rooms import problems_of_known_kinds
from sceneweaver.layout.engine import refine
from sceneweaver.prior import LayoutPrior
from sceneweaver.prior.tokens import tokens_of
from sceneweaver.scene import Scene

MISSING = 2.0
"""Distance, in units of the room, of an object whose category the other layout lacks."""


def spread(scene: Scene, poses: np.ndarray) -> float | None:
    """How far apart the same object stands in two layouts [B, N, 4], on average [m]; None for a single layout."""
    free = [i for i, o in enumerate(scene.objects) if not o.fixed]
    if len(poses) < 2 or not free:
        return None
    xy = np.asarray(poses, dtype=np.float64)[:, free, :2]
    apart = np.linalg.norm(xy[:, None] - xy[None], axis=-1).mean(axis=-1)
    return float(apart.sum() / (len(xy) * (len(xy) - 1)))


def nearest(
    layout: np.ndarray, categories: np.ndarray, others: np.ndarray, theirs: np.ndarray, there: np.ndarray
) -> float:
    """Distance of a layout [N, 4] to the nearest of others [L, M, 4], in units of the room.

    Of each object the distance to the nearest one of its category, averaged over objects; the other way round as well,
    of both the larger. Rooms are compared in their frames, turned by quarters.
    """
    best = np.inf
    same = (categories[:, None] == theirs[:, None, :]) & there[:, None, :]  # [L, N, M]
    for quarter in range(4):
        c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter]
        turned = np.stack([c * layout[:, 0] - s * layout[:, 1], s * layout[:, 0] + c * layout[:, 1]], axis=-1)
        apart = np.linalg.norm(turned[None, :, None] - others[:, None, :, :2], axis=-1)
        apart = np.where(same, np.minimum(apart, MISSING), MISSING)
        one = apart.min(axis=2).mean(axis=1)
        two = np.where(there, apart.min(axis=1), 0.0).sum(axis=1) / np.maximum(there.sum(axis=1), 1)
        best = min(best, float(np.maximum(one, two).min()))
    return best


def main(arguments: list[str] | None = None) -> int:
    """Measure, and print the table."""
    p = argparse.ArgumentParser(prog="python -m benchmarks prior_memory", description=__doc__)
    p.add_argument("--data", type=Path, required=True, help="the folder of prior_data that the prior was trained on")
    p.add_argument("--count", type=int, default=40, help="held-out rooms")
    p.add_argument("--candidates", type=int, default=16, help="layouts of each that are refined")
    p.add_argument("--each", type=int, default=2, help="layouts of each that are compared")
    p.add_argument("--device", default="cpu")
    asked = p.parse_args(arguments)
    words, data = all_words(), read_parts(asked.data)
    first = np.concatenate([[0], np.cumsum(data["counts"])])
    prior = LayoutPrior.load()
    found: dict[str, list[float]] = {"sample": [], "prior": [], "drawn": []}
    for kind, seed in problems_of_known_kinds(asked.count):
        chosen = np.flatnonzero(data["token.kind"] == words.kind(kind))
        if not len(chosen):
            continue
        made = draft(kind, seed)
        tokens = tokens_of(made.plain, words)
        rows = np.concatenate([np.arange(first[k], first[k + 1]) for k in chosen])
        owner = np.repeat(chosen, data["counts"][chosen])
        theirs = data["token.categories"][owner]
        there = data["token.mask"][owner][:, -theirs.shape[1] :]
        drawn = prior.sample(made.plain, asked.candidates, seed)
        options = {"seed": seed, "device": asked.device, "snap": True, "quality": made.terms, "walk": False}
        layouts = {"drawn": drawn[: asked.each]}
        for name, init in (("sample", "sample"), ("prior", drawn)):
            solution = refine(made.plain, candidates=asked.candidates, init=init, **options)
            layouts[name] = solution.poses[solution.ranked[: asked.each]]
        for name, poses in layouts.items():
            found[name] += [
                nearest(one, tokens.categories, data["poses"][rows], theirs, there) for one in tokens.local(poses)
            ]
    say(f"{'layouts':8} {'count':>6} {'least':>7} {'10 %':>7} {'median':>7}")
    for name, values in found.items():
        if values:
            tenth, middle = np.quantile(values, [0.1, 0.5])
            say(f"{name:8} {len(values):6} {min(values):7.3f} {tenth:7.3f} {middle:7.3f}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
