"""From the words of a user to a category: names, synonyms, plurals, compounds, spelling; else a labelled body."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from importlib import resources
from itertools import combinations
from typing import Any, Literal

from sceneweaver.io import packaged

from .asset import Mount
from .category import Category, categories, read_yaml
from .looks import is_look
from .materials import finishes_named
from .plurals import singular, slips
from .wordnet import NOTHING, noun_named, of_head

_NO_KIND = frozenset(("high", "open", "plush", "little", "old"))
"""Words that say how a thing is and, before a noun, name another: a chair that is high is no high chair."""

How = Literal["exact", "synonym", "plural", "spelling", "like", "head", "group", "generic"]

GENERIC = "object"
"""The parent of the bodies that stand for nouns which no category fits."""

_OF_MOUNT: dict[Mount, tuple[str, ...]] = {
    "wall": ("generic_panel", "generic_fixture"),
    "ceiling": ("generic_hanging",),
    "floor": ("generic_furniture", "generic_machine", "generic_table", "generic_stand", "generic_rack", "generic_mat"),
    "surface": (
        "generic_item",
        "generic_tool",
        "generic_sheet",
        "generic_device",
        "generic_figure",
        "generic_vessel",
        "generic_soft",
    ),
}


_ADJECTIVE = re.compile(r"..(ed|ing|ful|ous|able|ible|ish|less|ive|ical|esque)$")
"""How words end that describe a thing rather than name its kind."""


@dataclass(frozen=True)
class Match:
    """What a noun was taken for, and how.

    ``category`` is what the object is called in a scene: a category of the taxonomy or, where none fits, the noun
    itself ("zebra_crossing"). ``body`` is the category that draws it: a ``generic_*`` one for such a noun, or one whose
    body may stand for it.
    ``modifiers`` are the words before the noun that are no part of its name: colours, materials, sizes, others.
    ``note`` is a sentence for the user unless the name was known.
    """

    category: str
    how: How
    note: str = ""
    body: str = ""
    modifiers: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "body", self.body or self.category)

    @property
    def generic(self) -> bool:
        """Whether a labelled body of typical size stands for the noun."""
        return self.how == "generic"


@cache
def _words() -> dict[str, tuple[str, How]]:
    """Every known word: names before synonyms before plurals."""
    table: dict[str, tuple[str, How]] = {}
    known = categories()
    for name, category in known.items():
        table[category.words] = (name, "exact")
    for name, category in known.items():
        for word in category.synonyms:
            table.setdefault(_plain(word), (name, "synonym"))
    for name, category in known.items():
        for word in category.like:
            table.setdefault(_plain(word), (name, "like"))
    for name, category in known.items():
        if category.plural:
            table.setdefault(_plain(category.plural), (name, "plural"))
    for word, (name, how) in list(table.items()):
        table.setdefault(singular(word), (name, how if how == "like" else "synonym"))
    return table


@cache
def phrases() -> dict[str, str]:
    """Every known word or phrase, lower case, with the category or group that it names; of a thing that another's body
    stands for, its own name."""
    return {word: singular(word).replace(" ", "_") if how == "like" else name for word, (name, how) in _words().items()}


@cache
def members(group: str) -> tuple[str, ...]:
    """The categories with a body that belong to a group, directly or not."""
    known = categories()

    def belongs(category: Category) -> bool:
        parent = category.parent
        while parent is not None:
            if parent == group:
                return True
            parent = known[parent].parent if parent in known else None
        return False

    return tuple(name for name, category in known.items() if category.size is not None and belongs(category))


@cache
def likeliness(thing: str, carrier: str) -> int | None:
    """How unlikely a category is to stand on another: 0 where it stands first of all; None: nowhere near usual.

    What is said of a desk goes for a standing desk, too: a compound is of the kind of its last words.
    """
    known, one, other = categories(), category_named(thing), category_named(carrier)
    for rank, kind in enumerate(one.on):
        if carrier == kind or carrier.endswith(f"_{kind}") or (carrier not in known and other.name == kind):
            return rank
    return len(one.on) if thing in other.holds else None


@lru_cache(maxsize=4096)
def category_named(name: str, mount: Mount | None = None) -> Category:
    """What is known about the category of a scene's object, whatever it is: of a noun that no category fits, what is
    known about the body that stands for it, under that noun."""
    known = categories()
    if name in known and known[name].size is not None:
        return known[name]
    match = resolve(name, mount)
    found = known[match.body]
    return found if match.body == match.category else found.model_copy(update={"name": match.category})


@lru_cache(maxsize=4096)
def resolve(noun: str, mount: Mount | None = None) -> Match:
    """The category that a noun, or a noun with the words before it, means; never fails, but says how sure it is.

    Tried in turn: the name, a synonym, a plural; what is in "a pair of"; a spelling near to a known name; the longest
    known end of a compound, with those of the words before it that make it a narrower thing ("round wooden mirror" is
    a round mirror); the body of what a dictionary says it is a kind of; and at last a labelled body, whose kind and
    size the last word decides.

    Args:
        noun: lower or upper case, with blanks, hyphens or underscores, singular or plural, without article or number.
        mount: what the request says holds it, which decides among the labelled bodies; None when nothing was said.
    """
    asked = _plain(noun)
    return (
        _known(noun, asked)
        or _contents(asked, mount)
        or _misspelt(noun, asked)
        or _compound(noun, asked)
        or _closed(noun, asked)
        or _akin(noun, asked, mount)
        or _labelled(noun, asked, mount)
    )


@lru_cache(maxsize=4096)
def narrower(category: str, words: str, noun: str = "") -> str:
    """The category that words about a thing make of it ("king size" of a bed), else the category itself.

    They stand before its name or the noun that was said, not before other names of it: a movable kitchen island is no
    "movable counter". A colour, a material or "high" makes nothing else of a thing.
    """
    table, known = _words(), categories()
    if category not in known:
        return category
    plain = [word for word in _plain(words).split() if word not in _NO_KIND and not finishes_named(word)]
    for chosen in _choices(plain):
        for name in (known[category].words, singular(_plain(noun))):
            narrow = table.get(f"{' '.join(chosen)} {name}")
            if narrow is not None and narrow[1] != "like" and known[narrow[0]].size is not None:
                return narrow[0]
    return category


def _plain(text: str) -> str:
    return " ".join(re.sub(r"[_\-]+", " ", text.lower()).split())


def _known(noun: str, asked: str) -> Match | None:
    table = _words()
    for word, plural in ((asked, False), (singular(asked), True)):
        if word in table:
            name, how = table[word]
            if categories()[name].size is None:
                return _of_group(noun, name)
            if how == "like":
                note = f"there is no {word}; the body of a {categories()[name].words} stands for it"
                return Match(singular(word).replace(" ", "_"), how, note, name)
            return Match(name, "plural" if plural and how == "exact" else how)
    return None


def _compound(noun: str, asked: str) -> Match | None:
    """The longest end that is known, narrowed by words before it."""
    words = asked.split()
    if is_no_thing(asked):
        return None
    for start in range(1, len(words)):
        before, end = words[:start], singular(" ".join(words[start:]))
        narrow = next((c for c in _choices(before) if f"{' '.join(c)} {end}" in _words()), ())
        found = _known(noun, f"{' '.join(narrow)} {end}".strip())
        if found is None or found.how == "group":
            continue
        rest = [word for word in before if word not in narrow]
        found, rest = _narrowed(found, rest)
        strange = [word for word in rest if not is_look(word)]
        if not strange or is_look(" ".join(rest)):
            return replace(found, modifiers=tuple(rest))
        if found.how == "like" or end in _lexicon()["not_heads"]:
            return None
        name = holder(end, strange[-1]) or found.category
        note = f"'{noun}' is not known; a {categories()[name].words} stands for it"
        return Match(name, "head", note, modifiers=tuple(rest))
    return None


def holder(end: str, held: str) -> str | None:
    """What a rack is by the kind of thing that is on it: a "kimono rack" is one for clothes; None: as any rack."""
    meant = noun_named(singular(held))
    if meant is None or meant.sure < CERTAIN:
        return None
    return _lexicon()["holders"].get(end, {}).get(meant.kind)


def _narrowed(found: Match, rest: list[str]) -> tuple[Match, list[str]]:
    """A category made narrower by words before it, under any of its names: a round wall mirror is a round mirror."""
    if found.how == "like":
        return found, rest
    table, category = _words(), categories()[found.category]
    for words in _choices(rest):
        for name in (category.words, *category.synonyms):
            narrow = table.get(f"{' '.join(words)} {_plain(name)}")
            if narrow is None or narrow[1] == "like" or categories()[narrow[0]].size is None:
                continue
            if name != category.words and finishes_named(" ".join(words)):  # what it is made of says no more than that
                continue
            if narrow[0] != found.category:
                return Match(*narrow), [word for word in rest if word not in words]
            if not is_look(" ".join(words)):  # a "three-legged stool" is a stool
                return found, [word for word in rest if word not in words]
    return found, rest


def _choices(words: list[str]) -> Iterator[tuple[str, ...]]:
    """Words that may belong to the name, most of them first; at most six are looked at."""
    words = words[-6:]
    for count in range(min(3, len(words)), 0, -1):
        yield from combinations(words, count)


def _contents(asked: str, mount: Mount | None) -> Match | None:
    """ "A pair of X" is X, "a jar of X" a jar, "a bed with X" a bed; each by its own words."""
    head, link, rest = asked.partition(" with ") if " with " in asked else asked.partition(" of ")
    if not link:
        return None
    if link == " with ":
        match = resolve(head, mount)
        return replace(match, modifiers=(*match.modifiers, *rest.split()))
    collective = singular(head).split()[-1] in _lexicon()["collective"]
    match = resolve(rest if collective else head, mount)
    if not collective and categories()[match.body].parent == "sanitary":  # a tub of clay
        match, collective = resolve(rest, mount), True
    if collective:
        return match
    return None if match.generic else replace(match, modifiers=(*match.modifiers, rest))


def _misspelt(noun: str, asked: str) -> Match | None:
    """A known name of which one word has a slip; what is a word of some name is no slip of another."""
    words = singular(asked).split()
    strange = [word for word in words if word not in _single_words() and not is_look(word)]
    if len(strange) != 1 or len(strange[0]) < 5:
        return None
    (word,) = strange
    if word in near_words() or noun_named(word) is not None:
        return None
    alike = [known for known in _single_words() if known[0] == word[0] and abs(len(known) - len(word)) <= 2]
    for near in difflib.get_close_matches(word, alike, n=3, cutoff=0.8):
        if slips(word, near) <= (1 if len(word) < 9 else 2):
            meant = " ".join(near if w == word else w for w in words)
            found = _known(noun, meant)
            if found is not None and found.how != "group":
                return replace(found, how="spelling", note=f"'{noun}' was taken for '{meant}'")
    return None


def is_no_thing(noun: str) -> bool:
    """Whether a dictionary has a noun's last two words, and they are no thing whatever the last is: a fire drill."""
    words = noun.split()
    tail = " ".join(words[-2:])
    if len(words) < 2 or tail in _words() or singular(tail) in _words():
        return False
    meant = noun_named(tail)
    return meant is not None and meant.sure <= UNLIKELY and meant.kind in NOTHING


