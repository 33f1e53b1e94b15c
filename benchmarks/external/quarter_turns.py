"""A layout problem as rectangles at quarter turns and linear conditions: what integer programs and grids see.

Made from the engine's compiled scene, so that rivals know what the engine knows, as far as it can be said this way:

- a body is the bounding rectangles of its collision parts (and of what it carries) at four yaws, square to the longest
  wall; an object whose yaw is not free has its own. Parts that share no height do not meet. Heights stay as they are;
- the hull of the room and the sides of zones count exactly, pockets of the outline and doors as rectangles;
- a relation is a choice of linear intervals, one for each of its options, pair of turns, and side of a distance.
  Distances beyond a corner are cut to 1/sqrt(2) along both axes; angles that are free within some degrees to their
  middle. Positions between or around others (`FEATURE_BETWEEN`, `FEATURE_ASIDE`, `FEATURE_SPREAD`) and relations that
  users define are left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from weakref import WeakKeyDictionary

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import relative
from sceneweaver.kernels import tables as k
from sceneweaver.layout import Problem
from sceneweaver.layout.compile import LayoutProblem, compile_scene

from .linear_relations import relation_of
from .rectangles import Apart, Body, Wanted, box_of, turn_by


@dataclass
class QuarterTurns:
    """A scene in the frame of its longest wall, turned by ``angle``. Bodies are numbered as in ``bodies``.

    Attributes:
        planes: [K, 3] as (n, c) with n . x >= c inside of the room's hull.
        box: of the room, x0, y0, x1, y1 [m].
        left_out: how many hard relations cannot be said.
    """

    angle: float
    bodies: list[Body]
    planes: np.ndarray
    box: tuple[float, float, float, float]
    apart: list[Apart]
    relations: list[Wanted]
    left_out: int
    names: dict[str, int] = field(default_factory=dict)  # of bodies, by id of the object
    points: dict[str, np.ndarray] = field(default_factory=dict)  # middles of what stands still, doors and windows

    def bounds(self, body: int, turn: int) -> np.ndarray:
        """Levels [K] with n . p >= level for the body's pose at a turn."""
        return self.planes[:, 2] - (self.bodies[body].corners[turn] @ self.planes[:, :2].T).min(axis=0)

    def spot(self, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Positions [B, n, 2] and nearest turns [B, n] of the bodies in poses [B, N, 4]."""
        index = [body.index for body in self.bodies]
        xy = poses[:, index, :2] @ turn_by(-self.angle).T
        yaw = poses[:, index, 3] - self.angle
        turns = [np.abs(wrap_angle(yaw[:, i, None] - b.yaws)).argmin(axis=1) for i, b in enumerate(self.bodies)]
        return xy, np.array(turns, dtype=int).reshape(len(self.bodies), len(poses)).T

    def placed(self, poses: np.ndarray, xy: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Poses [B, N, 4] with the bodies at positions [B, n, 2] and turns [B, n]."""
        found = np.array(poses, dtype=np.float64)
        index = [body.index for body in self.bodies]
        found[:, index, :2] = xy @ turn_by(self.angle).T
        yaws = [body.yaws[turns[:, i]] for i, body in enumerate(self.bodies)]
        found[:, index, 3] = wrap_angle(np.array(yaws).reshape(len(index), -1).T + self.angle)
        return found


def quarter_turns(problem: Problem, given: np.ndarray | None = None) -> QuarterTurns:
    """The view of a problem of one scene, with what is carried as it stands in a layout ``given`` [N, 4].

    Without one what is carried does not count. Where nothing is carried the view is made once.
    """
    if given is not None and (problem.roots[0] != np.arange(problem.objects)).any():
        return _view(problem, given)
    if problem not in _VIEWS:
        _VIEWS[problem] = _view(problem, None)
    return _VIEWS[problem]


_VIEWS: WeakKeyDictionary[Problem, QuarterTurns] = WeakKeyDictionary()


def _view(problem: Problem, given: np.ndarray | None) -> QuarterTurns:
    room, scene = compile_scene(problem.scenes[0]).room, problem.scenes[0]
    walls = room.region.walls
    along = max(walls, key=lambda wall: wall.length).along
    angle = math.atan2(along[1], along[0]) % (math.pi / 2)
    back = turn_by(-angle)
    movable = [i for i in range(room.size) if problem.free[0, i, :2].all() and room.roots[i] == i]
    number = {index: i for i, index in enumerate(movable)}
    bodies = [_body(room, index, bool(problem.free[0, index, 3]), angle, given) for index in movable]
    planes = np.array([(*(back @ row[:2]), row[2]) for row in room.region.planes])
    box = box_of(np.array([wall.start for wall in walls]) @ back.T)
    apart = [*_between(room, bodies), *_still(room, bodies, number, back)]
    said, left_out = [], 0
    for relation in room.relations:
        if relation.weight <= 0 and not relation.fault:
            continue
        wanted = relation_of(room, relation, bodies, number, angle)
        left_out += wanted is None and relation.fault != 0
        said += [] if wanted is None or not wanted.choices else [wanted]
    view = QuarterTurns(
        angle, bodies, planes, (float(box[0]), float(box[1]), float(box[2]), float(box[3])), apart, said, left_out
    )
    view.names = {room.ids[index]: i for index, i in number.items()}
    for i, name in enumerate(room.ids):
        if i not in number:
            view.points[name] = back @ room.home[i, :2]
    for opening in scene.room.openings:
        wall = walls[opening.wall]
        view.points[opening.id] = back @ np.array(wall.point(opening.offset + opening.width / 2))
    return view


def _body(room: LayoutProblem, index: int, turns: bool, angle: float, given: np.ndarray | None) -> Body:
    base = 0.0 if turns else room.home[index, 3] - angle
    yaws = base + np.arange(4 if turns else 1) * math.pi / 2
    frames = np.stack([turn_by(yaw) for yaw in yaws])
    parts: dict[str, list[tuple[np.ndarray, np.ndarray]]] = {"solids": [], "zones": []}
    for j in np.flatnonzero(room.roots == index):
        if j != index and given is None:
            continue
        away = relative(given[j], given[index]) if given is not None else np.zeros(4)
        height = room.home[index, 2] if given is None else given[j, 2]
        for kind, found in parts.items():
            for prism in getattr(room, kind)[j]:
                found.append((prism.polygon @ turn_by(away[3]).T + away[:2], np.array(prism.z) + height))
    boxes, heights = {}, {}
    for kind, found in parts.items():
        turned = [[box_of(polygon @ frame.T) for frame in frames] for polygon, _ in found]
        boxes[kind] = np.array(turned).reshape(-1, len(yaws), 4)
        heights[kind] = np.array([z for _, z in found]).reshape(-1, 2)
    corners = np.concatenate([polygon for polygon, _ in parts["solids"]])
    outline = np.concatenate(room.footprints[index])
    return Body(
        index,
        yaws,
        boxes["solids"],
        heights["solids"],
        boxes["zones"],
        heights["zones"],
        np.stack([corners @ frame.T for frame in frames]),
        np.stack([box_of(outline @ frame.T) for frame in frames]),
    )


def _meet(z: np.ndarray, other: np.ndarray) -> bool:
    return min(z[1], other[1]) - max(z[0], other[0]) > 1e-3


def _between(room: LayoutProblem, bodies: list[Body]) -> Iterator[Apart]:
    """What two bodies have to keep free of each other."""
    for i, a in enumerate(bodies):
        for j in range(i + 1, len(bodies)):
            b, flags = bodies[j], int(room.flags[a.index, bodies[j].index])
            kinds = [
                (k.PAIR_COLLIDE, a.solids, a.solid_z, b.solids, b.solid_z),
                (k.PAIR_ZONE_OF_FIRST, a.zones, a.zone_z, b.solids, b.solid_z),
                (k.PAIR_ZONE_OF_SECOND, a.solids, a.solid_z, b.zones, b.zone_z),
            ]
            for bit, ours, our_z, theirs, their_z in kinds:
                if flags & bit:
                    pairs = [(p, q) for p in range(len(ours)) for q in range(len(theirs))]
                    yield from (Apart(i, ours[p], j, theirs[q]) for p, q in pairs if _meet(our_z[p], their_z[q]))


def _still(room: LayoutProblem, bodies: list[Body], number: dict[int, int], back: np.ndarray) -> Iterator[Apart]:
    """What bodies have to keep free of pockets, doors, and objects that do not move."""
    region = room.region
    walls = [(prism, "wall") for prism in region.solids] + [(prism, "opening") for prism in region.openings]
    for i, a in enumerate(bodies):
        for prism, kind in walls:
            if kind == "opening" and not room.clear[a.index]:
                continue
            box = box_of(prism.polygon @ back.T)[None]
            for ours, z in zip(a.solids, a.solid_z, strict=True):
                if _meet(z, np.array(prism.z)):
                    yield Apart(i, ours, -1, box)
        for j in range(room.size):
            if int(room.roots[j]) in number:
                continue
            flags, frame = int(room.flags[a.index, j]), back @ turn_by(room.home[j, 3])
            for bit, ours, our_z, theirs in (
                (k.PAIR_COLLIDE, a.solids, a.solid_z, room.solids[j]),
                (k.PAIR_ZONE_OF_FIRST, a.zones, a.zone_z, room.solids[j]),
                (k.PAIR_ZONE_OF_SECOND, a.solids, a.solid_z, room.zones[j]),
            ):
                for prism in theirs if flags & bit else ():
                    box = box_of(prism.polygon @ frame.T + back @ room.home[j, :2])[None]
                    for mine, z in zip(ours, our_z, strict=True):
                        if _meet(z, np.array(prism.z) + room.home[j, 2]):
                            yield Apart(i, mine, -1, box)
