"""Collision parts for a simulator: few, convex, and boxes where they are boxes."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence

import numpy as np

from sceneweaver.assets import Asset, Interior
from sceneweaver.assets.journal import Journal
from sceneweaver.assets.recent import Recent
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.scene import Part, SceneObject

from .nested import cut_apart
from .solids import THINNEST, Solid, solid_of
from .vertices import fewer_vertices

MOST = 40
"""Parts of one asset that a simulator is given at most, where merging can reach that."""

FEW = 16
"""The same for small things: their parts are the many in a room, and a coarse shape is still close."""

SMALL = 0.6
"""What is nowhere longer than this [m] is small, unless it has drawers or doors: merged, they would fill up."""

_SLACK = 1e-4  # [m] by which a part may stand out of a prism and still belong to it
_WASTE = 0.01  # share of volume that a merge may add when it is not forced
_NEAR = 8  # neighbours of a part that it is tried with first
_FILL = 0.02  # share of an interior that a merge may fill
_NEARLY = 0.93  # share of its bounds that a part fills which becomes a box
_NARROWER = (1.0, 0.998, 0.995, 0.99, 0.98, 0.97, 0.96, 0.95, 0.94, 0.92)  # shares of depth and width, tried in turn
_NARROWED = 0.005  # [m] by which a side of a box may lie inside that of the part
_CORNERS = np.array([(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
_TOUCH = 1e-3  # [m] by which parts of different links may reach into each other


_MERGED: Recent[bytes, tuple[Solid, ...]] = Recent(
    16 * 2**20, lambda solids: sum(solid.points.nbytes + 2**9 for solid in solids)
)
"""Parts of assets by their content."""

_JOURNAL: Journal | None = None


def solids_of(thing: SceneObject, asset: Asset | None, scale: np.ndarray) -> list[Solid]:
    """The parts of an object; of an asset its hulls, ``scale`` [3] times as large, else the object's own prisms."""
    if asset is None or not any(hull.link == 0 for hull in asset.hulls):
        return [_limited(solid_of(prism_vertices(part.polygon, part.z), 0)) for part in thing.solids]
    merged = merged_hulls(asset)
    if np.allclose(scale, 1.0, atol=1e-9):
        return merged
    return [solid_of(solid.points * scale, solid.link, solid.handle) for solid in merged]


def merged_hulls(asset: Asset) -> list[Solid]:
    """The parts of an asset, its hulls merged where they are many; kept by content, as scenes are built often."""
    most = MOST if max(asset.size) > SMALL or asset.links else FEW
    content = hashlib.blake2b(repr([most, *((part.polygon, part.z) for part in asset.parts)]).encode())
    rooms = rooms_of(asset.interiors)
    for corners in rooms:
        content.update(corners.tobytes())
    for hull in asset.hulls:
        content.update(np.array([len(hull.vertices), hull.link, hull.handle]).tobytes())
        content.update(np.ascontiguousarray(hull.vertices, dtype=float).tobytes())
    key = content.digest()[:16]
    return list(_MERGED.get(key, lambda: _shared(key, lambda: _made(asset, most, rooms))))


def share_parts(journal: Journal | None) -> None:
    """Tell other processes the parts of assets, and take theirs, by a journal; None: no more."""
    global _JOURNAL
    _JOURNAL = journal


def _shared(key: bytes, make: Callable[[], tuple[Solid, ...]]) -> tuple[Solid, ...]:
    """The parts of an asset as another process tells them, else made and told."""
    if _JOURNAL is None:
        return make()
    content = _JOURNAL.get(key)
    if content is None:
        made = make()
        _JOURNAL.put(key, packed(made))
        return made
    return unpacked(content)


def packed(solids: Sequence[Solid]) -> bytes:
    """Parts as bytes: their number, a row of numbers for each, and all points."""
    rows = np.zeros((len(solids), 11))
    for row, solid in zip(rows, solids, strict=True):
        row[:5] = len(solid.points), solid.link, solid.handle, solid.volume, solid.box is not None
        if solid.box is not None:
            row[5:] = np.concatenate(solid.box)
    points = [np.asarray(solid.points, dtype=float).reshape(-1) for solid in solids]
    return np.concatenate([[len(solids)], rows.reshape(-1), *points]).astype("<f8").tobytes()


def unpacked(content: bytes) -> tuple[Solid, ...]:
    """The parts that were packed."""
    numbers = np.frombuffer(content, dtype="<f8").copy()
    count = int(numbers[0])
    rows, points = numbers[1 : 1 + 11 * count].reshape(-1, 11), numbers[1 + 11 * count :].reshape(-1, 3)
    found, start = [], 0
    for row in rows:
        end = start + int(row[0])
        box = (row[5:8], row[8:11]) if row[4] else None
        found.append(Solid(points[start:end], float(row[3]), int(row[1]), box, bool(row[2])))
        start = end
    return tuple(found)


