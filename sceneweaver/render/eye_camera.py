"""Cameras at eye level: from the door and from the two corners that show most of a room."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.angles import cross
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Scene, SceneObject

from .camera import Camera
from .room_probe import (
    CEILING,
    DOOR,
    FLOOR,
    NOTHING,
    WALL,
    WINDOW,
    Glimpse,
    Probe,
    box_corners,
    has_back,
    is_key,
    weight,
)

EYE_VIEWS = ("eye-door", "eye-corner", "eye-corner2")

EYE_HEIGHT = 1.5
"""Height of the camera [m]; lower under a low ceiling."""

FOCAL_LENGTHS = (24.0, 28.0)
"""Of the lens in a small and in a large room [mm, of 35 mm film, which is 36 mm wide]."""

SHIFTS = (-0.12, -0.35, -0.65)
"""How far the lens may be shifted, in half heights of the picture: more floor than ceiling; the last in tiny rooms."""

_TINY, _SMALL, _LARGE = 4.0, 5.0, 10.0  # diagonals [m]: of tiny rooms, and of those with the one and the other lens
_ROUGH, _FINE = (48, 36), (160, 120)  # pixels of the first and the second look
_FINALISTS = 10  # cameras of each kind that get a second look
_CLEAR = 0.5  # what is nearer than this to the camera [m] is in its way
_HEAD = 0.22  # radius [m] of what must be free around the camera
_CELL = 0.4  # side [m] of the cells in which the floor is counted
_FULL = {"floor": 0.05, "wall": 0.015, "ceiling": 0.01, "surface": 0.01}
"""Shares of the picture from which on a thing counts as shown, by what holds it; more of what is key."""
_KEY_FULL = 0.12


@dataclass(frozen=True)
class _Candidate:
    """A camera, and the corner or door that it stands in."""

    camera: Camera
    place: tuple[str, int]


@dataclass(frozen=True)
class _Judged:
    """A candidate's worth by itself, and how well it shows each object, [N] in 0..1."""

    candidate: _Candidate
    worth: float
    shown: np.ndarray


def eye_cameras(scene: Scene, aspect: float = 4 / 3) -> dict[str, Camera]:
    """The camera of each of `EYE_VIEWS`: level, 24 to 28 mm, chosen by what a look through each candidate shows.

    A room without doors is entered through the middle of a wall.
    """
    doors = _best(scene, Probe(scene, doors=False), _free(scene, [*_door_candidates(scene, aspect)]))
    corners = _best(scene, Probe(scene), _free(scene, [*_corner_candidates(scene, aspect)]))
    weights = np.array([weight(thing) for thing in scene.objects])
    chosen = [_first(doors, [], weights)]
    for _ in range(2):
        chosen.append(_first(corners, chosen, weights))
    return {view: one.candidate.camera for view, one in zip(EYE_VIEWS, chosen, strict=True)}


def _first(judged: list[_Judged], chosen: list[_Judged], weights: np.ndarray) -> _Judged:
    """The best of some, beside those chosen before: what these show well counts less."""
    before = np.max([one.shown for one in chosen], axis=0, initial=0.0)
    taken = [one.candidate.place for one in chosen]

    def worth(one: _Judged) -> float:
        more = float(weights @ np.maximum(one.shown - before, 0.0)) / max(float(weights.sum()), 1e-9)
        again = one.candidate.place in taken
        alike = max((_likeness(one.candidate.camera, other.candidate.camera) for other in chosen), default=0.0)
        return one.worth + (0.4 * more if chosen else 0.0) - 0.5 * again - 0.5 * alike

    return max(judged, key=lambda one: round(worth(one), 6))


def _likeness(one: Camera, other: Camera) -> float:
    """1 for cameras at one place that look the same way, 0 for such as are far apart or look differently."""
    apart = math.dist(one.eye, other.eye) / 1.5
    turned = math.acos(float(np.clip(one.axis @ other.axis, -1.0, 1.0))) / 0.8
    return max(0.0, 1.0 - math.hypot(apart, turned))


def _free(scene: Scene, candidates: list[_Candidate]) -> list[_Candidate]:
    """The candidates around whose lens nothing is; all where there is none."""
    import shapely

    height = candidates[0].camera.eye[2]
    plans = [
        thing.pose.frame.to_world(np.asarray(part.polygon))
        for thing in scene.objects
        for part in thing.solids
        if part.z[0] + thing.pose.position[2] < height + _HEAD and part.z[1] + thing.pose.position[2] > height - _HEAD
    ]
    taken = shapely.union_all([shapely.MultiPoint(plan).convex_hull.buffer(_HEAD) for plan in plans])
    eyes = np.array([one.camera.eye for one in candidates])
    free = ~shapely.contains_xy(taken, eyes[:, 0], eyes[:, 1])
    return [one for one, is_free in zip(candidates, free, strict=True) if is_free] or candidates


