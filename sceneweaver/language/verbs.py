"""Verbs and "with": the lists that they open, and who they are about."""

from __future__ import annotations

from .chunks import Chunk
from .parsed import Mention
from .relating import relate_to_nearest, relate_to_place
from .state import Frame, State, Waiting
from .vocabulary import Place, Verb, frame, shows


def open_ends(state: State) -> None:
    """A word of place without a target is said of what is near, or is noted."""
    waiting, state.waiting = state.waiting, None
    if waiting is None or waiting.lost or waiting.first is not None:
        return
    if waiting.place.words not in (
        "in",
        "on",
        "at",
        "by",
        "over",
        "under",
        "around",
        "from",
        "before",
        "about",
        "to",
        "up to",
        "all",
        "next",
        "across",
    ):
        state.out.note(f"'{waiting.place.words}': it is not clear of what; it was left out")


def with_chunk(state: State, chunk: Chunk) -> None:
    state.negated = ""
    if state.waiting is not None:
        open_ends(state)
    owner = state.head if state.glue in ("", "and") else (state.subject or state.first_items)[-1:]
    if state.each and state.subject:
        owner = state.subject
    if not owner or state.lost:
        owner = [] if not state.previous else owner
    if state.glue == "start" and not state.out.mentions:
        owner = []
    if not owner and state.glue in ("comma", "comma and", "while") and state.refs.topics and state.out.mentions:
        owner = []
    if owner:
        state.frames.append(Frame("with", list(owner), words=chunk.text, each=state.each))
        if chunk.text in ("full of", "filled with"):
            state.frames[-1] = Frame("verb", list(owner), "inside", "after", chunk.text)
    elif not state.frames:
        state.frames.append(Frame("list"))
    state.glue, state.subject_open = "open", state.subject_open
    state.manner = ""


def verb_chunk(state: State, chunk: Chunk) -> None:
    verb: Verb = chunk.value
    if state.relative and state.head:
        state.relative = False
        if verb.lemma == "be":
            return
        verb = Verb(verb.lemma, "ing" if not chunk.passive else "ed")
    finite = verb.form in ("s", "base") or (verb.form == "ed" and chunk.passive and state.after_be)
    after_be, state.after_be = state.after_be, False
    if state.negated and verb.form in ("base", "s") and state.glue != "":
        state.negated = ""
    if verb.lemma == "be" and verb.form in ("s", "base"):
        state.after_be = True
        _finite(state, chunk)
        if state.negated:
            state.negated = ""
        state.predicate = list(state.subject)
        return
    if chunk.passive and verb.lemma in ("be",):
        return
    if verb.form == "ed" and state.noun_next() and state.head and frame(verb) is not None and not chunk.passive:
        verb = Verb(verb.lemma, "s")  # "three cabinets lined the walls"
        finite = state.glue == ""
    if verb.lemma in ("center", "centre", "anchor", "focus") and not state.subject and not state.frames:
        after = state.chunk(state.at)
        if (
            after is not None
            and after.kind == "place"
            and after.value.type in ("around", "on", "centered_on", "near", "above")
        ):
            state.at += 1  # "a room centered around a desk"
        if state.noun_next():
            state.frames.append(Frame("list", type="centered" if verb.lemma != "anchor" else "", words=chunk.text))
            state.glue, state.lost = "open", False
            return
    together = state.glue.startswith(("and", "comma")) and state.frames and state.frames[-1].kind == "verb"
    if together and not finite and not state.frames[-1].finite and state.glue == "and":
        state.head = list(state.frames.pop().owner)  # "holding a vase and flanked by chairs"
    voices = frame(verb)
    if verb.form in ("s", "base") and not (chunk.passive):
        _finite(state, chunk)
    owner = (
        state.subject
        if (finite or after_be)
        else state.head
        if state.glue not in ("comma", "comma and")
        else (state.subject if state.done else state.head or state.subject)
    )
    if verb.lemma == "drape" and not chunk.passive:
        state.manner = "drape"
    if (
        verb.lemma in ("hang", "suspend", "lean", "prop", "mount", "center", "centre", "hook")
        and voices is not None
        and not chunk.passive
    ):
        state.manner = {"suspend": "hang", "prop": "lean", "centre": "center", "hook": "mount"}.get(
            verb.lemma, verb.lemma
        )
        if state.manner == "center" and _place_or_nothing(state, chunk, owner):
            state.manner = ""
        state.glue = "verb" if finite else ""
        state.placing = owner
        return
    if (
        voices is None
        or (chunk.passive and not {"by", "with"} & voices.keys())
        or (not chunk.passive and "active" not in voices)
    ):
        if shows(verb.lemma) and verb.form != "ed":
            _shows(state, chunk, owner)
        elif verb.form == "ed" and verb.lemma == "pair":
            _open(state, Frame("with", owner, words=chunk.text), after_be)
        state.glue = "verb" if finite or after_be else ""
        state.placing = owner
        return
    if verb.form == "ed" and not chunk.passive:
        state.glue, state.placing = ("verb" if after_be else ""), owner
        return
    if shows(verb.lemma) and not owner:
        _shows(state, chunk, owner)
        return
    kind, placed = (voices.get("by") or voices["with"]) if chunk.passive else voices["active"]
    _framed(state, chunk, kind, placed, owner, finite or after_be)


