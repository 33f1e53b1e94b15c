"""Energy shares and gradients of every object, for optimisers that step along them.

A CPU takes all terms in one kernel; a GPU takes several (`gradients_gpu`).
"""

from typing import Any, NamedTuple

import warp as wp

from .array_access import inline_on_gpu, item
from .bodies import body_of, candidate_of, layout_of
from .evaluator import EVERY_KIND, evaluator
from .geometry import FAR
from .step import AT_REST, Gradients
from .tables import BOUNDS, Energy, Problems, State, TermSlice
from .warp_primitives import WARP_SIZE

# Fast sines on a GPU are good to a few micrometres; the layout that is kept is measured again with exact ones.
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


class GradientKernel(NamedTuple):
    """A kernel that adds some kinds of terms (bits) to every object's share and gradient."""

    kinds: int
    kernel: Any


def gradient_kernel(module: str, name: str, kinds: int, registers: int | None = None) -> GradientKernel:
    """The kernel of some kinds of terms, in a module. One with bounds sets shares and gradients, others add to them."""
    energy_of = evaluator(kinds)
    wanted = wp.constant(kinds)
    sets = wp.constant(kinds & BOUNDS)

    @wp.kernel(name=name, module=wp.get_module(module), cuda_max_registers=registers)
    def gradients(
        # Problem:
        b: Problems,
        # State in:
        s: State,
        lowest: wp.array(dtype=wp.float32),
        # State in and out:
        each: Gradients,
    ):
        """Add some kinds of terms to every object's share and gradient, [object, candidate].

        Candidates whose ``lowest`` energy is that of rest are left as they are.
        """
        inline_on_gpu()
        group, obj, lane = wp.tid()
        candidate = group * WARP_SIZE + lane
        if candidate >= b.problem.shape[0]:
            return
        c = candidate_of(b, candidate)
        if obj >= c.objects or lowest[candidate] <= AT_REST:
            return
        if (item(b.tables[0].object_terms, c.first_object + obj) & wanted) == 0:
            return
        x = body_of(c, obj, s)
        e = Energy()
        if not wp.isfinite(x.pose):  # comparisons with NaN are false, so every term would pass it
            e.share = FAR
        else:
            e = energy_of(b, layout_of(c, s), x, TermSlice(0, 1, FAR))
        if sets != 0:
            each.share[obj, candidate] = e.share
            each.gradient[obj, candidate] = e.gradient
        elif e.value > 0.0:
            each.share[obj, candidate] = item(each.share, obj, candidate) + e.share
            each.gradient[obj, candidate] = item(each.gradient, obj, candidate) + e.gradient

    return GradientKernel(kinds, gradients)


WHOLE = gradient_kernel(__name__, "gradients_of_all", EVERY_KIND)
