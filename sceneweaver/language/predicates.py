"""Words whose meaning hangs on where they stand: what is said of things in clauses of their own ("the table is round
and made of glass"), numbers behind their nouns ("chairs x8"), fillers ("and like a chair").

Tokens go in and come out; what a word cannot be at its place is taken from it, so that no shape is read as a word of
place and no material as a thing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise, takewhile

from sceneweaver.assets.plurals import singular as _singular

from .chunks import EACH, OPEN, QUALITIES
from .tokens import Token
from .vocabulary import Verb, vocabulary, words

_SAID_OF_THINGS = ("color", "material", "finish", "shape")
_OF_ROOMS = ("room", "place")


def with_predicates(tokens: list[Token]) -> list[Token]:
    """The tokens, each with what it can be at its place."""
    found: list[Token] = []
    at = 0
    while at < len(tokens):
        taken = 0
        for rule in _RULES:
            taken = rule(tokens, at, found)
            if taken:
                break
        if not taken:
            found.append(_fitting(tokens, at))
            taken = 1
        at += taken
    return found


def _token(tokens: list[Token], k: int) -> Token | None:
    return tokens[k] if 0 <= k < len(tokens) else None


def _ends(token: Token | None) -> bool:
    """Whether a list or a clause ends before a token."""
    return token is None or token.has("break", "and", "with", "while")


def _fitting(tokens: list[Token], at: int) -> Token:
    """A token without what it cannot be here: "round" without a target is a shape, "a stand" no verb."""
    token, before, after = tokens[at], _token(tokens, at - 1), _token(tokens, at + 1)
    if token.has("preposition") and token.has("shape"):
        target = after is not None and after.has("det", "pron", "number", "amount", "each", "both")
        things = before is not None and before.has("plural", "noun") and before.text.endswith("s")
        if token.text in ("round", "all round") and things and _ends(after):
            return replace(token, text="around", kinds=dict(vocabulary()["around"]))  # "six chairs round"
        if not target:
            return _without(token, "preposition", "place_adverb")
    counted = before is not None and before.has("number") and _singular(token.text) in words("nouns")["places"]
    if counted and token.text.endswith("s"):
        return replace(token, kinds={"plural": True})
    if token.text == "others" and before is not None and before.has("preposition"):
        return replace(token, kinds={"rest": token.text})  # "nothing on others"
    verb = token.get("verb")
    if not isinstance(verb, Verb) or verb.form != "base" or token.has(*OPEN) or before is None:
        return token
    alone = after is None or _ends(after) or after.has("preposition", "verb")
    return replace(token, kinds={}) if alone and before.text in ("a", "an") else token


def _without(token: Token, *kinds: str) -> Token:
    return replace(token, kinds={kind: value for kind, value in token.kinds.items() if kind not in kinds})


def _pieces(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "(4 pcs)", "x 4 pieces": the word after a number counts what was named, and is no thing."""
    token, after = tokens[at], _token(tokens, at + 1)
    if not token.has("number") or after is None or after.text not in words("predicates")["pieces"]:
        return 0
    if not _ends(_token(tokens, at + 2)):
        return 0
    found.append(replace(token, end=after.end))
    return 2


