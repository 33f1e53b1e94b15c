"""Relations of the user's own: their residual functions join the feature dispatch.

Registering one rebinds ``features.user_value`` to a chain of the registered residuals, so that the kernels are
compiled once for a set of user relations and cached by Warp like any other code. Built-in relations never compile
anything: they are rows of data.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import warp as wp

from sceneweaver.runtime import compiling

from . import features
from .tables import FEATURE_USER

_NO_RESIDUAL = features.user_value
_residuals: dict[str, wp.Function] = {}


def feature_of(name: str) -> int:
    """The feature code of a registered residual."""
    return FEATURE_USER + list(_residuals).index(name)


def residuals() -> dict[str, wp.Function]:
    """The registered residuals by name, in the order of their codes."""
    return dict(_residuals)


def register_residual(name: str, residual: wp.Function) -> None:
    """Enter a residual ``f(a, b, size_a, size_b, p) -> float``: poses as vec4, sizes as vec3, params as vec4."""
    _residuals[name] = residual
    _rebuild()


def unregister_residual(name: str) -> None:
    """Take a residual out again; those registered after it change their codes."""
    del _residuals[name]
    _rebuild()


def prober(residual: wp.Function) -> Callable[..., tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
    """A function that looks at a residual as the engine does; compiled once, at its first call.

    It takes poses a, b [K, 4], sizes [K, 3] of both and params [K, 4], and gives values [K], Warp's own gradients by a
    [K, 4], and the engine's differences by a and by b [K, 4].
    """

    @wp.kernel(module="unique", enable_backward=False)
    def probe(
        # State in:
        a: wp.array(dtype=wp.vec4),
        b: wp.array(dtype=wp.vec4),
        size_a: wp.array(dtype=wp.vec3),
        size_b: wp.array(dtype=wp.vec3),
        p: wp.array(dtype=wp.vec4),
        # State out:
        value_out: wp.array(dtype=wp.float32),
        exact_out: wp.array(dtype=wp.vec4),
        by_a_out: wp.array(dtype=wp.vec4),
        by_b_out: wp.array(dtype=wp.vec4),
    ):
        i = wp.tid()
        value_out[i] = float(residual(a[i], b[i], size_a[i], size_b[i], p[i]))
        ga, _gb, _sa, _sb, _p = wp.grad(residual)(a[i], b[i], size_a[i], size_b[i], p[i])
        exact_out[i] = ga
        by_a = wp.vec4(0.0, 0.0, 0.0, 0.0)
        by_b = wp.vec4(0.0, 0.0, 0.0, 0.0)
        for c in range(4):
            h = wp.vec4(0.0, 0.0, 0.0, 0.0)
            h[c] = features.STEP
            up = residual(a[i] + h, b[i], size_a[i], size_b[i], p[i])
            down = residual(a[i] - h, b[i], size_a[i], size_b[i], p[i])
            by_a[c] = (up - down) / (2.0 * features.STEP)
            up_b = residual(a[i], b[i] + h, size_a[i], size_b[i], p[i])
            down_b = residual(a[i], b[i] - h, size_a[i], size_b[i], p[i])
            by_b[c] = (up_b - down_b) / (2.0 * features.STEP)
        by_a_out[i] = by_a
        by_b_out[i] = by_b

    def measure(a: np.ndarray, b: np.ndarray, size_a: np.ndarray, size_b: np.ndarray, p: np.ndarray):
        compiling.start_warp()
        device, count = wp.get_preferred_device(), len(a)
        compiling.load(str(device), [probe.module])
        types = (wp.vec4, wp.vec4, wp.vec3, wp.vec3, wp.vec4)
        inputs = [
            wp.array(np.ascontiguousarray(x, dtype=np.float32), dtype=t, device=device)
            for x, t in zip((a, b, size_a, size_b, p), types, strict=True)
        ]
        outputs = [wp.zeros(count, dtype=t, device=device) for t in (wp.float32, wp.vec4, wp.vec4, wp.vec4)]
        wp.launch(probe, count, inputs, outputs, device=device)
        return tuple(x.numpy() for x in outputs)

    return measure


def _link(residual: wp.Function, before: wp.Function, code: int) -> wp.Function:
    @wp.func(name=f"user_value_{code}_{residual.key}", module=features.__name__)
    def user_value(kind: wp.int32, a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        value = before(kind, a, b, size_a, size_b, p)
        if kind == wp.static(code):
            value = residual(a, b, size_a, size_b, p)
        return value

    return user_value


def _rebuild() -> None:
    chain = _NO_RESIDUAL
    for i, residual in enumerate(_residuals.values()):
        chain = _link(residual, chain, FEATURE_USER + i)
    features.user_value = chain
    package = __name__.rpartition(".")[0]
    for info in pkgutil.iter_modules([str(Path(__file__).parent)]):
        wp.get_module(importlib.import_module(f"{package}.{info.name}").__name__).mark_modified()
