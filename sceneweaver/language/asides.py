"""What people do or may do, said by the way: "where we can read", "she can't reach them". It names nothing.

Works on tokens: the words of such a clause become one token of the kind ``aside``, whose value is "clause" when it says
who does it, else "verb". What follows with a word of place is read on: "where I can read next to a lamp" has a lamp.
"""

from __future__ import annotations

from .tokens import Token
from .vocabulary import words

_OWN = ("person", "modal", "action", "trade", "passive", "unit")
"""Kinds of words that are looked at here alone."""

_OPEN = ("modal", "adverbs")
_OBJECTS = (
    "it",
    "them",
    "him",
    "her",
    "me",
    "us",
    "you",
    "everything",
    "anything",
    "something",
    "this",
    "that",
    "each other",
    "myself",
    "ourselves",
    "yourself",
    "himself",
    "herself",
    "themselves",
)
_SELDOM = ("can", "will", "may", "might", "must")
"""Modal verbs that are nouns as well: a can is one after an article, a number or a word of quality."""

_BEFORE_NOUNS = ("det", "number", "amount", "color", "material", "adjective", "scale", "shape", "each", "bound")
_MOST_OPEN = 12
"""Words between who does something and what: "people who will then also still have to sit"."""
_SUBJECTS = ("i", "we", "they", "you", "he", "she")
_NO_DEEDS = ("action", "verb", "stop", "people_words", "det", "number")
_MOST_BARE = 4
"""Words of the name of a thing of a trade at most."""
_POSSESSIVE = ("my", "our", "your", "their", "his", "her", "its")
_WISHES = ("person", "modal")
_IN_SIMILES, _ARTICLES = ("in", "on", "at", "from", "inside"), ("a", "an", "old", "some", *_POSSESSIVE)


def without_asides(tokens: list[Token]) -> list[Token]:
    """The tokens with each clause about people, each modal verb and each simile as one token."""
    found: list[Token] = []
    at = 0
    while at < len(tokens):
        end, value = _aside(tokens, at)
        if end > at:
            found.append(_joined(tokens[at:end], value))
            at = end
            continue
        found.append(_plain(tokens, at))
        at += 1
    return found


def _aside(tokens: list[Token], at: int) -> tuple[int, str]:
    """The end of the aside that begins at a token, and what it is; ``at`` itself where none does."""
    if tokens[at].has("aside"):
        return at + 1, "verb"
    if (opened := _opened_simile(tokens, at)) > at:
        return _end_of_simile(tokens, opened), "verb"
    first = at + 1 if tokens[at].has("person") and not _is_noun(tokens, at) else at
    of_people = first == at and tokens[at].has("people_words", "whom") and not _is_noun(tokens, at)
    if of_people:  # "walkers need", "both groups can see"
        first = at + 1
    k = first
    while k < min(first + _MOST_OPEN, len(tokens)) and tokens[k].has(*_OPEN) and not _is_noun(tokens, k):
        k += 1
    modal = any(t.has("modal") for t in tokens[first:k])
    if (first > at or of_people) and (end := _end_of_trade(tokens, k)) > k:
        return end, "clause"
    if tokens[at].text in _SUBJECTS and (end := _end_of_deed(tokens, at, k)) > k:
        return end, "clause"
    if k >= len(tokens) or not _acts(tokens, k, first > at, modal, of_people):
        return at, ""
    end = _end(tokens, k + 1, first > at)
    if (first > at or of_people) and end == k + 1 and _is_by_place(tokens[k]):
        end = _end_of_bare(tokens, end)  # "I ladle soup"
    return end, "clause" if first > at else "verb"


def _is_by_place(token: Token) -> bool:
    """Whether a token is a verb by where it stands alone (see `parts_of_speech`)."""
    return token.kinds.keys() == {"action"}


def _end_of_trade(tokens: list[Token], k: int) -> int:
    """The end of what somebody does to things of a trade ("I repair old clocks and radios"); ``k`` itself for none.

    The things have no article and no number: "we build a shelf" may ask for one.
    """
    if k >= len(tokens) or tokens[k].get("trade") not in ("base", "s", "ed"):
        return k
    end = _end_of_bare(tokens, k + 1)
    if end == k + 1:
        return k
    while end < len(tokens) and tokens[end].has("and"):
        form = tokens[k].get("trade")
        again = end + 1 < len(tokens) and tokens[end + 1].get("trade") == form  # "and bind books"
        more = _end_of_bare(tokens, end + 1 + again)
        if more == end + 1 + again or not (more >= len(tokens) or _ends_clause(tokens[more])):
            break
        end = more
    return end


def _ends_clause(token: Token) -> bool:
    return token.has("break", "and", "preposition", "while", "aside") or token.text in ("for", "so", "but")


def _end_of_deed(tokens: list[Token], at: int, k: int) -> int:
    """The end of what somebody does by a word that is a noun elsewhere ("where we iron"); ``k`` itself for none.

    Right behind who does it stands no thing; who is no I, you, we and they does it with an s.
    """
    if k >= len(tokens) or not tokens[k].has("noun") or tokens[k].has(*_NO_DEEDS):
        return k
    ends = tokens[k].has("plural") or tokens[k].text.endswith("s")
    if ends != (tokens[at].text in ("he", "she")):
        return k
    return _end_of_bare(tokens, k + 1)


