"""How the tables of a problem change with the parameters of its scene: the compiler's own derivative.

The compiler is Python in float64, and what it computes is smooth in the parameters but for a few kinks, so a scene is
compiled a little to either side of each parameter and the tables are subtracted (`STEP`: the error is some 1e-8).
There is no second compiler that could disagree with the first. Where both sides have tables of one structure, and what
lies ahead goes on as what lies behind, the derivative is the central difference. Where only one side has the structure
of the scene as it is (a corner of an outline that is straight on the other, an opening that would leave its wall), it
is that side's. Else there is none, and derivatives by that parameter are NaN. Weights are factors of tables, and need
no compiling.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels import tables as k
from sceneweaver.kernels.slopes import Entries
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError, Scene

from .compile import LayoutProblem, compile_room
from .pack import columns_of
from .parameters import WEIGHTS, Slot, scene_with
from .rows import SOFT_WEIGHT

STEP = 1.0e-4
"""To either side of a length [m] or a number; a hundred times that of an angle [degrees]."""

JUMP = 1.0e4
"""Slope of a table that is none: numbers that changed places."""

KINK = 1.0e-3
"""By how much slopes ahead and behind may differ, as a share of 1 or of the larger one."""

ENTRIES = (
    ("weight", "relation_weight", 1),
    ("frame", "row_frame", 4),
    ("aim", "row_aim", 4),
    ("size", "object_size", 3),
    ("heights", "object_z", 2),
    ("vertex", "vertex", 2),
    ("edge", "edge", 3),
    ("plane", "plane", 3),
    ("ceiling", "room_height", 1),
)
"""The tables that the energy is smooth in, as `Entries` calls them, and how many numbers of an element are used."""

# What searches look at, and what says how quickly something can be measured: no energy depends on it.
_LOOSE = {"grid_count", "object_boxes", "object_terms", "relation_kind", "pair_flags", "snap_start"} | {
    table.name for table in k.TABLES if table.name.startswith(("surface", "pool", "group", "member"))
}
_STRUCTURE = tuple(
    table.name
    for table in k.TABLES
    if getattr(table.dtype, "_wp_scalar_type_", table.dtype) not in (wp.float32,) and table.name not in _LOOSE
)


@dataclass(frozen=True)
class Jacobian:
    """Derivatives of a scene's entries, as triplets: which entry (of `ENTRIES`, by table), which slot, how much."""

    counts: tuple[int, ...]  # entries of each table
    entry: np.ndarray
    slot: np.ndarray
    slope: np.ndarray
    lost: np.ndarray  # [slot]: True where there is no derivative


def entries_of(layout: LayoutProblem) -> tuple[list[np.ndarray], list]:
    """The entries of a problem, table by table, and what has to be the same for a difference to mean something."""
    columns = columns_of(layout)
    found = [
        np.asarray(columns[name], dtype=np.float64).reshape(len(columns[name]), -1)[:, :width].ravel()
        for _, name, width in ENTRIES
    ]
    return found, [columns[name] for name in _STRUCTURE]


def weight_slopes(layout: LayoutProblem, scene: Scene, terms: Sequence[str]) -> list[tuple[str, int, int, float]]:
    """What the weight of a problem's relation is a multiple of: kind, number there, relation, factor."""
    found = []
    for at, relation in enumerate(layout.relations):
        place = layout.riders.get(at, at)
        if place < len(layout.relation_ids):
            number = layout.relation_ids[place]
            found.append(("weight", number, at, 1.0 if scene.relations[number].hard else SOFT_WEIGHT))
        elif relation.term is not None:
            found.append(("term", terms.index(relation.term), at, SOFT_WEIGHT))
    return found


