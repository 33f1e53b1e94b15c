"""A `sceneweaver.Problem` as pure functions for JAX: jit, vmap, grad, jvp and jacobians; ``import sceneweaver.jax``.

Every function takes the problem first, which is static (a pytree without leaves), and poses [..., N, 4] with any number
of leading dimensions. The engine's kernels run on JAX's own buffers, without copies.
"""

from .functions import carry as carry
from .functions import energy as energy
from .functions import energy_and_grad as energy_and_grad
from .functions import feasible as feasible
from .functions import free as free
from .functions import project as project
from .functions import ravel as ravel
from .functions import residuals as residuals
from .functions import sample as sample
from .functions import unravel as unravel

__all__ = [
    "carry",
    "energy",
    "energy_and_grad",
    "feasible",
    "free",
    "project",
    "ravel",
    "residuals",
    "sample",
    "unravel",
]
