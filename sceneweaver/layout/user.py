"""The engine's side of a relation of the user's own: its residual in the kernels, its row in the compiler."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import user
from sceneweaver.kernels.features import STEP
from sceneweaver.scene import CATALOGUE, InputError, Relation

from .rows import BUILDERS, INF, Frame, Row

WIDTH = 4  # numbers that reach a residual


def enter_relation(name: str, residual: wp.Function, scale: float) -> None:
    """Let the engine pull towards ``residual <= 0``; ``scale`` is how many metres a unit of it counts as.

    Raises:
        InputError: the residual is no ``wp.func`` of the right form, or its gradient is not finite.
    """
    _check_gradient(name, residual)
    user.register_residual(name, residual)

    def build(frame: Frame, rel: Relation, value: Callable[[str], Any]) -> list[list[Row]]:
        p = [float(value(param)) for param in CATALOGUE[name].params]
        p += [0.0] * (WIDTH - len(p))
        margin = 2.0e-3 / scale
        row = Row(
            user.feature_of(name),
            aim=(-INF, -margin),
            hold=(-INF, -0.05 * margin),
            point=(p[0], p[1]),
            normal=(p[2], p[3]),
            scale=scale,
        )
        return [[row]]

    BUILDERS[name] = build


def leave_relation(name: str) -> None:
    """Take a relation out of the engine."""
    user.unregister_residual(name)
    del BUILDERS[name]


def _check_gradient(name: str, residual: wp.Function, count: int = 256) -> None:
    """Compare the engine's differences with Warp's own derivative of the residual at random poses."""
    if not isinstance(residual, wp.Function):
        raise InputError(f'relation "{name}": residual is not a wp.func; decorate it with @wp.func')

    rng = np.random.default_rng(0)
    low, high = (-3.0, -3.0, 0.0, -np.pi), (3.0, 3.0, 2.0, np.pi)
    a, b = (rng.uniform(low, high, (count, 4)).astype(np.float32) for _ in "ab")
    try:
        g, f = user.probe_gradients(residual, a, b)
    except Exception as error:  # Warp's own errors have no common type
        text = str(error).strip().splitlines()
        raise InputError(
            f'relation "{name}": residual does not compile as f(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, '
            f"size_b: wp.vec3, p: wp.vec4) -> number: {text[-1] if text else type(error).__name__}"
        ) from error
    if not (np.isfinite(g).all() and np.isfinite(f).all()):
        raise InputError(
            f'relation "{name}": the gradient of its residual is not finite everywhere; add a small number inside '
            "sqrt, length and division"
        )
    off = np.abs(g - f).max(axis=1) > 1e-2 * (1.0 + np.abs(g).max(axis=1))
    if off.mean() > 0.1:  # a few kinks are fine
        raise InputError(
            f'relation "{name}": the residual is not smooth: Warp\'s gradient and differences over {STEP} disagree at '
            f"{off.mean():.0%} of random poses"
        )
