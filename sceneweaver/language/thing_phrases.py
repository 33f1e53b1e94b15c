"""Phrases about things and their parts."""

from __future__ import annotations

from .chunks import Chunk, NounPhrase
from .items import name_nothing, name_things
from .parsed import Mention
from .room_phrases import abstract_phrase, describe_room, names_a_room, people_phrase, unknown_room
from .state import State
from .things import describe, match_of, name_of, new_mention, note_on, singular

MOST_NEW = 400
"""Mentions that are made at most."""


_FLOORS = ("basement", "attic", "loft", "cellar", "rooftop", "upstairs", "downstairs")
"""Words before the name of a room."""

_BUILT_IN = ("integrated", "built in", "integral", "inset")
"""Words for what is part of the thing that it comes with."""

_IN_FRAMES = ("print", "photo", "photograph", "picture", "image", "portrait")
"""What a frame shows."""


def named_thing(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    if phrase.text in ("furniture", "object"):
        describe_room(state, phrase)
        state.glue = ""
        return
    waiting = state.waiting
    target = waiting is not None and state.glue != "start"
    if waiting is None and phrase.determiner in ("each", "every"):  # "each bowl next to a spoon"
        group = state.refs.known(phrase, True, [])
        if group is not None and group.many:
            name_things(state, [group], phrase, chunk, False)
            state.each = True
            return
    if (
        waiting is not None
        and waiting.subjects
        and len(waiting.subjects) > 1
        and (phrase.definite or phrase.determiner == "each")
    ):
        one = state.refs.known(phrase, True, [])  # "ten tables and four chairs around each table"
        waiting.subjects = [s for s in waiting.subjects if s is not one]
    without = (waiting.subjects or []) if waiting is not None else []
    if (
        phrase.value in ("rest", "the other", "the others")
        and state.refs.rest is not None
        and singular_is(state.refs.rest, phrase)
    ):
        found: Mention | None = state.refs.rest
    else:
        found = state.refs.known(phrase, target, without)
        if found is None and phrase.count == (1, 1) and phrase.determiner == "one" and not target:
            several = state.refs.known(phrase, True, without)
            if several is not None and several.many:
                found = state.refs.part([several])
    new = found is None
    of_room = any((t.has("room") and not t.has("noun")) or t.text in _FLOORS for t in phrase.qualities)
    if new and of_room and phrase.value is None and state.glue == "start" and not state.out.mentions:
        abstract_phrase(state, phrase, chunk)  # "a basement cinema"
        state.lost = False
        return
    if new and _of_the_room(state, phrase):
        return
    mention = found if found is not None else new_thing(state, phrase)
    if mention is None:
        _drop_noun(state)
        return
    if not new:
        _again(state, mention, phrase)
    name_things(state, [mention], phrase, chunk, new)


def _of_the_room(state: State, phrase: NounPhrase) -> bool:
    """Whether an unknown noun at the very start is the room or who it is for: "a mountain hut for two hikers: "."""
    if state.out.mentions or state.waiting is not None or match_of(name_of(phrase)).how != "generic":
        return False
    before, after = state.chunk(state.at - 2), state.chunk(state.at)
    if before is not None and before.kind == "purpose" and before.value == "people" and phrase.count is not None:
        people_phrase(state, phrase, before)
        return True
    room = state.out.room_type is not None or bool(state.out.room_words) or names_a_room(state)
    if room or phrase.definite or phrase.plural or phrase.count not in (None, (1, 1)) or after is None:
        return False
    if not (after.start in state.source.colons or (after.kind == "purpose" and after.value == "people")):
        return False
    unknown_room(state, phrase)
    describe_room(state, phrase)
    state.lost = False
    return True


def is_part(state: State, phrase: NounPhrase) -> bool:
    """Whether what a thing is told to come with is a part of it: an integrated basin, the photo in a frame."""
    owner = state.frames[-1].owner[-1:] if state.frames and state.frames[-1].kind == "with" else []
    if not owner or state.waiting is not None or phrase.definite:
        return False
    built_in = any(t.text in _BUILT_IN for t in phrase.qualities)
    framed = singular(owner[0].noun).endswith("frame") and singular(phrase.text) in _IN_FRAMES
    return built_in or framed


def new_thing(state: State, phrase: NounPhrase) -> Mention | None:
    implied = _called_for(state, phrase)
    if implied is not None:
        return implied
    if len(state.out.mentions) >= MOST_NEW:
        state.leave_unread(phrase.text, phrase.start, phrase.end)
        return None
    mention = new_mention(phrase, state.source)
    if mention.generic and not _is_concrete(state, phrase):
        state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
        return None
    if any(t.text == "matching" for t in phrase.qualities) and (state.head or state.previous or state.subject):
        like = (state.head or state.previous or state.subject)[-1]
        mention.color, mention.material = mention.color or like.color, mention.material or like.material
        mention.style = mention.style or like.style
        mention.attributes += [
            a for a in like.attributes if a.kind in ("color", "material", "style", "other", "finish")
        ]
    note_on(mention, state.out)
    state.out.mentions.append(mention)
    return mention


def _is_concrete(state: State, phrase: NounPhrase) -> bool:
    """Whether a noun that is not known stands where a thing is named: in a list, or as what is placed."""
    if phrase.definite or not any(c.isalpha() for c in phrase.text):
        return False
    if phrase.determiner or phrase.count is not None:
        return True
    return bool(state.frames or state.waiting) and state.glue != "start" and bool(state.out.mentions)


def _called_for(state: State, phrase: NounPhrase) -> Mention | None:
    """What a "dining area" called for, when the request now says what it is to be."""
    if phrase.definite:
        return None
    noun = name_of(phrase)
    head = singular(noun).split()[-1]
    for mention in (m for m in reversed(state.out.mentions[-12:]) if m.implied):
        match = match_of(noun)
        if mention.category == match.category or singular(mention.noun).split()[-1] == head:
            if singular(noun) != head:
                mention.noun, mention.category, mention.generic = noun, match.category, match.how == "generic"
            if phrase.count is not None or phrase.determiner:
                mention.count = phrase.count or (1, 1)
            mention.implied = False
            mention.span = state.source.span(phrase.start, phrase.end)
            describe(mention, phrase, state.source)
            return mention
    return None


def _again(state: State, mention: Mention, phrase: NounPhrase) -> None:
    """More is said of what was named before."""
    if mention.count is None and phrase.count is not None:
        mention.count = phrase.count
    if mention.implied:
        mention.implied = False
    known = {a.words for a in mention.attributes}
    phrase.qualities = [t for t in phrase.qualities if t.text not in known]
    describe(mention, phrase, state.source)


def _drop_noun(state: State) -> None:
    if state.waiting is not None:
        state.leave_unread(state.waiting.chunk.text, state.waiting.chunk.start, state.waiting.chunk.end)
        state.waiting = None
        return
    name_nothing(state)


def singular_is(mention: Mention, phrase: NounPhrase) -> bool:
    """Whether a phrase names a mention by its last word."""
    return mention.noun.rstrip("s").endswith(phrase.text.rstrip("s"))
