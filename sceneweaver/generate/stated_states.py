"""States and looks that a request tells of some things, or of parts of them: their bodies are drawn so."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.assets.states import State
from sceneweaver.language import Attribute, SceneGraph
from sceneweaver.language.told_states import (
    colors_as_told,
    detail_as_told,
    posture_as_told,
    pulled_as_told,
    state_as_told,
)
from sceneweaver.scene import CATALOGUE, Relation, Window

from .program import Wanted

NEARER, FARTHER = 0.06, 0.1
"""How much [m] nearer to its table, or farther from it, a chair may be that is pulled out so far."""

BEYOND = 0.04
"""How much higher [m] than its window a blind is that covers it."""


def with_stated_states(
    wanted: Sequence[Wanted], brief: SceneGraph, windows: Sequence[Window], library: Library
) -> None:
    """Gives things bodies in the states of which a request speaks; of so many of them where it tells how many.

    Args:
        wanted: the things; the bodies of those of which a state is told change.
        brief: the request.
        windows: those of the room.
        library: where bodies are from.
    """
    for asked in brief.entities:
        things = [one for one in wanted if one.asked == asked.id]
        done: set[str] = set()
        for told in asked.attributes:
            if told.kind != "state":
                continue
            free = [one for one in things if one.id not in done]
            for one in free[: told.count[1] if told.count else None]:
                state = state_as_told(one.category, told)
                if state is not None and _change(one, told, state, windows, library):
                    done.add(one.id)


def with_stated_looks(wanted: Sequence[Wanted], brief: SceneGraph, library: Library) -> None:
    """Gives things bodies in the colours and materials that are said of some of them, or of parts of them.

    Args:
        wanted: the things; the bodies of those of which this is said change.
        brief: the request.
        library: where bodies are from.
    """
    for asked in brief.entities:
        things = [one for one in wanted if one.asked == asked.id and one.wish is not None]
        parts = tuple(detail for told in asked.attributes if (detail := detail_as_told(told)) is not None)
        for one in things if parts else ():
            _drawn(one, library, details=parts)
        for told in asked.attributes:
            colors = colors_as_told(told)
            for k, one in enumerate(things if colors else ()):
                _drawn(one, library, color=colors[k % len(colors)])
        start = 0
        counted = [told for told in asked.attributes if told.count is not None and told.kind in ("color", "material")]
        for k, told in enumerate(counted):
            another = k > 0 and told.span == counted[k - 1].span and told.kind != counted[k - 1].kind
            start = start - (counted[k - 1].count or (0, 0))[1] if another else start
            for one in things[start : start + (told.count or (0, 0))[1]]:
                _drawn(one, library, **{told.kind: told.value})
            start += (told.count or (0, 0))[1]


def pulled_out(relations: Iterable[Relation], wanted: Sequence[Wanted], brief: SceneGraph) -> list[Relation]:
    """The relations, of which those of seats that are not pushed in keep them as far from their tables as is asked."""
    far: dict[str, float] = {}
    for asked in brief.entities:
        for told in asked.attributes:
            if (length := pulled_as_told(told)) is not None:
                things = [one.id for one in wanted if one.asked == asked.id]
                far |= dict.fromkeys(things[: told.count[1] if told.count else None], length)
    return [
        r.model_copy(
            update={
                "params": {**r.params, "gap": [round(max(0.1, far[r.subject] - NEARER), 3), far[r.subject] + FARTHER]}
            }
        )
        if r.subject in far and r.type in CATALOGUE.with_role("seat")
        else r
        for r in relations
    ]


def _drawn(one: Wanted, library: Library, **look: Any) -> None:
    """Another body of the same size with a look."""
    assert one.wish is not None
    depth, width, height = (round(side, 4) for side in one.asset.size)
    one.wish = replace(one.wish, size=(depth, width, height), beyond=True, **look)
    one.asset = library.choose(one.category, 1, one.wish)[0]


def _change(one: Wanted, told: Attribute, state: State, windows: Sequence[Window], library: Library) -> bool:
    if one.wish is None:
        return False
    depth, width, height = one.asset.size
    if state.measure == "drop" and windows:
        window = windows[one.number % len(windows)]
        height = (sum(state.range) / 2 if state.range[0] < 0.8 else 1.0) * window.height
        height += BEYOND if state.range[0] >= 0.8 else 0.0
    depth, width, height = (side * share for side, share in zip((depth, width, height), state.scale, strict=True))
    size = (round(depth, 4), round(width, 4), round(height, 4))
    wish = replace(one.wish, size=size, posture=posture_as_told(state, told), beyond=True)
    one.asset, one.wish = library.choose(one.category, 1, wish)[0], wish
    return True


__all__ = ["pulled_out", "with_stated_looks", "with_stated_states"]
