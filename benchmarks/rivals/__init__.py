"""Other solvers on the same rooms, judged by the same judge. One module each; a new one gets a line here."""

from benchmarks.rivals.base import RIVALS as RIVALS
from benchmarks.rivals.base import Rival as Rival
from benchmarks.rivals.base import present as present
from benchmarks.rivals.base import register as register
from benchmarks.rivals.base import solve as solve

from . import numpy_descent as numpy_descent  # enters itself

__all__ = ["RIVALS", "Rival", "present", "register", "solve"]
