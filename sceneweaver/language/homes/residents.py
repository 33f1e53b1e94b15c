"""Who lives in a home, all in all: families, couples, the speaker; how many, and which bedrooms they need."""

from __future__ import annotations

from .lexicon import data
from .parts import Person, Reading

_ROLE = {
    "couples": "couple",
    "adults": "adult",
    "seniors": "senior",
    "children": "child",
    "twins": "twins",
    "babies": "baby",
}


_ELDERS = ("mother", "father", "mother-in-law", "father-in-law")


def settle(reading: Reading) -> None:
    """Adults of a family that names its children, and partners as couples."""
    roles = {person.role for person in reading.people}
    found = list[Person]()
    for person in reading.people:
        if person.role == "partners":
            person = Person("couples", 1, person.span)
            found = [p for p in found if p.role != "couples"]
        if person.role == "families":
            if "couples" not in roles and "partners" not in roles and "adults" not in roles:
                found.append(Person("couples", 1, person.span))
            if not roles & {"children", "twins", "babies"}:
                children = 2 if reading.household is None else max(0, reading.household - 2)
                if children:
                    found.append(Person("children", children, person.span))
            continue
        found.append(person)
    spoken = {token.text for token in reading.tokens}
    elders = [p for p in found if p.role == "adults" and p.who in _ELDERS and not _is_called_one(reading, p)]
    elders = [] if _is_speaker(reading) else elders
    if (
        not any(p.role in ("couples", "adults") and p not in elders for p in found)
        and found
        and reading.use.plan in ("flat", "house")
    ):
        we, me = bool(spoken & {"we", "us", "our", "we're", "we'd"}), bool(spoken & {"i", "me", "my", "i'm", "myself"})
        if we and any(p.role in ("children", "twins", "babies", "seniors") for p in found):
            found.insert(0, Person("couples", 1, found[0].span))
        elif me and not we or elders and (me or _speaker_counts(reading)):
            found.insert(0, Person("adults", 1, found[0].span))
    elif {p.role for p in found} & {"adults", "couples"} == {"adults"} and _speaker_counts(reading):
        found.append(Person("adults", 1, found[0].span))
    reading.people = found


def _is_called_one(reading: Reading, person: Person) -> bool:
    """Whether an adult is told as one of many: "a single mum", and not "my mum"."""
    before = reading.text[: person.span.start].lower().split()
    return bool(before) and before[-1] in ("a", "an", "single", "divorced", "widowed", "working", "lone")


def _speaker_counts(reading: Reading) -> bool:
    """Whether the speaker lives there beside the others: "for my brother and me"."""
    tokens = reading.tokens
    if _is_speaker(reading):
        return False
    for at, token in enumerate(tokens):
        if (
            token.text == "me"
            and at
            and (tokens[at - 1].text in ("and", "for", "&") or at + 1 < len(tokens) and tokens[at + 1].text == "and")
        ):
            return True
        if token.text == "i" and at and tokens[at - 1].text == "and":
            return True
    return False


def _is_speaker(reading: Reading) -> bool:
    """Whether an adult who is named is the speaker: "single mum here", "I am a lawyer"."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if token.get("person") != "adults":
            continue
        before = {t.text for t in tokens[max(0, at - 4) : at]}
        if at + 1 < len(tokens) and tokens[at + 1].text == "here" or before & {"i'm", "am", "i am"}:
            return True
    return False


def bedrooms_for(reading: Reading) -> list[tuple[str, int]]:
    """Kinds of bedrooms with their number, for those who live there."""
    found: dict[str, int] = {}
    rows = data("people")["bedrooms"]
    for person in reading.people:
        role = _ROLE.get(person.role)
        if role is None:
            continue
        count = person.count
        if role == "child" and reading.together:
            count = 0 if found.get(rows[role]["kind"]) else 1
        elif role == "child" and reading.share and count > 1:
            count = (count + 1) // 2
        kind = rows[role]["kind"]
        found[kind] = found.get(kind, 0) + count * rows[role]["each"]
    told = people_told(reading)
    if reading.household is not None and told is not None and told < reading.household:
        kind = "childrens_room" if "master_bedroom" in found else "bedroom"
        found[kind] = found.get(kind, 0) + reading.household - told
    if reading.household is not None and not reading.people:
        found["bedroom"] = reading.household
    return list(found.items())


def people_told(reading: Reading) -> int | None:
    """How many live there by those who are named; None where nobody is."""
    many = {"couples": 2, "twins": 2}
    total = sum(person.count * many.get(person.role, 1) for person in reading.people)
    return total or None
