"""Chunks into mentions and statements: who is placed where, clause by clause."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sceneweaver.assets.taxonomy import category_named

from .chunks import Chunk, NounPhrase
from .distribution import each_next, every_so_many, group_used_by_people, listed_before, stands_for_each
from .exclusions import bar_anything, but_for, excluded, only_chunk, without_chunk
from .in_room import is_called_in
from .items import begin_clause, close_surface, give_target, name_nothing, name_things, open_surface
from .nearness import meant_of_list, nearest
from .nothings import may_name
from .parsed import Mention, Parsed
from .pronouns import is_one_of_quality, number_phrase, pronoun_phrase
from .region_phrases import part_phrase, region_phrase, thing_phrase
from .relating import relate_mutually, relate_to_nearest
from .room_phrases import (
    abstract_phrase,
    group_phrase,
    matter_phrase,
    people_phrase,
    place_phrase,
    room_phrase,
    room_quality,
)
from .senses import sense_of
from .shares import share_total
from .source import Source
from .state import Frame, State, Waiting
from .stations import names_stations, new_stations, station_group
from .things import describe, give_length, give_sides, singular
from .tokens import Token
from .verbs import open_ends, verb_chunk, with_chunk
from .vocabulary import Place, vocabulary, words

_TURNED = ("transform", "convert", "turn", "set up")
"""Verbs whose "into a studio" is no place."""

_LOOKING = ("face", "turn", "look", "point")
"""Verbs whose "away from" is no distance."""

SEATED = 4
"""Chairs from which on those around a table are taken for dining chairs."""


def read_clauses(chunks: list[Chunk], source: Source, parsed: Parsed) -> None:
    """Puts what chunks say into ``parsed``, from left to right."""
    state = State(chunks, source, parsed)
    if parsed.arrangements:
        _name_formations(chunks, source, parsed)
    while state.at < len(chunks):
        chunk = chunks[state.at]
        state.at += 1
        if chunk.kind not in ("while", "verb", "word"):
            state.relative = False
        _CHUNKS[chunk.kind](state, chunk)
    total, begun = state.total, state.begun
    _end_sentence(state)
    if total is not None:
        share_total(state, total, begun)
    _seat_diners(parsed)


def _name_formations(chunks: list[Chunk], source: Source, parsed: Parsed) -> None:
    """ "Near the row": the things that stand in one are meant."""
    for chunk in chunks:
        phrase = chunk.value
        if chunk.kind != "noun" or phrase.of is not None or not phrase.definite or phrase.qualities:
            continue
        if phrase.what in ("abstract", "collective", "matter") and phrase.text in words("nouns")["formations"]:
            parsed.referred.append(source.span(phrase.start, phrase.end))
            phrase.what, phrase.text, phrase.value = "pronoun", "them", "pron"


def _seat_diners(parsed: Parsed) -> None:
    """Chairs around a table to eat at are dining chairs, upholstered or not."""
    easy = frozenset(words("nouns")["easy"])
    for said in parsed.said:
        target = said.targets[0]
        if said.type not in ("around", "along", "at", "flanking") or not isinstance(target, Mention):
            continue
        for one in said.subjects if "dining" in target.category else ():
            many = one.count is not None and one.count[0] >= SEATED
            plain = singular(one.noun).split()[-1] == "chair" and not easy.intersection(one.noun.split())
            if many and plain and one.category == "armchair":
                one.category = "dining_chair"


def _end_sentence(state: State) -> None:
    """What is open ends; who the sentence was about is what "it" may mean in the next."""
    open_ends(state)
    close_surface(state)
    inverted = state.frames[0].fronted_on if state.inverted and state.frames else []
    topic = inverted or state.subject or state.first_items[:1]
    if not topic and state.lost:
        topic = state.out.mentions[state.begun :][:1]
    state.begun = len(state.out.mentions)
    if topic and topic not in state.refs.topics[-1:]:
        state.refs.tell_of(topic)
    state.begin()


def _stop(state: State, chunk: Chunk) -> None:
    total, begun = state.total, state.begun
    _end_sentence(state)
    if total is not None and not share_total(state, total, begun) and chunk.start in state.source.colons:
        state.total = total


def _purpose(state: State, chunk: Chunk) -> None:
    open_ends(state)
    if state.glue == "verb":
        state.glue = ""


def _adjective(state: State, chunk: Chunk) -> None:
    """Words of quality alone: of what "is" so, of what stands before them, or of the room."""
    phrase: NounPhrase = chunk.value
    if is_one_of_quality(chunk, state.chunk(state.at)):
        return  # "the larger one": the pronoun after it says which
    others = phrase.value in words("said_again")["others"] and state.waiting is None
    if others and any(t.text in words("said_again")["bare"] for t in phrase.qualities):
        rest = state.refs.rest or state.refs.several(state.head or state.subject)
        if rest is not None:  # "a cushion on one of them, the rest bare"
            bar_anything(state, "on", rest, chunk)
            return
    bare = any(t.text == "bare" for t in phrase.qualities) and len(state.predicate) == 1
    if bare and state.predicate[0].family in ("table", "storage", "seat"):
        bar_anything(state, "on", state.predicate[0], chunk)
        return
    if (some := _some_so(state, phrase)) is not None:
        describe(some, replace(phrase, count=None, determiner="", value=None), state.source)
        state.out.referred.append(state.span_of(chunk))
        state.head, state.glue = [some], ""
        return
    if state.glue == "open" and state.frames and state.frames[-1].owner and not state.frames[-1].items:
        state.head, state.glue = state.frames.pop().owner, ""  # "covered in red felt"
    within = state.bracketed is not None and state.glue in ("bracket", "comma")  # "a table (round, 80 cm wide)"
    who = state.predicate or (state.head if (state.glue == "" or within) and not state.waiting else [])
    who = who or _said_at_last(state, phrase)
    last = (state.head or state.subject)[-1:]
    if phrase.sides is not None:
        if last and not state.waiting and _may_have(last[0], phrase.sides):
            give_sides(last[0], phrase.sides)
        else:
            state.leave_sides(phrase)
        phrase.sides = None
    if last:
        give_length(last[0], phrase)
    before = state.source.text[: chunk.start].rstrip()
    stuff = bool(phrase.qualities) and all(t.has("color") and not t.has("material") for t in phrase.qualities)
    if who and stuff and before.endswith(" of"):
        state.leave_unread(chunk.text, chunk.start, chunk.end)
        return  # a crate of sand holds it, and has no colour of it
    for mention in who:
        plain = NounPhrase("thing", "", phrase.start, phrase.end, qualities=phrase.qualities)
        describe(mention, plain, state.source)
    if not who:
        for token in phrase.qualities:
            room_quality(state, token, room=not state.out.mentions or state.after_be)


def _some_so(state: State, phrase: NounPhrase) -> Mention | None:
    """ "Five stools, two white, the others black": of which of those that were named words of quality are said."""
    of_things = any(t.has("color", "material", "shape", "finish", "scale", "adjective") for t in phrase.qualities)
    if not of_things or phrase.sides is not None or state.waiting is not None:
        return None
    if phrase.value in words("said_again")["others"]:
        return state.refs.rest
    if phrase.determiner not in ("", "one"):
        return None
    if phrase.count is None or phrase.count[0] != phrase.count[1] or state.glue == "open":
        return None
    if _goes_on_to_noun(state):
        return None  # "one red, one yellow and one blue thing"
    near = state.head or state.subject or state.previous
    group = state.refs.several(near)
    part = state.refs.part(near, phrase.count[0])
    return part if part is not None and part is not group else None


def _goes_on_to_noun(state: State) -> bool:
    """Whether a list of words of quality ends with the noun that all of them are about."""
    for chunk in state.chunks[state.at : state.at + 8]:
        if chunk.kind == "noun":
            first = vocabulary().get(chunk.value.text.split()[0], {}) if chunk.value.text else {}
            return chunk.value.count is not None and (bool(chunk.value.qualities) or "color" in first)
        if chunk.kind not in ("comma", "and", "adjective"):
            return False
    return False


def _said_at_last(state: State, phrase: NounPhrase) -> list[Mention]:
    """ "A rug under the table, red and round": what the sentence is about, where no noun follows."""
    after = state.chunk(state.at)
    ends = after is None or after.kind in ("stop", "comma", "with", "aside", "word", "and")
    of_things = any(t.has("color", "material", "shape", "finish") for t in phrase.qualities)
    if not state.glue.startswith("comma") or not ends or not of_things or phrase.determiner:
        return []
    fresh = [m for m in state.out.mentions[state.begun :] if not m.implied]
    if not fresh:
        return []
    listed = state.frames[-1].items if state.frames else []
    about = listed or state.subject
    return about[-1:] if about and about[-1] in fresh else fresh[:1]


def _may_have(mention: Mention, sides: tuple[float, ...]) -> bool:
    """Whether sides [m] may be those of a thing."""
    size = category_named(mention.category).size
    return size is not None and max(sides[:2]) <= 2 * max(size.depth[1], size.width[1])


def _word(state: State, chunk: Chunk) -> None:
    token: Token = chunk.value
    after = state.chunk(state.at)
    number = after.value if after is not None and after.kind == "noun" and after.value.what == "number" else None
    if token.text in ("seats", "sleeps", "accommodates") and number is not None:
        state.out.people = (number.count or (1, 1))[1]
        state.at += 1
    elif not token.kinds and token.text.isalpha() and not token.text.endswith("ly"):
        state.leave_unread(token.text, chunk.start, chunk.end)


def _aside(state: State, chunk: Chunk) -> None:
    """What somebody does or may do: nothing is said of it, but of what stands beside it with a word of place."""
    before = state.chunk(state.at - 2)
    live = not set(words("people")["live"]).isdisjoint(chunk.text.split())
    if live and before is not None and before.kind == "noun" and before.value.what == "number":
        state.out.people = state.out.people or (before.value.count or (1, 1))[1]  # "two brothers share this room"
        state.out.unread = [left for left in state.out.unread if left.start != before.start]
        state.out.referred.append(state.source.span(before.start, chunk.end))
        open_ends(state)
        return
    state.leave_unread(state.source.text[chunk.start : chunk.end], chunk.start, chunk.end)
    open_ends(state)
    if chunk.text.startswith("who ") and _after_people(state):
        _tell_of_people(state)
        return
    if chunk.value != "clause":
        return
    state.fronted, state.negated = [], ""
    before = state.chunk(state.at - 2)
    if before is not None and before.kind == "while" and not state.subject and state.refs.topics:
        state.subject = state.head = list(state.refs.topics[-1])  # "a chair where we can read next to a lamp"
        state.glue, state.done, state.subject_open = "", True, False
    elif state.glue in ("comma", "and", "comma and"):
        state.glue = "while" if not state.frames else state.glue


def _bracket(state: State, chunk: Chunk) -> None:
    """What was opened in a bracket ends with it: "two desks (each with a lamp), a sofa"."""
    if chunk.text == "(":
        state.bracketed = len(state.frames)
    elif chunk.text == ")" and state.bracketed is not None:
        del state.frames[state.bracketed :]
        state.bracketed, state.each = None, None
    state.glue = "bracket"


def _comma(state: State, chunk: Chunk) -> None:
    if state.waiting is not None and state.waiting.first is None:
        open_ends(state)
    state.manner, state.each = "", None
    state.glue = "comma"
    state.predicate = []


def _and(state: State, chunk: Chunk) -> None:
    state.glue = "comma and" if state.glue == "comma" else "or" if chunk.text == "or" else "and"


def _while(state: State, chunk: Chunk) -> None:
    """A clause of its own begins, unless "that" goes on with what was just named."""
    if chunk.text == "but" and state.nowhere is not None and state.noun_next():
        but_for(state)  # "nothing on the desk but a lamp"
        return
    if chunk.text == "but" and state.subject and _leaves_some(state):
        return
    if chunk.text == "but":
        state.negated, state.glue = "", "comma"
        return
    last = (state.head or state.subject)[-1:]
    if chunk.text == "where" and last and last[0].mount == "floor":
        open_surface(state, last[0], chunk.text)
    before = state.chunk(state.at - 2)
    if chunk.text == "who" and before is not None and _after_people(state):
        _tell_of_people(state)
        return
    if chunk.text in ("that", "which", "whose", "who"):
        state.relative = bool(state.head)
        return
    if state.subject:
        state.refs.tell_of(state.subject)
    open_ends(state)
    state.close_frames()
    state.fronted, state.subject, state.subject_open = [], [], True
    state.glue, state.negated, state.manner = "while", "", ""


def _tell_of_people(state: State) -> None:
    """ "The clerk, who sits on a platform": what comes next is said of no thing."""
    state.each = None
    name_nothing(state)
    state.head, state.subject = [], []


def _leaves_some(state: State) -> bool:
    """ "All desks but one face the window": that some do not is told."""
    some, verb = state.chunk(state.at), state.chunk(state.at + 1)
    number = some is not None and some.kind == "noun" and (some.text == "one" or some.value.what == "number")
    if some is None or not number or verb is None or verb.kind not in ("verb", "place"):
        return False
    state.leave_unread(f"but {some.text}", some.start, some.end)
    state.at += 1
    return True


def _after_people(state: State) -> bool:
    """Whether the last noun before a relative clause is one for people."""
    before = [c for c in state.chunks[max(0, state.at - 3) : state.at - 1] if c.kind == "noun"]
    return bool(before) and before[-1].value.what == "people"


def _noun(state: State, chunk: Chunk) -> None:
    phrase: NounPhrase = chunk.value
    state.after_be = False
    state.every = every_so_many(phrase)
    if state.every > 1 and not (state.waiting is not None and state.waiting.place.type == "between"):
        state.out.referred.append(state.span_of(phrase))
    if phrase.text == "half" and phrase.of is not None and _half_of(state, phrase):
        return
    if phrase.text in words("nouns")["spots"] and state.waiting is None and _placed_by_in(state):
        state.leave_unread(state.source.text[chunk.start : chunk.end], chunk.start, chunk.end)
        state.close_frames()
        state.subject, state.head, state.fronted, state.glue = [], [], [], "start"
        return  # "one tidy spot in the middle, a table": the table is there
    if names_stations(state, phrase):
        name_things(state, [new_stations(state, phrase)], phrase, True)
        return
    if stands_for_each(state, phrase) and state.refs.known(phrase, True, []) is None and _is_of_stations(state, phrase):
        return
    if state.negated and excluded(state, phrase, chunk):
        return
    waiting = state.waiting
    looks = waiting is not None and waiting.place.type == "facing"
    if waiting is not None and looks and phrase.text in words("relations")["views"]:
        place = replace(waiting.place, words=f"{waiting.place.words} the {phrase.text} through")
        state.waiting = replace(waiting, place=place)  # "a bench that looks out over the garden"
        phrase.what, phrase.value = "place", "window"
    hangs = waiting is not None and waiting.place.type == "hanging_from" and phrase.what != "place"
    if hangs and phrase.text in words("relations")["overhead"] and not _is_named(state, phrase):
        phrase.what, phrase.value = "place", "ceiling"
    if hangs and phrase.text in words("relations")["hung_on"] and phrase.of is None and not _is_named(state, phrase):
        phrase.what, phrase.value = "thing", words("relations")["hung_on"][phrase.text]
        phrase.text = phrase.value.replace("_", " ")
    what = "thing" if phrase.what in ("abstract", "matter", "part") and _is_of_kit(state, phrase) else phrase.what
    _PHRASES[what](state, phrase, chunk)


def _is_of_kit(state: State, phrase: NounPhrase) -> bool:
    """Whether what is mostly no thing is one in that room, where it stands in a list: the ring of a boxing gym; of what
    is mostly a part of something, several that hang somewhere: "wheels hanging from the ceiling"."""
    of_thing = bool(state.frames and state.frames[-1].owner)
    if state.waiting is not None or of_thing or state.negated:
        return False
    called = is_called_in(state.out, phrase.text)
    if phrase.what == "matter":
        return called and (phrase.count is not None or phrase.plural)
    if phrase.what == "abstract":
        listed = not state.frames and state.glue in ("start", "comma")
        return listed and called and may_name(phrase.text)
    after = state.chunk(state.at)
    if not phrase.plural or after is None or after.kind != "place" or after.value.type not in ("hanging_from", "on"):
        return False
    return called or bool(sense_of(phrase.text, state.source, phrase.start, phrase.end, 1.0))


def _placed_by_in(state: State) -> bool:
    """Whether words of place with their target come next, and then a list of what is there."""
    place, target, link = (state.chunk(state.at + k) for k in range(3))
    follows = place is not None and place.kind == "place" and target is not None and target.kind == "noun"
    return follows and link is not None and link.kind == "comma" and state.noun_next(3)


def _half_of(state: State, phrase: NounPhrase) -> bool:
    """ "Half of the chairs": parted from the others, where their number is known and even; else it is told."""
    of = phrase.of
    assert of is not None
    group = state.refs.known(of, True, []) if of.what == "thing" and of.definite else None
    if group is None or group.count is None or group.count[0] != group.count[1] or group.count[0] % 2:
        return False
    part = state.refs.part([group], group.count[0] // 2)
    if part is None:
        return False
    state.out.referred.append(state.span_of(phrase))
    name_things(state, [part], phrase, False)
    return True


def _is_named(state: State, phrase: NounPhrase) -> bool:
    """Whether a thing of that name is there: a bar of a pub is no bar overhead."""
    return any(phrase.text in (m.noun, f"{m.noun}s") for m in state.out.mentions)


def _is_of_stations(state: State, phrase: NounPhrase) -> bool:
    """Whether "each place" means places that are no things, and what comes next is each one's; else it means the things
    that people are at, if there are several."""
    used = group_used_by_people(state)
    if used is not None and not state.out.stations:
        state.refer(phrase)
        phrase.what, phrase.value, phrase.text, phrase.of = "thing", None, used.noun, None
        return False
    group = station_group(state)
    if group is None:
        return False
    state.refer(phrase)
    if state.waiting is not None:
        give_target(state, state.waiting, [group], phrase, False)
        return True
    begin_clause(state, [group], state.glue)
    state.each, state.glue = group, ""
    return True


def _place(state: State, chunk: Chunk) -> None:
    place: Place = chunk.value
    state.after_be = False
    if state.negated and _is_nowhere(state, chunk):
        return
    open_ends(state)
    before, after = state.chunk(state.at - 2), state.chunk(state.at)
    noun_next = state.noun_next()
    turned = before is not None and before.kind == "verb" and before.value.lemma in _TURNED
    if before is not None and before.kind == "verb" and before.value.lemma in _LOOKING and place.type == "far_from":
        state.leave_unread(state.source.text[before.start : chunk.end], before.start, chunk.end)
        name_nothing(state)  # "faces away from the door" says nothing of how far it is
        return
    if turned and place.type in ("inside", "through", "on") and noun_next:
        state.at += 1  # "transformed into a studio"
        return
    named = state.subject or state.head or state.out.mentions
    if place.type == "centered_on" and not named and noun_next:
        state.frames.append(Frame("list", type="centered", words=chunk.text))  # "a bedroom centered on a bed"
        state.glue, state.lost = "open", False
        return
    if chunk.mutual:
        relate_mutually(state, place, chunk)
        return
    if chunk.text in ("in", "from") and after is not None and after.kind == "adjective" and state.head:
        return  # "a pair of chairs in green and violet"
    glue, state.glue = state.glue, ""
    subjects = _subjects_of(state, place, glue)
    place = _mannered(state, place)
    if subjects and glue in ("comma", "comma and") and noun_next and _tells_of_next(state, chunk, subjects):
        state.close_frames()
        state.previous = list(subjects)
        state.subject, state.subject_open, state.done = [], True, False
        before, subjects = nearest(state, []), None
        state.fronted.append((place, tuple(before[-1:]), chunk))
        state.glue, state.subset = "comma", None
        return
    fronts = chunk.bare and subjects is None and not state.target_next()
    if noun_next and not (chunk.passive or fronts):
        state.waiting = Waiting(place, subjects, chunk, state.subset, lost=state.lost and not subjects)
        state.glue = "object"
    else:
        relate_to_nearest(state, place, subjects, chunk)
    state.subset = None


def _tells_of_next(state: State, chunk: Chunk, subjects: list[Mention]) -> bool:
    """Whether a word of place that may stand alone is said of the noun after it: "a shelf on the wall, underneath a
    desk", "a dresser by the door, on top a vase"."""
    phrase: NounPhrase = state.chunks[state.at].value
    new = phrase.determiner in ("a", "an", "") and phrase.what == "thing"
    if not (new and chunk.bare and state.head_related):
        return False
    kind, mounts = chunk.value.type, {m.mount for m in subjects}
    if kind == "below":
        return (mounts | {m.mount for m in state.subject}) & {"wall", "ceiling"} != set()
    return (kind == "above" and mounts == {"floor"}) or chunk.text in ("on top", "in front")


