"""Phrases about things: what is new, what was named before, and what is no thing after all."""

from __future__ import annotations

from dataclasses import replace

from .chunks import Chunk, NounPhrase
from .distribution import count_out_again
from .in_room import is_called_in
from .items import begin_clause, name_nothing, name_things
from .model import Attribute
from .nothings import is_animal, is_certain, is_large, may_name
from .parsed import Mention, without
from .room_phrases import abstract_phrase, describe_room, people_phrase, unknown_room
from .shares import ends_here, last_items, multiply, share_out
from .state import Frame, State
from .things import MANY, describe, match_of, name_of, new_mention, note_on, singular
from .vocabulary import family, words

MOST_NEW = 400
"""Mentions that are made at most."""


_ANYTHING = ("object", "item", "thing", "piece", "article")
"""Nouns that name nothing, but may be counted."""


def named_thing(state: State, phrase: NounPhrase, chunk: Chunk) -> None:
    """A noun: of something new, or of what was named before."""
    if singular(phrase.text) in _ANYTHING and phrase.count is not None and state.waiting is None:
        state.total = phrase.count  # "ten objects, mugs and bottles"
        name_nothing(state)
        state.lost = False
        return
    if phrase.text in ("furniture", "object"):
        describe_room(state, phrase)
        state.glue = ""
        return
    waiting = state.waiting
    if state.glue == "or" and waiting is None and _is_alternative(state, phrase):
        return
    if phrase.of_group:
        _name_group(state, phrase)
    if waiting is None and phrase.determiner in ("each", "every"):  # "each bowl next to a spoon"
        group = state.refs.known(phrase, True, [])
        before = state.chunk(state.at - 2)
        follows = before is not None and (before.text == "for" or before.kind == "noun")
        if group is not None and follows and ends_here(state) and share_out(state, group):
            state.refer(phrase)
            state.glue = ""  # "one locker per bed"
            return
        if group is None and before is not None and before.kind == "noun" and ends_here(state):
            items = last_items(state)
            owner = new_thing(state, phrase) if items else None
            if owner is not None and share_out(state, owner, items=items):
                owner.uncounted = True
                state.glue = ""  # "one chair per desk, six desks"
                return
        if group is not None and group.many:
            state.refer(phrase)
            if before is not None and before.text == "for" and state.glue == "start":
                begin_clause(state, [group], state.glue)
                state.frames.append(Frame("with", [group], words="for each", each=True))
                state.each, state.glue = group, "open"  # "for each bench one stool and a lamp"
                return
            if state.verb_follows(state.at):
                begin_clause(state, [group], state.glue)
                state.glue = ""
            else:
                name_things(state, [group], phrase, False)
            state.each = group
            return
    several = waiting is not None and waiting.subjects is not None and len(waiting.subjects) > 1
    if waiting is not None and several and (phrase.definite or phrase.determiner == "each"):
        one = state.refs.known(phrase, True, [])  # "ten tables and four chairs around each table"
        waiting.subjects = without(waiting.subjects or [], [one])
    found = _named_before(state, phrase)
    if found is not None:
        state.refer(phrase)
        _describe_again(found, phrase, state)
        name_things(state, [found], phrase, False)
        return
    of_room = any((t.has("room") and not t.has("noun")) or t.text in words("nouns")["floors"] for t in phrase.qualities)
    if of_room and phrase.value is None and state.glue == "start" and not state.out.mentions:
        abstract_phrase(state, phrase, chunk)  # "a basement cinema"
        state.lost = False
        return
    if _is_of_the_room(state, phrase) or _is_kind_of(state, phrase):
        return
    made = new_thing(state, phrase)
    if made is not None and phrase.determiner in ("each", "every"):
        made.uncounted = True  # "every bookcase has a lamp, there are three bookcases"
        state.each = made if waiting is None else state.each
    if made is not None:
        name_things(state, [made], phrase, True)
    elif waiting is not None:
        state.leave_unread(waiting.chunk.text, waiting.chunk.start, waiting.chunk.end)
        state.waiting = None
    else:
        name_nothing(state)


