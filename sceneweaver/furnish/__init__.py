"""Homes from words: the programme, its plan, all rooms furnished together, and the folder of what came of that."""

from .anew import refurnish
from .design import asks_for_home, design_home
from .home import FurnishedHome, furnish_home
from .jobs import FurnishedRoom
from .proposals import PlanProposals, propose_plans
from .requests import room_requests
from .result import HomeResult

__all__ = [
    "FurnishedHome",
    "FurnishedRoom",
    "HomeResult",
    "PlanProposals",
    "asks_for_home",
    "design_home",
    "furnish_home",
    "propose_plans",
    "refurnish",
    "room_requests",
]
