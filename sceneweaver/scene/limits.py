"""How much one scene may hold. More is refused when the scene is made, in one line and by every command alike.

The numbers leave room for the largest halls and keep the work on a scene bounded: a search, the judge and the pictures
take seconds to minutes with the most of everything, and end in time when they are told to. docs/conventions.md lists
them.
"""

from __future__ import annotations

MAX_OBJECTS = 2_000
"""Objects of a scene; also those that are listed as dropped."""

MAX_RELATIONS = 10_000
"""Relations of a scene."""

MAX_FREE_AREAS = 100
"""Free areas of a scene."""

MAX_DOORS = 100
"""Doors of a room."""

MAX_WINDOWS = 500
"""Windows of a room."""

MAX_CORNERS = 500
"""Corners of an outline, and of the polygon of a part, a zone or a surface."""

MAX_PARTS = 64
"""Parts of an object, and likewise its zones and its surfaces."""

MAX_SHAPES = 20_000
"""Parts, zones and surfaces of all objects of a scene together."""

MOST_TURN = 3_600.0
"""Degrees by which one edit turns an object at most, either way."""
