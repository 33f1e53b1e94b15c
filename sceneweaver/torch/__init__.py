"""A `sceneweaver.Problem` as differentiable functions for PyTorch; ``import sceneweaver.torch``.

Every function takes the problem first and poses [..., N, 4] on the problem's device, with any number of leading
dimensions. The engine's kernels run on the tensors' own memory. ``torch.func`` and ``torch.compile`` take the
functions. PyTorch is not installed along with sceneweaver: ``pip install torch``.
"""

from .functions import energy as energy
from .functions import feasible as feasible
from .functions import free as free
from .functions import project as project
from .functions import residuals as residuals

__all__ = ["energy", "feasible", "free", "project", "residuals"]
