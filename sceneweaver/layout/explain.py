"""Why no candidate is valid, in a few plain lines, the most fundamental cause first.

Arithmetic comes first, as it proves: fixed objects in each other's way, objects larger than the room or their surface,
more width against the walls than there is wall, more footprint than floor. What arithmetic cannot see is searched
for: small refinements of parts of the scene tell which objects or hard relations do not go together, and a deletion
search (QuickXplain) narrows them down. A search can miss a layout, so what it finds is called found, not proved.

Everything is bounded by work, and the same call finds the same; the clock only cuts off, and the text says so.
"""

from __future__ import annotations

import inspect
import itertools
import math
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely

from sceneweaver.kernels import tables as k
from sceneweaver.optimizers import judge, load_poses
from sceneweaver.scene import CATALOGUE, Relation, Room, Scene, SceneObject, Surface

from .compile import Problem, compile_scene, relative
from .region import Region
from .rows import NEVER
from .shapes import Points, Prism, reach_of
from .solution import Solution

LONGEST = 10.0  # [s] that an explanation may take
RESERVE = 0.3  # [s] of it kept for the last words
LOOK = 256  # candidates of the solution that are looked at,
MOST = 20_000  # as long as they hold no more objects than this
BEST = 16  # candidates whose violations are counted
PAIRS = 144  # pairs of relations that are tried,
CHUNK = 48  # so many at once
LINES = 3  # of one kind
FOUND = "(found by search, which is no proof)"

PENETRATION = 1.0e-3  # [m] that bodies may sink into each other and into walls
INTRUSION = 5.0e-3  # [m] that they may reach into the clearance of a door or window

SUNK = 2.5e-4  # [m] half of what the engine lets two bodies sink in; INTRUDED: the same for zones and clearances
INTRUDED = 4.25e-3

Effort = tuple[int, int]  # candidates, attempts
QUICK, FIRM, FEW_SURE, SURE = range(4)
# Of a test, by the kind of device: a GPU takes many candidates as fast as few.
EFFORTS: dict[str, tuple[Effort, ...]] = {
    "cpu": ((32, 1), (32, 3), (64, 3), (64, 5)),
    "cuda": ((256, 1), (1024, 1), (1024, 2), (2048, 2)),
}
FEW = 4  # objects up to which FEW_SURE is sure
CROWD = 40  # objects from which on a test stays quick


class _OutOfTime(Exception):
    """The clock cut the search off; ``lines`` say what it had found by then."""

    def __init__(self, lines: Sequence[str] = ()) -> None:
        super().__init__()
        self.lines = lines


def explain(scene: Scene, solution: Solution, *, device: str, seed: int, deadline: float | None = None) -> str | None:
    """Why no candidate of a refinement is valid: one to about six lines of plain English; None when one is valid.

    Args:
        scene: what was refined.
        solution: what came of it.
        device: where to run the small refinements, as for ``refine``.
        seed: their seed.
        deadline: when to be back, in the time of ``time.monotonic()``; it never takes much longer than 10 s anyway.
    """
    if np.any(solution.status == 0):
        return None
    start = time.monotonic()
    end = start + LONGEST if deadline is None else min(deadline, start + LONGEST)
    until = end - min(RESERVE, 0.1 * (end - start))
    if until - start < 0.02:
        return "\n".join([*_timed_out(solution, False), _unmet(scene, solution)])
    study = _Study(scene, solution, device, seed, until)
    proved = False
    try:
        lines, proved = study.causes()
        if not lines:
            lines = ["No single cause was found.", *study.hints()]
        if study.cut:
            lines.append(f"Looking further was stopped after {time.monotonic() - start:.1f} s.")
    except _OutOfTime as cut:
        lines = [f"Looking for the cause was stopped after {time.monotonic() - start:.1f} s.", *cut.lines]
        lines += study.hints() if time.monotonic() < end else [_unmet(scene, solution)]
    return "\n".join([*_timed_out(solution, proved), *lines])


def _timed_out(solution: Solution, proved: bool) -> list[str]:
    if not solution.timed_out:
        return []
    proof = "but more time would not have helped" if proved else "which is no proof that there is none"
    return [f"The time limit stopped the run after {solution.elapsed:.1f} s, before any layout was valid, {proof}."]


# --- words ---------------------------------------------------------------------------------------------------------


def _size(obj: SceneObject) -> str:
    return f"{obj.id} ({' x '.join(f'{s:.2f}' for s in obj.size)} m)"


def _list(names: Sequence[str], most: int = 12, joint: str = ", ") -> str:
    names = list(names)
    if len(names) > most:
        return f"{joint.join(names[: most - 1])}{joint}and {len(names) - most + 1} more"
    return joint.join(names)


def _crowd(objects: Sequence[SceneObject]) -> str:
    """A number of objects, by category when they share it."""
    if len(objects) == 1:
        return objects[0].id
    kinds = {o.category for o in objects}
    if len(kinds) == 1:
        return f"{len(objects)} x {kinds.pop()}"
    return f"{len(objects)} objects ({_list([o.id for o in objects], 6)})"


def _say(rel: Relation) -> str:
    """A relation with what it sets for itself: "chair-0 near desk-0 (max 0.5 m)"."""
    units = {"m": " m", "deg": " deg", "": ""}
    params = []
    for name, value in rel.params.items():
        numbers = value if isinstance(value, tuple) else (value,)
        text = " to ".join(v if isinstance(v, str) else f"{v:g}" for v in numbers)
        unit = "" if isinstance(value, str) else units.get(CATALOGUE[rel.type].params[name].unit, "")
        params.append(f"{name} {text}{unit}")
    words = " ".join([rel.subject, rel.type, " and ".join(rel.targets)]).rstrip()
    return f"{words} ({', '.join(params)})" if params else words


def _small(length: float) -> str:
    return f"{length:.1f}" if length >= 0.1 else f"{length:.2f}"


def _plural(n: int, noun: str) -> str:
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


# --- arithmetic: what can be proved ----------------------------------------------------------------------------------


def _fits_turned(points: Points, planes: np.ndarray) -> bool:
    """Whether a convex hull may fit between half planes at some yaw; False is certain."""
    reach = float(np.max(np.hypot(points[:, 0], points[:, 1])))
    steps = 360
    slack = 2 * PENETRATION + reach * math.pi / steps
    for angle in np.arange(steps) * (2 * math.pi / steps):
        c, s = math.cos(angle), math.sin(angle)
        turned = points @ np.array([[c, s], [-s, c]])
        room = 1e4 * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        for nx, ny, offset in planes:
            need = offset - float((turned @ np.array([nx, ny])).min()) - slack
            room = _clip(room, nx, ny, need)
            if not len(room):
                break
        if len(room):
            return True
    return False


def _clip(polygon: Points, nx: float, ny: float, offset: float) -> Points:
    """The part of a convex polygon with n . x >= offset."""
    height = polygon @ np.array([nx, ny]) - offset
    if np.all(height >= 0):
        return polygon
    kept = []
    for a, b, ha, hb in zip(polygon, np.roll(polygon, -1, axis=0), height, np.roll(height, -1), strict=True):
        if ha >= 0:
            kept.append(a)
        if (ha >= 0) != (hb >= 0):
            kept.append(a + (b - a) * (ha / (ha - hb)))
    return np.asarray(kept)


