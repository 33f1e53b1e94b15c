"""Compile a scene: one problem for the room, one for each support surface that carries something.

Floor, wall and ceiling objects of a room are solved together in the room's frame. What stands on a surface is solved
in that surface's own frame and then carried along by its supporter; the room's problem lists it too, so that the
verdict and the pair terms see the whole scene.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.geometry.polygons import tidy
from sceneweaver.geometry.se2 import relative
from sceneweaver.kernels import tables as k
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import CATALOGUE, Relation, Room, Scene, SceneObject

from .free_floor import StandIns, flags_of, stand_ins, walker
from .region import Region, enclosure, room_region
from .rows import INF, CompiledRelation, Frame, compile_relation, mounting, spread_before
from .shapes import Prism, footprint_of, solids_of, zones_of
from .user import compiled_terms
from .yaw_domain import into_domain, into_domains, turns_along, yaws_of


@dataclass
class SupportSurface:
    """What a support surface carries: indices of supporter and members, height of the surface above the supporter."""

    supporter: int
    height: float
    members: list[int]


@dataclass
class LayoutProblem:
    """One layout problem in plain arrays; see ``kernels.tables`` for what the kernels make of it.

    ``home`` holds the scene's poses [object, 4] (x, y, z, yaw) in the problem's frame; ``relations`` the scene's
    relations first (``relation_ids`` names them), then what the engine adds: riders (conditions that belong to a
    relation before them), the mountings of wall objects, and terms of the user's own. ``walker`` is the
    radius [m] of who has to get about, where the scene says one. ``yaws`` are the yaws [rad] that each object may take,
    in the problem's frame; none: any. ``packed`` keeps by device tables with it and its number there, see `make_batch`.
    """

    ids: list[str]
    region: Region
    sizes: np.ndarray
    home: np.ndarray
    free: np.ndarray
    clear: np.ndarray
    roots: np.ndarray
    groups: list[list[int]]
    parents: np.ndarray
    solids: list[list[Prism]]
    footprints: list[list[np.ndarray]]
    zones: list[list[Prism]]
    flags: np.ndarray
    relations: list[CompiledRelation]
    relation_ids: list[int]
    riders: dict[int, int]
    yaws: list[tuple[float, ...]]
    faulty: bool = False
    walker: float | None = None
    surfaces: list[SupportSurface] = field(default_factory=list)
    packed: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def size(self) -> int:
        """Number of objects."""
        return len(self.ids)


@dataclass
class Domain:
    """A support surface with what stands on it, in the supporter's frame; heights are above the surface."""

    surface: SupportSurface
    problem: LayoutProblem


@dataclass
class CompiledScene:
    """The room's problem and its domains, supporters before what they carry."""

    scene: Scene
    room: LayoutProblem
    domains: list[Domain]
    stand_ins: StandIns = field(default_factory=StandIns)

    def bodies(self, world: np.ndarray) -> np.ndarray:
        """Poses [B, N + F, 4] of all bodies of the room's problem, objects [B, N, 4] and the stand-ins of free areas.

        Poses that have these already are given back as they are.
        """
        if not self.stand_ins.objects or world.shape[1] == self.room.size:
            return world
        return np.concatenate([world, self.stand_ins.poses(world)], axis=1)


def _ties(relations: Sequence[Relation], index: dict[str, int]) -> set[tuple[int, int]]:
    """Pairs that may stand in each other's hard zones."""
    ties = set()
    for rel in relations:
        if (
            CATALOGUE[rel.type].ties_zones
            and isinstance(rel.target, str)
            and rel.target in index
            and rel.subject in index
        ):
            a, b = index[rel.subject], index[rel.target]
            ties |= {(a, b), (b, a)}
    return ties


def _roots(objects: Sequence[SceneObject], index: dict[str, int]) -> np.ndarray:
    """The object at the bottom of each stack."""
    roots = np.arange(len(objects))
    for i, obj in enumerate(objects):
        at = obj
        while at.support is not None and at.support.object in index:
            roots[i] = index[at.support.object]
            at = objects[roots[i]]
    return roots


def _families(
    relations: Sequence[Relation],
    index: dict[str, int],
    roots: np.ndarray,
    free: np.ndarray,
    yaws: Sequence[tuple[float, ...]],
):
    """Who goes along with whom: each root's group (itself and what it carries, then the groups of the objects that
    relations place by it, if its turns keep them in their domains of yaw) and each root's parent (-1: none)."""
    n = len(roots)
    parents = np.full(n, -1, dtype=np.int32)
    placing = CATALOGUE.with_role("placing")
    for rel in relations:
        if rel.type not in placing or not isinstance(rel.target, str) or rel.target not in index:
            continue
        child, parent = index[rel.subject], int(roots[index[rel.target]])
        if roots[child] == child and child != parent and free[child] and free[parent] and parents[child] < 0:
            chain = parent
            while chain >= 0 and chain != child:
                chain = parents[chain]
            if chain < 0 and turns_along(yaws[child], yaws[parent]):  # no object is its own ancestor
                parents[child] = parent

    carried: dict[int, list[int]] = {}
    placed: dict[int, list[int]] = {}
    for j in range(n):
        if roots[j] != j:
            carried.setdefault(int(roots[j]), []).append(j)
        if parents[j] >= 0:
            placed.setdefault(int(parents[j]), []).append(j)

    groups: list[list[int]] = [[] for _ in range(n)]
    for i in reversed(_parents_first(parents)):  # the groups of what it places are there before its own
        if roots[i] == i:
            groups[i] = [i, *carried.get(i, ()), *(k for j in placed.get(i, ()) for k in groups[j])]
    return groups, parents


