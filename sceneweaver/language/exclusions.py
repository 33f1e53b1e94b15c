"""What must not be there, and that nothing else is to be."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular

from .chunks import Chunk, NounPhrase
from .items import begin_clause
from .model import ANYTHING
from .nothings import may_name
from .parsed import Barred, Mention
from .region_phrases import thing_phrase
from .relating import support_kind
from .state import Frame, State
from .thing_phrases import new_thing
from .things import match_of, name_of
from .unwanted import is_class, kinds_unwanted
from .vocabulary import category_of, group_rows, vocabulary, words

FEW = 12
"""Kinds of a known thing that are ruled out with it."""

_NO = re.compile(r"\b(?:no|not|without|zero|neither|nor|sans)\b(?:\s(?:an?|any|the|real|proper))*\s*$")
"""What rules out the noun that comes next."""


def without_chunk(state: State, chunk: Chunk) -> None:
    """ "No", "without", "nothing": what follows must not be there."""
    state.waiting = None
    if state.nowhere is not None and chunk.value in words("unwanted")["except"]:
        but_for(state)
        return
    if state.denied is not None and chunk.value in words("unwanted")["except"] and _somewhere_next(state):
        _but_there(state)
        return
    if state.negated and chunk.value in words("unwanted")["except"]:
        state.negated, state.glue = "", "start"  # "no appliances except a stove"
        return
    if _rules_out_no_thing(state, chunk):
        state.negated, state.glue = "", "start"
        return
    if chunk.value != "nothing":
        state.negated, state.negation, state.glue = "first", str(chunk.value), "neg"
        return
    after = state.chunk(state.at)
    if after is not None and after.text.split()[0] in ("else", "more"):
        state.out.only = True
    elif after is not None and after.text == "with":  # "nothing with tassels" rules them out
        state.at += 1
        state.negated, state.negation, state.glue = "first", "nothing with", "neg"
    elif _somewhere_next(state):
        nothing_there(state)


def _somewhere_next(state: State) -> bool:
    """Whether the next words are those of a place with what it is of: "nothing on the bench"."""
    place, target = state.chunk(state.at), state.chunk(state.at + 1)
    if place is None or place.kind != "place" or target is None or target.kind != "noun":
        return False
    of_room = target.value.what == "place" and target.value.value in ("room", "floor", "wall", "ceiling")
    if target.value.what == "pronoun" and target.value.value == "pron" and not target.value.determiner:
        last = next((c.value for c in reversed(state.chunks[: state.at]) if c.kind == "noun"), None)
        of_room = last is not None and last.what == "place" and last.value not in ("window", "door")
        # "white walls with nothing on them"
    if place.value.type == "between" and any(
        c.kind == "noun" and c.value.what == "place" for c in state.chunks[state.at + 1 : state.at + 4]
    ):
        return False
    return not place.passive and not of_room and target.value.what in ("thing", "pronoun", "place")


def nothing_there(state: State) -> None:
    """Nothing is to be where the next words of place say, but for what is told of it."""
    state.close_frames()
    state.fronted = []
    state.unwanted = [Mention("nothing", "", words=[ANYTHING])]
    state.negated, state.negation, state.glue = "where", "nothing", ""


def _but_there(state: State) -> None:
    """ "No rugs except in front of the sofa": what was ruled out is wanted there."""
    phrase, state.denied = state.denied, None
    assert phrase is not None
    said = state.out.without[-1][0]
    thing = new_thing(state, replace(phrase, determiner="" if phrase.plural else "a"))
    if thing is None:
        return
    state.out.others.add(said)
    state.negated, state.glue = "", "start"
    begin_clause(state, [thing], "start")
    state.glue = "verb"


def but_for(state: State) -> None:
    """ "Nothing on it except a bell": what comes next is there."""
    assert state.nowhere is not None
    state.fronted, state.nowhere = [state.nowhere], None
    state.subject, state.glue, state.negated = [], "start", ""


def _rules_out_no_thing(state: State, chunk: Chunk) -> bool:
    """Whether what is denied is something that happens, "without bumping into each other", or a case, "if not"."""
    before, after = state.source.text[: chunk.start].split()[-1:], state.source.text[chunk.end :].split()[:1]
    if str(chunk.value).startswith("not"):
        return before in (["if"], ["or"])
    word = after[0].strip(",.;:") if after else ""
    return chunk.value == "without" and word.endswith("ing") and word not in words("unwanted")["things_in_ing"]


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
    placed = after is not None and after.kind == "place" and phrase.what == "thing"
    if phrase.definite and placed:
        state.negated = "where"  # "don't put the bed near the door" wants a bed
        state.glue = "start"
        thing_phrase(state, phrase, chunk)
        return True
    if phrase.what == "place" and _somewhere_next(state):
        _no_opening_there(state, phrase)
        return True
    at = state.at if placed else _place_of_list(state, phrase)
    if at is not None and _is_elsewhere(state, phrase, at):
        return True
    before = len(state.out.without)
    _leave_out(state, phrase)
    state.denied = phrase if phrase.what == "thing" and len(state.out.without) > before else None
    if state.negation.endswith("other"):
        state.out.others |= {said for said, _, _ in state.out.without[before:]}
    if state.negated == "first":
        state.negated = "article" if phrase.determiner in ("a", "an") else "list"
    state.glue = ""
    return True


def _no_opening_there(state: State, phrase: NounPhrase) -> None:
    """ "No windows near the beds" is not "no windows": it is told, and what else the list names is ruled out there."""
    place, target = state.chunk(state.at), state.chunk(state.at + 1)
    assert place is not None and target is not None
    state.leave_unread(state.source.text[phrase.start : target.end], phrase.start, target.end)
    if state.unwanted:
        state.negated, state.glue = "where", ""
    else:
        state.at, state.negated, state.glue = state.at + 2, "", ""


def _place_of_list(state: State, phrase: NounPhrase) -> int | None:
    """Where the word of place is that is said of a whole list: "no shelves, plants or pictures near the beds"."""
    if phrase.what != "thing":
        return None
    linked = False
    for k in range(state.at, len(state.chunks) - 1):
        chunk = state.chunks[k]
        if chunk.kind == "place":
            return k if linked and state.chunks[k - 1].kind == "noun" else None
        if chunk.kind == "and":
            linked = True
        elif chunk.kind == "noun":
            if chunk.value.determiner or chunk.value.count is not None:
                return None
        elif chunk.kind != "comma":
            return None
    return None


def _is_elsewhere(state: State, phrase: NounPhrase, at: int) -> bool:
    """Whether something is unwanted in one place alone, said at chunk ``at``: "no shelf above the bed"."""
    place, target = state.chunk(at), state.chunk(at + 1)
    assert place is not None
    if at != state.at and (target is None or target.kind != "noun"):
        return False
    if target is None or target.kind != "noun":
        if not place.value.each and "one" in place.text.split():  # "no chair on one side"
            state.leave_unread(state.source.text[phrase.start : place.end], phrase.start, place.end)
            state.at, state.negated, state.glue = state.at + 1, "", ""
            return True
        return False
    whole = target.value.what in ("room", "abstract") or target.value.value in ("room", "floor", "wall", "ceiling")
    names = () if whole else excluded_names(phrase)
    if not names:
        return False
    unwanted = Mention(name_of(phrase), category_of(names[0]), words=list(names))
    state.unwanted, state.negated, state.glue = [*state.unwanted, unwanted], "where" if at == state.at else "list", ""
    return True


def _leave_out(state: State, phrase: NounPhrase) -> None:
    """The categories, or groups of them, that a noun phrase rules out."""
    span = state.span_of(phrase)
    if phrase.what in ("group", "abstract", "collective", "matter") and is_class(phrase.text):
        state.out.without.append((phrase.text, kinds_unwanted(phrase.text), span))
    elif phrase.what == "place":
        listed = phrase.value == "door" and not _NO.search(state.source.text, 0, phrase.start)
        if listed or (phrase.determiner == "the" and "not" in state.negation):
            # "no mirrors, doors painted red": a room without a door is one of which just this is said; "a shelf behind
            # me, not the door" is about a door that is there
            state.leave_unread(state.source.text[phrase.start : phrase.end], phrase.start, phrase.end)
        elif not any(one.part == phrase.value for one in state.out.stated_openings):
            state.out.openings[str(phrase.value)] = 0
    elif phrase.what == "group":
        things = group_rows()[phrase.value]["things"]
        state.out.without += [(phrase.text, (category_of(name),), span) for name in things]
    elif phrase.what in ("thing", "part") and (names := excluded_names(phrase)):
        state.out.without.append((phrase.text, names, span))
        return
    elif phrase.what in ("thing", "part", "matter", "people", "collective"):
        spoken = state.source.text[phrase.start : phrase.end]
        state.leave_unread(f"{state.negation} {spoken}", phrase.start, phrase.end)
        if phrase.what == "thing" and _may_be_ruled_out(state, phrase):
            noun = name_of(phrase)
            category = match_of(noun).category
            name = noun.replace(" ", "_") if category == "object" else category
            state.out.without.append((noun, (name,), span))


def _may_be_ruled_out(state: State, phrase: NounPhrase) -> bool:
    """Whether an unknown noun is ruled out by its own name; "not sad" rules out nothing."""
    plain = state.negation in ("not", "but not", "isn't", "aren't", "never") and not phrase.determiner
    return phrase.value is None and not plain and not _qualified(phrase) and may_name(phrase.text)


def _qualified(phrase: NounPhrase) -> bool:
    """Whether only some of a kind are meant: "no red chairs"."""
    return any(
        t.has("material") or (t.has("color", "scale", "styles", "finish") and not t.has("noun"))
        for t in phrase.qualities
    )


def excluded_names(phrase: NounPhrase) -> tuple[str, ...]:
    """The categories, or groups of them, that "no" with such a noun phrase rules out; none where it is not known.

    A plain noun rules out all that bears its name: "no cabinets" the kitchen's and those on the wall as well.
    """
    noun = name_of(phrase)
    if _qualified(phrase):
        return ()
    for name in (noun, phrase.text):
        if is_class(name):
            names, usual = kinds_unwanted(name), match_of(noun).category
            return names if singular(phrase.text) != phrase.text or usual in names else (usual, *names)
    match, known = match_of(noun), categories().get(str(phrase.value))
    if match.how == "generic" and phrase.value is None:
        return kinds_unwanted(noun)
    if known is not None and known.size is None:
        return (str(phrase.value),)
    below = kinds_unwanted(noun)
    return tuple(dict.fromkeys((match.category, *_namesakes(singular(noun), match.category), *below[:FEW])))


def names_of(noun: str) -> tuple[str, ...]:
    """As `excluded_names` for a noun by itself."""
    return excluded_names(NounPhrase("thing", noun, value=vocabulary().get(noun, {}).get("noun")))


@cache
def _namesakes(noun: str, category: str) -> tuple[str, ...]:
    """Other categories that are called by a noun of one word, or by the name of its category, with words before it."""
    heads = {name for name in (noun, category) if " " not in name and "_" not in name}
    found = (name for name, row in categories().items() if row.size is not None and name.rpartition("_")[2] in heads)
    return tuple(name for name in found if name != category and not name.startswith("generic_") and "_" in name)


def only_chunk(state: State, chunk: Chunk) -> None:
    """ "Only a bed", "nothing else": nothing but what is named, unless other things were named before."""
    if chunk.value == "all" and _somewhere_next(state):
        nothing_there(state)  # "a bell, nothing else on the counter"
        return
    if chunk.text == "nothing but":
        _nothing_but(state, chunk)
        return
    ahead = state.chunk(state.at)
    if ahead is not None and ahead.kind == "verb":  # "it should only have a bed"
        ahead = state.chunk(state.at + 1)
    # "Only two chairs" is how many chairs there are, not all that there is; "the only chair" is one of a kind.
    named = (
        ahead is not None
        and ahead.kind == "noun"
        and ahead.value.what in ("thing", "group")
        and not ahead.value.definite
        and not _is_counted(ahead.value)
        and not state.out.mentions
    )
    state.out.only = state.out.only or chunk.value == "all" or named


def _nothing_but(state: State, chunk: Chunk) -> None:
    """ "A shelf that holds nothing but books": what it holds is all that is there; else that is all of the room."""
    frame = state.frames[-1] if state.frames else None
    if state.glue in ("verb", "") and len(state.subject) == 1 and (frame is None or not frame.owner):
        frame = Frame("with", list(state.subject), words="with")  # "the bench is bare but for a lamp"
        state.frames.append(frame)
        state.glue = "open"
    if frame is None or not frame.owner:
        state.out.only = True
        return
    kind = support_kind(frame.type if frame.type in ("on", "inside") else "on", frame.owner[-1])
    bar_anything(state, kind, frame.owner[-1], chunk)


def bar_anything(state: State, kind: str, target: Mention, chunk: Chunk) -> None:
    """Nothing is to be in or on a thing but what the request names there."""
    spoken = f"nothing but what is named {'in' if kind == 'inside' else 'on'} the {target.noun}"
    nothing = Mention("nothing", "", words=[ANYTHING])
    barred = Barred(kind, [nothing], (target,), spoken, span=state.span_of(chunk), categories=(ANYTHING,))
    state.out.barred.append(barred)


def _is_counted(phrase: NounPhrase) -> bool:
    """Whether a noun phrase has a number of its own, or is no thing that is known: "they only talk"."""
    if phrase.determiner in ("a", "an", "the"):
        return False
    return phrase.count is not None or phrase.value is None