def _made(asset: Asset, most: int, rooms: Sequence[np.ndarray]) -> tuple[Solid, ...]:
    found = [solid_of(np.asarray(h.vertices, dtype=float), h.link, h.handle) for h in asset.hulls]
    merged = reduce(found, asset.parts, most, rooms) if len(found) > most and asset.parts else found
    loose = {number for number, link in enumerate(asset.links, 1) if link.joint == "free"}
    return tuple(cut_apart([_limited(solid) for solid in squared(merged, asset.parts)], loose, _like))


def _like(points: np.ndarray, solid: Solid) -> Solid:
    """The part of some points, of the same link as another."""
    return _limited(solid_of(points, solid.link, solid.handle))


def rooms_of(interiors: Sequence[Interior]) -> list[np.ndarray]:
    """The corners [V, 3] of interiors: of a box, or around an ellipse at its floor and at its rim."""
    rooms = []
    for room in interiors:
        low, high = np.asarray(room.low), np.asarray(room.high)
        plan = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float)
        if room.oval:
            angle = np.arange(12) * (np.pi / 6)
            plan = np.column_stack([np.cos(angle), np.sin(angle)])
        corners = np.array([(x, y, z) for x, y in plan for z in (-1.0, 1.0)])
        rooms.append((low + high) / 2 + corners * (high - low) / 2)
    return rooms


def reduce(solids: Sequence[Solid], parts: Sequence[Part], most: int, rooms: Sequence[np.ndarray] = ()) -> list[Solid]:
    """Merge parts until at most ``most`` are left, as far as that goes.

    Two parts are merged only when both lie in one prism (and belong to one link): a prism is convex, so their common
    hull stays in it, and what was free in the scene stays free. Nor may it reach into a part of another link, which
    could then not move, nor fill more of one of the ``rooms`` (convex, by their corners), which hold things. Those go
    first whose hull adds the least volume.
    """
    import heapq

    live: dict[int, Solid] = dict(enumerate(solids))
    prisms = [_Home(part) for part in parts]
    homes = {k: _homes(solid.points, prisms) for k, solid in live.items()}
    bounds = {k: np.stack([solid.points.min(axis=0), solid.points.max(axis=0)]) for k, solid in live.items()}
    spans = np.array([[solid.points.min(axis=0), solid.points.max(axis=0)] for solid in solids])
    links = np.array([solid.link for solid in solids])
    others = {k: ([s for s in solids if s.link != k], spans[links != k]) for k in set(links.tolist())}
    free = [_Room(corners) for corners in rooms]
    filled = {k: _filled(solid.points, free) for k, solid in live.items()}
    heap: list[tuple[float, int, int]] = []
    fresh, total = len(live), sum(s.volume for s in solids)

    def offer(i: int, count: int, first: int) -> None:
        """Pairs of a part with the nearest ones of number ``first`` and above."""
        if live[i].handle:
            return
        same = [k for k in live if k >= first and k != i and live[k].link == live[i].link and not live[k].handle]
        fits = [k for k in same if homes[k] & homes[i]]
        if len(fits) > count:
            boxes = np.stack([bounds[k] for k in fits])
            gap = np.maximum(np.maximum(boxes[:, 0] - bounds[i][1], bounds[i][0] - boxes[:, 1]), 0.0)
            far = np.linalg.norm(gap, axis=1) + 0.1 * np.linalg.norm((boxes - bounds[i]).mean(axis=1), axis=1)
            fits = [fits[k] for k in np.argpartition(far, count)[:count]]
        for k in fits:
            both = _hull_volume(np.concatenate([live[i].points, live[k].points]))
            heapq.heappush(heap, (both - live[i].volume - live[k].volume, i, k))

    for count in (_NEAR, len(solids)):  # far pairs are seldom the cheapest, and are tried when there are no others
        if count > _NEAR and (len(live) <= most or rooms):  # around a room, far pairs fill it
            break
        heap.clear()
        for i in sorted(live):
            offer(i, count, 0 if count == _NEAR else i + 1)
        while heap:
            added, i, j = heapq.heappop(heap)
            if i not in live or j not in live:
                continue
            if len(live) <= most and added > _WASTE * total:
                break
            points = np.concatenate([live[i].points, live[j].points])
            fills = _filled(points, free)
            if (fills > filled[i] + filled[j] + _FILL).any():
                continue
            both = solid_of(points, live[i].link)
            if any(_reaches(both, other) for other in _near(both, *others[both.link])):
                continue
            filled[fresh] = fills
            homes[fresh] = homes[i] & homes[j]
            bounds[fresh] = np.stack([both.points.min(axis=0), both.points.max(axis=0)])
            del live[i], live[j]
            live[fresh] = both
            offer(fresh, count, 0)
            fresh += 1
    return [live[k] for k in sorted(live)]


