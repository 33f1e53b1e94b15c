"""What an objective is worth, in float64 and by arithmetic that the kernels have no part in."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import user
from sceneweaver.scene import InputError, Scene

from .objective import MANHATTAN, ObjectiveTerm, check_objective, feature_of
from .objective_members import Place, fluxes_of, members_of, pins_of, places_of
from .problem import Problem
from .shortest_ways import shortest_ways

LEAST_DISTANCE = 0.1  # [m] below which a source of light gives no more


def objective_of(scene: Scene | Problem, terms: Sequence[ObjectiveTerm], poses: np.ndarray) -> np.ndarray:
    """The value [B] float64 of an objective at layouts, whether these are valid or not.

    Args:
        scene: a scene, or the problem of a single one.
        terms: the objective.
        poses: world poses (x, y, z, yaw) [B, N, 4], objects in the scene's order.

    Raises:
        InputError: a term names what the scene does not have, or the poses have another shape.

    Examples:
        >>> import numpy as np, sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> poses = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]])
        >>> sw.objective_of(scene, [sw.ObjectiveTerm("flow", ("bed", "bed"))], poses)
        array([0.])
    """
    return term_values(scene, terms, poses).sum(axis=1)


def term_values(scene: Scene | Problem, terms: Sequence[ObjectiveTerm], poses: np.ndarray) -> np.ndarray:
    """The weighted value [B, T] float64 of every term; arguments and errors as for `objective_of`."""
    return ObjectiveValues(scene, terms)(poses)


class ObjectiveValues:
    """An objective of a scene, made ready for many layouts; arguments and errors as for `objective_of`.

    Examples:
        >>> import numpy as np, sceneweaver as sw
        >>> from sceneweaver.layout.objective_values import ObjectiveValues
        >>> scene = sw.Scene.example("bedroom")
        >>> values = ObjectiveValues(scene, [sw.ObjectiveTerm("flow", ("bed", "bed"))])
        >>> values(np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]]))
        array([[0.]])
    """

    def __init__(self, scene: Scene | Problem, terms: Sequence[ObjectiveTerm]) -> None:
        if isinstance(scene, Problem):
            if len(scene.scenes) != 1:
                raise InputError(f"objective: a problem of one scene is needed, not of {len(scene.scenes)}")
            scene = scene.scenes[0]
        check_objective(scene, terms)
        self.scene, self.terms = scene, list(terms)
        self._nets = _Nets(scene, self.terms)

    def __call__(self, poses: np.ndarray) -> np.ndarray:
        """The weighted value [B, T] of every term at poses [B, N, 4]."""
        layouts = np.asarray(poses, dtype=np.float64)
        count = len(self.scene.objects)
        if layouts.ndim != 3 or layouts.shape[1] < count or layouts.shape[2] != 4:
            raise InputError(f"poses: an array of shape {layouts.shape} is not [B, {count}, 4]")
        values = np.zeros((len(layouts), len(self.terms)))
        self._nets.add_to(values, layouts)
        others = [(k, term) for k, term in enumerate(self.terms) if term.kind not in _Nets.KINDS]
        look = _Look(self.scene, layouts)
        for k, term in others:
            values[:, k] = term.weight * _VALUES[term.kind](look, term)
        return values


class _Nets:
    """The terms that look at pins alone, all at once: one by one they take most of the time there is."""

    KINDS = ("wire_length", "flow")
    ROWS = 64  # layouts at a time, so that all pins of them fit into a cache

    def __init__(self, scene: Scene, terms: Sequence[ObjectiveTerm]) -> None:
        index, places = {name: i for i, name in enumerate(scene.ids)}, places_of(scene)
        self.columns = [k for k, term in enumerate(terms) if term.kind in self.KINDS]
        own = [terms[k] for k in self.columns]
        objects, pins, first = [], [], []
        for term in own:
            first.append(len(objects))
            offsets = term.pins if term.kind == "wire_length" else [(0.0, 0.0)] * len(term.objects)
            for name, (x, y) in zip(term.objects, offsets, strict=True):
                if name not in index:  # of a place x is into the room
                    (mx, my), (c, s) = places[name].middle, places[name].inward
                    x, y = mx + c * x - s * y, my + s * x + c * y
                objects.append(index.get(name, -1))
                pins.append((x, y))
        self.objects, self.first = np.array(objects, dtype=int), np.array(first, dtype=int)
        self.pins = np.array(pins, dtype=np.float64).reshape(-1, 2)
        self.weights = np.array([term.weight for term in own])
        flows = [(i, term.value("metric")) for i, term in enumerate(own) if term.kind == "flow"]
        self.flows = {m: np.array([i for i, own in flows if own == m], dtype=int) for m in {m for _, m in flows}}

    def add_to(self, values: np.ndarray, poses: np.ndarray) -> None:
        if not self.columns:
            return
        for row in range(0, len(poses), self.ROWS):
            values[row : row + self.ROWS, self.columns] = self._of(poses[row : row + self.ROWS]) * self.weights

    def _of(self, poses: np.ndarray) -> np.ndarray:
        px, py, _, yaw = np.moveaxis(poses[:, self.objects], -1, 0)
        still = self.objects < 0
        c, s, (x, y) = np.cos(yaw), np.sin(yaw), self.pins.T
        at = np.stack([px + c * x - s * y, py + s * x + c * y], axis=-1)  # [B, P, 2]
        at[:, still] = self.pins[still]
        wide = np.maximum.reduceat(at, self.first, axis=1) - np.minimum.reduceat(at, self.first, axis=1)
        found = wide.sum(axis=-1)
        for metric, rows in self.flows.items():
            found[:, rows] = _length(at[:, self.first[rows] + 1] - at[:, self.first[rows]], metric)
        return found


class _Look:
    """Layouts of a scene as terms look at them."""

    def __init__(self, scene: Scene, poses: np.ndarray) -> None:
        self.scene, self.poses = scene, poses
        self.index = {name: i for i, name in enumerate(scene.ids)}
        self.places = places_of(scene)

    def pins(self, term: ObjectiveTerm) -> np.ndarray:
        """Pins [B, M, 3] of a term's members in the room's frame."""
        points = []
        for name, (x, y, z) in zip(members_of(self.scene, term), pins_of(self.scene, term), strict=True):
            if name in self.index:
                px, py, pz, yaw = np.moveaxis(self.poses[:, self.index[name]], -1, 0)
                c, s = np.cos(yaw), np.sin(yaw)
                points.append(np.stack([px + c * x - s * y, py + s * x + c * y, pz + z], axis=-1))
            else:
                place = self.places[name]
                (mx, my), (c, s) = place.middle, place.inward
                at = (mx + c * x - s * y, my + s * x + c * y, z)
                points.append(np.broadcast_to(np.array(at), (len(self.poses), 3)))
        return np.stack(points, axis=1)


def _length(way: np.ndarray, metric: str) -> np.ndarray:
    return np.abs(way).sum(axis=-1) if metric == MANHATTAN else np.hypot(way[..., 0], way[..., 1])


def _walking(look: _Look, term: ObjectiveTerm) -> np.ndarray:
    return shortest_ways(look.scene, look.poses, look.pins(term)[..., :2])


def _cost(look: _Look, term: ObjectiveTerm) -> np.ndarray:
    at = look.pins(term)[:, 0, :2]
    if term.value("direction") is not None:
        return at @ np.asarray(term.value("direction"), dtype=np.float64)
    return _length(at - np.asarray(term.value("point"), dtype=np.float64), term.value("metric"))


def _exposed_wall(look: _Look, term: ObjectiveTerm) -> np.ndarray:
    names, depth = members_of(look.scene, term), float(term.value("depth"))
    walls = [look.places[name] for name in names if name in look.places]
    objects = [look.index[name] for name in names if name in look.index]
    return np.array([sum(_bare(look, wall, poses[objects], objects, depth) for wall in walls) for poses in look.poses])


def _bare(look: _Look, wall: Place, poses: np.ndarray, objects: Sequence[int], depth: float) -> float:
    """Length of a wall that no box of the objects comes near."""
    covers = []
    for i, (x, y, _z, yaw) in zip(objects, poses, strict=True):
        deep, wide = look.scene.objects[i].size[0] / 2, look.scene.objects[i].size[1] / 2
        c, s = math.cos(yaw), math.sin(yaw)
        corners = np.array([(x + c * u - s * v, y + s * u + c * v) for u in (-deep, deep) for v in (-wide, wide)])
        off = (corners - wall.middle) @ np.array(wall.inward)
        if off.min() <= depth and off.max() >= 0.0:
            along = (corners - wall.middle) @ np.array((-wall.inward[1], wall.inward[0]))
            covers.append((max(along.min(), -wall.half), min(along.max(), wall.half)))
    total, reached = 0.0, -wall.half
    for first, last in sorted(covers):
        if last >= first:
            total += max(first - reached, 0.0)
            reached = max(reached, last)
    return total + max(wall.half - reached, 0.0)


def _light(look: _Look, term: ObjectiveTerm) -> np.ndarray:
    at = look.pins(term)
    lux = np.zeros(len(at))
    for k, name in enumerate(term.objects[1:], start=1):
        way = at[:, k] - at[:, 0]
        distance = np.maximum(np.linalg.norm(way, axis=-1), LEAST_DISTANCE)
        flux = fluxes_of(look.scene, term)[k]
        if name in look.places:
            facing = -(way[:, :2] @ np.array(look.places[name].inward)) / distance
            candela = flux / math.pi * np.maximum(facing, 0.0)
        else:
            candela = np.full(len(at), flux / (4.0 * math.pi))
        lux += candela * np.maximum(way[:, 2], 0.0) / distance / distance**2
    return np.maximum(1.0 - lux / float(term.value("target")), 0.0)


def _user(look: _Look, term: ObjectiveTerm) -> np.ndarray:
    residual = user.residuals()[feature_of(term)].func
    assert residual is not None  # of built-in functions alone
    a, b = look.index[term.objects[0]], look.index[term.objects[-1]]
    sizes = [wp.vec3(*look.scene.objects[i].size) for i in (a, b)]
    values = [*map(float, term.value("values")), 0.0, 0.0, 0.0, 0.0][:4]
    return np.array([float(residual(wp.vec4(*p[a]), wp.vec4(*p[b]), *sizes, wp.vec4(*values))) for p in look.poses])


_VALUES: dict[str, Callable[[_Look, ObjectiveTerm], Any]] = {
    "walking": _walking,
    "cost": _cost,
    "exposed_wall": _exposed_wall,
    "light": _light,
    "user": _user,
}
