"""Furniture drawn from numbers: every category has a function that draws it anew for each seed."""

from .builder import Builder as Builder
from .builder import Request as Request
from .builder import Size as Size
from .drawing import make as make
from .drawing import makers as makers
from .registry import draws as draws

__all__ = ["Builder", "Request", "Size", "draws", "make", "makers"]
