"""Pictures of whole homes: plans as architects draw them, storeys without their roof, a walk from room to room."""

from .plan import draw_plan as draw_plan

__all__ = ["draw_plan"]
