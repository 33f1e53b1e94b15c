"""Noun phrases: article, number, words of quality, head, and what it is of."""

from __future__ import annotations

from typing import Any

from .chunks import CLOSED, OPEN, QUALITIES, NounPhrase, bounded, nominal
from .scan import Scan, is_verb
from .tokens import Token
from .vocabulary import words

_ONE = ("a", "an", "one", "the", "this", "each", "every", "another")


def _opening(scan: Scan, k: int, phrase: NounPhrase) -> int:
    """Articles, numbers and measures ahead of a noun."""
    while k < len(scan.tokens):
        token = scan.tokens[k]
        after = scan.tokens[k + 1] if k + 1 < len(scan.tokens) else None
        if (
            token.has("each", "det", "both", "rest", "partial")
            and not phrase.determiner
            and not (token.has("noun") and not token.has("det"))
        ):
            phrase.determiner = (
                "each"
                if token.has("each") and not token.has("det")
                else "the"
                if token.has("rest", "both")
                else token.text
            )
            if token.has("both", "rest"):
                phrase.value = token.text
            if token.has("both"):
                phrase.count = (2, 2)
            if token.text in ("one of which", "one of them", "another", "one more", "a second"):
                phrase.count = (1, 1)
            if token.has("number"):
                phrase.count = (int(token.get("number")), int(token.get("number")))
        elif token.has("bound") and after is not None and after.has("number", "amount"):
            phrase.bound = token.get("bound")
        elif token.has("number", "amount") and not (token.has("adjective", "scale") and _is_adjective(scan, k)):
            value = token.get("amount") or (int(token.get("number")), int(token.get("number")))
            phrase.count = bounded(value, phrase.bound)
            phrase.paired = "pair" in token.text
        elif token.has("length"):
            phrase.length = token.get("length")
        elif token.has("sides"):
            phrase.sides = token.get("sides")
        elif (
            token.has("adverbs")
            and not token.has("noun", *QUALITIES)
            and after is not None
            and (after.has(*OPEN, "number") or not after.kinds)
            and not after.has("verb")
        ):
            pass
        elif token.text == "of" and phrase.count is not None and after is not None and after.has("det"):
            phrase.determiner = ""
        elif token.text in ("of", "same", "other") and (phrase.count is not None or phrase.determiner):
            if token.text == "other" and phrase.determiner in ("the", "its"):
                phrase.value = "rest"
        else:
            break
        k += 1
    return k


def _is_adjective(scan: Scan, k: int) -> bool:
    """Whether "double" or "twin" says what a thing is like: "a double bed"."""
    return (
        scan.tokens[k].text in ("double", "twin", "single", "dual")
        and k > 0
        and scan.tokens[k - 1].has("det", "adjective", "color", "each", "material", "scale")
    )


