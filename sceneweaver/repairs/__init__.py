"""Repair of scenes that are there already: the least movement after which the judge has nothing to say."""

from .report import Move as Move
from .report import Repair as Repair
from .run import repair as repair
from .run import repair_many as repair_many
from .run import repair_report as repair_report

__all__ = ["Move", "Repair", "repair", "repair_many", "repair_report"]
