"""From where a room is looked at: at eye level from its door and two corners, and from above the best corner."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.angles import cross, heading
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Scene

from .camera import Camera
from .instances import hidden_with
from .probe import (
    CEILING,
    DOOR,
    FLOOR,
    NOTHING,
    WALL,
    WINDOW,
    Glimpse,
    Probe,
    box_corners,
    box_share,
    has_back,
    is_key,
    weight,
)
from .shell import STUB

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

_MUCH = 0.22  # how much better the view from a corner must be than that from the door, on a walk

_BACK = (0.9, 1.3, 1.7, 2.2, 2.8, 3.5)  # how far one steps back from a door to look through it [m]
_THROUGH = 0.2  # share of the picture that is seen through the door, from which on it is enough

MORE = 0.4
"""What it counts for a picture that it shows all that matters and that no other picture shows."""


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


class _Room:
    """A scene as the candidates are judged by: numbers of its objects as arrays, worked out once.

    Attributes:
        weights: How much each object matters [N].
        key: Which ones the room is about [N].
        turned: Which ones have a side to be seen from [N].
        full: Share of the picture from which on each counts as shown [N].
        tall, hung: Which ones hide what is behind them, and which hang from the ceiling [N].
        places, fronts: Where they are [N, 2] in metres, and which way they look [N, 2].
        corners: Of their boxes [N, 8, 3].
        focus: The middle [2] of what the room is about.
        diagonal, area: Of its plan [m], [m2].
    """

    def __init__(self, scene: Scene, aspect: float) -> None:
        self.scene, self.aspect = scene, aspect
        things, outline = scene.objects, np.asarray(scene.room.outline, dtype=float)
        low, high = outline.min(axis=0), outline.max(axis=0)
        x, y = outline.T
        self.low, self.diagonal = low, float(np.linalg.norm(high - low))
        self.area = max(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2, 1e-6)
        self.weights = np.array([weight(thing) for thing in things])
        self.key = np.array([is_key(thing) for thing in things], dtype=bool)
        heights = np.array([thing.size[2] for thing in things])
        self.turned = np.array([has_back(thing) for thing in things], dtype=bool) & (self.key | (heights > 1.2))
        self.full = np.where(self.key, _KEY_FULL, [_FULL[thing.mount] for thing in things])
        self.tall = (heights > 1.0) & ~self.key
        self.hung = np.array([thing.mount == "ceiling" for thing in things], dtype=bool)
        self.places = np.array([thing.pose.position[:2] for thing in things]).reshape(-1, 2)
        self.fronts = np.array([thing.pose.frame.axis for thing in things]).reshape(-1, 2)
        self.corners = np.array([box_corners(thing) for thing in things]).reshape(-1, 8, 3)
        standing = np.array([thing.mount == "floor" for thing in things], dtype=bool)
        about = standing & self.key if (standing & self.key).any() else standing
        self.focus = (low + high) / 2
        if about.any():
            self.focus = np.average(self.places[about], axis=0, weights=self.weights[about] ** 2)
        share = min(1.0, max(0.0, (self.diagonal - _SMALL) / (_LARGE - _SMALL)))
        short, long = FOCAL_LENGTHS
        self.angle = 2 * math.atan(18.0 / (short + share * (long - short)))

    @property
    def tiny(self) -> bool:
        """Whether one can hardly step back in it."""
        return self.diagonal < _TINY


def eye_cameras(scene: Scene, aspect: float = 4 / 3) -> dict[str, Camera]:
    """The camera of each of `EYE_VIEWS`: level, 24 to 28 mm, chosen by what a look through each candidate shows.

    A room without doors is entered through the middle of a wall.
    """
    return cameras_and_hero(scene, aspect)[0]


def cameras_and_hero(scene: Scene, aspect: float = 4 / 3) -> tuple[dict[str, Camera], str]:
    """The `eye_cameras`, and the view among them that shows the room best."""
    room = _Room(scene, aspect)
    doors = _best(room, Probe(scene, doors=False), _free(scene, [*_door_candidates(room)]))
    corners = _best(room, Probe(scene), _free(scene, [*_corner_candidates(room)]))
    chosen = [_first(doors, [], room.weights)]
    for _ in range(2):
        chosen.append(_first(corners, chosen, room.weights))
    views: dict[str, _Judged] = dict(zip(EYE_VIEWS, chosen, strict=True))

    def alone(view: str) -> float:
        return round(views[view].worth + MORE * _share(views[view].shown, room.weights), 6)

    return {view: one.candidate.camera for view, one in views.items()}, max(EYE_VIEWS, key=alone)


PASSAGE = 0.3
"""What it counts for a picture on a walk that it shows an open door, and the room behind it."""


def walk_camera(scene: Scene, aspect: float, entered: str | None, doors: Collection[str] = ()) -> Camera:
    """From where a room is looked at on a walk: from the door by which it is entered, or, where that shows much less,
    from the corner that shows it best.

    Args:
        scene: The room.
        aspect: Width over height of the picture.
        entered: Id of the door by which one comes; None, or none of the room: any.
        doors: Ids of the doors that stand open: a view through one of them is worth something.
    """
    room = _Room(scene, aspect)
    open_doors = [k for k, door in enumerate(scene.room.doors) if door.id in doors and door.id != entered]
    here = [k for k, door in enumerate(scene.room.doors) if door.id == entered]
    places = [one for one in _door_candidates(room) if not here or one.place == ("door", here[0])]
    best = []
    for candidates in (places, [*_corner_candidates(room)]):
        judged = _best(room, Probe(scene, doors=False), _free(scene, candidates))
        first = max(judged, key=lambda one: round(_on_walk(one, room, open_doors), 6))
        best.append((_on_walk(first, room, open_doors), first.candidate.camera))
    (from_door, entering), (from_corner, corner) = best
    return corner if from_corner > from_door + _MUCH else entering


def onward_camera(scene: Scene, aspect: float, door: str) -> Camera | None:
    """From where one looks out of a room through an open door, seeing something of the room as well.

    Args:
        scene: The room.
        aspect: Width over height of the picture.
        door: Id of the door.

    Returns:
        The camera, or None where nobody can step back from the door.
    """
    import shapely

    room = _Room(scene, aspect)
    number, own = next((k, d) for k, d in enumerate(scene.room.doors) if d.id == door)
    wall, middle = scene.room.walls[own.wall], own.offset + own.width / 2
    inside = shapely.Polygon(scene.room.outline).buffer(-_HEAD)
    target = np.array(wall.point(middle, -0.3))
    height = min(EYE_HEIGHT, 0.6 * scene.room.height)
    found = []
    for depth in _BACK:
        for aside in (0.0, -0.4, 0.4, -0.9, 0.9):
            eye = np.array(wall.point(middle + aside, depth))
            if inside.contains(shapely.Point(eye)):
                yaw = math.atan2(*(target - eye)[::-1])
                found += [
                    _Candidate(Camera.level((*eye, height), yaw + turn, room.angle, aspect, shift), ("door", number))
                    for turn in (0.0, -0.22, 0.22)
                    for shift in SHIFTS[:2]
                ]
    if not found:
        return None
    found = _free(scene, found)
    glimpses = Probe(scene, doors=False).look([one.camera for one in found], *_FINE)

    def worth(one: _Candidate, glimpse: Glimpse) -> float:
        through = float((glimpse.ids == NOTHING).mean())
        return round(min(through, _THROUGH) / _THROUGH + 0.5 * _judge(room, one, glimpse).worth, 6)

    return max(zip(found, glimpses, strict=True), key=lambda pair: worth(*pair))[0].camera


def _on_walk(one: _Judged, room: _Room, open_doors: list[int]) -> float:
    """The worth of a view on a walk: of itself, and for the open doors of which most is in it."""
    seen = 0.0
    for k in open_doors:
        door = room.scene.room.doors[k]
        wall = room.scene.room.walls[door.wall]
        corners = [(*wall.point(door.offset + s * door.width), z) for s in (0.1, 0.9) for z in (0.1, 0.9 * door.height)]
        u, v, ahead = one.candidate.camera.project(np.asarray(corners)).T
        inside = float(((np.abs(u) < 1) & (np.abs(v) < 1) & (ahead > 0.6)).mean())
        facing = -float(np.dot(one.candidate.camera.axis[:2], wall.inward))  # straight through it: 1
        seen = max(seen, inside * max(0.0, facing))
    return one.worth + PASSAGE * seen


def _share(shown: np.ndarray, weights: np.ndarray) -> float:
    """How much of all that matters is shown, 0 to 1."""
    return float(weights @ shown) / max(float(weights.sum()), 1e-9)


def _first(judged: list[_Judged], chosen: list[_Judged], weights: np.ndarray) -> _Judged:
    """The best of some, beside those chosen before: what these show well counts less."""
    before = np.max([one.shown for one in chosen], axis=0, initial=0.0)
    taken = [one.candidate.place for one in chosen]

    def worth(one: _Judged) -> float:
        more = _share(np.maximum(one.shown - before, 0.0), weights)
        again = one.candidate.place in taken
        alike = max((_likeness(one.candidate.camera, other.candidate.camera) for other in chosen), default=0.0)
        return one.worth + (MORE * more if chosen else 0.0) - 0.5 * again - 0.5 * alike

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


def _best(room: _Room, probe: Probe, candidates: list[_Candidate]) -> list[_Judged]:
    """The candidates that deserve a second look, judged by it; of those in one place the better half only."""

    def judged(some: list[_Candidate], size: tuple[int, int]) -> list[_Judged]:
        glimpses = probe.look([one.camera for one in some], *size)
        return [_judge(room, one, glimpse) for one, glimpse in zip(some, glimpses, strict=True)]

    first = sorted(judged(candidates, _ROUGH), key=lambda one: -round(one.worth, 6))
    kept: list[_Candidate] = []
    for one in first:
        same = sum(other.place == one.candidate.place for other in kept)
        if same < 4 and len(kept) < 2 * _FINALISTS:
            kept.append(one.candidate)
    return judged(kept, _FINE)


def _judge(room: _Room, one: _Candidate, glimpse: Glimpse) -> _Judged:
    camera, ids, distance = one.camera, glimpse.ids, glimpse.distance
    share = glimpse.pixels(len(room.weights)) / ids.size
    toward = np.asarray(camera.eye[:2]) - room.places
    facing = (toward * room.fronts).sum(axis=1) / np.maximum(np.linalg.norm(toward, axis=1), 1e-6)
    worths = np.where(room.turned, 0.6 + 0.4 * facing, 1.0)
    u, v, ahead = camera.project(room.corners.reshape(-1, 3)).T
    inside = ((np.abs(u) < 1) & (np.abs(v) < 1) & (ahead > 0)).reshape(-1, 8).mean(axis=1)
    worths = worths * np.where(room.key, 0.25 + 0.75 * inside, 1.0)  # half a bed at the edge is no view of it
    shown = np.minimum(1.0, share / room.full) ** 0.5 * worths
    worth = float(room.weights @ shown) / max(float(room.weights.sum()), 1e-9)
    worth += 0.5 * _covered(room, glimpse)
    if room.scene.room.windows:
        worth += 0.15 * min(1.0, float((ids == WINDOW).mean()) / 0.05)
    # Much wall and ceiling is a dull picture; something large right before the lens is a bad one.
    empty = np.isin(ids, (WALL, CEILING, NOTHING))
    worth -= 0.8 * max(0.0, float(empty.mean()) - 0.5)
    thing_ahead = (ids >= 0) | (ids == WALL)
    worth -= 3.0 * float(((distance < _CLEAR) & thing_ahead).mean() > 0.004)
    near = np.clip((1.3 - distance) / 0.8, 0.0, 1.0)
    worth -= 1.6 * float((near * (ids >= 0)).mean()) + 0.6 * float((near * np.isin(ids, (WALL, DOOR, WINDOW))).mean())
    # What hides a third of the picture hides the room.
    worth -= 1.5 * max(0.0, float(share[room.tall].max(initial=0.0)) - 0.18)
    worth -= 2.0 * max(0.0, float(share[room.hung].sum()) - 0.03)
    return _Judged(one, worth, shown)


def _covered(room: _Room, glimpse: Glimpse) -> float:
    """The share of the floor's cells on which, or above which, something is seen."""
    seen = (glimpse.ids >= 0) | (glimpse.ids == FLOOR)
    points = glimpse.points[seen & (glimpse.points[..., 2] < 1.4)][:, :2]
    column, row = ((points - room.low) / _CELL).astype(int).T
    return min(1.0, len(np.unique(column * 100_000 + row)) * _CELL**2 / room.area)