def _end_of_bare(tokens: list[Token], k: int) -> int:
    """The end of a noun without article, the words before it included, that begins at ``k``."""
    end = k
    while end < min(k + _MOST_BARE, len(tokens)) and (
        tokens[end].has("noun", "material", "color", "adjective", "scale", "containers") or not tokens[end].kinds
    ):
        if tokens[end].has("det", "number", "amount", "preposition") or _ends_clause(tokens[end]):
            break
        end += 1
    return end


def _acts(tokens: list[Token], k: int, has_subject: bool, modal: bool, of_people: bool) -> bool:
    """Whether a token is what somebody does there."""
    token = tokens[k]
    if token.has("passive") and modal and not has_subject:
        return True
    form = token.get("action")
    if form is None or (token.has("preposition") and form == "ing"):
        return False
    if of_people and not modal:
        return _is_by_place(token) or (form == "base" and not token.has("noun", "abstract"))
    if not (has_subject or modal):
        return False
    return form in ("base", "s", "ed") or modal


def _end(tokens: list[Token], k: int, has_subject: bool) -> int:
    """The end of what belongs to the verb before ``k``: particles, pronouns, "their coffee"."""
    stops = ("break", "with", "and") if has_subject else ("break",)
    while k < len(tokens):
        token, after = tokens[k], tokens[k + 1] if k + 1 < len(tokens) else None
        plain = token.has("adverbs") and not token.has("noun", "preposition")
        if token.text in _OBJECTS or plain or (token.has("unit") and not token.has("noun", "preposition")):
            k += 1
        elif token.text in _POSSESSIVE and after is not None and not after.has("break", "preposition"):
            k += 2
        elif token.has("and") and after is not None and after.get("action") == "base":
            k += 2  # "where you can sit and read"
        elif token.has("preposition") and (after is None or after.has(*stops) or _is_participle(after)):
            k += 1  # "they have to get past with prams", "a chair to read in"
        elif not token.kinds and token.text.isalpha():
            k += 1
        else:
            break
    return k


def _is_participle(token: Token) -> bool:
    """Whether a word says how somebody does something: "a mirror he can see himself in sitting down"."""
    verb = token.get("verb")
    doing = token.get("action") == "ing" or (verb is not None and verb.form == "ing")
    return doing and not token.has("noun", "preposition")


def _is_noun(tokens: list[Token], at: int) -> bool:
    """Whether a word that may be a modal verb or a person stands where a noun does."""
    token, before = tokens[at], tokens[at - 1] if at else None
    if not token.has("noun"):
        return False
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    if after is not None and after.text == "of":
        return True
    if token.text not in _SELDOM:
        return True
    canned = before is not None and before.text.rpartition(" ")[2] in words("asides")["canned"]
    return before is not None and not before.has("while") and (canned or before.has(*_BEFORE_NOUNS))


def _opened_simile(tokens: list[Token], at: int) -> int:
    """Where what something is compared with begins ("like a ship", "reminds me of a ship"); ``at`` where nothing is.

    "I'd like a ship" and "things like cups" are no similes.
    """
    data = words("parts_of_speech")
    if tokens[at].text in data["reminding"]:
        of = next((k for k in (at + 1, at + 2) if k < len(tokens) and tokens[k].text == "of"), None)
        return of + 1 if of is not None and of + 1 < len(tokens) else at
    end = next((at + n for n in (3, 2, 1) if " ".join(t.text for t in tokens[at : at + n]) in data["alike"]), at)
    if end == at or end >= len(tokens) or tokens[end].has("break"):
        return at
    if tokens[at].text not in ("like", "as in", "as if", "as though"):
        return end
    before = tokens[at - 1] if at else None
    if before is None or before.has("break", *_WISHES):
        return at
    return at if before.text in ("something", "things", "stuff", "i'd", "we'd", "d", "would") else end


def _end_of_simile(tokens: list[Token], k: int) -> int:
    """The end of what something is compared with: "in a boat" is of the ship, "in the corner" of the room."""
    first = k
    if tokens[k].has("preposition"):
        k += 1
    while k < len(tokens) and not tokens[k].has("break", "and", "with", "while", "place_adverb"):
        if k > first and tokens[k].has("preposition"):
            after = tokens[k + 1] if k + 1 < len(tokens) else None
            if tokens[k].text not in _IN_SIMILES or after is None or after.text not in _ARTICLES:
                break
        k += 1
    return k


def _plain(tokens: list[Token], at: int) -> Token:
    """A token without the kinds that were looked at here; a modal verb that is no noun is none further on."""
    token = tokens[at]
    gone = set(_OWN)
    if token.text in _SELDOM and not _is_noun(tokens, at):
        gone |= {"noun", "containers", "plural"}
    if not token.kinds.keys() & gone:
        return token
    kinds = {kind: value for kind, value in token.kinds.items() if kind not in gone}
    if token.has("unit") and not kinds:
        kinds = {"matter": token.text}
    elif not kinds and " " in token.text:
        kinds = {"adverbs": token.text}
    return Token(token.text, token.start, token.end, kinds)


def _joined(tokens: list[Token], value: str) -> Token:
    text = " ".join(t.text for t in tokens)
    return Token(text, tokens[0].start, tokens[-1].end, {"aside": value})
