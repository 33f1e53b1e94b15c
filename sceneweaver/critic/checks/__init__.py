"""Measures of the faults beside the design rules, as `sceneweaver/rules/faults` asks for them."""

from . import bodies, facing

__all__ = ["bodies", "facing"]