def _times(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Chairs x 8", "chairs (x8)": a number behind its noun stands before it."""
    sign, number = tokens[at], _token(tokens, at + 1)
    if sign.text not in ("x", "times") or number is None or not number.has("number"):
        return 0
    first = len(found)
    while first and found[first - 1].has(*OPEN) and not found[first - 1].has("break", "and", "det", "number"):
        first -= 1
    if first == len(found) or not any(t.has("noun") for t in found[first:]) or not _ends(_token(tokens, at + 2)):
        return 0
    if first and found[first - 1].has("det", "number", "amount", "preposition"):
        return 0
    start = found[first].start
    found.insert(first, replace(number, start=start, end=start))
    found[-1] = replace(found[-1], end=number.end)
    return 2


def _pronoun_with_verb(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "It is green": said of what was named last, where that can be said of things."""
    table = words("predicates")["subjects"]
    token, second = tokens[at], _token(tokens, at + 1)
    if token.text == "that's" and second is not None and second.has(*QUALITIES) and found and found[-1].has("noun"):
        middle = token.start + len("that")
        found.append(Token("that", token.start, middle, {"while": "that"}))
        found.append(Token("is", middle, token.end, {"verb": Verb("be", "s")}))
        return 1
    pronoun, taken = table.get(token.text), 1
    if pronoun is None and second is not None:
        pronoun, taken = table.get(f"{token.text} {second.text}"), 2
    if pronoun is None or not any(t.has("noun") for t in found):
        return 0
    ahead = at + taken
    while (after := _token(tokens, ahead)) is not None and after.has("adverbs", "stop") and not after.has(*QUALITIES):
        if after.text in words("predicates")["made"]:
            break
        ahead += 1
    if after is None:
        return 0
    of_room = after.has("scale", "adjective") and not any(t.has(*_OF_ROOMS) for t in _last_sentence(found))
    if not (after.has(*_SAID_OF_THINGS) or of_room or after.text in words("predicates")["made"]):
        return 0
    end = tokens[at + taken - 1].end
    found.append(Token(pronoun, token.start, token.end, {"pron": pronoun}))
    found.append(Token("is" if pronoun == "it" else "are", token.start, end, {"verb": Verb("be", "s")}))
    return taken


def _should_be(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "The bookcase should be tall and white": a verb, of which words of quality are the rest."""
    token, after = tokens[at], _token(tokens, at + 1)
    if not (token.has("verb_stop") and token.text.endswith(" be")) or after is None or not found:
        return 0
    said = after.has(*QUALITIES) or after.text in words("predicates")["made"]
    if not said or not (found[-1].has("noun", "pron", "parts") or found[-1].text == "also"):
        return 0
    found.append(Token(token.text, token.start, token.end, {"verb": Verb("be", "s")}))
    return 1


def _last_sentence(found: list[Token]) -> list[Token]:
    """The tokens of the sentence that ended last, or of the one that is read."""
    stops = [k for k, token in enumerate(found) if token.text == "."]
    if stops and stops[-1] == len(found) - 1:
        stops.pop()
    return found[stops[-1] + 1 :] if stops else found


def _made_of(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Made of glass and dark wood": each material is a word of quality there."""
    made, of = tokens[at], _token(tokens, at + 1)
    table = words("predicates")
    if made.text not in table["made"] or of is None or of.text not in table["of"]:
        return 0
    end = at + 2
    materials: list[Token] = []
    while (token := _token(tokens, end)) is not None:
        after = _token(tokens, end + 1)
        if token.has("material"):
            materials.append(replace(token, kinds={"material": token.get("material")}))
        elif token.has(*QUALITIES):
            materials.append(_without(token, "noun", "containers", "plural"))
        elif token.has("and") and materials and after is not None and after.has("material"):
            materials.append(token)
        elif not (token.text in ("a", "the", "solid", "real", "some") and not materials):
            break
        end += 1
    if not any(t.has("material") for t in materials):
        return 0
    found += [made, replace(of, kinds={"stop": of.text}), *materials]
    return end - at


def _filler(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "And like a chair": the word says nothing."""
    token, after = tokens[at], _token(tokens, at + 1)
    if token.text != "like" or after is None or not after.has("det", "number", "amount"):
        return 0
    before = found[-1].text if found else "."
    return 1 if before in words("predicates")["fillers_after"] else 0


def _seen_from(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Visible from the sofa" says nothing of where a thing is; it is told as not understood."""
    token, after = tokens[at], _token(tokens, at + 1)
    if token.text not in words("predicates")["seen"] or after is None or after.text not in ("from", "to"):
        return 0
    found.append(Token(f"{token.text} {after.text}", token.start, after.end, {"aside": "verb"}))
    return 2


def _as_many(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "30 desks and as many chairs": the number that was told last."""
    token, after = tokens[at], _token(tokens, at + 1)
    if token.text not in ("as many", "as") or after is None:
        return 0
    taken = 1 if token.text == "as many" else 2 if after.text == "many" else 0
    if not taken:
        return 0
    number = next((t for t in reversed(found) if t.has("number")), None)
    noun = _token(tokens, at + taken)
    if number is None or noun is None or not noun.has(*OPEN):
        return 0
    found.append(Token("as many", token.start, tokens[at + taken - 1].end, {"number": number.get("number")}))
    return taken


def _to_each(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Four chairs to a table": to each of the tables that were named."""
    token, article, noun = tokens[at], _token(tokens, at + 1), _token(tokens, at + 2)
    if token.text != "to" or article is None or noun is None or article.text not in ("a", "an", "each", "every", "one"):
        return 0
    head = _singular(noun.text)
    named = any(t.has("plural") and _singular(t.text).endswith(head) for t in found)
    if not noun.has("noun") or not named or not found[-1].has("plural"):
        return 0
    found.append(Token("per", token.start, article.end, {"each": "per"}))
    return 2


def _each_of(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Each of the five benches": each of a group that is named, with its number, now or before."""
    token, of, article = tokens[at], _token(tokens, at + 1), _token(tokens, at + 2)
    if token.text not in (*EACH, "every one", "each one") or of is None or of.text != "of" or article is None:
        return 0
    if not article.has("det") or article.has("noun"):
        return 0
    found.append(Token("each of", token.start, article.end, {"each": "each of"}))
    return 3


def _there_is(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Every wall has a picture and there is a bed": the bed is not every wall's."""
    token, there = tokens[at], _token(tokens, at + 1)
    if not token.has("and", "break") or there is None or there.text not in ("there is", "there are", "there should be"):
        return 0
    if not any(t.has("each") for t in _last_sentence(found)):
        return 0
    found.append(Token(".", token.start, token.end, {"break": "."}))
    return 1


def _to_the_other(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "A screen to one side of the fire and a piano to the other": at the other side of the same."""
    token, other = tokens[at], _token(tokens, at + 1)
    if other is None or other.text not in ("the other", "the other side"):
        return 0
    last = _last_sentence(found)
    named = next(
        (b for a, b in pairwise(last) if a.text == "one" and b.has("region", "place") and not b.has("noun")), None
    )
    if named is None and (one := next((t for t in last if t.text.startswith("one ") and t.has("region")), None)):
        noun = one.text.removeprefix("one ")
        named = replace(one, text=noun, kinds=dict(vocabulary()[noun]))
    if token.has("preposition") and named is not None and _ends(_token(tokens, at + 2)):
        found += [token, other, replace(named, start=other.end, end=other.end)]  # "in one corner, ... in the other"
        return 2
    if token.text not in ("to", "on", "at"):
        return 0
    first = next((k for k, t in enumerate(last) if t.text.rpartition(" of")[0].endswith("one side")), None)
    if first is None or not _ends(_token(tokens, at + 2)):
        return 0
    target = list(takewhile(lambda t: not _ends(t) and not t.has("verb", "preposition"), last[first + 1 :]))
    if not any(t.has("noun", "place", "pron") for t in target):
        return 0
    found.append(Token(last[first].text, token.start, other.end, dict(last[first].kinds)))
    found += [
        replace(t, text="the", kinds=dict(vocabulary()["the"])) if t.text in ("a", "an") else replace(t) for t in target
    ]
    return 2


def _on_the_left_one(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "A lamp on the left nightstand": on the one that is at the left."""
    token, noun = tokens[at], _token(tokens, at + 1)
    spoken = token.text.split()
    if spoken[-1] not in ("left", "right") or spoken[1:-1] != ["the"] or noun is None or not found:
        return 0
    one = noun.has("noun") and not noun.has("plural", "verb", "break", "place")
    if not one or found[-1].has("break") or spoken[0] not in ("on", "at"):
        return 0
    table, start = vocabulary(), token.start
    found.append(Token(spoken[0], start, start + len(spoken[0]), dict(table[spoken[0]])))
    found.append(Token("the", start, start, dict(table["the"])))
    found.append(Token(spoken[-1], token.end - len(spoken[-1]), token.end, {"adjective": spoken[-1]}))
    return 1


_LIST = 40
"""Most nouns of a list without a comma; what goes on for longer is none, and is not read to its end at each noun."""


def _bare_list(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Bed desk lamp each": three nouns or more with nothing between them before "each" are as many things."""
    end = at
    while (token := _token(tokens, end)) is not None and token.has("noun") and not token.has("plural", *QUALITIES):
        end += 1
        if end - at > _LIST:
            return 0
    each = _token(tokens, end)
    if end - at < 3 or each is None or each.text not in (*EACH, "apiece") or not _ends(_token(tokens, end + 1)):
        return 0
    for k in range(at, end):
        if k > at:
            here = tokens[k].start
            link = Token("and", here, here, {"and": "and"}) if k == end - 1 else Token(",", here, here, {"break": ","})
            found.append(link)
        found.append(tokens[k])
    return end - at


_RULES: tuple[Callable[[list[Token], int, list[Token]], int], ...] = (
    _bare_list,
    _on_the_left_one,
    _to_the_other,
    _pieces,
    _times,
    _pronoun_with_verb,
    _should_be,
    _made_of,
    _filler,
    _seen_from,
    _as_many,
    _to_each,
    _each_of,
    _there_is,
)
"""Each takes what has been found so far, adds to it, and says how many tokens it took; 0 leaves them to the next."""

__all__ = ["with_predicates"]
