"""Derivatives of a `Problem` by its parameters, and second ones: the methods of `Problem` that are about them."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import load_for
from sceneweaver.kernels.adjoint import in_units, measure_parameter_slopes
from sceneweaver.kernels.slopes import Entries
from sceneweaver.scene import InputError, Scene

from .arrays import Array, poses_from
from .compile import CompiledScene, LayoutProblem, compile_scene
from .differences import difference
from .jacobian import Jacobian, entries_on, jacobian_of, weight_slopes
from .pack import PULL
from .pack import WEIGHTS as WEIGHT
from .parameters import KINDS, WEIGHTS, Parameters, Slot, parameters_of, scene_with, slots_of
from .sensitivity import Objective, Stationary, right_side, stationary_energy, stationary_projection

Problem = Any  # its module imports this one, so it cannot be named here

KEPT = 8
"""Problems at other parameters that a problem keeps."""


class Differentiable:
    """What `Problem` has of parameters and of second derivatives."""

    scenes: tuple[Scene, ...]
    device: str
    _layouts: tuple[LayoutProblem, ...]
    _compiled: tuple[CompiledScene, ...]

    @cached_property
    def parameters(self: Problem) -> Parameters:
        """Sizes, outline, openings, numbers and weights of relations, weights of terms: `Parameters`.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> problem.parameters.values["size"].shape == (1, problem.objects, 3)
            True
        """
        return parameters_of(self._slots, self.objects)

    @cached_property
    def _slots(self: Problem) -> list[list[Slot]]:
        if not self._compiled:
            raise InputError("parameters: this problem is that of a surface; ask the problem of its room")
        return [slots_of(scene) for scene in self.scenes]

    def energy_at(self: Problem, poses: Array, parameters: Mapping[str, Any], which: Array | None = None) -> Any:
        """Energy in metres [B] of layouts at other values of parameters: ``problem.at(parameters).energy(poses)``."""
        return self.at(parameters).energy(poses, which)

    def parameter_gradient(
        self: Problem, poses: Array, which: Array | None = None, *, of: str | Iterable[str] = KINDS
    ) -> dict[str, np.ndarray]:
        """The derivatives of every layout's energy by the parameters of its scene.

        Exact up to kinks, as those by poses are: kernels give derivatives by the compiled tables, the compiler's own
        differences how tables change with parameters. The first call compiles the scene twice for each parameter of
        the kinds that are asked for, but for weights; what it learns is kept.

        Args:
            poses, which: as for `energy`.
            of: one kind of parameters or several, see `Parameters`.

        Returns:
            float32 by kind: "size" [B, N, 3], "outline" [B, V, 2], "opening" [B, D, 2], "relation" [B, Q],
            "weight" [B, R], "term" [B, T]. 0 for what a scene has not; NaN where the compiler has a kink to both sides.

        Raises:
            InputError: no such kind, or as for `energy`.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> poses = problem.sample(0, 4)
            >>> slope = problem.parameter_gradient(poses, of="weight")["weight"]  # [4, R], by relation
            >>> slope.shape, bool((slope >= 0).all())
            ((4, 26), True)
        """
        given, rows = self._read(poses, which)
        kinds = kinds_of(of)
        slopes = self.parameter_slopes(given, rows, None, 0, kinds).numpy()
        return self._by_kind(slopes, np.asarray(rows.numpy()), kinds)

    def hessian_product(self: Problem, poses: Array, along: Array, which: Array | None = None) -> np.ndarray:
        """The energy's Hessian by poses times a movement ``along`` [B, N, 4]: the change [B, N, 4] of the gradient.

        A difference of the engine's gradient over 1 mm and 1 mrad; at a kink that of one side. Two energies a layout.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> poses = problem.sample(0, 2)
            >>> problem.hessian_product(poses, poses * 0 + 1).shape == poses.shape
            True
        """
        x, v, rows = self._moving(poses, along, which)
        twice = np.concatenate([rows, rows])
        here = self.energy_and_grad(x, rows)[1]
        return difference(np, lambda moved: self.energy_and_grad(moved, twice)[1], here, x, v)

    def gauss_newton_product(self: Problem, poses: Array, along: Array, which: Array | None = None) -> np.ndarray:
        """J^T J v / 0.05 m of the residuals' Jacobian J and a movement v, ``along`` [B, N, 4]; [B, N, 4].

        The part of `hessian_product` that is never negative: the energy is the sum of r^2 / 0.1 m. One energy.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> poses = problem.sample(0, 2)
            >>> along = poses * 0 + 1
            >>> bool(((problem.gauss_newton_product(poses, along) * along).sum((1, 2)) >= 0).all())
            True
        """
        x, v, rows = self._moving(poses, along, which)
        slope, objects = self.residuals(x, rows)[1], np.maximum(self.item_objects[rows], 0)
        layout = np.arange(len(x))[:, None, None]
        pushed = np.sum(slope * v[layout, objects], axis=(2, 3)) / WEIGHT["knee"]
        product = np.zeros_like(x)
        np.add.at(product, (np.broadcast_to(layout, objects.shape), objects), slope * pushed[:, :, None, None])
        return product

    def mixed_product(
        self: Problem, poses: Array, along: Array, which: Array | None = None, *, of: str | Iterable[str] = KINDS
    ) -> dict[str, np.ndarray]:
        """The change of `parameter_gradient` along a movement [B, N, 4]: the energy's mixed second derivative times it.

        A difference over 1 mm and 1 mrad, as in `hessian_product`; arguments and result otherwise as those of
        `parameter_gradient`.
        """
        x, v, rows = self._moving(poses, along, which)
        kinds = kinds_of(of)

        def slopes(moved: np.ndarray) -> np.ndarray:
            several = np.tile(rows, len(moved) // len(rows))
            return self.parameter_slopes(*self._read(moved, several), None, 0, kinds).numpy()

        return self._by_kind(difference(np, slopes, slopes(x), x, v), rows, kinds)

    def sensitivity(
        self: Problem,
        poses: Array,
        which: Array | None = None,
        *,
        of: str | Iterable[str],
        anchors: Array | None = None,
        objective: Objective = "projection",
        pull: float = PULL,
    ) -> dict[str, np.ndarray]:
        """How solved layouts move when a parameter moves: their derivatives by the parameters of their scenes.

        Args:
            poses, which: layouts that are solved: projected, or of least energy.
            of: one kind of parameters or several, see `Parameters`.
            anchors: [B, N, 4]: what was projected; the rows under force hold, and what no force acts on stays. Left
                out, all that is active at a layout (contacts, ends of intervals) stays at its limit, by the least
                movement.
            objective: "projection", or "energy": the least of `energy`, and of ``pull`` times half the squared
                distance of coordinates from anchors that need not be given.
            pull: [1/m], 0: none; then what nothing pulls stays.

        Returns:
            float64 by kind, [B, N, 4, ...] with the dimensions of a scene's parameters behind: "size" [B, N, 4, N, 3].
            What is carried moves along. NaN where a row, or the compiler, has a kink to both sides.

        Raises:
            InputError: no such kind or objective, or as for `energy`.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> moves = problem.sensitivity(problem.home, of="outline")["outline"]
            >>> moves.shape == (1, problem.objects, 4, 4, 2)
            True
        """
        if objective not in ("projection", "energy"):
            raise InputError(f'objective: {objective!r}; give "projection" or "energy"')
        given, rows = self._read(poses, which)
        kinds, scenes = kinds_of(of), np.asarray(rows.numpy(), dtype=np.int32)
        near = None if anchors is None else poses_from(anchors, self.objects, self.device).numpy()
        shapes = {kind: self.parameters.values[kind].shape[1:] for kind in kinds}
        found = {kind: np.zeros((len(scenes), self.objects, 4, *shape)) for kind, shape in shapes.items()}
        for b, (layout, scene) in enumerate(zip(given.numpy(), scenes.tolist(), strict=True)):
            equation = self.stationary(layout, None if near is None else near[b], scene, objective, pull)
            _, slots = self.slots_of(scene, kinds)
            moved = equation.moves(right_side(equation, slots, objective))
            for slot, move in zip(slots, moved, strict=True):
                found[slot.kind][(b, slice(None), slice(None), *slot.index)] = move
        return found

    def stationary(
        self: Problem,
        poses: np.ndarray,
        anchor: np.ndarray | None,
        scene: int,
        objective: Objective = "projection",
        pull: float = PULL,
    ) -> Stationary:
        """The equation that one solved layout [N, 4] solves; arguments as for `sensitivity`."""
        if objective == "energy":
            return stationary_energy(self, poses, pull, scene)
        return stationary_projection(self, poses, anchor, scene)

    # What follows takes flat values [F] of all parameters, kind after kind, or slopes [B, P] by those of a scene.

    def at_flat(self: Problem, flat: np.ndarray) -> Problem:
        """`at` for all values [F] at once, which are taken as they are."""
        flat = np.asarray(flat, dtype=np.float64)
        if np.array_equal(flat, self.parameters.flat):
            return self
        key = flat.tobytes()
        if key not in self._others:
            self._others[key] = self._compiled_at(self.parameters.unflat(flat))
            while len(self._others) > KEPT:
                self._others.popitem(last=False)
        self._others.move_to_end(key)
        return self._others[key]

    @cached_property
    def _others(self: Problem) -> OrderedDict[bytes, Problem]:
        return OrderedDict()

    def _compiled_at(self: Problem, values: Mapping[str, np.ndarray]) -> Problem:
        """The problem at other values; where weights alone differ, with what is compiled already."""
        now = self.parameters.values
        fixed = all(np.array_equal(values[kind], now[kind]) for kind in KINDS if kind not in WEIGHTS)
        scenes, compiled = [], []
        for s, scene in enumerate(self.scenes):
            mine = {kind: rows[s] for kind, rows in values.items()}
            new = scene_with(scene, mine)
            each = self._compiled[s] if fixed else compile_scene(new)
            scenes.append(new)
            compiled.append(replace(each, scene=new, room=_weighted(each.room, new, mine, self._terms)))
        return type(self)(scenes, [each.room for each in compiled], self.device, compiled, self._pools)

    @cached_property
    def _terms(self: Problem) -> list[str]:
        return [label.removeprefix("term/") for label in self.parameters.labels["term"][0]]

    @cached_property
    def slots(self: Problem) -> np.ndarray:
        """Where the parameters of each scene stand among all: [S, P] int32; F behind a smaller scene's."""
        size = self.parameters.flat.size
        number = self.parameters.unflat(np.arange(size))
        found = np.full((len(self.scenes), max(1, *map(len, self._slots))), size, dtype=np.int32)
        for s, (row, of_scene) in enumerate(zip(found, self._slots, strict=True)):
            row[: len(of_scene)] = [number[slot.kind][(s, *slot.index)] for slot in of_scene]
        return found

    def slots_of(self: Problem, scene: int, kinds: Sequence[str]) -> tuple[list[int], list[Slot]]:
        """The parameters of a scene that are of some kinds: their numbers there, and what they are."""
        found = [(i, slot) for i, slot in enumerate(self._slots[scene]) if slot.kind in kinds]
        return [i for i, _ in found], [slot for _, slot in found]

    def parameter_slopes(
        self: Problem,
        poses: wp.array,
        which: wp.array,
        up: wp.array | None,
        roots: int,
        kinds: Sequence[str],
        along: wp.array | None = None,
    ) -> wp.array:
        """Derivatives by the parameters of a layout's scene: of its items' sum [B, P], or of each item along a change.

        Args:
            poses, which: Warp arrays, [B, N] of vec4 and [B] int32.
            up: how often each item counts [B, M]; None: once.
            roots: 1: items as residuals, 0: as energies.
            kinds: of parameters that are wanted; those of others are 0.
            along: a change of the parameters [B, P]; then the result is [B, M].
        """
        entries, offset = self._entries(tuple(kinds))
        count, columns = poses.shape[0], self.slots.shape[1] if along is None else self.items
        if up is None:
            up = wp.full((count, self.items), 1.0, dtype=wp.float32, device=self.device)
        if along is None:
            along = wp.zeros((count, 0), dtype=wp.float32, device=self.device)
        else:
            lost = np.isnan(offset.numpy())[np.asarray(which.numpy())] & (along.numpy() != 0)
            if lost.any():
                raise InputError("along: it changes a parameter at a kink of the compiler; leave that one out")
            offset = wp.zeros((len(self.scenes), columns), dtype=wp.float32, device=self.device)
        batch = self._measured_at(poses, which)
        total = wp.zeros((count, columns), dtype=wp.int64, device=self.device)
        found = wp.zeros((count, columns), dtype=wp.float32, device=self.device)
        load_for(measure_parameter_slopes, self.device)
        inputs = [batch.problems, self._items, entries, along, batch.state, up, roots]
        wp.launch(measure_parameter_slopes, (count, self.items), inputs, [total], device=self.device)
        wp.launch(in_units, (count, columns), [batch.problems, offset, total], [found], device=self.device)
        return found

    def _entries(self: Problem, kinds: tuple[str, ...]) -> tuple[Entries, wp.array]:
        """How tables change with parameters of some kinds, and NaN [S, P] for those that they do not change smoothly
        with."""
        if kinds not in self._entries_of:
            values = self.parameters.values
            jacobians = [
                _joined([self._jacobian(s, kind, {k: v[s] for k, v in values.items()}) for kind in kinds])
                for s in range(len(self.scenes))
            ]
            offset = np.zeros(self.slots.shape, dtype=np.float32)
            for row, jacobian in zip(offset, jacobians, strict=True):
                np.asarray(row)[: jacobian.lost.size][jacobian.lost] = np.nan
            entries = entries_on(jacobians, self.device)
            self._entries_of[kinds] = entries, wp.array(offset, dtype=wp.float32, device=self.device)
        return self._entries_of[kinds]

    @cached_property
    def _entries_of(self: Problem) -> dict[tuple[str, ...], tuple[Entries, wp.array]]:
        return {}

    @cached_property
    def _jacobians(self: Problem) -> dict[tuple[int, str], Jacobian]:
        return {}

    def _jacobian(self: Problem, s: int, kind: str, values: dict[str, np.ndarray]) -> Jacobian:
        if (s, kind) not in self._jacobians:
            found = jacobian_of(self.scenes[s], self._layouts[s], self._slots[s], values, [kind])
            self._jacobians[s, kind] = found
        return self._jacobians[s, kind]

    def _by_kind(self: Problem, slopes: np.ndarray, which: np.ndarray, kinds: Sequence[str]) -> dict[str, np.ndarray]:
        """Slopes [B, P] as arrays by kind, without the dimension of scenes."""
        size, scenes = self.parameters.flat.size, len(self.scenes)
        whole = np.zeros((len(slopes), size + 1), dtype=np.float32)
        np.put_along_axis(whole, self.slots[which].astype(np.int64), slopes, axis=1)
        by_scene = self.parameters.unflat(whole[:, :size])
        return {kind: by_scene[kind][np.arange(len(slopes)), which] for kind in kinds} if scenes else {}

    def _moving(self: Problem, poses: Array, along: Array, which: Array | None) -> tuple[np.ndarray, ...]:
        """Poses, a movement and scenes as NumPy."""
        given, rows = self._read(poses, which)
        moving = poses_from(along, self.objects, self.device).numpy()
        if moving.shape != given.numpy().shape:
            raise InputError(
                f"along: an array of shape {list(moving.shape)}; the poses' is {list(given.numpy().shape)}"
            )
        return given.numpy(), moving, np.asarray(rows.numpy(), dtype=np.int32)


