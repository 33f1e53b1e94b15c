"""Tokens into chunks, each by the classes of its tokens."""

from __future__ import annotations

from collections.abc import Callable

from sceneweaver.assets.plurals import singular

from .chunks import CLOSED, EACH, OPEN, QUALITIES, Chunk, Kind, NounPhrase
from .noun_phrases import noun_phrase
from .scan import Scan, is_verb, participle_next
from .tokens import Token
from .vocabulary import Verb, frame, words

_BREAKS: dict[str, Kind] = {",": "comma", ".": "stop"}
_PRONOUNS = ("rest", "partial", "both", "each", "pron")
_SEATS = ("seats", "sleeps", "seating", "sleeping")

_IN_PURPOSES = ("in", "on", "at", "by", "about")
"""Words of place that belong to what something is for: "for storing toys in"."""

_IN_OR_ON = ("cover", "connect", "fill")
"""Verbs whose participle may take "in", "on" and "to" as well: "covered in felt"."""


def chunked(tokens: list[Token]) -> list[Chunk]:
    """The chunks of tokens, from left to right: at each place the first rule that fits makes one."""
    scan = Scan(tokens)
    while scan.at < len(tokens):
        token, after = tokens[scan.at], scan.peek(1)
        next(rule for rule in _RULES if rule(scan, token, after))
    return scan.out


def _mark(scan: Scan, token: Token, after: Token | None) -> bool:
    """Punctuation, and words that mean what they are wherever they stand."""
    if token.has("break"):
        scan.add(_BREAKS.get(token.text, "bracket"))
    elif token.has("aside"):
        scan.add("aside", value=token.get("aside"))
    elif token.has("only_all"):
        scan.add("only", value="all")
    elif token.has("neg"):
        scan.add("without", value=token.text)
    elif token.has("nothing"):
        scan.add("without", value="nothing")
    elif token.has("only") and not token.has("noun"):
        scan.add("only", value="named")
    elif token.has("mutual"):
        scan.add("place", value=token.get("mutual"), mutual=True)
    else:
        return False
    return True


def _with(scan: Scan, token: Token, after: Token | None) -> bool:
    if not token.has("with") or (token.has("noun") and not scan.noun_before):
        return False
    scan.add("with", value=token.text)
    return True


def _place(scan: Scan, token: Token, after: Token | None) -> bool:
    if not token.has("preposition", "place_adverb") or not _is_place(scan, token, after):
        return False
    if token.get("bound") == "about" and after is not None and after.has("number", "amount", "length"):
        return False
    takes_target = token.has("preposition")
    place, alone = token.get("preposition"), token.get("place_adverb")
    if alone is not None and not (takes_target and _noun_follows(scan)):
        place = alone
    chunk = scan.add("place", value=place, bare=not takes_target or token.has("place_adverb", "bare"))
    chunk.passive = not takes_target
    return True


def _seats(scan: Scan, token: Token, after: Token | None) -> bool:
    """ "Seats eight" says for how many people, and not which chairs."""
    if token.text not in _SEATS or after is None or not after.has("number", "amount"):
        return False
    third = scan.peek(2)
    if third is not None and (third.has(*OPEN) or not third.kinds):
        return False
    scan.add("word", value=token)
    return True


def _binding(scan: Scan, token: Token, after: Token | None) -> bool:
    if token.has("and") and not token.has("noun"):
        scan.add("and")
    elif token.has("while"):
        scan.add("while", value=token.text)
    else:
        return False
    return True


def _verb_in_place(scan: Scan, token: Token, after: Token | None) -> bool:
    """A verb after its subject, known or told by its ending."""
    if token.has("verb") and is_verb(scan, scan.at, scan.noun_before or participle_next(scan, token, after)):
        return _verb(scan, token, after)
    if token.kinds or not scan.noun_before:
        return False
    closed = after is not None and after.has(*CLOSED)
    if token.text.endswith(("ing", "ed")) and (after is None or closed):
        scan.add("verb", value=Verb("act", "ing" if token.text.endswith("ing") else "ed"))
    elif token.text.endswith("s") and closed:
        scan.add("verb", value=Verb("act", "s"))
    else:
        return False
    return True


def _noun(scan: Scan, token: Token, after: Token | None) -> bool:
    return noun_phrase(scan)


def _word(scan: Scan, token: Token, after: Token | None) -> bool:
    scan.add("word", value=token)
    return True


def _noun_follows(scan: Scan) -> bool:
    """Whether a noun phrase comes next."""
    token = scan.peek(1)
    if token is None or token.has("break", "and", "with", "while"):
        return False
    quality = token.has(*QUALITIES)
    if token.has("preposition") and not (quality or token.has("det")):
        return False
    if token.has("verb") and not (quality or token.has("noun")):
        return False
    return not token.has("adverbs", "stop") or quality or token.has("det", "number", "amount", "noun")


def _is_place(scan: Scan, token: Token, after: Token | None) -> bool:
    if (
        token.has("shape", "adjective", "color", "scale", "noun", "region")
        and after is not None
        and token.text not in ("opposite", "inside")
    ):
        return not after.has("noun", "room", *QUALITIES) or after.has("det", "number")
    return True


