"""People in words: how many there are, what they do at what, and what each of them has for their own.

A number of people at something ("a table for ten", "four people at a round table", "five benches, four pupils each") is
taken out of the source; people of whom nothing else is said are left to the clause grammar, and `counts.peopled` makes
one statement of both.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from sceneweaver.assets import resolve
from sceneweaver.assets.plurals import singular

from ..model import Activity, Capacity
from ..parsed import Parsed
from ..source import Source
from ..things import match_of
from ..vocabulary import family, vocabulary, words
from .phrases import NUMBER, Edits, listed, noun_after, noun_before, number_of, one_of, table_before

_N = rf"(?P<n>{NUMBER})"
_ABOUT = r"(?:about |around |roughly |some |up to |at least |max(?:imum)? |approx(?:imately)? )?"
_PEOPLE = rf"(?: *(?:[a-z-]+ ){{0,2}}{one_of(listed('people'))}\b)"
_ENDS = (
    r"(?=\s*(?:$|[.,()]|(?:with|and|in|at|but|by|under|near|on|along|that|which|in|from|next|to|or|against|plus|facing"
    r"|looking|so|around|without|arranged|opposite|across|beside|behind)\b))"
)


def activity_at(noun: str) -> Activity | None:
    """What people do at a thing, by the last word of its noun; None where nobody does anything at such things."""
    last = noun.split()[-1] if noun else ""
    told = next((name for name, nouns in words("people")["at"].items() if last in nouns), None)
    if told is not None or not last:
        return told
    match = match_of(singular(noun))
    return _AT.get(family(match.category)) if match.how != "generic" else None


_AT: dict[str, Activity] = {"seat": "sit", "bed_group": "sleep", "table": "sit"}
"""What people do at things of a family."""


def capacities(source: Source, parsed: Parsed) -> None:
    """Reads numbers of people and what is each one's own; see `Capacity`."""
    edits = Edits(source)
    for pattern, read in _PATTERNS:
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                read(m, edits, parsed)


def _add(edits: Edits, parsed: Parsed, start: int, end: int, said: Capacity, instead: str = "") -> None:
    words_ = " ".join(edits.source.spoken[start:end].split()).strip(" ,")
    span = edits.take(start, end, instead)
    parsed.capacities.append(said.model_copy(update={"words": words_, "span": span}))


