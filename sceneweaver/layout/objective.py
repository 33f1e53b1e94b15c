"""Objectives as data: what is minimised over valid layouts.

An objective is a weighted sum of terms. `sceneweaver.refine` minimises it subject to all that is hard: bodies, room,
zones and hard relations. `objective_values` has the meaning of each kind in float64.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from sceneweaver.kernels import user
from sceneweaver.scene import InputError, Scene

MANHATTAN, EUCLIDEAN = "manhattan", "euclidean"
METRICS = (EUCLIDEAN, MANHATTAN)
MOST_TERMS = 10_000


class Kind(NamedTuple):
    """What a term takes: least and greatest number of members, and its parameters with their defaults (None: none)."""

    least: int
    most: int | None
    params: Mapping[str, Any]
    places: bool = True  # doors and windows may be members
    walls: bool = False  # "wall:k" may be


KINDS: Mapping[str, Kind] = {
    "wire_length": Kind(2, None, {"pins": None}),
    "flow": Kind(2, 2, {"metric": EUCLIDEAN}),
    "walking": Kind(2, 2, {"sides": None}),
    "cost": Kind(1, 1, {"point": None, "direction": None, "metric": EUCLIDEAN}, places=False),
    "exposed_wall": Kind(0, None, {"depth": 0.35}, places=False, walls=True),
    "light": Kind(2, None, {"target": 300.0, "flux": None, "height": None}),
    "user": Kind(1, 2, {"name": None, "values": ()}, places=False),
}
"""The kinds of terms by name; docs/objectives.md has their formulas."""


@dataclass(frozen=True)
class ObjectiveTerm:
    """A term of an objective: ``weight`` times the value of its kind, to be minimised.

    Attributes:
        kind: a name in `KINDS`: "wire_length" [m], "flow" [m], "walking" [m], "cost" [m], "exposed_wall" [m], "light"
            (a share) or "user".
        objects: ids of objects, doors and windows, as many as the kind takes; of "exposed_wall" names of walls
            ("wall:0"), none for all walls.
        weight: cost of a unit of the value, not negative but for "cost", "flow" and "user".
        params: what the kind takes besides.

    Raises:
        InputError: a kind that there is not, a wrong number of members, a parameter out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> net = sw.ObjectiveTerm("wire_length", ("bed", "wardrobe", "door"), weight=2.0)
        >>> solution = sw.refine(sw.Scene.example("bedroom"), candidates=4, objective=[net], device="cpu")
        >>> bool(solution.objective[solution.order[0]] > 0.0)
        True
    """

    kind: str
    objects: tuple[str, ...] = ()
    weight: float = 1.0
    params: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        """Raise InputError on what is out of range."""
        kind = KINDS.get(self.kind) if isinstance(self.kind, str) else None
        if kind is None:
            raise InputError(f'objective: "{self.kind}" is not one of {", ".join(KINDS)}')
        if isinstance(self.objects, str) or not all(isinstance(name, str) for name in self.objects):
            raise InputError(f"objective: {self.kind}: objects are a sequence of ids, not {self.objects!r}")
        object.__setattr__(self, "objects", tuple(self.objects))
        name = f"objective: {self.kind} of {', '.join(self.objects) or 'all'}"
        count = len(self.objects)
        if count < kind.least or (kind.most is not None and count > kind.most):
            known = f"{kind.least}" if kind.most == kind.least else f"at least {kind.least}"
            raise InputError(f"{name}: takes {known} members, not {count}")
        if not _is_number(self.weight):
            raise InputError(f"{name}: weight {self.weight!r} is not a finite number")
        if self.weight < 0 and self.kind not in ("cost", "flow", "user"):
            raise InputError(f"{name}: weight {self.weight:g} is negative")
        if self.params is not None and not isinstance(self.params, Mapping):
            raise InputError(f"{name}: params are a mapping, not {self.params!r}")
        unknown = sorted(set(self.params or {}) - set(kind.params))
        if unknown:
            known = ", ".join(kind.params) or "none"
            raise InputError(f"{name}: has no parameter {', '.join(unknown)}; it has {known}")
        _CHECKS[self.kind](name, self)

    def value(self, param: str) -> Any:
        """A parameter, or its default."""
        return (self.params or {}).get(param, KINDS[self.kind].params[param])

    @property
    def pins(self) -> tuple[tuple[float, float], ...]:
        """Pins [x, y] of a net's members in their own frames [m]."""
        return tuple((float(x), float(y)) for x, y in self.value("pins") or [(0.0, 0.0)] * len(self.objects))

    def to_dict(self) -> dict[str, Any]:
        """The term as JSON has it."""
        found: dict[str, Any] = {"kind": self.kind, "objects": list(self.objects), "weight": self.weight}
        return found | ({"params": dict(self.params)} if self.params else {})

    @classmethod
    def from_dict(cls, data: Any) -> ObjectiveTerm:
        """A term from JSON: {"kind": "wire_length", "objects": ["a", "b"], "weight": 1.0, "params": {...}}.

        Raises:
            InputError: not such a mapping.
        """
        if not isinstance(data, Mapping) or "kind" not in data:
            raise InputError(f'objective: a term is a mapping with "kind" and "objects", not {data!r}')
        unknown = sorted(set(data) - {"kind", "objects", "weight", "params"})
        if unknown:
            raise InputError(f"objective: a term has no {', '.join(unknown)}; it has kind, objects, weight, params")
        objects = data.get("objects", ())
        if not isinstance(objects, list | tuple):
            raise InputError(f"objective: {data['kind']}: objects are a list of ids, not {objects!r}")
        return cls(data["kind"], tuple(objects), data.get("weight", 1.0), data.get("params"))