def _best(scene: Scene, probe: Probe, candidates: list[_Candidate]) -> list[_Judged]:
    """The candidates that deserve a second look, judged by it; of those in one place the better half only."""

    def judged(some: list[_Candidate], size: tuple[int, int]) -> list[_Judged]:
        glimpses = probe.look([one.camera for one in some], *size)
        return [_judge(scene, one, glimpse) for one, glimpse in zip(some, glimpses, strict=True)]

    first = sorted(judged(candidates, _ROUGH), key=lambda one: -round(one.worth, 6))
    kept: list[_Candidate] = []
    for one in first:
        same = sum(other.place == one.candidate.place for other in kept)
        if same < 4 and len(kept) < 2 * _FINALISTS:
            kept.append(one.candidate)
    return judged(kept, _FINE)


def _judge(scene: Scene, one: _Candidate, glimpse: Glimpse) -> _Judged:
    camera, ids, distance = one.camera, glimpse.ids, glimpse.distance
    share = glimpse.pixels(len(scene.objects)) / ids.size
    eye = np.asarray(camera.eye[:2])
    shown, weights, fronts = np.zeros(len(share)), np.zeros(len(share)), np.ones(len(share))
    for k, thing in enumerate(scene.objects):
        weights[k] = weight(thing)
        if share[k] == 0:
            continue
        key = is_key(thing)
        if has_back(thing) and (key or thing.size[2] > 1.2):
            toward = eye - np.asarray(thing.pose.position[:2])
            facing = float(toward @ thing.pose.frame.axis) / max(float(np.linalg.norm(toward)), 1e-6)
            fronts[k] = 0.6 + 0.4 * facing
        if key:  # half a bed at the picture's edge is no view of it
            fronts[k] *= 0.25 + 0.75 * _inside(camera, thing)
        full = _KEY_FULL if key else _FULL[thing.mount]
        shown[k] = min(1.0, share[k] / full) ** 0.5 * fronts[k]
    worth = float(weights @ shown) / max(float(weights.sum()), 1e-9)
    worth += 0.5 * _covered(scene, glimpse)
    if scene.room.windows:
        worth += 0.15 * min(1.0, float((ids == WINDOW).mean()) / 0.05)
    # Much wall and ceiling is a dull picture; something large right before the lens is a bad one.
    empty = np.isin(ids, (WALL, CEILING, NOTHING))
    worth -= 0.8 * max(0.0, float(empty.mean()) - 0.5)
    thing_ahead = (ids >= 0) | (ids == WALL)
    worth -= 3.0 * float(((distance < _CLEAR) & thing_ahead).mean() > 0.004)
    near = np.clip((1.3 - distance) / 0.8, 0.0, 1.0)
    worth -= 1.6 * float((near * (ids >= 0)).mean()) + 0.6 * float((near * np.isin(ids, (WALL, DOOR, WINDOW))).mean())
    # What hides a third of the picture hides the room.
    if len(share):
        blocking = [share[k] for k, thing in enumerate(scene.objects) if thing.size[2] > 1.0 and not is_key(thing)]
        worth -= 1.5 * max(0.0, max(blocking, default=0.0) - 0.18)
        lamps = [share[k] for k, thing in enumerate(scene.objects) if thing.mount == "ceiling"]
        worth -= 2.0 * max(0.0, sum(lamps) - 0.03)
    return _Judged(one, worth, shown)


def _inside(camera: Camera, thing: SceneObject) -> float:
    """The share of the corners of a thing's box that lie in the picture."""
    u, v, ahead = camera.project(box_corners(thing)).T
    return float(((np.abs(u) < 1) & (np.abs(v) < 1) & (ahead > 0)).mean())


def _covered(scene: Scene, glimpse: Glimpse) -> float:
    """The share of the floor's cells on which, or above which, something is seen."""
    import shapely

    low = np.asarray(scene.room.outline).min(axis=0)
    seen = (glimpse.ids >= 0) | (glimpse.ids == FLOOR)
    points = glimpse.points[seen & (glimpse.points[..., 2] < 1.4)][:, :2]
    cells = np.unique(((points - low) / _CELL).astype(int), axis=0)
    return min(1.0, len(cells) * _CELL**2 / max(shapely.Polygon(scene.room.outline).area, 1e-6))