@cache
def near_words() -> frozenset[str]:
    """Words of English, singular, that a slip would turn into the name of a thing: "dressed" is no dresser."""
    lines = packaged.text(__package__ or "", "near_words.txt").splitlines()
    return frozenset(word for line in lines if not line.startswith("#") for word in line.split())


@cache
def _single_words() -> list[str]:
    """Every word of a name, and what says the kind of a labelled body."""
    return sorted({word for phrase in (*_words(), *_heads()) for word in phrase.split()})


def _closed(noun: str, asked: str) -> Match | None:
    """ "Sidetable" is a table: only for words of furniture."""
    for word in (asked, singular(asked)):
        for end in ("chair", "table", "desk", "lamp", "shelf", "cabinet", "sofa", "stool", "bench", "shelves"):
            if " " not in word and word.endswith(end) and len(word) > len(end) + 2:
                match = resolve(f"{word.removesuffix(end)} {end}")
                if not match.generic:
                    return Match(match.category, "head", match.note or f"'{noun}' was read as a {end}")
    return None


UNLIKELY = 1
"""Tenths of its use up to which a noun is hardly ever a thing."""

CERTAIN = 7
"""Tenths of its use from which a noun is a thing of one kind, so that the body of another of that kind may be it."""


def _akin(noun: str, asked: str, mount: Mount | None) -> Match | None:
    """A noun that is a kind of what is known ("tankard"), under its own name with the body of that."""
    name, modifiers = _label(asked)
    meant = of_head(asked.partition(" of ")[0])
    if meant is None or not meant.is_thing or meant.sure < CERTAIN or not name or name in categories():
        return None
    known = categories().get(meant.category)
    if known is None or known.size is None or (mount is not None and mount not in known.mount):
        return None
    note = f"there is no {name.replace('_', ' ')}; the body of a {known.words} stands for it"
    return Match(name, "generic", note, known.name, modifiers=modifiers)


