"""Materials with grain: seamless maps by the name of a texture, and coordinates that lay them on any mesh."""

from .catalogue import found as found
from .catalogue import kind_of as kind_of
from .catalogue import patterns as patterns
from .library import maps as maps
from .projection import uv_of as uv_of
from .registry import Pattern as Pattern
from .relief import Maps as Maps

__all__ = ["Maps", "Pattern", "found", "kind_of", "maps", "patterns", "uv_of"]
