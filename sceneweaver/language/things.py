"""From a noun phrase to what it names: a category, how many, and what each word before the noun says."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, lru_cache

from sceneweaver.assets import Match, resolve
from sceneweaver.assets.taxonomy import category_named, holder, is_no_thing, narrower
from sceneweaver.assets.wordnet import noun_named

from .chunks import NounPhrase
from .model import Attribute, AttributeKind
from .parsed import Mention, Parsed
from .senses import NOTHING, sense_of
from .source import Source
from .tokens import Token
from .vocabulary import category_of, plural, vocabulary, words

MANY = (2, 6)
"""Least and most of a bare plural."""

_KINDS: tuple[tuple[str, AttributeKind], ...] = (
    ("color", "color"),
    ("material", "material"),
    ("finish", "finish"),
    ("scale", "size"),
    ("dim", "size"),
    ("shape", "shape"),
    ("styles", "style"),
)


_IN_NAMES = ("color", "shape", "material", "adjective", "scale")


def name_of(phrase: NounPhrase) -> str:
    """The noun with the words before it that may belong to its name."""
    before = []
    for token in reversed(phrase.qualities):
        named = token.has("noun", "room", "place", "whom", "region", "containers", "abstract", "parts", "collective")
        if token.has("color", "styles", "scale", "moods", "adverbs") and not (named and token.has("noun")):
            break
        if token.has("material", "shape", "adjective", "finish") and not token.has("noun"):
            break
        if not named and token.kinds:
            break
        before.insert(0, token.text)
    return " ".join([*before[-3:], phrase.text])


@lru_cache(maxsize=4096)
def match_of(noun: str, of: str = "") -> Match:
    """The category of a noun, tried whole, then without the words before it."""
    table = vocabulary()
    head, _, last = noun.rpartition(" ")
    if of and singular(last) in words("nouns")["sold_in"]:  # of what is sold in it: no tub to bathe in, no handbag
        noun = f"{head} {words('nouns')['sold_in'][singular(last)]}".strip()
    whole = f"{noun} of {of}" if of else noun
    parts = noun.split()
    first, *others = parts
    if others and not table.get(first) and noun_named(first) is None:  # "coffe table"
        meant = resolve(noun)
        if meant.how == "spelling":
            return meant
    tails = 1 if is_no_thing(noun) else len(parts)  # a fire drill is no drill
    for k, name in ((0, whole), *((k, " ".join(parts[k:])) for k in range(tails))):
        found = table.get(name, {}).get("noun")
        if found is not None:
            held = holder(singular(name), parts[k - 1]) if k == len(parts) - 1 > 0 else None
            return Match(held or category_of(found), "exact" if k == 0 else "head", modifiers=tuple(parts[:k]))
    return resolve(noun)


def new_mention(phrase: NounPhrase, source: Source) -> Mention:
    """What a noun phrase names, as something that was not named before."""
    noun = name_of(phrase)
    of = phrase.of.text if phrase.of is not None and phrase.of.what != "pronoun" else ""
    match = match_of(noun, of)
    if of:
        noun = f"{noun} of {of}"
    mention = Mention(noun, match.category, phrase.count, generic=match.how == "generic", plural=phrase.plural)
    mention.span = source.span(phrase.start, phrase.end)
    mention.numbered = phrase.count is not None
    if mention.count is None:
        head = phrase.text.split(" of ")[0]
        several = phrase.plural and head.split()[-1] not in words("nouns")["paired"] and plural(_single(head)) == head
        if several:
            mention.count = MANY
        elif phrase.determiner and phrase.determiner not in ("the", "its", "their", "any", "these", "those"):
            mention.count = (1, 1)
    first, _, rest = noun.partition(" ")
    if (
        rest
        and first in ("dual", "twin", "double")
        and phrase.plural
        and (first == "twin" or match_of(rest).category == match.category)
    ):
        mention.count = phrase.count or (2, 2)
    describe(mention, phrase, source)
    mention.category = narrower(mention.category, " ".join(a.words for a in mention.attributes), mention.noun)
    meant = sense_of(mention.noun, source, phrase.start, phrase.end, mention.scale, _is_bare(phrase))
    if meant == NOTHING:
        mention.category, mention.generic = "", True
        return mention
    if meant is not None:
        mention.category, mention.generic = meant, False
        return mention
    described = {word for a in mention.attributes for word in a.words.split()} | set(mention.words)
    spoken = set(mention.category.split("_"))
    mention.unnamed = [word for word in match.modifiers if word not in described | spoken and not _is_quality(word)]
    if of and f"{name_of(phrase)} of {of}" not in vocabulary():
        mention.unnamed += _untold(of, described | spoken)
    return mention


def _untold(contents: str, told: set[str]) -> list[str]:
    """The words of what a thing is of ("toys" of a basket) that its category and its attributes do not tell."""
    idle = {*words("function_words")["nouns_of_place"].split(), *words("function_words")["units"].split()}
    told = {singular(word) for word in told}
    return [word for word in contents.split() if singular(word) not in told and word not in idle]


def _is_bare(phrase: NounPhrase) -> bool:
    """Whether a noun has no "a", no number and no plural, as the names of materials have none."""
    return phrase.count is None and not phrase.plural and phrase.determiner in ("", "the", "its", "their", "some")


def _is_quality(word: str) -> bool:
    """Whether a word says what a thing is like, rather than which kind of thing it is."""
    return not vocabulary().get(word, {}).keys() <= {"noun", "trade"}


def note_on(mention: Mention, parsed: Parsed) -> None:
    """Says what a noun was taken for, unless its name was known."""
    match = match_of(mention.noun)
    if match.note and mention.generic == match.generic and match.how in ("generic", "group", "head", "spelling"):
        parsed.note(match.note)


_PLURALS = {"shelves": "shelf", "ies": "y", "xes": "x", "ches": "ch", "shes": "sh", "sses": "ss", "s": ""}


def _single(noun: str) -> str:
    for ending, plain in _PLURALS.items():
        whole = noun == ending or noun.endswith(f" {ending}")
        if noun.endswith(ending) and (not whole or len(plain) > 2):  # an ending ends a word
            return noun[: len(noun) - len(ending)] + plain
    return noun


def singular(noun: str) -> str:
    """A noun without the ending of its plural; good enough for comparing nouns with each other."""
    return noun if noun.endswith("ss") else _single(noun)


def describe(mention: Mention, phrase: NounPhrase, source: Source) -> None:
    """What stood before a noun, or was said to be so of it."""
    named = mention.noun.split()
    for token in phrase.qualities:
        if token.text in named and not token.has("material", "color", "shape"):
            continue
        _quality(mention, token, source)
    for token in _parts_of_name(phrase):
        _quality(mention, token, source, known=True)
    give_length(mention, phrase)
    if phrase.sides is not None:
        give_sides(mention, phrase.sides)


@cache
def _linking() -> frozenset[str]:
    """Words that only link others, and are no quality of anything."""
    groups = words("function_words")
    return frozenset(
        word for name in ("prepositions", "conjunctions", "auxiliaries", "politeness") for word in groups[name].split()
    )


def _parts_of_name(phrase: NounPhrase) -> Iterator[Token]:
    """Words of quality inside a name, such as the shape of a "round dining table"."""
    for word in phrase.text.split()[:-1]:
        kinds = {kind: value for kind, value in vocabulary().get(word, {}).items() if kind in _IN_NAMES}
        if kinds:
            yield Token(word, phrase.start, phrase.end, kinds)


def _quality(mention: Mention, token: Token, source: Source, known: bool = False) -> None:
    """One word about a thing; what is in its name is ``known`` and changes nothing but its attributes."""
    nouns = words("nouns")
    kind: AttributeKind = "size" if token.has("length") else "other"
    for name, of_kind in _KINDS:
        if token.has(name):
            kind = of_kind
            break
    if kind == "other" and token.has("noun") and not token.has("adjective"):
        return
    value = token.text
    if kind not in ("shape", "size", "style"):
        value = str(token.get("color") or token.get("material") or token.text)
    if token.text in nouns["states"]:
        kind = "state"
    elif kind == "other" and token.text in nouns["sizes"]:
        kind = "size"
    elif kind == "other" and token.has("adverbs", "density") and not token.has("adjective", "moods"):
        return
    elif kind == "other" and all(word in _linking() for word in token.text.split()):
        return  # "a bench of oak"
    value = nouns["made_of"].get(value, value)
    span = source.span(token.start, token.end)
    mention.attributes.append(Attribute(kind=kind, value=value, words=token.text, span=span))
    if known:
        return
    if token.has("color"):
        mention.color = token.get("color")
    elif token.has("material"):
        mention.material = value
    elif token.has("finish"):
        mention.words.append(token.text)
    elif token.has("scale"):
        mention.scale = float(token.get("scale"))
    elif token.has("styles"):
        mention.style = token.get("styles")
    elif not token.has("moods", "dim", "density"):
        mention.words.append(token.text)


def give_length(mention: Mention, phrase: NounPhrase) -> None:
    """ "1.6 m wide": a length [m] along the axis that a phrase names."""
    axis = next((t.get("dim") for t in phrase.qualities if t.has("dim")), None)
    if phrase.length is not None and axis is not None:
        mention.size[int(axis)], mention.scale = phrase.length, 1.0


def give_sides(mention: Mention, sides: tuple[float, ...]) -> None:
    """Two sides [m] and perhaps a height; the longer side lies as it does in the usual thing of that kind."""
    usual = category_named(mention.category).size
    long, short = max(sides[:2]), min(sides[:2])
    deep = usual is not None and sum(usual.depth) > sum(usual.width)
    mention.size[0:2] = (long, short) if deep else (short, long)
    if len(sides) > 2:
        mention.size[2] = sides[2]
    mention.scale = 1.0
