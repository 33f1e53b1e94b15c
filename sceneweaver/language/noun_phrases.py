"""Noun phrases: article, number, words of quality, head, and what it is of."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from .chunks import CLOSED, EACH, OPEN, QUALITIES, NounPhrase, bounded, nominal
from .nothings import is_word
from .scan import Scan, has_article, is_name_of_one, is_verb
from .tokens import Token, looks_adjective
from .vocabulary import words

_ENDS = ("neg", "with", "while", "pron", "mutual", "only_all", "sides", "aside")
"""Kinds of words that end a noun phrase, unless they may be its noun."""

DEEPEST = 12
"""Levels of "of" that are read as one noun phrase; nobody says so many."""

_ONE = ("a", "an", "one", "the", "this", "each", "every", "another")


def _opening(scan: Scan, k: int, phrase: NounPhrase) -> int:
    """Reads articles, numbers and measures ahead of a noun into a phrase; the first token after them."""
    while k < len(scan.tokens) and _opens(scan, k, phrase):
        k += 1
    return k


def _opens(scan: Scan, k: int, phrase: NounPhrase) -> bool:
    """Whether a token stands ahead of a noun; what it says goes into the phrase."""
    token, after = scan.tokens[k], scan.token(k + 1)
    article = token.has("each", "both", "rest", "partial") and not token.has("noun")
    if (article or token.has("det")) and not phrase.determiner:
        _determine(phrase, token)
    elif token.has("bound") and after is not None and after.has("number", "amount"):
        phrase.bound = token.get("bound")
    elif token.has("number", "amount") and not _is_quality(scan, k):
        phrase.count = bounded(token.get("amount") or (token.get("number"),) * 2, phrase.bound)
        phrase.paired = "pair" in token.text
    elif token.has("length"):
        phrase.length = token.get("length")
    elif token.has("sides"):
        phrase.sides = token.get("sides")
    elif token.has("adverbs") and not token.has("noun", *QUALITIES) and after is not None:
        if after.has("verb") or not (after.has(*OPEN, "number") or not after.kinds):
            return _joins(token, after, phrase)
    else:
        return _joins(token, after, phrase)
    return True


def _joins(token: Token, after: Token | None, phrase: NounPhrase) -> bool:
    """Whether "of", "same" or "other" goes on with what stands ahead of a noun: "two of the other chairs"."""
    if token.text == "of" and phrase.count is not None and after is not None and after.has("det"):
        phrase.determiner = ""
        return True
    if token.text not in ("of", "same", "other") or (phrase.count is None and not phrase.determiner):
        return False
    if token.text == "other" and phrase.determiner in ("the", "its"):
        phrase.value = "rest"
    return True


def _determine(phrase: NounPhrase, token: Token) -> None:
    """An article or what stands for one."""
    phrase.determiner = token.text
    if token.has("each") and not token.has("det"):
        phrase.determiner = "each"
    elif token.has("rest", "both", "ordinal"):
        phrase.determiner = "the"
    if token.has("both", "rest", "ordinal"):
        phrase.value = token.text
    if token.text == "each of":
        phrase.of_group = True
    if token.has("both"):
        phrase.count, phrase.both = (2, 2), True
    if token.text in ("one of which", "one of them", "another", "one more", "a second"):
        phrase.count = (1, 1)
    if token.has("number"):
        phrase.count = (token.get("number"), token.get("number"))


def _is_quality(scan: Scan, k: int) -> bool:
    """Whether "double" or "twin" says what a thing is like: "a double bed"."""
    token, before = scan.tokens[k], scan.token(k - 1)
    if not token.has("adjective", "scale") or token.text not in ("double", "twin", "single", "dual"):
        return False
    after = scan.token(k + 1)
    if token.text == "single" and after is not None and after.has("plural"):
        return True  # "four single desks"
    return before is not None and before.has("det", "adjective", "color", "each", "material", "scale")


def _run_ends(scan: Scan, k: int, run: list[Token], phrase: NounPhrase, named: bool) -> bool:
    """Whether the words of a noun phrase end before token ``k``; ``named``: whether one of them is surely a noun."""
    token, after = scan.tokens[k], scan.token(k + 1)
    seen = named or (bool(run) and nominal(run[-1]))
    more = after is not None and bool(run) and after.has(*QUALITIES) and run[-1].has(*QUALITIES)
    if token.text in ("to", "for") or (run and has_article(token)):
        return True
    if seen and is_name_of_one(scan, k):
        return False
    if token.has("break"):  # "a large, comfortable sofa"
        return token.text != "," or seen or not (more and _nominal_ahead(scan, k + 1))
    if token.has("and"):  # "a red and white rug"
        another = after is not None and after.has("det", "number")
        return seen or another or not (more and _nominal_ahead(scan, k + 1))
    if token.has(*_ENDS) and (seen or not token.has("noun")):
        return True
    if token.has("det", "each", "partial", "rest", "both") and not token.has("noun"):
        return True
    if token.has("length"):
        if after is not None and after.has("dim") and not seen:
            phrase.length = token.get("length")
            return False
        return seen or not _nominal_ahead(scan, k + 1)
    if token.text == "seats" and seen and after is not None and after.has("number", "amount"):
        return True  # "a table seats eight"
    if token.has("number", "amount"):
        return seen or not token.has("adjective", "scale", "noun")
    if token.has("preposition", "place_adverb"):
        ends = _place_ends(token, after, run, phrase, seen)
        if ends is not None:
            return ends
    strange = (
        not token.kinds.keys() - {"matter", "plural"} and token.text.endswith("s") and not token.text.endswith("ss")
    )
    follows = after is not None and (after.has("det", "number", "preposition", "adverbs") or has_article(after))
    if strange and seen and phrase.determiner in _ONE and follows:  # a verb that is not known
        return True
    if token.has("verb") and is_verb(scan, k, seen or bool(run and run[-1].has("noun"))):
        return True
    if token.has("place") and seen and not token.has("noun", "region"):
        return token.get("place") not in ("room", "wall", "window", "door", "corner", "floor", "ceiling")
    if token.has("adverbs", "stop", "verb_stop", "only") and not token.has(*OPEN):
        return seen or not _nominal_ahead(scan, k + 1)
    if token.has("people_words", "whom") and seen and not token.has("noun"):
        return True
    if token.kinds or not seen or not run:
        return False
    closed, doing = after is None or after.has(*CLOSED), token.text.endswith("ing")
    if (closed or doing) and not looks_adjective(token.text) and not is_word(token.text):
        return run[-1].has("noun") or is_word(
            run[-1].text
        )  # "fairy lights allong the rail", "a diffuser emitting mist"
    return closed and doing


def _place_ends(token: Token, after: Token | None, run: list[Token], phrase: NounPhrase, seen: bool) -> bool | None:
    """Whether a word of place ends a noun phrase; None where other rules tell."""
    if not token.has("noun", *QUALITIES, "region", "place"):
        first = bool(phrase.determiner) and not run and " " not in token.text
        return not (first and after is not None and after.has("noun", "place", "region"))  # "the opposite corner"
    if seen:
        return not token.has("noun") or token.has("bare")
    if token.has("preposition") and not token.has("noun", "region", "place"):
        return not (after is not None and (after.has(*OPEN) or not after.kinds))
    return None


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
    """Adds the noun phrase, number or words of quality that begin here; whether there is any."""
    start, phrase = scan.at, NounPhrase("thing")
    k = _opening(scan, start, phrase)
    run: list[Token] = []
    named = False
    while k < len(scan.tokens) and not _run_ends(scan, k, run, phrase, named):
        token = scan.tokens[k]
        run.append(replace(token, kinds={}) if run and is_name_of_one(scan, k) else token)
        named = named or (nominal(run[-1]) and not run[-1].has("material", "color"))
        k += 1
    while run and not nominal(run[-1]) and any(nominal(t) for t in run):
        trailing = run.pop()  # "a magazine open on the sofa"
        if trailing.has("preposition", "place_adverb"):
            k = scan.tokens.index(trailing, start)
        else:
            phrase.qualities.append(trailing)
    if not run:
        return _without_noun(scan, start, k, phrase)
    _close(scan, start, k, phrase, run)
    return True


def _without_noun(scan: Scan, start: int, end: int, phrase: NounPhrase) -> bool:
    """A number or words of quality that stand alone: "four on each side", "the walls are white"."""
    if end == start and not phrase.qualities:
        return False
    scan.at = start
    after = scan.token(end)
    if phrase.count is not None:
        phrase.what = "number"
        of_them = after is not None and after.text in ("them", "these", "those")
        _add_phrase(scan, start, end + of_them, phrase)
    elif phrase.sides is not None or phrase.length is not None:
        scan.add("adjective", end - start, value=phrase)
    elif phrase.determiner == "another":
        phrase.what, phrase.value = "pronoun", "partial"
        _add_phrase(scan, start, end, phrase)
    else:
        scan.add("word", max(1, end - start), value=scan.tokens[start])
    return True


def _close(scan: Scan, start: int, end: int, phrase: NounPhrase, run: list[Token]) -> None:
    """The head of a run, what stands before it, and what it is of."""
    if not any(nominal(t) for t in run):
        phrase.qualities += run
        plain = phrase.determiner in ("", "the") and phrase.count is None
        if plain or all(t.has(*QUALITIES) for t in run):
            scan.at = start
            scan.add("adjective", end - start, value=phrase)
            return
    head, after = run[-1], scan.token(end)
    phrase.qualities = run[:-1] + phrase.qualities
    phrase.plural = head.has("plural") or (not head.has("noun", "place", "room") and _plural_form(head.text))
    phrase.what, phrase.value = _kind(scan, head, phrase, start)
    if after is not None and after.text == "of" and end + 1 < len(scan.tokens) and scan.depth < DEEPEST:
        scan.at, scan.depth = end + 1, scan.depth + 1
        length, named = len(scan.out), set(scan.named)
        if noun_phrase(scan) and scan.out[-1].kind == "noun":
            phrase.of, end = scan.out[-1].value, scan.at
        scan.depth, scan.named = scan.depth - 1, named
        del scan.out[length:]
    phrase.text = head.text
    end = _or_more(scan, end, phrase)
    if phrase.paired and phrase.count is not None and head.text.split()[-1] in words("nouns")["paired"]:
        phrase.count = (phrase.count[0] // 2, phrase.count[1] // 2)  # "a pair of scissors"
    _add_phrase(scan, start, end, _collected(phrase, head))


def _or_more(scan: Scan, end: int, phrase: NounPhrase) -> int:
    """ "A lamp or two", "four chairs or more": the end of the phrase with what follows its noun."""
    link, more, after = scan.token(end), scan.token(end + 1), scan.token(end + 2)
    if link is None or more is None or link.text != "or" or phrase.of is not None:
        return end
    low = (phrase.count or (1, 1))[0]
    if more.has("number") and not (after is not None and (after.has(*OPEN) or not after.kinds)):
        phrase.count = (low, max(low, more.get("number")))
    elif more.text in ("more", "so") and phrase.count is not None:
        phrase.count = bounded(phrase.count, "least" if more.text == "more" else None)
    else:
        return end
    return end + 2


def _add_phrase(scan: Scan, start: int, end: int, phrase: NounPhrase) -> None:
    scan.at = start
    phrase.start, phrase.end = scan.tokens[start].start, scan.tokens[max(start, end - 1)].end
    scan.add("noun", max(1, end - start), value=phrase)


def _kind(scan: Scan, head: Token, phrase: NounPhrase, start: int) -> tuple[str, Any]:
    """What a noun phrase names by its head, and the value of that."""
    before, noun, place = scan.token(start - 1), head.has("noun"), head.get("place")
    if head.has("group") and (scan.named or not head.has("room")):
        return "group", head.get("group")
    of_room = not head.has("room") or place == "room"
    if place is not None and of_room and (place in ("window", "door") or not noun):
        return "place", place
    if head.has("region") and not (noun and not phrase.definite and head.get("region") not in ("center", "corner")):
        return "region", head.get("region")
    if head.has("room"):  # "a sofa by the library": a room is none among things
        placed = before is not None and before.has("preposition") and before.text not in ("in", "inside", "within")
        told = before is not None and before.text == "with"  # "a dance studio with a bar"
        if not noun or not (placed or told or {"thing", "group", "room"} & scan.named):
            return "room", head.get("room")
    last = before.text.split()[-1] if before is not None else ""
    holds = last in ("on", "from", "of", ",") and head.text in words("nouns")["holders"]
    if head.has("parts") and not (noun and (holds or before is None or before.text == ".")):
        return "part", head.text
    aimed = before is not None and bool(scan.out) and scan.out[-1].kind == "purpose" and scan.out[-1].value == "people"
    if phrase.determiner in EACH and not head.kinds and f"{head.text}s" in words()["people_words"]:
        return "people", head.text  # "every pupil"
    if noun and aimed and head.has("people_words"):
        return "people", head.text  # "a chair for staff"
    if noun and not (head.has("abstract") and not phrase.determiner and phrase.count is None):
        return "thing", head.get("noun")
    if head.has("people_words", "whom"):
        return "people", head.text
    if head.has("abstract"):
        return "abstract", head.text
    if head.has("collective"):
        return "collective", head.get("collective")
    if head.has("matter"):
        return "matter", head.get("matter")
    return "thing", None


def _plural_form(word: str) -> bool:
    return word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3


def _collected(phrase: NounPhrase, head: Token) -> NounPhrase:
    """ "A pair of chairs" is two chairs, "a stack of two books" two books, "a tea set of six cups" six cups."""
    inner = phrase.of
    if inner is None or not (head.has("collective") or (inner.count is not None and head.text.endswith(" set"))):
        return phrase
    paired, counted = inner.text in words("nouns")["paired"], head.get("collective")
    if inner.count is None and paired:
        inner.count = phrase.count or (1, 1)
    elif inner.count is None:
        inner.count = tuple(counted) if counted else (2, 5) if inner.plural else None
    elif counted is None and phrase.count is not None and head.has("collective"):  # "two rows of four chairs"
        inner.count = (phrase.count[0] * inner.count[0], phrase.count[1] * inner.count[1])
        inner.value = "grouped" if inner.what == "number" else inner.value
    inner.determiner = phrase.determiner or inner.determiner
    return inner
