"""Lengths and states that patterns read, as those of the things that a request names: whose they are, what they do."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.assets.category import Category
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named

from .model import Attribute, StatedMeasure
from .parsed import Left, Mention, Parsed, Told
from .statements.measures import WORKTOPS
from .things import singular
from .vocabulary import words

TOP = 0.09
"""Thickness [m] of a top with its frame, below which knees are."""

_EXTENTS = {"depth": 0, "width": 1, "height": 2}


def measured(parsed: Parsed, mentions: Sequence[Mention], text: str) -> list[tuple[StatedMeasure, Mention | None]]:
    """The lengths with the things that they are of, which get their sizes; None stands for the worktops of the room.

    Those of no thing that is named are left as words that were not understood.
    """
    found: list[tuple[StatedMeasure, Mention | None]] = []
    for told in parsed.measures:
        assert isinstance(told.what, StatedMeasure)
        mention = None if told.noun == WORKTOPS else named_by(told, mentions, text)
        if told.what.quantity == "knee":
            mention = _sat_at(told.what, mentions) or mention
        elif mention is not None and told.what.low is None:
            mention = _bearer(told.what, mention, mentions, text)
        if mention is None and told.noun != WORKTOPS:
            parsed.unread.append(Left(told.what.words, span=told.what.span))
            continue
        found.append((told.what if mention is None else _meant(told.what, mention), mention))
    for mention in {id(m): m for _, m in found if m is not None}.values():
        said = [measure for measure, m in found if m is mention]
        _give(mention, said)
    return found


def _sat_at(measure: StatedMeasure, mentions: Sequence[Mention]) -> Mention | None:
    """The table or basin named last before what is said of the room for knees below it."""
    start = measure.span.start if measure.span is not None else 0
    before = [m for m in mentions if m.span is not None and m.span.start < start]
    tops = [m for m in before if m.family == "table" or "basin" in m.category or has_role(m.category, "seated_at")]
    return max(tops, key=lambda m: m.span or (0, 0), default=None)


_BEARING = ("with", "for", "of", "full of")
"""Words between what bears things and them."""


def _bearer(measure: StatedMeasure, mention: Mention, mentions: Sequence[Mention], text: str) -> Mention:
    """What a small thing stands on or in, where a limit of height is beyond any such thing: of "shelves with bins no
    higher than 90 cm" the shelves are no higher."""
    known = category_named(mention.category).size
    if measure.quantity not in ("height", "placed") or not mention.is_small or known is None or measure.high is None:
        return mention
    if measure.high <= known.reach[2][1] or mention.span is None:
        return mention
    start = mention.span.start
    before = [m for m in mentions if m.span is not None and m.span.end <= start]
    bearer = max(before, key=lambda m: m.span or (0, 0), default=None)
    if bearer is None or bearer.span is None or text[bearer.span.end : start].strip().lower() not in _BEARING:
        return mention
    return bearer


def give_states(parsed: Parsed, mentions: Sequence[Mention], text: str) -> None:
    """States and looks become attributes of the things that they are said of; those of none are not understood."""
    for told in (*parsed.states, *parsed.appearances):
        assert isinstance(told.what, Attribute)
        mention = named_by(told, mentions, text)
        if mention is None:
            parsed.unread.append(Left(told.what.words, span=told.what.span))
            continue
        mention.attributes.append(told.what)
        if told.what.count is None and told.what.kind == "color":
            mention.color = mention.color or told.what.value
        elif told.what.count is None and told.what.kind == "material":
            mention.material = mention.material or told.what.value
        elif told.what.kind == "finish":
            mention.words.append(told.what.words)


def worktop_categories() -> frozenset[str]:
    """What has a worktop where a request speaks of those of the room."""
    return frozenset(words("measures")["worktop_categories"])


def named_by(told: Told, mentions: Sequence[Mention], text: str) -> Mention | None:
    """The thing that something is said of: the next one of that name in the sentence, before or behind its words."""
    assert told.what.span is not None
    start, end = told.what.span
    placed = [m for m in mentions if m.span is not None]
    if told.after:
        near = [m for m in placed if m.span is not None and m.span.end > end and "." not in text[end : m.span.start]]
        return min(near, key=lambda m: m.span or (0, 0), default=None)
    first = max(text.rfind(mark, 0, start) for mark in (". ", "\n", "; ")) + 1
    before = [m for m in placed if m.span is not None and m.span.start < start]
    near = [m for m in before if m.span is not None and first <= m.span.start]
    head = singular(told.noun.replace("-", " ")).split()[-1]
    named = [
        m for m in before if head in singular(m.noun.replace("-", " ")).split()
    ]  # "The desk is 2 m wide": it was named earlier
    same = [m for m in near if m in named] or named
    return max(same if told.named else same or near, key=lambda m: m.span or (0, 0), default=None)


