"""Homes from words: the programme, its plan, all rooms furnished together, and the folder of what came of that."""

from .design import asks_for_home, design_home
from .home import FurnishedHome, furnish_home
from .jobs import FurnishedRoom
from .requests import room_requests
from .result import HomeResult

__all__ = [
    "FurnishedHome",
    "FurnishedRoom",
    "HomeResult",
    "asks_for_home",
    "design_home",
    "furnish_home",
    "room_requests",
]
