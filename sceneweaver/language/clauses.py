"""Chunks into mentions and relations: who is placed where, clause by clause."""

from __future__ import annotations

from collections.abc import Callable

from sceneweaver.assets.taxonomy import category_named

from .chunks import Chunk, NounPhrase
from .exclusions import excluded, only_chunk, without_chunk
from .items import close_surface, open_surface
from .nearness import meant_of_list
from .parsed import Mention
from .pronouns import number_phrase, pronoun_phrase
from .region_phrases import part_phrase, region_phrase, thing_phrase
from .relating import relate_mutually, relate_to_nearest
from .room_phrases import abstract_phrase, group_phrase, people_phrase, place_phrase, room_phrase, room_quality
from .state import Frame, State, Waiting
from .things import describe, give_sides, singular
from .tokens import Token
from .verbs import open_ends, verb_chunk, with_chunk
from .vocabulary import Place, mounts

_TURNED = ("transform", "convert", "turn", "set up")

SEATED = 4
"""Chairs from which on those around a table are taken for dining chairs."""


def _is_plain(noun: str) -> bool:
    """Whether chairs are not called armchairs and the like, but for what covers them."""
    return singular(noun).split()[-1] == "chair" and not _EASY.intersection(noun.split())


_EASY = frozenset(("arm", "easy", "lounge", "reading", "accent", "club", "wing", "sofa", "papasan", "slipper"))
"""Words for chairs to rest in."""


def _purpose(state: State, chunk: Chunk) -> None:
    if state.waiting is not None:
        open_ends(state)
    if state.glue == "verb":
        state.glue = ""


def _adjective(state: State, chunk: Chunk) -> None:
    """Words of quality alone: of what "is" so, of what stands before them, or of the room."""
    phrase: NounPhrase = chunk.value
    if state.glue == "open" and state.frames and state.frames[-1].owner and not state.frames[-1].items:
        state.head, state.glue = state.frames.pop().owner, ""  # "covered in red felt"
    who = state.predicate or (state.head if state.glue == "" and not state.waiting else [])
    if phrase.sides is not None:
        sides, phrase.sides = phrase.sides, None
        last = (state.head or state.subject)[-1:]
        if last and not state.waiting and _furniture(last[0], sides):
            give_sides(last[0], sides)
        else:
            state.out.sides.append(sides)
    if phrase.length is not None and (state.head or state.subject):
        axis = next((t.get("dim") for t in phrase.qualities if t.has("dim")), None)
        if axis is not None:
            last_one = (state.head or state.subject)[-1]
            last_one.size[int(axis)], last_one.scale = phrase.length, 1.0
    if who:
        for mention in who:
            describe(
                mention, NounPhrase("thing", "", phrase.start, phrase.end, qualities=phrase.qualities), state.source
            )
    else:
        for token in phrase.qualities:
            room_quality(state, token, room=not state.out.mentions or state.after_be)


def _word(state: State, chunk: Chunk) -> None:
    token: Token = chunk.value
    if (
        token.text in ("seats", "sleeps", "accommodates")
        and state.at < len(state.chunks)
        and state.chunks[state.at].kind == "noun"
    ):
        phrase = state.chunks[state.at].value
        if phrase.what == "number":
            state.out.people = (phrase.count or (1, 1))[1]
            state.at += 1
            return
    if not token.kinds and token.text.isalpha() and not token.text.endswith("ly"):
        state.leave_unread(token.text, chunk.start, chunk.end)


def read_clauses(state: State) -> None:
    """All chunks."""
    _sentence(state)
    while state.at < len(state.chunks):
        chunk = state.chunks[state.at]
        state.at += 1
        if chunk.kind not in ("while", "verb", "word"):
            state.relative = False
        _CHUNKS[chunk.kind](state, chunk)
    _sentence(state)
    _seated(state)


def _seated(state: State) -> None:
    """Chairs around a table to eat at are dining chairs, upholstered or not."""
    for said in state.out.said:
        target = said.targets[0]
        if said.type not in ("around", "along", "at", "flanking") or not isinstance(target, Mention):
            continue
        for one in said.subjects:
            many = one.count is not None and one.count[0] >= SEATED
            if many and "dining" in target.category and one.category == "armchair" and _is_plain(one.noun):
                one.category = "dining_chair"


