"""Files as users of data sets expect them: shards, index, splits without near-duplicates, card, checksums."""

from .fingerprint import fingerprint, signature
from .finish import finish
from .hub import push_card
from .packing import pack
from .plan import packing

__all__ = ["finish", "fingerprint", "pack", "packing", "push_card", "signature"]