def _meant(measure: StatedMeasure, mention: Mention) -> StatedMeasure:
    """The length with what it is of a thing of that kind: "at 90 cm" is the top of a table, and the middle of a
    picture."""
    kind = measure.quantity
    shapes = {a.words for a in mention.attributes if a.kind == "shape"} | set(mention.noun.split())
    if kind == "length" and "round" in shapes:
        kind = "diameter"
    elif kind == "length" and "square" in shapes:
        kind = "side"
    elif kind == "placed" and mention.mount == "floor":
        kind = "seat" if mention.family == "seat" else "top"
    elif kind == "placed" and mention.mount == "wall" and measure.low is None:
        kind = "upper"
    elif kind == "placed" and mention.mount == "wall" and category_named(mention.category).parent == "decor":
        kind = "centre"
    elif kind == "height" and mention.mount == "ceiling":
        kind = "height"
    return measure.model_copy(update={"quantity": kind})


def _give(mention: Mention, said: Sequence[StatedMeasure]) -> None:
    """A thing gets the extents that are said of it, and becomes of the kind that can have them."""
    known = category_named(mention.category).size
    deep = known is not None and sum(known.depth) > sum(known.width)
    plan = (1, 2) if mention.mount == "wall" else (0, 1)
    kinds = {measure.quantity for measure in said}
    for measure in said:
        axes: tuple[int, ...] = ()
        if measure.quantity == "width" and "length" in kinds and not deep:
            axes = (0,)
        elif measure.quantity in _EXTENTS:
            axes = (_EXTENTS[measure.quantity],)
        elif measure.quantity == "length":
            axes = (0,) if deep else (1,)
        elif measure.quantity in ("diameter", "side"):
            axes = plan
        elif (
            measure.quantity == "top"
            and mention.family == "table"
            or measure.quantity == "seat"
            and has_role(mention.category, "backless_seat")
        ):
            axes = (2,)
        if measure.quantity == "knee" and mention.family == "table" and known is not None and measure.low is not None:
            high = max(measure.low + TOP, sum(known.height) / 2)
            mention.size[2], mention.scale = round(min(high, known.reach[2][1]), 4), 1.0
        for axis in axes:
            mention.size[axis], mention.scale = _within(measure, known.ranges[axis] if known else None), 1.0
    if any(mention.size) and not mention.generic:
        mention.category = _fitting(mention)


def _within(measure: StatedMeasure, usual: tuple[float, float] | None) -> float:
    """The length [m] within what is asked that is nearest to the usual ones."""
    if measure.low is not None and measure.low == measure.high:
        return measure.low
    low = measure.low if measure.low is not None else 0.0
    high = measure.high if measure.high is not None else float("inf")
    middle = sum(usual) / 2 if usual is not None else measure.wanted
    return round(min(max(middle, low), high), 4)


def _fitting(mention: Mention) -> str:
    """The category of a thing, or another one that its name may mean and that can have the size, where it cannot.

    A "table" 1.1 m high is a bar table.
    """
    own, head = category_named(mention.category), singular(mention.noun).split()[-1]
    alike: list[str] = words("measures")["by_size"].get(head, [])
    described = {word for a in mention.attributes for word in a.words.split()}
    if mention.category not in alike or not set(mention.noun.split()[:-1]) <= described or _fits(own, mention.size):
        return mention.category
    rows = [category_named(name) for name in alike]
    usual = (row.name for row in rows if _fits(row, mention.size, beyond=False))
    return next(usual, min(rows, key=lambda row: _misfit(row, mention.size)).name)


def _misfit(row: Category, size: Sequence[float | None]) -> float:
    """By how much, as a share, a size is beyond what things of a category may have."""
    reach = row.size.reach if row.size is not None else ((1.0, 1.0),) * 3
    return sum(
        max(0.0, low / want - 1.0, want / high - 1.0)
        for want, (low, high) in zip(size, reach, strict=True)
        if want is not None
    )


def _fits(row: Category, size: Sequence[float | None], beyond: bool = True) -> bool:
    """Whether things of a category may have a size, or, where not ``beyond``, usually have."""
    if row.size is None:
        return False
    ranges = row.size.reach if beyond else row.size.ranges
    return all(
        want is None or low - 1e-6 <= want <= high + 1e-6 for want, (low, high) in zip(size, ranges, strict=True)
    )


__all__ = ["give_states", "measured", "named_by", "worktop_categories"]
