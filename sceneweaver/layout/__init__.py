"""Compile a scene to a layout problem, refine many candidates of it, select."""

from .refine import refine as refine
from .solution import Solution as Solution

__all__ = ["Solution", "refine"]
