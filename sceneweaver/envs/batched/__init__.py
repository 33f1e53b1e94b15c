"""Many worlds with different rooms and the same robot at once: on a GPU as one launch of MuJoCo Warp."""

from .bank import Bank as Bank
from .bank import Slots as Slots
from .env import BatchedRoomEnv as BatchedRoomEnv
from .steady import steady as steady

__all__ = ["Bank", "BatchedRoomEnv", "Slots", "steady"]
