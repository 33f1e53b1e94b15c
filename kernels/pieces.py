"""`slopes` for a GPU: a kernel for each kind of terms, which add up.

One for all would keep so much in registers that few warps fit side by side, and what is rare would slow down what is
common. How many registers a kind gets was measured; see docs/gpu.md.
"""

from typing import Any

import warp as wp

from .array_access import inline_on_gpu, item, item_strided
from .energy import add_contact_energy, own_energy
from .geometry import FAR
from .slopes import at_work
from .tables import (
    BOXES,
    DISTANCES,
    FORMULAS,
    POLYGONS,
    RELATIONS,
    ROOM,
    Margins,
    Share,
    State,
    TablesRef,
    View,
    Weights,
)
from .warp_primitives import WARP_SIZE

# Fast sines on a GPU are good to a few micrometres; the layout that is kept is measured again with exact ones.
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

EVERY_KIND = ROOM | FORMULAS | DISTANCES | RELATIONS | BOXES | POLYGONS


def _piece(name: str, kinds: int, registers: int) -> tuple[int, Any]:
    """Some kinds of terms and the kernel that adds them up; the one with the room begins anew."""
    wanted = wp.constant(kinds)
    without = wp.constant(EVERY_KIND & ~kinds)
    alone = wp.constant(kinds & (ROOM | FORMULAS | DISTANCES | RELATIONS))
    meets = wp.constant(kinds & (BOXES | POLYGONS))
    fresh = wp.constant(kinds & ROOM)

    @wp.kernel(name=name, cuda_max_registers=registers)
    def slopes(
        # Problem:
        t: TablesRef,
        m: Margins,
        w: Weights,
        problem: wp.array(dtype=wp.int32),
        # State in:
        s: State,
        lowest: wp.array(dtype=wp.float32),
        # State in and out:
        share: wp.array2d(dtype=wp.float32),
        slope: wp.array2d(dtype=wp.vec4),
    ):
        """Add some kinds of terms to every object's share and slope, [object, candidate]."""
        inline_on_gpu()
        group, obj, lane = wp.tid()
        candidate = group * WARP_SIZE + lane
        if not at_work(t, problem, candidate, obj, lowest):
            return
        p = problem[candidate]
        if (item(t[0].object_terms, item(t[0].object_start, p) + obj) & wanted) == 0:
            return
        pose = item_strided(s.poses, candidate, obj)
        q = item_strided(s.turns, candidate, obj)
        e = float(0.0)
        own = float(0.0)
        g = wp.vec4(0.0, 0.0, 0.0, 0.0)
        view = View()
        view.without = without
        if not wp.isfinite(pose):  # comparisons with NaN are false, so every term would pass it
            own = FAR
        else:
            if alone != 0:
                e, own, _soft, g = own_energy(t, m, w, p, candidate, obj, pose, q, s, view, Share(0, 1))
            if meets != 0:
                e, own, g = add_contact_energy(
                    t, m, w, p, candidate, obj, pose, q, s, FAR, view, Share(0, 1), e, own, g
                )
        if fresh != 0:
            share[obj, candidate] = own
            slope[obj, candidate] = g
        elif e > 0.0:
            share[obj, candidate] = item(share, obj, candidate) + own
            slope[obj, candidate] = item(slope, obj, candidate) + g

    return kinds, slopes


PIECES = (
    _piece("slopes_of_formulas", ROOM | FORMULAS, 64),
    _piece("slopes_of_distances", DISTANCES, 128),
    _piece("slopes_of_relations", RELATIONS, 128),
    _piece("slopes_of_boxes", BOXES, 80),
    _piece("slopes_of_polygons", POLYGONS, 128),
)
"""Kinds of terms and the kernel, with the arguments of ``slopes.slopes_of_all``, that adds them to shares and slopes.

The first one sets shares and slopes. A batch needs those only whose kinds it has.
"""