def squared(solids: Sequence[Solid], parts: Sequence[Part]) -> list[Solid]:
    """Boxes for those that are nearly boxes, as boards with cut edges or round corners are: their contacts are the
    cheapest and the most steady.

    A box stays in a prism that holds the part, a little narrower than the part where need be, and out of what parts of
    other links stay out of. It is as high as the part and stands on the same level.
    """
    found, prisms = list(solids), [_Home(part) for part in parts]
    for k, solid in enumerate(solids):
        low, high = solid.points.min(axis=0), solid.points.max(axis=0)
        if solid.box is not None or solid.volume < _NEARLY * float(np.prod(high - low)):
            continue
        middle, half = (low + high) / 2, (high - low) / 2
        for share in _NARROWER:
            if (1 - share) * half[:2].max() > _NARROWED:
                break
            corners = middle + _CORNERS * half * [share, share, 1.0]
            if _homes(corners, prisms):
                box = solid_of(corners, solid.link, solid.handle)
                if not any(s.link != solid.link and _reaches(box, s) and not _reaches(solid, s) for s in found):
                    found[k] = box
                break
    return found


def _limited(solid: Solid) -> Solid:
    """The part with as few vertices as all simulators take."""
    few = fewer_vertices(solid.points)
    return solid if len(few) == len(solid.points) else solid_of(few, solid.link, solid.handle)


def _hull_volume(points: np.ndarray) -> float:
    """Volume of the hull of points [N, 3], which tells what to merge: quicker than to make the merged part."""
    import manifold3d

    volume = manifold3d.Manifold.hull_points(points).volume()
    return volume if volume > THINNEST**3 else solid_of(points, 0).volume


class _Room:
    """A convex room by its corners [N, 3]: its box and its solid."""

    def __init__(self, corners: np.ndarray):
        import manifold3d

        self.low, self.high = corners.min(axis=0), corners.max(axis=0)
        self.solid = manifold3d.Manifold.hull_points(corners)
        self.volume = self.solid.volume()


def _filled(points: np.ndarray, rooms: Sequence[_Room]) -> np.ndarray:
    """The share of each room that the hull of points [N, 3] fills, [R]."""
    import manifold3d

    low, high = points.min(axis=0), points.max(axis=0)
    shares, body = np.zeros(len(rooms)), None
    for k, room in enumerate(rooms):
        if (np.minimum(high, room.high) - np.maximum(low, room.low)).min() > _TOUCH:
            body = manifold3d.Manifold.hull_points(points) if body is None else body
            shares[k] = (body ^ room.solid).volume() / room.volume
    return shares


def _near(one: Solid, others: Sequence[Solid], spans: np.ndarray) -> list[Solid]:
    """Those of some parts whose boxes, ``spans`` [N, 2, 3], reach into that of a part."""
    low, high = one.points.min(axis=0), one.points.max(axis=0)
    shared = (np.minimum(spans[:, 1], high) - np.maximum(spans[:, 0], low)).min(axis=1)
    return [others[k] for k in np.flatnonzero(shared >= _TOUCH).tolist()]


def _reaches(one: Solid, two: Solid) -> bool:
    """Whether no face of either parts the two, by ``_TOUCH`` at least; in doubt they do reach into each other."""
    low, high = np.maximum(one.points.min(0), two.points.min(0)), np.minimum(one.points.max(0), two.points.max(0))
    if (high - low).min() < _TOUCH:
        return False
    for a, b in ((one, two), (two, one)):
        planes = a.planes
        if (b.points @ planes[:, :3].T + planes[:, 3]).min(axis=0).max() > -_TOUCH:
            return False
    return True


class _Home:
    """A prism that parts may lie in: the outward normals [2, E] of its sides with their offsets, and its heights."""

    def __init__(self, part: Part):
        plan = np.asarray(part.polygon, dtype=float)
        edge = np.roll(plan, -1, axis=0) - plan
        normal = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
        self.normals, self.offsets = normal.T, (normal * plan).sum(axis=1)
        self.low, self.high = part.z

    def holds(self, plan: np.ndarray, low: float, high: float) -> bool:
        """Whether points [N, 2] between two heights lie in it."""
        if max(self.low - low, high - self.high) > _SLACK:
            return False
        return bool((plan @ self.normals - self.offsets).max() <= _SLACK)


def _homes(points: np.ndarray, prisms: Sequence[_Home]) -> frozenset[int]:
    """Which prisms contain all points."""
    plan, low, high = points[:, :2], float(points[:, 2].min()), float(points[:, 2].max())
    return frozenset(k for k, prism in enumerate(prisms) if prism.holds(plan, low, high))
