"""Topologies of plans: which rooms adjoin and which doors join them, told apart whatever the rooms are called."""

from __future__ import annotations

import numpy as np

from .programme import Programme

ROUNDS = 4
"""Refinements of the rooms' colours."""


def room_classes(programme: Programme) -> np.ndarray:
    """[rooms] int: rooms that the programme tells apart by their names alone have the same class.

    That is: equal in type, area, side, storey and daylight, and joined to the same rooms in the same ways.
    """
    joined = {
        room.id: sorted(
            (x.kind, x.hard, x.b if x.a == room.id else x.a) for x in programme.adjacencies if room.id in (x.a, x.b)
        )
        for room in programme.rooms
    }
    keys = [
        (r.type, r.area, r.side, r.storey, r.daylight, r.id == programme.entrance, tuple(joined[r.id]))
        for r in programme.rooms
    ]
    return np.array([keys.index(key) for key in keys], dtype=np.int64)


def neighbour_matrices(
    cells: np.ndarray,
    storey: np.ndarray,
    owner: np.ndarray,
    doors: np.ndarray,
    counts: np.ndarray,
    rooms: int,
    inner: int,
) -> np.ndarray:
    """[B, rooms, rooms] int: 1 where two rooms share a wall or lie over each other by storeys apart, 2 with a door too.

    Args:
        cells: [B, C, 4] int [mm].
        storey: [B, C] int; -1: not there.
        owner: [B, C] int.
        doors: [B, D, 9] int.
        counts: [B] int, of doors.
        rooms: how many.
        inner: thickness of inner walls [mm].
    """
    lows = np.maximum(cells[:, :, None, :2], cells[:, None, :, :2])
    highs = np.minimum(cells[:, :, None, 2:], cells[:, None, :, 2:])
    gap = lows - highs
    same = (storey[:, :, None] == storey[:, None, :]) & (storey[:, :, None] >= 0)
    beside = ((gap[..., 0] == inner) & (gap[..., 1] < 0)) | ((gap[..., 1] == inner) & (gap[..., 0] < 0))
    found = np.zeros((len(cells), rooms, rooms), dtype=np.int64)
    candidate, i, j = np.nonzero(beside & same)
    found[candidate, owner[candidate, i], owner[candidate, j]] = 1
    candidate, k = np.nonzero(np.arange(doors.shape[1])[None] < counts[:, None])
    a, b = doors[candidate, k, 0], doors[candidate, k, 1]
    inside = b >= 0
    found[candidate[inside], a[inside], b[inside]] = 2
    found[candidate[inside], b[inside], a[inside]] = 2
    return found


def topology_codes(matrices: np.ndarray, classes: np.ndarray) -> np.ndarray:
    """[B] uint64: equal for plans whose graphs are the same but for rooms of one class (isomorphic ones always are).

    Colours are refined by those of neighbours and doors (Weisfeiler and Leman 1968), and hashed: graphs that this does
    not tell apart count as one.
    """
    colours = np.broadcast_to(_mixed(classes.astype(np.uint64) + np.uint64(1)), matrices.shape[:2]).copy()
    for _ in range(ROUNDS):
        gathered = colours * np.uint64(0x9E3779B97F4A7C15)
        for kind in (1, 2):
            seen = _mixed(colours + np.uint64(kind * 0x51ED2701))
            gathered = gathered + ((matrices == kind) * seen[:, None, :]).sum(axis=2, dtype=np.uint64)
        colours = _mixed(gathered)
    return _mixed(colours.sum(axis=1, dtype=np.uint64))


def _mixed(x: np.ndarray) -> np.ndarray:
    """The finaliser of SplitMix64 (Steele, Lea, Flood 2014)."""
    with np.errstate(over="ignore"):
        x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return x ^ (x >> np.uint64(31))
