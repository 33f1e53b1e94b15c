"""What English words can be in a request: the files of ``lexicon``, nouns of the taxonomy, colours, kinds of rooms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.materials import color_words, finishes, print_words, shaded_colors
from sceneweaver.assets.taxonomy import category_named, phrases
from sceneweaver.io import packaged
from sceneweaver.knowledge.load import read_yaml, room_words

LONGEST = 8
"""Words of the longest phrase."""

_SMALL = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen twenty"
)
NUMBERS = {word: n for n, word in enumerate(_SMALL.split())} | {
    "thirty": 30,
    "forty": 40,
    "fifty": 50,
    "sixty": 60,
    "seventy": 70,
    "eighty": 80,
    "ninety": 90,
    "hundred": 100,
    "thousand": 1000,
    "million": 1_000_000,
    "billion": 1_000_000_000,
    "dual": 2,
}


_KINDS = {"places": "place", "dims": "dim", "materials": "material", "bounds": "bound", "adjectives": "adjective"}
"""Kinds whose section of ``words.yaml`` has another name."""


@dataclass(frozen=True)
class Place:
    """How a word says where something is: a type of relation, and which sides of its target."""

    type: str
    side: str | None = None
    each: bool = False
    words: str = ""
    over_each: bool = False
    """Whether what it is said of is each one of several, so that what stands there is counted out over them."""
    gap: tuple[float | None, float | None] = (None, None)
    """Least and largest distance [m], where one was given: "2 m from"."""
    nth: int = 0
    """Which one of several it is said of, in order: 3 for the third, -1 for the last; 0: any."""

    @property
    def params(self) -> dict[str, float]:
        """The distance as a relation has it."""
        return {name: end for name, end in zip(("min", "max"), self.gap, strict=True) if end is not None}


@dataclass(frozen=True)
class Verb:
    """A form of a verb: ``form`` is base, s, ed or ing; ``lemma`` its dictionary form."""

    lemma: str
    form: str


@cache
def words(file: str = "words") -> dict[str, Any]:
    """A file of the lexicon."""
    return read_yaml(packaged.text(__package__ or "", "lexicon", f"{file}.yaml"))


@cache
def group_rows() -> dict[str, dict[str, Any]]:
    """What stands for several things: parts of a room, and nouns for things of many kinds together."""
    data = words("groups")
    return data["groups"] | data["collections"]


@cache
def vocabulary() -> dict[str, dict[str, Any]]:
    """Every phrase that is known: phrase -> kind -> value."""
    table: dict[str, dict[str, Any]] = {}

    def put(phrase: Any, kind: str, value: Any) -> None:
        table.setdefault(" ".join(str(phrase).lower().replace("-", " ").split()), {}).setdefault(kind, value)

    data, nouns, relations = words(), words("nouns"), words("relations")
    for section, listed in data.items():
        if section == "amounts":
            continue
        kind = _KINDS.get(section, section)
        for value, group in listed.items() if isinstance(listed, dict) else [(None, listed)]:
            for phrase in group:
                put(phrase, kind, phrase if value is None else value)
    for region, listed in nouns["regions"].items():
        for phrase in listed:
            put(phrase, "region", region)
    for section in ("parts", "abstract", "containers"):
        for phrase in nouns[section]:
            put(phrase, section, phrase)
    for phrase, count in nouns["collectives"].items():
        put(phrase, "collective", count)
    for name, row in group_rows().items():
        heads = words("groups")["heads"] if row.get("about") else ()
        for phrase in (*row["words"], *(f"{about} {head}" for about in row.get("about", ()) for head in heads)):
            put(phrase, "group", name)
    for phrase, value in NUMBERS.items():
        put(phrase, "number", value)
    for phrase, value in data["amounts"].items():
        put(phrase, "amount", tuple(value))
    for section, kind in (("prepositions", "preposition"), ("adverbs", "place_adverb"), ("mutual", "mutual")):
        for name, patterns in relations[section].items():
            for phrase in expand(patterns):
                put(phrase, kind, _place(name, phrase))
    for phrase in relations["bare"]:
        put(phrase, "bare", True)
    for form, verb in _verbs(relations).items():
        put(form, "verb", verb)
    for phrase, finish in finishes().items():
        if not finish.asked:
            put(phrase, "finish", phrase)
    for phrase in color_words():
        put(phrase, "color", phrase)
    for phrase in shaded_colors():
        put(phrase, "color", phrase)
    for phrase in print_words():
        put(phrase, "material", phrase)
    for phrase, name in room_words().items():
        put(phrase, "room", name)
    for phrase, name in phrases().items():
        put(phrase, "noun", name)
        if phrase.endswith("s") and phrase in nouns["paired"]:
            continue
        put(plural(phrase), "noun", name)
        put(plural(phrase), "plural", True)
    _put_people(table, put)
    _put_refusals(put)
    _put_nothings(table, put)
    return table


Put = Callable[[Any, str, Any], None]
"""Adds a phrase with one of its kinds and its value."""


def _put_people(table: dict[str, dict[str, Any]], put: Put) -> None:
    """Who people are, and what they do."""
    people = words("asides")
    for role in people["roles"]:
        put(role, "people_words", role)
        put(plural(role), "people_words", role)
        put(plural(role), "plural", True)
    for phrase in people["persons"]:
        put(phrase, "person", phrase)
        if not table[phrase].keys() & {"stop", "while", "partial"}:
            put(phrase, "people_words", phrase)
    for phrase in people["modals"]:
        put(phrase, "modal", phrase)
    for phrase in people["passives"]:
        put(phrase, "passive", phrase)
    for kind, lemmas in (("action", people["actions"]), ("trade", people["trades"])):
        for lemma in lemmas:
            verb, _, rest = lemma.partition(" ")
            s, ed, ing = people["irregular"].get(verb) or _regular(verb)
            for form, word in (("base", verb), ("s", s), ("ed", ed), ("ing", ing)):
                put(f"{word} {rest}".strip(), kind, form)


def _put_refusals(put: Put) -> None:
    """Verbs of refusing, with who does it, are words of negation."""
    refusals = words("refusals")
    for phrase in (*refusals["alone"], *(f"{who} {verb}" for who in refusals["who"] for verb in refusals["verbs"])):
        put(phrase, "neg", phrase)


def _put_nothings(table: dict[str, dict[str, Any]], put: Put) -> None:
    """Words that name no object, where they are nothing else."""
    nothings = words("nothings")
    for phrase in nothings["idioms"]:
        put(phrase, "aside", phrase)
    for phrase in nothings["units"]:
        put(phrase, "unit", phrase)
    known = {
        phrase for phrase, kinds in table.items() if kinds.keys() - {"action", "trade", "passive", "modal", "unit"}
    }
    for phrase in nothings["adverbs"]:
        if phrase not in known:
            put(phrase, "adverbs", phrase)
    for phrase in nothings["adjectives"]:
        if phrase not in known:
            put(phrase, "adjective", phrase)
    for section in ("ways", "parts", "matters"):
        for phrase in nothings[section]:
            for form in dict.fromkeys((phrase, plural(phrase))):
                if form not in known:
                    put(form, "matter", phrase)
                    put(form, "plural", True) if form != phrase else None


def _place(name: str, phrase: str) -> Place:
    kind, _, side = name.partition(":")
    sides = phrase.split()
    each = bool({"each", "every", "either", "both"} & set(sides)) or (kind in ("flanking",))
    return Place(kind, side or None, each, phrase)


def expand(patterns: str | list[str]) -> list[str]:
    """The phrases that patterns stand for: "a|b c?" is a c, b c, a and b."""
    found = []
    for pattern in patterns.split(",") if isinstance(patterns, str) else patterns:
        parts = [
            [*part.removesuffix("?").split("|"), *([""] if part.endswith("?") else [])] for part in pattern.split()
        ]
        found += [" ".join(word for word in chosen if word) for chosen in product(*parts)]
    return found


def _verbs(relations: dict[str, Any]) -> dict[str, Verb]:
    data, table = relations["verbs"], {}
    known = {*data["posture"], *data["show"], *data["frames"]}
    for lemma in sorted(known):
        verb, _, rest = lemma.partition(" ")
        s, ed, ing, *others = relations["irregular"].get(verb) or _regular(verb)
        forms = {"s": s, "ed": ed, "ing": ing, "base": verb}
        for form, word in [*forms.items(), *(("s", word) for word in others)]:
            table.setdefault(f"{word} {rest}".strip(), Verb(lemma, form))
    for lemma, participles in data["participles"].items():
        for word in participles:
            table.setdefault(word, Verb(lemma, "ing" if word.endswith("ing") else "ed"))
    return table


def _regular(verb: str) -> tuple[str, str, str]:
    if verb.endswith("e"):
        return verb + "s", verb + "d", verb[:-1] + "ing"
    if verb.endswith("y") and verb[-2] not in "aeiou":
        return verb[:-1] + "ies", verb[:-1] + "ied", verb + "ing"
    short = len(verb) > 2 and verb[-1] in "tpnmgb" and verb[-2] in "aeiou" and verb[-3] not in "aeiou"
    stem = verb + verb[-1] if short and len(verb) < 5 else verb
    return verb + ("es" if verb.endswith(("s", "x", "ch", "sh")) else "s"), stem + "ed", stem + "ing"


def frame(verb: Verb) -> dict[str, Any] | None:
    """What a verb says of where things are: voice -> (type, which of the two is placed)."""
    return words("relations")["verbs"]["frames"].get(verb.lemma)


@cache
def shows(lemma: str) -> bool:
    """Whether what follows the verb is there as well."""
    return lemma in words("relations")["verbs"]["show"]


def plural(phrase: str) -> str:
    """The plural of a noun."""
    if phrase.endswith(("s", "x", "ch", "sh", "z")):
        return phrase + "es"
    if phrase.endswith("y") and phrase[-2:-1] not in "aeiou":
        return phrase[:-1] + "ies"
    if phrase.endswith("shelf"):
        return phrase[:-1] + "ves"
    if phrase.endswith("knife"):
        return phrase[:-2] + "ves"
    if phrase.endswith("man") and not phrase.endswith("human"):
        return phrase[:-3] + "men"
    return phrase + "s"


@cache
def category_of(name: str) -> str:
    """A category with a body: for a group its usual member."""
    found = categories().get(name)
    return name if found is not None and found.size is not None else resolve(name.replace("_", " ")).category


@cache
def family(category: str) -> str:
    """Seats, tables, or the group of the taxonomy that a category is in."""
    known, name = categories(), category_named(category).name
    while name in known and (parent := known[name].parent) is not None and parent in known and parent != "furniture":
        name = parent
    return {"chair_group": "seat", "seating": "seat", "table_group": "table"}.get(name, name)


@cache
def mounts(category: str) -> tuple[str, ...]:
    """Where a category goes: floor, wall, ceiling, surface, the usual one first."""
    return category_named(category).mount
