"""What is known about rooms: kinds of rooms, arrangements on tables, what fills shelves. All of it is data."""

from .load import room_types as room_types
from .model import Count as Count
from .model import Item as Item
from .model import Opening as Opening
from .model import Place as Place
from .model import RoomType as RoomType
from .names import match_room as match_room
from .names import room_type as room_type

__all__ = ["Count", "Item", "Opening", "Place", "RoomType", "match_room", "room_type", "room_types"]
