"""Grades for a scene, with reasons and with what would mend it."""

from .model import CRITERIA as CRITERIA
from .model import Fault as Fault
from .model import Review as Review
from .review import review_scene as review_scene

__all__ = ["CRITERIA", "Fault", "Review", "review_scene"]
