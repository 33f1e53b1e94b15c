"""Relations of the user's own: their residual functions join the feature dispatch.

Registering one rebinds ``features.user_value`` to a chain of the registered residuals, so that the kernels are
compiled once for a set of user relations and cached by Warp like any other code. Built-in relations never compile
anything: they are rows of data.
"""

from __future__ import annotations

import importlib
import pkgutil
from pathlib import Path

import warp as wp

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
