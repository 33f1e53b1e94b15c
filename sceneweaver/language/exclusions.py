"""What must not be there, and that nothing else is to be."""

from __future__ import annotations

from sceneweaver.assets import categories

from .chunks import Chunk, NounPhrase
from .region_phrases import thing_phrase
from .state import State
from .things import match_of, name_of
from .vocabulary import category_of, words


def without_chunk(state: State, chunk: Chunk) -> None:
    if state.waiting is not None:
        state.waiting = None
    if chunk.value == "nothing":
        _nothing(state)
        return
    state.negated = "first"
    state.glue = "neg"


def _nothing(state: State) -> None:
    rules = words("groups")["nothing_on"]
    for k, chunk in enumerate(state.chunks[state.at : state.at + 4]):
        if chunk.kind == "noun" and chunk.value.what == "place" and str(chunk.value.value).split(":")[0] in rules:
            named = rules[str(chunk.value.value).split(":")[0]]
            state.out.without += [(name, (name,), state.source.span(chunk.start, chunk.end)) for name in named]
            state.at += k + 1
            return
    if state.at < len(state.chunks) and state.chunks[state.at].text.split()[0] in ("else", "more"):
        state.out.only = True


def excluded(state: State, phrase: NounPhrase, chunk: Chunk) -> bool:
    """Whether a noun phrase is one of what must not be there."""
    glue = state.glue
    if (
        state.negated != "first"
        and glue != "or"
        and (phrase.count is not None or phrase.determiner in ("a", "an", "the", "another"))
        and not (state.negated == "article" and phrase.determiner in ("a", "an") and phrase.count is None)
    ):
        state.negated = ""
        return False
    if phrase.what in ("room",) or (phrase.what == "place" and phrase.value not in ("window", "door")):
        state.negated = ""
        return False
    after = state.chunks[state.at] if state.at < len(state.chunks) else None
    if phrase.definite and after is not None and after.kind == "place" and phrase.what == "thing":
        state.negated = "where"  # "don't put the bed near the door" wants a bed
        state.glue = "start"
        thing_phrase(state, phrase, chunk)
        return True
    span = state.source.span(phrase.start, phrase.end)
    if phrase.what == "place":
        state.out.openings[str(phrase.value)] = 0
    elif phrase.what == "group":
        for name in words("groups")["groups"][phrase.value]["things"]:
            state.out.without.append((phrase.text, (category_of(name),), span))
    elif phrase.what in ("thing",):
        noun = name_of(phrase)
        listed = words("groups")["without"].get(phrase.text)
        known = categories().get(str(phrase.value))
        match = match_of(noun)
        names = (
            tuple(listed)
            if listed
            else ((phrase.value,) if known is not None and known.size is None else (match.category,))
        )
        if match.how == "generic" and not listed and phrase.value is None:
            state.leave_unread(f"no {noun}", phrase.start, phrase.end)
            state.out.without.append(
                (noun, (match.category if match.category != "object" else noun.replace(" ", "_"),), span)
            )
        else:
            state.out.without.append((phrase.text, names, span))
    if state.negated == "first":
        state.negated = "article" if phrase.determiner in ("a", "an") else "list"
    state.glue = ""
    return True


def only_chunk(state: State, chunk: Chunk) -> None:
    if chunk.value == "all":
        state.out.only = True
        return
    ahead = state.chunks[state.at : state.at + 2]
    state.out.only = state.out.only or any(c.kind == "noun" and c.value.what in ("thing", "group") for c in ahead)
