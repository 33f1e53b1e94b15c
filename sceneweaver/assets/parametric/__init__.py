"""Furniture drawn from numbers: every category has a function that draws it anew for each seed."""

from ..drawing import Request as Request
from ..drawing import Size as Size
from ..drawing import draws as draws
from .catalogue import make as make
from .catalogue import makers as makers

__all__ = ["Request", "Size", "draws", "make", "makers"]
