"""The library of our own: furniture drawn to order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from urllib.parse import parse_qsl

from sceneweaver.scene import InputError

from ..asset import Asset
from ..category import categories
from ..journal import Journal
from ..looks import Words, shows
from ..materials import STYLES
from ..parametric import Request
from ..parametric.drawings import Drawings
from ..taxonomy import Match, resolve
from .base import Card, Wish

WORDS = ("color", "material", "style", "shape", "label", "palette", "posture")
"""What an id says in words."""

PREFIX, MIRRORED = "parametric:", "&mirrored=1"


class ParametricSource:
    """Draws any category of the taxonomy for any seed; an id says all that is needed to draw it again."""

    name = "parametric"

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """``wish.count`` variants of the category in the wanted size and look, as far as its ranges allow."""
        match = resolve(category, wish.mount)
        from shapely import GEOSException

        request = self._request(match, wish)
        for k in range(wish.count):
            try:
                made = _shown(match.body, wish.seed + k, request)
            except (ValueError, GEOSException):
                if not wish.beyond:
                    raise
                # A drawing with a part that cannot be so low or small is made as far as is usual.
                made = _shown(match.body, wish.seed + k, self._request(match, replace(wish, beyond=False)))
            licence = made.origin.licence
            yield Card(made.id, made.category, made.size, self.name, licence, made.attributes, made.description)

    def owns(self, asset_id: str) -> bool:
        """Ids look like ``parametric:desk?seed=3&color=white``."""
        return asset_id.startswith(PREFIX)

    def load(self, asset_id: str) -> Asset:
        """Draw the asset of an id again."""
        return _draw(*_read(asset_id))

    @staticmethod
    def _request(match: Match, wish: Wish) -> Request:
        """The wish within what the category can be: sizes are brought into its ranges."""
        sizes = categories()[match.body].size
        assert sizes is not None
        depth, width, height = (
            None if want is None else min(max(want, low), high)
            for want, (low, high) in zip(wish.size, sizes.built if wish.beyond else sizes.ranges, strict=True)
        )
        size = (depth, width, height)
        style = wish.style if wish.style in STYLES else None
        label = match.category if match.body != match.category else None
        look = wish.color, wish.material, style, wish.shape, wish.parts
        return Request(size, *look, label, wish.palette, wish.suite, posture=wish.posture, details=wish.details)


TRIES, TRIES_FOR_COUNTS = 8, 24
"""Seeds that are drawn to find one that shows all that was asked: not every variant has every part."""


VARIED = ("material", "shape")
"""What variants of a category differ in, besides counts of parts that it has."""


def _shown(category: str, seed: int, request: Request) -> Asset:
    """A body that shows the asked look, of another seed where this one's cannot; the first when none can."""
    words = Words(color=request.color, material=request.material, shape=request.shape, parts=request.parts)
    first = _draw(category, seed, request)
    missing = {kind for kind, shown in shows(first.attributes, words).items() if not shown}
    bare = _without_details(first, request)
    if any(kind not in (*VARIED, *first.attributes) for kind in missing) or not (missing or bare):
        return first
    if not _can_show(category, replace(request, size=(None, None, None), style=None), words):
        return first
    tries = TRIES if missing & set(VARIED) or bare else TRIES_FOR_COUNTS
    return next(_that_show(category, seed, request, words, range(1, tries)), first)


@lru_cache(maxsize=1024)
def _can_show(category: str, request: Request, words: Words) -> bool:
    """Whether any variant of a category shows a look: so as not to try in vain for each seed and size."""
    return next(_that_show(category, 0, request, words, range(TRIES_FOR_COUNTS)), None) is not None


def _that_show(category: str, seed: int, request: Request, words: Words, tries: range) -> Iterator[Asset]:
    drawn = (_draw(category, seed + 7919 * k, request) for k in tries)
    shown = (made for made in drawn if all(shows(made.attributes, words).values()))
    return (made for made in shown if not _without_details(made, request))


def _without_details(made: Asset, request: Request) -> list[str]:
    """The parts of a body that were to have a look and have none."""
    return [part for part, _ in request.details if f"{part} finish" not in made.attributes]


_DRAWN = Drawings(64 * 2**20)


def keep_drawings(nbytes: int) -> None:
    """Keep at least so many bytes of the drawings that were used last."""
    _DRAWN.keep(max(_DRAWN.most, nbytes))


def share_drawings(journal: Journal | None) -> None:
    """Tell other processes what is drawn, and ask them, from now on; None: no longer."""
    _DRAWN.share(journal)


def _draw(category: str, seed: int, request: Request) -> Asset:
    return _DRAWN.get(category, seed, request)


@lru_cache(maxsize=1024)
def _read(asset_id: str) -> tuple[str, int, Request]:
    """What an id says: category, seed and request; the things of a scene are loaded many times."""
    category, _, query = asset_id.removeprefix(PREFIX).partition("?")
    given = dict(parse_qsl(query, keep_blank_values=True))
    words = {k: given.pop(k) for k in WORDS if k in given}
    try:
        seed = int(given.pop("seed", "0"))
        size, parts = _size(given.pop("size", ",,")), _parts(given.pop("parts", ""))
        suite = int(given.pop("suite")) if "suite" in given else None
        flipped = int(given.pop("mirrored", "0"))
        details = _details(given.pop("details", ""))
    except ValueError as error:
        raise InputError(f"asset: '{asset_id}' is no parametric id; write parametric:CATEGORY?seed=N") from error
    if given or seed < 0 or (suite or 0) < 0 or flipped not in (0, 1):
        raise InputError(f"asset: '{asset_id}' is no parametric id; write parametric:CATEGORY?seed=N")
    return (
        category,
        seed,
        Request(size=size, parts=parts, suite=suite, mirrored=bool(flipped), details=details, **words),
    )


def _size(text: str) -> tuple[float | None, float | None, float | None]:
    a, b, c = (float(v) if v else None for v in text.split(","))
    return a, b, c


def _parts(text: str) -> tuple[tuple[str, int], ...]:
    rows = [row.partition(":") for row in text.split(",") if row]
    return tuple((name, int(count)) for name, _, count in rows)


def _details(text: str) -> tuple[tuple[str, str], ...]:
    rows = [row.partition(":") for row in text.split(",") if row]
    return tuple((name, look) for name, _, look in rows)


def other_hand(asset_id: str) -> str | None:
    """The id of a drawn asset in a mirror; None for assets from elsewhere."""
    if not asset_id.startswith(PREFIX):
        return None
    return asset_id.removesuffix(MIRRORED) if asset_id.endswith(MIRRORED) else asset_id + MIRRORED
