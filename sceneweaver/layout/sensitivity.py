"""How a solved layout moves when a parameter or its anchor moves: the implicit function theorem.

A projection x of an anchor a is the least movement (x - a) W (x - a) / 2 with clearances c(x, p) >= 0. Where rows under
force stay so, x and the forces f solve

    W (x - a) - f . dc/dx = 0,    c(x, p) = 0 for the rows under force,

and the derivative of x by p and a is that of this system. Its matrix has the curvature of the rows, which counts: a
long body that turns away from a wall. A layout of least energy with a pull to an anchor solves dE/dx + pull (x - a) = 0
instead, whose matrix is the energy's Hessian. Derivatives of rows and of gradients are differences of the kernels' own,
those by parameters of problems that are compiled anew.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError

from .active_rows import NEAR, Rows, batch_for, movement_weights, rows_of
from .parameters import WEIGHTS, Slot

Problem = Any  # its module imports this one, so it cannot be named here

MOVE = 1.0e-3
"""[m, rad] by which poses go for differences of rows."""

CHANGE = 1.0e-3
"""[m] by which a parameter goes; of angles degrees, a hundred times as many."""

LEAST_FORCE = 1.0e-4
"""[m] of movement from which on a row counts as under force."""

SINGULAR = 1.0e-5
"""Share of the largest singular value below which a direction counts as free."""

Objective = Literal["projection", "energy"]


@dataclass
class Stationary:
    """What holds at a solved layout: an equation F(x, f; p, a) = 0 for free coordinates [D] and forces [R]."""

    problem: Problem
    poses: np.ndarray  # [N, 4]
    scene: int
    free: np.ndarray  # [N, 4] bool
    force: np.ndarray  # [R]
    keys: list[tuple[int, int]]
    options: np.ndarray
    matrix: np.ndarray  # [D + R, D + R]: dF by (x, f)
    anchor: np.ndarray  # [D]: minus dF by the anchor, a diagonal

    @cached_property
    def inverse(self) -> np.ndarray:
        """Of the matrix; where several movements will do, the least one."""
        import scipy.linalg

        return np.asarray(scipy.linalg.pinv(self.matrix, rtol=SINGULAR))

    def moves(self, right: np.ndarray) -> np.ndarray:
        """The movements [K, N, 4] that keep F where it is, by changes ``right`` [D + R, K] of it."""
        return (
            np.stack([self.whole(v) for v in -(self.inverse @ right)[: self.anchor.size].T])
            if right.size
            else (np.zeros((right.shape[1], *self.free.shape)))
        )

    def whole(self, vector: np.ndarray) -> np.ndarray:
        """A movement [N, 4] of all objects, from that of the free coordinates [D]: what is carried goes along."""
        moved = np.zeros(self.free.shape)
        moved[self.free] = vector
        return along_with_roots(moved, self.poses, self.problem.roots[self.scene])

    def pulled(self, up: np.ndarray) -> np.ndarray:
        """What a cost of movements ``up`` [N, 4] is by free coordinates and forces [D + R], through the equation."""
        on_roots = onto_roots(up, self.poses, self.problem.roots[self.scene])
        return -(self.inverse.T @ np.concatenate([on_roots[self.free], np.zeros(self.force.size)]))


def along_with_roots(moved: np.ndarray, poses: np.ndarray, roots: np.ndarray) -> np.ndarray:
    """The movement [N, 4] of all objects where roots move so: rigid, to first order."""
    arm = (poses - poses[roots]).astype(np.float64)
    found = moved[roots].astype(np.float64)
    found[:, 0] -= found[:, 3] * arm[:, 1]
    found[:, 1] += found[:, 3] * arm[:, 0]
    return found


def onto_roots(gradient: np.ndarray, poses: np.ndarray, roots: np.ndarray) -> np.ndarray:
    """A gradient [N, 4] by every object's own pose as one by those of roots: `along_with_roots` turned round."""
    arm = (poses - poses[roots]).astype(np.float64)
    pull = gradient.astype(np.float64)
    pull[:, 3] += pull[:, 1] * arm[:, 0] - pull[:, 0] * arm[:, 1]
    found = np.zeros_like(pull)
    np.add.at(found, roots, pull)
    return found


def stationary_projection(problem: Problem, poses: np.ndarray, anchor: np.ndarray | None, scene: int) -> Stationary:
    """The equation of a projected layout [N, 4].

    Without an anchor all that is active stays at its limit, by the least movement.
    """
    which = np.array([scene], dtype=np.int32)
    batch = batch_for(problem, poses[None], which)
    options = np.array(batch.state.options.numpy())
    free = np.asarray(problem.free[scene])
    rows = rows_of(problem, poses[None], which, options)[0]
    near = np.flatnonzero(rows.clearance < NEAR)
    slope = rows.slope[near][:, free]
    weight = movement_weights(problem.objects)[free]
    force = np.zeros(near.size)
    if anchor is not None:
        import scipy.optimize

        moved = (poses - anchor).astype(np.float64)
        moved[:, 3] -= 2 * np.pi * np.round(moved[:, 3] / (2 * np.pi))
        root = np.sqrt(weight)
        force = scipy.optimize.nnls((slope / root).T, root * moved[free])[0] if near.size else force
        kept = force > LEAST_FORCE
        near, slope, force = near[kept], slope[kept], force[kept]
    keys = [rows.keys[i] for i in near]
    bend = np.diag(weight)
    if force.size:
        bend = bend - _curvature(problem, poses, scene, free, options, keys, force)
    matrix = np.block([[bend, -slope.T], [slope, np.zeros((near.size, near.size))]])
    return Stationary(problem, poses, scene, free, force, keys, options, matrix, weight)


