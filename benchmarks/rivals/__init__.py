"""Other solvers on the same rooms, judged by the same judge. One module each; a new one gets a line here.

PyTorch and Drake are not locked with the development dependencies: their wheels bring CUDA libraries and MOSEK along,
which are large and not under open licences. ``uv pip install torch drake`` adds them to an environment.
"""

from benchmarks.rivals.base import RIVALS as RIVALS
from benchmarks.rivals.base import Rival as Rival
from benchmarks.rivals.base import batch_size as batch_size
from benchmarks.rivals.base import present as present
from benchmarks.rivals.base import register as register
from benchmarks.rivals.base import solve as solve

from . import drake_projection as drake_projection  # each enters itself
from . import numpy_descent as numpy_descent
from . import torch_descent as torch_descent
from . import torch_positions as torch_positions

__all__ = ["RIVALS", "Rival", "batch_size", "present", "register", "solve"]
