"""The engine's side of relations and terms of the user's own: residuals in the kernels, rows in the compiler."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import warp as wp

from sceneweaver.kernels import user
from sceneweaver.scene import CATALOGUE, Relation

from .rows import BUILDERS, INF, SOFT_WEIGHT, CompiledRelation, Frame, Row

WIDTH = 4  # numbers that reach a residual
MARGIN = 2.0e-3  # [m] below 0 that the energy pulls the residual of a relation to
HELD = 0.05  # share of that which the verdict insists on


@dataclass(frozen=True)
class Term:
    """A term of the energy that belongs to no relation: a residual of each object, or pair, of some categories.

    Attributes:
        feature: the name under which the kernels know its residual.
        subjects: categories of the first object; those of the second one, None where there is none.
        params: numbers that reach the residual.
        weight: beside that of a soft relation.
        scale: metres that a unit of the residual counts as.
    """

    feature: str
    subjects: frozenset[str]
    targets: frozenset[str] | None
    params: tuple[float, ...]
    weight: float
    scale: float


TERMS: dict[str, Term] = {}
"""Terms by name, in the order of their definition."""


def enter_term(
    name: str,
    residual: wp.Function,
    subjects: Iterable[str],
    targets: Iterable[str] | None,
    params: Sequence[float],
    weight: float,
    scale: float,
) -> None:
    """Add a term to the energy of every scene that is compiled from now on.

    It has gone through `probe.check_term`.
    """
    feature = f"term {name}"
    user.register_residual(feature, residual)
    others = None if targets is None else frozenset(targets)
    TERMS[name] = Term(feature, frozenset(subjects), others, tuple(map(float, params)), weight, scale)


def leave_term(name: str) -> None:
    """Take a term out again."""
    user.unregister_residual(TERMS.pop(name).feature)


def compiled_terms(frame: Frame) -> list[tuple[str, CompiledRelation]]:
    """What the terms mean in a room, by name: a soft condition that belongs to no relation, for each object or pair."""
    found = []
    for name, term in TERMS.items():
        row = _row(term.feature, term.params, term.scale, 0.0)
        for i, subject in enumerate(frame.objects):
            if subject.category not in term.subjects:
                continue
            for j in _partners(frame, term, i):
                found.append((name, CompiledRelation((i, j, -1), [[row]], SOFT_WEIGHT * term.weight, 0, False)))
    return found


def _partners(frame: Frame, term: Term, subject: int) -> list[int]:
    """The second objects of a term for one subject; -1 where it has none."""
    if term.targets is None:
        return [-1]
    return [j for j, o in enumerate(frame.objects) if j != subject and o.category in term.targets]


def _row(feature: str, params: Sequence[float], scale: float, margin: float) -> Row:
    p = [*params, *[0.0] * (WIDTH - len(params))]
    return Row(
        user.feature_of(feature),
        aim=(-INF, -margin),
        hold=(-INF, -HELD * margin),
        point=(p[0], p[1]),
        normal=(p[2], p[3]),
        scale=scale,
    )


def enter_relation(name: str, residual: wp.Function, scale: float) -> None:
    """Let the engine pull towards ``residual <= 0``; ``scale`` is how many metres a unit of it counts as.

    It has gone through `probe.check_relation`.
    """
    user.register_residual(name, residual)

    def build(frame: Frame, rel: Relation, value: Callable[[str], Any]) -> list[list[Row]]:
        return [[_row(name, [float(value(param)) for param in CATALOGUE[name].params], scale, MARGIN / scale)]]

    BUILDERS[name] = build


def leave_relation(name: str) -> None:
    """Take a relation out of the engine."""
    user.unregister_residual(name)
    del BUILDERS[name]