def _hull(solids: Sequence[Prism]) -> Points:
    points = np.concatenate([p.polygon for p in solids])
    shape = shapely.MultiPoint(points).convex_hull
    return shapely.get_coordinates(shape)[:-1]


def _height(prisms: Sequence[Prism]) -> tuple[float, float]:
    """Lowest and highest point of an object above its origin."""
    return min(p.z[0] for p in prisms), max(p.z[1] for p in prisms)


def _levels(prisms: Iterable[Prism]) -> list[float]:
    """Heights in the middle between any two neighbouring ends of prisms."""
    ends = sorted({round(z, 4) for p in prisms for z in p.z})
    return [0.5 * (a + b) for a, b in itertools.pairwise(ends) if b - a > 4 * PENETRATION]


def _cut(prisms: Iterable[Prism], z: float, shrink: float = PENETRATION):
    """The section of prisms at height z, each smaller by what may sink in."""
    shapes = [
        shapely.Polygon(p.polygon).buffer(-shrink, join_style="mitre")
        for p in prisms
        if p.z[0] + PENETRATION < z < p.z[1] - PENETRATION
    ]
    return shapely.union_all(shapes) if shapes else shapely.Polygon()


def _moved(prisms: Iterable[Prism], pose: np.ndarray) -> list[Prism]:
    c, s = math.cos(pose[3]), math.sin(pose[3])
    turn = np.array([[c, s], [-s, c]])
    return [Prism(p.polygon @ turn + pose[:2], (p.z[0] + pose[2], p.z[1] + pose[2])) for p in prisms]


@dataclass(frozen=True)
class _Fullness:
    """Footprints on a floor or surface at the height where they need most, against what there is [m2]."""

    need: float
    free: float
    count: int


def _fullest(
    solids: Sequence[Sequence[Prism]], floor, blocked: Sequence[tuple[Prism, float]], most: int = 8
) -> _Fullness | None:
    """The height at which sections exceed the free area most; None when they do nowhere.

    Sections at one height must not overlap, so their sum over the free area proves that there is not enough.
    """
    levels = _levels(p for s in solids for p in s)
    if not levels:
        return None
    needs = np.zeros(len(levels))
    counts = np.zeros(len(levels), dtype=int)
    for prisms in solids:
        areas: dict[tuple[int, ...], float] = {}
        for i, z in enumerate(levels):
            there = tuple(j for j, p in enumerate(prisms) if p.z[0] < z < p.z[1])
            if there and there not in areas:
                areas[there] = _cut([prisms[j] for j in there], z).area
            needs[i] += areas.get(there, 0.0)
            counts[i] += bool(there)
    worst = None
    for i in np.argsort(-needs)[:most]:
        taken = [
            shapely.Polygon(p.polygon).buffer(-give, join_style="mitre")
            for p, give in blocked
            if p.z[0] + PENETRATION < levels[i] < p.z[1] - PENETRATION
        ]
        free = floor.buffer(PENETRATION, join_style="mitre").difference(shapely.union_all(taken)).area
        if needs[i] > free and (worst is None or needs[i] - free > worst.need - worst.free):
            worst = _Fullness(float(needs[i]), float(free), int(counts[i]))
    return worst


@dataclass(frozen=True)
class _Claim:
    """A stretch of wall that an object must have, by a hard against_wall or side_against_wall."""

    obj: SceneObject
    wall: int | None
    length: float  # at least
    across: float  # at most
    gap: float
    angle: float
    spare: float  # how much of it may stick out beyond the wall's end
    side: bool

    def depth(self, z: float) -> float:
        """How deep the object is solid at height z over the whole length, from the wall on; 0: not at all."""
        d, w, _ = self.obj.size
        prisms = [Prism(np.asarray(p.polygon), p.z) for p in self.obj.solids]
        section = _cut(prisms, z, 0.0).buffer(1e-4, join_style="mitre")
        if self.side:
            return min(d, w) if section.covers(shapely.box(-d / 2, -w / 2, d / 2, w / 2)) else 0.0
        for share in (1.0, 0.75, 0.5, 0.25):
            if section.covers(shapely.box(-d / 2, -w / 2, -d / 2 + share * d, w / 2)):
                return share * d
        return 0.0

    def near(self) -> float:
        """Farthest from the wall [m] that the near face's corners can be."""
        return self.gap + self.across / 2 * math.sin(self.angle) + PENETRATION

    def far(self, depth: float) -> float:
        """Nearest to the wall [m] that the far face's corners can be."""
        return depth * math.cos(self.angle) - self.across / 2 * math.sin(self.angle) - PENETRATION


def _claims(scene: Scene) -> list[_Claim]:
    """One claim for every object that has to stand at a wall and is upright and free to move."""
    claims: dict[str, _Claim] = {}
    for rel in scene.relations:
        if not rel.hard or rel.type not in ("against_wall", "side_against_wall"):
            continue
        obj, spec = scene.object(rel.subject), CATALOGUE[rel.type]
        if obj.fixed or obj.mount != "floor" or max(map(abs, obj.pose.quaternion[:2])) > 1e-9:
            continue
        side = rel.type == "side_against_wall"
        d, w, _ = obj.size
        length, across = (min(d, w), max(d, w)) if side else (w, w)
        degrees = spec.value(rel, "degrees")
        if degrees > 15:  # the arithmetic is for objects that stand nearly along the wall
            continue
        claim = _Claim(
            obj,
            int(rel.target.split(":")[1]) if isinstance(rel.target, str) else None,
            length,
            across,
            spec.gap_range(rel, d)[1],
            math.radians(degrees),
            (1 - spec.value(rel, "overlap")) * across,
            side,
        )
        if rel.subject not in claims or (claims[rel.subject].wall is None and claim.wall is not None):
            claims[rel.subject] = claim
    return list(claims.values())


def _most_within(lengths: Sequence[float], room: float) -> float:
    """The largest sum of some lengths in whole millimetres that is at most ``room`` (rounded up)."""
    sums, limit = 1, max(0, math.ceil(room * 1000))
    mask = (1 << (limit + 1)) - 1
    for length in lengths:
        sums |= (sums << round(length * 1000)) & mask
    return (sums.bit_length() - 1) / 1000


@dataclass(frozen=True)
class _Row:
    """What stands along the walls at height z: the least length that it needs and the most that it can use."""

    z: float
    claims: list[_Claim]
    need: float
    usable: float
    stretches: list[float]


