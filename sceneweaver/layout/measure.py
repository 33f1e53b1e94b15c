"""Energy, residuals, violations and verdict of layouts as they stand: the engine's kernels, each launched once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.kernels import load_for
from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.kernels.residuals import Items, mark_feasible, measure_residuals, measure_violations
from sceneweaver.kernels.step import add_up
from sceneweaver.kernels.tables import State
from sceneweaver.optimizers import Batch
from sceneweaver.optimizers.descent import add_choice, add_gradients, new_gradients
from sceneweaver.optimizers.launches import Launches
from sceneweaver.optimizers.verdict import new_device_verdict, write_verdict

from .compile import LayoutProblem
from .metadata import ALONE, items_of
from .pack import Packed, margins, weights

KINDS = ("collision", "bounds", "zone", "opening", "relation")
"""Kinds of terms: bodies that meet, walls and ceiling, hard zones, doors and windows, relations."""


def items_on(layouts: Sequence[LayoutProblem], device: str) -> tuple[Items, int]:
    """The items of some layouts' energies on a device, and the largest number that one has."""
    objects, relation, start = [], [], [0]
    for layout in layouts:
        for info in items_of(layout):
            if info.relation is not None:
                objects.append(layout.relations[info.relation].objects)
            else:
                objects.append((*info.objects, -1, -1)[:3] if info.kind == ALONE else (*info.objects, -1))
            relation.append(-1 if info.relation is None else info.relation)
        start.append(len(objects))
    items = Items()
    items.start = wp.array(np.asarray(start, dtype=np.int32), device=device)
    items.objects = wp.array(np.asarray(objects, dtype=np.int32).reshape(-1, 3), dtype=wp.vec3i, device=device)
    items.relation = wp.array(np.asarray(relation, dtype=np.int32), dtype=wp.int32, device=device)
    return items, int(np.diff(start).max(initial=0))


def batch_at(packed: Packed, which: wp.array, poses: wp.array) -> Batch:
    """Candidates of packed problems (``which`` [B]) at poses [B, N], which are read in place and never written."""
    state, device = State(), packed.device
    state.poses = poses
    state.turns = wp.zeros(poses.shape, dtype=wp.vec2, device=device)
    state.options = wp.zeros((poses.shape[0], max(packed.relations, 1)), dtype=wp.int32, device=device)
    wp.launch(set_turns, poses.shape, [poses], [state.turns], device=device)
    return Batch(
        packed.tables,
        packed.keep,
        margins(),
        weights(),
        which,
        state,
        packed.objects,
        packed.relations,
        packed.terms,
        device,
    )


def energy_of(batch: Batch) -> tuple[wp.array, wp.array]:
    """Energies [B] and their gradients [B, N] (vec4) for the pose of every object, with the best of all options."""
    each, total = new_gradients(batch), wp.zeros(batch.size, dtype=wp.float32, device=batch.device)
    gradient = wp.zeros(batch.state.poses.shape, dtype=wp.vec4, device=batch.device)
    if batch.size and batch.objects:
        block, open_end = Launches(batch.device), wp.full(batch.size, np.inf, dtype=wp.float32, device=batch.device)
        add_choice(block, batch, batch.state, [batch.state.options, batch.state.options])
        add_gradients(block, batch, batch.state, open_end, each)
        block.add(add_up, batch.size, [batch.problems, each.share], [total])
        block.run()
        wp.copy(gradient, each.gradient.transpose())
    return total, gradient


def shares_of(batch: Batch, kind: str) -> wp.array:
    """Every object's share [B, N] of the energy of one of `KINDS`."""
    alone = weights(**{other: 0.0 for other in KINDS if other != kind})
    one = replace(batch, weights=alone)
    each, shares = new_gradients(one), wp.zeros(batch.state.poses.shape, dtype=wp.float32, device=batch.device)
    if batch.size and batch.objects:
        block, open_end = Launches(one.device), wp.full(one.size, np.inf, dtype=wp.float32, device=one.device)
        add_choice(block, one, one.state, [one.state.options, one.state.options])
        add_gradients(block, one, one.state, open_end, each)
        block.run()
        wp.copy(shares, each.share.transpose())
    return shares


def residuals_of(batch: Batch, items: Items, count: int) -> tuple[wp.array, wp.array]:
    """Residuals [B, M] of the items, and their derivatives [B, M, 3] (vec4) for the poses of an item's objects."""
    residual = wp.zeros((batch.size, count), dtype=wp.float32, device=batch.device)
    slope = wp.zeros((batch.size, count, 3), dtype=wp.vec4, device=batch.device)
    inputs = [batch.problems, items, batch.state]
    load_for(measure_residuals, batch.device)
    wp.launch(measure_residuals, (batch.size, count), inputs, [residual, slope], device=batch.device)
    return residual, slope


def violations_of(batch: Batch, items: Items, count: int) -> wp.array:
    """Signed violations [B, M] of the items."""
    violation = wp.zeros((batch.size, count), dtype=wp.float32, device=batch.device)
    inputs = [batch.problems, items, batch.state]
    load_for(measure_violations, batch.device)
    wp.launch(measure_violations, (batch.size, count), inputs, [violation], device=batch.device)
    return violation


def feasible_of(batch: Batch, also: wp.array) -> wp.array:
    """Which layouts [B] the verdict calls valid and ``also`` [B] int32 does not rule out."""
    verdict, feasible = new_device_verdict(batch), wp.zeros(batch.size, dtype=wp.bool, device=batch.device)
    write_verdict(batch, verdict, wp.full(batch.size, 1, dtype=wp.int32, device=batch.device))
    wp.launch(mark_feasible, batch.size, [verdict, also], [feasible], device=batch.device)
    return feasible