def stationary_energy(problem: Problem, poses: np.ndarray, pull: float, scene: int) -> Stationary:
    """The equation of a layout [N, 4] of least energy and pull to an anchor."""
    free = np.asarray(problem.free[scene])
    size = int(free.sum())
    moves = np.zeros((size, *poses.shape), dtype=np.float32)
    moves[np.arange(size), *np.nonzero(free)] = 1.0
    roots = problem.roots[scene]
    moves = np.array([along_with_roots(np.asarray(m), poses, roots) for m in moves], dtype=np.float32).reshape(
        moves.shape
    )
    which = np.full(size, scene, dtype=np.int32)
    product = problem.hessian_product(np.repeat(poses[None], size, axis=0), moves, which)
    hessian = np.einsum("inc,jnc->ij", product.astype(np.float64), moves.astype(np.float64))
    weight = np.full(size, pull)
    matrix = 0.5 * (hessian + hessian.T) + np.diag(weight)
    return Stationary(problem, poses, scene, free, np.zeros(0), [], np.zeros((1, 0), dtype=np.int32), matrix, weight)


def _curvature(
    problem: Problem,
    poses: np.ndarray,
    scene: int,
    free: np.ndarray,
    options: np.ndarray,
    keys: list[tuple[int, int]],
    force: np.ndarray,
) -> np.ndarray:
    """The sum [D, D] of the rows' second derivatives by their forces; rows that change on the way count as straight."""
    size = int(free.sum())
    steps = np.zeros((size, *poses.shape), dtype=np.float32)
    steps[np.arange(size), *np.nonzero(free)] = MOVE
    moved = np.array([along_with_roots(np.asarray(m), poses, problem.roots[scene]) for m in steps], dtype=np.float32)
    both = np.concatenate([poses + moved, poses - moved])
    which = np.full(2 * size, scene, dtype=np.int32)
    found = [r.matched(keys)[1][:, free] for r in rows_of(problem, both, which, np.repeat(options, 2 * size, axis=0))]
    ahead, behind = np.stack(found[:size]), np.stack(found[size:])
    bend = np.nan_to_num((ahead - behind) / (2 * MOVE))  # [coordinate, row, coordinate]
    whole = np.einsum("irj,r->ij", bend, force)
    return 0.5 * (whole + whole.T)


def right_side(equation: Stationary, slots: list[Slot], objective: Objective) -> np.ndarray:
    """dF [D + R, P] by some parameters; NaN where rows change with them."""
    columns = [_by_parameter(equation, slot, objective) for slot in slots]
    return np.stack(columns, axis=1) if columns else np.zeros((equation.matrix.shape[0], 0))


def _by_parameter(equation: Stationary, slot: Slot, objective: Objective) -> np.ndarray:
    checkpoint()
    if objective == "projection" and slot.kind in WEIGHTS:  # rows do not look at weights
        return np.zeros(equation.matrix.shape[0])
    step = CHANGE * (100.0 if slot.label.endswith("degrees") else 1.0)
    ahead, behind = _side(equation, slot, step, objective), _side(equation, slot, -step, objective)
    whole = (ahead - behind) / (2 * step)
    if np.isnan(whole).any():  # a row, or a room, that is there to one side only
        here = _values(equation, equation.problem, objective)
        for side in ((ahead - here) / step, (here - behind) / step):
            whole = np.where(np.isnan(whole), side, whole)
    return whole


def _side(equation: Stationary, slot: Slot, step: float, objective: Objective) -> np.ndarray:
    problem = equation.problem
    values = problem.parameters.values[slot.kind].copy()
    values[(equation.scene, *slot.index)] += step
    try:
        return _values(equation, problem.at({slot.kind: values}), objective)
    except InputError:
        return np.full(equation.matrix.shape[0], np.nan)


def _values(equation: Stationary, problem: Problem, objective: Objective) -> np.ndarray:
    """F less what does not depend on parameters: [D + R]."""
    which = np.array([equation.scene], dtype=np.int32)
    poses, free = equation.poses, equation.free
    if objective == "energy":
        gradient = problem.energy_and_grad(poses[None], which)[1][0]
        return onto_roots(gradient, poses, problem.roots[equation.scene])[free]
    rows: Rows = rows_of(problem, poses[None], which, equation.options)[0]
    clearance, slope = rows.matched(equation.keys)
    return np.concatenate([-np.einsum("r,rd->d", equation.force, slope[:, free]), clearance])