def jacobian_of(
    scene: Scene, layout: LayoutProblem, slots: Sequence[Slot], values: dict[str, np.ndarray], kinds: Sequence[str]
) -> Jacobian:
    """The derivatives of a scene's tables by its parameters of some kinds.

    Args:
        scene, layout: the scene and what it compiles to.
        slots: its parameters.
        values: their values, by kind.
        kinds: which of them are wanted; those of others are zero.
    """
    here, structure = entries_of(layout)
    flat = np.concatenate(here)
    entry, slot, slope, lost = [], [], [], np.zeros(len(slots), dtype=bool)
    number = {(s.kind, s.index): i for i, s in enumerate(slots)}
    terms = [s.label.removeprefix("term/") for s in slots if s.kind == "term"]
    for kind, index, relation, factor in weight_slopes(layout, scene, terms):
        if kind in kinds:
            entry.append(np.array([relation]))
            slot.append(np.array([number[kind, (index,)]]))
            slope.append(np.array([factor]))
    for i, each in enumerate(slots):
        if each.kind in kinds and each.kind not in WEIGHTS:
            checkpoint()
            found = _slope(scene, each, values, flat, structure)
            if found is None:
                lost[i] = True
                continue
            at = np.flatnonzero(np.abs(found) > 1e-9)
            entry.append(at)
            slot.append(np.full(at.size, i))
            slope.append(found[at])
    whole = [np.concatenate(x) if x else np.zeros(0) for x in (entry, slot, slope)]
    counts = tuple(x.size for x in here)
    return Jacobian(counts, whole[0].astype(np.int64), whole[1].astype(np.int32), whole[2], lost)


def _slope(
    scene: Scene, slot: Slot, values: dict[str, np.ndarray], here: np.ndarray, structure: list
) -> np.ndarray | None:
    """The derivative of all entries by one parameter; None: there is none."""
    step = STEP * (100.0 if slot.label.endswith("degrees") else 1.0)
    ahead, behind = (_side(scene, slot, values, here, structure, h) for h in (step, -step))
    if ahead is None or behind is None:
        return behind if ahead is None else ahead
    if np.any(np.abs(ahead - behind) > KINK * np.maximum(1.0, np.maximum(np.abs(ahead), np.abs(behind)))):
        return None
    return 0.5 * (ahead + behind)


def _side(
    scene: Scene, slot: Slot, values: dict[str, np.ndarray], here: np.ndarray, structure: list, step: float
) -> np.ndarray | None:
    """The slope of all entries to one side; None where the tables there have another structure."""
    moved = {**values, slot.kind: values[slot.kind].copy()}
    moved[slot.kind][slot.index] += step
    try:
        found, other = entries_of(compile_room(scene_with(scene, moved)))
    except InputError:
        return None
    if other != structure:
        return None
    slope = (np.concatenate(found) - here) / step
    return None if np.any(np.abs(slope) > JUMP) else slope


def entries_on(jacobians: Sequence[Jacobian], device: str) -> Entries:
    """The derivatives of several scenes' tables, packed one after the other, on a device."""
    counts = np.array([j.counts for j in jacobians], dtype=np.int64).reshape(-1, len(ENTRIES))
    total = counts.sum(axis=0)
    first = np.concatenate([[0], np.cumsum(total)])
    within = np.cumsum(counts, axis=0) - counts  # where a scene's part of each table begins
    where, slot, slope = [], [], []
    for s, j in enumerate(jacobians):
        own = np.concatenate([[0], np.cumsum(counts[s])])
        table = np.searchsorted(own, j.entry, side="right") - 1
        where.append(first[table] + within[s][table] + j.entry - own[table])
        slot.append(j.slot)
        slope.append(j.slope)
    at = np.concatenate(where) if where else np.zeros(0, dtype=np.int64)
    order = np.argsort(at, kind="stable")
    start = np.searchsorted(at[order], np.arange(first[-1] + 1))
    entries = Entries()
    for (name, _, _), begin in zip(ENTRIES, first[:-1].tolist(), strict=True):
        setattr(entries, name, begin)
    entries.start = wp.array(start.astype(np.int32), dtype=wp.int32, device=device)
    entries.parameter = wp.array(np.concatenate(slot)[order].astype(np.int32), dtype=wp.int32, device=device)
    entries.slope = wp.array(np.concatenate(slope)[order].astype(np.float32), dtype=wp.float32, device=device)
    return entries
