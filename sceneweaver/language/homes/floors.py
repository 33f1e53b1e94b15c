"""Storeys: how many a home has, and on which of them rooms are."""

from __future__ import annotations

from .mentions import is_thing
from .parts import Named, Reading

_ALL = ("all", "both")


def read_floors(reading: Reading) -> None:
    """Reads how many storeys a home has, and puts rooms on those that are told."""
    tokens = reading.tokens
    for at, token in enumerate(tokens):
        if token.has("storey_words") and not token.done:
            _count(reading, at)
        elif token.has("single_storey") and not token.done:
            reading.one_storey = True
            reading.rows.append((token.span, "storeys", "1 storey"))
            reading.did(at, "storeys")
    named = reading.use.storeys
    if reading.use_at is not None and reading.storeys is None:
        word = tokens[reading.use_at].text
        reading.storeys = named.get(word)
        if word == "bungalow":
            reading.one_storey = True
    for sentence in reading.sentences():
        _place(reading, sentence)


def _count(reading: Reading, at: int) -> None:
    """ "Two-storey", "on two floors", "three floors"; "both storeys" are two."""
    tokens = reading.tokens
    before = tokens[at - 1] if at else None
    number = before.number if before is not None else None
    if before is not None and before.text == "both":
        number = 2
    if number is None or not 1 <= number <= 6 or before is None or before.text in ("a", "an"):
        return
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    single = tokens[at].text in ("floor", "level", "storey", "story", "storied", "storeyed")
    if single and number > 1 and not (before.glued or after is not None and after.has("use")):
        return  # "two floor lamps"
    if not single and after is not None and is_thing(after):
        return
    if any(t.text in ("its", "their") for t in tokens[max(0, at - 3) : at]):
        return  # "on its three levels"
    reading.storeys = max(reading.storeys or 0, number)
    if number == 1:
        reading.one_storey = True
    reading.rows.append((tokens[at].span, "storeys", f"{number} storeys"))
    for k in (at - 1, at):
        reading.did(k, "storeys")


def _place(reading: Reading, sentence: range) -> None:
    """A word for a storey is said of the rooms behind it where a clause begins with it, else of those before it.

    Rooms that stand right before a word which begins no clause belong to that word, whatever word stands before them.
    """
    tokens = reading.tokens
    words = [k for k in sentence if tokens[k].has("storey") and not any(n.first <= k <= n.last for n in reading.named)]
    names = sorted((one for one in reading.named if one.at in sentence), key=lambda one: one.at)
    leads = list[tuple[int, list[Named]]]()
    for number, k in enumerate(words):
        if reading.use_at is not None and _is_of_home(reading, k):
            reading.did(k, "storeys")
            continue
        if _over_room(reading, sentence, names, k) or _sleepers(reading, sentence, k):
            continue
        until = words[number + 1] if number + 1 < len(words) else sentence.stop
        _whole_flat(reading, k, until)
        behind, ahead = [n for n in names if k < n.at < until], [n for n in names if n.at < k]
        if behind and _leads(reading, sentence, names, k):
            leads.append((k, behind))
        elif not behind and reading.live_storey and _is_whole_flat(reading, k, until):
            reading.did(k, "storeys")  # "..., upstairs a flat": nothing of the rooms before
        elif ahead and _of_people(reading, ahead[-1], k):
            reading.sleep_storey = reading.sleep_storey or tokens[k].get("storey")
            reading.did(k, "storeys")
        elif ahead:
            _put(reading, k, _joined(reading, ahead, max((at for at, _ in leads), default=-1)))
    for k, behind in leads:
        _put(reading, k, behind)


def _put(reading: Reading, at: int, rooms: list[Named]) -> None:
    for one in rooms:
        one.storey = one.storey or reading.tokens[at].get("storey")
    reading.did(at, "storeys")


def _leads(reading: Reading, sentence: range, names: list[Named], at: int) -> bool:
    """Whether a clause begins with a word for a storey, which then is said of what follows."""
    tokens = reading.tokens
    start = at
    while start > sentence.start and tokens[start - 1].text in ("in", "on", "at", "the", "its", "to"):
        start -= 1
    before = tokens[start - 1] if start > sentence.start else None
    after = tokens[at + 1] if at + 1 < sentence.stop else None
    if after is None or after.breaks and after.text != ":":
        return False  # "..., ground floor, ..."
    if after.text in ("for", "is", ":"):
        return True
    if before is None or before.breaks:
        return True
    if before.text in ("and", "with", "the", "then") and after.text != "and":
        return True
    clause = max((k for k in range(sentence.start, at) if tokens[k].breaks), default=sentence.start - 1)
    alone = not any(clause < one.at < at for one in names)
    return alone and after.text in (
        "with",
        "in",
        "has",
        "have",
        "holds",
        "contains",
        "houses",
    )  # "she gets the top with ..."


