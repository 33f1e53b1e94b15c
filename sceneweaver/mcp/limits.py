"""How much the server keeps, reads and waits for. Each bound has an error that says so."""

from __future__ import annotations

from dataclasses import dataclass

MOST_PROMPT = 4_000
"""Characters of a request for a design."""

MOST_CANDIDATES = 65536
"""Layouts that a design refines for each call of a tool."""

MOST_SCENE = 8 * 2**20
"""Bytes of a scene file that is opened."""

MOST_HOME = 64 * 2**20
"""Bytes of a file of a home that is opened."""

MOST_PLANS = 12
"""Plans of one search that are kept."""

MOST_LISTED = 60
"""Violations, moves and the like in one answer; the report has them all."""

MOST_OBJECTS = 300
"""Objects in one answer; the scene's resource has them all."""

MOST_FOUND = 200
"""Scene files that are listed."""

MOST_VIEWS = 4
"""Pictures of one call."""

LEAST_SIDE, MOST_SIDE = 200, 2048
"""Pixels of a side of a picture."""

MOST_WAY = 1_000.0
"""Metres of a coordinate or a way, either way."""

MOST_SECONDS = 86_400.0
"""Seconds that a call may ask for; the server's own bound is mostly less."""

GRACE = 6.0
"""Seconds that cancelled work has to end in good order, and work that is late to say so."""

CLOSING = 0.8
"""Seconds that running work has when the server ends."""


@dataclass(frozen=True)
class Limits:
    """Bounds that whoever starts the server may set.

    Attributes:
        seconds: of one call.
        scenes: open at once, and as many homes.
        versions: kept of a scene or a home.
        waiting: calls that may wait for a process to be free.
    """

    seconds: float = 300.0
    scenes: int = 16
    versions: int = 100
    waiting: int = 8
