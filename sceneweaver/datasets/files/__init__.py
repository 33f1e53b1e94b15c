"""Files as users of data sets expect them: shards, index, splits without near-duplicates, card, checksums."""

from .fingerprint import fingerprint, signature
from .finish import finish
from .packing import pack
from .plan import packing

__all__ = ["finish", "fingerprint", "pack", "packing", "signature"]
