"""Energy shares and gradients of every object, for optimisers that step along them: all terms in one kernel.

That is best on a CPU; a GPU takes `pieces`.
"""

import warp as wp

from .array_access import item
from .energy import object_energy
from .geometry import FAR
from .step import AT_REST
from .tables import Margins, Share, State, TablesRef, View, Weights
from .warp_primitives import WARP_SIZE

wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})


@wp.func
def at_work(
    t: TablesRef,
    problem: wp.array(dtype=wp.int32),
    candidate: wp.int32,
    obj: wp.int32,
    lowest: wp.array(dtype=wp.float32),
):
    """True for an object of a candidate that is not at rest."""
    if candidate >= problem.shape[0]:
        return False
    p = problem[candidate]
    return obj < item(t[0].object_start, p + 1) - item(t[0].object_start, p) and lowest[candidate] > AT_REST


@wp.kernel
def slopes_of_all(
    # Problem:
    t: TablesRef,
    m: Margins,
    w: Weights,
    problem: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    lowest: wp.array(dtype=wp.float32),
    # State out:
    share_out: wp.array2d(dtype=wp.float32),
    slope_out: wp.array2d(dtype=wp.vec4),
):
    """Every object's share of its candidate's energy and the gradient for its pose, [object, candidate].

    Candidates whose ``lowest`` energy is that of rest are left as they are.
    """
    group, obj, lane = wp.tid()
    candidate = group * WARP_SIZE + lane
    if not at_work(t, problem, candidate, obj, lowest):
        return
    _e, share, _soft, g = object_energy(t, m, w, problem[candidate], candidate, obj, s, FAR, View(), Share(0, 1))
    share_out[obj, candidate] = share
    slope_out[obj, candidate] = g
