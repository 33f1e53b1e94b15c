"""Relations of the user's own: their residual functions join the feature dispatch.

Registering one rebinds ``features.user_value`` to a chain of the registered residuals, so that the kernels are
compiled once for a set of user relations and cached by Warp like any other code. Built-in relations never compile
anything: they are rows of data.
"""

from __future__ import annotations

import importlib
import pkgutil
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


def register_residual(name: str, residual: wp.Function) -> None:
    """Enter a residual ``f(a, b, size_a, size_b, p) -> float``: poses as vec4, sizes as vec3, params as vec4."""
    _residuals[name] = residual
    _rebuild()


def unregister_residual(name: str) -> None:
    """Take a residual out again; those registered after it change their codes."""
    del _residuals[name]
    _rebuild()


def probe_gradients(residual: wp.Function, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gradients [K, 4] of a residual for the poses a [K, 4], beside those b: Warp's own, and the engine's."""

    @wp.kernel(module="unique", enable_backward=False)
    def probe(
        # State in:
        a: wp.array(dtype=wp.vec4),
        b: wp.array(dtype=wp.vec4),
        # State out:
        exact_out: wp.array(dtype=wp.vec4),
        near_out: wp.array(dtype=wp.vec4),
    ):
        i = wp.tid()
        size_a = wp.vec3(0.6, 0.8, 0.9)
        size_b = wp.vec3(0.5, 1.1, 0.7)
        p = wp.vec4(0.5, 0.5, 0.5, 0.5)
        ga, _gb, _sa, _sb, _p = wp.grad(residual)(a[i], b[i], size_a, size_b, p)
        exact_out[i] = ga
        g = wp.vec4(0.0, 0.0, 0.0, 0.0)
        for c in range(4):
            h = wp.vec4(0.0, 0.0, 0.0, 0.0)
            h[c] = features.STEP
            up = residual(a[i] + h, b[i], size_a, size_b, p)
            down = residual(a[i] - h, b[i], size_a, size_b, p)
            g[c] = (up - down) / (2.0 * features.STEP)
        near_out[i] = g

    count = len(a)
    compiling.start_warp()
    device = wp.get_preferred_device()
    compiling.load(str(device), [probe.module])
    inputs = [wp.array(x, dtype=wp.vec4, device=device) for x in (a, b)]
    outputs = [wp.zeros(count, dtype=wp.vec4, device=device) for _ in "ab"]
    wp.launch(probe, count, inputs, outputs, device=device)
    return outputs[0].numpy(), outputs[1].numpy()


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
