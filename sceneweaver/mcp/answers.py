"""What the tools give back as data; its schema is theirs."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, Field

from .answers_homes import OpenHome
from .differences import Difference

Size = tuple[float, float, float]


class Thing(BaseModel):
    """One object of a scene."""

    id: str
    category: str
    position: Size = Field(description="Bottom centre: x, y, z [m]")
    yaw: float = Field(description="Counter-clockwise, the front is +x at 0 [degrees]")
    size: Size = Field(description="Depth along the front, width, height [m]")
    on: str | None = Field(default=None, description="Id of what carries it")


class RoomFacts(BaseModel):
    """The room of a scene."""

    type: str
    outline: list[tuple[float, float]] = Field(description="Corners, counter-clockwise [m]; wall k begins at corner k")
    height: float
    doors: dict[str, int] = Field(description="The wall of each door")
    windows: dict[str, int] = Field(description="The wall of each window")


class SceneState(BaseModel):
    """A scene after a call."""

    scene: str = Field(description="Handle of the scene, for the other tools")
    version: int
    change: str = Field(description="What made this version")
    valid: bool = Field(description="Whether the judge finds nothing wrong")
    violations: list[str] = Field(description="What is wrong, a sentence each")
    soft: list[str] = Field(description="What is not as it should be, but allowed")
    difference: Difference = Field(description="What changed since the version before")
    notes: list[str] = []
    resource: str = Field(description="URI of the scene")


class OpenedScene(SceneState):
    """A scene that is new on the server, with all that stands in it."""

    name: str
    room: RoomFacts
    objects: list[Thing]
    relations: list[str]


class DesignedScene(OpenedScene):
    """A designed scene, with how it came about."""

    folder: str = Field(description="Where its files are, below the server's folder")
    grades: dict[str, float] = Field(description="Grades of the critic, 0 to 10")
    unmet: list[str] = Field(description="What was asked for and is not so")
    steps: list[str]
    finished: str = Field(description="Why the agent ended")
    undone: list[str] = Field(description="What there was no time for")
    model: dict[str, Any] | None = Field(description="What a language model did and took; null: none was asked")


class Checked(BaseModel):
    """The judge on a scene."""

    scene: str
    version: int
    valid: bool
    violations: list[str]
    soft: list[str]
    counts: dict[str, int]
    walkable_share: float | None = Field(description="Share of the floor that one can walk on")
    reachable_share: float | None = Field(description="Share of the objects that one can walk up to")
    warnings: list[str]
    resource: str


class Explained(BaseModel):
    """Why a scene is not valid, or cannot be."""

    scene: str
    version: int
    valid: bool = Field(description="Whether the scene is valid as it is")
    possible: bool | None = Field(description="Whether a valid layout was found; null where none was looked for")
    lines: list[str]


class Diff(BaseModel):
    """What differs between two versions of a scene."""

    scene: str
    before: int
    after: int
    difference: Difference


class Picture(BaseModel):
    """One picture; the picture itself is in the content of the answer."""

    view: str
    width: int
    height: int
    file: str | None = Field(default=None, description="Name below the server's folder")


class Rendered(BaseModel):
    """Pictures of a scene."""

    scene: str
    version: int
    pictures: list[Picture]


class Exported(BaseModel):
    """Files of a scene, below the server's folder."""

    scene: str
    version: int
    folder: str
    files: dict[str, str]


class Furniture(BaseModel):
    """One kind of furniture."""

    category: str
    words: str
    synonyms: list[str]
    mount: list[str] = Field(description="What may hold it, the usual one first")
    stands_on: list[str]
    size: list[tuple[float, float]] = Field(description="Usual depth, width and height, from and to [m]")


class FurnitureList(BaseModel):
    """Furniture that can be added by words, and rooms that can be designed."""

    furniture: list[Furniture]
    rooms: list[str]
    notes: list[str]


class OpenScene(BaseModel):
    """A scene that is open."""

    scene: str
    name: str
    version: int
    versions: list[int] = Field(description="Those that are kept")
    objects: int
    valid: bool


class SceneList(BaseModel):
    """Scenes and homes that are open, and those that can be."""

    open: list[OpenScene]
    files: list[str] = Field(description="Scene files below the server's folder")
    examples: list[str] = Field(description="Scenes that ship with sceneweaver; open takes their names")
    homes: list[OpenHome] = Field(description="Homes that are open")
    home_files: list[str] = Field(description="Files of homes below the server's folder")
    home_examples: list[str] = Field(description="Homes that ship with sceneweaver; open_home takes their names")
    programmes: list[str] = Field(description="Programmes that ship with sceneweaver; plan_home takes their names")


class Closed(BaseModel):
    """A scene or home that is no longer open; its files stay."""

    scene: str
    versions: int