def _door_candidates(setting: _Room) -> Iterator[_Candidate]:
    """Just inside each door, in the doorway of a small room; without doors, the middles of walls."""
    room = setting.scene.room
    doors = [(room.walls[d.wall], d.offset + d.width / 2, d.width, k) for k, d in enumerate(room.doors)]
    doors = doors or [(wall, wall.length / 2, min(0.8, wall.length), wall.index) for wall in room.walls]
    # Behind the doorway there is room only where there is a doorway.
    depths = (0.1, 0.25, 0.45, 0.7, 1.0) if not room.doors else (-0.35, 0.05, 0.25, 0.45, 0.7, 1.0)
    for wall, at, width, number in doors:
        free = _depth_of(setting.scene, wall, at)
        for depth in depths:
            if depth > 0.4 * free or (depth < 0.2 and free > 2.6 and depth < 0.04):
                continue
            for aside in (0.0, -0.25, 0.25) if depth > 0.2 else (0.0,):
                eye = np.array(wall.point(at + aside * width, depth))
                yield from _aimed(setting, eye, ("door", number), math.atan2(wall.inward[1], wall.inward[0]))


def _corner_candidates(setting: _Room) -> Iterator[_Candidate]:
    """In each corner that does not stand out into the room, nearer to it and farther, beside it along each wall."""
    walls = setting.scene.room.walls
    for k, wall in enumerate(walls):
        before = walls[k - 1]
        if cross(before.along, wall.along) < 0.17:  # no corner to stand in
            continue
        corner = np.asarray(wall.start)
        inward = np.asarray(wall.inward) + np.asarray(before.inward)
        yaw = math.atan2(inward[1], inward[0])
        reach = min(wall.length, before.length)
        near = 0.12 if setting.tiny else 0.3
        for a, b in ((near, near), (0.5, 0.5), (0.8, 0.8), (1.2, 1.2), (0.3, 1.0), (1.0, 0.3), (0.3, 1.8), (1.8, 0.3)):
            if max(a, b) > 0.5 * reach and (a, b) != (near, near):
                continue
            a, b = min(a, 0.3 * wall.length), min(b, 0.3 * before.length)
            eye = corner + a * np.asarray(before.inward) + b * np.asarray(wall.inward)
            yield from _aimed(setting, eye, ("corner", k), yaw)


