"""Gates: what a scene must be to be delivered. Each is one row of ``gates.yaml``, which all who ask for it read."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import TYPE_CHECKING, Any, Literal

from pydantic import Field, create_model

from sceneweaver.assets.category import read_yaml
from sceneweaver.scene.base import FrozenModel

TYPES: dict[str, Any] = {"number": float, "count": int | None, "length": float | None}
"""Types of limits by their name in ``gates.yaml``."""

ROUNDING = 1e-9
"""How far a number of a table may be beyond its limit."""


@dataclass(frozen=True)
class Gate:
    """One row of ``gates.yaml``.

    Attributes:
        name: of the option of a specification.
        measure: what is measured.
        at: whether the limit is the least or the most that it may be.
        limit: type, default, bounds and description of the option.
        fails: the words for a delivered scene that does not pass, with fields for ``value`` and ``limit``.
        valid: whether it is looked at only where a scene is valid.
    """

    name: str
    measure: str
    at: Literal["least", "most"]
    limit: dict[str, Any]
    fails: str
    valid: bool = False

    def asked(self, gates: Gates) -> Any:
        """The limit that a specification sets; None where it asks for nothing."""
        limit = getattr(gates, self.name)
        return None if limit == self.limit["default"] else limit

    def passes(self, value: float | None, limit: float, rounding: float = 0.0) -> bool:
        """Whether a value is within the limit; what was not measured is."""
        if value is None:
            return True
        return value >= limit - rounding if self.at == "least" else value <= limit + rounding


@cache
def gates() -> tuple[Gate, ...]:
    """All gates, in the order in which they are looked at."""
    rows = read_yaml(resources.files(__package__ or "").joinpath("gates.yaml"))
    return tuple(Gate(name, **row) for name, row in rows.items())


def gate_names() -> tuple[str, ...]:
    """The flags of a scene: whether it is valid, and through each gate."""
    return ("valid", *(gate.name for gate in gates()))


if TYPE_CHECKING:

    class Gates(FrozenModel):
        """The limits that a specification sets, a field a gate."""

        def __getattr__(self, name: str) -> Any: ...

else:

    def _field(limit: dict[str, Any]) -> Any:
        return TYPES[limit["type"]], Field(**{name: value for name, value in limit.items() if name != "type"})

    Gates = create_model(
        "Gates", __base__=FrozenModel, __module__=__name__, **{gate.name: _field(gate.limit) for gate in gates()}
    )
    Gates.__doc__ = (
        "What a scene must be to be delivered; one that is not is drawn again, and at last left out with its reason."
    )


def passed(asked: Gates, measure: Callable[[str], Any]) -> dict[str, bool]:
    """Whether a scene is valid, and through each of the gates that a specification asks for.

    Args:
        asked: the limits.
        measure: the value of a measure by its name; a list is counted, None is what was not measured.
    """
    valid, found = bool(measure("valid")), {}
    for gate in gates():
        limit = gate.asked(asked)
        if limit is not None and (valid or not gate.valid):
            found[gate.name] = gate.passes(_number(measure(gate.measure)), limit)
    return {"valid": valid, **found}


def failures(asked: Gates, row: Callable[[str], Any]) -> Iterator[str]:
    """Lines about gates that a delivered row does not pass, by its columns."""
    for gate in gates():
        limit, value = gate.asked(asked), _number(row(gate.measure))
        if limit is not None and value is not None and not gate.passes(value, limit, ROUNDING):
            yield gate.fails.format(value=value, limit=limit)


def _number(value: Any) -> Any:
    return len(value) if isinstance(value, list | tuple) else value