class _Walls:
    """How much wall there is for objects that must stand along one."""

    def __init__(self, room: Room, region: Region, fixed: Sequence[Prism]) -> None:
        self.room, self.region, self.fixed = room, region, fixed
        self.floor = shapely.Polygon(room.outline).buffer(PENETRATION, join_style="mitre")
        self.free: dict[tuple[bool, ...], shapely.geometry.base.BaseGeometry] = {}

    def _free(self, z: float) -> str:
        """What the free wall at height z is free of, in words."""
        n = len(self.room.doors)
        openings = [p.z[0] < z < p.z[1] for p in self.region.openings]
        words = ["doors"] * any(openings[:n]) + ["windows"] * any(openings[n:])
        words += ["fixed objects"] * any(p.z[0] < z < p.z[1] for p in self.fixed)
        return f" free of {' and '.join(words)}" if words else ""

    def stretches(self, z: float, line: float, spare: float) -> list[list[tuple[float, float]]]:
        """For every wall the free stretches [from, to] of the line along it, ``line`` metres inside, at height z."""
        key = tuple(p.z[0] < z < p.z[1] for p in (*self.region.openings, *self.fixed))
        if key not in self.free:
            openings = _cut(self.region.openings, z, INTRUSION)
            self.free[key] = self.floor.difference(openings).difference(_cut(self.fixed, z))
        free = self.free[key]
        out = []
        for wall in self.region.walls:
            ends = [wall.p + line * wall.n + at * wall.t for at in (-spare, wall.length + spare)]
            hit = free.intersection(shapely.LineString(ends))
            pieces = [g for g in getattr(hit, "geoms", [hit]) if g.geom_type == "LineString" and not g.is_empty]
            spans = [sorted(float((np.asarray(p) - wall.p) @ wall.t) for p in g.coords) for g in pieces]
            out.append(sorted((s[0], s[-1]) for s in spans))
        return out

    def corner_loss(self, claims: Sequence[_Claim], depths: Sequence[float], line: float) -> float:
        """How far from a square corner one of its two walls is lost for certain: of the two objects nearest to the
        corner, one makes the other keep away from it by its own depth."""
        reach = [c.far(d) for c, d in zip(claims, depths, strict=True)]
        drift = max(math.tan(c.angle) for c in claims) * max(reach)
        loss = min(reach) - drift - 0.01
        return loss if min(c.length for c in claims) >= line + 2 * drift else 0.0

    def usable(self, spans: list[list[tuple[float, float]]], lengths: Sequence[float], loss: float) -> float:
        """The most that objects of these lengths can use of the stretches, whoever has to keep away from corners."""
        walls = self.region.walls
        corners = []
        for i, wall in enumerate(walls):
            j = (i + 1) % len(walls)
            square = abs(float(wall.t @ walls[j].t)) < 1e-3 and float(wall.n @ walls[j].t) > 0
            if square and spans[i] and spans[j] and loss > 0:
                (_, end), (start, _) = spans[i][-1], spans[j][0]
                if abs(end - wall.length) < 0.005 and abs(start) < 0.005:
                    corners.append(((i, len(spans[i]) - 1), (j, 0)))
        holds: dict[tuple[float, int], float] = {}
        most = 0.0
        for losers in itertools.product((0, 1), repeat=min(len(corners), 10)):
            times = Counter(corner[which] for corner, which in zip(corners, losers, strict=False))
            total = 0.0
            for i, each in enumerate(spans):
                for at, (a, b) in enumerate(each):
                    key = (b - a, times[i, at])
                    if key not in holds:
                        holds[key] = _most_within(lengths, b - a - key[1] * loss)
                    total += holds[key]
            most = max(most, total)
        return most

    def missing(self, claims: Sequence[_Claim]) -> list[str]:
        """Lines about claims that the walls cannot meet."""
        lines, hopeless = [], set()
        for claim in claims:
            text = self._worst([claim], claim.wall)
            if text:
                lines.append(text)
                hopeless.add(claim.obj.id)
        if len(lines) > LINES:
            lines[LINES - 1 :] = [f"And {len(lines) - LINES + 1} more like these."]
        rest = [c for c in claims if c.obj.id not in hopeless]
        text = self._worst(rest, None)
        if text:
            return [*lines, text]
        for wall in sorted({c.wall for c in rest if c.wall is not None}):
            group = [c for c in rest if c.wall == wall]
            text = self._worst(group, wall) if len(group) > 1 else None
            lines += [text] if text else []
        return lines

    def _worst(self, claims: Sequence[_Claim], wall: int | None) -> str | None:
        """The line for the height at which most wall is missing; None when there is enough."""
        worst = max(self._rows(claims, wall), key=lambda row: row.need - row.usable, default=None)
        return None if worst is None or worst.need - worst.usable < 1e-3 else self._text(worst, wall)

    def tightest(self, claims: Sequence[_Claim]) -> str | None:
        """How much of the wall is claimed at the height where it is tightest; None below three quarters."""
        row = max(self._rows(claims, None), key=lambda row: row.need / max(row.usable, 1e-3), default=None)
        if row is None or row.need < 0.75 * row.usable:
            return None
        crowd, need = _crowd([c.obj for c in row.claims]), sum(c.length for c in row.claims)
        return f"{crowd} need {need:.1f} m of the {sum(row.stretches):.1f} m of wall{self._free(row.z) or ' there is'}"

    def _rows(self, claims: Sequence[_Claim], wall: int | None) -> Iterator[_Row]:
        """What stands along the walls at any height, on one line at a distance from them that all of it reaches."""
        prisms = [Prism(np.zeros((3, 2)), p.z) for c in claims for p in c.obj.solids]
        levels = _levels([*prisms, *self.region.openings])
        if len(levels) > 24:
            levels = [levels[i] for i in np.linspace(0, len(levels) - 1, 24).astype(int)]
        seen = set()
        for z in levels:
            depths = {c.obj.id: c.depth(z) for c in claims}
            group = [c for c in claims if depths[c.obj.id] > 0]
            while group:  # leave out what is too thin to reach the line of the others
                line = max(c.near() for c in group)
                thick = [c for c in group if c.far(depths[c.obj.id]) > line]
                if len(thick) == len(group):
                    break
                group = thick
            key = (tuple(c.obj.id for c in group), tuple(p.z[0] < z < p.z[1] for p in self.region.openings))
            if not group or key in seen:
                continue
            seen.add(key)
            spans = self.stretches(z, line, max(c.spare for c in group))
            spans = [each if wall in (None, w) else [] for w, each in enumerate(spans)]
            lengths = [math.floor(1000 * (c.length - 2 * PENETRATION)) / 1000 for c in group]
            loss = self.corner_loss(group, [depths[c.obj.id] for c in group], line) if len(group) > 1 else 0.0
            usable = self.usable(spans, lengths, loss)
            yield _Row(z, group, sum(lengths), usable, [b - a for each in spans for a, b in each])

    def _text(self, row: _Row, wall: int | None) -> str:
        free, where = self._free(row.z), "wall" if wall is None else f"wall:{wall}"
        need, there = sum(c.length for c in row.claims), sum(row.stretches)
        if len(row.claims) == 1:
            longest = max(row.stretches, default=0.0)
            left = f"no stretch{free} is left" if longest < 0.05 else f"the longest stretch{free} is {longest:.2f} m"
            return f"{_size(row.claims[0].obj)} needs {need:.2f} m of {where}; {left}."
        crowd = _crowd([c.obj for c in row.claims])
        start = f"{crowd} need {need:.1f} m of {where}; {there:.1f} m is{free or ' there'}"
        if row.usable > there - 0.1:
            return f"{start}: {_small(need - there)} m missing."
        parts = _list([f"{s:.1f}" for s in sorted(row.stretches, reverse=True) if s > 0.05], 6)
        most = f"hold {row.usable:.1f} m of them at most: {_small(need - row.usable)} m missing"
        return f"{start}, and its stretches ({parts} m; a corner serves one wall) {most}."


