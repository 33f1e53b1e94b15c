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
    """A word for a storey is said of the rooms behind it where a clause begins with it, else of those before it."""
    tokens = reading.tokens
    words = [k for k in sentence if tokens[k].has("storey") and not any(n.first <= k <= n.last for n in reading.named)]
    names = sorted((one for one in reading.named if one.at in sentence), key=lambda one: one.at)
    for number, k in enumerate(words):
        if reading.use_at is not None and _is_of_home(reading, k):
            reading.did(k, "storeys")
            continue
        start = k
        while start > sentence.start and tokens[start - 1].text in ("in", "on", "at", "the", "its", "to"):
            start -= 1
        before = tokens[start - 1] if start > sentence.start else None
        after = tokens[k + 1] if k + 1 < sentence.stop else None
        lead = (
            before is None
            or before.breaks
            or before.text in ("and", "with", "the", "then")
            and (after is not None and not after.breaks and after.text != "and")
        )
        if after is None or after.breaks and after.text != ":":
            lead = False  # "..., ground floor, ..."
        behind = [one for one in names if one.at > k]
        ahead = [one for one in names if one.at < k]
        until = words[number + 1] if number + 1 < len(words) else sentence.stop
        if after is not None and (after.text in ("for", "is") or after.breaks and after.text == ":"):
            lead = bool([one for one in behind if one.at < until])
        if lead and (found := [one for one in behind if one.at < until]):
            chosen = found
        elif ahead:
            chosen = _joined(reading, ahead, k)
        else:
            chosen = []
        for one in chosen:
            one.storey = one.storey or tokens[k].get("storey")
        if chosen:
            reading.did(k, "storeys")


def _is_of_home(reading: Reading, at: int) -> bool:
    """Whether the home itself is on a storey of a building: "a ground floor flat", "an office on the first floor"."""
    tokens, use_at = reading.tokens, reading.use_at
    if use_at is None or reading.use.plan == "house":
        return False
    between = range(min(at, use_at) + 1, max(at, use_at))
    if any(tokens[k].breaks or any(one.first <= k <= one.last for one in reading.named) for k in between):
        return False
    return at == use_at - 1 or (at > use_at and len(between) <= 2)


def _joined(reading: Reading, ahead: list[Named], at: int) -> list[Named]:
    """The rooms right before a word: the last one, and those of its list where "and" ends that."""
    tokens = reading.tokens
    chosen = [ahead[-1]]
    listed = False
    for one in reversed(ahead[:-1]):
        gap = [t for t in tokens[one.last + 1 : chosen[-1].first]]
        if any(t.text == "and" for t in gap) and len(gap) <= 2:
            listed = True
        elif not (listed and len(gap) == 1 and gap[0].text == ","):
            break
        chosen.append(one)
    return chosen
