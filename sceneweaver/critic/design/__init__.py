"""The design rules over a scene whose poses are known: queries, measures and findings of the rows."""

from .evaluate import faults as faults

__all__ = ["faults"]
