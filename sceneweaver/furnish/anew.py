"""Rooms of a home that is there already, planned or designed, furnished as its request says and in its look."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.home import Home
from sceneweaver.language.homes import is_home

from .asked import Asked
from .home import FurnishedHome, furnish_home, room_seed


def refurnish(
    home: Home, requests: Mapping[str, str] | None = None, *, seed: int | None = None, **options: Any
) -> FurnishedHome:
    """Furnish rooms of a home that was planned or designed from words; the other rooms stay as they are.

    The look is that of the home, which follows from its ``prompt`` and the seed of its plan.

    Args:
        home: with the request that it answers as its ``prompt``.
        requests: by id of a room, what it is to hold, in words; empty words: what it was to hold before, or what the
            request for the home says of it. None: all rooms, so.
        seed: another one draws these rooms anew; None: that of the home, which draws what it drew.
        options: of `furnish_home`: workers, device, draws, time_limit, steps, candidates, clutter ...

    Raises:
        InputError: as `furnish_home`.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.furnish import refurnish
        >>> flat = sw.Home.example("flat")
        >>> options = {"workers": 1, "steps": 1, "candidates": 8}
        >>> done = refurnish(flat, {"hall": "a hallway with a coat rack"}, seed=1, **options)
        >>> [room.id for room in done.home.rooms if room.scene is not None]
        ['hall']
    """
    told = home.prompt.strip() != "" and (home.provenance.get("tool") == "solve_plans" or is_home(home.prompt))
    asked = Asked.of(home.prompt, None, None, None) if told else None
    had = {room.id: room.scene.prompt for room in home.rooms if room.scene is not None and room.scene.prompt}
    texts = {**(asked.told(home) if asked is not None else {}), **had}
    texts |= {name: words for name, words in (requests or {}).items() if words.strip()}
    own = seed_of(home)
    anew = None if seed is None else {room.id: room_seed(room.id, seed) for room in home.rooms}
    return furnish_home(
        home,
        texts,
        only=None if requests is None else tuple(requests),
        seed=own,
        seeds=anew,
        prompt=asked.style if asked is not None else "",
        **options,
    )


def seed_of(home: Home) -> int:
    """The seed of the plan of a home, from which its look follows; 0 for a home that no seed has made."""
    seed = home.provenance.get("seed", 0)
    return seed if isinstance(seed, int) and not isinstance(seed, bool) and 0 <= seed < 2**32 else 0