def _run_ends(scan: Scan, k: int, run: list[Token], phrase: NounPhrase) -> bool:
    token = scan.tokens[k]
    after = scan.tokens[k + 1] if k + 1 < len(scan.tokens) else None
    seen = any(nominal(t) and not t.has("material", "color") for t in run) or (bool(run) and nominal(run[-1]))
    if token.text in ("to", "for"):
        return True
    if token.has("break"):
        if token.text != "," or seen or not run or after is None:
            return True
        return not (after.has(*QUALITIES) and run[-1].has(*QUALITIES) and _nominal_ahead(scan, k + 1))
    if token.has("and"):
        both = (
            run
            and not seen
            and after is not None
            and after.has(*QUALITIES)
            and run[-1].has(*QUALITIES)
            and not after.has("det", "number")
        )
        return not (both and _nominal_ahead(scan, k + 1))
    if token.has("neg", "with", "while", "pron", "mutual", "only_all", "sides") and not (
        token.has("noun") and not seen
    ):
        return True
    if token.has("det", "each", "partial", "rest", "both") and not token.has("noun"):
        return True
    if token.has("length"):
        if after is not None and after.has("dim") and not seen:
            phrase.length = token.get("length")
            return False
        return seen or not _nominal_ahead(scan, k + 1)
    if token.has("number", "amount"):
        return not (token.has("adjective", "scale", "noun") and not seen)
    if token.has("preposition", "place_adverb") and not token.has("noun", *QUALITIES, "region", "place"):
        first = bool(phrase.determiner) and not run and " " not in token.text
        return not (first and after is not None and after.has("noun", "place", "region"))  # "the opposite corner"
    strange = not token.kinds and token.text.endswith("s") and not token.text.endswith("ss")
    follows = after is not None and after.has("det", "number", "preposition", "adverbs")
    if strange and seen and phrase.determiner in _ONE and follows:  # a verb that is not known
        return True
    if token.has("preposition", "place_adverb") and seen:
        return not (token.has("noun") and not token.has("bare"))
    if token.has("preposition") and not seen and not token.has("noun", "region", "place"):
        return not (after is not None and (after.has(*OPEN) or not after.kinds))
    if token.has("verb") and is_verb(scan, k, seen or bool(run and run[-1].has("noun"))):
        return True
    if token.has("place") and seen and not token.has("noun", "region"):
        return token.get("place") not in ("room", "wall", "window", "door", "corner", "floor", "ceiling")
    if token.has("adverbs", "stop", "verb_stop", "only") and not token.has(*OPEN):
        return seen or not _nominal_ahead(scan, k + 1)
    if token.has("people_words", "whom") and seen and not token.has("noun"):
        return True
    return (
        not token.kinds and seen and bool(run) and token.text.endswith("ing") and (after is None or after.has(*CLOSED))
    )


def _nominal_ahead(scan: Scan, k: int) -> bool:
    for token in scan.tokens[k : k + 5]:
        if token.has("break", "preposition", "with", "det", "pron"):
            return False
        if nominal(token) and not token.has("color", "material"):
            return True
        if token.has("verb") and not token.has(*QUALITIES) and token.get("verb").form in ("s", "base"):
            return False
    return False


def noun_phrase(scan: Scan) -> bool:
    start, phrase = scan.at, NounPhrase("thing")
    k = _opening(scan, start, phrase)
    run: list[Token] = []
    while k < len(scan.tokens):
        token = scan.tokens[k]
        if _run_ends(scan, k, run, phrase):
            break
        run.append(token)
        k += 1
    while run and not nominal(run[-1]) and any(nominal(t) for t in run):
        trailing = run.pop()  # "a magazine open on the sofa"
        phrase.qualities.append(trailing)
        if trailing.has("preposition", "place_adverb"):
            phrase.qualities.pop()
            k = scan.tokens.index(trailing, start)
    if not run:
        return _without_noun(scan, start, k, phrase)
    return _close(scan, start, k, phrase, run)


def _without_noun(scan: Scan, start: int, end: int, phrase: NounPhrase) -> bool:
    """A number or words of quality that stand alone: "four on each side", "the walls are white"."""
    if end == start and not phrase.qualities:
        return False
    scan.at = start
    if phrase.count is not None:
        phrase.what = "number"
        tail = [t.text for t in scan.tokens[end : end + 2]]
        if tail and tail[0] in ("them", "these", "those"):
            end += 1
        _add_phrase(scan, start, end, phrase)
        return True
    if phrase.sides is not None or phrase.length is not None:
        scan.add("adjective", end - start, value=phrase)
        return True
    if phrase.determiner in ("another", "its", "their") and phrase.determiner == "another":
        phrase.what, phrase.value = "pronoun", "partial"
        _add_phrase(scan, start, end, phrase)
        return True
    scan.add("word", max(1, end - start), value=scan.tokens[start])
    return True