def _labelled(noun: str, asked: str, mount: Mount | None) -> Match:
    """A body of typical size with the noun as its category.

    A dictionary says which kind of body where its last word does not.
    """
    name, modifiers = _label(asked)
    spoken = asked.partition(" of ")[0]
    heads, words, meant = _heads(), _label(spoken)[0].split("_"), of_head(spoken)
    tails = [" ".join(words[k:]) for k in range(len(words))]
    usual = _lexicon()["kinds"].get(meant.kind) if meant is not None else None
    body = next((heads[tail] for tail in tails if tail in heads), usual or _lexicon()["default"])
    if mount is not None and body not in _OF_MOUNT[mount] and body != GENERIC:
        body = _OF_MOUNT[mount][0]
    if not name or name in categories():  # a group's or a generic body's own name
        name, body = GENERIC, body if name else GENERIC
    note = f"'{noun}' is not known; a plain labelled body stands for it"
    return Match(name, "generic", note, body, modifiers=modifiers)


def _label(asked: str) -> tuple[str, tuple[str, ...]]:
    """A noun as the name of a category, without the words before it that describe it, and those words."""
    words = re.sub(r"[^a-z0-9 ]", "", asked).split()
    noun = (k for k, word in enumerate(words) if not is_look(word) and not _ADJECTIVE.search(word))
    first = min(next(noun, len(words)), max(0, len(words) - 1))
    return singular(" ".join(words[first:])).replace(" ", "_"), tuple(words[:first])


@cache
def _lexicon() -> dict[str, Any]:
    found = read_yaml(resources.files(__package__ or "").joinpath("nouns.yaml"))
    return found | {"not_heads": frozenset(found["not_heads"]), "collective": frozenset(found["collective"])}


@cache
def _heads() -> dict[str, str]:
    """The labelled body of each last word."""
    table: dict[str, str] = {}
    for body, words in _lexicon()["heads"].items():
        for word in words:
            table.setdefault(singular(word), body)
            table.setdefault(word, body)
    return table


def is_head(noun: str) -> bool:
    """Whether a noun, singular or plural, says of itself what kind of body a thing has: "stand", "panel"."""
    return noun.lower() in _heads() or singular(noun.lower()) in _heads()


def _of_group(noun: str, group: str) -> Match:
    """A group's word ("seat") means its most usual member: the one that a group names first, by its own name."""
    names = members(group)
    usual = categories()[group].usual or names[0]
    return Match(usual, "group", f"'{noun}' may be many things; a {categories()[usual].words} stands for it")