def _of_people(reading: Reading, last: Named, at: int) -> bool:
    """ "... and the four of us on the upper floor": said of who lives there, and not of the room before."""
    gap = reading.tokens[last.last + 1 : at]
    parts = [k for k, token in enumerate(gap) if token.breaks or token.text == "and"]
    return (
        bool(parts)
        and any(t.has("we", "me", "person") for t in gap[parts[-1] :])
        and not any(t.has("room") for t in gap[parts[-1] :])
    )


def _over_room(reading: Reading, sentence: range, names: list[Named], at: int) -> bool:
    """ "The bedroom above the garage", "I want to live above the shop": one is upstairs, the other below."""
    tokens = reading.tokens
    way = tokens[at].text
    k = at + 1
    while k < sentence.stop and tokens[k].text in ("the", "our", "my", "his", "her", "their", "a"):
        k += 1
    other = next((one for one in reading.named if one.first <= k <= one.last), None) if k < sentence.stop else None
    if way not in ("above", "below") or other is None or k == at + 1 and not other.definite:
        return False
    clause = max((j for j in range(sentence.start, at) if tokens[j].breaks), default=sentence.start - 1)
    ahead = [one for one in names if clause < one.at < at]
    high, low = ("upper", "ground") if way == "above" else ("ground", "upper")
    if ahead:
        ahead[-1].storey = ahead[-1].storey or high
    elif any(t.text in ("live", "living", "lives") or t.has("use") for t in tokens[clause + 1 : at]):
        reading.live_storey = reading.live_storey or high
    else:
        return False
    other.storey = other.storey or low
    reading.did(at, "storeys")
    return True


def _sleepers(reading: Reading, sentence: range, at: int) -> bool:
    """ "Upstairs everybody sleeps", "all of us sleep on the upper floor": where all bedrooms are."""
    tokens = reading.tokens
    start = max((k + 1 for k in range(sentence.start, at) if tokens[k].breaks), default=sentence.start)
    stop = min((k for k in range(at + 1, sentence.stop) if tokens[k].breaks), default=sentence.stop)
    said = {tokens[k].text for k in range(start, stop)}
    everyone = {"all", "everybody", "everyone", "we"} & said
    if not everyone or not {"sleep", "sleeps", "sleeping"} & said:
        return False
    reading.sleep_storey = reading.sleep_storey or tokens[at].get("storey")
    for k in range(start, stop):
        if tokens[k].text in ("sleep", "sleeps", "sleeping"):
            reading.did(k, "storeys")
    reading.did(at, "storeys")
    return not any(start <= one.at < stop for one in reading.named) and stop == sentence.stop


def _whole_flat(reading: Reading, at: int, until: int) -> None:
    """ "Upstairs a flat for us": what a flat has besides is there as well."""
    if _is_whole_flat(reading, at, until):
        reading.live_storey = reading.live_storey or reading.tokens[at].get("storey")


def _is_whole_flat(reading: Reading, at: int, until: int) -> bool:
    tokens = reading.tokens
    return any(tokens[k].has("use") and tokens[k].text in ("flat", "apartment") for k in range(at + 1, until))


def _is_of_home(reading: Reading, at: int) -> bool:
    """Whether the home itself is on a storey of a building: "a ground floor flat", "an office on the first floor"."""
    tokens, use_at = reading.tokens, reading.use_at
    if use_at is None or reading.use.plan == "house":
        return False
    between = range(min(at, use_at) + 1, max(at, use_at))
    if any(tokens[k].breaks or any(one.first <= k <= one.last for one in reading.named) for k in between):
        return False
    return at == use_at - 1 or (at > use_at and len(between) <= 2)


def _joined(reading: Reading, ahead: list[Named], led: int) -> list[Named]:
    """The rooms right before a word: the last one, and those of its list where "and" ends that; behind the word number
    ``led``, which a clause began with, a comma ends the list as well."""
    tokens = reading.tokens
    chosen = [ahead[-1]]
    listed = False
    for one in reversed(ahead[:-1]):
        gap = [t for t in tokens[one.last + 1 : chosen[-1].first]]
        if one.at > led >= 0 and any(t.breaks for t in gap):
            break
        if any(t.text == "and" for t in gap) and len(gap) <= 2:
            listed = True
        elif not (listed and len(gap) == 1 and gap[0].text == ","):
            break
        chosen.append(one)
    return chosen
