"""The design rules over a scene whose poses are known: queries, measures and findings of the rows."""

from .evaluate import faults as faults
from .evaluate import other_faults as other_faults

__all__ = ["faults", "other_faults"]
