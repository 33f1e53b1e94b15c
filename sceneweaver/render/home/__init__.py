"""Pictures of whole homes: plans as architects draw them, storeys without their roof, a walk from room to room."""

from .plan import draw_plan as draw_plan
from .plan import plan_picture as plan_picture

__all__ = ["draw_plan", "plan_picture"]
