"""From the words of a user to a category: exact names, synonyms, plurals, spelling, and what is nearest."""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from functools import cache
from typing import Literal

from .category import Category, categories

How = Literal["exact", "synonym", "plural", "spelling", "head", "group", "generic"]

GENERIC = "object"
"""What stands in for a noun that nothing is known about: a labelled body of the asked size."""

_IRREGULAR = {
    "shelves": "shelf",
    "bookshelves": "bookshelf",
    "knives": "knife",
    "loaves": "loaf",
    "scarves": "scarf",
    "leaves": "leaf",
    "mice": "mouse",
    "people": "person",
    "children": "child",
    "men": "man",
    "feet": "foot",
    "mattresses": "mattress",
    "glasses": "glass",
    "couches": "couch",
    "benches": "bench",
    "boxes": "box",
    "dishes": "dish",
    "brushes": "brush",
    "buses": "bus",
    "vases": "vase",
    "cacti": "cactus",
    "pouffes": "pouffe",
    "bonsai": "bonsai",
    "tomatoes": "tomato",
    "potatoes": "potato",
    "pianos": "piano",
    "photos": "photo",
}


@dataclass(frozen=True)
class Match:
    """What a noun was taken for, and how; ``note`` is a sentence for the user unless the name was known."""

    category: str
    how: How
    note: str = ""


@cache
def _words() -> dict[str, tuple[str, How]]:
    """Every known word: names before synonyms before plurals."""
    table: dict[str, tuple[str, How]] = {}
    known = categories()
    for name, category in known.items():
        table[category.words] = (name, "exact")
    for name, category in known.items():
        for word in category.synonyms:
            table.setdefault(word.lower(), (name, "synonym"))
    for name, category in known.items():
        if category.plural:
            table.setdefault(category.plural.lower(), (name, "plural"))
    return table


@cache
def phrases() -> dict[str, str]:
    """Every known word or phrase, lower case, with the category or group that it names."""
    return {word: name for word, (name, _) in _words().items()}


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
    known = categories()
    if thing not in known or carrier not in known:
        return None
    for rank, kind in enumerate(known[thing].on):
        if carrier == kind or carrier.endswith(f"_{kind}"):
            return rank
    return len(known[thing].on) if thing in known[carrier].holds else None


def resolve(noun: str) -> Match:
    """The category that a noun means; never fails, but says how sure it is.

    Tried in turn: the name, a synonym, a plural, a spelling near to one of them, the last word of a compound
    ("gaming throne chair" is a chair), and at last a generic body that carries the noun as its label.
    """
    asked = " ".join(noun.replace("_", " ").replace("-", " ").lower().split())
    table = _words()
    for word, plural in ((asked, False), (singular(asked), True)):
        if word in table:
            name, how = table[word]
            if categories()[name].size is None:
                return _of_group(noun, name)
            return Match(name, "plural" if plural and how == "exact" else how)
    near = difflib.get_close_matches(singular(asked), table, n=1, cutoff=0.82) if len(asked) > 3 else []
    if near:
        name = table[near[0]][0]
        if categories()[name].size is not None:
            return Match(name, "spelling", f"'{noun}' was taken for '{near[0]}'")
    words = asked.split()
    for start in range(1, len(words)):
        for word in (" ".join(words[start:]), singular(" ".join(words[start:]))):
            if word in table and categories()[table[word][0]].size is not None:
                return Match(table[word][0], "head", f"'{noun}' is not known; a {word} stands for it")
    if len(words) == 1:
        for word in (asked, singular(asked)):
            tails = [known for known in table if len(known) > 3 and word.endswith(known)]
            if tails:
                best = max(tails, key=len)
                if categories()[table[best][0]].size is not None:
                    return Match(table[best][0], "head", f"'{noun}' is not known; a {best} stands for it")
    return Match(GENERIC, "generic", f"'{noun}' is not known; a plain labelled body stands for it")


def singular(words: str) -> str:
    """The last word without its plural ending."""
    head, _, last = words.rpartition(" ")
    if last in _IRREGULAR:
        last = _IRREGULAR[last]
    elif last.endswith("ies") and len(last) > 4:
        last = last[:-3] + "y"
    elif last.endswith(("sses", "shes", "ches", "xes", "zes")):
        last = last[:-2]
    elif last.endswith("s") and not last.endswith(("ss", "us", "is")) and len(last) > 3:
        last = last[:-1]
    return f"{head} {last}".strip()


def _of_group(noun: str, group: str) -> Match:
    """A group's word ("seat") means its most usual member: the one that a group names first, by its own name."""
    names = members(group)
    if not names:
        return Match(GENERIC, "generic", f"'{noun}' is not known; a plain labelled body stands for it")
    usual = categories()[group].usual or names[0]
    return Match(usual, "group", f"'{noun}' may be many things; a {categories()[usual].words} stands for it")
