"""The kinds of faults beside the design rules as rows: what they take off together, and the lid of grave ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from types import MappingProxyType

import yaml


@dataclass(frozen=True)
class FaultKind:
    """A row of ``faults.yaml``.

    Attributes:
        most: points that faults of the kind take off a criterion together.
        criteria: the grades that it lowers; empty: those of a check of the user's own.
        lid: the highest grade while a grave fault of the kind stands; None: no such fault.
        points: of one fault, where all of the kind cost the same; None: the check measures them.
    """

    most: float
    criteria: tuple[str, ...] = ()
    lid: float | None = None
    points: float | None = None


@cache
def fault_kinds() -> Mapping[str, FaultKind]:
    """All kinds by name; "default" is for those that have no row."""
    text = (resources.files(__package__ or "") / "faults.yaml").read_text(encoding="utf-8")
    data = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    usual = data["default"]
    return MappingProxyType(
        {name: FaultKind(**{**usual, **row, "criteria": tuple(row.get("criteria", ()))}) for name, row in data.items()}
    )


def fault_kind(name: str) -> FaultKind:
    """The row of a kind, or the default one."""
    rows = fault_kinds()
    return rows.get(name, rows["default"])
