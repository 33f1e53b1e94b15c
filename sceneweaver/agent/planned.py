"""A scene before its poses are known, as rows of the design rules ask for it: what is near is what a relation ties."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.critic.design.query import Case, kind_set
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.shell import heights
from sceneweaver.geometry.walls import Wall
from sceneweaver.knowledge.small_things import left_about, sparse_walls
from sceneweaver.layout.quality import KINDS
from sceneweaver.rules.design import room_groups
from sceneweaver.rules.expression import CALLED
from sceneweaver.rules.faults import number
from sceneweaver.scene import CATALOGUE, Scene, SceneObject
from sceneweaver.verify.walkable import ARM, RADIUS

FLAT = number("underfoot")
"""Height [m] up to which things are walked on."""

QUARTER = math.pi / 2


class Measured(NamedTuple):
    """A measure of the engine and the ids of what it is about."""

    kind: str
    objects: tuple[str, ...]


class Use(NamedTuple):
    """The side at which a piece is used (0 to 3 from the front to the left; -1: any), and the depth [m] there."""

    side: float
    depth: float


class Planned:
    """A scene whose poses are not known, as queries of rows ask for it: what is near is what a relation ties."""

    def __init__(self, scene: Scene, room: str) -> None:
        self.scene, self.room = scene, room
        objects = scene.objects
        standing = [o for o in objects if o.mount == "floor" and o.size[2] > FLAT]
        self.standing = sorted(standing, key=lambda o: -round(o.size[0] * o.size[1], 6))
        self._members: dict[str, list[SceneObject]] = {"": list(objects), "standing": self.standing}
        self._index = {o.id: o for o in objects}
        ties: dict[str, list[str]] = defaultdict(list)
        for relation in scene.relations:
            for target in relation.targets:
                if target in self._index:
                    ties[relation.subject].append(target)
                    ties[target].append(relation.subject)
        self.ties = {name: list(dict.fromkeys(others)) for name, others in ties.items()}
        self.movable = tuple(o for o in objects if self.is_light(o) or (o.mount == "floor" and o.size[2] <= FLAT))
        measures = {kind: partial(_measured, kind) for kind in KINDS}
        self.functions: Mapping[str, Callable[..., Any]] = {
            name + CALLED: function for name, function in {**self._functions(), **measures}.items()
        }

    def members(self, mount: str) -> Iterable[SceneObject]:
        """The objects of a mount; "standing": on the floor and no rug, the largest first; "": all."""
        if mount not in self._members:
            self._members[mount] = [o for o in self.scene.objects if o.mount == mount]
        return self._members[mount]

    def near(self, o: SceneObject, distance: float = 0.0) -> list[SceneObject]:
        """What a relation names with an object, either way."""
        return [self._index[name] for name in self.ties.get(o.id, ())]

    def tied(self, o: SceneObject, kinds: str) -> list[SceneObject]:
        """What a relation names with an object, of a set of categories."""
        return [other for other in self.near(o) if other.category in kind_set(kinds)]

    def category(self, o: SceneObject) -> str:
        """The category of an object."""
        return o.category

    def of_kind(self, kinds: str) -> list[SceneObject]:
        """The objects of a set of categories, in the scene's order."""
        return [o for o in self.scene.objects if o.category in kind_set(kinds)]

    def is_light(self, o: SceneObject) -> bool:
        """Whether it is a seat that is moved aside with one hand."""
        return o.category in kind_set("light_seat upright_seat")

    def named(self, selector: str) -> Iterator[Case]:
        """The cases of a named selector, by relations."""
        room = self.scene.room
        if selector == "wall":
            for k, wall in enumerate(room.walls):
                yield {"wall": wall, "openings": tuple(o.id for o in room.openings_of(k))}
        elif selector in ("door", "window"):
            for opening in room.doors if selector == "door" else room.windows:
                yield {selector: opening}
        elif selector.startswith("sofa_"):
            yield from self._sofas(selector.removeprefix("sofa_"))
        elif selector == "flanking_pair":
            yield from self._pairs()
        else:
            yield from self._beds(selector)

    def _sofas(self, what: str) -> Iterator[Case]:
        """Sofas with their tables, rugs, or what they look at."""
        for sofa in self.of_kind("sofa"):
            tables = self.tied(sofa, "coffee_table")
            if not tables and len(self.of_kind("sofa")) == 1:
                tables = self.of_kind("coffee_table")
            rugs = [r for r in self.of_kind("rug") if any(r in self.tied(o, "rug") for o in (sofa, *tables))]
            found = {"table": tables, "rug": rugs, "focus": self.of_kind("focus")[:1]}[what]
            yield from ({"sofa": sofa, what: other, "alone": False} for other in found)

    def _beds(self, selector: str) -> Iterator[Case]:
        """Beds with the rugs and lamps tied to them; beds and sofas with what hangs over them."""
        if selector == "hung_over":
            for base in [*self.of_kind("sofa -=sectional_sofa"), *self.of_kind("bed")]:
                yield from ({"base": base, "over": over} for over in self.tied(base, "hung_over"))
            return
        name = {"bed_rug": "rug", "bed_lamp": "lamp"}[selector]
        kinds = {"rug": "rug", "lamp": "=pendant =chandelier =ceiling_light"}[name]
        for bed in self.of_kind("bed"):
            yield from ({"bed": bed, name: other} for other in self.tied(bed, kinds))

    def _pairs(self) -> Iterator[Case]:
        """Two of a kind beside a bed or a sofa."""
        for base in self.of_kind("bed sofa"):
            pairs: dict[str, list[SceneObject]] = defaultdict(list)
            for o in self.tied(base, "flanking"):
                pairs[o.category].append(o)
            yield from ({"one": p[0], "other": p[1], "base": base} for p in pairs.values() if len(p) == 2)

    def table_at(self, seat: SceneObject) -> SceneObject | None:
        """The table or desk that a seat is tied to."""
        return next(iter(self.tied(seat, "seated_at")), None)

    def sets_of_equals(self) -> list[tuple[SceneObject, ...]]:
        """What stands, by category, and seats by their table; no plants, and no seats without a table."""
        sets: dict[tuple[str, str | None], list[SceneObject]] = defaultdict(list)
        for o in self.standing:
            seat = o.category in kind_set("upright_seat")
            table = self.table_at(o) if seat else None
            if o.category not in kind_set("tall_plant") and not (seat and table is None):
                sets[o.category, table.id if table else None].append(o)
        return [tuple(objects) for objects in sets.values()]

    def axis_period(self, base: SceneObject | str) -> float:
        """The turn [rad] after which the axes of a table, or else of the walls, are the same.

        0 in a room whose walls do not meet in quarter or eighth turns.
        """
        walls = self.scene.room.walls
        turns = (wrap_angle(w.yaw - walls[0].yaw, QUARTER) for w in walls if w.length >= number("short_wall"))
        axes = {round(math.degrees(turn)) % 90 for turn in turns}
        if axes not in ({0}, {0, 45}):
            return 0.0
        return QUARTER if axes == {0} or not isinstance(base, str) else QUARTER / 2

    def side_of_use(self, o: SceneObject) -> Use:
        """The side at which a piece is used, and how far its zone reaches out there; of what has seats any."""
        ties = CATALOGUE.with_role("seat")
        tucked = any(r.type in ties and o.id in (r.subject, *r.targets) for r in self.scene.relations)
        depths = {} if tucked else {0.0: 0.0}
        for zone in o.zones:
            if zone.hard:
                xs, ys = [p[0] for p in zone.polygon], [p[1] for p in zone.polygon]
                out = {0.0: max(xs) - o.size[0] / 2, 1.0: max(ys) - o.size[1] / 2}
                out |= {2.0: -min(xs) - o.size[0] / 2, 3.0: -min(ys) - o.size[1] / 2}
                side = max(out, key=lambda name: out[name])
                depths[side] = max(depths.get(side, 0.0), out[side])
        return Use(*next(iter(depths.items()))) if len(depths) == 1 else Use(-1.0, 0.0)

    def _functions(self) -> dict[str, Callable[..., Any]]:
        """What conditions and numbers of rows may call, beside the measures."""
        walls = tuple(f"wall:{k}" for k in range(len(self.scene.room.outline)))
        return {
            "after": lambda row, o: row[row.index(o) + 1 :],
            "arm": lambda: ARM,
            "axis_period": self.axis_period,
            "category": lambda o: o.category,
            "deg": math.degrees,
            "depth": lambda o: o.size[0],
            "has_doors": lambda: bool(self.scene.room.doors),
            "in_rooms": lambda group: self.room in room_groups().get(group, (group,)),
            "kind": lambda o, kinds: o.category in kind_set(kinds),
            "lean": lambda: False,
            "left_about": lambda o: left_about(o.category, self.room),
            "light": lambda: self.movable,
            "mount": lambda o: o.mount,
            "priority": lambda o: o.intent.priority,
            "robot": lambda: RADIUS,
            "same_kind": lambda a, b: a.category == b.category,
            "sets_of_equals": self.sets_of_equals,
            "side_of_use": self.side_of_use,
            "sides_used": _sides_used,
            "sill": lambda window: heights(window)[0],
            "sparse_walls": lambda: sparse_walls(self.room),
            "table_at": self.table_at,
            "tall": lambda o: o.size[2],
            "tied": lambda a, b: b in self.near(a),
            "walls": lambda: walls,
            "width": lambda o: o.size[1],
            "windows": lambda: tuple(self.scene.room.windows),
        }


def _sides_used(o: SceneObject) -> tuple[str, ...]:
    row = categories().get(o.category)
    return tuple(row.sides) if row is not None else ()


def _measured(kind: str, *things: Any) -> Measured:
    """A measure of the engine over objects, openings, walls and lists of them."""
    found: list[str] = []
    for thing in things:
        for one in thing if isinstance(thing, (tuple, list)) else (thing,):
            found.append(one if isinstance(one, str) else f"wall:{one.index}" if isinstance(one, Wall) else one.id)
    return Measured(kind, tuple(found))
