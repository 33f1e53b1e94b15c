"""What the tools give back: as data with a schema, and as text to read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel, Field

from .differences import SOFT, Difference, Moved
from .limits import MOST_LISTED

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
    """Scenes that are open, and scenes that can be."""

    open: list[OpenScene]
    files: list[str] = Field(description="Scene files below the server's folder")
    examples: list[str] = Field(description="Scenes that ship with sceneweaver; open takes their names")


class Closed(BaseModel):
    """A scene that is no longer open; its files stay."""

    scene: str
    versions: int


def faults(report: Mapping[str, Any], hard: bool, most: int) -> list[str]:
    """The violations of a report as sentences."""
    lines = [
        v["detail"] or f"{v['kind']}: {', '.join(v['objects'])}" for v in report["violations"] if v["hard"] is hard
    ]
    return [*lines[:most], *([f"and {len(lines) - most} more"] if len(lines) > most else [])]


def state_text(state: SceneState) -> str:
    """A scene after a call, in words."""
    lines = [f"{state.scene} version {state.version}: {state.change}; {'valid' if state.valid else 'NOT valid'}"]
    lines += [f"- wrong: {line}" for line in state.violations]
    lines += [f"- soft: {line}" for line in state.soft]
    lines += difference_lines(state.difference)
    lines += [f"- note: {line}" for line in state.notes]
    if isinstance(state, OpenedScene):
        lines += _opened_lines(state)
    if isinstance(state, DesignedScene):
        lines += [f"- asked for and not so: {line}" for line in state.unmet]
        lines += [f"- not done: {line}" for line in state.undone]
        lines += [f"- the agent ended: {state.finished}", f"- files in: {state.folder}"]
    return "\n".join(lines)


def _opened_lines(state: OpenedScene) -> list[str]:
    room = state.room
    corners = ", ".join(f"({x:g}, {y:g})" for x, y in room.outline)
    lines = [f"{room.type}, {room.height:g} m high, corners {corners}"]
    for what, walls in (("door", room.doors), ("window", room.windows)):
        lines += [f"- {what} {name} in wall:{wall}" for name, wall in walls.items()]
    for thing in state.objects:
        x, y, z = thing.position
        size = " x ".join(f"{v:.2f}" for v in thing.size)
        on = f" on {thing.on}" if thing.on else ""
        lines.append(
            f"- {thing.id}: {thing.category} at ({x:.2f}, {y:.2f}, {z:.2f}), {thing.yaw:.0f} deg, {size} m{on}"
        )
    hard = [line for line in state.relations if not line.startswith(SOFT)]
    lines += [f"- {line}" for line in hard]
    return lines + [f"- and {len(state.relations) - len(hard)} soft relations, which are in the data"]


def difference_lines(found: Difference) -> list[str]:
    """What changed, a line each."""
    lines = [f"- added: {name}" for name in found.added] + [f"- removed: {name}" for name in found.removed]
    far = [move for move in found.moved if move_words(move)]
    lines += [f"- moved: {move_words(move)}" for move in far[:MOST_LISTED]]
    if len(far) < len(found.moved):
        lines.append(f"- moved by less than 5 mm: {len(found.moved) - len(far)}")
    for each in found.resized:
        sizes = (" x ".join(f"{v:.2f}" for v in size) for size in (each.before, each.after))
        lines.append(f"- resized: {each.id} from {' to '.join(sizes)} m")
    lines += [f"- changed: {name}" for name in found.changed]
    lines += [f"- now related: {line}" for line in found.related]
    lines += [f"- no longer related: {line}" for line in found.unrelated]
    return lines + (["- the room changed"] if found.room else [])


def move_words(move: Moved) -> str:
    """How far something went, in words; empty for less than 5 mm and half a degree."""
    words = [f"{move.distance:.2f} m"] if move.distance >= 0.005 else []
    words += [f"{abs(move.rise):.2f} m {'up' if move.rise > 0 else 'down'}"] if abs(move.rise) >= 0.005 else []
    words += [f"turned {move.turn:+.0f} deg"] if abs(move.turn) >= 0.5 else []
    return f"{move.id} {', '.join(words)}" if words else ""
