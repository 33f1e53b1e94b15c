"""What must not be there, and that nothing else is to be."""

from __future__ import annotations

from sceneweaver.assets import categories

from .chunks import Chunk, NounPhrase
from .region_phrases import thing_phrase
from .state import State
from .things import match_of, name_of
from .vocabulary import category_of, words


def without_chunk(state: State, chunk: Chunk) -> None:
    """ "No", "without", "nothing": what follows must not be there."""
    state.waiting = None
    if chunk.value != "nothing":
        state.negated, state.glue = "first", "neg"
        return
    rules = words("groups")["nothing_on"]  # "nothing on the walls"
    for k, ahead in enumerate(state.chunks[state.at : state.at + 4]):
        place = str(ahead.value.value).split(":")[0] if ahead.kind == "noun" and ahead.value.what == "place" else ""
        if place in rules:
            state.out.without += [(name, (name,), state.span_of(ahead)) for name in rules[place]]
            state.at += k + 1
            return
    if state.at < len(state.chunks) and state.chunks[state.at].text.split()[0] in ("else", "more"):
        state.out.only = True


def excluded(state: State, phrase: NounPhrase, chunk: Chunk) -> bool:
    """Whether a noun phrase is one of what must not be there; "a TV, and a desk" after "no" ends the list."""
    named = phrase.count is not None or phrase.determiner in ("a", "an", "the", "another")
    alike = state.negated == "article" and phrase.determiner in ("a", "an") and phrase.count is None
    ends = state.negated != "first" and state.glue != "or" and named and not alike
    of_room = phrase.what == "room" or (phrase.what == "place" and phrase.value not in ("window", "door"))
    if ends or of_room:
        state.negated = ""
        return False
    after = state.chunk(state.at)
    if phrase.definite and after is not None and after.kind == "place" and phrase.what == "thing":
        state.negated = "where"  # "don't put the bed near the door" wants a bed
        state.glue = "start"
        thing_phrase(state, phrase, chunk)
        return True
    _leave_out(state, phrase)
    if state.negated == "first":
        state.negated = "article" if phrase.determiner in ("a", "an") else "list"
    state.glue = ""
    return True


def _leave_out(state: State, phrase: NounPhrase) -> None:
    """The categories, or groups of them, that a noun phrase rules out."""
    span, groups = state.span_of(phrase), words("groups")
    if phrase.what == "place":
        state.out.openings[str(phrase.value)] = 0
    elif phrase.what == "group":
        things = groups["groups"][phrase.value]["things"]
        state.out.without += [(phrase.text, (category_of(name),), span) for name in things]
    elif phrase.what == "thing":
        noun = name_of(phrase)
        match, known = match_of(noun), categories().get(str(phrase.value))
        listed = groups["without"].get(phrase.text)
        if listed:
            names = tuple(listed)
        elif match.how == "generic" and phrase.value is None:
            state.leave_unread(f"no {noun}", phrase.start, phrase.end)
            category = match.category if match.category != "object" else noun.replace(" ", "_")
            state.out.without.append((noun, (category,), span))
            return
        else:
            names = (phrase.value,) if known is not None and known.size is None else (match.category,)
        state.out.without.append((phrase.text, names, span))


def only_chunk(state: State, chunk: Chunk) -> None:
    """ "Only a bed", "nothing else": nothing but what is named."""
    ahead = state.chunk(state.at)
    if ahead is not None and ahead.kind == "verb":  # "it should only have a bed"
        ahead = state.chunk(state.at + 1)
    # "Only two chairs" is how many chairs there are, not all that there is.
    named = (
        ahead is not None
        and ahead.kind == "noun"
        and ahead.value.what in ("thing", "group")
        and not _is_counted(ahead.value)
    )
    state.out.only = state.out.only or chunk.value == "all" or named


def _is_counted(phrase: NounPhrase) -> bool:
    """Whether a noun phrase has a number of its own, or is no thing that is known: "they only talk"."""
    if phrase.determiner in ("a", "an", "the"):
        return False
    return phrase.count is not None or phrase.value is None
