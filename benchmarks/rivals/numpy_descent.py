"""Random-restart penalty descent in NumPy: the straightforward way, for scale."""

from __future__ import annotations

import numpy as np

from benchmarks.rivals.base import Rival, register
from benchmarks.rivals.boxes import Boxes, Pairs, axes, overlap_loss
from benchmarks.rivals.prisms import tied
from benchmarks.rivals.pulls import ARM, Pull, Room, build
from benchmarks.starts import carry, movable, random_poses
from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import Scene, Window

STEPS = 300
RUNS = 3  # the first and two restarts
RATE = (0.06, 0.002)  # of Adam, at the first and the last step
MARGIN = 0.005  # [m]
SOLVED = 1e-5
LOOK, SLACK = 5, 1.2  # steps between looks at who is near; [m] that two may close in on each other meanwhile

Row = tuple[int, tuple[float, float], tuple[float, float], tuple[float, float], float]


class Model:
    """Losses of a scene's floor objects, as boxes, at poses [B, n, 3] (x, y, yaw)."""

    def __init__(self, scene: Scene) -> None:
        self.floor = movable(scene)
        self.size = np.array([scene.objects[i].size for i in self.floor]).reshape(-1, 3)
        self.pulls: list[tuple[int, int, Pull]] = build(scene, self.floor)
        self.boxes, pairs = _boxes(scene, self.floor)
        self.pairs = self.active = Pairs(self.boxes, pairs)
        self.planes = hull_planes(scene)

    def look(self, x: np.ndarray) -> None:
        """Leave out pairs that are too far apart to touch before the next look."""
        self.active = self.pairs.near(self.boxes, x, SLACK)

    def loss(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Loss [B] and its gradient [B, n, 3]."""
        gradient = np.zeros_like(x)
        loss = overlap_loss(self.boxes, self.active, x, MARGIN, gradient) + self._bounds(x, gradient)
        for a, b, pull in self.pulls:
            r = pull(x)
            loss = loss + (r * r).sum(axis=1)
            gradient[:, a] += 2 * r * (1.0, 1.0, ARM)
            if b >= 0:
                gradient[:, b, :2] -= 2 * r[:, :2]
        return loss, gradient

    def _bounds(self, x: np.ndarray, gradient: np.ndarray) -> np.ndarray:
        frame, half = axes(x[..., 2]), self.size[:, :2] / 2
        loss = np.zeros(len(x))
        for n, c in self.planes:
            along = frame @ n
            out = np.maximum((np.abs(along) * half).sum(-1) + MARGIN - (x[..., :2] @ n - c), 0.0)
            turned = np.stack([-frame[..., 1], frame[..., 0]], -1) @ n
            gradient[..., :2] -= 2 * out[..., None] * n
            gradient[..., 2] += 2 * out * (half * np.sign(along) * turned).sum(-1)
            loss += (out * out).sum(axis=1)
        return loss


def hull_planes(scene: Scene) -> list[tuple[np.ndarray, float]]:
    """Half planes (n, c) of the outline's convex hull: n . x >= c inside."""
    walls = walls_of(convex_hull(scene.room.outline))
    return [(np.array(wall.inward), dot(wall.inward, wall.start)) for wall in walls]


def _boxes(scene: Scene, floor: np.ndarray) -> tuple[Boxes, np.ndarray]:
    """Boxes of bodies, hard zones, openings, pockets and fixed objects, and the pairs that must not overlap."""
    rows: list[Row] = [
        (k, (0.0, 0.0), (o.size[0] / 2, o.size[1] / 2), (0.0, o.size[2]), 0.0)
        for k, o in enumerate(scene.objects[i] for i in floor)
    ]
    bodies = len(rows)
    rows += _zones(scene, floor)
    zones = range(bodies, len(rows))
    rows += _fixed(scene) + _openings(scene) + _pockets(scene)
    owner, *rest = (np.array(column) for column in zip(*rows, strict=True))
    boxes = Boxes(owner, *(np.asarray(c, dtype=float) for c in rest))
    exempt, item = tied(scene), [*floor, -1]  # the item of an owner; the room, -1, has none
    pairs = [
        (i, j)
        for j in range(len(rows))
        for i in range(min(j, bodies))
        if owner[i] != owner[j]
        and not (j in zones and (item[owner[i]], item[owner[j]]) in exempt)
        and min(boxes.z[i, 1], boxes.z[j, 1]) > max(boxes.z[i, 0], boxes.z[j, 0])
    ]
    return boxes, np.array(pairs, dtype=int).reshape(-1, 2)


def _between(low: np.ndarray, high: np.ndarray) -> tuple[tuple[float, float], tuple[float, float]]:
    """Middle and half size of a box from corner to corner."""
    middle, half = (low + high) / 2, (high - low) / 2
    return (float(middle[0]), float(middle[1])), (float(half[0]), float(half[1]))


def _zones(scene: Scene, floor: np.ndarray) -> list[Row]:
    return [
        (k, *_between(np.min(zone.polygon, axis=0), np.max(zone.polygon, axis=0)), zone.z, 0.0)
        for k, i in enumerate(floor)
        for zone in scene.objects[i].zones
        if zone.hard
    ]


def _fixed(scene: Scene) -> list[Row]:
    rows: list[Row] = []
    for o in scene.objects:
        if o.fixed or o.mount in ("wall", "ceiling"):
            x, y, z = o.pose.position
            rows.append((-1, (x, y), (o.size[0] / 2, o.size[1] / 2), (z, z + o.size[2]), o.pose.yaw))
    return rows


def _openings(scene: Scene) -> list[Row]:
    """The clear space of doors and windows."""
    room, rows = Room(scene), []
    for opening in (*scene.room.doors, *scene.room.windows):
        if isinstance(opening, Window):
            depth, z = 0.3, (opening.sill, opening.sill + opening.height)
        else:
            depth, z = opening.width if opening.swing.startswith("in") else 0.6, (0.0, opening.height)
        t, n = room.t[opening.wall], room.n[opening.wall]
        middle = room.p[opening.wall] + (opening.offset + opening.width / 2) * t + depth / 2 * n
        yaw = float(np.arctan2(t[1], t[0]))
        rows.append((-1, (float(middle[0]), float(middle[1])), (opening.width / 2, depth / 2), z, yaw))
    return rows


def _pockets(scene: Scene) -> list[Row]:
    """What the convex hull has more than the room, as boxes."""
    import shapely

    room = shapely.Polygon(scene.room.outline)
    outside, rows = room.convex_hull.difference(room), []
    for part in getattr(outside, "geoms", [outside]):
        if part.area > 1e-9:
            c = np.array(part.minimum_rotated_rectangle.exterior.coords[:4])
            edge, other = c[1] - c[0], c[2] - c[1]
            middle, half = c.mean(axis=0), (float(np.linalg.norm(edge)) / 2, float(np.linalg.norm(other)) / 2)
            yaw = float(np.arctan2(edge[1], edge[0]))
            rows.append((-1, (float(middle[0]), float(middle[1])), half, (0.0, scene.room.height), yaw))
    return rows


def descend(model: Model, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Adam from poses [B, n, 3]: the best poses passed and their loss [B]."""
    best, best_loss = x.copy(), np.full(len(x), np.inf)
    mean, square = np.zeros_like(x), np.zeros_like(x)
    for step in range(STEPS + 1):
        if step % LOOK == 0:
            model.look(x)
        loss, g = model.loss(x)
        better = loss < best_loss
        best[better], best_loss[better] = x[better], loss[better]
        mean = 0.9 * mean + 0.1 * g
        square = 0.99 * square + 0.01 * g * g
        rate = RATE[0] * (RATE[1] / RATE[0]) ** (step / STEPS)
        scale = np.sqrt(square / (1 - 0.99 ** (step + 1))) + 1e-8
        x = x - rate * mean / (1 - 0.9 ** (step + 1)) / scale
    return best, best_loss


def solve(scene: Scene, starts: np.ndarray, seed: int, device: str) -> np.ndarray:
    """Descend from the starts; what is not solved starts again from anywhere."""
    model = Model(scene)
    poses = starts.astype(np.float64)
    plane = np.array([0, 1, 3])
    best_loss = np.full(len(poses), np.inf)
    for run in range(RUNS):
        left = np.flatnonzero(best_loss > SOLVED)
        if not len(left) or not len(model.floor):
            break
        begin = poses[left] if run == 0 else random_poses(scene, len(left), seed + 7919 * run)
        found, loss = descend(model, begin[:, model.floor][:, :, plane])
        better = loss < best_loss[left]
        where = left[better]
        best_loss[where] = loss[better]
        poses[np.ix_(where, model.floor, plane)] = found[better]
    return carry(scene, poses)


def _most(objects: int, device: str) -> int:
    return 128 if objects <= 19 else 32 if objects <= 30 else 8 if objects <= 70 else 4


register(
    Rival(
        name="numpy descent",
        about="random-restart penalty descent (Adam, 300 steps, at most two restarts) on boxes with hinge losses, one "
        "core; what stands on surfaces is carried along as the witness has it.",
        solve=solve,
        missing=lambda device: None,
        most=_most,
    )
)
