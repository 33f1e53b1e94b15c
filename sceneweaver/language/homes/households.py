"""People: who lives or works in a home, who visits, and whom single rooms are for."""

from __future__ import annotations

from .lexicon import plain
from .mentions import is_thing
from .owners import kin
from .parts import Named, Person, Reading
from .tokens import Token

_NEW = ("a", "an", "another", "other", "second", "two", "one")
"""Words before somebody who was not told before."""

ELDER = ("mother", "mother-in-law")
"""Elders whom one bare name may mean: "Gran"."""

_OWNERS = ("my", "our", "his", "her", "their", "the")
_ELDERS = ("father", "mother", "mum", "mom", "dad")
_STAYS = ("stay", "visit", "visits", "come", "comes", "visiting", "over")
_COLLECTIVE = ("kids", "children")
_ORDER = ("couples", "parents", "partners", "twins", "babies", "children", "seniors", "adults", "families")


def read_people(reading: Reading) -> None:
    """Reads who a home is for; see above."""
    for sentence in reading.sentences():
        _sentence(reading, sentence)
        _shared_storey(reading, sentence)


def _sentence(reading: Reading, sentence: range) -> None:
    tokens = reading.tokens
    depth = 0
    names = [one for one in reading.named if one.at in sentence]
    for at in sentence:
        token = tokens[at]
        work = reading.use_of(at).plan in ("clinic", "office")
        if (
            at == reading.use_at
            and not work
            and at + 2 < len(tokens)
            and tokens[at + 1].text in ("of", "for")
            and tokens[at + 2].number
        ):
            after = tokens[at + 3] if at + 3 < len(tokens) else None
            if (after is None or after.breaks) and (tokens[at + 2].number or 0) > 1:  # "a house share of five"
                reading.household = tokens[at + 2].number
                reading.did(at + 2, "people")
        depth += (token.text == "(") - (token.text == ")")
        if token.done:
            continue
        if token.has("animal"):
            reading.did(at, "people")
            continue
        if token.text in ("each", "everyone", "everybody") and _gets_a_room(reading, at, sentence):
            reading.own_rooms = True
            reading.did(at, "people")
        if not token.has("person", "staff", "me", "we", "groups", "visitors") or names_thing(tokens, at):
            continue
        room = _of_room(reading, names, at)
        if room is not None:
            continue  # whom a room is for, its own request says
        if work:
            _workers(reading, at)
        else:
            _lives(reading, at, sentence, depth)


def _shared_storey(reading: Reading, sentence: range) -> None:
    """ "Ground floor for the shared rooms"."""
    tokens = reading.tokens
    for at in sentence:
        ahead = [t.text for t in tokens[at + 1 : min(at + 5, sentence.stop)]]
        shared = {"shared", "common", "communal", "joint", "living"} & set(ahead) and {
            "rooms",
            "areas",
            "spaces",
        } & set(ahead)
        if tokens[at].get("storey") == "ground" and (shared or tokens[at - 1].text in ("share", "shared")):
            reading.share_ground = True
            for k in range(at, min(at + 5, sentence.stop)):
                reading.did(k, "storeys")


def _gets_a_room(reading: Reading, at: int, sentence: range) -> bool:
    """ "Everyone gets their own room", "we each want a door we can close", "for each of us"."""
    tokens = reading.tokens
    said = {tokens[k].text for k in range(at, min(at + 7, sentence.stop))}
    before = tokens[at - 1] if at else None
    if reading.use.plan not in ("flat", "house"):
        return False
    if "us" in said and "of" in said:
        return True
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    if (
        before is not None
        and before.has("we", "person")
        or tokens[at].text in ("everyone", "everybody")
        or after is not None
        and after.has("person")
    ):
        end = next(
            (
                k
                for k in range(at, min(at + 8, sentence.stop))
                if tokens[k].text in ("room", "bedroom", "door", "rooms", "space")
            ),
            None,
        )
        if end is not None and not any(one.first <= end <= one.last and one.told == "article" for one in reading.named):
            for k in range(at, end + 1):
                reading.did(k, "people")
            return True
    return False


