"""Counterfactuals: twins of a scene that differ from it in one stated thing, with the measured difference."""

from .twins import Twin, twin_files, twins

__all__ = ["Twin", "twin_files", "twins"]