def _aimed(setting: _Room, eye: np.ndarray, place: tuple[str, int], yaw: float) -> Iterator[_Candidate]:
    """Cameras at one point [2] that look along ``yaw``, to the focus of the room, between and beside."""
    height = min(EYE_HEIGHT, 0.6 * setting.scene.room.height)
    toward = math.atan2(setting.focus[1] - eye[1], setting.focus[0] - eye[0])
    off = math.remainder(toward - yaw, math.tau)
    turns = {0.0, 0.5 * off, off, -0.2, 0.2, off - 0.18, off + 0.18}
    for turn in sorted(round(turn, 4) for turn in turns if abs(turn) < 1.3):
        for shift in SHIFTS if setting.tiny else SHIFTS[:-1]:
            yield _Candidate(Camera.level((*eye, height), yaw + turn, setting.angle, setting.aspect, shift), place)


def _depth_of(scene: Scene, wall: Wall, at: float) -> float:
    """How far the room reaches [m] straight before a point of a wall."""
    import shapely

    beam = shapely.LineString([wall.point(at, 0.01), wall.point(at, 1e3)])
    inside = shapely.get_parts(shapely.intersection(beam, shapely.Polygon(scene.room.outline)))
    return max((part.length for part in inside[:1]), default=0.0)


PITCH = math.radians(37.0)
_FOV = 0.42

