"""A source of assets that only the caller has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sceneweaver.assets import Asset
from sceneweaver.assets.sources import Card, ParametricSource
from sceneweaver.assets.sources.base import Wish


class Private:
    """The drawn assets under ids of their own, as a source that only the caller has."""

    name = "mine"

    def __init__(self) -> None:
        self.drawn = ParametricSource()

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        for card in self.drawn.find(category, wish):
            yield replace(card, id=f"mine:{card.id}", source=self.name)

    def load(self, asset_id: str) -> Asset:
        return replace(self.drawn.load(asset_id.removeprefix("mine:")), id=asset_id)

    def owns(self, asset_id: str) -> bool:
        return asset_id.startswith("mine:")
