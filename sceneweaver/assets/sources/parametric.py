"""The library of our own: furniture drawn to order."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from urllib.parse import parse_qsl

from sceneweaver.scene import InputError

from ..asset import Asset
from ..category import categories
from ..materials import STYLES
from ..parametric import Request, make, makers
from .base import Card, Wish

PREFIX = "parametric:"


class ParametricSource:
    """Draws any category of the taxonomy for any seed; an id says all that is needed to draw it again."""

    name = "parametric"

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """``wish.count`` variants of the category in the wanted size and look, as far as its ranges allow."""
        if category not in makers():
            return
        for k in range(wish.count):
            asset = _draw(category, wish.seed + k, self._request(category, wish))
            yield Card(
                asset.id, category, asset.size, self.name, asset.origin.licence, asset.attributes, asset.description
            )

    def owns(self, asset_id: str) -> bool:
        """Ids look like ``parametric:desk?seed=3&color=white``."""
        return asset_id.startswith(PREFIX)

    def load(self, asset_id: str) -> Asset:
        """Draw the asset of an id again."""
        category, _, query = asset_id.removeprefix(PREFIX).partition("?")
        given = dict(parse_qsl(query, keep_blank_values=True))
        try:
            seed = int(given.pop("seed", "0"))
            size = _size(given.pop("size", ",,"))
            request = Request(size=size, **{k: given.pop(k) for k in ("color", "material", "style") if k in given})
        except (TypeError, ValueError) as error:
            raise InputError(f"asset: '{asset_id}' is no parametric id; write parametric:CATEGORY?seed=N") from error
        if given or seed < 0:
            raise InputError(f"asset: '{asset_id}' is no parametric id; write parametric:CATEGORY?seed=N")
        return _draw(category, seed, request)

    @staticmethod
    def _request(category: str, wish: Wish) -> Request:
        """The wish within what the category can be: sizes are brought into its ranges."""
        sizes = categories()[category].size
        assert sizes is not None
        size = tuple(
            None if want is None else min(max(want, low), high)
            for want, (low, high) in zip(wish.size, sizes.ranges, strict=True)
        )
        style = wish.style if wish.style in STYLES else None
        return Request(size, wish.color, wish.material, style)  # pyright: ignore[reportArgumentType]


@lru_cache(maxsize=1024)
def _draw(category: str, seed: int, request: Request) -> Asset:
    return make(category, seed, request)


def _size(text: str) -> tuple[float | None, float | None, float | None]:
    a, b, c = (float(v) if v else None for v in text.split(","))
    return a, b, c