_LOOK = (96, 72)  # pixels of the look that tells how much a camera shows
_BEHIND = 0.1  # what a thing is worth from behind
_TALL = 1.3  # height [m] of a thing whose back hides what is behind it

HIDDEN = 0.03
"""Share of the floor behind a wall from which on it is cut away."""


def corner_directions(scene: Scene) -> list[np.ndarray]:
    """Unit vectors [2] from the room to the four corners of its box, the best one first."""
    u, across = _axes_of(scene)
    found = []
    for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        way = a * u + b * across
        found.append(way / np.linalg.norm(way))
    return sorted(found, key=lambda way: (-round(_worth(scene, way), 6), round(math.atan2(way[1], way[0]), 6)))


def opposite(ways: list[np.ndarray]) -> np.ndarray:
    """The direction across the room from the best one."""
    return min(ways, key=lambda way: float(way @ ways[0]))


def cut_walls(scene: Scene, way: np.ndarray) -> set[int]:
    """Walls that hide the room from a camera in the direction ``way``: whose outer face is turned to it, and those of a
    notch behind which more of the floor lies."""
    turned = {wall.index for wall in scene.room.walls if float(np.dot(wall.outward, way)) > 0.12}
    return turned | _before_the_floor(scene, way, turned)


def _before_the_floor(scene: Scene, way: np.ndarray, cut: set[int]) -> set[int]:
    """Standing walls behind which, for a camera in a direction, more than `HIDDEN` of the floor lies."""
    import shapely

    floor = shapely.Polygon(scene.room.outline)
    strip = -way * scene.room.height / math.tan(PITCH)  # what a wall hides, seen from far away
    found = set()
    for wall in scene.room.walls:
        if wall.index in cut:
            continue
        ends = np.array([wall.point(0.0), wall.point(wall.length)])
        hidden = shapely.MultiPoint(np.concatenate([ends, ends + strip])).convex_hull
        if shapely.intersection(hidden, floor).area > HIDDEN * floor.area:
            found.add(wall.index)
    return found


