"""Better layouts out of good ones: groups of valid layouts recombined, mended and rated, generation by generation."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.scene import InputError

from . import engine
from .compile import LayoutProblem, compile_scene
from .quality import QualityTerm
from .rate import walked
from .solution import Solution, best_of_each_signature, joined

PARENTS = 16
"""Layouts that children come from: the best of each signature first."""

LEAD = 4.0
"""Mean rank among the parents that a child's first parent is drawn with."""

MORE = 0.4
"""Groups of a child that are changed besides the one that always is, on average."""

SLIDE = 0.3
"""Standard deviation [m] of the way that a group slides along its back."""


def improve(
    solution: Solution,
    quality: Sequence[QualityTerm],
    *,
    candidates: int = 64,
    generations: int = 4,
    steps: int | None = None,
    time_limit: float | None = None,
    snap: bool = False,
) -> Solution:
    """A solution with more candidates, made out of its best.

    A child is a good layout of which one or a few groups (a bed with its nightstands) stand as in another layout, or
    slid along their back. What then overlaps is mended by the search from there, which costs a small part of a layout
    drawn anew. Each generation draws from all before it.

    Args:
        solution: what to begin with; without a valid candidate nothing is done.
        quality: the terms that it was rated by.
        candidates: children of a generation.
        generations: how often.
        steps, time_limit, snap: as for `refine`; the time is for all generations together.

    Raises:
        InputError: the solution was not rated, or keeps to given poses (``init="current"``).

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> near = sw.QualityTerm("gap", ("armchair", "floor-lamp"), high=0.3)
        >>> first = sw.refine(scene, candidates=8, quality=[near], device="cpu")
        >>> better = sw.improve(first, [near], candidates=4, generations=1)
        >>> better.candidates > first.candidates, better.quality.shape == better.status.shape
        (True, True)
    """
    if solution.quality is None or solution.moved is not None:
        raise InputError('improve: takes a solution that was refined with quality terms, not with init="current"')
    began = time.monotonic()
    compiled = compile_scene(solution.source)
    room = compiled.room
    groups = [group for group, parent in zip(room.groups, room.parents, strict=True) if group and parent < 0]
    groups = [group for group in groups if room.free[group[0]]]
    # Walkable floor is measured at the end: candidates for which it is known would else be the only parents.
    solution = replace(solution, walkable=np.full(solution.candidates, np.nan, dtype=np.float32))
    rng = np.random.default_rng([solution.seed, candidates])
    for generation in range(generations if groups else 0):
        left = None if time_limit is None else time_limit - (time.monotonic() - began)
        if not len(solution.ranked) or (left is not None and left <= 0):
            break
        children = engine.refine(
            solution.source,
            init=_children(solution, room, groups, candidates, rng),
            seed=(solution.seed + generation + 1) % 2**32,
            device=solution.device,
            steps=steps,
            time_limit=left,
            snap=snap,
            quality=quality,
            compiled=compiled,
            walk=False,
        )
        solution = joined(solution, children)
    return walked(solution, compiled)


def _children(
    solution: Solution, room: LayoutProblem, groups: Sequence[Sequence[int]], count: int, rng: np.random.Generator
) -> np.ndarray:
    """Poses [count, N, 4] to mend, of all bodies."""
    parents = best_of_each_signature(solution)
    parents = np.concatenate([parents, solution.ranked[~np.isin(solution.ranked, parents)]])[:PARENTS]
    ranks = np.minimum(rng.exponential(LEAD, count).astype(int), len(parents) - 1)
    bodies = solution.bodies
    children = bodies[parents[ranks]].astype(np.float64)
    always = rng.integers(len(groups), size=count)  # of each child one group, now and then more
    for number, members in enumerate(groups):
        group = np.array(members)
        changed = (always == number) | (rng.random(count) < MORE / len(groups))
        # As in another parent; as in any candidate, since a group may stand well where others do not; or aside.
        how, step = rng.integers(3, size=count), SLIDE * rng.normal(size=(count, 1, 1))
        for move, donors in ((0, rng.choice(parents, size=count)), (1, rng.integers(solution.candidates, size=count))):
            rows = np.flatnonzero(changed & (how == move))
            children[rows[:, None], group] = bodies[donors[rows][:, None], group]
        rows = np.flatnonzero(changed & (how == 2))
        yaw = children[rows, group[0], 3]
        aside = np.stack([-np.sin(yaw), np.cos(yaw)], axis=-1)
        children[rows[:, None], group, :2] += step[rows] * aside[:, None]
    return np.where(np.isfinite(children), children, room.home)
