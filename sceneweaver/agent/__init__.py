"""Plan, act, reflect: from a request in words to a room, by tools that are chosen by their cards and their record."""

from .design import design as design
from .result import Result as Result
from .settings import Settings as Settings

__all__ = ["Result", "Settings", "design"]
