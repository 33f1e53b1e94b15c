"""A problem as a function of poses and parameters, for JAX and PyTorch: parameters as an array, layouts in groups.

Values are [B, F] of some kinds of parameters, laid out as `Parameters.values` one kind after the other. Layouts with
equal values are measured together, by the problem that is compiled for them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import warp as wp

from .parameters import KINDS
from .sensitivity import right_side

if TYPE_CHECKING:
    from .problem import Problem


def kinds_from(bits: int) -> tuple[str, ...]:
    """Kinds of parameters by the bits of a number, as calls of other libraries carry numbers alone."""
    return tuple(kind for i, kind in enumerate(KINDS) if bits >> i & 1)


def bits_of(kinds: Sequence[str]) -> int:
    """The number of some kinds of parameters."""
    return sum(1 << KINDS.index(kind) for kind in kinds)


@dataclass(frozen=True)
class Group:
    """Layouts with equal parameters: their rows [K], their problem, and where their parameters are [K, P] in values."""

    rows: np.ndarray
    problem: Problem
    columns: np.ndarray
    size: int

    def spread(self, slopes: np.ndarray) -> np.ndarray:
        """Slopes [K, P] by the parameters of a scene as slopes [K, F] by values."""
        whole = np.zeros((len(slopes), self.size + 1), dtype=slopes.dtype)
        np.put_along_axis(whole, self.columns, slopes, axis=1)
        return whole[:, : self.size]

    def taken(self, values: np.ndarray) -> np.ndarray:
        """What belongs to the parameters of a scene [K, P] of values [K, F]."""
        padded = np.concatenate([values, np.zeros((len(values), 1), dtype=values.dtype)], axis=1)
        return np.ascontiguousarray(np.take_along_axis(padded, self.columns, axis=1))


def groups(problem: Problem, values: np.ndarray, which: np.ndarray, kinds: Sequence[str]) -> Iterator[Group]:
    """Layouts by their values [B, F]."""
    parameters = problem.parameters
    places = parameters.unflat(np.arange(parameters.flat.size))
    where = np.concatenate([places[kind].ravel() for kind in kinds])
    now = parameters.flat
    column = np.full(now.size + 1, where.size, dtype=np.int64)
    column[where] = np.arange(where.size)
    columns = column[problem.slots]
    # a float32 of what a scene says is that number
    given = np.where(values == now[where].astype(np.float32), now[where], values.astype(np.float64))
    different, group = np.unique(given, axis=0, return_inverse=True)
    for g, each in enumerate(different):
        flat = now.copy()
        flat[where] = each
        names = {kind: parameters.unflat(flat)[kind] for kind in kinds}
        rows = np.flatnonzero(group.reshape(-1) == g)
        yield Group(rows, problem.at(names), columns[which[rows]], where.size)


class Functional:
    """Measurements of layouts [B, N, 4] of scenes [B] at values [B, F] of some kinds of parameters; NumPy float32."""

    def __init__(self, problem: Problem, kinds: Sequence[str]) -> None:
        """Of a problem, with its parameters of some kinds."""
        self.problem, self.kinds = problem, tuple(kinds)

    def energy(self, poses: np.ndarray, which: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, ...]:
        """Energies [B] and their gradients by poses [B, N, 4] and by values [B, F]."""
        energy, gradient, slope = np.zeros(len(poses), np.float32), np.zeros_like(poses), np.zeros_like(values)
        for g in self._groups(values, which):
            energy[g.rows], gradient[g.rows] = g.problem.energy_and_grad(poses[g.rows], which[g.rows])
            if self.kinds:
                slope[g.rows] = self._pulled(g, poses, which, None, 0)
        return energy, gradient, slope

    def residuals(self, poses: np.ndarray, which: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, ...]:
        """Residuals [B, M] and their derivatives [B, M, 3, 4] by the poses of their objects."""
        items = self.problem.items
        residual = np.zeros((len(poses), items), np.float32)
        slope = np.zeros((len(poses), items, 3, 4), np.float32)
        for g in self._groups(values, which):
            residual[g.rows], slope[g.rows] = g.problem.residuals(poses[g.rows], which[g.rows])
        return residual, slope

    def residuals_along(
        self, poses: np.ndarray, which: np.ndarray, values: np.ndarray, along: np.ndarray
    ) -> np.ndarray:
        """The change of residuals [B, M] along one of values [B, F]."""
        found = np.zeros((len(poses), self.problem.items), np.float32)
        for g in self._groups(values, which):
            there, rows = self._on_device(g, poses, which)
            moves = wp.array(g.taken(along[g.rows]).astype(np.float32), dtype=wp.float32, device=g.problem.device)
            found[g.rows] = g.problem.parameter_slopes(there, rows, None, 1, self.kinds, moves).numpy()
        return found

    def residuals_pulled(self, poses: np.ndarray, which: np.ndarray, values: np.ndarray, up: np.ndarray) -> np.ndarray:
        """The gradient [B, F] by values of residuals weighted by ``up`` [B, M]."""
        found = np.zeros_like(values)
        for g in self._groups(values, which):
            found[g.rows] = self._pulled(g, poses, which, up, 1)
        return found

    def projected(self, poses: np.ndarray, which: np.ndarray, values: np.ndarray) -> np.ndarray:
        """The feasible layouts nearest to poses."""
        found = np.zeros_like(poses)
        for g in self._groups(values, which):
            found[g.rows] = g.problem.project(poses[g.rows], which[g.rows])
        return found

    def projection_pulled(
        self, poses: np.ndarray, which: np.ndarray, values: np.ndarray, nearest: np.ndarray, up: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """The gradients by poses [B, N, 4] and values [B, F] of nearest layouts weighted by ``up`` [B, N, 4].

        Those by poses are by coordinates that are free: what is fixed or carried counts as constant.
        """
        by_poses, by_values = np.zeros_like(poses), np.zeros_like(values)
        for g in self._groups(values, which):
            slopes = np.zeros(g.columns.shape, dtype=np.float32)
            for k, b in enumerate(g.rows.tolist()):
                scene, problem = int(which[b]), g.problem
                equation = problem.stationary(nearest[b], poses[b], scene)
                pulled = equation.pulled(up[b])
                by_poses[b][equation.free] = -equation.anchor * pulled[: equation.anchor.size]
                if self.kinds:
                    number, slots = problem.slots_of(scene, self.kinds)
                    slopes[k, number] = pulled @ right_side(equation, slots, "projection")
            by_values[g.rows] = g.spread(slopes)
        return by_poses, by_values

    def _groups(self, values: np.ndarray, which: np.ndarray) -> Iterator[Group]:
        if not self.kinds:
            rows = np.arange(len(which))
            yield Group(rows, self.problem, np.zeros((len(rows), 0), dtype=np.int64), 0)
            return
        yield from groups(self.problem, values, which, self.kinds)

    def _on_device(self, g: Group, poses: np.ndarray, which: np.ndarray) -> tuple[wp.array, wp.array]:
        device = g.problem.device
        there = wp.array(np.ascontiguousarray(poses[g.rows]), dtype=wp.vec4, device=device)
        return there, wp.array(which[g.rows].astype(np.int32), dtype=wp.int32, device=device)

    def _pulled(self, g: Group, poses: np.ndarray, which: np.ndarray, up: np.ndarray | None, roots: int) -> np.ndarray:
        there, rows = self._on_device(g, poses, which)
        device = g.problem.device
        weights = None if up is None else wp.array(np.ascontiguousarray(up[g.rows]), dtype=wp.float32, device=device)
        return g.spread(g.problem.parameter_slopes(there, rows, weights, roots, self.kinds).numpy())


class Joint:
    """Energy [B, 1] or residuals [B, M] of coordinates u [B, U], poses and then values, with products of their
    Jacobian J."""

    def __init__(self, problem: Problem, kinds: Sequence[str], residuals: bool) -> None:
        """Of a problem, with its parameters of some kinds."""
        self.functional, self.of_residuals = Functional(problem, kinds), residuals

    def value(self, u: np.ndarray, which: np.ndarray) -> np.ndarray:
        """The measurement [B, M]."""
        f = self.functional
        return (
            f.residuals(*self._taken(u, which))[0]
            if self.of_residuals
            else f.energy(*self._taken(u, which))[0][:, None]
        )

    def push(self, u: np.ndarray, which: np.ndarray, v: np.ndarray) -> np.ndarray:
        """J v [B, M]."""
        f, (poses, _, values) = self.functional, self._taken(u, which)
        moves, _, along = self._taken(v, which)
        if not self.of_residuals:
            _, gradient, slope = f.energy(poses, which, values)
            return (np.sum(gradient * moves, axis=(1, 2)) + np.sum(slope * along, axis=1))[:, None]
        slope = f.residuals(poses, which, values)[1]
        layout, objects = np.arange(len(u))[:, None, None], np.maximum(f.problem.item_objects[which], 0)
        return np.sum(slope * moves[layout, objects], axis=(2, 3)) + f.residuals_along(poses, which, values, along)

    def pull(self, u: np.ndarray, which: np.ndarray, w: np.ndarray) -> np.ndarray:
        """J^T w [B, U]."""
        f, (poses, _, values) = self.functional, self._taken(u, which)
        if not self.of_residuals:
            _, gradient, slope = f.energy(poses, which, values)
            return w * np.concatenate([gradient.reshape(len(u), -1), slope], axis=1)
        slope = f.residuals(poses, which, values)[1]
        layout, objects = np.arange(len(u))[:, None, None], np.maximum(f.problem.item_objects[which], 0)
        pulled = np.zeros_like(poses)
        np.add.at(pulled, (np.broadcast_to(layout, objects.shape), objects), slope * w[:, :, None, None])
        return np.concatenate([pulled.reshape(len(u), -1), f.residuals_pulled(poses, which, values, w)], axis=1)

    def _taken(self, u: np.ndarray, which: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Poses, scenes and values of coordinates."""
        size = 4 * self.functional.problem.objects
        return np.ascontiguousarray(u[:, :size]).reshape(len(u), -1, 4), which, np.ascontiguousarray(u[:, size:])