def _subjects_of(state: State, place: Place, glue: str) -> list[Mention] | None:
    """Who a word of place is about; None: who comes after it."""
    joins = glue in ("comma", "and", "comma and")
    if glue in ("start", "while") or (joins and state.fronts(state.at - 1)):
        state.lost = False
        if glue != "and" or state.done:
            state.close_frames()
        if state.subject and glue != "start":
            state.previous = list(state.subject)
            state.refs.tell_of(state.subject)
            state.subject, state.subject_open, state.done = [], True, False
        return None
    if glue == "verb":
        return list(state.subject)
    if glue in ("comma", "comma and") and not state.frames and state.subject:
        return list(state.subject) if state.done else list(state.head)
    if glue == "and" and state.last_subjects:
        return list(state.last_subjects)
    frame = state.frames[-1] if state.frames else None
    if glue == "open" and frame is not None and not frame.items:
        return None
    if not state.head:
        return list(state.subject) if state.subject else ([] if state.lost else None)
    holds = frame is not None and frame.kind == "verb" and frame.type in ("on", "inside")
    if frame is not None and holds and place.type in ("opposite", "along"):
        return list(frame.owner)  # "a console supports a TV across from the sofa"
    if state.joined in ("and", "comma") and each_next(state, state.at):
        listed = frame.items if frame is not None else state.subject if state.subject_open else []
        owner = state.refs.known(state.chunks[state.at].value, True, [])
        if state.joined == "and" and state.head == listed[-1:]:
            return listed_before(state, listed, owner) or list(state.head)
    if state.joined == "and":
        listed = frame.items if frame is not None else state.subject if state.subject_open else []
        if len(listed) > 1 and state.head == listed[-1:]:
            return meant_of_list(state, place, listed)
    return list(state.head)


