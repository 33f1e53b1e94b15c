"""Limits on all things of a kind: "no shelf above 137 cm", "no table lower than 70 cm", "nothing taller than 30 cm".

Such a thing may be there, and none beyond the limit: it is no exclusion. Things that a request names and those that
a room has anyhow are meant alike.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from sceneweaver.assets.plurals import singular

from ..alternatives import one_of
from ..exclusions import names_of
from ..model import StatedMeasure
from ..parsed import Parsed, Told
from ..source import Source
from ..vocabulary import mounts, words
from .lengths import BOUNDED, bounded_length
from .measures import REACH, WORKTOPS
from .phrases import Edits
from .resolve import is_thing

ALL = "object"
"""The kind of all things."""


def limits(source: Source, parsed: Parsed) -> None:
    """Adds every limit on the things of a kind, and takes its words out."""
    edits = Edits(source)
    for found in list(_pattern().finditer(source.text)):
        noun = " ".join((found["noun"] or "").split())
        if not edits.free(*found.span()) or not (found["nothing"] or noun):
            continue
        said = _said(found, noun)
        if said is None:
            continue
        on = found["on"] or ""
        span = edits.take(*found.span(), f"the {on}" if on else "")
        measure = StatedMeasure(**said, words=" ".join(found[0].split()), span=span, on=on)
        if noun and _is_worktop(noun):
            worktop = measure.model_copy(update={"quantity": "top", "categories": ()})
            parsed.measures.append(Told(worktop, WORKTOPS, after=False))
        else:
            parsed.limits.append(measure)


def _said(found: re.Match[str], noun: str) -> dict[str, Any] | None:
    """What a limit is on and how far it goes; None where it is on no thing, or no length of one."""
    data, comparison = words("limits"), found["comparison"]
    bound = "most" if any(comparison in several for several in data["most"].values()) else "least"
    quantity = next(name for name, several in data[bound].items() if comparison in several)
    quantity = data["axes"].get(found["axis"] or "", quantity)
    if found["level"]:
        low, high = words("measures")["levels"][found["level"]]
        end = high if bound == "most" else low
    else:
        low, high, _ = bounded_length(found)
        end = high if high is not None else low
    categories: tuple[str, ...] = (ALL,)
    if noun and not _is_worktop(noun):
        categories = _kinds(noun)
        small = bool(categories) and all(mounts(name)[0] == "surface" for name in categories[:1])
        quantity = "height" if small and quantity == "upper" and bound == "most" else quantity
    elif found["on"] and quantity == "upper":
        quantity = "height"
    if not categories or end is None or not REACH[0] <= end <= REACH[1]:
        return None
    if bound == "least" and quantity == "upper":
        quantity = "lowest"
    return {"quantity": quantity, ("high" if bound == "most" else "low"): end, "categories": categories}


def _is_worktop(noun: str) -> bool:
    return singular(noun) in [singular(name) for name in words("measures")["worktops"]]


def _kinds(noun: str) -> tuple[str, ...]:
    """The categories, or groups of them, that a limit on a noun is for; none where it is no thing that is known."""
    one = singular(noun)
    last = one.split()[-1]
    if not is_thing(one):
        return ()
    names = names_of(one)
    if last in words("limits")["by_name"]:
        names = tuple(name for name in names if last in name.split("_"))
    return tuple(dict.fromkeys((*names, *words("limits")["also"].get(one, ()))))


@cache
def _pattern() -> re.Pattern[str]:
    data = words("limits")
    compared = one_of([word for bound in ("most", "least") for several in data[bound].values() for word in several])
    levels = "|".join(words("measures")["levels"])
    above = one_of(words("measures")["above"])
    return re.compile(
        rf"\b(?:(?P<nothing>{one_of(data['nothing'])})|{one_of(data['none'])} (?P<noun>(?:[a-z-]+ ){{0,2}}?[a-z-]+))"
        rf"(?:,? {one_of(data['between'])}\b){{0,4}} (?P<comparison>{compared}) (?:about |around |just )?"
        rf"(?:(?:{BOUNDED})(?:\s?(?P<axis>{one_of(data['axes'])})\b)?(?: (?:{above}))?"
        rf"|(?:my |the |your |a |his |her |our )?(?P<level>{levels})(?:'s)?(?:[ -](?:level|height|high))?\b)"
        r"(?: on (?:the |any |a |each |every |top of the )(?P<on>[a-z]+)\b)?"
    )


__all__ = ["ALL", "limits"]
