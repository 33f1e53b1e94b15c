"""The engine's side of relations and terms of the user's own: residuals in the kernels, rows in the compiler."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import user
from sceneweaver.kernels.features import STEP
from sceneweaver.scene import CATALOGUE, InputError, Relation

from .rows import BUILDERS, INF, SOFT_WEIGHT, CompiledRelation, Frame, Row

WIDTH = 4  # numbers that reach a residual


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

    Raises:
        InputError: as `check_gradient`.
    """
    label, feature = f'term "{name}"', f"term {name}"
    require_smooth(label, residual)
    user.register_residual(feature, residual)
    others = None if targets is None else frozenset(targets)
    TERMS[name] = Term(feature, frozenset(subjects), others, tuple(map(float, params)), weight, scale)


def leave_term(name: str) -> None:
    """Take a term out again."""
    user.unregister_residual(TERMS.pop(name).feature)


def compiled_terms(frame: Frame) -> list[CompiledRelation]:
    """What the terms mean in a room: a soft condition that belongs to no relation, for each object or pair."""
    found = []
    for term in TERMS.values():
        row = _row(term.feature, term.params, term.scale, 0.0)
        for i, subject in enumerate(frame.objects):
            if subject.category not in term.subjects:
                continue
            for j in _partners(frame, term, i):
                found.append(CompiledRelation((i, j, -1), [[row]], SOFT_WEIGHT * term.weight, 0, False))
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
        hold=(-INF, -0.05 * margin),
        point=(p[0], p[1]),
        normal=(p[2], p[3]),
        scale=scale,
    )


def enter_relation(name: str, residual: wp.Function, scale: float) -> None:
    """Let the engine pull towards ``residual <= 0``; ``scale`` is how many metres a unit of it counts as.

    Raises:
        InputError: the residual is no ``wp.func`` of the right form, or its gradient is not finite.
    """
    require_smooth(f'relation "{name}"', residual)
    user.register_residual(name, residual)

    def build(frame: Frame, rel: Relation, value: Callable[[str], Any]) -> list[list[Row]]:
        return [[_row(name, [float(value(param)) for param in CATALOGUE[name].params], scale, 2.0e-3 / scale)]]

    BUILDERS[name] = build


def leave_relation(name: str) -> None:
    """Take a relation out of the engine."""
    user.unregister_residual(name)
    del BUILDERS[name]


ROUGH = 0.1
"""Share of random poses at which a gradient may be off: a few kinks are fine."""


def check_gradient(residual: wp.Function, *, count: int = 256, seed: int = 0) -> float:
    """Compare the engine's differences with Warp's own derivative of a residual at random poses.

    Args:
        residual: as for `define_relation`.
        count: how many random pairs of poses.
        seed: equal seeds draw equal poses.

    Returns:
        The share of the poses, 0 to 1, at which the two differ by more than a hundredth: kinks and steps. Up to 0.1 is
        accepted of relations and terms.

    Raises:
        InputError: the residual is no ``wp.func`` of the right form, or its gradient is not finite.

    Examples:
        >>> import sceneweaver as sw, warp as wp
        >>> @wp.func
        ... def far(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        ...     return wp.length(wp.vec2(a[0] - b[0], a[1] - b[1])) - 1.0
        >>> sw.check_gradient(far) < 0.02
        True
    """
    return _rough("residual", residual, count, seed)


def require_smooth(label: str, residual: wp.Function) -> None:
    """Refuse a residual whose gradient is off at more than a few poses; ``label`` says in a message what it is of."""
    off = _rough(label, residual, 256, 0)
    if off > ROUGH:
        raise InputError(
            f"{label}: the residual is not smooth: Warp's gradient and differences over {STEP} disagree at "
            f"{off:.0%} of random poses"
        )


def _rough(label: str, residual: wp.Function, count: int, seed: int) -> float:
    if not isinstance(residual, wp.Function):
        raise InputError(f"{label}: residual is not a wp.func; decorate it with @wp.func")
    rng = np.random.default_rng(seed)
    low, high = (-3.0, -3.0, 0.0, -np.pi), (3.0, 3.0, 2.0, np.pi)
    a, b = (rng.uniform(low, high, (count, 4)).astype(np.float32) for _ in "ab")
    try:
        g, f = user.probe_gradients(residual, a, b)
    except Exception as error:  # Warp's own errors have no common type
        text = str(error).strip().splitlines()
        raise InputError(
            f"{label}: residual does not compile as f(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, "
            f"p: wp.vec4) -> number: {text[-1] if text else type(error).__name__}"
        ) from error
    if not (np.isfinite(g).all() and np.isfinite(f).all()):
        raise InputError(
            f"{label}: the gradient of its residual is not finite everywhere; add a small number inside sqrt, length "
            "and division"
        )
    off = np.abs(g - f).max(axis=1) > 1e-2 * (1.0 + np.abs(g).max(axis=1))
    return float(off.mean())
