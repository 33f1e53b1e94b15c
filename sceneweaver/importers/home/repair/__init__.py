"""Plans repaired with least movement."""

from .plan import PlanMove as PlanMove
from .plan import PlanRepair as PlanRepair
from .plan import repair_plan as repair_plan

__all__ = ["PlanMove", "PlanRepair", "repair_plan"]