def _is_alternative(state: State, phrase: NounPhrase) -> bool:
    """ "A desk or a table by the window": one of the two is enough, and the first is made."""
    before = (state.head or state.subject or state.out.mentions)[-1:]
    if not before or match_of(name_of(phrase)).how == "generic":
        return False
    if phrase.definite and state.refs.known(phrase, True, []) is None:
        return False  # "next to the bed or the sofa" names a sofa
    if not phrase.definite and state.last_target is None:
        before[0].also.append(name_of(phrase))
    if not phrase.definite:
        state.out.note(f"'{before[0].noun} or {name_of(phrase)}': the first was taken")
    state.out.referred.append(state.span_of(phrase))
    state.glue = ""
    return True


def _name_group(state: State, phrase: NounPhrase) -> None:
    """ "Each of the five benches": the group is there, if it was not named before."""
    count, phrase.count = phrase.count, None
    if state.refs.known(phrase, True, []) is None:
        group = new_thing(state, replace(phrase, determiner="", count=count, of_group=False))
        if group is not None and count is None:
            group.count = MANY


def _named_before(state: State, phrase: NounPhrase) -> Mention | None:
    """What was named and is meant again."""
    if (counted := _counted_now(state, phrase)) is not None:
        state.out.referred.append(state.span_of(phrase))
        return counted
    if (told := _told_of_again(state, phrase)) is not None:
        return told
    rest, waiting = state.refs.rest, state.waiting
    apart = (waiting.subjects or []) if waiting is not None else []
    target = waiting is not None and state.glue != "start"
    if not phrase.plural and (one := _one_in_order(state, phrase)) is not None:
        state.out.referred.append(state.span_of(phrase))
        return one
    other = phrase.value in ("rest", "the other", "the others")
    if other and rest is not None and rest.noun.rstrip("s").endswith(phrase.text.rstrip("s")):
        return rest
    found = state.refs.known(phrase, target, apart)
    if found is None and phrase.bound is not None and not target and (some := _some_of(state, phrase)) is not None:
        return some
    if found is None and phrase.count == (1, 1) and phrase.determiner == "one" and not target:
        several = state.refs.known(phrase, True, apart)
        if several is not None and several.many:
            return state.refs.part([several])
    return found


def _one_in_order(state: State, phrase: NounPhrase) -> Mention | None:
    """ "The first desk", "her bed" after "two beds": one of those that were named, each time the next of them."""
    owned = phrase.determiner in words("said_again")["owned"]
    spoken = state.source.text[phrase.start : phrase.end].split()[:2]
    order = " ".join(spoken) in words("said_again")["ordinals"]
    if spoken[:1] == ["the"] and (one := _one_in_row(state, phrase, spoken[1:])) is not None:
        return one
    if (one := _one_of_two_sides(state, phrase)) is not None:
        return one
    if not (owned or order) or phrase.qualities:
        return None
    noun, rest = singular(name_of(phrase)), state.refs.rest
    if rest is not None and singular(rest.noun) == noun and spoken[-1] != "first":
        return state.refs.part([rest]) if rest.many else rest
    group = next((m for m in reversed(state.out.mentions[-20:]) if m.many and singular(m.noun).endswith(noun)), None)
    return state.refs.part([group]) if group is not None and group.count is not None else None


def _one_of_two_sides(state: State, phrase: NounPhrase) -> Mention | None:
    """ "The left nightstand" of two: of a pair on both sides of something the one on that side."""
    side = next((t for t in phrase.qualities if t.text in ("left", "right")), None)
    if side is None or not phrase.definite:
        return None
    noun, rest = singular(name_of(replace(phrase, qualities=[]))), state.refs.rest
    group = next((m for m in reversed(state.out.mentions[-20:]) if singular(m.noun).endswith(noun)), None)
    if group is None:
        return None
    if group.count == (2, 2):
        first = state.refs.part([group])
        if side.text == "right" and first is not None and state.refs.rest is not None:
            first, state.refs.rest = state.refs.rest, first
        found = first
    else:
        found = rest if rest is not None and singular(rest.noun).endswith(noun) and group.count == (1, 1) else None
    if found is not None:
        phrase.qualities = [t for t in phrase.qualities if t is not side]
    return found


def _one_in_row(state: State, phrase: NounPhrase, spoken: list[str]) -> Mention | None:
    """ "On the third locker" of eight: the lockers, of which the relation in hand then means one."""
    noun, waiting = singular(name_of(phrase)), state.waiting
    if waiting is None or not spoken:
        return None
    plain = [t.text for t in phrase.qualities if t.text != spoken[0]]
    group = next((m for m in reversed(state.out.mentions[-20:]) if m.many and singular(m.noun).endswith(noun)), None)
    meant = state.refs.in_row(spoken, group) if not plain else None
    if meant is None:
        return None
    phrase.qualities = []
    state.waiting = replace(waiting, place=replace(waiting.place, nth=meant[1]))
    return meant[0]


