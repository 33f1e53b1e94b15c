"""What is said that is no demand: greetings, names, ages, reasons, what people say of themselves without a wish."""

from __future__ import annotations

from sceneweaver.language.vocabulary import vocabulary

from .lexicon import data, plain
from .parts import Reading
from .tokens import Token

OLDEST = 115
"""Years up to which a number may be somebody's age."""

WHO = 5
"""Tokens at most of what is said of somebody before the word for him."""

NEAR = 4
"""Tokens between a name and the person who has it."""


def is_remark(reading: Reading, clause: range) -> bool:
    """Whether a clause is plainly no demand; in doubt it is one."""
    tokens, words = reading.tokens, data("remarks")
    said = [tokens[k].text for k in clause]
    begin = next((k for k in range(len(said)) if said[k] not in words["lead"]), 0)
    if _is_greeting(reading, clause):
        return True
    if said[0] in words["reasons"] and (
        said[0] not in ("as", "since") or len(said) > 1 and _is_person(tokens, clause[1])
    ):
        return True
    if said[begin] in words["to_you"] and any(k in said for k in ("you", "me")) and not _of_home(reading, clause):
        return True
    if not _is_person(tokens, clause[begin]):
        return False
    rest = [word for text in said[begin:] for word in text.split()]
    if {"hope", "hoping"} & {*rest}:
        return not _of_home(reading, clause) and bool({"move", "moving", "you", "this", "hear"} & {*rest})
    fond = [k for k, word in enumerate(rest[:-1]) if word in ("love", "like", "enjoy", "adore", "loves", "likes")]
    if fond and rest[fond[0] + 1].endswith("ing") and not {"would", "to"} & {*rest} and len(rest) < 8:
        return True
    if (
        {*words["wishes"]} & {*rest}
        or any(word.endswith("n't") for word in rest)
        or any(tokens[k].has("no") for k in clause)
    ):
        return False
    return not _of_home(reading, clause)


def is_of_person(reading: Reading, clause: range, phrase: range) -> bool:
    """Whether a phrase only says what somebody is or does: "our teenage daughter", "two nurses who work nights"."""
    tokens, words = reading.tokens, data("remarks")
    if {word for k in phrase for word in tokens[k].text.split()} & {*words["wishes"]}:
        return False
    last = tokens[phrase.stop - 1]
    if last.has("person", "staff") and last.done and len(phrase) <= WHO:
        return True
    who = next((k for k in range(phrase.start - 1, clause.start, -1) if tokens[k].text == "who"), None)
    if who is None or not tokens[who - 1].has("person", "staff", "visitors", "we", "me"):
        return False
    said = {word for k in range(who, phrase.stop) for word in tokens[k].text.split()}
    return not said & {*words["wishes"]} and not any(tokens[k].has("no") for k in range(who, phrase.stop))


def mark_persons(reading: Reading) -> None:
    """Says of ages, and of names of those who are told, that nothing is asked for by them."""
    for at, token in enumerate(reading.tokens):
        if token.done:
            continue
        if _is_age(reading, at):
            reading.did(at, "age")
        elif _is_name(reading, at):
            reading.did(at, "name")


def _is_greeting(reading: Reading, clause: range) -> bool:
    tokens, words = reading.tokens, data("remarks")["greetings"]
    said = [tokens[k] for k in clause]
    if any(t.done for t in said):
        return False
    if said[0].text in ("dear", "hello", "hi", "hey", "hiya") and len(said) < 5:
        return True
    meant = [w for t in said if not t.has("function") or t.text in words for w in t.text.split()]
    if meant and all(word in words for word in meant):
        return True
    last = not any(any(c.isalnum() for c in t.text) for t in tokens[clause.stop :])
    return last and len(said) <= 3 and all(_is_capital(reading, t) and not t.kinds for t in said) and clause.start > 0


def _is_person(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether somebody who lives there, or the speaker, is what a clause begins with."""
    token = tokens[at]
    if token.text.split()[0] in data("remarks")["persons"] or token.done == "name":
        return True
    if token.has("person") and not token.text.endswith(("'s", "s'")):
        return True
    owner = token.text in ("my", "our", "his", "her", "their", "the", "both", "one", "two")
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    if owner and after is not None and (after.has("person") or after.done == "name"):
        return not after.text.endswith(("'s", "s'"))
    past = at + 2 < len(tokens) and tokens[at + 2].text.endswith("ed") and not tokens[at + 2].done
    return token.text in ("my", "our") and past and not tokens[at + 1].done


def _of_home(reading: Reading, clause: range) -> bool:
    """Whether a clause tells of rooms, things or places of a home."""
    told = ("rooms", "joint", "storeys", "area", "envelope", "profile", "light", "request", "not wanted")
    return any(reading.tokens[k].done.split(" ")[0] in told or reading.tokens[k].has("place") for k in clause)


def _is_age(reading: Reading, at: int) -> bool:
    """ "My father (82)", "aged 4 and 7", "two years old", "mum is 79"."""
    tokens = reading.tokens
    token = tokens[at]
    before, after = (tokens[at - 1] if at else None), (tokens[at + 1] if at + 1 < len(tokens) else None)
    words = data("remarks")["ages"]
    if token.text in words:
        return any(t.done == "age" or t.get("number") is not None for t in tokens[max(0, at - 3) : at + 3])
    number = token.get("number")
    if number is None or number > OLDEST or before is None:
        return False
    if before.text in words or after is not None and after.text in words and after.text not in ("age", "old"):
        return True
    ends = after is None or after.breaks or after.text in ("and", "&", "but", "or")
    if not ends:
        return False
    if before.text in ("and", ",", "&") and any(t.done == "age" for t in tokens[max(0, at - 2) : at]):
        return True
    near = tokens[max(0, at - 4) : at]
    person = any(t.has("person", "me", "we") or t.done in ("people", "name") for t in near)
    persons = person or any(t.text in data("remarks")["persons"] for t in near)
    return persons and before.text in ("(", ",", "is", "are", "am", "i'm", "he's", "she's", "we're", "they're", "was")


def _is_name(reading: Reading, at: int) -> bool:
    """Whether a word that nobody knows is the name of somebody who is told beside it."""
    tokens = reading.tokens
    token = tokens[at]
    if (
        token.kinds
        or not token.text.isalpha()
        or not _is_capital(reading, token)
        or vocabulary().get(plain(token.text))
    ):
        return False
    alike = [k for k, t in enumerate(tokens) if t.text in (token.text, f"{token.text}'s")]
    return any(_beside_person(tokens, k) or tokens[k].done == "name" for k in alike)


def _beside_person(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether a person, "I'm" or "called" stands beside a word."""
    low, high = max(0, at - NEAR), min(len(tokens), at + NEAR)
    near = [tokens[k] for k in range(low, high) if k != at]
    if any(t.stops for t in tokens[low:at]):
        near = [tokens[k] for k in range(at + 1, high)]
    told = ("i'm", "we're", "i am", "called", "named", "name", "dear", "regards", "cheers")
    return any(t.has("person") and t.text != "single" or t.text in told or t.done == "name" for t in near)


def _is_capital(reading: Reading, token: Token) -> bool:
    return reading.text[token.span.start : token.span.start + 1].isupper()
