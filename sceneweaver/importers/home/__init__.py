"""Plans of other systems as homes: clear floors between walls of real thickness, doors that join two rooms."""

from .model import ImportedHome as ImportedHome
from .read import read_homes as read_homes
from .repair import PlanMove as PlanMove
from .repair import PlanRepair as PlanRepair
from .repair import repair_plan as repair_plan

__all__ = ["ImportedHome", "PlanMove", "PlanRepair", "read_homes", "repair_plan"]
