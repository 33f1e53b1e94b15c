"""Measures of the faults beside the design rules, as `sceneweaver/rules/faults` asks for them."""

from . import access, bodies, facing, order, report

__all__ = ["access", "bodies", "facing", "order", "report"]
