"""What the tools for homes give back as data; its schema is theirs."""

from __future__ import annotations

from pydantic import BaseModel, Field


class HomeRoomFacts(BaseModel):
    """One room of a home."""

    id: str
    type: str
    storey: str
    area: float = Field(description="Clear floor [m2]")
    leads_to: list[str] = Field(description="Rooms behind its doors, passages and stairs")
    objects: int | None = Field(description="How much stands in it; null: it is not furnished")
    request: str | None = Field(description="What it was to hold, in words")


class HomeState(BaseModel):
    """A home after a call."""

    home: str = Field(description="Handle of the home, for the other tools for homes")
    version: int
    change: str = Field(description="What made this version")
    valid: bool = Field(description="Whether rules of plans, rooms, and ways between them are kept")
    violations: list[str] = Field(description="What is wrong, a sentence each")
    soft: list[str] = Field(description="Rules of plans that are not kept, and need not be")
    rooms: list[HomeRoomFacts]
    entrance: str | None = Field(description="Door that one comes in by")
    unreached: list[str] = Field(description="Rooms, and things as room/object, that a base of 0.25 m does not get to")
    notes: list[str] = []
    resource: str = Field(description="URI of the home")


class PlanOption(BaseModel):
    """One of several plans."""

    version: int = Field(description="Version of the home that is this plan")
    cost: float = Field(description="Of soft rules that are not kept; less is better")
    area: float = Field(description="Floor of all rooms [m2]")
    soft: list[str] = Field(description="Names of those rules")


class PlannedHome(HomeState):
    """A home without furniture, with other plans for the same as further versions."""

    options: list[PlanOption] = Field(description="All plans, best first")
    found: int = Field(description="How many valid plans were found")


class RoomOutcome(BaseModel):
    """What became of a room that was furnished."""

    room: str
    request: str = Field(description="What it was to hold")
    grade: float | None = Field(description="Of the critic, 0 to 10; null: it could not be furnished")
    unmet: list[str] = Field(description="What was asked for and is not so, and what such a room lacks")
    failed: str = Field(description="Why it could not be furnished; empty: it could")


class FurnishedHomeState(HomeState):
    """A home of which rooms were furnished."""

    furnished: list[RoomOutcome]


class DesignedHome(FurnishedHomeState):
    """A designed home, with how it came about."""

    folder: str = Field(description="Where its files are, below the server's folder")
    files: list[str] = Field(description="They, in the order in which to look at them")
    style: str
    unmet: list[str] = Field(description="What was asked for and is not so")
    undone: list[str] = Field(description="What there was no time for")
    log: list[str] = Field(description="What was done, in order")


class CheckedHome(BaseModel):
    """The judge on a home."""

    home: str
    version: int
    valid: bool
    violations: list[str]
    soft: list[str]
    plan_valid: bool | None = Field(description="Whether the plan keeps its rules; null: it was judged by none")
    rooms: dict[str, bool] = Field(description="Whether each furnished room is valid")
    entrance: str | None
    walkable_share: float = Field(description="Share of the floor that the base gets to from the entrance")
    reachable_share: float = Field(description="Share of what is used that it gets to")
    unreached_rooms: list[str]
    unreached_objects: list[str] = Field(description="As room/object")
    blocked_doors: list[str]
    by_stairs: list[str] = Field(description="Rooms that need a stair")
    resource: str


class HomePicture(BaseModel):
    """One picture; the picture itself is in the content of the answer."""

    view: str
    shows: str
    width: int
    height: int
    file: str | None = Field(default=None, description="Name below the server's folder")


class RenderedHome(BaseModel):
    """Pictures of a home."""

    home: str
    version: int
    pictures: list[HomePicture]


class ExportedHome(BaseModel):
    """Files of a home, below the server's folder."""

    home: str
    version: int
    folder: str
    files: dict[str, str]


class OpenHome(BaseModel):
    """A home that is open."""

    home: str
    name: str
    version: int
    versions: list[int] = Field(description="Those that are kept")
    rooms: int
    furnished: int
    valid: bool
