"""Things on a table that a call gives a place among each other: beside, upon, before each seat, at the back left."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.io.messages import show, suggest
from sceneweaver.knowledge.surfaces import Arrangement, Slot
from sceneweaver.scene import InputError

from .surface_slots import Layout

REGIONS: Mapping[str, tuple[float, float]] = {
    "middle": (0.5, 0.0),
    "back": (0.15, 0.0),
    "front": (0.85, 0.0),
    "left": (0.5, -0.8),
    "right": (0.5, 0.8),
    "back left": (0.15, -0.8),
    "back right": (0.15, 0.8),
    "front left": (0.85, -0.8),
    "front right": (0.85, 0.8),
}
"""Parts of a top as its user sees them, as depth and side of a slot."""

SAID = ("name", "by", "side", "upon", "at", "each", "on")
"""Keys of a row by which it has a place; one with none of them stands where there is room."""

PREFIX = "said-"
"""Before the ids of the slots, to tell them from those of an arrangement."""

MOST = 6
"""Things of one row that has a place."""

REACH = 0.3
"""How far [m] a thing may move from the part of the top that is said to where there is room."""


@dataclass(frozen=True)
class Said:
    """One row with a place: its slot, the support that it names, and its look."""

    slot: Slot
    support: str | None
    look: Mapping[str, str]


def is_said(row: Mapping[str, Any]) -> bool:
    """Whether a row says where among the others its thing stands."""
    return any(row.get(key) is not None for key in SAID)


def said_rows(rows: Sequence[Mapping[str, Any]], where: str = "objects") -> list[Said]:
    """Rows of ``objects`` as slots; what is beside or upon another stands on the same support.

    Raises:
        InputError: for a category that nothing draws, a place that is none, or a row that refers to none before it.
    """
    found: list[Said] = []
    names: dict[str, int] = {}
    for k, row in enumerate(rows):
        at = f"{where}[{k}]"
        match = resolve(str(row["category"]), "surface")
        category = match.category
        if category not in categories() or categories()[category].size is None:
            raise InputError(
                f"{at}.category: nothing draws a {show(row['category'])}; name another, or leave its place out"
            )
        count = int(row.get("count", 1))
        if not 1 <= count <= MOST:
            raise InputError(f"{at}.count: {count} is more than {MOST}, which is the most for things with a place")
        given = [key for key in ("by", "upon", "at", "each") if row.get(key) is not None]
        if len(given) > 1 and set(given) != {"by", "each"}:
            raise InputError(f"{at} has {' and '.join(given)}; it stands in one place: give one of them")
        anchor = _named(row.get("by") or row.get("upon"), names, at)
        support = row.get("on")
        if anchor is not None:
            support = support or found[anchor].support
            if support != found[anchor].support:
                raise InputError(f"{at}.on is {show(support)}, and what it is beside stands on {found[anchor].support}")
        slot = Slot(
            id=f"{PREFIX}{k}",
            what=(category,),
            need="needed",
            count=count if "each" not in given else 1,
            by=found[anchor].slot.id if anchor is not None and "by" in given else None,
            on=found[anchor].slot.id if anchor is not None and "upon" in given else None,
            at=_region(row.get("at"), at)
            if "by" not in given and "upon" not in given and "each" not in given
            else None,
            side=row.get("side") or "beside",
            each=row.get("each"),
            relate="near" if "by" in given else "on_top" if "upon" in given else None,
            fixed=True,
            drift=0.0,
            loose=2.0,
            reach=REACH,
        )
        look = {key: str(row[key]) for key in ("color", "material", "style", "words") if row.get(key)}
        found.append(Said(slot, support, look))
        for name in (row.get("name"), category, str(row["category"])):
            if name:
                names[str(name)] = k
    return found


def _named(name: Any, names: Mapping[str, int], where: str) -> int | None:
    """The row that a name means; None for no name."""
    if name is None:
        return None
    if name in names:
        return names[name]
    category = resolve(str(name), "surface").category
    if category in names:
        return names[category]
    raise InputError(f"{where}: {show(name)} is no row before it{suggest(name, names, what='those before it')}")


def _region(word: Any, where: str) -> tuple[float, float]:
    if word is None:
        return REGIONS["middle"]
    if word not in REGIONS:
        raise InputError(f"{where}.at is {show(word)}{suggest(word, REGIONS, what='one of')}")
    return REGIONS[word]


def with_said(plan: Arrangement, said: Sequence[Said], only: bool) -> Arrangement:
    """An arrangement with the slots of some rows before its own, without what they name already; or these alone."""
    own = Arrangement(name=plan.name, description=plan.description, slots=tuple(one.slot for one in said)).slots
    kinds = {name for slot in own for name in slot.what}
    rest: list[Slot] = []
    for slot in () if only else plan.slots:
        left = tuple(c for c in slot.what if c not in kinds)
        if left:
            rest.append(slot.model_copy(update={"what": left}))
    return plan.model_copy(update={"slots": (*own, *rest)})


def lost(said: Sequence[Said], done: Layout) -> list[str]:
    """Categories of rows of which less stands than was said, beyond those that are reported as missing."""
    wanted = Counter(one.slot.what[0] for one in said for _ in range(one.slot.count))
    there = Counter(o.category for o in done.objects) + Counter(done.missing)
    return [category for category, count in wanted.items() if there[category] < count]
