"""As many rooms as people: "each couple needs a bedroom", "three doctors with a consulting room each"."""

from __future__ import annotations

import math

from .households import count_before, in_singular, names_thing, number_done
from .parts import Named, Reading
from .residents import people_told
from .tokens import Token


def read_each(reading: Reading) -> None:
    """ "Each couple needs a bedroom", "three doctors with a consulting room each": as many rooms as people."""
    tokens = reading.tokens
    _for_every(reading)
    for at, token in enumerate(tokens):
        if token.text not in ("each", "every", "everyone", "everybody", "for each", "per"):
            continue
        pronoun = next((one for one in reading.named if one.of is not None and one.at == at), None)
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        who = after is not None and after.has("person", "staff", "groups")
        before = next((one for one in reversed(reading.named) if one.last == at - 1 and one.of is None), None)
        number = _people_before(reading, at, tokens[at + 1] if who else None)
        behind_one = before is not None and before.told in ("article", "") and before.count == 1
        if number is None or (not behind_one and pronoun is not None and not _people_nearer(reading, at, pronoun)):
            continue
        if behind_one and before is not None:
            _drop(reading, pronoun)
            for one in _listed_before(reading, before):
                one.times = number
            reading.did(at, "people")
            if who:
                reading.did(at + 1, "people")
        elif (
            who
            or after is not None
            and after.text in ("has", "have", "gets", "get", "needs", "with", "in", "their", "his", "her", "own")
        ):
            for one in _told_of(reading, at):
                one.times = number
                if one.of is not None and one.per is None:
                    one.of = None
            _drop(reading, pronoun)
            reading.did(at, "people")
            if who:
                reading.did(at + 1, "people")


def _for_every(reading: Reading) -> None:
    """ "A bathroom for every two of them": so many rooms as make that of all who live or work there."""
    tokens = reading.tokens
    people = people_told(reading) or reading.household or reading.workers
    for at, token in enumerate(tokens[:-1]):
        number = tokens[at + 1].get("number")
        room = next((one for one in reversed(reading.named) if one.last < at), None)
        if token.text not in ("every", "per", "each") or not number or not people or room is None:
            continue
        if [t.text for t in tokens[room.last + 1 : at]] in ([], ["for"]) and room.told in ("article", ""):
            room.times = math.ceil(people / number)
            for k in range(room.last + 1, min(at + 4, len(tokens))):
                if not tokens[k].breaks:
                    reading.did(k, "people")


def _drop(reading: Reading, pronoun: Named | None) -> None:
    """Forget an "each" that was taken for rooms."""
    if pronoun is not None:
        reading.named.remove(pronoun)
        reading.joints = [j for j in reading.joints if j.a is not pronoun and j.b is not pronoun]


def _listed_before(reading: Reading, last: Named) -> list[Named]:
    """A room and those that "and" joins to it, where all have an article."""
    found = [last]
    for one in reversed([o for o in reading.named if o.at < last.at]):
        gap = [t.text for t in reading.tokens[one.last + 1 : found[-1].first]]
        if gap not in (["and"], ["&"], [","]) or one.told != "article" or one.count != 1:
            break
        found.append(one)
    return found


def _people_before(reading: Reading, at: int, who: Token | None) -> int | None:
    """How many people an "each" means: those who were counted last, of the kind that follows it."""
    tokens = reading.tokens
    if who is None and at > 2 and tokens[at - 1].has("person") and not tokens[at - 1].plural:
        listed = [t for t in tokens[max(0, at - 6) : at] if t.has("person") and not t.plural]
        if len(listed) > 1 and any(t.text in ("and", "&") for t in tokens[at - 4 : at]):
            return len(listed)  # "the son and the daughter each have ..."
    for k in range(at - 1, max(-1, at - 30), -1):
        if (
            not tokens[k].has("person", "staff", "groups")
            or tokens[k].text.endswith(("'s", "s'"))
            or names_thing(tokens, k)
        ):
            continue
        if (
            who is not None
            and who.get("person") != tokens[k].get("person")
            and in_singular(tokens[k]) != in_singular(who)
        ):
            continue
        number = count_before(tokens, k)
        if number is not None and number > 1:
            number_done(reading, k)
            return number
    return None if who is not None else reading.household


def _people_nearer(reading: Reading, at: int, pronoun: Named) -> bool:
    """Whether the people stand nearer to an "each" than the rooms that it might mean."""
    tokens, room = reading.tokens, pronoun.root.at
    return any(tokens[k].has("person", "staff") and (count_before(tokens, k) or 0) > 1 for k in range(room + 1, at))


def _told_of(reading: Reading, at: int) -> list[Named]:
    """The rooms that each one has: to the end of the clause, those with an article."""
    found: list[Named] = []
    for one in reading.named:
        if one.at > at and one.of is None and one.told in ("article", "") and one.count == 1 and one.per is None:
            if any(t.breaks for t in reading.tokens[at : one.first]):
                break
            found.append(one)
    return found
