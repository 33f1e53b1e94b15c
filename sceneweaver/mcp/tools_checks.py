"""Tools that lay a scene out anew, mend it, judge it, and say why it cannot be valid."""

from __future__ import annotations

from typing import Annotated, Literal

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult
from pydantic import Field

from .answers import Checked, Explained, SceneState
from .inputs import SceneId, Seconds, Seed, VersionNumber
from .limits import MOST_LISTED
from .service import Service, answer
from .words import faults

USUAL = 60.0
"""Seconds that laying out, mending and explaining may take unless the call says otherwise."""

COUNTS = ("requested", "placed", "dropped", "collisions", "out_of_bounds", "unsupported")


class CheckTools:
    """Refine, repair, check, explain."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def refine(
        self,
        scene: SceneId,
        context: Context,
        init: Annotated[
            Literal["current", "sample", "random"],
            Field(description="Begin where things are, where their relations put them, or anywhere"),
        ] = "current",
        candidates: Annotated[int, Field(ge=1, le=65536, description="Layouts to choose from")] = 64,
        seed: Seed = 0,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, SceneState]:
        """Look for a better layout of the whole scene: nothing collides, all relations hold."""
        handle, seconds = self.service.handles.get(scene), self.service.seconds(time_limit, USUAL)
        async with handle.changing:
            before = handle.current
            options = {"init": init, "candidates": candidates, "seed": seed}
            result = await self.service.long(context, "refine", seconds, scene=before.content, **options)
            change = f"refined, {result['valid']} of {candidates} layouts valid"
            return await self.service.changed(context, handle, before, result, change)

    async def repair(
        self,
        scene: SceneId,
        context: Context,
        relations: Annotated[bool, Field(description="Whether hard relations are to hold afterwards, too")] = True,
        seed: Seed = 0,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, SceneState]:
        """Move objects as little as makes the scene valid. Nothing is added, dropped or resized."""
        handle, seconds = self.service.handles.get(scene), self.service.seconds(time_limit, USUAL)
        async with handle.changing:
            before = handle.current
            options = {"relations": relations, "seed": seed}
            result = await self.service.long(context, "repair", seconds, scene=before.content, **options)
            return await self.service.changed(context, handle, before, result, "repaired")

    async def check(
        self,
        scene: SceneId,
        context: Context,
        version: VersionNumber | None = None,
        physics: Annotated[bool, Field(description="Simulate it as well: does everything stay where it is?")] = False,
        openable: Annotated[
            bool, Field(description="Open doors and drawers as well: is anything in their way?")
        ] = False,
    ) -> Annotated[CallToolResult, Checked]:
        """Judge a scene: collisions, bounds, support, free zones, relations. Changes nothing."""
        handle = self.service.handles.get(scene)
        one = handle.get(version)
        options = {"physics": physics, "openable": openable}
        report = await self.service.quick(context, "check", scene=one.content, **options)
        found = Checked(
            scene=handle.id,
            version=one.number,
            valid=report["valid"],
            violations=faults(report, True, MOST_LISTED),
            soft=faults(report, False, MOST_LISTED),
            counts={name: report[name] for name in COUNTS},
            walkable_share=report["walkable_share"],
            reachable_share=report["reachable_share"],
            warnings=[self.service.folder.without_paths(w) for w in report.get("warnings", ())],
            resource=f"report://{handle.id}",
        )
        lines = [f"{handle.id} version {one.number}: {'valid' if found.valid else 'NOT valid'}"]
        lines += [f"- wrong: {line}" for line in found.violations] + [f"- soft: {line}" for line in found.soft]
        return answer(found, "\n".join(lines + [f"- warning: {line}" for line in found.warnings]))

    async def explain(
        self,
        scene: SceneId,
        context: Context,
        version: VersionNumber | None = None,
        seed: Seed = 0,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, Explained]:
        """Say why a scene is not valid: what is wrong as it stands, which relations conflict, where room is short."""
        handle, seconds = self.service.handles.get(scene), self.service.seconds(time_limit, USUAL)
        one = handle.get(version)
        valid, possible = bool(one.report["valid"]), None
        lines = ["the scene is valid; there is nothing to explain"] if valid else faults(one.report, True, MOST_LISTED)
        if not valid:
            found = await self.service.long(context, "explain", seconds, scene=one.content, seed=seed)
            possible = found["found"] > 0 if found["found"] or not found["timed_out"] else None
            lines += found["lines"]
            if possible:
                lines.append(f"a valid layout exists: {found['found']} of {found['tried']} were; refine or repair it")
        told = Explained(scene=handle.id, version=one.number, valid=valid, possible=possible, lines=lines)
        return answer(told, "\n".join([f"{handle.id} version {one.number}", *(f"- {line}" for line in lines)]))
