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
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely

from sceneweaver.kernels import tables as k
from sceneweaver.optimizers import judge, load_poses
from sceneweaver.scene import CATALOGUE, Relation, Room, Scene, SceneObject, Surface

from .compile import Problem, compile_scene, relative
from .region import Region, Wall, room_region, walls_of
from .rows import NEVER
from .shapes import Points, Prism, solids_of
from .solution import Solution

LONGEST = 10.0  # [s] that an explanation may take
RESERVE = 0.3  # [s] of it kept for the last words
LOOK = 256  # candidates of the solution that are looked at
BEST = 16  # candidates whose violations are counted
PAIRS = 160  # pairs of relations that are tried
LINES = 3  # of one kind
FOUND = "(found by search, which is no proof)"

PENETRATION = 1.0e-3  # [m] that bodies may sink into each other and into walls
INTRUSION = 5.0e-3  # [m] that they may reach into the clearance of a door or window

Effort = tuple[int, int]  # candidates, attempts
QUICK: Effort = (32, 1)
FIRM: Effort = (64, 3)
SURE: Effort = (192, 6)
CROWD = 40  # objects from which on a test stays quick


class _OutOfTime(Exception):
    """The clock cut the search off; ``text`` is what it had found by then."""

    def __init__(self, text: str | None = None) -> None:
        super().__init__(text)
        self.text = text


def explain(
    scene: Scene, solution: Solution, *, device: str, seed: int, deadline: float | None = None
) -> str | None:
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
    lines = []
    if solution.timed_out:
        lines.append(
            f"The time limit stopped the run after {solution.elapsed:.1f} s, before any layout was valid: "
            "that is no proof that there is none."
        )
    until = end - min(RESERVE, 0.1 * (end - start))
    if until - time.monotonic() < 0.02:
        return "\n".join(lines + [_unmet(scene, solution)])
    study = _Study(scene, solution, device, seed, until)
    try:
        causes = study.causes()
    except _OutOfTime as cut:
        spent = time.monotonic() - start
        causes = [f"Looking for the cause was stopped after {spent:.1f} s." + (f" {cut.text}" if cut.text else "")]
        causes += [_frequent(study)]
    return "\n".join(lines + (causes or [f"No single cause was found. {_frequent(study)}"]))


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
        number = f"{value[0]:g} to {value[1]:g}" if isinstance(value, tuple) else f"{value:g}"
        params.append(f"{name} {number}{units[CATALOGUE[rel.type].params[name].unit]}")
    return " ".join([rel.subject, rel.type, " and ".join(rel.targets)]).rstrip() + (
        f" ({', '.join(params)})" if params else ""
    )


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
    return np.asarray(shape.exterior.coords[:-1])


def _height(obj: SceneObject) -> tuple[float, float]:
    """Lowest and highest point of an upright object above its origin."""
    return min(p.z[0] for p in obj.solids), max(p.z[1] for p in obj.solids)


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
    length: float
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
        return self.gap + self.length / 2 * math.sin(self.angle) + PENETRATION

    def far(self, depth: float) -> float:
        """Nearest to the wall [m] that the far face's corners can be."""
        return depth * math.cos(self.angle) - self.length / 2 * math.sin(self.angle) - PENETRATION


def _claims(scene: Scene) -> list[_Claim]:
    """One claim for every object that has to stand at a wall and is upright and free to move."""
    claims: dict[str, _Claim] = {}
    for rel in scene.relations:
        if not rel.hard or rel.type not in ("against_wall", "side_against_wall"):
            continue
        obj, spec = scene.object(rel.subject), CATALOGUE[rel.type]
        if obj.fixed or obj.mount != "floor":
            continue
        side = rel.type == "side_against_wall"
        d, w, _ = obj.size
        length, degrees = (min(d, w) if side else w), spec.value(rel, "degrees")
        if degrees > 15:  # the arithmetic is for objects that stand nearly along the wall
            continue
        claim = _Claim(
            obj,
            int(rel.target.split(":")[1]) if isinstance(rel.target, str) else None,
            length,
            spec.gap_range(rel, d)[1],
            math.radians(degrees),
            (1 - spec.value(rel, "overlap")) * length,
            side,
        )
        if rel.subject not in claims or (claims[rel.subject].wall is None and claim.wall is not None):
            claims[rel.subject] = claim
    return list(claims.values())


