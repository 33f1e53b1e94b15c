"""Imported assets: what a store holds."""

from __future__ import annotations

from collections.abc import Iterator

from ..asset import Asset
from ..store import Store
from ..taxonomy import members
from .base import Card, Wish

OF_SCENES = "imported"
"""Source of assets that came with a scene of another system: they stand in that scene, and are offered to no other."""


class StoreSource:
    """The assets of a store; its rows are read once."""

    name = "store"

    def __init__(self, store: Store | None = None):
        self.store = store or Store()
        self._cards: list[Card] | None = None

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """Assets of the category, or of its members when it is a group."""
        names = {category, *members(category)}
        yield from (card for card in self.cards() if card.category in names and card.source != OF_SCENES)

    def cards(self) -> list[Card]:
        """All assets of the store."""
        if self._cards is None:
            self._cards = [
                Card(
                    row["id"],
                    row["category"],
                    tuple(row["size"]),
                    row["source"],
                    row["licence"],
                    row["attributes"],
                    row["description"],
                )
                for row in self.store.rows()
            ]
        return self._cards

    def owns(self, asset_id: str) -> bool:
        """Whether the store has an asset of that id."""
        return any(card.id == asset_id for card in self.cards())

    def load(self, asset_id: str) -> Asset:
        """Read the asset."""
        return self.store.load(asset_id)
