"""What a source of assets can do: say what it has, and load it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Protocol

from sceneweaver.scene import InputError

from ..asset import Asset, Mount


@dataclass(frozen=True)
class Card:
    """An asset as a search sees it, without its arrays; ``size`` is (depth, width, height) [m]."""

    id: str
    category: str
    size: tuple[float, float, float]
    source: str
    licence: str
    attributes: dict[str, Any] = field(default_factory=dict)
    description: str = ""

    @property
    def text(self) -> str:
        """All words about it, for matching."""
        words = [self.category.replace("_", " "), self.description, *map(str, self.attributes.values())]
        return " ".join(word for word in words if word).lower()


class Source(Protocol):
    """A library of assets.

    ``find`` yields what it has of a category (fast, no meshes); ``load`` brings one of them by id. A source that
    makes things to order draws them for the wish that it is given.
    """

    name: str

    def find(self, category: str, wish: Wish) -> Iterator[Card]:
        """Cards of a category; for sources that make things, ``wish.count`` of them in the wanted size and look."""
        ...

    def load(self, asset_id: str) -> Asset:
        """The asset of an id; InputError when there is none."""
        ...

    def owns(self, asset_id: str) -> bool:
        """Whether an id is one of this source."""
        ...


@dataclass(frozen=True)
class Wish:
    """What is looked for; None and empty leave it open.

    ``size`` is the wanted (depth, width, height) [m], which goes ``beyond`` what is usual where words ask for it;
    ``words`` are style words, any colour or material among them;
    ``shape`` is a name of ``looks.yaml``, ``parts`` are counted ones (("drawers", 3), ...), ``mount`` is what holds a
    thing that no category fits; ``palette`` is the code of the room's palette, for sources that make things to order;
    ``posture`` is how it is there, for sources that make things to order: a name of `postures` or of the drawing;
    ``details`` are looks of its parts, (("top", "black marble"), ...);
    ``licences`` are the only ones allowed, None allows all. What is chosen for one ``suite`` (any number) matches.

    Raises:
        InputError: for a size that is no length above 0.
    """

    size: tuple[float | None, float | None, float | None] = (None, None, None)
    color: str | None = None
    material: str | None = None
    style: str | None = None
    shape: str | None = None
    parts: tuple[tuple[str, int], ...] = ()
    mount: Mount | None = None
    words: str = ""
    seed: int = 0
    count: int = 8
    licences: frozenset[str] | None = None
    beyond: bool = False
    palette: str | None = None
    suite: int | None = None
    posture: str | None = None
    details: tuple[tuple[str, str], ...] = ()

    def __post_init__(self) -> None:
        for name, want in zip(("depth", "width", "height"), self.size, strict=True):
            if want is not None and not (math.isfinite(want) and want > 0):
                raise InputError(f"size: a {name} of {want} m is none; give a length above 0, or None")
