"""The judge of whole homes: rooms by the judge of rooms, and what joins them; it shares nothing with the engine."""

from .access import Ways as Ways
from .check import check_home as check_home
from .floors import RADIUS as RADIUS
from .floors import Floor as Floor
from .floors import floors_of as floors_of
from .reports import HomeAccess as HomeAccess
from .reports import HomeReport as HomeReport
from .reports import HomeViolation as HomeViolation

__all__ = ["RADIUS", "Floor", "HomeAccess", "HomeReport", "HomeViolation", "Ways", "check_home", "floors_of"]
