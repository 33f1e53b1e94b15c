"""Requests for whole homes: what rooms they have, how these lie to each other, and what each room is to hold."""

from .model import HomeRequest as HomeRequest
from .model import JointAsked as JointAsked
from .model import RoomAsked as RoomAsked
from .model import Understood as Understood
from .read import read_home as read_home

__all__ = ["HomeRequest", "JointAsked", "RoomAsked", "Understood", "read_home"]