def _verb(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Sleeps 8", "table seats eight", "room for six people"."""
    text, verb = edits.source.text, m["verb"]
    does = next(name for name, verbs in words("people")["verbs"].items() if verb in verbs)
    before = re.search(r"([a-z-]+) (?:that |which )?(?:comfortably )?$", text[: m.start()])
    at = before[1] if before is not None and activity_at(before[1]) else ""
    if verb == "beds for":
        at = "beds"
    of_room = verb.endswith(" for") and re.search(r"[a-z] $", text[: m.start()]) and not at
    if (does == "use" and not at and not m["who"]) or (of_room and not re.search(r"\bwith $", text[: m.start()])):
        return  # "a dormitory room for four"
    activity: Activity = (activity_at(at) or "use") if does == "use" else does
    instead = "beds" if verb == "beds for" else ""
    if does == "sit" and not at and verb.startswith("seat") and _AT_PLACE.match(text, m.end()):
        instead = f"{number_of(m['n'])} seats"
    _add(edits, parsed, m.start(), m.end(), Capacity(people=number_of(m["n"]), activity=activity, target=at), instead)


_AT_PLACE = re.compile(
    r",? ?(?:all |placed |arranged |set )?(?:along|against|around|round|on|at|by|near|in (?:two |three |\d )?rows?|"
    r"facing|looking|in an? (?:circle|ring|u|row|semi-?circle|horseshoe))\b"
)
"""Where seats are of which only the number of people was told."""


def _thing_for(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A table for ten", "five tables for two", "a sofa for all of us", "a desk wide enough for both"."""
    noun = noun_before(edits.source.text, m.end("noun"))
    noun = noun if noun.split()[-1:] == [m["noun"]] else m["noun"]
    activity = activity_at(m["noun"])
    if activity is None:
        return
    many = re.search(rf"({NUMBER}) (?:[a-z-]+ ){{0,2}}{re.escape(m['noun'])}$", edits.source.text[: m.end("noun")])
    people = number_of(m["n"]) if m["n"] else 0
    each = activity == "sit" and many is not None and number_of(many[1]) > 1
    plural = many is None and singular(m["noun"]) != m["noun"] and not _is_long(m["noun"])
    each = each or (activity == "sit" and plural and 0 < people <= PARTY)
    said = Capacity(people=people, activity=activity, target=noun, each=each)
    _add(edits, parsed, m.end("noun"), m.end(), said)
    more = _AND_FOR.match(edits.source.text, m.end())
    if more is not None:  # "and one for six"
        count, one = number_of(more["m"]), singular(m["noun"])
        instead = f"a {one}" if count == 1 else f"{count} {m['noun']}"
        if len(instead) <= more.end() - more.start("m"):
            said = Capacity(people=number_of(more["k"]), activity=activity, target=one, each=count > 1)
            _add(edits, parsed, more.start("m"), more.end(), said, instead)


PARTY = 8
"""People at one of several tables, at most."""

_AND_FOR = re.compile(
    rf"\s*,?\s*(?:and |plus |, )(?P<m>{NUMBER})(?: of them)? for (?P<k>{NUMBER})(?![\w-])(?! [a-z]+s\b)"
)


def _is_long(noun: str) -> bool:
    """Whether several people sit beside each other on a thing without a table: benches for twenty."""
    category = match_of(singular(noun)).category
    return family(category) == "seat" and not category.startswith("booth")


def _at_thing(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Four people at a round table", "three operators side by side at a console"."""
    noun, _ = noun_after(edits.source.text, m.end())
    activity = activity_at(noun)
    if activity is None:
        return
    _add(edits, parsed, m.start(), m.end("at"), Capacity(people=number_of(m["n"]), activity=activity, target=noun))


def _each_at(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Five island benches, four pupils each on stools"."""
    noun = noun_before(edits.source.text, m.start())
    activity = activity_at(noun)
    if activity is None:
        return
    said = Capacity(people=number_of(m["n"]), activity=activity, target=noun, each=True)
    _add(edits, parsed, m.start(), m.end(), said, ", " if m["on"] else "")


def _a_side(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A table, six a side": so many people on both sides of it."""
    noun = table_before(edits.source.text, m.start())
    if noun:
        _add(edits, parsed, m.start(), m.end(), Capacity(people=2 * number_of(m["n"]), activity="sit", target=noun))


def _they_do(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Ten people can sit", "a table where four can eat", "two people work side by side", "six of us eat here"."""
    does = next(name for name, verbs in words("people")["does"].items() if m["does"] in verbs)
    noun, _ = noun_after(edits.source.text, m.end())
    if len(m[0].split()) == 2 and noun and match_of(singular(noun)).how != "generic":
        return  # "three work tables" are tables
    at = ""
    if m["where"]:
        noun = noun_before(edits.source.text, m.start())
        at = noun if activity_at(noun) is not None else ""
    _add(edits, parsed, m.start(), m.end(), Capacity(people=number_of(m["n"]), activity=does, target=at))


def _seater(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A 6-seater dining table", "four-person booth", "a one person office"."""
    noun, _ = noun_after(edits.source.text, m.end())
    activity = activity_at(noun)
    if noun and resolve(f"{m[0]} {noun.split()[-1]}").how in ("exact", "synonym"):
        return  # a two-seat sofa is a kind of its own
    if activity is None and not (m["person"] or m["people"]):
        return
    if noun.split()[-1:] and "room" in vocabulary().get(noun.split()[-1], {}):
        parsed.people = parsed.people or number_of(m["n"])
        edits.take(m.start(), m.end())
        return
    said = Capacity(people=number_of(m["n"]), activity=activity or "use", target=noun if activity else "")
    _add(edits, parsed, m.start(), m.end(), said)


def _seats(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A sofa 2 seats", "40 seats ... the benches face the altar": seats of what is named, and no chairs beside it."""
    seats = one_of([noun for noun in words("people")["at"]["sit"] if noun.endswith("s") and noun != "tables"])
    others = edits.source.text[: m.start()] + edits.source.text[m.end() :]
    if m["noun"] or re.search(rf"\b{seats}\b", others):
        start = m.end("noun") if m["noun"] else m.start()
        said = Capacity(people=number_of(m["n"]), activity="sit", target=m["noun"] or "")
        _add(edits, parsed, start, m.end(), said)


def _places(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two working places", "14 covers"."""
    does = next(name for name, spoken in words("people")["places"].items() if m["place"] in spoken)
    _add(edits, parsed, m.start(), m.end(), Capacity(people=number_of(m["n"]), activity=does))
    each = _EACH_WITH.match(edits.source.text, m.end())
    if each is not None:
        _own_list(each, edits, parsed)


def _own_list(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Each place has a couch, a rolling stool and a lamp over the couch"."""
    of_places = re.search(_PLACE, m[0]) is not None
    if of_places and re.search(rf"\b{NUMBER} {_PLACE}", edits.source.text[: m.start()]):
        return  # "three stations, each station with a chair": the clauses count out what stands at each
    text = edits.source.text
    stop = re.compile(r"[.;()]").search(text, m.end())
    clause = text[m.end() : stop.start() if stop is not None else len(text)]
    nouns: list[str] = []
    for piece in re.split(r",|\band\b|\bplus\b", clause):
        head = re.split(rf"\b{one_of(listed('prepositions'))}\b", piece.strip())[0]
        noun = noun_before(head, len(head))
        if not noun or match_of(singular(noun)).how == "generic":
            break
        nouns.append(noun)
    if nouns:
        said = Capacity(people=0, activity="use", own=tuple((noun, 1) for noun in dict.fromkeys(nouns)))
        _add(edits, parsed, m.start(), m.end(), said, ", " if m.end() - m.start() > 2 else "")


def _couple(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "For me and my wife": two people, who stay in the source for whom the room is."""
    parsed.people = parsed.people or 2
    parsed.referred.append(edits.source.span(*m.span()))


def _ensemble(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    parsed.people = parsed.people or words("people")["ensembles"][m[1]]
    parsed.referred.append(edits.source.span(*m.span(1)))


def _room_people(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "My two boys", "staff of five": how many there are, who stay in the source for whom the room is."""
    if parsed.people is None:
        parsed.people = number_of(m["n"])
        parsed.referred.append(edits.source.span(m.start("n"), m.end()))
        if m.end() == m.end("n") and m[0].split()[1] == "are":
            edits.take(m.start(), m.end())  # "we are seven": a number of nothing that is named


def _own(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Everybody must have an own wardrobe, so four, and own lamp"."""
    text = edits.source.text
    noun, end = noun_after(text, m.end())
    if not noun:
        return
    own = [(noun, 1)]
    rest = re.compile(rf"(?:,? so {NUMBER})?,? and (?:(?:his|her|their|an|a) )?own ")
    while again := rest.match(text, end):
        noun, last = noun_after(text, again.end())
        if not noun:
            break
        own.append((noun, 1))
        edits.take(again.start(), again.end(), ", a ")
        end = last
    if so := re.compile(rf",? so {NUMBER}\b").match(text, end):
        edits.take(so.start(), so.end())
    _add(edits, parsed, m.start(), m.end(), Capacity(people=0, activity="use", own=tuple(own)), "a ")


def _for_each(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "A microphone and headphones for each", "plate, glass and napkin for each guest"."""
    text = edits.source.text
    start = max(text.rfind(".", 0, m.start()), -1) + 1
    parts = text[start : m.start()].split(",")
    tied = rf"\b{one_of(listed('prepositions'))}\b"
    nouns: list[str] = []
    end = begin = m.start()
    if len(parts) > 1 and parts[-1].strip() in ("one", "1"):  # "five hooks, one for everybody"
        end = begin = m.start() - len(parts.pop()) - 1
        if re.search(rf"\b{NUMBER} (?:[a-z-]+ )?[a-z-]+$", parts[-1]):
            parsed.referred.append(edits.take(begin, m.end()))
            return
    for k, part in enumerate(reversed(parts)):
        told = not edits.free(end - len(part), end)  # "four people at a table, a cup for each": the table is not each's
        end -= len(part) + 1
        if k and (told or re.search(tied, part) or len(part.split()) > 4):
            break
        for piece in re.split(rf"\band\b|{tied}", part):
            if re.match(r"\s*the\b", piece) and piece is not part:
                continue  # "a jug on the shelf for every four players": one shelf
            noun = noun_before(piece, len(piece))
            nouns += [noun] if noun else []
    if nouns and m["n"]:
        parsed.shared += [(noun, number_of(m["n"])) for noun in dict.fromkeys(nouns)]
        parsed.referred.append(edits.take(begin, m.end()))
    elif nouns:
        said = Capacity(people=0, activity="use", own=tuple((noun, 1) for noun in dict.fromkeys(nouns)))
        _add(edits, parsed, begin, m.end(), said)


def _per_person(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "Two lockers per person", "one chair each"."""
    noun, count = m["noun"], number_of(m["n"]) if m["n"] else 1
    if match_of(singular(noun)).how != "generic":
        said = Capacity(people=0, activity="use", own=((noun, count),))
        _add(edits, parsed, m.end("noun"), m.end(), said)


_EACH_ONE = (
    r"(?:each one|each of (?:them|us|the [a-z]+)|every one|everyone|everybody"
    rf"|each(?: of the)? {_PEOPLE}|every {_PEOPLE})"
)
_HAS = r"(?:must |should |needs to |need to |has to |shall |will )?(?:have|has|gets|get|needs|need|with)"

_EACH_WITH = re.compile(
    r",?\s*(?:and\s)?(?:each|every|both)(?:\s(?:one|place|of them|of which))?\s(?:with|has|have|having)\s"
)
_PLACE = r"(?:(?:work |working |treatment )?(?:place|station|spot|workplace|work place|position)s?)"

_PATTERNS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str], Edits, Parsed], None]], ...] = (
    (re.compile(rf"\b{_EACH_ONE} {_HAS} (?:(?:his|her|their|its|an|a) )?own "), _own),
    (
        re.compile(
            rf",? ?\b{_N} {_PEOPLE} (?:each|at each(?: one| of them)?|per [a-z]+)\b"
            r"(?: (?P<on>on|with|sitting on|seated on))?"
        ),
        _each_at,
    ),
    (
        re.compile(
            rf"\b{_N} {_PEOPLE}(?P<at>(?: (?:sit|sitting|seated|work|working|sleep|sleeping))?"
            r"(?: side by side| together| next to each other)? (?:at|around|round|across)) (?:an? |the |one )"
        ),
        _at_thing,
    ),
    (
        re.compile(
            rf"\b(?P<verb>{'|'.join(v for listed_ in words('people')['verbs'].values() for v in listed_)})"
            rf" {_ABOUT}{_N}(?P<who> {_PEOPLE})?{_ENDS}"
        ),
        _verb,
    ),
    (re.compile(rf"\b{_N}(?: {_PEOPLE})? (?:a|per) side\b"), _a_side),
    (
        re.compile(rf"\b(?P<noun>tables|rounds|booths|desks|benches) of (?P<n>{NUMBER})(?! [a-z]+s\b){_ENDS}"),
        _thing_for,
    ),
    (
        re.compile(
            rf"\b(?P<noun>[a-z]+)(?: (?:that is |that's )?(?:big|wide|large|long|roomy))?(?: enough)? for {_ABOUT}"
            rf"(?:{_N}(?: {_PEOPLE})?|both(?: of them)?|all(?: of (?:us|them))?"
            rf"|everyone|everybody|the whole family){_ENDS}"
        ),
        _thing_for,
    ),
    (
        re.compile(
            r"\b(?P<noun>[a-z]+) where (?:all of us|we all|everyone|everybody|they all|all of them) "
            r"(?:can )?(?:fits?|sits?)\b(?P<n>(?!))?"
        ),
        _thing_for,
    ),
    (
        re.compile(
            rf"\b(?P<where>where |at which |that )?{_N}(?: (?:of us|of them|{_PEOPLE}))?"
            rf"(?: {one_of(listed('can'))})? (?:all |comfortably |both )?"
            rf"(?P<does>{'|'.join(verb for verbs in words('people')['does'].values() for verb in verbs)})"
            r"(?![a-z])(?: (?:side by side|together|next to each other|in it|there|here|at it|at once|at a time"
            r"|at the same time))*"
        ),
        _they_do,
    ),
    (
        re.compile(rf"\b(?:(?P<noun>sofa|couch|settee|bench|booth),? )?{_ABOUT}{_N} seats\b(?! (?:each|per|at))"),
        _seats,
    ),
    (
        re.compile(
            rf"\b{_N} (?P<place>{'|'.join(p for found in words('people')['places'].values() for p in found)})\b"
        ),
        _places,
    ),
    (re.compile(rf"\b(?:each|every|both)(?: of (?:these|those|the))? {_PLACE} (?:with|{_HAS}) "), _own_list),
    (re.compile(rf",? ?\b(?:and )?{_EACH_ONE} {_HAS} (?=an? |one |their |his |her )"), _own_list),
    (
        re.compile(
            rf"\b{_N}(?:[\s-](?:seater|seat|(?P<person>person|man|child|pupil|guest))|-(?P<people>people))\b(?! each)"
        ),
        _seater,
    ),
    (
        re.compile(
            rf"\b(?:me|i|myself|mum|mom|dad|us) and (?:my |our )?{one_of(listed('partners'))}\b"
            rf"|\b(?:my |our ){one_of(listed('partners'))} and (?:me|i|myself)\b"
        ),
        _couple,
    ),
    (re.compile(rf"\b(?:for|of) an? (?:[a-z]+ )?({'|'.join(words('people')['ensembles'])})\b"), _ensemble),
    (re.compile(rf"\b(?:we|they|you) are {_N}(?! [a-z]+s\b)(?: {_PEOPLE})?\b"), _room_people),
    (re.compile(rf"\b(?:my|our|his|her|their|the) {_N} {_PEOPLE}"), _room_people),
    (re.compile(rf"\b{one_of(listed('of_people'))} of {_N}\b(?! [a-z]+s\b)"), _room_people),
    (
        re.compile(
            rf" for (?:(?:each|every) {_N} (?:{_PEOPLE}|of (?:us|them))|each(?: (?:one|of them|{_PEOPLE}))?"
            rf"|every {_PEOPLE}|everyone|everybody)(?=\s*(?:$|[.,)]))"
        ),
        _for_each,
    ),
    (
        re.compile(
            rf"\b(?:(?P<n>{NUMBER}) |an? )?(?P<noun>(?:[a-z-]+ )?[a-z-]+) "
            rf"(?:per (?:person|head|{_PEOPLE})|for each person)\b"
        ),
        _per_person,
    ),
)
"""Each pattern with what reads it, in order: what the ones before it took is no more in the text."""

__all__ = ["activity_at", "capacities"]