def _sentence(state: State) -> None:
    open_ends(state)
    close_surface(state)
    inverted = [t for f in state.frames[:1] for _, ts, _ in f.fronted for t in ts if isinstance(t, Mention)]
    topic = (inverted if state.inverted else []) or state.subject or state.first_items[:1]
    if not topic and state.lost:
        topic = state.out.mentions[state.begun :][:1]
    state.begun = len(state.out.mentions)
    if topic and topic not in state.refs.topics[-1:]:
        state.refs.topics.append(list(topic))
    state.begin()


def _stop(state: State, chunk: Chunk) -> None:
    _sentence(state)


def _bracket(state: State, chunk: Chunk) -> None:
    state.glue = "bracket"


def _comma(state: State, chunk: Chunk) -> None:
    if state.waiting is not None and state.waiting.first is None:
        open_ends(state)
    state.manner, state.each = "", False
    state.glue = "comma"
    state.predicate = []


def _and(state: State, chunk: Chunk) -> None:
    state.glue = "comma and" if state.glue == "comma" else "or" if chunk.text == "or" else "and"


def _while(state: State, chunk: Chunk) -> None:
    if chunk.text == "but":
        state.negated = ""
        state.glue = "comma"
        return
    if chunk.text == "where" and (state.head or state.subject):
        place = (state.head or state.subject)[-1]
        if mounts(place.category)[0] == "floor":
            open_surface(state, place, chunk.text)
    if chunk.text in ("that", "which", "whose", "who"):
        state.relative = bool(state.head)
        return
    if state.subject:
        state.refs.topics.append(list(state.subject))
    open_ends(state)
    bottom = [f for f in state.frames[:1] if f.kind == "list"]
    state.frames, state.fronted, state.waiting = bottom, [], None
    state.subject, state.subject_open, state.glue, state.negated, state.manner = [], True, "while", "", ""


def _noun(state: State, chunk: Chunk) -> None:
    phrase: NounPhrase = chunk.value
    state.after_be = False
    if state.negated and excluded(state, phrase, chunk):
        return
    _PHRASES[phrase.what](state, phrase, chunk)


def _place(state: State, chunk: Chunk) -> None:
    place: Place = chunk.value
    state.after_be = False
    if state.negated:
        _nowhere(state, chunk)
        return
    if state.waiting is not None:
        open_ends(state)
    before = state.chunk(state.at - 2)
    turned = before is not None and before.kind == "verb" and before.value.lemma in _TURNED
    if turned and place.type in ("inside", "through", "on") and state.noun_next():
        state.at += 1  # "transformed into a studio"
        return
    if place.type == "centered_on" and not (state.subject or state.head or state.out.mentions) and state.noun_next():
        state.frames.append(Frame("list", type="centered", words=chunk.text))  # "a bedroom centered on a bed"
        state.glue, state.lost = "open", False
        return
    if chunk.mutual:
        relate_mutually(state, place, chunk)
        return
    after = state.chunk(state.at)
    if chunk.text == "in" and after is not None and after.kind == "adjective" and state.head:
        return  # "a pair of chairs in green and violet"
    glue, state.glue = state.glue, ""
    subjects = _subjects_of(state, place, glue)
    fronts = chunk.bare and subjects is None and not state.target_next()
    if state.noun_next() and not (chunk.passive or fronts):
        lost = state.lost and not subjects
        state.waiting = Waiting(_mannered(state, place), subjects, chunk, state.subset, lost=lost)
        state.subset = None
        state.glue = "object"
        return
    relate_to_nearest(state, _mannered(state, place), subjects, chunk)
    state.subset = None


