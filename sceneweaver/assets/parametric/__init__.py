"""Furniture drawn from numbers: every category has a function that draws it anew for each seed."""

from .builder import Builder as Builder
from .builder import Request as Request
from .builder import Size as Size
from .registry import draws as draws
from .registry import make as make
from .registry import makers as makers

__all__ = ["Builder", "Request", "Size", "draws", "make", "makers"]
