"""Terms of design quality as data: what tells a good valid layout from a poor one.

A term asks one measure of some members (objects, doors, windows, walls) to lie in an interval, softly. The kinds are
few and general; which terms a room has is for the caller to say. `rate` measures many layouts at once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import warp as wp

from sceneweaver.geometry.shell import heights
from sceneweaver.kernels import quality as q
from sceneweaver.kernels import quality_floor as f
from sceneweaver.scene import InputError, Room, Scene

FAR = 1.0e6
"""Stands for no bound [m] and no limit of points."""


class Kind(NamedTuple):
    """A measure: its number in the kernels, how many members it has at least and at most, its numbers and defaults."""

    code: int
    least: int
    most: int | None
    params: Mapping[str, float] = {}


KINDS: Mapping[str, Kind] = {
    "lateral": Kind(q.LATERAL, 2, 2),
    "ahead": Kind(q.AHEAD, 2, 2),
    "gap": Kind(q.GAP, 2, 2),
    "nearest": Kind(q.NEAREST, 2, None),
    "bearing": Kind(q.BEARING, 2, None, {"front": 0.0}),
    "turned": Kind(q.TURNED, 2, 2, {"by": 0.0, "period": 2.0 * math.pi}),
    "mirrored": Kind(q.MIRRORED, 3, 3),
    "backing": Kind(q.BACKING, 2, 2),
    "clear": Kind(q.CLEAR, 1, None, {"width": 0.0, "low": 0.05, "high": 1.8, "side": 0.0}),
    "overlap": Kind(q.OVERLAP, 2, 2, {"depth": 1.0, "side": 0.0, "beside": 0.0}),
    "screened": Kind(q.SCREENED, 2, None, {"height": 1.1}),
    "bare": Kind(q.BARE, 1, None, {"depth": 0.35, "tall": 1.2, "run": 1.5}),
    "uneven": Kind(q.UNEVEN, 2, None, {"reach": 3.0, "seats": 0.0}),
    "way": Kind(f.WAY, 1, 1, {"reach": 0.1, "side": -1.0}),
    "empty": Kind(f.EMPTY, 0, 0),
    "remote": Kind(f.REMOTE, 1, None),
}
"""The measures by name; docs/engine.md has their formulas."""


@dataclass(frozen=True)
class QualityTerm:
    """A soft wish about a layout.

    It takes ``weight`` times clamp(miss / span, 0, 1) points off, where the miss is how far its measure lies outside of
    [low, high]. All terms of one ``rule`` take ``most`` of them off together, at most (the largest that one says).

    Attributes:
        kind: a name in `KINDS`.
        objects: ids of objects, doors and windows, or "wall:k", as many as the kind takes.
        low, high: bounds of the measure [m, rad, or a share].
        span: miss at which all points are gone, in the measure's unit.
        weight: points.
        params: numbers of the kind that differ from its defaults.
        rule: what the terms belong to that take a limited number of points off together; "": this term alone.

    Examples:
        >>> import sceneweaver as sw
        >>> near = sw.QualityTerm("gap", ("armchair", "floor-lamp"), high=0.3, weight=2.0)
        >>> solution = sw.refine(sw.Scene.example("bedroom"), candidates=8, quality=[near], device="cpu")
        >>> best = solution.order[0]
        >>> -2.0 <= solution.quality[best] <= 0.0
        np.True_
    """

    kind: str
    objects: tuple[str, ...] = ()
    low: float = -FAR
    high: float = FAR
    span: float = 0.5
    weight: float = 1.0
    params: Mapping[str, float] | None = None
    rule: str = ""
    most: float = FAR

    def __post_init__(self) -> None:
        """Raise InputError on what is out of range."""
        name = f"quality: {self.kind} of {', '.join(self.objects) or 'nothing'}"
        kind = KINDS.get(self.kind)
        if kind is None:
            raise InputError(f'quality: "{self.kind}" is not one of {", ".join(KINDS)}')
        count = len(self.objects)
        if count < kind.least or (kind.most is not None and count > kind.most):
            known = f"{kind.least}" if kind.most == kind.least else f"at least {kind.least}"
            raise InputError(f"{name}: takes {known} members, not {count}")
        numbers = (self.low, self.high, self.span, self.weight, self.most, *(self.params or {}).values())
        if not all(math.isfinite(n) for n in numbers) or self.span <= 0 or self.weight < 0 or self.most < 0:
            raise InputError(f"{name}: numbers are finite, span is positive, weight and most are not negative")
        if self.low > self.high:
            raise InputError(f"{name}: low {self.low:g} is above high {self.high:g}")
        unknown = sorted(set(self.params or {}) - set(kind.params))
        if unknown:
            raise InputError(
                f"{name}: has no parameter {', '.join(unknown)}; it has {', '.join(kind.params) or 'none'}"
            )

    @property
    def on_floor(self) -> bool:
        """Whether it needs the free floor as a grid, which is measured for the best candidates only."""
        return KINDS[self.kind].code >= q.ON_FLOOR


def _places(room: Room) -> dict[str, tuple[float, ...]]:
    """Doors, windows and walls by name: middle x, y, cos and sin of the way inside, half depth and width, heights."""
    walls = room.walls
    found = {}
    for opening in room.openings:
        wall = walls[opening.wall]
        middle = wall.point(opening.offset + opening.width / 2)
        found[opening.id] = (*middle, *wall.inward, 0.0, opening.width / 2, *heights(opening))
    for k, wall in enumerate(walls):
        found[f"wall:{k}"] = (*wall.point(wall.length / 2), *wall.inward, 0.0, wall.length / 2, 0.0, room.height)
    return found


def check_terms(scene: Scene, terms: Sequence[QualityTerm]) -> None:
    """Raise InputError when a term names what the scene does not have."""
    known = {*scene.ids, *_places(scene.room)} if terms else ()
    for term in terms:
        for name in term.objects:
            if name not in known:
                raise InputError(f'quality: {term.kind}: "{name}" is no object, door, window or wall of the scene')


def by_rule(terms: Sequence[QualityTerm]) -> list[list[QualityTerm]]:
    """The terms of each rule, in the order in which rules are met first."""
    found: dict[Any, list[QualityTerm]] = {}
    for k, term in enumerate(terms):
        found.setdefault(term.rule or k, []).append(term)
    return list(found.values())


def pack_terms(scene: Scene, terms: Sequence[QualityTerm], device: str) -> tuple[Any, list[QualityTerm]]:
    """Checked terms as tables on a device, and the terms in the order of their rows."""
    places = _places(scene.room)
    number = {name: k for k, name in enumerate(places)}
    index = {name: k for k, name in enumerate(scene.ids)}
    groups = by_rule(terms)
    rows = [term for group in groups for term in group]
    member, start = [], [0]
    for term in rows:
        member += [index[name] if name in index else -1 - number[name] for name in term.objects]
        start.append(len(member))
    params = [[{**KINDS[t.kind].params, **(t.params or {})}[p] for p in KINDS[t.kind].params] for t in rows]
    stood = np.array(list(places.values()), dtype=np.float32).reshape(-1, 8)
    columns = {
        "kind": [KINDS[t.kind].code for t in rows],
        "member_start": start,
        "member": member,
        "interval": [(t.low, t.high, t.span, t.weight) for t in rows],
        "params": [(*p, 0.0, 0.0, 0.0, 0.0)[:4] for p in params],
        "rule_start": np.cumsum([0, *map(len, groups)]),
        "rule_most": [max(t.most for t in group) for group in groups],
        "place": stood[:, :4],
        "place_half": stood[:, 4:6],
        "place_z": stood[:, 6:],
    }
    packed = q.Terms()
    for table in q.TERMS:
        scalar, width = getattr(table.dtype, "_wp_scalar_type_", table.dtype), getattr(table.dtype, "_length_", 1)
        values = np.asarray(columns[table.name], dtype=wp.dtype_to_numpy(scalar))
        values = values.reshape(-1, width) if width > 1 else values.reshape(-1)
        setattr(packed, table.name, wp.array(values, dtype=table.dtype, device=device))
    packed.first = 0
    return packed, rows