def _parents_first(parents: Sequence[int] | np.ndarray) -> list[int]:
    """All indices, those of parents (-1: none) before those of their children."""
    order: dict[int, None] = {}
    for i in range(len(parents)):
        chain, at = [], i
        while at >= 0 and at not in order:
            chain.append(at)
            at = int(parents[at])
        order.update(dict.fromkeys(reversed(chain)))
    return list(order)


def _freedom(obj: SceneObject, carried: bool) -> int:
    if obj.fixed or carried:
        return 0
    turning = k.FREE_YAW if obj.yaw_domain is None else k.FREE_TURNS
    return k.FREE_PLANE | turning | (k.FREE_Z if obj.mount == "wall" else 0)


def _keeps_clear(obj: SceneObject) -> bool:
    """Whether doors and windows must stay free of it: not of what hangs on walls, unless its intent says so, as for
    pictures; to the judge that is no fault."""
    return obj.mount != "wall" or obj.intent.keep_clear


def _home(objects: Sequence[SceneObject]) -> np.ndarray:
    return np.array([(*o.pose.position, o.pose.yaw) for o in objects], dtype=np.float64).reshape(-1, 4)


def _flags(
    zones: list[list[Prism]], roots: np.ndarray, ties: set[tuple[int, int]], fixed: Sequence[bool]
) -> np.ndarray:
    """Pair flags [n, n]."""
    n = len(zones)
    flags = np.full((n, n), k.PAIR_COLLIDE, dtype=np.uint8)
    zoned = np.array([bool(z) for z in zones], dtype=bool)
    free_of = zoned[:, None] & np.ones((n, n), dtype=bool)
    for a, b in ties:
        free_of[a, b] = False
    flags[free_of] |= k.PAIR_ZONE_OF_FIRST
    flags[free_of.T] |= k.PAIR_ZONE_OF_SECOND
    still = np.asarray(fixed, dtype=bool)[roots]
    flags[(roots[:, None] == roots[None, :]) | (still[:, None] & still[None, :])] |= k.PAIR_RIGID
    np.fill_diagonal(flags, 0)
    return flags


def _compile(
    objects: Sequence[SceneObject],
    home: np.ndarray,
    region: Region,
    relations: Sequence[tuple[int, Relation]],
    room: Room | None,
    plates: StandIns | None = None,
    terms: bool = True,
) -> LayoutProblem:
    in_room = room is not None
    plates = plates or StandIns()
    index = {o.id: i for i, o in enumerate(objects)}
    solids = [solids_of(o) for o in objects]
    footprints = [footprint_of(s) for s in solids]
    zones = [zones_of(o) for o in objects]
    around: dict[str, list[Relation]] = {}
    for _, rel in relations:
        if rel.type == "around" and isinstance(rel.target, str):
            around.setdefault(rel.target, []).append(rel)
    tied = Counter((rel.type, rel.target) for _, rel in relations if isinstance(rel.target, str))
    openings = (room.windows, room.doors) if room is not None else ((), ())
    frame = Frame(objects, index, region, footprints, *openings, around, tied)
    compiled = []
    for _, rel in relations:
        checkpoint()
        compiled.append(compile_relation(frame, rel))
    riders: dict[int, int] = {}
    for i, (_, rel) in enumerate(relations):
        extra = spread_before(frame, rel) if rel.type == "around" else None
        if extra is not None:
            riders[len(compiled)] = i
            compiled.append(extra)
    if in_room:
        compiled += [mounting(frame, i) for i, o in enumerate(objects) if o.mount == "wall"]
        compiled += compiled_terms(frame) if terms else []
        compiled += [compile_relation(frame, rel) for rel in plates.relations]
    roots = _roots(objects, index) if in_room else np.arange(len(objects))
    free = np.array([_freedom(o, in_room and roots[i] != i) for i, o in enumerate(objects)], dtype=np.int32)
    stated = [r for _, r in relations]
    yaws = [() if roots[i] != i else yaws_of(o) for i, o in enumerate(objects)]
    groups, parents = _families([*stated, *plates.relations], index, roots, free, yaws)
    ties = _ties(stated, index)
    flags = flags_of(_flags(zones, roots, ties, [o.fixed for o in objects]), plates, ties, roots)
    clear = [_keeps_clear(o) for o in objects]
    clear[len(objects) - len(plates.objects) :] = [not over for over in plates.over_doors]
    return LayoutProblem(
        ids=[o.id for o in objects],
        region=region,
        sizes=np.array([o.size for o in objects], dtype=np.float64).reshape(-1, 3),
        home=home,
        free=free,
        clear=np.array(clear, dtype=np.int32),
        roots=roots,
        groups=groups,
        parents=parents,
        solids=solids,
        footprints=footprints,
        zones=zones,
        flags=flags,
        relations=compiled,
        relation_ids=[i for i, _ in relations],
        riders=riders,
        yaws=yaws,
    )


