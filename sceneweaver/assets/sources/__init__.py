"""Where assets come from, behind one protocol: drawn from numbers, imported into the store, made by Infinigen."""

from .base import Card as Card
from .base import Source as Source
from .library import Library as Library
from .parametric import ParametricSource as ParametricSource
from .stored import StoreSource as StoreSource

__all__ = ["Card", "Library", "ParametricSource", "Source", "StoreSource"]