def _of_room(reading: Reading, names: list[Named], at: int) -> Named | None:
    """The room that people are named with: "waiting room for eight", "a study where two can work"."""
    tokens = reading.tokens
    before = [one for one in names if one.last < at]
    if not before:
        return None
    room = before[-1]
    gap = tokens[room.last + 1 : at]
    if any(t.breaks or t.done and t.done != "rooms" for t in gap):
        return None
    ties = [t.text for t in gap]
    if not ties or not {"for", "where", "of", "that", "seats", "seating", "with", "in"} & set(ties[:2]):
        return None
    sleeping = "bedroom" in (room.root.kind.name, *room.root.kind.counts_as)
    if sleeping and reading.use.plan in ("flat", "house") and room.count is None:
        return None  # "bedrooms for us and for our twins" tells who lives there
    return room


def _workers(reading: Reading, at: int) -> None:
    """How many work there; who has a room of his kind of work."""
    tokens, token = reading.tokens, reading.tokens[at]
    number = count_before(tokens, at)
    if token.has("groups") and at + 2 < len(tokens) and tokens[at + 1].text == "of" and tokens[at + 2].number:
        reading.workers = tokens[at + 2].number
        for k in (at, at + 1, at + 2):
            reading.did(k, "people")
        if at + 3 < len(tokens) and tokens[at + 3].has("person", "staff"):
            reading.did(at + 3, "people")
        return
    single = plain(in_singular(token))
    staff = reading.use_of(at).staff
    if single in staff and number is not None:
        kind = staff[single]
        reading.staff[kind] = reading.staff.get(kind, 0) + number
        reading.did(at, "people")
        number_done(reading, at)
    elif token.has("staff", "person") and number is not None and number > 1 and not token.has("visitors"):
        reading.workers = max(reading.workers or 0, number)
        reading.did(at, "people")
        number_done(reading, at)
    elif token.has("visitors", "person", "staff", "we", "me"):
        reading.did(at, "people")