def poses_of(scene: Scene) -> tuple[np.ndarray, bool]:
    """Poses with the heights that mounting demands, and whether a fixed object contradicts its own."""
    home = _home(scene.objects)
    faulty = False
    for i, obj in enumerate(scene.objects):
        if obj.mount in ("floor", "ceiling"):
            height = 0.0 if obj.mount == "floor" else scene.room.height - obj.size[2]
            if obj.fixed:
                faulty |= abs(home[i, 2] - height) > 1.8e-3
            else:
                home[i, 2] = height
    index = {o.id: i for i, o in enumerate(scene.objects)}
    yaws, movable = [yaws_of(o) for o in scene.objects], [not o.fixed for o in scene.objects]
    return into_domains(yaws, movable, _roots(scene.objects, index), home[None])[0], faulty


def _domain_region(supporter: SceneObject, name: str) -> tuple[Region, float]:
    """The surface as a region: its polygon, its head room, and the supporter's own parts above it."""
    surface = next(s for s in supporter.surfaces if s.name == name)
    top = INF if surface.headroom is None else surface.headroom
    region = enclosure(tidy(surface.polygon), top)
    for part in supporter.solids:
        z = (part.z[0] - surface.z, part.z[1] - surface.z)
        if z[1] > 1e-3 and z[0] < top:
            region.solids.append(Prism(tidy(part.polygon), z))
    return region, surface.z


def compile_scene(scene: Scene, *, terms: bool = True) -> CompiledScene:
    """Compile a validated scene; without ``terms`` as if the user had defined none."""
    home, faulty = poses_of(scene)
    index = {o.id: i for i, o in enumerate(scene.objects)}
    groups: dict[tuple[str, str], list[int]] = {}
    for i, obj in enumerate(scene.objects):
        if obj.support is not None:
            groups.setdefault((obj.support.object, obj.support.surface), []).append(i)

    depths = [0] * len(scene.objects)
    carriers = [-1 if o.support is None else index[o.support.object] for o in scene.objects]
    for i in _parents_first(carriers):
        depths[i] = depths[carriers[i]] + 1 if carriers[i] >= 0 else 0

    domains = []
    for (supporter_id, surface), members in sorted(groups.items(), key=lambda item: depths[item[1][0]]):
        checkpoint()
        supporter = index[supporter_id]
        region, z = _domain_region(scene.objects[supporter], surface)
        local = relative(home[members], home[supporter][None, :])
        local[:, 2] = 0.0
        for row, i in zip(local, members, strict=True):
            if not scene.objects[i].fixed:
                row[3] = into_domain(yaws_of(scene.objects[i]), row[3])
        ids = {scene.objects[i].id for i in members}
        relations = [
            (j, r) for j, r in enumerate(scene.relations) if r.subject in ids and _targets(r) and _targets(r) <= ids
        ]
        objects = [scene.objects[i] for i in members]
        problem = _compile(objects, local, region, relations, None)
        domains.append(Domain(SupportSurface(supporter, z, members), problem))
    room, plates = _compile_room(scene, home, terms)
    room.faulty, room.walker = faulty, walker(scene)
    room.surfaces = [d.surface for d in domains]
    return CompiledScene(scene, room, domains, plates)


def compile_room(scene: Scene) -> LayoutProblem:
    """The room's problem alone, without what is asked of surfaces and of those who walk there."""
    return _compile_room(scene, poses_of(scene)[0])[0]


def _compile_room(scene: Scene, home: np.ndarray, terms: bool = True) -> tuple[LayoutProblem, StandIns]:
    """The room's problem, and the stand-ins of its free areas; without ``terms`` as if the user had defined none."""
    plates = stand_ins(scene, home)
    objects, stated = [*scene.objects, *plates.objects], list(enumerate(scene.relations))
    home = np.concatenate([home, np.array(plates.home, dtype=np.float64).reshape(-1, 4)])
    return _compile(objects, home, room_region(scene.room), stated, scene.room, plates, terms), plates


def _targets(rel: Relation) -> set[str]:
    if rel.target is None:
        return set()
    return {rel.target} if isinstance(rel.target, str) else set(rel.target)