def terms_from(data: Any) -> list[ObjectiveTerm]:
    """The terms of an objective from JSON: a list of them.

    Raises:
        InputError: not a list of terms, or too many.
    """
    if not isinstance(data, list):
        raise InputError(f"objective: a list of terms is needed, not {type(data).__name__}")
    return [ObjectiveTerm.from_dict(term) for term in data]


def check_objective(scene: Scene, terms: Sequence[ObjectiveTerm]) -> None:
    """Raise InputError when a term names what the scene does not have."""
    if not terms:
        return
    if len(terms) > MOST_TERMS:
        raise InputError(f"objective: {len(terms)} terms are more than {MOST_TERMS}")
    openings = {opening.id for opening in scene.room.openings}
    walls = {f"wall:{k}" for k in range(len(scene.room.walls))}
    objects = set(scene.ids)
    for term in terms:
        if not isinstance(term, ObjectiveTerm):
            raise InputError(f"objective: {term!r} is not an ObjectiveTerm")
        kind = KINDS[term.kind]
        known = walls if kind.walls else objects | openings if kind.places else objects
        what = "wall" if kind.walls else "object, door or window" if kind.places else "object"
        for name in term.objects:
            if name not in known:
                raise InputError(f'objective: {term.kind}: "{name}" is no {what} of the scene')
        if term.kind == "user":
            feature_of(term)


def feature_of(term: ObjectiveTerm) -> str:
    """The name under which the kernels know the residual of a user's term.

    Raises:
        InputError: nothing of that name is defined.
    """
    name = term.value("name")
    for known in (f"term {name}", name):
        if known in user.residuals():
            return known
    raise InputError(f'objective: user: "{name}" is not defined; use sw.define_term or sw.define_relation first')


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _is_point(value: Any) -> bool:
    return isinstance(value, list | tuple) and len(value) == 2 and all(map(_is_number, value))


def _check_metric(name: str, term: ObjectiveTerm) -> None:
    if term.value("metric") not in METRICS:
        raise InputError(f"{name}: metric {term.value('metric')!r} is not one of {', '.join(METRICS)}")


def _check_net(name: str, term: ObjectiveTerm) -> None:
    pins = term.value("pins")
    if pins is None:
        return
    if not isinstance(pins, list | tuple) or len(pins) != len(term.objects) or not all(map(_is_point, pins)):
        raise InputError(f"{name}: pins are a point [x, y] in metres for each of its {len(term.objects)} members")


def _check_walking(name: str, term: ObjectiveTerm) -> None:
    sides = term.value("sides")
    good = sides is None or (
        isinstance(sides, list | tuple) and len(sides) == 2 and all(side in (0, 1, 2, 3) for side in sides)
    )
    if not good:
        raise InputError(f"{name}: sides are two numbers from 0 (front) over 1 (left) and 2 (back) to 3, not {sides!r}")


def _check_cost(name: str, term: ObjectiveTerm) -> None:
    given = [param for param in ("point", "direction") if term.value(param) is not None]
    if len(given) != 1 or not _is_point(term.value(given[0])):
        raise InputError(f"{name}: takes one of point and direction, as [x, y]")
    _check_metric(name, term)


def _check_wall(name: str, term: ObjectiveTerm) -> None:
    if not _is_number(term.value("depth")) or term.value("depth") <= 0:
        raise InputError(f"{name}: depth {term.value('depth')!r} is not a positive number of metres")


def _check_light(name: str, term: ObjectiveTerm) -> None:
    target, flux, height = (term.value(param) for param in ("target", "flux", "height"))
    if not _is_number(target) or target <= 0:
        raise InputError(f"{name}: target {target!r} is not a positive number of lux")
    if height is not None and not (_is_number(height) and height >= 0):
        raise InputError(f"{name}: height {height!r} is not a number of metres")
    sources = len(term.objects) - 1
    if flux is None or (_is_number(flux) and flux >= 0):
        return
    if not isinstance(flux, list | tuple) or len(flux) != sources or not all(_is_number(f) and f >= 0 for f in flux):
        raise InputError(f"{name}: flux is a number of lumens, or one for each of its {sources} sources")


def _check_user(name: str, term: ObjectiveTerm) -> None:
    if not isinstance(term.value("name"), str):
        raise InputError(f'{name}: params need the "name" of a term or relation of your own')
    values = term.value("values")
    if not isinstance(values, list | tuple) or len(values) > 4 or not all(map(_is_number, values)):
        raise InputError(f"{name}: values are up to four numbers, not {values!r}")


_CHECKS = {
    "wire_length": _check_net,
    "flow": _check_metric,
    "walking": _check_walking,
    "cost": _check_cost,
    "exposed_wall": _check_wall,
    "light": _check_light,
    "user": _check_user,
}