def _door_candidates(scene: Scene, aspect: float) -> Iterator[_Candidate]:
    """Just inside each door, in the doorway of a small room; without doors, the middles of walls."""
    room = scene.room
    doors = [(room.walls[d.wall], d.offset + d.width / 2, d.width, k) for k, d in enumerate(room.doors)]
    doors = doors or [(wall, wall.length / 2, min(0.8, wall.length), wall.index) for wall in room.walls]
    # Behind the doorway there is room only where there is a doorway.
    depths = (0.1, 0.25, 0.45, 0.7, 1.0) if not room.doors else (-0.35, 0.05, 0.25, 0.45, 0.7, 1.0)
    for wall, at, width, number in doors:
        free = _depth_of(scene, wall, at)
        for depth in depths:
            if depth > 0.4 * free or (depth < 0.2 and free > 2.6 and depth < 0.04):
                continue
            for aside in (0.0, -0.25, 0.25) if depth > 0.2 else (0.0,):
                eye = np.array(wall.point(at + aside * width, depth))
                yield from _aimed(scene, eye, ("door", number), aspect, math.atan2(wall.inward[1], wall.inward[0]))


def _corner_candidates(scene: Scene, aspect: float) -> Iterator[_Candidate]:
    """In each corner that does not stand out into the room, nearer to it and farther, beside it along each wall."""
    walls = scene.room.walls
    for k, wall in enumerate(walls):
        before = walls[k - 1]
        if cross(before.along, wall.along) < 0.17:  # no corner to stand in
            continue
        corner = np.asarray(wall.start)
        inward = np.asarray(wall.inward) + np.asarray(before.inward)
        yaw = math.atan2(inward[1], inward[0])
        reach = min(wall.length, before.length)
        near = 0.12 if _diagonal(scene) < _TINY else 0.3
        for a, b in ((near, near), (0.5, 0.5), (0.8, 0.8), (1.2, 1.2), (0.3, 1.0), (1.0, 0.3), (0.3, 1.8), (1.8, 0.3)):
            if max(a, b) > 0.5 * reach and (a, b) != (near, near):
                continue
            a, b = min(a, 0.3 * wall.length), min(b, 0.3 * before.length)
            eye = corner + a * np.asarray(before.inward) + b * np.asarray(wall.inward)
            yield from _aimed(scene, eye, ("corner", k), aspect, yaw)


def _aimed(scene: Scene, eye: np.ndarray, place: tuple[str, int], aspect: float, yaw: float) -> Iterator[_Candidate]:
    """Cameras at one point [2] that look along ``yaw``, to the focus of the room, between and beside."""
    room = scene.room
    height = min(EYE_HEIGHT, 0.6 * room.height)
    focus = _focus(scene)
    toward = math.atan2(focus[1] - eye[1], focus[0] - eye[0])
    off = math.remainder(toward - yaw, math.tau)
    turns = {0.0, 0.5 * off, off, -0.2, 0.2, off - 0.18, off + 0.18}
    for turn in sorted(round(turn, 4) for turn in turns if abs(turn) < 1.3):
        for shift in SHIFTS if _diagonal(scene) < _TINY else SHIFTS[:-1]:
            yield _Candidate(Camera.level((*eye, height), yaw + turn, _angle(scene), aspect, shift), place)


def _angle(scene: Scene) -> float:
    """The horizontal angle [rad] of the lens."""
    share = min(1.0, max(0.0, (_diagonal(scene) - _SMALL) / (_LARGE - _SMALL)))
    short, long = FOCAL_LENGTHS
    return 2 * math.atan(18.0 / (short + share * (long - short)))


def _diagonal(scene: Scene) -> float:
    """The diagonal of the room's box from above [m]."""
    outline = np.asarray(scene.room.outline)
    return float(np.linalg.norm(outline.max(axis=0) - outline.min(axis=0)))


def _focus(scene: Scene) -> np.ndarray:
    """The middle [2] of what the room is about: of its key pieces, else of its furniture, else of its floor."""
    standing = [thing for thing in scene.objects if thing.mount == "floor"]
    standing = [thing for thing in standing if is_key(thing)] or standing
    if not standing:
        outline = np.asarray(scene.room.outline, dtype=float)
        return (outline.min(axis=0) + outline.max(axis=0)) / 2
    places = np.array([thing.pose.position[:2] for thing in standing])
    return np.average(places, axis=0, weights=[weight(thing) ** 2 for thing in standing])


def _depth_of(scene: Scene, wall: Wall, at: float) -> float:
    """How far the room reaches [m] straight before a point of a wall."""
    import shapely

    beam = shapely.LineString([wall.point(at, 0.01), wall.point(at, 1e3)])
    inside = shapely.get_parts(shapely.intersection(beam, shapely.Polygon(scene.room.outline)))
    return max((part.length for part in inside[:1]), default=0.0)
