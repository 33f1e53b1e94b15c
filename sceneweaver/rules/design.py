"""The design rules as rows: what a row is about, its measure, the interval, what a breach costs and how to mend it.

``design/*.yaml`` has the rules, one file for each family of rooms or things; docs/design_rules.md says how rows are
read. The critic makes findings of rows with a ``text`` (`sceneweaver.critic.design`), the choice among many layouts
makes terms of the engine of rows with a ``span`` (`sceneweaver.agent.choice`). Points tell what a breach costs beside
others; how grades follow from them is in `sceneweaver.rules.grades`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any

from sceneweaver.io import packaged

from .expression import Expression

CRITERIA = ("realism", "functionality", "layout", "completion")


@dataclass(frozen=True)
class Row:
    """One way to keep or break a rule. All texts but templates and selectors are expressions over its case.

    Attributes:
        of: what the row is about: a named selector, or the members of a query by name.
        where: condition on the case.
        let: further quantities of the case by name.
        measure: what is measured; none where the condition is the breach.
        low, high: the interval in which the measure lies.
        slack: how far it may lie outside before that is a breach.
        span: how far outside all points of a term are gone; none: no term is made.
        share: share of the rule's points that such a term has.
        params: further numbers of a term.
        kind: measure of the engine where that is another than the critic's.
        objects: names of the case that a finding or term is about.
        text: what a finding says, or several texts by condition, the first that holds; none: no finding is made.
        mend: what would mend it.
        call: a tool and its inputs that do mend it.
        measured, allowed: what a finding gives for both, where that is not the measure and its interval.
        weight: share of the rule's points, for what is not all of a breach, or more than one.
        points: of a fault that is no breach of a design rule: what it, or a term of it, takes off.
        grave: of such a fault: whether the lid of its kind lies on the grade.
        criterion: of such a fault: the grade that it lowers, where that is not each of its kind.
        rooms: kinds of rooms, or names of groups of them, that the row is for.
    """

    of: str | Mapping[str, str] = ""
    where: Expression | None = None
    let: Mapping[str, Expression] = field(default_factory=dict)
    measure: Expression | None = None
    low: Expression | None = None
    high: Expression | None = None
    slack: Expression = Expression(0.0)
    span: Expression | None = None
    share: Expression = Expression(1.0)
    params: Mapping[str, Expression] = field(default_factory=dict)
    kind: str = ""
    objects: tuple[str, ...] = ()
    text: str | Mapping[str, str] = ""
    mend: str | Mapping[str, str] = ""
    call: Mapping[str, Any] | None = None
    measured: Expression | None = None
    allowed: tuple[Expression | None, Expression | None] | None = None
    weight: Expression = Expression(1.0)
    points: Expression | None = None
    grave: Expression | None = None
    criterion: str = ""
    rooms: frozenset[str] = frozenset()

    def applies(self, room: str) -> bool:
        """Whether the row is for a kind of room."""
        return not self.rooms or room in self.rooms


@dataclass(frozen=True)
class DesignRule:
    """One rule: what it says, the grade that a breach lowers, its numbers and its rows.

    Attributes:
        id: its name.
        statement: one plain sentence.
        criterion: the grade that a breach lowers.
        points: what one breach takes off the grade.
        most: what all breaches of it take off together.
        rooms: kinds of rooms that it is for; empty: all.
        limits: its numbers by name: metres, degrees, counts, shares.
        rows: what is looked at.
    """

    id: str
    statement: str
    criterion: str
    points: float
    most: float
    rooms: frozenset[str] = frozenset()
    limits: Mapping[str, float] = field(default_factory=dict)
    rows: tuple[Row, ...] = ()

    def applies(self, room: str) -> bool:
        """Whether the rule is for a kind of room."""
        return not self.rooms or room in self.rooms


@cache
def room_groups() -> Mapping[str, frozenset[str]]:
    """Kinds of rooms that rules name together."""
    data = read_yaml(resources.files(__package__ or "") / "design" / "rooms.yaml")
    return MappingProxyType({name: frozenset(rooms) for name, rooms in data.items()})


@cache
def design_rules() -> Mapping[str, DesignRule]:
    """All rules by id, file by file.

    Raises:
        ValueError: a rule or row has a field that is unknown, or an id is there twice.
    """
    files = sorted((resources.files(__package__ or "") / "design").iterdir(), key=lambda f: f.name)
    found: dict[str, DesignRule] = {}
    for file in files:
        if file.name == "rooms.yaml" or not file.name.endswith(".yaml"):
            continue
        for data in read_yaml(file):
            rule = _rule(data)
            if rule.id in found or rule.criterion not in CRITERIA:
                raise ValueError(f"{file.name}: {rule.id} is there twice, or has no criterion of {CRITERIA}")
            found[rule.id] = rule
    return MappingProxyType(found)


def limit(rule: str, name: str) -> float:
    """A number of a rule; KeyError when there is none of that name."""
    return design_rules()[rule].limits[name]


def read_yaml(file: Any) -> Any:
    """What a YAML file has."""
    return packaged.parse(packaged.text_of(file))


def _rule(data: dict[str, Any]) -> DesignRule:
    name = data.get("id", "?")
    rows = tuple(read_row(name, row) for row in data.pop("rows", ()))
    known_keys(f"{name}", data, DesignRule)
    return DesignRule(**{**data, "rooms": _rooms(data), "rows": rows})


def read_row(rule: str, data: dict[str, Any]) -> Row:
    """A row of a file; `if` is its condition, and what is no template is an expression."""
    if "if" in data:
        data = {**{k: v for k, v in data.items() if k != "if"}, "where": data["if"]}
    known_keys(f"a row of {rule}", data, Row)
    plain = ("of", "text", "mend", "call", "kind", "criterion")
    found: dict[str, Any] = {k: v for k, v in data.items() if k in plain}
    found["rooms"], found["objects"] = _rooms(data), tuple(data.get("objects", ()))
    for key in data.keys() - {*plain, "rooms", "objects"}:
        value = data[key]
        if isinstance(value, bool):
            raise ValueError(f"a row of {rule}: {key}: a bare on, off, yes or no is a truth value of YAML, so quote it")
        if key == "allowed":
            found[key] = tuple(None if v is None else Expression(v) for v in value)
        elif isinstance(value, dict):
            found[key] = {k: Expression(v) for k, v in value.items()}
        else:
            found[key] = Expression(value)
    return Row(**found)


def known_keys(what: str, data: Mapping[str, Any], kind: type) -> None:
    """Refuse keys that a dataclass has no field for."""
    unknown = set(data) - {f.name for f in fields(kind)}
    if unknown:
        raise ValueError(f"{what}: unknown key {', '.join(sorted(unknown))}")


def _rooms(data: Mapping[str, Any]) -> frozenset[str]:
    groups = room_groups()
    return frozenset(room for name in data.get("rooms", ()) for room in groups.get(name, (name,)))
