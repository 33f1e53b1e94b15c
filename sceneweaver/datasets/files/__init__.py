"""Files as users of data sets expect them: shards, index, splits without near-duplicates, card, checksums."""

from .card import push_card
from .fingerprint import fingerprint
from .packing import finish, pack
from .planned import packing_began

__all__ = ["finish", "fingerprint", "pack", "packing_began", "push_card"]