def _place_or_nothing(state: State, chunk: Chunk, owner: list[Mention]) -> bool:
    """ "A rug centered": in the middle of the room, or of what small things stand on, when nothing more is said."""
    after = state.chunk(state.at)
    if after is not None and after.kind in ("place", "adjective", "word"):
        return False
    if after is not None and after.kind == "noun":
        return True
    if owner:
        relate_to_nearest(state, Place("centered_on", words=chunk.text), list(owner), chunk)
    return True


def _framed(state: State, chunk: Chunk, kind: str, placed: str, owner: list[Mention], finite: bool) -> None:
    if kind == "centering" and owner and not chunk.passive:
        after = state.chunk(state.at)
        if after is not None and after.kind == "noun" and after.value.definite:  # "a rug anchors the space"
            state.at += 1
            if after.value.what in ("abstract", "room", "place"):
                relate_to_place(state, "at", owner, "middle", chunk.text, None, state.chunk_span(), True)
        state.glue = ""
        return
    if kind == "centering":
        if not chunk.passive and state.noun_next() and not owner:  # "the room centers on a table"
            _open(state, Frame("list", words="centered"), finite)
            state.frames[-1].type = "centered"
        elif chunk.passive and not owner:
            _open(state, Frame("list"), finite)
        state.glue = "open" if state.noun_next() else ""
        return
    if not owner and not state.lost and not state.fronted and kind != "occupying":
        _open(state, Frame("list"), finite)
        state.glue = "open"
        return
    if placed == "before":
        words = Place(kind, words=chunk.text)
        if finite:
            state.frames = [f for f in state.frames[:1] if f.kind == "list"]
        state.waiting = Waiting(words, list(owner), chunk, state.subset, lost=state.lost and not owner)
        state.subset = None
        state.glue = "object"
        return
    _open(state, Frame("verb", list(owner), kind, placed, chunk.text, finite=finite, each=state.each), finite)
    state.glue = "open"


def _shows(state: State, chunk: Chunk, owner: list[Mention]) -> None:
    owner = [m for m in owner if not m.implied]
    _open(state, Frame("with", list(owner), words=chunk.text) if owner else Frame("list", words=chunk.text), True)
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
        state.frames = [f for f in state.frames[:1] if f.kind == "list"]
        state.head = list(state.subject)
    elif state.subject_open and state.subject:
        if verb.form == "s" and chunk.text not in ("are", "were") and len(state.subject) > 1 and not state.fronted:
            related = {id(m) for s in state.out.said for m in s.subjects}
            if any(id(m) in related for m in state.subject[:-1]):
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
    state.placing = list(state.subject)
