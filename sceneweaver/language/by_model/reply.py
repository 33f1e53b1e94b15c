"""What a model answers when it reads a request: the scene graph as it can be said in any language.

Words are quoted from the request as they stand there, so that code can find them; what they mean is said in English.
"""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import BeforeValidator, Field, model_validator

from sceneweaver.llm import Reply

from ..model import AttributeKind, RelationType, Shape
from .leniency import Count, Flag, Listed, Metres, Number, Text, Whole, absent, term

Style = Literal["modern", "scandinavian", "industrial", "classic", "rustic"]
Density = Literal["sparse", "normal", "full"]
Side = Literal["long", "short", "left", "right"]


SAME = {
    "beside": "next_to",
    "adjacent": "next_to",
    "adjacent_to": "next_to",
    "under": "below",
    "underneath": "below",
    "beneath": "below",
    "in": "inside",
    "within": "inside",
    "left": "left_of",
    "right": "right_of",
    "front_of": "in_front_of",
    "across_from": "opposite",
    "surrounding": "around",
}
"""Other words for types of relations."""


def _words(of: object) -> BeforeValidator:
    return BeforeValidator(term(get_args(of)))


Quote = Annotated[Text, Field(description="Words copied from the request, in its own language")]
English = Annotated[Text, Field(description="In English")]
Length = Annotated[Metres | None, BeforeValidator(absent)]
Many = Annotated[Whole | None, BeforeValidator(absent)]
Factor = Annotated[Number | None, BeforeValidator(absent)]


class WordReply(Reply):
    """One word about a thing."""

    kind: Annotated[AttributeKind, _words(AttributeKind)]
    value: English
    quote: Quote = ""
    count: Count = Field(default=None, description="Of how many of the things; null: of all")


class ThingReply(Reply):
    """Things of one kind."""

    id: Text = Field(description="Your short name for it; relations use it")
    name: English
    quote: Quote
    count: Count = Field(default=None, description="[least, most]; null when nothing says how many")
    depth: Length = Field(default=None, description="m")
    width: Length = Field(default=None, description="m")
    height: Length = Field(default=None, description="m")
    scale: Factor = Field(default=None, description="1 is usual, 1.2 large, 0.8 small")
    words: Annotated[tuple[WordReply, ...], Listed] = ()
    implied: Flag = Field(default=False, description="Whether only a part of a room calls for it")


class RelationReply(Reply):
    """Where something is."""

    type: Annotated[RelationType, BeforeValidator(term(get_args(RelationType), SAME))]
    subject: Text = Field(description="Id of a thing")
    targets: Annotated[tuple[Text, ...], Listed] = Field(default=(), description="Ids of things, or one place")
    count: Count = Field(default=None, description="Of how many of the subjects; null: of all")
    each: Flag = Field(default=False, description="So many at every single one of the targets or sides")
    side: Annotated[Side | None, _words(Side)] = Field(default=None, description="Sides of the target")
    min: Length = Field(default=None, description="Least distance, m")
    max: Length = Field(default=None, description="Most distance, m")
    quote: Quote = ""
    implied: Flag = False


class ExclusionReply(Reply):
    """What must not be there."""

    quote: Quote
    names: Annotated[tuple[English, ...], Listed] = Field(description="English nouns")

    @model_validator(mode="before")
    @classmethod
    def _bare(cls, data: object) -> object:
        return {"quote": data, "names": [data]} if isinstance(data, str) else data


class RoomReply(Reply):
    """What is said of the room."""

    @model_validator(mode="before")
    @classmethod
    def _bare(cls, data: object) -> object:
        return {} if data is None else {"kind": data} if isinstance(data, str) else data

    kind: English = ""
    quote: Quote = Field(default="", description="The words that name the kind")
    others: Annotated[tuple[English, ...], Listed] = Field(default=(), description="Kinds of further rooms")
    shape: Annotated[Shape | None, _words(Shape)] = None
    sides: Annotated[tuple[Metres, ...], Listed] = Field(default=(), description="Two sides, m")
    area: Length = Field(default=None, description="m2")
    height: Length = Field(default=None, description="Of the ceiling, m")
    scale: Factor = Field(default=None, description="1 is usual, 1.3 large, 0.75 small")
    people: Many = None
    for_whom: Annotated[tuple[Quote, ...], Listed] = ()
    style: Annotated[Style | None, _words(Style)] = None
    colors: Annotated[tuple[English, ...], Listed] = ()
    windows: Many = None
    doors: Many = None
    density: Annotated[Density | None, _words(Density)] = None


class RequestReply(Reply):
    """A request, read."""

    language: English = ""
    room: RoomReply = RoomReply()
    things: Annotated[tuple[ThingReply, ...], Listed] = ()
    relations: Annotated[tuple[RelationReply, ...], Listed] = ()
    exclusions: Annotated[tuple[ExclusionReply, ...], Listed] = ()
    only: Annotated[bool | None, BeforeValidator(absent)] = Field(
        default=None, description="Whether nothing but what is named may be there"
    )
    unread: Annotated[tuple[Quote, ...], Listed] = Field(default=(), description="What you do not understand")
