"""The relation catalogue: what each relation type means, as data (``rules/relations.yaml``) that engine and judge read.

Lengths are metres, angles degrees, overlaps shares of the narrower face. Faces are named in an object's own frame:
front is +x, back -x, left +y, right -y.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal, Protocol

from sceneweaver.io import InputError
from sceneweaver.io.messages import clean, show, suggest
from sceneweaver.rules.relation import Way, load, own_side, ways_of

from .fields import LARGEST
from .messages import FieldError

SIDES = ("front", "back", "left", "right")
TARGETS = ("none", "wall", "wall?", "object", "objects", "window", "window?", "door", "door?")
TUCKED = "tucked"
"""A gap of [-0.8 * the subject's depth, 0.05]: the subject may reach under the target where their parts allow it."""
TUCKED_SHARE = 0.8
TUCKED_MOST = 0.05

ROLES: Mapping[str, str] = MappingProxyType(
    {
        "placing": "says where the subject stands by its target, so that it goes along with it",
        "seat": "pulls a seat up to a table",
        "wall": "puts a face to a wall",
        "edge": "keeps the subject at the edge of the room",
        "symmetric": "says the same of its target",
        "turning": "says how the subject is turned",
        "tying": "makes the subject belong to its target, so that it is placed anew with it",
        "formation": "sets out many things regularly",
    }
)
"""What relation types are for, by name."""

Side = Literal["front", "back", "left", "right"]
Gap = tuple[float, float]


def sides_named(word: str, size: Sequence[float], frame: str = "own") -> tuple[str, ...]:
    """The sides of a box of some size (depth, width, ...), in its own frame, that a word names in a frame.

    Args:
        word: a side, ``ends`` for the two short ones, ``any``.
        size: of the box [m].
        frame: ``own``, or ``viewer`` where left and right are those of who looks at its front.
    """
    if word == "ends":
        return ("left", "right") if size[1] >= size[0] else ("front", "back")
    return SIDES if word == "any" else (own_side(word, frame),)


class HasParams(Protocol):
    """A relation, as far as the catalogue needs to know it."""

    @property
    def params(self) -> Mapping[str, Any]:
        """What the relation sets for itself."""
        ...


@dataclass(frozen=True, slots=True)
class ParamSpec:
    """A parameter of a relation type.

    Attributes:
        type: ``number``, ``integer``, ``range`` (two numbers in order) or ``choice`` (a word of ``choices``).
        default: its value when a relation does not give it; None when it must be given or is worked out.
        unit: ``m``, ``deg`` or empty for a plain ratio or count.
        minimum, maximum: bounds, included; ``exclusive_minimum``: lower bound, left out.
        required: whether every relation of the type must give it.
    """

    name: str
    type: Literal["number", "integer", "range", "choice"]
    default: float | int | Gap | str | None
    unit: str
    description: str
    minimum: float | None = None
    maximum: float | None = None
    exclusive_minimum: float | None = None
    required: bool = False
    choices: tuple[str, ...] = ()

    def check(self, value: Any) -> float | int | Gap | str:
        """The value as float, int, a pair of floats or a word; FieldError for another type or a bad number."""
        if self.type == "choice":
            if not isinstance(value, str) or value not in self.choices:
                raise FieldError((), f"is {show(value)}; give one of {', '.join(self.choices)}")
            return value
        if self.type == "range":
            if value == TUCKED and self.default == TUCKED:
                return TUCKED
            if not isinstance(value, list | tuple) or len(value) != 2:
                raise FieldError((), f"is {show(value)}; give a range [least, most]")
            low, high = self._number(value[0], (0,)), self._number(value[1], (1,))
            if low > high:
                raise FieldError((), f"is [{low:g}, {high:g}]; the first must not be more than the second")
            return (low, high)
        number = self._number(value, ())
        if self.type == "integer":
            if number != int(number):
                raise FieldError((), f"is {show(value)}; give a whole number")
            return int(number)
        return number

    def _number(self, value: Any, loc: tuple[int, ...]) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise FieldError(loc, f"is {show(value)}; give a number")
        if not math.isfinite(value):
            raise FieldError(loc, f"is {show(value)}; numbers must be finite")
        if abs(value) > LARGEST:
            raise FieldError(loc, f"is {show(value)}; numbers are at most {LARGEST:g}")
        low, more, high = self.minimum, self.exclusive_minimum, self.maximum
        if (low is not None and value < low) or (more is not None and value <= more):
            bound = f"at least {low:g}" if low is not None else f"more than {more:g}"
            raise FieldError(loc, f"is {show(value)}; it must be {bound}")
        if high is not None and value > high:
            raise FieldError(loc, f"is {show(value)}; it must be at most {high:g}")
        return float(value)


@dataclass(frozen=True, slots=True)
class Exact:
    """The value of a quantity of a relation when it is not merely fulfilled but exact.

    Attributes:
        value: the exact value, in m or deg; ``middle``: that of the interval that the relation allows.
        within: between which values the quantity is brought to it; beyond them it is taken to be meant otherwise.
        alike: where it is given, all subjects with one target take the same value, from this to the exact one, which
            is then as far as one would go, such as chairs that are pushed under a table.
    """

    value: float | Literal["middle"]
    within: tuple[float, float]
    alike: float | None = None


@dataclass(frozen=True, slots=True)
class RelationSpec:
    """A relation type.

    Attributes:
        target: what ``relation.target`` is: ``none``, ``object`` (an id), ``objects`` (two ids), ``wall`` ("wall:k"),
            ``window`` or ``door`` (an id); with a question mark it may be left out, and any (or every) one is meant.
        subject_sides, target_sides: the faces that may take part.
        degrees: most angle [deg], gap: [least, most] distance [m] or ``tucked``, overlap: least share; None: no say.
        params: what a relation may set for itself; a parameter named like a field above overrides that field.
        constants: numbers of the type's definition that nothing overrides.
        ties_zones: subject and target are exempt from each other's hard zones.
        roles: what relations of the type are for, see `ROLES`.
        ways: the rows that make it hold; none of a registered type, which brings functions of its own.
        rounded: whether the judge forgives what float64 loses, see `sceneweaver.verify.measure.ROUNDING`.
        frame: whose sides are meant: ``own``, or ``frame`` where the param of that name says it; None: no side matters.
        snap: the exact values of quantities: ``degrees`` off, ``gap``, ``lateral`` (the two middles, along the
            target's face), ``backs`` (the two back faces, along the front).
    """

    type: str
    description: str
    target: str = "object"
    subject_sides: tuple[Side, ...] = ()
    target_sides: tuple[Side, ...] = ()
    degrees: float | None = None
    gap: Gap | Literal["tucked"] | None = None
    overlap: float | None = None
    params: Mapping[str, ParamSpec] = field(default_factory=lambda: MappingProxyType({}))
    constants: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    ties_zones: bool = False
    roles: frozenset[str] = frozenset(("placing",))
    snap: Mapping[str, Exact] = field(default_factory=lambda: MappingProxyType({}))
    ways: tuple[Way, ...] = ()
    rounded: bool = False
    frame: str | None = None

    @property
    def target_kind(self) -> str:
        """``target`` without its question mark."""
        return self.target.removesuffix("?")

    @property
    def target_optional(self) -> bool:
        """Whether a relation may go without a target."""
        return self.target == "none" or self.target.endswith("?")

    def value(self, relation: HasParams | Mapping[str, Any] | None, name: str) -> Any:
        """The number called ``name`` for this relation: what its params say, else the default of the type.

        Args:
            relation: a relation, its params, or None for the default.
            name: a parameter, a constant, or ``degrees``, ``gap`` or ``overlap``.

        Returns:
            A float, an int, a (low, high) pair, "tucked", or None when the type leaves it open.

        Raises:
            InputError: when the relation type has no such number.
        """
        params = {} if relation is None else relation if isinstance(relation, Mapping) else relation.params
        if name in params:
            return params[name]
        if name in self.params:
            return self.params[name].default
        if name in self.constants:
            return self.constants[name]
        if name in ("degrees", "gap", "overlap"):
            return getattr(self, name)
        raise InputError(f'{self.type}: no number "{clean(name)}"{suggest(name, [*self.params, *self.constants])}')

    def scope(self, relation: HasParams, depth: float) -> dict[str, Any]:
        """The names of its rows' expressions that a relation fixes: params, constants and numbers of the type.

        Args:
            relation: a relation of the type.
            depth: the subject's depth [m], which a "tucked" gap refers to.
        """
        found: dict[str, Any] = {"degrees": self.degrees, "overlap": self.overlap, **self.constants}
        found.update({name: param.default for name, param in self.params.items()})
        found.update(relation.params)
        if self.gap is not None:
            found["gap"] = self.gap_range(relation, depth)
        return {"frame": self.frame, **found}

    def gap_range(self, relation: HasParams | Mapping[str, Any] | None, depth: float) -> Gap:
        """The gap [m] as numbers; ``depth`` is the subject's depth (``size[0]``), which "tucked" refers to.

        Raises:
            InputError: when the relation type has no gap.
        """
        gap = self.value(relation, "gap")
        if gap is None:
            raise InputError(f"{self.type}: this relation has no gap")
        return (-TUCKED_SHARE * depth, TUCKED_MOST) if gap == TUCKED else gap

    def check_params(self, params: Mapping[str, Any]) -> dict[str, Any]:
        """The params with their proper types: numbers as float, counts as int, ranges as pairs.

        Raises:
            FieldError: an unknown name, a value of another type, out of bounds or out of order, a missing value.
        """
        out: dict[str, Any] = {}
        for name, value in params.items():
            if name not in self.params:
                hint = suggest(name, self.params, what="known") if self.params else f"; {self.type} takes none"
                raise FieldError((), f': unknown param "{clean(name)}"{hint}')
            try:
                out[name] = self.params[name].check(value)
            except FieldError as error:
                raise FieldError((name, *error.loc), error.text) from None
        for name, param in self.params.items():
            if param.required and name not in out:
                unit = f", in {param.unit}" if param.unit else ""
                raise FieldError((), f': "{name}" is missing; {self.type} needs it{unit}')
        if "min" in out and "max" in out and out["min"] > out["max"]:
            raise FieldError(("min",), f"is {out['min']:g}, more than max {out['max']:g}; swap them")
        return out


def _pair(value: Any) -> Any:
    return (float(value[0]), float(value[1])) if isinstance(value, list) else value


def _spec(name: str, entry: Mapping[str, Any]) -> RelationSpec:
    gap = _pair(entry.get("gap"))
    params: dict[str, ParamSpec] = {}
    for key, p in entry.get("params", {}).items():  # a param without a default overrides the field of its name
        default = _pair(p["default"]) if "default" in p else {**entry, "gap": gap}[key]
        words = {"choices": tuple(p["choices"])} if "choices" in p else {}
        params[key] = ParamSpec(**{"name": key, **p, **words, "default": default})
    made = {
        "gap": gap,
        "params": MappingProxyType(params),
        "constants": MappingProxyType(entry.get("constants", {})),
        "roles": frozenset(entry.get("roles", ())),
        "snap": MappingProxyType({key: _exact(e) for key, e in entry.get("snap", {}).items()}),
        "ways": ways_of(name, entry["ways"], entry.get("frame")),
    }
    plain = {key: tuple(value) if isinstance(value, list) else value for key, value in entry.items() if key not in made}
    return RelationSpec(type=name, **plain, **made)


def _exact(entry: Mapping[str, Any]) -> Exact:
    value = entry["exact"]
    return Exact("middle" if value == "middle" else float(value), _pair(entry["within"]), entry.get("alike"))


_specs: dict[str, RelationSpec] = {
    name: _spec(name, entry) for name, entry in load("relations.yaml")["relations"].items()
}


class Catalogue(Mapping[str, RelationSpec]):
    """Relation types by name, read-only."""

    def __getitem__(self, name: str) -> RelationSpec:
        return _specs[name]

    def __iter__(self) -> Iterator[str]:
        return iter(_specs)

    def __len__(self) -> int:
        return len(_specs)

    def with_role(self, *roles: str) -> frozenset[str]:
        """The names of the types that have any of some roles (`ROLES`)."""
        return frozenset(name for name, spec in _specs.items() if spec.roles & set(roles))


CATALOGUE = Catalogue()
"""Every relation type by name, in the order of the data file; registered ones come last."""

BUILT_IN: frozenset[str] = frozenset(_specs)


def register_relation(spec: RelationSpec) -> RelationSpec:
    """Add a relation type of your own; scenes that use it load from then on.

    Raises:
        InputError: when the name is taken, or its target or a side is none of the known ones.
    """
    if spec.type in _specs:
        raise InputError(f"relation type {show(spec.type)} is there already; choose another name")
    if spec.target not in TARGETS:
        fix = suggest(spec.target, TARGETS)
        raise InputError(f"relation type {show(spec.type)}: target is {show(spec.target)}{fix}")
    for side in (*spec.subject_sides, *spec.target_sides):
        if side not in SIDES:
            raise InputError(f"relation type {show(spec.type)}: side {show(side)} is unknown{suggest(side, SIDES)}")
    _specs[spec.type] = spec
    return spec


def unregister_relation(name: str) -> None:
    """Take back a registered relation type.

    Raises:
        InputError: when it is built in or unknown.
    """
    if name in BUILT_IN:
        raise InputError(f"relation type {show(name)} is built in; only registered ones can be taken back")
    if _specs.pop(name, None) is None:
        raise InputError(f"relation type {show(name)} is unknown{suggest(name, _specs)}")
