"""What the learned analysis tells apart: kinds of mentions, marks of words, links between mentions."""

from __future__ import annotations

KINDS = {
    "thing": "what is to be in the room",
    "unwanted": "what must not be there",
    "person": "people and animals who use the room",
    "opening": "a door, a window",
    "place": "a wall or part of the room",
    "free": "floor that is to stay free, a way",
    "measure": "a length, an area",
    "quality": "what something is like",
    "arrangement": "how several things stand to each other",
    "room": "the room itself",
    "reference": "a word that stands for another mention",
}
"""Kinds of mentions, and what they are."""

WHERE = (
    *("on", "in", "under", "above", "beside", "near", "far", "left", "right", "front", "behind", "facing", "opposite"),
    *("against", "along", "between", "around", "at", "flank", "center", "sees"),
)
"""Links that say where a thing is, from it to what it is placed by."""

LINKS = ("none", *WHERE, "each", "of", "from", "to", "part", "for", "same")
"""All links: of so many things for each of the owners; of a quality to what has it; the ends of a way; a thing of a
part of the room; whom it is for; what a reference stands for."""

MARKS = ("outside", *(f"{mark} {kind}" for kind in KINDS for mark in ("begin", "inside")))
"""Marks of words, by which they make mentions."""
