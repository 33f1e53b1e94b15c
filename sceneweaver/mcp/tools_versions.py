"""Tools that go back and forth between the versions of a scene, and compare them."""

from __future__ import annotations

from typing import Annotated

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult
from pydantic import Field

from .answers import Diff, SceneState
from .differences import difference
from .inputs import SceneId, VersionNumber
from .service import Service, answer, uri_of
from .words import difference_lines, state_text


class VersionTools:
    """Undo, redo, diff."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def undo(self, scene: SceneId, context: Context) -> Annotated[CallToolResult, SceneState]:
        """Go back to the version before the last change. redo takes that back until something else is changed."""
        return await self._step(scene, context, -1, "undone")

    async def redo(self, scene: SceneId, context: Context) -> Annotated[CallToolResult, SceneState]:
        """Go forward again to what was undone."""
        return await self._step(scene, context, 1, "done again")

    async def diff(
        self,
        scene: SceneId,
        before: Annotated[VersionNumber | None, Field(description="null: the one before the current one")] = None,
        after: Annotated[VersionNumber | None, Field(description="null: the current one")] = None,
    ) -> Annotated[CallToolResult, Diff]:
        """Say what differs between two versions: what was added, removed, moved and by how much, and relations."""
        handle = self.service.handles.get(scene)
        new = handle.get(after)
        old = handle.get(before) if before is not None else handle.before(new)
        differs = difference(old.content, new.content)
        found = Diff(scene=handle.id, before=old.number, after=new.number, difference=differs)
        lines = difference_lines(found.difference) or ["- nothing differs"]
        return answer(found, "\n".join([f"{handle.id}: from version {old.number} to {new.number}", *lines]))

    async def _step(self, scene: str, context: Context, by: int, change: str) -> CallToolResult:
        handle = self.service.handles.get(scene)
        async with handle.changing:
            before = handle.current
            version = handle.step(by)
            change = f"{change}: {before.change if by < 0 else version.change}"
            state = SceneState(**self.service.state(handle, version, before.content, change, []))
            await context.notify_resource_updated(uri_of(handle))
        return answer(state, state_text(state))