def _pronoun(scan: Scan, token: Token, after: Token | None) -> bool:
    """ "It", "both", "the other", "one", unless a noun follows that they belong to."""
    kind = next((kind for kind in _PRONOUNS if token.has(kind)), None)
    if kind is None:
        return False
    if token.text == "one" and after is not None and after.has("adverbs") and not after.has(*OPEN, *CLOSED):
        after = scan.peek(2) or after  # "one totally clean table"
    opens = (
        after is not None
        and (after.has(*OPEN, "length", "sides") or (not after.kinds and not after.text.endswith("ed")))
        and not after.has(*CLOSED)
        and not (after.has("verb") and is_verb(scan, scan.at + 1, seen_noun=True))
    )
    if token.text == "each of":
        return False
    if token.text in EACH and after is not None and after.text in words("nouns")["every"]:
        third = scan.peek(2)
        if third is not None and third.text == "one":  # "every second one with a lamp"
            value = NounPhrase("pronoun", "each", token.start, third.end, value="each", determiner="every")
            value.qualities = [after]
            scan.add("noun", 3, value=value)
            return True
    if token.text in EACH and after is not None and _one_of_several(scan, token, after):
        return False
    of_station = token.text in EACH and after is not None and singular(after.text) in words("nouns")["stations"]
    belongs = token.has("each", "both", "det", "number", "rest", "ordinal") or token.text == "another"
    if of_station or (opens and belongs):
        return False
    targeted = bool(scan.out) and scan.out[-1].kind == "place"  # "on each a vase"
    if token.text in (*EACH, "both") and not targeted and after is not None and after.has("det", "number"):
        return False
    if token.text == "one" and after is not None:
        placed = after.has("verb", "preposition", "place_adverb")
        if after.text == "of" or (scan.noun_before and not placed):
            return False
    scan.add("noun", value=NounPhrase("pronoun", token.text, token.start, token.end, value=kind))
    return True


def _one_of_several(scan: Scan, token: Token, after: Token) -> bool:
    """Whether "every second chair", "for every two chairs" or "between each two chairs" begins."""
    if after.text in words("nouns")["every"]:
        return True
    between = bool(scan.out) and scan.out[-1].kind == "place" and scan.out[-1].value.type == "between"
    return after.has("number") and (token.text == "every" or between)


def _purpose(scan: Scan, token: Token, after: Token | None) -> bool:
    """ "For players to rest", "to illuminate the layout": what something is for; people are read."""
    verb = after.get("verb") if after is not None else None
    before = scan.peek(-1)
    # "deep enough to fill tall vases" says what it is fit for
    fit = before is not None and before.text in words("parts_of_speech")["enough"]
    opens = isinstance(verb, Verb) and verb.form == "base" and "active" in (frame(verb) or ())
    if token.text == "to" and isinstance(verb, Verb) and opens and not fit:
        scan.add("word", value=token)
        scan.add("verb", value=Verb(verb.lemma, "ing"))  # "open to reveal two toys"
        return True
    if token.text == "for" and after is not None and (after.has("each") or after.text in ("each", "every")):
        scan.add("word", value=token)  # "a towel for each guest"
        return True
    first = scan.at + 1
    if token.text == "for" or token.has("purposes"):
        ahead = scan.tokens[first : first + 3]
        said_of_people = any(t.has("whom", "people_words", "number", "amount") for t in ahead)
        if said_of_people and not any(t.has("noun") and not t.has("whom", "people_words", "number") for t in ahead[:2]):
            scan.add("purpose", value="people")
            return True
        if any(t.has("room", "group") for t in ahead):
            scan.add("purpose", value="room")
            return True
    elif token.text not in ("to", "ready to", "in order to"):
        return False
    end = first
    while end < len(scan.tokens) and not _purpose_ends(scan, end, first):
        end += 1
    scan.add("purpose", end - scan.at, value="use")
    return True


def _purpose_ends(scan: Scan, k: int, first: int) -> bool:
    """Whether token ``k`` says no more of what something is for."""
    token = scan.tokens[k]
    if token.has("break", "with", "while"):
        return True
    if token.has("and") and k + 1 < len(scan.tokens) and scan.tokens[k + 1].has("det", "number"):
        return True
    if k > first and (token.has("place_adverb") or (token.has("preposition") and token.text not in _IN_PURPOSES)):
        return True
    return k > first + 1 and token.has("verb") and token.get("verb").form == "s" and not token.has("noun")


def _verb(scan: Scan, token: Token, after: Token | None) -> bool:
    """A verb, together with the "by", "with" and the like of its participle."""
    if not token.has("verb"):
        return False
    verb: Verb = token.get("verb")
    voices = frame(verb) or {}
    word = after.text if after is not None and verb.form == "ed" else ""
    joined = ("with" in voices and word == "with") or (
        "by" in voices and (word in ("by", "with", "of") or (word in ("in", "to", "on") and verb.lemma in _IN_OR_ON))
    )
    scan.add("verb", 2 if joined else 1, value=verb, passive=joined)
    return True


_RULES: tuple[Callable[[Scan, Token, Token | None], bool], ...] = (
    _mark,
    _pronoun,
    _purpose,
    _with,
    _place,
    _seats,
    _binding,
    _verb_in_place,
    _noun,
    _verb,
    _word,
)
"""Each adds a chunk and says so, or leaves the token to the next."""
