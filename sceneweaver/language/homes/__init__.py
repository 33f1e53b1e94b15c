"""Requests for whole homes: what rooms they have, how these lie to each other, and what each room is to hold."""

from .asks import is_home as is_home
from .demands import demands as demands
from .model import HomeDemand as HomeDemand
from .model import HomeRequest as HomeRequest
from .model import JointAsked as JointAsked
from .model import RoomAsked as RoomAsked
from .model import Understood as Understood
from .read import read_home as read_home
from .texts import room_requests as room_requests

__all__ = [
    "HomeDemand",
    "HomeRequest",
    "JointAsked",
    "RoomAsked",
    "Understood",
    "demands",
    "is_home",
    "read_home",
    "room_requests",
]
