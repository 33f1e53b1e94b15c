"""What arithmetic can prove about the space that there is.

By horizontal sections of prisms: an object that fits at no yaw, a floor or surface that is too small. Along walls:
objects that must stand at one against the wall that is free.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from sceneweaver.geometry.angles import cross, dot
from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.polygons import union
from sceneweaver.geometry.se2 import SE2
from sceneweaver.layout.region import Region
from sceneweaver.layout.shapes import Points, Prism
from sceneweaver.scene import CATALOGUE, Room, Scene, SceneObject

from .words import crowd_words, few, listed, short_length, sized

PENETRATION = 1.0e-3  # [m] that bodies may sink into each other and into walls
INTRUSION = 5.0e-3  # [m] that they may reach into the clearance of a door or window


def hull(solids: Sequence[Prism]) -> Points:
    """The convex hull of solids, seen from above."""
    return convex_hull(np.concatenate([p.polygon for p in solids]))


def extent(prisms: Sequence[Prism]) -> tuple[float, float]:
    """Lowest and highest point of an object above its origin."""
    return min(p.z[0] for p in prisms), max(p.z[1] for p in prisms)


def levels_between(prisms: Iterable[Prism]) -> list[float]:
    """Heights in the middle between any two neighbouring ends of prisms."""
    ends = sorted({round(z, 4) for p in prisms for z in p.z})
    return [0.5 * (a + b) for a, b in itertools.pairwise(ends) if b - a > 4 * PENETRATION]


def section(prisms: Iterable[Prism], z: float, shrink: float = PENETRATION):
    """The section of prisms at height z, each smaller by what may sink in."""
    shapes = [
        shapely.Polygon(p.polygon).buffer(-shrink, join_style="mitre")
        for p in prisms
        if p.z[0] + PENETRATION < z < p.z[1] - PENETRATION
    ]
    return union(shapes)


def moved(prisms: Iterable[Prism], pose: np.ndarray) -> list[Prism]:
    """Prisms of an object, in the room that it has this pose [x, y, z, yaw] in."""
    x, y, z, yaw = (float(value) for value in pose)
    return [Prism(SE2(x, y, yaw).to_world(p.polygon), (p.z[0] + z, p.z[1] + z)) for p in prisms]


def fits_turned(points: Points, planes: np.ndarray) -> bool:
    """Whether a convex hull may fit between half planes [N, 3] (normal, offset) that enclose an area at some yaw; False
    is certain."""
    steps = 360
    angles = np.arange(steps) * (2 * math.pi / steps)
    reach = float(np.max(np.hypot(points[:, 0], points[:, 1])))
    slack = 2 * PENETRATION + reach * math.pi / steps
    normals, offsets = planes[:, :2], planes[:, 2]
    lowest = np.array([(SE2(yaw=angle).to_world(points) @ normals.T).min(axis=0) for angle in angles])
    need = offsets - lowest - slack  # [yaw, plane]: how far inside the hull's origin has to be
    # Places that are far enough inside of all planes form a convex area, which has a corner where two planes meet.
    i, j = np.triu_indices(len(planes), 1)
    det = cross(normals[i].T, normals[j].T)
    i, j, det = (values[np.abs(det) > 1e-9] for values in (i, j, det))
    x = (need[:, i] * normals[j, 1] - need[:, j] * normals[i, 1]) / det
    y = (need[:, j] * normals[i, 0] - need[:, i] * normals[j, 0]) / det
    inside = x[..., None] * normals[:, 0] + y[..., None] * normals[:, 1] >= need[:, None] - 1e-9
    return bool(inside.all(axis=2).any())


@dataclass(frozen=True)
class Fullness:
    """Footprints on a floor or surface at the height where they need most, against what there is [m2]."""

    need: float
    free: float
    count: int


def fullest(
    solids: Sequence[Sequence[Prism]], floor, blocked: Sequence[tuple[Prism, float]], most: int = 8
) -> Fullness | None:
    """The height at which sections exceed the free area most; None when they do nowhere.

    Sections at one height must not overlap, so their sum over the free area proves that there is not enough.
    """
    levels = levels_between(p for s in solids for p in s)
    if not levels:
        return None
    needs = np.zeros(len(levels))
    counts = np.zeros(len(levels), dtype=int)
    for prisms in solids:
        areas: dict[tuple[int, ...], float] = {}
        for i, z in enumerate(levels):
            there = tuple(j for j, p in enumerate(prisms) if p.z[0] < z < p.z[1])
            if there and there not in areas:
                areas[there] = section([prisms[j] for j in there], z).area
            needs[i] += areas.get(there, 0.0)
            counts[i] += bool(there)
    worst = None
    for i in np.argsort(-needs)[:most]:
        taken = [
            shapely.Polygon(p.polygon).buffer(-give, join_style="mitre")
            for p, give in blocked
            if p.z[0] + PENETRATION < levels[i] < p.z[1] - PENETRATION
        ]
        free = floor.buffer(PENETRATION, join_style="mitre").difference(union(taken)).area
        if needs[i] > free and (worst is None or needs[i] - free > worst.need - worst.free):
            worst = Fullness(float(needs[i]), float(free), int(counts[i]))
    return worst


@dataclass(frozen=True)
class Claim:
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
        solid = section(prisms, z, 0.0).buffer(1e-4, join_style="mitre")
        if self.side:
            return min(d, w) if solid.covers(shapely.box(-d / 2, -w / 2, d / 2, w / 2)) else 0.0
        for share in (1.0, 0.75, 0.5, 0.25):
            if solid.covers(shapely.box(-d / 2, -w / 2, -d / 2 + share * d, w / 2)):
                return share * d
        return 0.0

    def near(self) -> float:
        """Farthest from the wall [m] that the near face's corners can be."""
        return self.gap + self.across / 2 * math.sin(self.angle) + PENETRATION

    def far(self, depth: float) -> float:
        """Nearest to the wall [m] that the far face's corners can be."""
        return depth * math.cos(self.angle) - self.across / 2 * math.sin(self.angle) - PENETRATION