def _is_nowhere(state: State, chunk: Chunk) -> bool:
    """Whether a word of place says where something must not be, and has been read."""
    after = state.chunk(state.at)
    noun = after if after is not None and after.kind == "noun" else None
    of_room = noun is not None and noun.value.what == "room"
    where, state.negated = state.negated in ("where", "first"), ""
    if of_room or not where:
        return of_room
    subjects = state.unwanted or state.subject or state.head
    place: Place = chunk.value
    if noun is not None and subjects:
        state.waiting = Waiting(place, list(subjects), chunk, barred=True)
        state.glue = "object"
        return True
    end = chunk.end if noun is None else noun.end
    state.at += noun is not None
    state.leave_unread(f"{state.negation} {state.source.text[chunk.start : end]}", chunk.start, end)
    return True


def _mannered(state: State, place: Place) -> Place:
    """ "Leaning against", "hanging on", "centered under": what the verb adds to a word of place."""
    manner, state.manner = state.manner, ""
    kind = place.type
    if manner == "lean" and kind in ("against", "on", "next_to", "near"):
        return Place("leaning_on" if kind in ("against", "on") else kind, words=f"leaning {place.words}")
    if manner == "center" and kind in ("on", "inside", "centered_on"):
        return Place("centered_on", words=f"centered {place.words}")
    if manner == "drape" and kind in ("above", "through"):
        return Place("on", words=f"draped {place.words}")
    if manner in ("hang", "mount") and kind in ("above", "on", "inside", "against"):
        return Place(kind, words=f"{'hanging' if manner == 'hang' else 'mounted'} {place.words}")
    return place


_CHUNKS: dict[str, Callable[[State, Chunk], None]] = {
    "aside": _aside,
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
    "matter": matter_phrase,
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
