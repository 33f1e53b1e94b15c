"""What an evaluation of a residual of the user's own costs, beside one of a built-in row's kind."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import cast

import numpy as np
import warp as wp

from sceneweaver.kernels import user_cost
from sceneweaver.runtime import compiling
from sceneweaver.scene import InputError

from .devices import pick_devices
from .probe_samples import anywhere

PAIRS, REPEATS, RUNS = 512, 256, 5
GPU_PAIRS = 2**16  # enough to fill one


@dataclass(frozen=True)
class ResidualCost:
    """What a residual costs; times depend on the machine and on what else it does.

    Attributes:
        nanoseconds: of one evaluation: the least of several runs, over all pairs at once.
        built_in: of one evaluation of a built-in row's kind, the distance of a thing from a box, in the same way [ns].
        compile_seconds: from source to a kernel with this residual; near 0 where it was compiled before.
        device: where it was measured.
    """

    nanoseconds: float
    built_in: float
    compile_seconds: float
    device: str

    def __str__(self) -> str:
        return (
            f"{self.nanoseconds:.2g} ns an evaluation, {self.nanoseconds / max(self.built_in, 1e-9):.2g} times a "
            f"built-in row's ({self.built_in:.2g} ns), on {self.device}; compiled in {self.compile_seconds:.2g} s"
        )


def residual_cost(residual: wp.Function, *, device: str = "auto") -> ResidualCost:
    """Measure what a residual costs, as for `define_relation` or `define_term`.

    The engine takes a value and its differences by the poses of both things: up to 17 evaluations for a gradient.

    Args:
        residual: a ``wp.func`` ``f(a, b, size_a, size_b, p)``.
        device: as for `refine`.

    Raises:
        InputError: it is no ``wp.func`` of this form.

    Examples:
        >>> import sceneweaver as sw, warp as wp
        >>> @wp.func
        ... def far(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4):
        ...     return 2.0 - wp.length(wp.vec2(a[0] - b[0], a[1] - b[1]))
        >>> cost = sw.residual_cost(far, device="cpu")
        >>> cost.nanoseconds > 0 and cost.built_in > 0
        True
    """
    if not isinstance(residual, wp.Function):
        raise InputError("residual: it is not a wp.func; decorate it with @wp.func")
    where = pick_devices(device)[0]
    mine, seconds = _measured(residual, where)
    plain, _ = _measured(cast(wp.Function, user_cost.box_gap), where)
    return ResidualCost(mine, plain, seconds, where)


def _measured(residual: wp.Function, device: str) -> tuple[float, float]:
    """Nanoseconds of an evaluation, and seconds that it took to compile."""
    began = time.perf_counter()
    kernel = user_cost.spender(residual)
    try:
        compiling.load(device, [kernel.module])
    except Exception as error:  # Warp's own errors have no common type
        text = str(error).strip().splitlines()
        raise InputError(
            "residual: it does not compile as f(a: wp.vec4, b: wp.vec4, size_a: wp.vec3, size_b: wp.vec3, p: wp.vec4) "
            f"-> number: {text[-1] if text else type(error).__name__}"
        ) from error
    compiled = time.perf_counter() - began
    count = PAIRS if device == "cpu" else GPU_PAIRS
    samples = anywhere(count, 0)
    a, b = (wp.array(poses, dtype=wp.vec4, device=device) for poses in (samples.a, samples.b))
    total = wp.zeros(count, dtype=wp.float32, device=device)
    took = []
    for _ in range(RUNS):
        wp.synchronize_device(device)
        began = time.perf_counter()
        wp.launch(kernel, count, [REPEATS, a, b], [total], device=device)
        wp.synchronize_device(device)
        took.append(time.perf_counter() - began)
    return float(np.min(took)) / (count * REPEATS) * 1e9, compiled
