"""Rooms with a door of their own that leads outside."""

from __future__ import annotations

import re

from sceneweaver.plans import room_type

from .parts import Reading

_OUT = r"(?:outside|outdoors|garden|yard|courtyard|street)"
_OWN = re.compile(
    r"\b(?:(?:its|their|an?|her|his|my|our)\s+)?(?:own|separate|direct|private|independent)\s+"
    r"(?:(?:front|street|outside|entry|main|side|back|garden)\s+)?(?:door|entrance|entry|access|way in)\b"
    r"|\b(?:front |street |outside )?(?:door|entrance|way in)\s+of\s+(?:its|their|her|his|my|our)\s+own\b"
    r"|\b(?:is|be|are)\s+entered\s+(?:separately|from (?:the\s+)?" + _OUT + r")"
    r"|\b(?:its|their)\s+(?:own\s+)?(?:door|entrance)\s+(?:straight\s+)?(?:out|to the " + _OUT + r")"
    r"|\bdoors?\s+(?:of its own\s+)?(?:straight\s+|directly\s+)?(?:out\s+)?(?:to|into)\s+(?:the\s+)?" + _OUT
)
_ONLY = re.compile(rf"\bonly\b[^.;,]{{0,30}}\bfrom\s+(?:the\s+)?{_OUT}\b|\bfrom\s+(?:the\s+)?{_OUT}\s+only\b")


def read_outside(reading: Reading) -> None:
    """ "A workshop with its own door outside", "a store only reached from outside": said of a room up to the next."""
    text = reading.text.lower()
    names = sorted((one for one in reading.named if one.of is None and not one.barred), key=lambda one: one.at)
    for sentence in reading.sentences():
        _of_people(reading, sentence)
    for number, one in enumerate(names):
        kind = room_type(one.kind.type)
        if kind.roles & {"entrance", "outdoor"}:
            continue
        stops = [token.span.start for token in reading.tokens if token.stops and token.span.start >= one.span.end]
        following = [names[number + 1].span.start] if number + 1 < len(names) else []
        end = min([*stops, *following, len(text)])
        said = text[one.span.end : end]
        only, own = _ONLY.search(said), _OWN.search(said)
        if only is None and (own is None or "own" in own[0] and not re.search(r"door|entrance|access", own[0])):
            continue
        found = only or own
        assert found is not None
        one.outside = "only" if only is not None else "also"
        low, high = one.span.end + found.start(), one.span.end + found.end()
        for token in reading.tokens:
            if low <= token.span.start < high or token.span.start < high <= token.span.end:
                token.done = token.done or "rooms"
        if one.outside == "only":
            reading.notes.append(
                f"{one.said or one.kind.noun}: besides the door outside it has one to the rooms within"
            )


def _of_people(reading: Reading, sentence: range) -> None:
    """ "The in-laws have their own front door and their own sitting room": the door is that of their room."""
    rooms = [one for one in reading.named if one.at in sentence and one.of is None and not one.barred]
    start, end = reading.tokens[sentence.start].span.start, reading.tokens[sentence.stop - 1].span.end
    found = _OWN.search(reading.text[start:end].lower())
    if found is None or not rooms or any(one.span.start < start + found.start() for one in rooms):
        return
    theirs = next((one for one in rooms if one.owner), None)
    if theirs is None or room_type(theirs.kind.type).roles & {"entrance", "outdoor", "sanitary"}:
        return
    theirs.outside = theirs.outside or "also"
    for token in reading.tokens:
        if start + found.start() <= token.span.start < start + found.end():
            token.done = token.done or "rooms"