def _lives(reading: Reading, at: int, sentence: range, depth: int) -> None:
    tokens, token = reading.tokens, reading.tokens[at]
    of_use = at + 1 < len(tokens) and at + 1 == reading.use_at
    if token.text.endswith(("'s", "s'")) and not of_use or at and tokens[at - 1].text in ("each", "every"):
        return
    count = count_before(tokens, at)
    if token.has("visitors") and _visits(reading, at, sentence) or _only_visits(tokens, at):
        reading.visitors = reading.visitors or token.has("visitors")
        reading.did(at, "people")
        number_done(reading, at)
        return
    if token.has("groups") and at + 2 < len(tokens) and tokens[at + 1].text == "of" and tokens[at + 2].number:
        reading.household = tokens[at + 2].number
        for k in (at, at + 1, at + 2):
            reading.did(k, "people")
        if token.get("person") == "families":
            reading.people.append(Person("families", 1, token.span))
        return
    if token.has("we") and _we_are(reading, at):
        return
    role = token.get("person")
    if role is None:
        return
    if depth and reading.household is None:
        reading.did(at, "people")
        return
    if token.text == "single":
        reading.did(at, "people")
        return
    if (
        role == "adults"
        and at >= 2
        and tokens[at - 1].text in ("a", "single", "an")
        and any(t.text in ("i am", "i'm", "am") for t in tokens[max(0, at - 4) : at])
    ):
        count = 1
    if role == "adults" and at and tokens[at - 1].text == "au":
        return
    before = [t for t in tokens[max(0, at - 2) : at]]
    if role in ("twins",) and at + 1 < len(tokens) and tokens[at + 1].text in ("bed", "beds", "room"):
        return
    if role == "twins" and at + 1 < len(tokens) and tokens[at + 1].get("person") in ("children", "babies"):
        reading.did(at + 1, "people")
    if role == "babies" and at + 1 < len(tokens) and tokens[at + 1].get("person") == "children":
        reading.did(at + 1, "people")  # "a baby girl" is one
    if role == "parents":
        number = 1 if token.plural or any(word.endswith("s") for word in token.text.split()) else None
        role, count = ("couples" if number else "adults"), 1
        if token.text.startswith("grand"):
            role = "couples"
    elif count is None:
        count = 2 if token.plural and role not in ("twins",) else 1
    if role == "twins":
        count = 1
    if role in ("children", "twins") and _in_one_room(tokens, at, sentence):
        reading.together = True
    share = {t.text for t in tokens[at + 1 : min(at + 5, sentence.stop)]} & {"share", "together"}
    if role in ("children", "twins") and share and not reading.named_between(at, min(at + 6, sentence.stop)):
        reading.share = True
        for t in tokens[at + 1 : at + 5]:
            if t.text in ("share", "together", "shares", "room", "bedroom"):
                t.done = t.done or "people"
    if role == "seniors" and not before_article(tokens, at):
        elder = next(
            (
                p
                for p in reading.people
                if p.role == "adults" and reading.text[p.span.start : p.span.end].lower() in _ELDERS
            ),
            None,
        )
        if elder is not None:  # "my father ... grandad": one person
            reading.people[reading.people.index(elder)] = Person("seniors", 1, elder.span, elder.who)
            reading.did(at, "people")
            return
    who = kin(token.text) if not token.plural and count == 1 else ""
    if who and _is_same_person(reading, who, at):
        reading.did(at, "people")
        return
    named_again = any(t.text in ("the",) for t in before) and any(p.role == role for p in reading.people)
    again = _said_again(reading, role, at)
    if not (named_again or again):
        reading.people.append(Person(role, count, token.span, who))
    reading.did(at, "people")
    number_done(reading, at)


def _in_one_room(tokens: tuple[Token, ...], at: int, sentence: range) -> bool:
    """Whether children are told to have one room for all of them."""
    said = " ".join(t.text for t in tokens[at + 1 : min(at + 7, sentence.stop)])
    shares = said.split()[:1] in (["share"], ["sharing"], ["together"]) or " together" in said or "share" in said
    return shares and any(words in said for words in ("one room", "a room", "one bedroom", "a bedroom", "same room"))