# --- search: what small refinements find -----------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _refine_many() -> tuple[Callable, dict]:
    """The engine's function, and what keeps it from explaining in its turn."""
    from .engine import refine_many  # the engine imports this module

    silent = {"explain": False} if "explain" in inspect.signature(refine_many).parameters else {}
    return refine_many, silent


class _Study:
    """One scene that has no valid candidate, taken apart.

    A part of the scene is a set of elements: the number of a unit (a hard relation, or all ``around`` of one target,
    which mean nothing one by one), or the number of units plus the index of an object. Fixed objects and the room
    belong to every part.
    """

    def __init__(self, scene: Scene, solution: Solution, device: str, seed: int, until: float) -> None:
        from .engine import pick_device  # the engine imports this module

        self.scene, self.solution, self.seed, self.until = scene, solution, seed, until
        self.device = pick_device(device)
        self.compiled = compile_scene(scene)
        self.problem = self.compiled.room
        self.index = {o.id: i for i, o in enumerate(scene.objects)}
        self.free = [i for i, o in enumerate(scene.objects) if not o.fixed]
        self.units = self._make_units()
        self.named = [self._named(unit) for unit in self.units]
        order = np.lexsort((solution.energy, solution.status == 3))
        self.top = order[: max(BEST, min(LOOK, MOST // max(1, len(scene.objects))))]
        self.cut = False
        self.narrowest: frozenset[int] | None = None
        self.possible: list[frozenset[int]] = []
        self.impossible: list[frozenset[int]] = []

    # parts

    @cached_property
    def walls(self) -> _Walls:
        """The walls with the fixed objects."""
        still = [i for i, o in enumerate(self.scene.objects) if o.fixed]
        fixed = [p for i in still for p in _moved(self.problem.solids[i], self.problem.home[i])]
        return _Walls(self.scene.room, self.problem.region, fixed)

    def _make_units(self) -> list[tuple[int, ...]]:
        units, groups = [], {}
        for j, rel in enumerate(self.scene.relations):
            if rel.type == "around":
                groups.setdefault(rel.target, []).append(j)
            elif rel.hard:
                units.append((j,))
        return units + [tuple(g) for g in groups.values() if any(self.scene.relations[j].hard for j in g)]

    def _named(self, unit: tuple[int, ...]) -> frozenset[int]:
        """Objects that a unit names, and what carries them."""
        names = {n for j in unit for n in (self.scene.relations[j].subject, *self.scene.relations[j].targets)}
        return self._carriers({self.index[n] for n in names if n in self.index})

    def _carriers(self, objects: Iterable[int]) -> frozenset[int]:
        out = set(objects)
        for i in tuple(out):
            support = self.scene.objects[i].support
            while support is not None:
                out.add(self.index[support.object])
                support = self.scene.object(support.object).support
        return frozenset(out)

    def presence(self, objects: Iterable[int]) -> frozenset[int]:
        """The part that is these objects, without relations."""
        return frozenset(len(self.units) + i for i in objects)

    def objects_of(self, part: Iterable[int]) -> frozenset[int]:
        """Movable objects of a part, with what carries them."""
        n = len(self.units)
        out = {e - n for e in part if e >= n}
        for e in part:
            if e < n:
                out |= self.named[e]
        return frozenset(i for i in self._carriers(out) if not self.scene.objects[i].fixed)

    def closed(self, part: Iterable[int]) -> frozenset[int]:
        """A part with the presence of all its objects, so that parts can be compared."""
        return frozenset(part) | self.presence(self.objects_of(part))

    def scene_of(
        self, part: Iterable[int], guides: bool = False, fixed: bool = True, room: Room | None = None
    ) -> Scene:
        """The scene reduced to a part.

        Relations that let objects into each other's zones stay, as faint soft ones; ``guides`` keeps all others that
        name nothing but objects of the part as soft ones, since they lead to layouts that are dense.
        """
        part = set(part)
        keep = set(self.objects_of(part))
        named = {i for e in part if e < len(self.units) for i in self.named[e]}
        keep |= self._carriers(i for i, o in enumerate(self.scene.objects) if o.fixed and (fixed or i in named))
        gone = {o.id for i, o in enumerate(self.scene.objects) if i not in keep}
        hard = {j for e in part if e < len(self.units) for j in self.units[e]}
        relations = []
        for j, rel in enumerate(self.scene.relations):
            ties = CATALOGUE[rel.type].ties_zones
            if j in hard:
                relations.append(rel)
            elif (ties or guides) and not gone.intersection((rel.subject, *rel.targets)):
                weight = rel.weight if guides else 1e-3
                relations.append(rel.model_copy(update={"hard": False, "weight": weight}))
        update = {
            "objects": tuple(o for i, o in enumerate(self.scene.objects) if i in keep),
            "relations": tuple(relations),
            "room": self.scene.room if room is None else room,
        }
        return self.scene.model_copy(update=update)

    # tests

    def search(self, scenes: Sequence[Scene], effort: int) -> list[bool]:
        """Which scenes a small refinement finds a valid layout for; raises _OutOfTime when the clock cuts it off."""
        refine_many, silent = _refine_many()
        left = self.until - time.monotonic()
        if left <= 0:
            raise _OutOfTime
        candidates, steps = EFFORTS["cpu" if self.device == "cpu" else "cuda"][effort]
        solutions = refine_many(
            scenes,
            candidates=candidates,
            seed=(self.seed + 7919 * steps + candidates) % 2**32,
            device=self.device,
            steps=steps,
            time_limit=left,
            **silent,
        )
        found = [bool(np.any(s.status == 0)) for s in solutions]
        if not all(found) and any(s.timed_out for s in solutions):
            raise _OutOfTime
        return found

    def known(self, part: frozenset[int]) -> bool | None:
        """What earlier tests and the solution's candidates say about a closed part."""
        if any(part <= other for other in self.possible) or self._witnessed(part):
            return True
        return False if any(other <= part for other in self.impossible) else None

    def _witnessed(self, part: frozenset[int]) -> bool:
        """Whether some candidate of the solution has a closed part in order."""
        units = [e for e in part if e < len(self.units)]
        bad = self.unmet[:, units].any(axis=1) | self.fault[:, sorted(self.objects_of(part))].any(axis=1)
        return not bad.all()

    def note(self, part: frozenset[int], can: bool) -> None:
        """Remember the outcome of a test."""
        if can:
            self.impossible = [p for p in self.impossible if not p <= part]
        (self.possible if can else self.impossible).append(part)

    def can(self, parts: Sequence[Iterable[int]]) -> list[bool]:
        """Whether each part has a layout, as far as a search tells: first a quick one, then a firmer one."""
        closed = [self.closed(p) for p in parts]
        for effort in (QUICK, FIRM):
            ask = [p for p in dict.fromkeys(closed) if self.known(p) is None]
            for some in (ask[i : i + CHUNK] for i in range(0, len(ask), CHUNK)):
                scenes = [self.scene_of(p, guides=effort == FIRM) for p in some]
                for part, can in zip(some, self.search(scenes, effort), strict=True):
                    if can or effort == FIRM or len(self.objects_of(part)) > CROWD:
                        self.note(part, can)
        return [bool(self.known(p)) for p in closed]

    def surely_not(self, part: Iterable[int]) -> bool:
        """Whether even a long search finds no layout for a part that a shorter one found none for."""
        closed = self.closed(part)
        few = len(self.objects_of(closed)) <= FEW
        try:
            found = self.search([self.scene_of(closed, guides=True)], FEW_SURE if few else SURE)[0]
        except _OutOfTime:
            self.cut = True
            return True
        self.note(closed, found)
        return not found

    # witnesses: what the solution's own candidates show

    @cached_property
    def fault(self) -> np.ndarray:
        """Which objects collide, lie outside or off their surface ..., [top candidate, object]."""
        from .engine import make_batch  # the engine imports this module

        if time.monotonic() > self.until:
            raise _OutOfTime
        poses = self.solution.poses[self.top]
        problems: list[tuple[Problem, list[int], np.ndarray]] = [(self.problem, list(range(len(self.index))), poses)]
        for domain in self.compiled.domains:
            members = domain.deck.members
            local = relative(poses[:, members].astype(np.float64), poses[:, None, domain.deck.supporter])
            local[..., 2] = 0.0
            problems.append((domain.problem, members, local))
        fault = np.zeros(poses.shape[:2], dtype=bool)
        for problem, members, layout in problems:
            batch = make_batch([problem], np.zeros(len(poses), dtype=np.int32), self.device)
            load_poses(batch, layout)
            verdict = judge(batch)
            fault[:, members] |= verdict.fault[:, : len(members)] != 0
            for r in range(len(problem.relation_ids), len(problem.relations)):  # mountings
                fault[:, problem.relations[r].objects[0]] |= ~verdict.holds[:, r]
        return fault

    @cached_property
    def unmet(self) -> np.ndarray:
        """Which units are unmet, [top candidate, unit]."""
        holds = self.solution.relations[self.top]
        out = np.zeros((len(self.top), len(self.units)), dtype=bool)
        for u, unit in enumerate(self.units):
            out[:, u] = ~np.all(holds[:, [j for j in unit if self.scene.relations[j].hard]], axis=1)
        return out

    @cached_property
    def good(self) -> np.ndarray:
        """Where units are met and the objects that they name are in order, [top candidate, unit]."""
        good = ~self.unmet
        for u, named in enumerate(self.named):
            good[:, u] &= ~np.any(self.fault[:, sorted(named)], axis=1)
        return good

    def always_at_fault(self) -> list[int]:
        """Movable objects that are at fault in every candidate looked at."""
        return [i for i in self.free if self.fault[:, i].all()]

    # causes, the most fundamental first

    def causes(self) -> tuple[list[str], bool]:
        """Lines about the first kind of cause that there is, and whether they are proved."""
        for find in (self.fixed_faults, self.arithmetic, self.never):
            if lines := list(find()):
                return lines[: 2 * LINES], True
        for find in (self.lonely, self.surfaces, self.together, self.singles, self.pairs, self.again, self.grown):
            lines = []
            try:
                for line in find():
                    lines.append(line)
            except _OutOfTime:
                if not lines:
                    raise
                self.cut = True
            if lines:
                return _few(lines), False
        return [], False

    def fixed_faults(self) -> Iterator[str]:
        """Fixed objects that collide or stand where nothing may."""
        fixed = [i for i, o in enumerate(self.scene.objects) if o.fixed]
        if not fixed:
            return
        scene = self.scene_of(())
        found = _violations(compile_scene(scene).room, scene, None)
        held = [text for text, ids in found.items() if all(self.scene.object(i).fixed for i in ids)]
        if held:
            yield f"Fixed objects are in the way of any layout: {_list(held, 6, '; ')}."
        for i in fixed:
            obj = self.scene.objects[i]
            height = {"floor": 0.0, "ceiling": self.scene.room.height - obj.size[2]}.get(obj.mount)
            off = 0.0 if height is None else obj.pose.position[2] - height
            if abs(off) > 1.8e-3:
                held.append(obj.id)
                where = "above" if off > 0 else "below"
                yield f"{obj.id} is fixed {abs(off):.3f} m {where} where its mount ({obj.mount}) holds it."
        if held or self.search([scene], QUICK)[0]:
            return
        alone = [self.scene.model_copy(update={"objects": self._stack(i), "relations": ()}) for i in fixed]
        loose = [self.scene.objects[i] for i, can in zip(fixed, self.search(alone, QUICK), strict=True) if not can]
        for obj in loose:
            yield f"{obj.id} is fixed where nothing holds it (its mount is {obj.mount})."
        if not loose:
            yield "The fixed objects cannot all stay where they are."

    def _stack(self, i: int) -> tuple[SceneObject, ...]:
        return tuple(self.scene.objects[j] for j in sorted(self._carriers([i])))

    def arithmetic(self) -> list[str]:
        """What does not fit by arithmetic alone."""
        lines = [*self._too_tall(), *self._too_large_for_surfaces(), *self._too_large()]
        fixed = self.walls.fixed
        lines += self.walls.missing(_claims(self.scene))
        floor = [i for i in self.free if self.scene.objects[i].mount == "floor"]
        blocked = [(p, INTRUSION) for p in self.problem.region.openings] + [(p, PENETRATION) for p in fixed]
        full = _fullest([self.problem.solids[i] for i in floor], shapely.Polygon(self.scene.room.outline), blocked)
        if full:
            free = " free of doors and fixed objects" if fixed else " free of doors" if self.scene.room.doors else ""
            cover = f"{_plural(full.count, 'object')} {'cover' if full.count > 1 else 'covers'}"
            missing = round(full.need, 1) - round(full.free, 1)
            lines.append(
                f"The floor is too small: {cover} {full.need:.1f} m2; {full.free:.1f} m2 is{free or ' there'}: "
                f"{missing:.1f} m2 missing."
            )
        return lines

    def _base(self, i: int) -> float | None:
        """Height that an object stands at, where that is given."""
        obj = self.scene.objects[i]
        if obj.fixed:
            return obj.pose.position[2]
        if obj.support is not None:
            base = self._base(self.index[obj.support.object])
            return None if base is None else base + self._surface(obj).z
        return {"floor": 0.0, "ceiling": self.scene.room.height - obj.size[2]}.get(obj.mount)

    def _surface(self, obj: SceneObject) -> Surface:
        assert obj.support is not None
        surfaces = self.scene.object(obj.support.object).surfaces
        return next(s for s in surfaces if s.name == obj.support.surface)

    def _too_tall(self) -> list[str]:
        lines, height = [], self.scene.room.height
        for i in self.free:
            obj = self.scene.objects[i]
            low, high = _height(self.problem.solids[i])
            base = self._base(i)
            if high - low > height + PENETRATION:
                lines.append(f"{obj.id} is {high - low:.2f} m tall; the room is {height:.2f} m high.")
            elif base is not None and base + high > height + PENETRATION:
                on = f"on {obj.support.object}, " if obj.support else ""
                reach = f"{obj.id} reaches {base + high:.2f} m ({on}from {base:.2f} m)"
                lines.append(f"{reach}; the room is {height:.2f} m high.")
        return _few(lines)

    def _too_large_for_surfaces(self) -> list[str]:
        lines = []
        for domain in self.compiled.domains:
            before = len(lines)
            for i in (i for i in domain.deck.members if not self.scene.objects[i].fixed):
                obj = self.scene.objects[i]
                surface = self._surface(obj)
                on = _where(obj)
                high = _height(self.problem.solids[i])[1]
                if surface.headroom is not None and high > surface.headroom + PENETRATION:
                    lines.append(f"{obj.id} is {high:.2f} m tall; {on} has {surface.headroom:.2f} m of head room.")
                elif not _fits_turned(_hull(self.problem.solids[i]), domain.problem.region.planes):
                    lines.append(f"{_size(obj)} is larger than what it stands on: {on} is {_span(surface.polygon)}.")
            polygon = shapely.Polygon(self._surface(self.scene.objects[domain.deck.members[0]]).polygon)
            blocked = [(p, PENETRATION) for p in domain.problem.region.solids]
            full = _fullest(domain.problem.solids, polygon, blocked)
            if full and len(lines) == before:
                members = [self.scene.objects[i] for i in domain.deck.members]
                cover = f"{_crowd(members)} {'cover' if len(members) > 1 else 'covers'}"
                lines.append(
                    f"{_where(members[0])} is overfull: {cover} {full.need:.3g} m2 of {full.free:.3g} m2: "
                    f"{full.need - full.free:.2g} m2 missing."
                )
        return _few(lines)

    def _too_large(self) -> list[str]:
        lines = []
        for i in self.always_at_fault():
            obj = self.scene.objects[i]
            if obj.support is None and not _fits_turned(_hull(self.problem.solids[i]), self.problem.region.planes):
                lines.append(f"{_size(obj)} fits nowhere in the room: its floor is {_span(self.scene.room.outline)}.")
        return _few(lines)

    def lonely(self) -> Iterator[str]:
        """Objects that find no place even with the movable rest away."""
        roots = [i for i in self.always_at_fault() if self.scene.objects[i].support is None]
        for i, can in zip(roots, self.can([self.presence([i]) for i in roots]), strict=True):
            if not can and self.surely_not(self.presence([i])):
                yield f"No place in the room was found for {_size(self.scene.objects[i])}{self._why_no_place(i)}."

    def _why_no_place(self, i: int) -> str:
        """What leaves no place for an object: the first of room, openings and fixed objects that does."""
        part, room = self.presence([i]), self.scene.room
        bare = room.model_copy(update={"doors": (), "windows": ()})
        try:
            if not self.search([self.scene_of(part, fixed=False, room=bare)], FIRM)[0]:
                on_wall = self.scene.objects[i].mount == "wall"
                return ": no wall has room for it" if on_wall else f": the floor is {_span(room.outline)} all in all"
            if not self.search([self.scene_of(part, fixed=False)], FIRM)[0]:
                return ": the clearances of doors and windows leave none"
        except _OutOfTime:
            self.cut = True
            return ""
        return ": the fixed objects leave none"

    def surfaces(self) -> Iterator[str]:
        """Surfaces whose things do not fit on them together, and carriers that fit nowhere with what they carry."""
        full = False
        for domain in self.compiled.domains:
            members = [i for i in domain.deck.members if not self.scene.objects[i].fixed]
            if not self.fault[:, members].any(axis=1).all():
                continue
            fixed = any(self.scene.objects[i].fixed for i in self._carriers(members))
            room = None if fixed else self._hall()
            several = [self.scene_of(self.presence(members), fixed=fixed, room=room)]
            if self.search(several, FIRM)[0]:
                continue
            alone = [self.scene_of(self.presence([i]), fixed=fixed, room=room) for i in members]
            misfits = [i for i, can in zip(members, self.search(alone, FIRM), strict=True) if not can]
            obj = self.scene.objects[members[0]]
            on, polygon = _where(obj), self._surface(obj).polygon
            for i in misfits:
                yield f"No place on {on} ({_span(polygon)}) was found for {_size(self.scene.objects[i])}."
            if not misfits and not self.search(several, SURE)[0]:
                area = sum(self._area(i) for i in members)
                yield (
                    f"{_crowd([self.scene.objects[i] for i in members])} do not fit on {on} together {FOUND}: "
                    f"footprints of {area:.3g} m2 on {shapely.Polygon(polygon).area:.3g} m2 ({_span(polygon)})."
                )
            full = True
        if full:
            return
        roots = self.problem.roots
        groups = [np.flatnonzero(roots == i).tolist() for i in self.always_at_fault() if np.sum(roots == i) > 1]
        for group, can in zip(groups, self.can([self.presence(g) for g in groups]), strict=True):
            if not can and self.surely_not(self.presence(group)):
                root = self.scene.objects[int(roots[group[0]])].id
                carried = [self.scene.objects[i].id for i in group if self.scene.objects[i].id != root]
                yield f"No place in the room was found for {root} with what stands on it ({_list(carried, 6)})."

    def _hall(self) -> Room:
        """An empty room larger than this one on all sides."""
        (x0, y0), (x1, y1) = np.min(self.scene.room.outline, axis=0) - 5, np.max(self.scene.room.outline, axis=0) + 5
        outline = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
        return Room(outline=tuple((float(x), float(y)) for x, y in outline), height=self.scene.room.height + 5)

    def again(self) -> Iterator[str]:
        """A valid layout after all, when the run was short."""
        weak = self.solution.timed_out or self.solution.candidates < LOOK
        everything = frozenset(range(len(self.units))) | self.presence(self.free)
        if weak and len(self.free) <= 3 * CROWD and self.can([everything])[0]:
            yield (
                "A short search found a valid layout, so there is one: give the run more candidates, more steps, "
                "more time or another seed."
            )

    def together(self) -> Iterator[str]:
        """Objects that do not fit together even without relations."""
        everyone = self.presence(self.free)
        if np.any(self.solution.status == 2):  # only relations were unmet
            self.note(everyone, True)
        if len(self.free) <= (CROWD if self.units else 3 * CROWD) and not self.can([everyone])[0]:
            order = sorted(self.free, key=lambda i: (-self.fault[:, i].mean(), -self._area(i), i))
            yield from self._crowding(order)

    def _area(self, i: int) -> float:
        return shapely.union_all([shapely.Polygon(p.polygon) for p in self.problem.solids[i]]).area

    def _crowding(self, objects: Sequence[int]) -> Iterator[str]:
        """A smallest set found of objects that do not fit together."""
        n = len(self.units)
        found = self.conflict([n + i for i in objects])
        if found is None:
            return
        ids = [self.scene.objects[i] for i in sorted(e - n for e in found)]
        everyone = " even without relations" if self.units else ""
        area = sum(self._area(self.index[o.id]) for o in ids if o.mount == "floor")
        floor = shapely.Polygon(self.scene.room.outline)
        doors = shapely.union_all([shapely.Polygon(d.polygon) for d in self.problem.region.doors.values()])
        yield (
            f"These {len(ids)} objects do not fit together{self._beside_fixed(found)}{everyone} {FOUND}: "
            f"{_list([o.id for o in ids])}. Those on the floor cover {area:.1f} m2 of the "
            f"{floor.difference(doors).area:.1f} m2 that doors leave free."
        )

    def _beside_fixed(self, part: frozenset[int]) -> str:
        """Words for a conflict that is none without the fixed objects."""
        if not any(o.fixed for o in self.scene.objects):
            return ""
        try:
            return " beside the fixed objects" if self.search([self.scene_of(part, fixed=False)], FIRM)[0] else ""
        except _OutOfTime:
            self.cut = True
            return ""

    def never(self) -> Iterator[str]:
        """Hard relations that no pose can fulfil."""
        for j, rel in enumerate(self.scene.relations):
            ids = [n for n in (rel.subject, *rel.targets) if n in self.index]
            if rel.hard and self.problem.relations[j].options == [[NEVER]]:
                yield f"{_say(rel)} can never hold{self._why_never(rel)}."
                continue
            fixed = rel.type != "around" and all(self.scene.object(n).fixed for n in ids)
            if rel.hard and fixed and not self.solution.relations[:, j].any():
                are = f"{' and '.join(ids)} {'is' if len(ids) == 1 else 'are'} fixed"
                yield f"{_say(rel)} does not hold, and {are}."

    def _why_never(self, rel: Relation) -> str:
        obj = self.scene.object(rel.subject)
        if rel.type in ("on_top", "inside"):
            if obj.support is None:
                return f": {obj.id} stands on no surface (its mount is {obj.mount})"
            if obj.support.object != rel.target:
                return f": {obj.id} stands on {obj.support.object}"
            return f": {_where(obj)} has no head room, so nothing is inside"
        if rel.type.endswith("against_wall"):
            longest = max(w.length for w in self.problem.region.walls)
            return f": {_size(obj)} is too wide (the longest wall is {longest:.2f} m)"
        if rel.type == "at_window":
            return ": the room has no window"
        return ": the room has no convex corner" if rel.type == "in_corner" else ""

    def singles(self) -> Iterator[str]:
        """Hard relations that no place was found for, though only they and their objects are in the room."""
        doubtful = [u for u in range(len(self.units)) if not self.good[:, u].any()]
        doubtful.sort(key=self._suspicion)
        for u, can in zip(doubtful, self.can([{u} for u in doubtful]), strict=True):
            if not can and self.surely_not({u}):
                yield self._settled(frozenset({u}))

    def pairs(self) -> Iterator[str]:
        """Two hard relations that do not go together."""
        keys = [self._keys(u) for u in range(len(self.units))]
        seen = self.good.astype(np.float32)
        met = seen.T @ seen > 0  # some candidate has both
        pairs = [p for p in itertools.combinations(range(len(self.units)), 2) if not met[p] and keys[p[0]] & keys[p[1]]]
        pairs.sort(key=lambda p: (self._suspicion(p[0])[0] + self._suspicion(p[1])[0], p))
        used: set[int] = set()
        for some in (pairs[i : i + CHUNK] for i in range(0, min(PAIRS, len(pairs)), CHUNK)):
            for pair, can in zip(some, self.can(some), strict=True):
                if not can and not used.intersection(pair) and self.surely_not(pair):
                    used.update(pair)
                    yield self._settled(frozenset(pair))
            if used:
                return

    def _keys(self, u: int) -> set:
        """What a unit is about: movable objects, and parts of the room that it wants."""
        keys: set = {i for i in self.named[u] if not self.scene.objects[i].fixed}
        for j in self.units[u]:
            rel = self.scene.relations[j]
            kind = CATALOGUE[rel.type].target_kind
            if kind not in ("object", "objects"):
                keys |= {t for t in rel.targets} or {rel.type}
        return keys

    def _suspicion(self, u: int) -> tuple[float, float, int]:
        """Sorts units: the most often unmet first, then those whose objects are at fault."""
        return (-float(self.unmet[:, u].mean()), -float(self.fault[:, sorted(self.named[u])].mean()), u)

    def grown(self) -> Iterator[str]:
        """A smallest set found of relations and objects, grown around the relations that are unmet most often."""
        seeds = sorted(range(len(self.units)), key=self._suspicion)
        best: frozenset[int] | None = None
        for seed in seeds[:LINES]:
            try:
                found = self.conflict(self._outward(seed))
            except _OutOfTime:
                if best is None:
                    raise
                self.cut = True
                break
            if found is not None and (best is None or len(found) < len(best)):
                best = found
            if best is not None and len(best) <= LINES:
                break
        if not seeds:
            best = self.conflict(sorted(self.presence(self.free)))
        if best is not None:
            yield self._settled(best)

    def _outward(self, seed: int) -> list[int]:
        """All elements: units by how many steps they are from the seed, then objects."""
        keys = [self._keys(u) for u in range(len(self.units))]
        step, rank, reached = 0, {seed: 0}, set(keys[seed])
        while len(rank) < len(self.units):
            step += 1
            new = [u for u in range(len(self.units)) if u not in rank and keys[u] & reached]
            if not new:
                new = [u for u in range(len(self.units)) if u not in rank]
            for u in new:
                rank[u] = step
                reached |= keys[u]
        units = sorted(rank, key=lambda u: (rank[u], self._suspicion(u)))
        objects = sorted(self.free, key=lambda i: (-self.fault[:, i].mean(), i))
        return units + [len(self.units) + i for i in objects]

    def conflict(self, order: Sequence[int]) -> frozenset[int] | None:
        """A set of elements, none of them to spare, for which no layout was found; early ones preferred."""
        try:
            for _ in range(3):  # a search that misses a layout may lead to a set that has one
                n = 1
                while n < len(order) and self.can([order[:n]])[0]:
                    n *= 2
                self.narrowest = frozenset(order[:n])
                found = self._narrow(frozenset(), False, list(order[:n]))
                if self.surely_not(found):
                    return found
        except _OutOfTime:
            raise _OutOfTime(self._so_far()) from None
        return None

    def _narrow(self, background: frozenset[int], grew: bool, rest: list[int]) -> frozenset[int]:
        """QuickXplain (Junker 2004): what of ``rest`` it takes, with the background, to have no layout."""
        if grew and not self.can([background])[0]:
            self.narrowest = background
            return frozenset()
        if len(rest) == 1:
            return frozenset(rest)
        half = len(rest) // 2
        second = self._narrow(background | set(rest[:half]), True, rest[half:])
        first = self._narrow(background | second, bool(second), rest[:half])
        return first | second

    def _so_far(self) -> list[str]:
        if self.narrowest is None or len(self.objects_of(self.narrowest)) == len(self.free) > CROWD:
            return []
        units = [self._unit_words(u) for u in sorted(self.narrowest) if u < len(self.units)]
        objects = [self.scene.objects[i].id for i in sorted(self.objects_of(self.narrowest))]
        if not units:
            return [f"By then the cause was narrowed down to these {len(objects)} objects: {_list(objects, 8)}."]
        parts = f"{_plural(len(units), 'hard relation')} and {_plural(len(objects), 'object')}"
        return [f"By then the cause was narrowed down to {parts}: {_list(units, 8, '; ')}."]

    def hints(self) -> list[str]:
        """Where it is tight, and what is wrong most often."""
        tight = self.walls.tightest(_claims(self.scene))
        return [f"It is tight: {tight}."] * bool(tight) + [_frequent(self)]

    def _settled(self, found: frozenset[int]) -> str:
        """The words for a conflict; objects alone when they do not fit together without its relations."""
        objects = sorted(self.objects_of(found))
        try:
            if len(objects) > 1 and not self.can([self.presence(objects)])[0]:
                return next(self._crowding(objects), self._tell(found))
        except _OutOfTime:
            self.cut = True
        return self._tell(found)

    def _tell(self, found: frozenset[int]) -> str:
        n = len(self.units)
        units = sorted(e for e in found if e < n)
        relations = [self._unit_words(u) for u in units]
        named = {i for u in units for i in self.named[u]}
        others = [self.scene.objects[e - n].id for e in sorted(found) if e >= n and e - n not in named]
        beside = self._beside_fixed(found)
        if others:
            beside += f" while {_list(others, 6)} {'is' if len(others) == 1 else 'are'} there"
        if len(units) == 1:
            sizes = _list([_size(self.scene.objects[i]) for i in sorted(named)], 4)
            return f"This hard relation holds nowhere{beside} {FOUND}: {relations[0]}; {sizes}."
        text = f"These {len(units)} hard relations cannot hold together{beside} {FOUND}: {_list(relations, 8, '; ')}."
        at_walls = {rel.subject for u in units for rel in self._relations(u) if rel.type.endswith("against_wall")}
        tight = self.walls.tightest([c for c in _claims(self.scene) if c.obj.id in at_walls])
        return f"{text} {tight}." if tight and len(at_walls) > 2 else text

    def _relations(self, u: int) -> list[Relation]:
        return [self.scene.relations[j] for j in self.units[u]]

    def _unit_words(self, u: int) -> str:
        relations = self._relations(u)
        if relations[0].type != "around":
            return _say(relations[0])
        return f"{_list([r.subject for r in relations], 6)} around {relations[0].target}"


def _few(lines: list[str]) -> list[str]:
    """At most LINES lines; the last says how many more there are."""
    return lines if len(lines) <= LINES else [*lines[: LINES - 1], f"And {len(lines) - LINES + 1} more like these."]


def _where(obj: SceneObject) -> str:
    assert obj.support is not None
    return f"{obj.support.surface} of {obj.support.object}"


def _span(polygon) -> str:
    """Length and width of the smallest rectangle around a polygon."""
    box = shapely.Polygon(polygon).minimum_rotated_rectangle
    points = shapely.get_coordinates(box)
    sides = sorted(np.hypot(*(points[i + 1] - points[i])) for i in range(2))
    return f"{sides[1]:.2f} x {sides[0]:.2f} m"


# --- what goes wrong most often --------------------------------------------------------------------------------------


def _violations(problem: Problem, scene: Scene, poses: np.ndarray | None) -> dict[str, tuple[str, ...]]:
    """What is wrong with one layout, in words, with the ids of the objects; relations are left out.

    ``poses`` are the world's [object, 4]; None: those of the scene.
    """
    poses = problem.home if poses is None else poses.astype(np.float64)
    ids, objects = problem.ids, scene.objects
    solids = [_shapes(_moved(s, p)) for s, p in zip(problem.solids, poses, strict=True)]
    zones = [_shapes(_moved(z, p), INTRUDED) for z, p in zip(problem.zones, poses, strict=True)]
    prisms = [(*s, *z) for s, z in zip(problem.solids, problem.zones, strict=True)]
    reach = np.array([reach_of([p.polygon for p in own]) for own in prisms])
    floor = shapely.Polygon(scene.room.outline).buffer(SUNK, join_style="mitre")
    shapes = [_shapes([p], INTRUDED) for p in problem.region.openings]
    openings = list(zip((*scene.room.doors, *scene.room.windows), shapes, strict=True))
    found: dict[str, tuple[str, ...]] = {}
    for i, obj in enumerate(objects):
        outside = any(not floor.covers(s) for s, _ in solids[i])
        low, top = _height(problem.solids[i]) + poses[i, 2]
        if outside or top > scene.room.height + 2 * SUNK or low < -2 * SUNK:
            found[f"{obj.id} is partly outside of the room"] = (obj.id,)
        if obj.mount != "wall":
            for opening, shape in openings:
                if _meet(solids[i], shape):
                    found[f"{obj.id} is in the clearance of {opening.id}"] = (obj.id,)
        gaps = np.hypot(*(poses[:, :2] - poses[i, :2]).T)
        for j in np.flatnonzero(gaps < reach + reach[i]):
            flags = int(problem.flags[i, j])
            if j > i and flags & k.PAIR_COLLIDE and _meet(solids[i], solids[j]):
                found[f"{obj.id} and {ids[j]} collide"] = (obj.id, ids[j])
            elif flags & k.PAIR_ZONE_OF_FIRST and _meet(zones[i], solids[j]) and not _meet(solids[i], solids[j]):
                found[f"{ids[j]} is in the access zone of {obj.id}"] = (obj.id, ids[j])
    return found


Shapes = list[tuple[shapely.Polygon, tuple[float, float]]]


def _shapes(prisms: Iterable[Prism], give: float = SUNK) -> Shapes:
    return [(shapely.Polygon(p.polygon).buffer(-give, join_style="mitre"), p.z) for p in prisms]


def _meet(a: Shapes, b: Shapes) -> bool:
    for s, z in a:
        for t, w in b:
            if min(z[1], w[1]) - max(z[0], w[0]) > 2 * SUNK and s.intersects(t):
                return True
    return False


def _unmet(scene: Scene, solution: Solution) -> str:
    """The hard relations that are unmet most often; costs nothing."""
    hard = [j for j, r in enumerate(scene.relations) if r.hard]
    share = (~solution.relations).sum(axis=0)
    worst = [j for j in sorted(hard, key=lambda j: (-share[j], j)) if share[j]][:LINES]
    unmet = [f"{_say(scene.relations[j])} unmet in {share[j]}" for j in worst]
    broken = int(np.sum(solution.status == 1))
    diverged = int(np.sum(solution.status == 3))
    words = [f"{broken} with a collision or something out of place"] * bool(broken) + unmet
    words += [f"{diverged} diverged"] * bool(diverged)
    return f"Of {_plural(solution.candidates, 'candidate')}: {'; '.join(words)}."


def _frequent(study: _Study) -> str:
    """What is wrong most often in the best candidates."""
    scene, top = study.scene, study.top[: max(4, min(BEST, 800 // max(1, len(study.scene.objects))))]
    counts: Counter[str] = Counter()
    for c in top[np.isfinite(study.solution.poses[top]).all(axis=(1, 2))]:
        counts.update(_violations(study.problem, scene, study.solution.poses[c]).keys())
        for j, rel in enumerate(scene.relations):
            if rel.hard and not study.solution.relations[c, j]:
                counts[f"{_say(rel)} is unmet"] += 1
    if not counts:
        return _unmet(scene, study.solution)
    worst = sorted(counts.items(), key=lambda item: (-item[1], item[0]))[: LINES + 1]
    which = f"In the best {len(top)} layouts" if len(top) > 1 else "In the only layout"
    return f"{which}: {'; '.join(f'{text} ({n})' for text, n in worst)}."