def wall_claims(scene: Scene) -> list[Claim]:
    """One claim for every object that has to stand at a wall and is upright and free to move."""
    claims: dict[str, Claim] = {}
    for rel in scene.relations:
        if not rel.hard or rel.type not in CATALOGUE.with_role("wall"):
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
        claim = Claim(
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
    claims: list[Claim]
    need: float
    usable: float
    stretches: list[float]


class Walls:
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
            openings = section(self.region.openings, z, INTRUSION)
            self.free[key] = self.floor.difference(openings).difference(section(self.fixed, z))
        free = self.free[key]
        out = []
        for wall in self.region.walls:
            ends = [wall.point(at, line) for at in (-spare, wall.length + spare)]
            hit = free.intersection(shapely.LineString(ends))
            pieces = [g for g in getattr(hit, "geoms", [hit]) if g.geom_type == "LineString" and not g.is_empty]
            spans = [sorted(wall.coordinates(p)[0] for p in g.coords) for g in pieces]
            out.append(sorted((s[0], s[-1]) for s in spans))
        return out

    def corner_loss(self, claims: Sequence[Claim], depths: Sequence[float], line: float) -> float:
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
            square = abs(dot(wall.along, walls[j].along)) < 1e-3 and dot(wall.inward, walls[j].along) > 0
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

    def missing(self, claims: Sequence[Claim]) -> list[str]:
        """Lines about claims that the walls cannot meet."""
        lines, hopeless = [], set()
        for claim in claims:
            text = self._worst([claim], claim.wall)
            if text:
                lines.append(text)
                hopeless.add(claim.obj.id)
        lines = few(lines)
        rest = [c for c in claims if c.obj.id not in hopeless]
        text = self._worst(rest, None)
        if text:
            return [*lines, text]
        for wall in sorted({c.wall for c in rest if c.wall is not None}):
            group = [c for c in rest if c.wall == wall]
            text = self._worst(group, wall) if len(group) > 1 else None
            lines += [text] if text else []
        return lines

    def _worst(self, claims: Sequence[Claim], wall: int | None) -> str | None:
        """The line for the height at which most wall is missing; None when there is enough."""
        worst = max(self._rows(claims, wall), key=lambda row: row.need - row.usable, default=None)
        return None if worst is None or worst.need - worst.usable < 1e-3 else self._text(worst, wall)

    def tightest(self, claims: Sequence[Claim]) -> str | None:
        """How much of the wall is claimed at the height where it is tightest; None below three quarters."""
        row = max(self._rows(claims, None), key=lambda row: row.need / max(row.usable, 1e-3), default=None)
        if row is None or row.need < 0.75 * row.usable:
            return None
        crowd, need = crowd_words([c.obj for c in row.claims]), sum(c.length for c in row.claims)
        return f"{crowd} need {need:.1f} m of the {sum(row.stretches):.1f} m of wall{self._free(row.z) or ' there is'}"

    def _rows(self, claims: Sequence[Claim], wall: int | None) -> Iterator[_Row]:
        """What stands along the walls at any height, on one line at a distance from them that all of it reaches."""
        prisms = [Prism(np.zeros((3, 2)), p.z) for c in claims for p in c.obj.solids]
        levels = levels_between([*prisms, *self.region.openings])
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
            return f"{sized(row.claims[0].obj)} needs {need:.2f} m of {where}; {left}."
        crowd = crowd_words([c.obj for c in row.claims])
        start = f"{crowd} need {need:.1f} m of {where}; {there:.1f} m is{free or ' there'}"
        if row.usable > there - 0.1:
            return f"{start}: {short_length(need - there)} m missing."
        parts = listed([f"{s:.1f}" for s in sorted(row.stretches, reverse=True) if s > 0.05], 6)
        most = f"hold {row.usable:.1f} m of them at most: {short_length(need - row.usable)} m missing"
        return f"{start}, and its stretches ({parts} m; a corner serves one wall) {most}."