def _most_within(lengths: Sequence[float], room: float) -> float:
    """The largest sum of some of the lengths that is at most ``room``, to the millimetre and rounded up."""
    sums, limit = 1, math.ceil(room * 1000)
    mask = (1 << (limit + 1)) - 1
    for length in lengths:
        sums |= (sums << math.floor(length * 1000)) & mask
    return (sums.bit_length() - 1) / 1000


class _Walls:
    """How much wall there is for objects that must stand along one."""

    def __init__(self, room: Room, region: Region, fixed: Sequence[Prism]) -> None:
        self.room, self.region, self.fixed = room, region, fixed
        self.floor = shapely.Polygon(room.outline).buffer(PENETRATION, join_style="mitre")

    def blockers(self, z: float) -> list[str]:
        """What keeps wall from being free at height z, in words."""
        n = len(self.room.doors)
        openings = [p.z[0] < z < p.z[1] for p in self.region.openings]
        words = ["doors"] * any(openings[:n]) + ["windows"] * any(openings[n:])
        return words + ["fixed objects"] * any(p.z[0] < z < p.z[1] for p in self.fixed)

    def stretches(self, z: float, line: float, spare: float) -> list[list[tuple[float, float]]]:
        """For every wall the free stretches [from, to] of the line along it, ``line`` metres inside, at height z."""
        openings = _cut(self.region.openings, z, INTRUSION)
        free = self.floor.difference(openings).difference(_cut(self.fixed, z))
        shapely.prepare(free)
        out = []
        for wall in self.region.walls:
            ends = [wall.p + line * wall.n + at * wall.t for at in (-spare, wall.length + spare)]
            hit = free.intersection(shapely.LineString(ends))
            pieces = [g for g in getattr(hit, "geoms", [hit]) if g.geom_type == "LineString" and not g.is_empty]
            spans = [sorted(float((np.asarray(p) - wall.p) @ wall.t) for p in g.coords) for g in pieces]
            out.append(sorted((s[0], s[-1]) for s in spans))
        return out

    def corner_loss(
        self, stretches: list[list[tuple[float, float]]], claims: Sequence[_Claim], depths: Sequence[float], line: float
    ) -> float:
        """Wall that is lost at square corners for certain: of the two objects nearest to a corner, one makes the other
        keep away from it by its own depth."""
        reach = [c.far(d) for c, d in zip(claims, depths, strict=True)]
        drift = max(math.tan(c.angle) for c in claims) * max(reach)
        least = min(reach) - drift - 2 * PENETRATION
        if least <= 0 or min(c.length for c in claims) < line + 2 * drift:
            return 0.0
        lost = 0.0
        walls = self.region.walls
        for i, wall in enumerate(walls):
            j = (i + 1) % len(walls)
            after = walls[j]
            square = abs(float(wall.t @ after.t)) < 1e-3 and float(wall.n @ after.t) > 0
            if not square or not stretches[i] or not stretches[j]:
                continue
            a, b = stretches[i][-1], stretches[j][0]
            if abs(a[1] - wall.length) < 0.02 and abs(b[0]) < 0.02:
                lost += max(0.0, min(least, (a[1] - a[0]) / 2, (b[1] - b[0]) / 2))
        return lost

    def missing(self, claims: Sequence[_Claim]) -> list[str]:
        """Lines about claims that the walls cannot meet."""
        lines, hopeless = [], set()
        for claim in claims:
            text = self._worst([claim], lambda c: (c.wall,) if c.wall is not None else None)
            if text:
                lines.append(text)
                hopeless.add(claim.obj.id)
        if len(lines) > LINES:
            lines[LINES - 1 :] = [f"{len(lines) - LINES + 1} more objects are too wide for any free stretch of wall."]
        rest = [c for c in claims if c.obj.id not in hopeless]
        text = self._worst(rest, lambda c: None)
        if text:
            return [*lines, text]
        for wall in sorted({c.wall for c in rest if c.wall is not None}):
            group = [c for c in rest if c.wall == wall]
            text = self._worst(group, lambda c: (c.wall,)) if len(group) > 1 else None
            lines += [text] if text else []
        return lines

    def _worst(self, claims: Sequence[_Claim], walls_for: Callable[[_Claim], tuple[int, ...] | None]) -> str | None:
        """The line for the height at which most wall is missing; None when there is enough."""
        if not claims:
            return None
        prisms = [Prism(np.zeros((3, 2)), p.z) for c in claims for p in c.obj.solids]
        levels = _levels([*prisms, *self.region.openings])
        if len(levels) > 24:
            levels = [levels[i] for i in np.linspace(0, len(levels) - 1, 24).astype(int)]
        worst, text, seen = 0.0, None, set()
        for z in levels:
            depths = {c.obj.id: c.depth(z) for c in claims}
            group = [c for c in claims if depths[c.obj.id] > 0]
            while group:  # all on one line: leave out what is too thin to reach the line of the others
                line = max(c.near() for c in group)
                thick = [c for c in group if c.far(depths[c.obj.id]) > line]
                if len(thick) == len(group):
                    break
                group = thick
            key = (tuple(c.obj.id for c in group), tuple(p.z[0] < z < p.z[1] for p in self.region.openings))
            if not group or key in seen or line > 0.29:  # beyond the clearance of windows
                continue
            seen.add(key)
            wanted = walls_for(group[0])
            stretches = self.stretches(z, line, max(c.spare for c in group))
            spans = [s for w, each in enumerate(stretches) if wanted is None or w in wanted for s in each]
            lengths = [c.length - 2 * PENETRATION for c in group]
            need, there = sum(c.length for c in group), sum(b - a for a, b in spans)
            usable = sum(_most_within(lengths, b - a) for a, b in spans)
            corners = 0.0
            if wanted is None and len(group) > 1:
                corners = self.corner_loss(stretches, group, [depths[c.obj.id] for c in group], line)
            short = sum(lengths) - min(usable, there - corners)
            if short > max(worst, 1e-3):
                worst = short
                text = self._text(group, wanted, z, need, there, usable, corners, spans)
        return text

    def _text(self, group, wanted, z, need, there, usable, corners, spans) -> str:
        blockers = self.blockers(z)
        free = f" free of {' and '.join(blockers)}" if blockers else " long"
        where = "wall" if wanted is None else f"wall:{wanted[0]}"
        if len(group) == 1:
            longest = max((b - a for a, b in spans), default=0.0)
            stretch = f"no stretch{free}" if longest < 0.05 else f"the longest stretch{free} is {longest:.2f} m"
            if longest < 0.05:
                stretch += " is left"
            return f"{_size(group[0].obj)} needs {need:.2f} m of {where}; {stretch}."
        crowd = _crowd([c.obj for c in group])
        start = f"{crowd} need {need:.1f} m of {where}; {there:.1f} m is{free}"
        if there < need:
            best = min(there, usable, there - corners)
            if best > there - 0.1:
                return f"{start}: {need - there:.1f} m missing."
        else:
            best = min(usable, there - corners)
        if usable <= there - corners:
            parts = _list([f"{b - a:.1f}" for a, b in sorted(spans, key=lambda s: s[0] - s[1]) if b - a > 0.05], 6)
            return f"{start}, in stretches ({parts} m) that hold {best:.1f} m of them at most: {need - best:.1f} m missing."
        return f"{start}, but at corners at least {corners:.1f} m of it is lost: {need - best:.1f} m missing."


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
        self.scene, self.solution, self.device, self.seed, self.until = scene, solution, device, seed, until
        self.compiled = compile_scene(scene)
        self.problem = self.compiled.room
        self.index = {o.id: i for i, o in enumerate(scene.objects)}
        self.free = [i for i, o in enumerate(scene.objects) if not o.fixed]
        self.units = self._make_units()
        self.named = [self._named(unit) for unit in self.units]
        order = np.lexsort((solution.energy, solution.status == 3))
        self.top = order[: min(LOOK, len(order))]
        self.possible: list[frozenset[int]] = []
        self.impossible: list[frozenset[int]] = []

    # parts

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

    def scene_of(self, part: Iterable[int], fixed: bool = True, room: Room | None = None) -> Scene:
        """The scene reduced to a part. Relations that let objects into each other's zones stay as faint soft ones."""
        part = set(part)
        keep = set(self.objects_of(part))
        named = {i for e in part if e < len(self.units) for i in self.named[e]}
        keep |= self._carriers(i for i, o in enumerate(self.scene.objects) if o.fixed and (fixed or i in named))
        ids = {self.scene.objects[i].id for i in keep}
        hard = {j for e in part if e < len(self.units) for j in self.units[e]}
        relations = []
        for j, rel in enumerate(self.scene.relations):
            if j in hard:
                relations.append(rel)
            elif CATALOGUE[rel.type].ties_zones and {rel.subject, *rel.targets} <= ids:
                relations.append(rel.model_copy(update={"hard": False, "weight": 1e-3}))
        update = {
            "objects": tuple(o for i, o in enumerate(self.scene.objects) if i in keep),
            "relations": tuple(relations),
            "room": self.scene.room if room is None else room,
        }
        return self.scene.model_copy(update=update)

    # tests

    def search(self, scenes: Sequence[Scene], effort: Effort) -> list[bool]:
        """Which scenes a small refinement finds a valid layout for; raises _OutOfTime when the clock cuts it off."""
        refine_many, silent = _refine_many()
        left = self.until - time.monotonic()
        if left <= 0:
            raise _OutOfTime
        candidates, steps = effort
        solutions = refine_many(
            scenes,
            candidates=candidates,
            seed=(self.seed + 7919 * steps) % 2**32,
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
        """What earlier tests say about a closed part."""
        if not self.objects_of(part) and all(e >= len(self.units) for e in part):
            return True
        if any(part <= other for other in self.possible):
            return True
        return False if any(other <= part for other in self.impossible) else None

    def note(self, part: frozenset[int], can: bool) -> None:
        """Remember the outcome of a test."""
        if can:
            self.impossible = [p for p in self.impossible if not p <= part]
        (self.possible if can else self.impossible).append(part)

    def can(self, parts: Sequence[Iterable[int]], effort: Effort = FIRM) -> list[bool]:
        """Whether each part has a layout, as far as a search tells: first a quick one, then a firmer one."""
        closed = [self.closed(p) for p in parts]
        answers = {p: a for p in dict.fromkeys(closed) if (a := self.known(p)) is not None}
        for level in (QUICK, effort):
            open_ = [p for p in dict.fromkeys(closed) if p not in answers]
            if level != QUICK or effort != QUICK:
                crowded = [p for p in open_ if len(self.objects_of(p)) > CROWD and level != QUICK]
                for p in crowded:
                    answers[p] = False
                    self.note(p, False)
                open_ = [p for p in open_ if p not in answers]
            for some in itertools.batched(open_, 48) if open_ else ():
                found = self.search([self.scene_of(p) for p in some], level)
                for part, ok in zip(some, found, strict=True):
                    if ok or level == effort:
                        answers[part] = ok
                        self.note(part, ok)
        return [answers[p] for p in closed]

    def surely_not(self, part: Iterable[int]) -> bool:
        """Whether a part has no layout even for a long search."""
        closed = self.closed(part)
        found = self.search([self.scene_of(closed)], SURE)[0]
        self.note(closed, found)
        return not found