def corner_camera(scene: Scene, way: np.ndarray, cut: set[int], aspect: float) -> Camera:
    """A perspective camera that holds the room: its slab, the stubs and the walls that stand."""
    forward = np.array([*(-way * math.cos(PITCH)), -math.sin(PITCH)])
    points = []
    for wall in scene.room.walls:
        high, reach = STUB if wall.index in cut else scene.room.height, WALL_THICKNESS
        for offset in (-reach, wall.length + reach):
            for z in (-FLOOR_THICKNESS, high):
                points.append((*wall.point(offset, -reach), z))
    return Camera.holding(np.asarray(points), forward, fov=_FOV, aspect=aspect, margin=1.06)


def _axes_of(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    longest = max(scene.room.walls, key=lambda wall: round(wall.length, 6))
    # The same axes whichever wall is the longest one.
    x, y = heading(longest.yaw % (math.pi / 2))
    return np.array([x, y]), np.array([-y, x])


def _worth(scene: Scene, way: np.ndarray) -> float:
    """How much a camera in a direction shows: objects by what is seen of them and from which side, and windows."""
    cut = cut_walls(scene, way)
    camera = corner_camera(scene, way, cut, _LOOK[0] / _LOOK[1])
    gone = hidden_with(scene, cut)
    glimpse = Probe(scene, gone, cut, ceiling=False).look([camera], *_LOOK)[0]
    pixels = glimpse.pixels(len(scene.objects))
    worth, total = 0.0, 0.0
    for thing, seen in zip(scene.objects, pixels, strict=True):
        if thing.mount in ("ceiling", "surface") or thing.size[2] < 0.05:
            continue
        matters = weight(thing)
        total += matters
        # Of what is about as large as its box, 0.6 of it is seen where nothing is in the way.
        shown = min(1.0, float(seen) / max(1.0, 0.6 * _LOOK[0] * _LOOK[1] * box_share(camera, thing)))
        facing = float(np.dot(thing.pose.frame.axis, way)) if has_back(thing) else 1.0
        side = _BEHIND + (1 - _BEHIND) * min(1.0, max(0.0, (facing + 0.8) / 0.9))
        worth += matters * shown * side
        if is_key(thing):  # one that is hidden or seen from behind is worse than two seen half
            worth -= matters * (1 - shown * side) ** 2
        elif thing.size[2] > _TALL:
            worth -= 2.0 * matters * (1 - side) ** 2
    worth /= max(total, 1e-9)
    floor = {o.id for o in scene.objects if o.mount == "floor"}
    standing_there = {r.target for r in scene.relations if r.type == "at_window" and r.subject in floor}
    for window in scene.room.windows:
        if window.wall not in cut:
            worth += 0.25 * (window.id in standing_there) + 0.02 * window.width * window.height
    worth += 0.01 * sum(door.wall not in cut for door in scene.room.doors)
    # A deep L shows its inside from where no wall of the notch is in the way.
    standing = sum(wall.length for wall in scene.room.walls if wall.index not in cut)
    return worth + 0.002 * standing