def _subjects_of(state: State, place: Place, glue: str) -> list[Mention] | None:
    """Who a word of place is about; None: who comes after it."""
    if glue in ("start", "while") or (glue in ("comma", "and", "comma and") and state.fronts(state.at - 1)):
        state.lost = state.lost and glue == ""
        state.frames = (
            [f for f in state.frames[:1] if f.kind == "list"] if glue != "and" or state.done else state.frames
        )
        if state.subject and glue != "start":
            state.previous = list(state.subject)
            state.refs.topics.append(list(state.subject))
            state.subject, state.subject_open, state.done = [], True, False
        return None
    if glue == "verb":
        return list(state.subject)
    if glue in ("comma", "comma and") and not state.frames and state.subject:
        return list(state.subject) if state.done else list(state.head)
    if glue == "and" and state.last_subjects:
        return list(state.last_subjects)
    if glue == "open" and state.frames and not state.frames[-1].items:
        return None
    if not state.head:
        return list(state.subject) if state.subject else ([] if state.lost else None)
    head = list(state.head)
    frame = state.frames[-1] if state.frames else None
    if (
        frame is not None
        and frame.kind == "verb"
        and frame.type in ("on", "inside")
        and place.type in ("opposite", "along")
    ):
        return list(frame.owner)  # "a console supports a TV across from the sofa"
    if state.joined != "and":
        return head
    if state.subject_open and not state.frames and len(state.subject) > 1 and state.head == state.subject[-1:]:
        head = meant_of_list(state, place, state.subject)
    elif state.frames and len(state.frames[-1].items) > 1 and state.head == state.frames[-1].items[-1:]:
        head = meant_of_list(state, place, state.frames[-1].items)
    return head


def _nowhere(state: State, chunk: Chunk) -> None:
    """Where something must not be cannot be said as a relation."""
    after = state.chunks[state.at] if state.at < len(state.chunks) else None
    if state.negated == "where" or state.negated == "first":
        said = chunk.text
        end = chunk.end
        if after is not None and after.kind == "noun" and after.value.what != "room":
            said, end = f"{chunk.text} {state.source.text[after.start : after.end]}", after.end
            state.at += 1
        elif after is not None and after.kind == "noun":
            state.negated = ""
            return
        state.leave_unread(f"not {said}", chunk.start, end)
        state.out.note(f"'not {said}' cannot be said as a relation and was left out")
        state.negated = ""
        return
    state.negated = (
        "" if not (after is not None and after.kind == "noun" and after.value.what == "room") else state.negated
    )
    if state.negated:
        state.negated = ""
        return
    _place(state, chunk)


def _mannered(state: State, place: Place) -> Place:
    """ "Leaning against", "hanging on", "centered under": what the verb adds to a word of place."""
    manner, state.manner = state.manner, ""
    if manner == "lean" and place.type in ("against", "on", "next_to", "near"):
        return Place("leaning_on" if place.type in ("against", "on") else place.type, words=f"leaning {place.words}")
    if manner == "center" and place.type in ("on", "inside", "centered_on"):
        return Place("centered_on", words=f"centered {place.words}")
    if manner == "drape" and place.type in ("above", "through"):
        return Place("on", words=f"draped {place.words}")
    if manner in ("hang", "mount") and place.type in ("above", "on", "inside", "against"):
        return Place(place.type, words=f"{'hanging' if manner == 'hang' else 'mounted'} {place.words}")
    return place


_CHUNKS: dict[str, Callable[[State, Chunk], None]] = {
    "adjective": _adjective,
    "and": _and,
    "bracket": _bracket,
    "comma": _comma,
    "noun": _noun,
    "only": only_chunk,
    "place": _place,
    "purpose": _purpose,
    "stop": _stop,
    "verb": verb_chunk,
    "while": _while,
    "with": with_chunk,
    "without": without_chunk,
    "word": _word,
}
"""What each kind of chunk does to the state."""

_PHRASES: dict[str, Callable[[State, NounPhrase, Chunk], None]] = {
    "abstract": abstract_phrase,
    "collective": abstract_phrase,
    "group": group_phrase,
    "number": number_phrase,
    "part": part_phrase,
    "people": people_phrase,
    "place": place_phrase,
    "pronoun": pronoun_phrase,
    "region": region_phrase,
    "room": room_phrase,
    "thing": thing_phrase,
}
"""What each kind of noun phrase does to the state."""


def _furniture(mention: Mention, sides: tuple[float, ...]) -> bool:
    """Whether sides [m] may be those of a thing."""
    size = category_named(mention.category).size
    return size is not None and max(sides[:2]) <= 2 * max(size.depth[1], size.width[1])
