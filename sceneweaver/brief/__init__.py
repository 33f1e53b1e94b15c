"""Plain English in, a typed request out; no model is needed."""

from .model import Asked as Asked
from .model import AskedRelation as AskedRelation
from .model import Brief as Brief

__all__ = ["Asked", "AskedRelation", "Brief"]
