"""Homes from words: the programme, its plan, all rooms furnished together, and the folder of what came of that."""

from .home import FurnishedHome, furnish_home
from .jobs import FurnishedRoom
from .requests import room_requests

__all__ = ["FurnishedHome", "FurnishedRoom", "furnish_home", "room_requests"]
