"""The words of whole homes, from ``lexicon/*.yaml``: one table of phrases with all that each may mean."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from sceneweaver.assets.plurals import singular
from sceneweaver.io import packaged
from sceneweaver.knowledge.load import read_yaml, room_words
from sceneweaver.plans.programme import Use as PlanUse

LONGEST = 9
"""Words of the longest phrase."""

_PERSON_KINDS = ("adults", "children", "babies", "twins", "couples", "seniors", "parents", "partners")
_PLACE_SINGULAR = frozenset(("living", "master", "administration", "dining", "recovery", "ladies", "gents", "waiting"))


@dataclass(frozen=True)
class RoomKind:
    """A kind of room of ``rooms.yaml``.

    Attributes:
        name: of the kind.
        type: of the plan (`sceneweaver.plans.room_types`).
        noun: what the room's own request calls it.
        counts_as: kinds that it is one of.
        whose: for whom it is by its name.
    """

    name: str
    type: str
    noun: str
    counts_as: tuple[str, ...] = ()
    whose: str = ""


@dataclass(frozen=True)
class Use:
    """A use of ``uses.yaml``: ``plan`` is that of the programme, ``means`` what words mean there."""

    name: str
    plan: PlanUse
    means: Mapping[str, str]
    needs: Mapping[str, int]
    staff: Mapping[str, str]
    storeys: Mapping[str, int]
    profile: str = "base"


@cache
def data(file: str) -> Mapping[str, Any]:
    """A file of the lexicon."""
    return read_yaml(packaged.text(__package__ or "", "lexicon", f"{file}.yaml"))


@cache
def room_kinds() -> Mapping[str, RoomKind]:
    """All kinds of rooms by name."""
    return {
        name: RoomKind(
            name, row.get("type", name), row.get("noun", row["words"][0]), tuple(row.get("is", ())), row.get("for", "")
        )
        for name, row in data("rooms").items()
    }


@cache
def trades() -> Mapping[str, Use]:
    """Businesses that are named beside a home alone, by name."""
    return {
        name: Use(name, "office", {plain(word): kind for word, kind in row["means"].items()}, row["needs"], {}, {})
        for name, row in data("trades").items()
    }


@cache
def uses() -> Mapping[str, Use]:
    """All uses by name."""
    return {
        name: Use(
            name,
            row["plan"],
            {plain(word): kind for word, kind in row.get("means", {}).items()},
            row.get("needs", {}),
            row.get("staff", {}),
            row.get("storeys", {}),
            row.get("profile", "base"),
        )
        for name, row in data("uses").items()
    }


def plain(phrase: str) -> str:
    """A phrase as it stands in the table: hyphens and slashes are spaces."""
    return " ".join(phrase.lower().replace("-", " ").replace("’", "'").replace("/", " / ").split())


@cache
def phrases() -> Mapping[str, Mapping[str, Any]]:
    """What each phrase may mean, by kind."""
    found: dict[str, dict[str, Any]] = {}

    def put(names: Iterable[Any], kind: str, value: Any = True) -> None:
        for name in names:
            found.setdefault(plain(str(name)), {}).setdefault(kind, value)

    for name, row in data("rooms").items():
        put(row["words"], "room", name)
    for use in uses().values():
        put(use.means, "means", True)
        for way, names in data("uses")[use.name]["words"].items():
            put(names, "use", (use.name, way == "whole"))
    for name, row in data("trades").items():
        put(row["words"], "trade", name)
    words, people = data("words"), data("people")
    for factor, names in words["sizes"].items():
        put(names, "size", float(factor))
    for joint, names in words["joints"].items():
        put(names, "joint", joint)
    for side, names in words["sides"].items():
        put(names, "side", side)
    put(words["alone"], "alone")
    for place, names in words["places"].items():
        put(names, "place", place)
    for storey, names in words["storeys"].items():
        put(names, "storey", storey)
    for kind in (
        "equal",
        "storey_words",
        "single_storey",
        "accessible",
        "no",
        "own",
        "each",
        "of_them",
        "them",
        "soft",
        "vague",
        "unmeasured",
        "units",
        "shared_by",
    ):
        put(words[kind], kind)
    for kind, names in words["envelope"].items():
        put(names, kind)
    for kind in _PERSON_KINDS:
        put(people[kind], "person", kind)
    put(people["families"]["words"], "person", "families")
    for kind in ("me", "we", "visitors", "staff", "groups"):
        put(people[kind], kind)
    put(people["animals"], "animal")
    put(words["function"], "function")
    return found


@cache
def activities() -> Mapping[str, str]:
    """What is done in rooms, with the kind of room that it makes."""
    return {plain(name): kind for kind, names in data("words")["activities"].items() for name in names}


def known(phrase: str) -> tuple[Mapping[str, Any], bool] | None:
    """What a phrase may mean, and whether it is a plural; None where no list has it."""
    table = phrases()
    if phrase in table:
        return table[phrase], False
    head, _, last = phrase.rpartition(" ")
    single = _single(last)
    if single != last and last not in _PLACE_SINGULAR:
        kinds = table.get(f"{head} {single}".strip())
        kept = {
            k: v
            for k, v in (kinds or {}).items()
            if k in ("trade", "room", "use", "person", "means", "visitors", "staff", "groups", "animal")
        }
        if kept:
            return kept, True
    if " " in phrase and _single(last) in data("words")["room_heads"]:
        kind = room_words().get(f"{head} {_single(last)}".strip())
        if kind is not None and kind not in room_kinds():
            return {"known_room": kind}, single != last
    owner = phrase.removesuffix("'s").removesuffix("s'")
    if owner != phrase and "person" in table.get(owner, {}):
        return {"person": table[owner]["person"]}, False
    return None


def _single(word: str) -> str:
    for ending in ("s'", "'s"):
        if word.endswith(ending):
            return word
    return singular(word)
