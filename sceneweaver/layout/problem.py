"""The layout problem of scenes, for people who bring their own optimiser."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import count
from typing import Any, Generic, TypeAlias, TypeVar, cast, overload
from weakref import WeakValueDictionary

import numpy as np
import warp as wp

from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import Batch, Monitor, run, streams
from sceneweaver.optimizers.starts import draw_starts
from sceneweaver.scene import InputError, Scene

from .arrays import Array, HostArray, SharesMemory, WarpArray, from_dlpack, handed_out, poses_from
from .batch import make_batch
from .compile import CompiledScene, LayoutProblem, compile_scene
from .derivatives import Differentiable
from .devices import pick_devices
from .measure import KINDS, batch_at, energy_of, feasible_of, items_on, residuals_of, shares_of, violations_of
from .metadata import Metadata, bounds_of, freedom_of, metadata_of
from .pack import PULL, Packed, pack, weights
from .surfaces import surfaces_hold

_NUMBERS = count()
_PROBLEMS: WeakValueDictionary[int, Problem] = WeakValueDictionary()


A = TypeVar("A")
Device: TypeAlias = WarpArray | SharesMemory  # what is answered with Warp arrays


@dataclass(frozen=True)
class Terms(Generic[A]):
    """The energy of layouts taken apart, in NumPy or Warp arrays.

    Attributes:
        energy: for "collision", "bounds", "zone", "opening" and "relation" each object's share [B, N] of it [m]; their
            sum is the energy.
        residual: [B, M] of every item, see `Problem.residuals`.
        violation: [B, M] by how much an item misses what the verdict insists on [m]; negative: what is left. Rows of
            angles count in the metres that the energy takes them for. -1e6 where two bodies can not meet as they
            stand, and behind a smaller problem's items.
    """

    energy: dict[str, A]
    residual: A
    violation: A


class Problem(Differentiable):
    """The layout problem of one or several scenes: a function of poses that is zero where a layout is in order.

    Poses are [B, N, 4] float32: x, y, z [m] and yaw [rad] of N objects, in the scene's order and in the room's frame.
    Where scenes differ in size, N is that of the largest, and what stands behind a smaller one's objects is not read.
    Methods take NumPy arrays, Warp arrays and whatever hands out its memory by DLPack, without a copy where it lies on
    the problem's device; they return NumPy for NumPy, and Warp arrays on the device for all else.

    ``which`` [B] int32 says which scene each layout is of. Left out, the batch has equal parts, scene after scene.

    Attributes:
        scenes: the scenes S.
        device: the Warp device that it lives on.
        number: what `numbered` knows it by, for calls of other libraries that carry arrays and numbers alone.
        metadata: for each scene what its objects, relations and items are.
        mask: [S, N] bool, which objects there are.
        free: [S, N, 4] bool, which coordinates an optimiser may change.
        lower, upper: [S, N, 4] float32, the box of the poses.
        home: [S, N, 4] float32, the poses of the scenes as given, at the heights that their mounts demand.
        energy_calls: how often the energy was measured so far: with a gradient, as residuals or by terms as well.
        evaluations: of how many layouts in all.

    Examples:
        >>> import sceneweaver as sw
        >>> problem = sw.compile([sw.Scene.example("bedroom"), sw.Scene.example("study")], device="cpu")
        >>> poses = problem.sample(0, 4)  # four layouts of each
        >>> energy, gradient = problem.energy_and_grad(poses)
        >>> energy.shape, gradient.shape == poses.shape == (8, problem.objects, 4)
        ((8,), True)
        >>> bool(problem.feasible(problem.home).all())  # the examples are in order
        True
    """

    def __init__(
        self,
        scenes: Sequence[Scene],
        layouts: Sequence[LayoutProblem],
        device: str,
        compiled: Sequence[CompiledScene] = (),
        pools: Sequence[Sequence[np.ndarray]] | None = None,
    ) -> None:
        """Use `compile`. ``layouts`` are the scenes' rooms or surfaces, ``compiled`` the scenes with all surfaces.

        Without ``compiled`` the verdict does not look at surfaces; ``pools`` are layouts of those to draw from.
        """
        self.scenes = tuple(scenes)
        self.device = device
        self.number = next(_NUMBERS)
        _PROBLEMS[self.number] = self
        self._layouts = tuple(layouts)
        self._compiled = tuple(compiled)
        self._pools = pools
        self._which: dict[int, wp.array] = {}
        self.energy_calls = self.evaluations = 0
        self._packed: Packed = pack(self._layouts, device)
        self._items, self._item_count = items_on(self._layouts, device)

    def __repr__(self) -> str:
        return f"Problem({len(self._layouts)} scenes, {self.objects} objects, {self.items} items, {self.device})"

    @property
    def objects(self) -> int:
        """Number of objects N that poses have."""
        return max(self._packed.objects, 1)

    @property
    def items(self) -> int:
        """Number of items M that residuals and violations have, see `Metadata.items`."""
        return self._item_count

    @cached_property
    def metadata(self) -> tuple[Metadata, ...]:
        """What stands where, for each scene."""
        return tuple(metadata_of(layout) for layout in self._layouts)

    @cached_property
    def mask(self) -> np.ndarray:
        """Which objects there are, [S, N] bool."""
        return np.arange(self.objects) < np.array([[layout.size] for layout in self._layouts])

    @cached_property
    def free(self) -> np.ndarray:
        """Which coordinates an optimiser may change, [S, N, 4] bool."""
        return self._padded([freedom_of(layout) for layout in self._layouts], bool)

    @cached_property
    def lower(self) -> np.ndarray:
        """Lower end of the poses' box, [S, N, 4] float32."""
        return self._padded([bounds_of(layout)[0] for layout in self._layouts])

    @cached_property
    def upper(self) -> np.ndarray:
        """Upper end of the poses' box, [S, N, 4] float32."""
        return self._padded([bounds_of(layout)[1] for layout in self._layouts])

    @cached_property
    def home(self) -> np.ndarray:
        """The scenes' own poses, [S, N, 4] float32."""
        return self._padded([layout.home for layout in self._layouts])

    @cached_property
    def roots(self) -> np.ndarray:
        """For each object the one at the bottom of the stack that it is in, [S, N] int32."""
        roots = np.tile(np.arange(self.objects, dtype=np.int32), (len(self._layouts), 1))
        for row, layout in zip(roots, self._layouts, strict=True):
            row[: layout.size] = layout.roots
        return roots

    @cached_property
    def item_objects(self) -> np.ndarray:
        """The objects of each item, [S, M, 3] int32; -1: none."""
        table, start = self._items.objects.numpy().reshape(-1, 3), self._items.start.numpy()
        found = np.full((len(self._layouts), self.items, 3), -1, dtype=np.int32)
        for s, row in enumerate(found):
            row[: start[s + 1] - start[s]] = table[start[s] : start[s + 1]]
        return found

    @cached_property
    def surfaces(self) -> tuple[Problem, ...]:
        """Problems of the support surfaces that carry something, scene after scene, in their supporters' frames."""
        domains = [(compiled.scene, domain.problem) for compiled in self._compiled for domain in compiled.domains]
        return tuple(Problem((scene,), (layout,), self.device) for scene, layout in domains)

    def sample(self, key: int | Array, count: int) -> np.ndarray:
        """Draw layouts to start from: every object from its relations, what stands on it where it stands in the scene.

        Args:
            key: a seed from 0 to 2**32 - 1, or an array of words such as ``jax.random.key_data(key)``.
            count: number of layouts of each scene.

        Returns:
            Poses [S * count, N, 4] as NumPy, scene after scene. They are drawn, not solved.
        """
        if not isinstance(count, int | np.integer) or isinstance(count, bool) or count < 1:
            raise InputError(f"count: {count!r} is not a whole number of at least 1")
        seeds = np.tile(streams(seed_of(key), np.arange(count)), len(self._layouts))
        which = self._which_of(None, len(seeds))
        return self.drawn(wp.array(seeds, dtype=wp.uint32, device=self.device), which).numpy()

    @overload
    def energy(self, poses: HostArray, which: Array | None = None) -> np.ndarray: ...
    @overload
    def energy(self, poses: Device, which: Array | None = None) -> WarpArray: ...
    def energy(self, poses: Array, which: Array | None = None) -> Any:
        """Energy [B] float32 [m] of layouts; 0: all holds with its margin.

        It is the sum of Huber penalties of all that is missing: air between bodies and to walls, free zones, openings,
        and the intervals of relations, each by the best of its options. What stands on something counts where it
        stands, but not against what carries it: see `carry` and `surfaces`.

        Raises:
            InputError: ``poses`` or ``which`` has another shape, type of number or device.
        """
        return handed_out(self.measured(*self._read(poses, which))[0], poses)

    @overload
    def energy_and_grad(self, poses: HostArray, which: Array | None = None) -> tuple[np.ndarray, np.ndarray]: ...
    @overload
    def energy_and_grad(self, poses: Device, which: Array | None = None) -> tuple[WarpArray, WarpArray]: ...
    def energy_and_grad(self, poses: Array, which: Array | None = None) -> Any:
        """Energies [B] and their gradients [B, N, 4], by x, y, z [m/m] and yaw [m/rad] of every object on its own.

        The gradient is there for all coordinates; multiply by ``free`` to leave alone what has to stay.
        """
        energy, gradient = self.measured(*self._read(poses, which))
        return handed_out(energy, poses), handed_out(gradient, poses)

    @overload
    def residuals(self, poses: HostArray, which: Array | None = None) -> tuple[np.ndarray, np.ndarray]: ...
    @overload
    def residuals(self, poses: Device, which: Array | None = None) -> tuple[WarpArray, WarpArray]: ...
    def residuals(self, poses: Array, which: Array | None = None) -> Any:
        """Residuals r [B, M] of the energy's items, and their derivatives [B, M, 3, 4] by the poses of their objects.

        r = sqrt(2 k e) for an item's part e of the energy, with the knee k = 0.05 m, so the energy is the sum of
        r^2 / (2 k). The objects of the items are in ``item_objects``.
        """
        residual, slope = self.taken_apart(*self._read(poses, which))
        return handed_out(residual, poses), handed_out(slope, poses)

    @overload
    def terms(self, poses: HostArray, which: Array | None = None) -> Terms[np.ndarray]: ...
    @overload
    def terms(self, poses: Device, which: Array | None = None) -> Terms[WarpArray]: ...
    def terms(self, poses: Array, which: Array | None = None) -> Any:
        """The energy by kinds of terms, and residual and signed violation of every relation, object and pair."""
        batch = self._measured_at(*self._read(poses, which))
        energy = {kind: handed_out(shares_of(batch, kind), poses) for kind in KINDS}
        residual, _ = residuals_of(batch, self._items, self.items)
        violation = violations_of(batch, self._items, self.items)
        return Terms(energy, handed_out(residual, poses), handed_out(violation, poses))

    @overload
    def feasible(self, poses: HostArray, which: Array | None = None) -> np.ndarray: ...
    @overload
    def feasible(self, poses: Device, which: Array | None = None) -> WarpArray: ...
    def feasible(self, poses: Array, which: Array | None = None) -> Any:
        """Which layouts [B] bool the engine calls valid; then `sw.check` does.

        It looks at what stands on surfaces as well, and at hard relations and bodies that no movement here changes.
        """
        return handed_out(self.judged(*self._read(poses, which)), poses)

    @overload
    def project(self, poses: HostArray, which: Array | None = None) -> np.ndarray: ...
    @overload
    def project(self, poses: Device, which: Array | None = None) -> WarpArray: ...
    def project(self, poses: Array, which: Array | None = None) -> Any:
        """The feasible layouts nearest to poses, [B, N, 4]: what `sw.refine` does with ``optimizer="projection"``.

        Where none is found, the least faulty one. What stands on something moves along.
        """
        return handed_out(self.projected(*self._read(poses, which)), poses)

    def carry(self, poses: Array, which: Array | None = None, *, like: Array | None = None) -> np.ndarray:
        """Poses [B, N, 4] with all that is carried put on its root as it stands in the layouts ``like``.

        ``like`` [B, N, 4] defaults to the scenes as given. NumPy, on the host; `sceneweaver.jax.carry` is its twin.
        """
        given, rows = self._read(poses, which)
        layouts, scene = np.asarray(given.numpy(), dtype=np.float64), np.asarray(rows.numpy(), dtype=np.int32)
        model = self.home[scene] if like is None else poses_from(like, self.objects, self.device).numpy()
        roots = self.roots[scene][..., None]
        offset = relative(model.astype(np.float64), np.take_along_axis(model, roots, axis=1).astype(np.float64))
        moved = absolute(offset, np.take_along_axis(layouts, roots, axis=1))
        return np.where(roots != np.arange(self.objects)[:, None], moved, layouts).astype(np.float32)

    def at(self, parameters: Mapping[str, Any]) -> Problem:
        """The problem with other values of some parameters, compiled anew; the last few are kept.

        Args:
            parameters: arrays by kind, as in `parameters`; what is left out stays. Problems at other values are about
                scenes with those, and poses mean the same to all of them.

        Raises:
            InputError: no such kind, another shape, a number outside of its bounds, or an impossible room.

        Examples:
            >>> import sceneweaver as sw
            >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
            >>> wider = problem.parameters.values["size"] * 1.05
            >>> problem.at({"size": wider}).scenes[0].objects[0].size[1] > problem.scenes[0].objects[0].size[1]
            True
        """
        return self.at_flat(self.parameters.flattened(parameters))

    def scene_of(self, count: int, which: Array | None = None) -> np.ndarray:
        """The scene [B] int32 of each of so many layouts, as ``which`` says or leaves to be said."""
        return np.asarray(self._which_of(which, count).numpy(), dtype=np.int32)

    def batch(self, poses: Array, which: Array | None = None) -> Batch:
        """Layouts at poses as the engine's own batch, with memory of its own: what `Optimizer`s move."""
        given, rows = self._read(poses, which)
        return self._movable(rows, given, self._pools)

    # What follows takes Warp arrays: poses [B, N] of vec4 and which [B] int32, on the problem's device.

    def measured(self, poses: wp.array, which: wp.array) -> tuple[wp.array, wp.array]:
        """Energies [B] and gradients [B, N] (vec4)."""
        return energy_of(self._measured_at(poses, which))

    def taken_apart(self, poses: wp.array, which: wp.array) -> tuple[wp.array, wp.array]:
        """Residuals [B, M] and their derivatives [B, M, 3] (vec4)."""
        return residuals_of(self._measured_at(poses, which), self._items, self.items)

    def judged(self, poses: wp.array, which: wp.array) -> wp.array:
        """Which layouts [B] are feasible."""
        batch = batch_at(self._packed, which, poses)
        return feasible_of(batch, self._surfaces_in_order(batch))

    def drawn(self, rng: wp.array, which: wp.array) -> wp.array:
        """Layouts [B, N] (vec4) to start from, by a word of uint32 [B] for each."""
        home = self.home[np.asarray(which.numpy(), dtype=np.int32)]
        batch = self._movable(which, wp.array(home, dtype=wp.vec4, device=self.device))
        wp.copy(batch.state.rng, rng)
        draw_starts(batch, "sample")
        return batch.state.poses

    def projected(self, poses: wp.array, which: wp.array) -> wp.array:
        """The feasible layouts [B, N] (vec4) nearest to poses."""
        batch = replace(self._movable(which, poses), weights=weights(pull=PULL))
        run(batch, "projection", "given", None, Monitor(batch.size))
        return batch.state.poses

    def _measured_at(self, poses: wp.array, which: wp.array) -> Batch:
        """Layouts whose energy is about to be measured; they are counted."""
        self.energy_calls += 1
        self.evaluations += poses.shape[0]
        return batch_at(self._packed, which, poses)

    def _movable(self, which: wp.array, poses: wp.array, pools: Any = None) -> Batch:
        """A batch of its own memory at some poses."""
        batch = make_batch(self._layouts, np.asarray(which.numpy()), self.device, pools)
        for into in (batch.state.poses, batch.state.anchors):
            wp.copy(into, poses)
        wp.launch(set_turns, poses.shape, [poses], [batch.state.turns], device=self.device)
        return batch

    def _surfaces_in_order(self, batch: Batch) -> wp.array:
        """Which layouts [B] int32 have everything on their surfaces in order, and nothing fixed at a wrong height."""
        laden = [s for s, compiled in enumerate(self._compiled) if compiled.domains or compiled.room.faulty]
        if not laden:
            return wp.full(batch.size, 1, dtype=wp.int32, device=self.device)
        scene, good = np.asarray(batch.problem.numpy(), dtype=np.int32), np.ones(batch.size, dtype=np.int32)
        for s in laden:
            rows = np.flatnonzero(scene == s)
            if rows.size:
                poses = wp.array(batch.state.poses.numpy()[rows], dtype=wp.vec4, device=self.device)
                some = self._movable(wp.full(rows.size, s, dtype=wp.int32, device=self.device), poses)
                held = surfaces_hold(self._compiled[s], some, 0, rows.size)
                good[rows] = held & (not self._compiled[s].room.faulty)
        return wp.array(good, dtype=wp.int32, device=self.device)

    def _read(self, poses: Array, which: Array | None) -> tuple[wp.array, wp.array]:
        """Poses [B, N] of vec4 and which [B] int32, on the device."""
        given = poses_from(poses, self.objects, self.device)
        return given, self._which_of(which, given.shape[0])

    def _which_of(self, which: Array | None, count: int) -> wp.array:
        if which is None:
            if count not in self._which:
                if count % len(self._layouts):
                    text = (
                        f"which: {count} layouts are no equal parts of {len(self._layouts)} scenes; say whose each is"
                    )
                    raise InputError(text)
                rows = np.repeat(np.arange(len(self._layouts), dtype=np.int32), count // len(self._layouts))
                self._which = {count: wp.array(rows, dtype=wp.int32, device=self.device)}
            return self._which[count]
        values = (
            which
            if isinstance(which, wp.array | np.ndarray | list | tuple)
            else from_dlpack("which", cast(SharesMemory, which))
        )
        rows = values.numpy() if isinstance(values, wp.array) else np.asarray(values)
        if rows.shape != (count,) or not np.issubdtype(rows.dtype, np.integer):
            raise InputError(f"which: {rows.dtype} of shape {rows.shape}; one whole number for each of {count} layouts")
        if rows.size and not 0 <= rows.min() <= rows.max() < len(self._layouts):
            raise InputError(f"which: numbers from {rows.min()} to {rows.max()}; there are {len(self._layouts)} scenes")
        return wp.array(rows.astype(np.int32), dtype=wp.int32, device=self.device)

    def _padded(self, values: Sequence[np.ndarray], dtype: Any = np.float32) -> np.ndarray:
        padded = np.zeros((len(values), self.objects, 4), dtype=dtype)
        for row, value in zip(padded, values, strict=True):
            row[: len(value)] = value
        return padded


def numbered(number: int) -> Problem:
    """The problem of a number.

    Raises:
        InputError: it is gone.
    """
    problem = _PROBLEMS.get(int(number))
    if problem is None:
        raise InputError("problem: it is gone; keep it as long as what calls it")
    return problem


def seed_of(key: int | Array) -> int:
    """A seed from a whole number, or from an array of words.

    Raises:
        InputError: it is neither.
    """
    words = np.asarray(key).reshape(-1)
    if not words.size or not np.issubdtype(words.dtype, np.integer) or isinstance(key, bool):
        raise InputError(f"key: {key!r} is not a whole number or an array of such")
    if words.size == 1 and not 0 <= int(words[0]) < 2**32:
        raise InputError(f"key: {int(words[0])} is not from 0 to 2**32 - 1")
    seed = 0
    for word in words:
        seed = (seed * 0x9E3779B1 + int(word)) % 2**32
    return seed


def compile(scenes: Scene | Sequence[Scene], *, device: str = "auto") -> Problem:  # noqa: A001
    """Compile one or several scenes to a `Problem`.

    Args:
        scenes: what to lay out; poses matter for fixed objects, and for what stands on others.
        device: "auto", "cpu", "cuda" or "cuda:k".

    Raises:
        InputError: no scenes, or a wrong device.
        MissingDependencyError: the device is not there.

    Examples:
        >>> import sceneweaver as sw
        >>> problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
        >>> poses = problem.sample(0, 8)
        >>> problem.energy(poses).shape
        (8,)
    """
    given = (scenes,) if isinstance(scenes, Scene) else tuple(scenes)
    if not given or not all(isinstance(scene, Scene) for scene in given):
        raise InputError("scenes: give a Scene, or a list of at least one")
    where = pick_devices(device)
    if len(where) > 1:
        raise InputError(f'device: "{device}" is several; a problem lives on one')
    compiled = [compile_scene(scene) for scene in given]
    return Problem(given, [each.room for each in compiled], where[0], compiled)