def _told_of_again(state: State, phrase: NounPhrase) -> Mention | None:
    """ "A desk and a chair, desk should be oak": a noun without article of which a verb tells is what was named so."""
    if phrase.determiner or phrase.count is not None or phrase.of is not None or state.waiting is not None:
        return None
    after = state.chunk(state.at)
    told = after is not None and after.kind == "verb" and after.value.form in ("s", "base") and not after.passive
    placed = after is not None and after.kind == "place" and state.glue == "start"
    if not (told or placed):
        return None
    noun, related = singular(name_of(phrase)), {m for said in state.out.said for m in said.subjects if not said.implied}
    named = [m for m in state.out.mentions[-20:] if singular(m.noun) == noun]
    if not named and told:  # "a cast iron stove ... stove is black"
        named = [m for m in state.out.mentions[-20:] if singular(m.noun).endswith(f" {noun}") or noun in m.also]
        named = named if len(named) == 1 else []
    for mention in reversed(named):
        if (phrase.plural or not mention.many) and (told or mention not in related):
            return mention
    return None


def _counted_now(state: State, phrase: NounPhrase) -> Mention | None:
    """ "The chairs are black, four chairs": the number of what was named without one and is nowhere yet."""
    if phrase.determiner or phrase.count is None or phrase.count == (1, 1) or phrase.qualities or phrase.of is not None:
        return None
    noun, placed = singular(name_of(phrase)), {m for said in state.out.said for m in said.subjects}
    for mention in reversed(state.out.mentions[-6:]):
        if mention.uncounted and singular(mention.noun) == noun:
            count_out_again(state, mention, phrase.count)
            return mention
        if mention.plural and mention.count in (None, MANY) and singular(mention.noun) == noun:
            if mention in placed or mention.per is not None:
                return None
            mention.count = phrase.count
            return mention
    return None


def _some_of(state: State, phrase: NounPhrase) -> Mention | None:
    """ "Six tables. At least two tables stand by the window": some of those that were named, of which it is said."""
    noun, count = singular(name_of(phrase)), phrase.count or (1, 1)
    for mention in reversed(state.out.mentions[-12:]):
        if mention.count is not None and singular(mention.noun) == noun and count[0] < mention.count[0]:
            state.subset = (count[0], max(count[1], mention.count[1]))
            phrase.count = None
            return mention
    return None


def _is_kind_of(state: State, phrase: NounPhrase) -> bool:
    """ "One of the chairs is a rocking chair": whether a noun says what kind of thing something is."""
    verb, who = state.chunk(state.at - 2), state.predicate
    told = verb is not None and verb.kind == "verb" and verb.value.lemma == "be"
    if not told or len(who) != 1 or state.waiting is not None or phrase.definite or phrase.value is None:
        return False
    (one,) = who
    match = match_of(name_of(phrase))
    many = one.count[1] > 1 if one.count is not None else one.plural
    if many != phrase.plural or match.how == "generic" or family(match.category) != one.family:
        return False
    one.noun, one.category, one.generic = name_of(phrase), match.category, False
    describe(one, phrase, state.source)
    state.out.referred.append(state.span_of(phrase))
    state.head, state.glue, state.predicate = [one], "", []
    return True


def _is_of_the_room(state: State, phrase: NounPhrase) -> bool:
    """Whether an unknown noun at the very start is the room or who it is for: "a mountain hut for two hikers: "."""
    if state.out.mentions or state.waiting is not None or match_of(name_of(phrase)).how != "generic":
        return False
    before, after = state.chunk(state.at - 2), state.chunk(state.at)
    if before is not None and before.kind == "purpose" and before.value == "people" and phrase.count is not None:
        people_phrase(state, phrase, before)
        return True
    room = state.out.room_type is not None or bool(state.out.room_words) or state.names_a_room
    if room or phrase.definite or phrase.plural or phrase.count not in (None, (1, 1)) or after is None:
        return False
    first = state.at == 1 and after.kind == "with"
    if not (first or after.start in state.source.colons or (after.kind == "purpose" and after.value == "people")):
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
    nouns = words("nouns")
    built_in = any(t.text in nouns["built_in"] for t in phrase.qualities)
    return built_in or (singular(owner[0].noun).endswith("frame") and singular(phrase.text) in nouns["framed"])


