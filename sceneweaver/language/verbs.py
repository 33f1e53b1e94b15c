"""Verbs and "with": the lists that they open, and who they are about."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets.taxonomy import likeliness

from .chunks import Chunk
from .parsed import Mention, Said
from .relating import relate_to_nearest, relate_to_place
from .state import Frame, State, Waiting
from .things import match_of, name_of
from .vocabulary import Place, Verb, frame, shows, words

_CENTERING = ("center", "centre", "anchor", "focus")
"""Verbs that say what a room is laid out around."""


def open_ends(state: State) -> None:
    """A word of place that got no target is noted, unless it is one of the short words that say little."""
    waiting, state.waiting = state.waiting, None
    if waiting is None or waiting.lost or waiting.first is not None:
        return
    if waiting.place.words not in words("relations")["weak"]:
        state.out.note(f"'{waiting.place.words}': it is not clear of what; it was left out")


def with_chunk(state: State, chunk: Chunk) -> None:
    """ "With" opens the list of what its owner has, or of what is there."""
    state.negated, state.unwanted = "", []
    open_ends(state)
    owner = state.head if state.glue in ("", "and") else (state.subject or state.first_items)[-1:]
    owner = _rather_carries(state, owner)
    if state.each and state.subject:
        owner = state.subject
    begins = state.glue == "start" and not state.out.mentions
    apart = state.lost and not state.previous
    if owner and not (begins or apart):
        if chunk.text in ("full of", "filled with"):
            state.frames.append(Frame("verb", list(owner), "inside", chunk.text))
        else:
            frame = Frame("with", list(owner), words=chunk.text, each=bool(state.each))
            if state.nth is not None and owner == [state.nth[0]]:
                frame.each, frame.nth, state.nth = False, state.nth[1], None  # "the third with a lamp"
            state.frames.append(frame)
    elif not state.frames:
        state.frames.append(Frame("list"))
    state.glue = "open"
    state.manner = ""


def _rather_carries(state: State, owner: list[Mention]) -> list[Mention]:
    """ "A nightstand beside the bed with a lamp": of what was placed and what it was placed by, what rather carries the
    first thing of the list."""
    last, item = state.out.said[-1] if state.out.said else None, state.chunk(state.at)
    if last is None or last.implied or len(owner) != 1 or [*last.targets[-1:]] != owner or item is None:
        return owner
    if item.kind != "noun" or item.value.what != "thing" or last.type in ("on", "inside"):
        return owner
    thing = match_of(name_of(item.value)).category
    ranks = [likeliness(thing, m.category) for m in (owner[0], last.subjects[-1])]
    nearer = ranks[1] is not None and (ranks[0] is None or ranks[1] < ranks[0])
    return list(last.subjects) if nearer else owner


def verb_chunk(state: State, chunk: Chunk) -> None:
    """A verb ends its subject, places it, or opens a list of what it has, holds or is flanked by."""
    verb: Verb = chunk.value
    if state.relative and state.head:  # "a desk that holds": said of the desk like a participle
        state.relative = False
        if verb.lemma == "be":
            return
        state.head = _rather_carries(state, state.head)
        verb = Verb(verb.lemma, "ed" if chunk.passive else "ing")
    finite = verb.form in ("s", "base") or (verb.form == "ed" and chunk.passive and state.after_be)
    after_be, state.after_be = state.after_be, False
    if state.negated == "first" and _places(state, verb):
        state.negated, state.done = "where", True  # "may not stand in front of the window"
        state.subject = list(state.subject or state.head)
        return
    if state.negated == "first" and verb.form == "base" and shows(verb.lemma):
        return  # "it should not have a bed"
    if state.negated and verb.form in ("base", "s") and state.glue != "":
        state.negated = ""
    if verb.lemma == "be" and (verb.form in ("s", "base") or chunk.passive):
        if verb.form in ("s", "base"):
            state.after_be, state.negated = True, ""
            _finite(state, chunk)
            state.predicate = list(state.subject)
        return
    voices = frame(verb)
    if verb.form == "ed" and state.noun_next() and state.head and voices is not None and not chunk.passive:
        verb = Verb(verb.lemma, "s")  # "three cabinets lined the walls"
        finite = state.glue == ""
    if verb.lemma in _CENTERING and not state.subject and not state.frames and _centers_room(state, chunk, verb):
        return
    inner = state.frames[-1] if state.frames else None
    if state.glue == "and" and inner is not None and inner.kind == "verb" and not finite and not inner.finite:
        state.frames.pop()
        state.head = list(inner.owner)  # "holding a vase and flanked by chairs"
    if verb.form in ("s", "base") and not chunk.passive:
        _finite(state, chunk)
    _place_by_verb(state, chunk, verb, _owner(state, finite or after_be), finite, after_be)


def _places(state: State, verb: Verb) -> bool:
    """Whether a verb after "not" only leads to the words that say where."""
    after = state.chunk(state.at)
    posture = verb.lemma == "be" or verb.lemma in words("relations")["verbs"]["posture"]
    return posture and after is not None and after.kind == "place" and bool(state.subject or state.head)


def _centers_room(state: State, chunk: Chunk, verb: Verb) -> bool:
    """ "A room centered around a desk": whether a list opens of what the room is laid out around."""
    after = state.chunk(state.at)
    if after is not None and after.kind == "place":
        state.at += after.value.type in ("around", "on", "centered_on", "near", "above")
    if not state.noun_next():
        return False
    state.frames.append(Frame("list", type="" if verb.lemma == "anchor" else "centered", words=chunk.text))
    state.glue, state.lost = "open", False
    return True


def _owner(state: State, of_subject: bool) -> list[Mention]:
    """Who a verb is about."""
    if of_subject:
        return state.subject
    if state.glue not in ("comma", "comma and"):
        return state.head
    return state.subject if state.done else state.head or state.subject


def _place_by_verb(state: State, chunk: Chunk, verb: Verb, owner: list[Mention], finite: bool, after_be: bool) -> None:
    """What a verb says of where things are, in the voice that it stands in."""
    voices: dict[str, Any] = frame(verb) or {}
    manner = words("relations")["manners"].get(verb.lemma)
    if manner is not None and voices and not chunk.passive:
        state.manner = manner
        if manner == "center" and _centered(state, chunk, owner):
            state.manner = ""
        if manner != "drape":
            state.glue = "verb" if finite else ""
            return
    if not ({"by", "with"} & voices.keys() if chunk.passive else "active" in voices):
        if shows(verb.lemma) and verb.form != "ed":
            _shows(state, chunk, owner)
        elif verb.form == "ed" and verb.lemma == "pair":
            _open(state, Frame("with", owner, words=chunk.text), after_be)
        state.glue = "verb" if finite or after_be else ""
    elif verb.form == "ed" and not chunk.passive:
        state.glue = "verb" if after_be else ""
    elif shows(verb.lemma) and not owner:
        _shows(state, chunk, owner)
    else:
        kind, placed = (voices.get("by") or voices["with"]) if chunk.passive else voices["active"]
        _framed(state, chunk, kind, placed, owner, finite or after_be)


def _centered(state: State, chunk: Chunk, owner: list[Mention]) -> bool:
    """ "A rug centered": in the middle of the room, or of what small things stand on, when nothing more is said."""
    after = state.chunk(state.at)
    if after is not None and after.kind in ("place", "adjective", "word"):
        return False
    if owner and (after is None or after.kind != "noun"):
        relate_to_nearest(state, Place("centered_on", words=chunk.text), list(owner), chunk)
    return True


def _framed(state: State, chunk: Chunk, kind: str, placed: str, owner: list[Mention], finite: bool) -> None:
    """A verb relates its owner to what comes after it; ``placed`` says which of the two it places."""
    if kind == "centering":
        after = state.chunk(state.at)
        if owner and not chunk.passive:
            if after is not None and after.kind == "noun" and after.value.definite:  # "a rug anchors the space"
                state.at += 1
                if after.value.what in ("abstract", "room", "place"):
                    middle = Said("at", owner, ("middle",), chunk.text, span=state.chunk_span(), implied=True)
                    relate_to_place(state, middle)
            state.glue = ""
            return
        if not chunk.passive and after is not None and after.kind == "noun":  # "the room centers on a table"
            _open(state, Frame("list", words="centered", type="centered"), finite)
        elif chunk.passive and not owner:
            _open(state, Frame("list"), finite)
        state.glue = "open" if state.noun_next() else ""
    elif not owner and not state.lost and not state.fronted and kind != "occupying":
        _open(state, Frame("list"), finite)
        state.glue = "open"
    elif placed == "before":
        if finite:
            state.close_frames()
        place = Place(kind, words=chunk.text)
        state.waiting = Waiting(place, list(owner), chunk, state.subset, lost=state.lost and not owner)
        state.subset = None
        state.glue = "object"
    else:
        _open(state, Frame("verb", list(owner), kind, chunk.text, finite=finite, each=bool(state.each)), finite)
        state.glue = "open"


def _shows(state: State, chunk: Chunk, owner: list[Mention]) -> None:
    owner = [m for m in owner if not m.implied]
    frame = (
        Frame("with", list(owner), words=chunk.text, each=bool(state.each))
        if owner
        else Frame("list", words=chunk.text)
    )
    _open(state, frame, True)
    state.glue = "open"


def _open(state: State, frame: Frame, finite: bool) -> None:
    if finite:
        state.frames = [f for f in state.frames[:1] if f.kind == "list" and f.owner == frame.owner]
    state.frames.append(frame)


def _finite(state: State, chunk: Chunk) -> None:
    """A finite verb ends the search for its subject; one in the singular has the last thing of a list for it."""
    state.done = True
    verb: Verb = chunk.value
    if state.glue in ("and", "comma", "comma and") and state.subject and not state.subject_open:
        state.close_frames()
        state.head = list(state.subject)
    elif state.subject_open and state.subject:
        singular = verb.form == "s" and chunk.text not in ("are", "were")
        if singular and len(state.subject) > 1 and not state.fronted:
            related = {m for said in state.out.said for m in said.subjects}
            if not related.isdisjoint(state.subject[:-1]):
                state.subject = state.subject[-1:]
        state.frames = []
        state.head = list(state.subject)
    elif state.fronted and not state.subject:
        state.frames = [Frame("fronted", fronted=state.fronted, finite=True)]
        state.fronted = []
        state.glue = "open"
        state.subject_open = False
        state.inverted = True
        return
    elif state.frames and state.frames[-1].items and not state.subject:
        state.subject, state.head = state.frames[-1].items[-1:], state.frames[-1].items[-1:]
    state.subject_open = False
    state.glue = "verb"
