"""What the judge found, in the form of ``metrics.json`` (schema ``sceneweaver.metrics/1``)."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal, NoReturn

from sceneweaver.io import write_atomic
from sceneweaver.scene.display import Displayed

from .measure import Measurement

SCHEMA = "sceneweaver.metrics/1"

OPEN = 0.9
"""Share of its range from which on a door, drawer or lid counts as open."""

Kind = Literal[
    "collision",
    "out_of_bounds",
    "unsupported",
    "blocked_zone",
    "blocked_opening",
    "blocked_floor",
    "narrow_path",
    "relation",
    "soft_relation",
    "unstable",
    "blocked_link",
    "yaw_domain",
    "dropped",
]


@dataclass(frozen=True, slots=True)
class RelationRef:
    """Which relation of a scene is meant: its place in ``relations``, and what stands there."""

    index: int
    type: str
    subject: str
    target: str | tuple[str, str] | None


@dataclass(frozen=True, slots=True)
class Violation:
    """One thing that is wrong.

    Attributes:
        kind: what kind of thing; ``soft_relation`` and ``narrow_path`` leave the scene valid, every other makes it
            invalid.
        objects: ids of all that take part: of a relation its subject, then its targets (an object, wall, door or
            window); of a blocked zone its owner, then who stands in it; of a blocked opening the object, then the
            opening; of blocked floor and a narrow path the free area, then what bounds it; of a blocked link its
            object or door, then what is in its way: an object, door, wall, "floor" or "ceiling".
        detail: one sentence with numbers and units.
        amount: how much, 0 when it has no size. Metres: depth of a collision or in a zone, distance outside the room,
            height or length that is wrong under an object. Degrees: of a yaw off its domain. Of a relation the worst
            excess over what is allowed, in metres, or in degrees where the angle is worst; angles are compared with
            lengths on an arm of half a metre. Of a blocked link the share of its range by which it opens too little.
        relation: the relation that does not hold; None for other kinds.
        zone: name of the blocked zone among those of its owner; None for other kinds.
        measurement: what was measured, and the interval in which it should lie, the tolerance of the judge aside. Of
            several quantities that are off the worst; None where nothing can be measured.

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> bed = scene.object("bed").pose
        >>> report = sw.check(scene.replace_poses({"wardrobe": bed}))
        >>> violation = next(v for v in report.violations if v.kind == "collision")
        >>> violation.objects, violation.hard, violation.amount > 0.1
        (('bed', 'wardrobe'), True, True)
    """

    kind: Kind
    objects: tuple[str, ...]
    detail: str
    amount: float
    relation: RelationRef | None = None
    zone: str | None = None
    measurement: Measurement | None = None

    @classmethod
    def of(
        cls, kind: Kind, objects: tuple[str, ...], detail: str, measurement: Measurement | None, **more: Any
    ) -> Violation:
        """A violation whose amount is how far a measurement is off, 0 without one."""
        amount = measurement.excess if measurement is not None else 0.0
        return cls(kind, objects, detail, amount, measurement=measurement, **more)

    @property
    def hard(self) -> bool:
        """Whether it makes the scene invalid."""
        return self.kind not in ("soft_relation", "narrow_path")

    def to_dict(self) -> dict[str, Any]:
        """Return plain JSON data.

        ``relation``, ``zone`` and the keys of the measurement (``quantity``, ``measured``, ``allowed`` [low, high] with
        null for an open end, ``unit``) are there only where there is something to say.
        """
        data = {"kind": self.kind, "objects": list(self.objects), "detail": self.detail, "amount": self.amount}
        data["hard"] = self.hard
        if self.relation is not None:
            data["relation"] = asdict(self.relation)
        if self.zone is not None:
            data["zone"] = self.zone
        if (m := self.measurement) is not None:
            allowed = [end if math.isfinite(end) else None for end in (m.low, m.high)]
            data |= {"quantity": m.quantity, "measured": m.value, "allowed": allowed, "unit": m.unit}
        return data


@dataclass(frozen=True, slots=True)
class LinkTravel:
    """How far a door, drawer or lid opens.

    Attributes:
        object: id of its object, or of the room's door.
        link: name of the link; "leaf" of a room's door.
        role: "door", "drawer" or "lid".
        share: of its range that is free, 0 to 1.
        blocked_by: what is in its way: id of an object or door, "wall:k", "floor" or "ceiling"; None: nothing.
    """

    object: str
    link: str
    role: str
    share: float
    blocked_by: str | None = None

    @property
    def opens(self) -> bool:
        """Whether it opens far enough, to `OPEN`."""
        return self.share >= OPEN - 1e-9


class _Items:
    """Lets fields be read like keys as well, as in the JSON form; they are no lists."""

    def __getitem__(self, key: str) -> Any:
        if not isinstance(key, str):
            raise TypeError(self._no_list())
        if key not in self._names():
            raise KeyError(f"{key!r} is not one of {', '.join(self._names())}")
        return getattr(self, key)

    def __iter__(self) -> NoReturn:
        raise TypeError(self._no_list())

    def _names(self) -> tuple[str, ...]:
        return tuple(self.__dataclass_fields__)  # type: ignore[attr-defined]

    def _no_list(self) -> str:
        return (
            f"{type(self).__name__} is no list: it counts relations ({', '.join(self._names())}); Report.unmet has "
            "those that do not hold, one by one"
        )


@dataclass(frozen=True)
class Tally(_Items):
    """How many of the relations hold."""

    total: int = 0
    satisfied: int = 0


@dataclass(frozen=True)
class RelationTally(_Items):
    """How many of the hard and of the soft relations hold."""

    hard: Tally = Tally()
    soft: Tally = Tally()


@dataclass(frozen=True)
class Report(Displayed):
    """The verdict on one scene.

    ``valid`` when nothing is dropped, collides, leaves the room, lacks support or blocks a hard zone or opening, and
    every hard relation holds. ``relations`` counts these; `unmet` has those that do not hold, one by one.

    Counts: ``collisions`` pairs of objects; ``out_of_bounds`` and ``unsupported`` objects; ``blocked_zones`` (object,
    zone, other object) triples; ``blocked_openings`` (opening, object) pairs. The shares are explained in
    `walkable.Access`; None when they were not measured. They are those of a disc of ``robot_radius`` [m] (None: 0.2).
    ``openable_share`` is that of the doors, drawers and lids that open to 90 % (None: not measured, or there are none),
    ``blocked_links`` are the others. ``stability`` and ``scores`` belong to the physics and the critics, as does
    ``alignment``: how many items a request has (total), and how many are met, unmet, assumed and not_understood;
    ``seed``, ``device`` and ``candidates`` to the run that made the scene: fill them in with ``dataclasses.replace``.
    So does ``cut_off``, what ended that run before it was done (None: nothing did), and ``left_out``, the files that it
    had no time for. ``seconds`` is wall time, in all and by step. ``warnings`` say where meshes or measures had to be
    done without. ``models`` says what a language or vision model did in the run that made the scene, as docs/agent.md
    has it (None: no model was asked), ``start`` what it changed of a scene that it began with (None: it began with
    none of somebody else).

    Examples:
        >>> import sceneweaver as sw
        >>> scene = sw.Scene.example("bedroom")
        >>> outside = scene.replace_poses({"plant": sw.Pose.from_yaw(9.0, 0.0, 0.0, 0.0)})
        >>> report = sw.check(outside)
        >>> report.valid, report.out_of_bounds
        (False, 1)
        >>> report.relations.soft.total - report.relations.soft.satisfied
        1
        >>> [(v.relation.type, v.relation.subject) for v in report.unmet]
        [('in_corner', 'plant')]
    """

    valid: bool
    requested: int
    placed: int
    dropped: int
    collisions: int
    out_of_bounds: int
    unsupported: int
    blocked_zones: int
    blocked_openings: int
    relations: RelationTally = RelationTally()
    walkable_share: float | None = None
    reachable_share: float | None = None
    robot_radius: float | None = None
    openable_share: float | None = None
    blocked_links: tuple[LinkTravel, ...] | None = None
    stability: Mapping[str, Any] | None = None
    scores: Mapping[str, Any] | None = None
    alignment: Mapping[str, int] | None = None
    violations: tuple[Violation, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=dict)
    seed: int | None = None
    device: str | None = None
    candidates: int | None = None
    cut_off: str | None = None
    left_out: tuple[str, ...] = ()
    versions: Mapping[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    models: Mapping[str, Any] | None = None
    start: Mapping[str, Any] | None = None

    @property
    def unmet(self) -> tuple[Violation, ...]:
        """The relations that do not hold, hard ones first; ``relation.index`` is the place in the scene's relations."""
        return tuple(v for kind in ("relation", "soft_relation") for v in self.violations if v.kind == kind)

    def to_dict(self) -> dict[str, Any]:
        """Return plain JSON data.

        ``left_out``, ``warnings``, ``models``, ``start`` and ``robot_radius`` are there only where set.
        """
        data: dict[str, Any] = {"schema": SCHEMA, **asdict(self)}
        data["violations"] = [v.to_dict() for v in self.violations]
        if self.blocked_links is not None:
            data["blocked_links"] = [asdict(link) for link in self.blocked_links]
        for name in ("left_out", "warnings"):
            data[name] = list(data[name])
            if not data[name]:
                del data[name]
        for name in ("models", "start", "robot_radius"):
            if data[name] is None:
                del data[name]
        return data

    def to_json(self, indent: int | None = 1) -> str:
        """Return the text of ``metrics.json``."""
        return json.dumps(self.to_dict(), indent=indent, allow_nan=False, ensure_ascii=False)

    def save(self, path: str | Path) -> None:
        """Write ``metrics.json`` under a temporary name beside it and rename it: it is never seen half written."""
        write_atomic(path, self.to_json() + "\n")
