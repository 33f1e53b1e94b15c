"""How a thing stands to another that it belongs to, as rooms have it: a stool before a wheel, a pump beside a chair.

Rooms say it of the pairs that they have. Asked for by name in any room, such a pair stands the same way.
"""

from __future__ import annotations

from collections import Counter
from functools import cache

from sceneweaver.scene import CATALOGUE

from .kin import kin
from .load import room_types
from .model import Place

PLACED = CATALOGUE.with_role("placing", "turning") | {"near", "beside", "distance"}
"""Types of relations that say where one thing of a pair is to the other."""


def place_with(category: str, of: str) -> tuple[Place, ...]:
    """The relations of a thing to another that it belongs to; empty where no room has such a pair.

    Args:
        category: what belongs to the other.
        of: the category of that one.

    Examples:
        >>> from sceneweaver.knowledge.belongings import place_with
        >>> [place.type for place in place_with("stool", "pottery_wheel")]
        ['front_to_front']
        >>> place_with("stool", "wardrobe")
        ()
    """
    known = _pairs()
    alike = [(category, of), *((a, b) for a in sorted(kin(category)) for b in sorted(kin(of)))]
    return next((known[pair] for pair in alike if pair in known), ())


@cache
def _pairs() -> dict[tuple[str, str], tuple[Place, ...]]:
    """What most rooms with a pair say of it; of several the first."""
    said: dict[tuple[str, str], Counter[str]] = {}
    places: dict[str, tuple[Place, ...]] = {}
    for room in room_types().values():
        for item in room.items:
            if item.with_ is None or item.mount not in (None, "floor"):
                continue
            own = tuple(p for p in item.place if p.to == item.with_ and p.type in PLACED)
            if not any(not p.soft for p in own):
                continue
            key = repr([(p.type, p.soft, sorted(p.params.items())) for p in own])
            places[key] = own
            for name in item.what:
                for host in room.item(item.with_).what:
                    said.setdefault((name, host), Counter())[key] += 1
    return {pair: places[counts.most_common(1)[0][0]] for pair, counts in said.items()}


__all__ = ["place_with"]
