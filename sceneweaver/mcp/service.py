"""What all tools share: the folder, the open scenes, the processes, and how a change becomes a version."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult, ContentBlock, TextContent
from pydantic import BaseModel

from sceneweaver.home import Home
from sceneweaver.scene import InputError, Scene

from .answers import RoomFacts, SceneState, Thing
from .differences import difference, relation_words
from .files import Files
from .handles import Handle, Handles, Version
from .limits import MOST_LISTED, MOST_OBJECTS, Limits
from .paths import Folder
from .words import faults, state_text
from .workers import Workers


@dataclass
class Service:
    """The state of a server.

    Attributes:
        folder: where everything is read and written.
        limits: how much is kept.
        device: where to compute.
        llm: arguments of a design with a language model, where one was set up; None: there is none.
    """

    folder: Folder
    limits: Limits
    device: str
    llm: Mapping[str, Any] | None = None
    files: Files = field(init=False)
    handles: Handles[Scene] = field(init=False)
    homes: Handles[Home] = field(init=False)
    workers: Workers = field(init=False)

    def __post_init__(self) -> None:
        self.files = Files(self.folder)
        self.handles = Handles(self.limits, "scene", "; it is a home: take the tools for homes, or open_room first")
        self.homes = Handles(self.limits, "home", "; it is a scene: take the tools for scenes")
        self.workers = Workers(self.device, self.limits)

    def seconds(self, wanted: float | None, usual: float) -> float:
        """The time limit of a call; InputError for more than the server gives."""
        most = self.limits.seconds
        if wanted is not None and wanted > most:
            raise InputError(f"time_limit: {wanted:g} s is more than this server gives; at most {most:g}")
        return min(usual, most) if wanted is None else wanted

    async def quick(self, context: Context, job: str, **arguments: Any) -> Any:
        """Do a job that takes seconds."""
        return await self.workers.quick.run(job, arguments, Progress(context), seconds=self.seconds(None, math.inf))

    async def long(
        self, context: Context, job: str, seconds: float, folder: Path | None = None, /, **arguments: Any
    ) -> Any:
        """Do a job that may take minutes; ``folder`` is where it leaves temporary files when it is ended."""
        return await self.workers.long.run(job, arguments, Progress(context), seconds=seconds, folder=folder)

    async def changed(
        self, context: Context, handle: Handle[Scene], before: Version[Scene], result: Mapping[str, Any], change: str
    ) -> CallToolResult:
        """The answer to a change, which becomes a version unless it left the scene as it was."""
        version = before
        if result["scene"] != before.content:
            version = handle.add(result["scene"], result["report"], change)
            await context.notify_resource_updated(uri_of(handle))
        else:
            change = f"{change}: nothing changed"
        state = SceneState(**self.state(handle, version, before.content, change, result["notes"]))
        return answer(state, state_text(state))

    def state(
        self, handle: Handle[Scene], version: Version[Scene], before: Scene | None, change: str, notes: list[str]
    ) -> dict[str, Any]:
        """The fields of a `SceneState`."""
        return {
            "scene": handle.id,
            "version": version.number,
            "change": change,
            "valid": version.report["valid"],
            "violations": faults(version.report, True, MOST_LISTED),
            "soft": faults(version.report, False, MOST_LISTED),
            "difference": difference(before or version.content, version.content),
            "notes": [self.folder.without_paths(note) for note in notes],
            "resource": uri_of(handle),
        }

    def opened(self, handle: Handle[Scene], notes: list[str]) -> dict[str, Any]:
        """The fields of an `OpenedScene`."""
        version = handle.current
        return self.state(handle, version, None, version.change, notes) | facts_of(version.content)


class Progress:
    """Reports progress to the client that asked for it; what is done never becomes less."""

    def __init__(self, context: Context) -> None:
        self._context, self._last = context, -1.0

    async def __call__(self, done: float, total: float | None, message: str) -> None:
        """So much is done, of so much in all."""
        self._last = done if done > self._last else self._last + 1e-3
        await self._context.report_progress(self._last, total, message)


def answer(data: BaseModel, text: str, *more: ContentBlock) -> CallToolResult:
    """An answer as text and as data."""
    content = [TextContent(text=text), *more]
    return CallToolResult(content=content, structured_content=data.model_dump(mode="json"))


def uri_of(handle: Handle[Any]) -> str:
    """The resource of an open scene or home."""
    return f"{'home' if handle.id.startswith('h') else 'scene'}://{handle.id}"


def facts_of(scene: Scene) -> dict[str, Any]:
    """What an `OpenedScene` says of a scene."""
    room = scene.room
    return {
        "name": scene.id,
        "room": RoomFacts(
            type=room.type,
            outline=[(float(x), float(y)) for x, y in room.outline],
            height=room.height,
            doors={door.id: door.wall for door in room.doors},
            windows={window.id: window.wall for window in room.windows},
        ),
        "objects": [_thing(obj) for obj in scene.objects[:MOST_OBJECTS]],
        "relations": [relation_words(r) for r in scene.relations[:MOST_OBJECTS]],
    }


def _thing(obj: Any) -> Thing:
    x, y, z = (round(v, 3) for v in obj.pose.position)
    return Thing(
        id=obj.id,
        category=obj.category,
        position=(x, y, z),
        yaw=round(math.degrees(obj.pose.yaw), 1),
        size=obj.size,
        on=obj.support.object if obj.support else None,
    )
