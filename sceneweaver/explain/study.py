"""A scene that has no valid candidate, taken apart: its parts, and what its candidates show about them."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np
import shapely

from sceneweaver.geometry.polygons import union
from sceneweaver.layout import Solution
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.devices import pick_devices
from sceneweaver.scene import CATALOGUE, Relation, Room, Scene, SceneObject, Surface
from sceneweaver.verify import Violation, check

from .space import Walls, moved
from .words import listed, relation_words

LOOK = 64  # candidates of the solution that are judged again,
MOST = 2_000  # as long as they hold no more objects than this,
BEST = 16  # and so many at least


class OutOfTime(Exception):
    """The clock cut the search off; ``lines`` say what it had found by then."""

    def __init__(self, lines: Sequence[str] = ()) -> None:
        super().__init__()
        self.lines = lines


class Study:
    """One scene that has no valid candidate, taken apart.

    A part of the scene is a set of elements: the number of a unit (a hard relation, or all ``around`` of one target,
    which mean nothing one by one), or the number of units plus the index of an object. Fixed objects and the room
    belong to every part.
    """

    def __init__(self, scene: Scene, solution: Solution, device: str, until: float) -> None:
        self.scene, self.solution, self.until = scene, solution, until
        self.device = pick_devices(device)[0]
        self.compiled = compile_scene(scene)
        self.problem = self.compiled.room
        self.index = {o.id: i for i, o in enumerate(scene.objects)}
        self.free = [i for i, o in enumerate(scene.objects) if not o.fixed]
        self.units = self._make_units()
        self.named = [self._named(unit) for unit in self.units]
        self._findings: dict[int, tuple[Violation, ...] | None] = {}
        order = np.lexsort((solution.energy, solution.status == 3))
        self.top = order[: max(BEST, min(LOOK, MOST // max(1, len(scene.objects))))]

    @cached_property
    def walls(self) -> Walls:
        """The walls with the fixed objects."""
        still = [i for i, o in enumerate(self.scene.objects) if o.fixed]
        fixed = [p for i in still for p in moved(self.problem.solids[i], self.problem.home[i])]
        return Walls(self.scene.room, self.problem.region, fixed)

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
        return self.carriers({self.index[n] for n in names if n in self.index})

    def carriers(self, objects: Iterable[int]) -> frozenset[int]:
        """Objects with all that carries them."""
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
        return frozenset(i for i in self.carriers(out) if not self.scene.objects[i].fixed)

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
        keep = set(self.carriers(self.objects_of(part)))
        named = {i for e in part if e < len(self.units) for i in self.named[e]}
        keep |= self.carriers(i for i, o in enumerate(self.scene.objects) if o.fixed and (fixed or i in named))
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

    # what the units and objects are

    def relations(self, u: int) -> list[Relation]:
        """The relations of a unit."""
        return [self.scene.relations[j] for j in self.units[u]]

    def unit_words(self, u: int) -> str:
        """A unit in words."""
        relations = self.relations(u)
        if relations[0].type != "around":
            return relation_words(relations[0])
        return f"{listed([r.subject for r in relations], 6)} around {relations[0].target}"

    def keys(self, u: int) -> set:
        """What a unit is about: movable objects, and parts of the room that it wants."""
        keys: set = {i for i in self.named[u] if not self.scene.objects[i].fixed}
        for j in self.units[u]:
            rel = self.scene.relations[j]
            kind = CATALOGUE[rel.type].target_kind
            if kind not in ("object", "objects"):
                keys |= {t for t in rel.targets} or {rel.type}
        return keys

    def surface(self, obj: SceneObject) -> Surface:
        """The surface that an object stands on."""
        assert obj.support is not None
        surfaces = self.scene.object(obj.support.object).surfaces
        return next(s for s in surfaces if s.name == obj.support.surface)

    def area(self, i: int) -> float:
        """Footprint of an object [m2]."""
        return float(union(shapely.Polygon(p.polygon) for p in self.problem.solids[i]).area)

    # what the solution's own candidates show

    def findings(self, candidate: int) -> tuple[Violation, ...] | None:
        """What the judge finds wrong in a candidate, kept for the next time; None where poses are no numbers."""
        if candidate not in self._findings:
            finite = bool(np.isfinite(self.solution.poses[candidate]).all())
            report = check(self.solution.scene(candidate), walkable=False) if finite else None
            self._findings[candidate] = report.violations if report else None
        return self._findings[candidate]

    @cached_property
    def fault(self) -> np.ndarray:
        """Which objects collide, lie outside or off their surface ..., [top candidate, object]."""
        fault = np.zeros((len(self.top), len(self.scene.objects)), dtype=bool)
        for row, candidate in zip(fault, self.top, strict=True):
            if time.monotonic() > self.until:
                raise OutOfTime
            violations = self.findings(int(candidate))
            if violations is None:
                row[:] = True
                continue
            for violation in violations:
                names = violation.objects[:1] if violation.kind == "unsupported" else violation.objects
                if violation.relation is None:
                    row[[self.index[name] for name in names if name in self.index]] = True
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

    def suspicion(self, u: int) -> tuple[float, float, int]:
        """Sorts units: the most often unmet first, then those whose objects are at fault."""
        return (-float(self.unmet[:, u].mean()), -float(self.fault[:, sorted(self.named[u])].mean()), u)
