"""What a request says, in terms that tools act on."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

Shape = Literal["rectangle", "L", "T", "U", "round"]


class Asked(FrozenModel):
    """Objects of one kind that a request names."""

    id: str = Field(description="Name in this brief; relations use it. The category, with a number when it recurs")
    noun: str = Field(description="As it was written")
    category: str = Field(description="Category of the taxonomy")
    count: tuple[int, int] | None = Field(default=None, description="Least and most; None when nothing was said")
    color: str | None = None
    material: str | None = None
    style: str | None = None
    size: tuple[float | None, float | None, float | None] = Field(
        default=(None, None, None), description="Depth, width, height [m] where given"
    )
    scale: float = Field(default=1.0, description="1.2 for large, 0.8 for small, relative to the usual size")
    words: tuple[str, ...] = Field(default=(), description="Other words about it, for choosing an asset")


class AskedRelation(FrozenModel):
    """A relation that a request names.

    ``target`` is the id of something asked for, ``wall``, ``wall:left`` (right, far, near, north ... as seen from the
    door, or by compass with y north), ``window``, ``door``, ``corner``, ``middle`` (of the room), or None. ``surface``
    targets stand for on_top and inside.
    """

    type: str = Field(description="Type of the relation catalogue")
    subject: str
    target: str | tuple[str, str] | None = None
    params: dict[str, Any] = {}
    words: str = Field(default="", description="As it was written")


class Brief(FrozenModel):
    """A request, read. Nothing of it is lost: what was not understood stands under ``unread``."""

    text: str
    room_type: str | None = Field(default=None, description="Kind of room, a name of the knowledge base")
    room_words: str = Field(default="", description="The words that named it")
    shape: Shape | None = None
    size: tuple[float, float] | None = Field(default=None, description="Floor [m], longer side first")
    area: float | None = Field(default=None, description="Floor [m2]")
    height: float | None = Field(default=None, description="Of the ceiling [m]")
    scale: float = Field(default=1.0, description="1.3 for a large room, 0.75 for a small one")
    people: int | None = None
    for_whom: tuple[str, ...] = Field(default=(), description="child, teenager, couple, guest ... as it was written")
    style: str | None = None
    colors: tuple[str, ...] = ()
    windows: int | None = None
    doors: int | None = None
    density: Literal["sparse", "normal", "full"] = "normal"
    objects: tuple[Asked, ...] = ()
    relations: tuple[AskedRelation, ...] = ()
    without: tuple[str, ...] = Field(default=(), description="Categories or groups that must not be there")
    only: bool = Field(default=False, description="Nothing but what is named: 'only', 'just', 'nothing else'")
    unread: tuple[str, ...] = Field(default=(), description="Words that were not understood")
    notes: tuple[str, ...] = Field(default=(), description="What was assumed, corrected or contradicts itself")
