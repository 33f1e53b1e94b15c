"""Which rooms the prior is trained on and which it never sees: decided by hashes of names, before anything is drawn."""

from __future__ import annotations

from hashlib import blake2b
from itertools import islice

from sceneweaver.knowledge import room_types

HELD_KINDS = 12
"""Kinds of rooms of which no room at all is trained on."""

HELD_SHARE = 8
"""One in so many seeds of the other kinds is held out."""

SEEDS = 1_000
"""Seeds of a kind."""


def _hash(text: str) -> int:
    return int.from_bytes(blake2b(f"prior of layouts: {text}".encode(), digest_size=8).digest(), "big")


def held_kinds() -> list[str]:
    """The kinds of rooms that are held out."""
    return sorted(room_types(), key=_hash)[:HELD_KINDS]


def held_out(kind: str, seed: int) -> bool:
    """Whether a seed of a kind that is trained on is held out."""
    return _hash(f"{kind} {seed}") % HELD_SHARE == 0


def training_rooms() -> list[tuple[str, int]]:
    """Kinds and seeds to train on: a first room of each kind, then a second one of each, and so on."""
    held = set(held_kinds())
    kinds = sorted((k for k in room_types() if k not in held), key=lambda k: _hash(f"order {k}"))
    return [(kind, seed) for seed in range(SEEDS) for kind in kinds if not held_out(kind, seed)]


def problems_of_known_kinds(count: int) -> list[tuple[str, int]]:
    """Held-out rooms, one of each of so many kinds that are trained on."""
    held = set(held_kinds())
    kinds = sorted((k for k in room_types() if k not in held), key=lambda k: _hash(f"problems {k}"))
    found = ((kind, next(s for s in range(SEEDS) if held_out(kind, s))) for kind in kinds)
    return list(islice(found, count))


def problems_of_new_kinds(kinds: int, each: int) -> list[tuple[str, int]]:
    """Rooms of kinds that are held out."""
    return [(kind, seed) for seed in range(each) for kind in held_kinds()[:kinds]]