def _close(scan: Scan, start: int, end: int, phrase: NounPhrase, run: list[Token]) -> bool:
    """The head of a run, and what stands before it."""
    if not any(nominal(t) for t in run):
        phrase.qualities += run
        if phrase.determiner in ("", "the") and phrase.count is None or all(t.has(*QUALITIES) for t in run):
            scan.at = start
            scan.add("adjective", end - start, value=phrase)
            return True
    head = run[-1]
    phrase.qualities = run[:-1] + phrase.qualities
    phrase.plural = bool(head.has("plural") or (not head.has("noun", "place", "room") and _plural_form(head.text)))
    phrase.what, phrase.value = _kind(scan, head, phrase, start)
    after = scan.tokens[end] if end < len(scan.tokens) else None
    if after is not None and after.text == "of" and end + 1 < len(scan.tokens):
        scan.at = end + 1
        length = len(scan.out)
        if noun_phrase(scan) and scan.out[-1].kind == "noun":
            inner = scan.out.pop()
            del scan.out[length:]
            phrase.of, end = inner.value, scan.at
        else:
            del scan.out[length:]
    phrase.text = head.text
    if phrase.paired and phrase.count is not None and head.text.split()[-1] in _paired():  # "a pair of scissors"
        phrase.count = (phrase.count[0] // 2, phrase.count[1] // 2)
    scan.at = start
    _add_phrase(scan, start, end, _collected(phrase, head))
    return True


def _add_phrase(scan: Scan, start: int, end: int, phrase: NounPhrase) -> None:
    scan.at = start
    phrase.start, phrase.end = scan.tokens[start].start, scan.tokens[max(start, end - 1)].end
    scan.add("noun", max(1, end - start), value=phrase)
    scan.noun_before = True


def _kind(scan: Scan, head: Token, phrase: NounPhrase, start: int) -> tuple[str, Any]:
    before = scan.tokens[start - 1] if start else None
    if head.has("group") and not (head.has("room") and not any(c.kind == "noun" for c in scan.out)):
        return "group", head.get("group")
    opening = head.get("place") in ("window", "door")
    of_room = not (head.has("room") and head.get("place") != "room")
    if head.has("place") and (opening or not head.has("noun")) and of_room:
        return "place", head.get("place")
    if head.has("region") and not (
        head.has("noun") and not phrase.definite and head.get("region") not in ("center", "corner")
    ):
        return "region", head.get("region")
    if head.has("room"):
        things = any(c.kind == "noun" and c.value.what in ("thing", "group") for c in scan.out)
        if not head.has("noun") or not (
            things
            or (before is not None and before.has("preposition") and before.text not in ("in", "inside", "within"))
        ):
            return "room", head.get("room")
    opening_sentence = before is None or before.text == "."
    if head.has("parts") and not (opening_sentence and head.has("noun")):
        return "part", head.text
    if head.has("noun") and not (head.has("abstract") and not phrase.determiner and phrase.count is None):
        return "thing", head.get("noun")
    if head.has("people_words", "whom"):
        return "people", head.text
    if head.has("abstract"):
        return "abstract", head.text
    if head.has("collective"):
        return "collective", head.get("collective")
    return "thing", None


def _plural_form(word: str) -> bool:
    return word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3


def _collected(phrase: NounPhrase, head: Token) -> NounPhrase:
    """ "A pair of chairs" is two chairs, "a stack of two books" two books."""
    inner = phrase.of
    counted_set = (
        inner is not None and inner.count is not None and head.text.endswith(" set")
    )  # "a tea set of six cups"
    if inner is None or not (head.has("collective") or counted_set):
        return phrase
    paired = inner.text in _paired()
    counted = head.get("collective")
    if inner.count is None:
        inner.count = (
            None
            if paired and counted == (2, 2)
            else tuple(counted)
            if counted
            else (2, 5)
            if inner.plural and not paired
            else None
        )
        if paired and phrase.count is not None:
            inner.count = phrase.count
        elif paired:
            inner.count = (1, 1)
    inner.determiner = phrase.determiner or inner.determiner
    return inner


def _paired() -> frozenset[str]:
    return frozenset(words("nouns")["paired"])