def names_thing(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether people only say what kind of thing follows: "guest chairs", "baby bath"."""
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    return after is not None and not tokens[at].plural and not tokens[at].has("me", "we") and is_thing(after)


def before_article(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether an article, a number or an owner stands before a word."""
    return bool(at) and (tokens[at - 1].number is not None or tokens[at - 1].text in _OWNERS)


def _said_again(reading: Reading, role: str, at: int) -> bool:
    """Whether the same people were named before: "the boys" of three boys, "my son" after two kids."""
    tokens = reading.tokens
    kin = {"children": ("children", "twins", "babies"), "babies": ("babies", "children")}.get(role, (role,))
    there = [p for p in reading.people if p.role in kin]
    if not there:
        return False
    if any(t.text in ("the", "those", "both") for t in tokens[max(0, at - 2) : at]):
        return True
    if role not in ("children", "babies"):
        return False
    if tokens[at].plural:
        return at > 0 and tokens[at - 1].breaks  # "..., boys together"
    start = tokens[at].span.start
    many = [p for p in there if p.count > 1 and reading.text[p.span.start : p.span.end].lower() in _COLLECTIVE]
    own = at > 0 and tokens[at - 1].text in _OWNERS
    return own and any(t.breaks for p in many for t in tokens if p.span.end <= t.span.start < start)


def _is_same_person(reading: Reading, who: str, at: int) -> bool:
    """Whether somebody was told before: "my mother ... mum ... Gran"; "my mother and my grandmother" are two."""
    tokens = reading.tokens
    alike = [p for p in reading.people if p.who and (p.who == who or {p.who, who} <= {*ELDER} and _is_bare(tokens, at))]
    if not alike:
        return False
    before = next((t for t in reversed(tokens[max(0, at - 3) : at]) if t.text in (*_NEW, "and", "&") or t.breaks), None)
    if before is not None and before.text in _NEW:
        return False
    told = {plain(reading.text[p.span.start : p.span.end]) for p in alike}
    listed = before is not None and before.text in ("and", "&")
    owned = at > 0 and tokens[at - 1].text in ("my", "our")
    if tokens[at].text not in told and owned and who not in ("mother", "father", "partner"):
        return False
    grand = tokens[at].text.startswith("gr") != any(word.startswith("gr") for word in told)
    return not (listed and tokens[at].text not in told) and not (grand and owned and not _is_kin_of_told(told))


def _is_bare(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether nobody's elder is called by a name alone: "Gran's room", "mum"."""
    return not at or tokens[at - 1].text not in ("my", "our", "his", "her", "their", "a", "the")


def _is_kin_of_told(told: set[str]) -> bool:
    """Whether those who were told are called as children call them, so that another word may be for the same ones."""
    return bool(told & {"gran", "granny", "nana", "oma", "opa", "grandad", "granddad", "grandpa", "grandma"})


def _only_visits(tokens: tuple[Token, ...], at: int) -> bool:
    """ "My brother who visits", "a friend that often visits"."""
    said = [t.text for t in tokens[at + 1 : at + 5]]
    return said[:1] in (["who"], ["that"]) and bool({"visit", "visits", "visiting"} & {*said[1:]})


def _we_are(reading: Reading, at: int) -> bool:
    """ "We are five", "there are four of us"."""
    tokens = reading.tokens
    if tokens[at].text in ("we", "we're"):
        k = at + 1 + (tokens[at].text == "we" and at + 1 < len(tokens) and tokens[at + 1].text == "are")
        follows = tokens[k + 1] if k + 1 < len(tokens) else None
        if k < len(tokens) and tokens[k].get("number") and (follows is None or follows.breaks):
            reading.household = int(tokens[k].get("number"))
            reading.did(k, "people")
            reading.did(at, "people")
            return True
    before = tokens[at - 2 : at] if at > 1 else []
    if tokens[at].text == "us" and len(before) == 2 and before[0].get("number") and before[1].text == "of":
        reading.household = int(before[0].get("number"))
        reading.did(at - 2, "people")
        return True
    return False


def _visits(reading: Reading, at: int, sentence: range) -> bool:
    tokens = reading.tokens
    near = {tokens[k].text for k in range(max(sentence.start, at - 6), min(at + 6, sentence.stop))}
    return bool(near & {*_STAYS}) or tokens[at].text.startswith("grand") or tokens[at].text in ("visitors", "visitor")


def count_before(tokens: tuple[Token, ...], at: int) -> int | None:
    """How many, by the number, article or owner before people; None where nothing tells it."""
    for k in range(at - 1, max(-1, at - 5), -1):
        token = tokens[k]
        if token.breaks or token.has("room", "use", "joint") and not token.has("own", "size"):
            return None
        if token.get("number") is not None:
            return int(token.get("number"))
        if token.text in ("a", "an", "another"):
            return 1
        if token.text in _OWNERS and not tokens[at].plural:
            return 1
        if token.has("person") and not token.text.endswith(("'s", "s'")) and token.get("person") not in ("adults",):
            return None
    return None


def number_done(reading: Reading, at: int) -> None:
    """The number before people is accounted for."""
    for k in range(at - 1, max(-1, at - 4), -1):
        if reading.tokens[k].get("number") is not None:
            reading.did(k, "people")
            return


def in_singular(token: Token) -> str:
    """A token with its last word in the singular."""
    from sceneweaver.assets.plurals import singular

    head, _, last = token.text.rpartition(" ")
    return f"{head} {singular(last) if token.plural else last}".strip()
