"""Live editing: a scene that is kept valid after every edit, with all that an edit does not touch left where it is."""

from .session import EditResult as EditResult
from .session import EditSession as EditSession

__all__ = ["EditResult", "EditSession"]
