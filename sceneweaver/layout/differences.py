"""Derivatives along a direction by differences, which know a kink when they meet one.

They take the arrays of NumPy, JAX or PyTorch alike.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

STEP = 1.0e-3
"""How far [m, rad] the coordinate that moves most goes either way, for a difference of gradients."""

APART = 0.1
"""Share by which the differences ahead and behind may be apart; more is a kink."""


def difference(xp: Any, function: Callable[[Any], Any], here: Any, poses: Any, along: Any) -> Any:
    """The derivative along a movement of a function that is ``here`` at the poses; one call for both sides.

    By central differences over `STEP`. Where those ahead and behind are apart a kink lies between, and the smaller one
    is that of the smooth side.

    Args:
        xp: ``numpy``, ``jax.numpy`` or ``torch``.
        function: takes poses [2 B, N, 4], layouts ahead before those behind, and returns [2 B, ...].
        here: what it is at the poses [B, ...].
        poses: [B, N, 4].
        along: the movement [B, N, 4], of any length.
    """
    most = xp.amax(abs(along), (1, 2))
    scale = xp.where(most > 0, most, 1.0)
    step = along * (STEP / scale)[:, None, None]
    found = function(xp.concatenate([poses + step, poses - step]))
    count = len(poses)
    ahead, behind = (found[:count] - here) / STEP, (here - found[count:]) / STEP
    smooth = abs(ahead - behind) <= APART * (1.0 + xp.maximum(abs(ahead), abs(behind)))
    smaller = xp.where(abs(ahead) < abs(behind), ahead, behind)
    whole = xp.where(smooth, (ahead + behind) / 2, smaller)
    return most.reshape((-1,) + (1,) * (whole.ndim - 1)) * whole
