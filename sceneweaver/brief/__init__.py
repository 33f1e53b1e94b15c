"""Plain English in, a typed request out; no model is needed."""

from .model import Asked as Asked
from .model import AskedRelation as AskedRelation
from .model import Brief as Brief
from .read import read_brief as read_brief

__all__ = ["Asked", "AskedRelation", "Brief", "read_brief"]
