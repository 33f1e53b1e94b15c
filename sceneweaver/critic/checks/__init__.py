"""Measures of the faults beside the design rules, as ``sceneweaver/rules/faults`` asks for them."""

from . import access, bodies, facing, finish, floor, order, program, report, sizes

__all__ = ["access", "bodies", "facing", "finish", "floor", "order", "program", "report", "sizes"]