def kinds_of(of: str | Iterable[str]) -> tuple[str, ...]:
    """Kinds of parameters in their order.

    Raises:
        InputError: there is no such kind.
    """
    wanted = {of} if isinstance(of, str) else set(of)
    unknown = wanted - set(KINDS)
    if unknown:
        raise InputError(f"of: no kind of parameters {sorted(map(str, unknown))[0]!r}; there are {', '.join(KINDS)}")
    return tuple(kind for kind in KINDS if kind in wanted)


def _weighted(room: LayoutProblem, scene: Scene, values: Mapping[str, np.ndarray], terms: list[str]) -> LayoutProblem:
    """A room's problem with other weights of relations and terms."""
    relations = list(room.relations)
    for kind, index, at, factor in weight_slopes(room, scene, terms):
        relations[at] = replace(relations[at], weight=factor * float(values[kind][index]))
    return replace(room, relations=relations)


def _joined(parts: Sequence[Jacobian]) -> Jacobian:
    """Derivatives by several kinds of parameters."""
    first = parts[0]
    entry, slot, slope = (np.concatenate([getattr(p, name) for p in parts]) for name in ("entry", "slot", "slope"))
    return Jacobian(first.counts, entry, slot, slope, np.logical_or.reduce([p.lost for p in parts]))
