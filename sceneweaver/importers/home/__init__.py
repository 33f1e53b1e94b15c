"""Plans of other systems as homes: clear floors between walls of real thickness, doors that join two rooms."""

from .model import ImportedHome as ImportedHome
from .read import read_homes as read_homes

__all__ = ["ImportedHome", "read_homes"]
