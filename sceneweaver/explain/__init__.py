"""Refine, and say why no candidate is valid: a few plain lines, the most fundamental cause first.

Arithmetic comes first, as it proves: fixed objects in each other's way, objects larger than the room or their surface,
more width against the walls than there is wall, more footprint than floor. What arithmetic cannot see is searched
for: small refinements of parts of the scene tell which objects or hard relations do not go together, and a deletion
search (QuickXplain) narrows them down. A search can miss a layout, so what it finds is called found, not proved.
What is wrong in a layout is what the judge finds in it.

Everything is bounded by work, and the same call finds the same; the clock only cuts off, and the text says so.
"""

from .refine import refine as refine
from .refine import refine_many as refine_many
from .report import certificate as certificate
from .report import explain as explain

__all__ = ["certificate", "explain", "refine", "refine_many"]
