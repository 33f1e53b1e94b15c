"""The kinds of faults beside the design rules: what they take off, the lid of grave ones, and the rows that find them.

``faults/*.yaml`` has the kinds, one file for each subject; a row is one of `sceneweaver.rules.design`, with the points
of a fault and when it is grave. Numbers that several kinds share stand in ``faults.yaml``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any

from .design import Row, known_keys, read_row, read_yaml


@dataclass(frozen=True)
class FaultKind:
    """One kind of fault.

    Attributes:
        id: its name.
        criteria: the grades that it lowers; empty: those of a check of the user's own.
        most: points that faults of the kind take off a criterion together.
        lid: the highest grade while a grave fault of the kind stands; None: no such fault.
        points: of one fault, where all of the kind cost the same; None: the rows say them.
        empty: whether it is looked for in a room without objects.
        limits: its numbers by name, with those that all kinds share: metres, degrees, counts, shares.
        rows: what is looked at.
    """

    id: str
    criteria: tuple[str, ...] = ()
    most: float = 0.0
    lid: float | None = None
    points: float | None = None
    empty: bool = False
    limits: Mapping[str, Any] = field(default_factory=dict)
    rows: tuple[Row, ...] = ()


@cache
def _shared() -> Mapping[str, Any]:
    return read_yaml(resources.files(__package__ or "") / "faults.yaml")


def number(name: str) -> float:
    """A number that several kinds of faults share; KeyError when there is none of that name."""
    return _shared()["numbers"][name]


@cache
def fault_kinds() -> Mapping[str, FaultKind]:
    """All kinds by name, file by file.

    Raises:
        ValueError: a kind or row has a field that is unknown, or a kind is there twice.
    """
    found: dict[str, FaultKind] = {}
    for file in sorted((resources.files(__package__ or "") / "faults").iterdir(), key=lambda f: f.name):
        for data in read_yaml(file) if file.name.endswith(".yaml") else ():
            name = data["id"]
            known_keys(name, data, FaultKind)
            if name in found:
                raise ValueError(f"{file.name}: {name} is there twice")
            rows = tuple(read_row(name, row) for row in data.get("rows", ()))
            limits = _shared()["numbers"] | data.get("limits", {})
            given = {"most": _shared()["most"], **data, "criteria": tuple(data["criteria"])}
            found[name] = FaultKind(**given | {"limits": limits, "rows": rows})
    return MappingProxyType(found)


def fault_kind(name: str) -> FaultKind:
    """A kind, or for an unknown name one with the usual numbers."""
    return fault_kinds().get(name) or FaultKind(name, most=_shared()["most"])
