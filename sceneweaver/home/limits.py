"""How much one home may hold; more is refused in one line when it is made."""

from __future__ import annotations

MAX_ROOMS = 300
"""Rooms of a home."""

MAX_STOREYS = 20
"""Storeys of a home."""

MAX_STAIRS = 40
"""Stairs of a home."""

THICKEST = 0.8
"""Thickest wall [m] through which a door joins two rooms."""
