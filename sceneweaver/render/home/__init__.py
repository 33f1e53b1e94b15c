"""Pictures of whole homes: plans as architects draw them, storeys without their roof, a walk from room to room."""

from .pictures import home_pictures as home_pictures
from .pictures import home_view as home_view
from .pictures import home_views as home_views
from .pictures import render_home as render_home
from .pictures import report_parts as report_parts
from .plan import draw_plan as draw_plan
from .plan import plan_picture as plan_picture

__all__ = [
    "draw_plan",
    "home_pictures",
    "home_view",
    "home_views",
    "plan_picture",
    "render_home",
    "report_parts",
]
