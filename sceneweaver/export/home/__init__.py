"""Whole homes as one scene of other tools: rooms as groups, walls once, doors that open."""

from .built import BuiltHome as BuiltHome

__all__ = ["BuiltHome"]