def new_thing(state: State, phrase: NounPhrase) -> Mention | None:
    """A mention of something that was not named before; None, and left unread, where that can be nothing."""
    called_for = _called_for(state, phrase)
    if called_for is not None:
        return called_for
    if len(state.out.mentions) >= MOST_NEW:
        state.leave_unread(phrase.text, phrase.start, phrase.end)
        return None
    mention = new_mention(phrase, state.source)
    if not mention.category or (mention.generic and not _is_concrete(state, phrase)):
        spoken = state.source.text[phrase.start : phrase.end].removeprefix(f"{phrase.determiner} ")
        state.leave_unread(spoken, phrase.start, phrase.end)
        if is_large(name_of(phrase)):
            state.out.note(f"'{name_of(phrase)}' is nothing that can be put in a room; it was left out")
        return None
    like = (state.head or state.previous or state.subject)[-1:]
    if like and any(t.text == "matching" for t in phrase.qualities):
        (other,) = like
        mention.color, mention.material = mention.color or other.color, mention.material or other.material
        mention.style = mention.style or other.style
        alike = ("color", "material", "style", "other", "finish")
        mention.attributes += [a for a in other.attributes if a.kind in alike]
    note_on(mention, state.out)
    for role in state.out.roles:
        if phrase.start <= role.at < phrase.end:
            mention.also.append(role.noun)
            mention.attributes.append(
                Attribute(kind="other", value=f"as {role.noun}", words=role.words, span=role.span)
            )
    state.out.mentions.append(mention)
    if state.per_person and state.out.people and mention.count in (None, (1, 1)):
        multiply([mention], (state.out.people, state.out.people))
    return mention


def _is_concrete(state: State, phrase: NounPhrase) -> bool:
    """Whether a noun that is not known stands where a thing is named: in a list, or as what is placed."""
    noun = name_of(phrase)
    if is_called_in(state.out, noun, phrase.plural):
        return True  # "a boxing gym: ring, ..."
    if not any(c.isalpha() for c in phrase.text) or not (may_name(noun) or _is_likeness(phrase)):
        return False
    if phrase.definite or is_certain(noun):
        return is_certain(noun)
    if _is_likeness(phrase):
        return True
    if phrase.determiner or phrase.count is not None:
        return True
    return bool(state.frames or state.waiting) and state.glue != "start" and bool(state.out.mentions)


def _is_likeness(phrase: NounPhrase) -> bool:
    """Whether an animal is one that somebody made: "a stuffed crocodile", "a bronze heron"."""
    made = words("nouns")["likenesses"]
    return is_animal(name_of(phrase)) and any(t.has("material") or t.text in made for t in phrase.qualities)


def _called_for(state: State, phrase: NounPhrase) -> Mention | None:
    """What a "dining area" called for, when the request now says what it is to be."""
    if phrase.definite:
        return None
    noun = name_of(phrase)
    head, match = singular(noun).split()[-1], match_of(noun)
    placed = state.party if state.waiting is not None else []  # "sweets in jars": other jars
    for mention in without((m for m in reversed(state.out.mentions[-12:]) if m.implied), placed):
        if mention.category != match.category and singular(mention.noun).split()[-1] != head:
            continue
        if singular(noun) != head:
            mention.noun, mention.category, mention.generic = noun, match.category, match.how == "generic"
        several = mention.count if state.each is not None and mention.count is not None else (1, 1)
        if phrase.count is not None or phrase.determiner:
            low, high = phrase.count or (1, 1)
            mention.count = (low * several[0], high * several[1])
        mention.implied = False
        mention.span = state.span_of(phrase)
        describe(mention, phrase, state.source)
        return mention
    return None


def _describe_again(mention: Mention, phrase: NounPhrase, state: State) -> None:
    """More is said of what was named before."""
    mention.count = phrase.count if mention.count is None else mention.count
    mention.implied = False
    known = {a.words for a in mention.attributes}
    phrase.qualities = [t for t in phrase.qualities if t.text not in known]
    describe(mention, phrase, state.source)
