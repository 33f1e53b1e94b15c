"""`gradients` for a GPU: a kernel for each group of terms, which add up.

One for all would keep so much in registers that few warps fit side by side, and what is rare would slow down what is
common. How many registers a group gets was measured; see docs/gpu.md.
"""

import warp as wp

from .gradients import gradient_kernel
from .tables import BOUNDS, BOXES, DISTANCES, FORMULAS, POLYGONS, PULL, RELATIONS

# Fast sines on a GPU are good to a few micrometres; the layout that is kept is measured again with exact ones.
wp.set_module_options({"enable_backward": False, "fast_math": True, "default_grid_stride": False})

GROUPS = (
    gradient_kernel(__name__, "gradients_of_formulas", BOUNDS | PULL | FORMULAS, 64),
    gradient_kernel(__name__, "gradients_of_distances", DISTANCES, 128),
    gradient_kernel(__name__, "gradients_of_relations", RELATIONS, 128),
    gradient_kernel(__name__, "gradients_of_boxes", BOXES, 80),
    gradient_kernel(__name__, "gradients_of_polygons", POLYGONS, 128),
)
"""The first sets shares and gradients. A batch needs it, and those others whose kinds of terms it has."""
