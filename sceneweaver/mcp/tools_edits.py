"""Tools that change a scene: everyday edits, after which the scene is made valid again, and typed ones."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult
from pydantic import Field

from sceneweaver.scene import InputError

from .answers import SceneState
from .inputs import Degrees, Exact, Metres, ObjectId, Point, SceneId, Seed, Target, Words
from .service import Service

Params = Annotated[dict[str, Any], Field(max_length=20, description="Numbers of the type, such as {max: 1.5}")]


class EditTools:
    """Edits of an open scene; each makes a version."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def move(
        self,
        scene: SceneId,
        object: ObjectId,  # noqa: A002 - the name of the argument in the protocol
        context: Context,
        to: Annotated[Point | None, Field(description="Where its bottom centre goes: x, y or x, y, z [m]")] = None,
        by: Annotated[Point | None, Field(description="Or how far it goes: dx, dy or dx, dy, dz [m]")] = None,
        turn: Degrees = 0.0,
        exact: Exact = False,
    ) -> Annotated[CallToolResult, SceneState]:
        """Move an object, with all that stands on it. Others make way as little as needed."""
        if to is None and by is None and not turn:
            raise InputError("move: say where to; give to, by or turn")
        options = {"name": object, "to": to, "by": by, "turn": turn}
        return await self._edit(context, scene, "move", options, f"moved {object}", exact)

    async def turn(
        self,
        scene: SceneId,
        object: ObjectId,  # noqa: A002
        degrees: Degrees,
        context: Context,
        exact: Exact = False,
    ) -> Annotated[CallToolResult, SceneState]:
        """Turn an object where it stands, counter-clockwise."""
        options = {"name": object, "turn": degrees}
        return await self._edit(context, scene, "move", options, f"turned {object}", exact)

    async def resize(
        self,
        scene: SceneId,
        object: ObjectId,  # noqa: A002
        context: Context,
        depth: Metres | None = None,
        width: Metres | None = None,
        height: Metres | None = None,
        exact: Exact = False,
    ) -> Annotated[CallToolResult, SceneState]:
        """Resize an object; what is not given stays as it is."""
        options = {"name": object, "depth": depth, "width": width, "height": height}
        if depth is None and width is None and height is None:
            raise InputError("resize: give depth, width or height")
        return await self._edit(context, scene, "resize", options, f"resized {object}", exact)

    async def add(
        self,
        scene: SceneId,
        what: Annotated[Words, Field(description='A noun with words about its look: "small round table"')],
        context: Context,
        at: Annotated[Point | None, Field(description="Where it is to stand, x, y [m]; null: the middle")] = None,
        turn: Degrees = 0.0,
        depth: Metres | None = None,
        width: Metres | None = None,
        height: Metres | None = None,
        on: Annotated[ObjectId | None, Field(description="Id of what it stands on")] = None,
        inside: Annotated[ObjectId | None, Field(description="Id of what it stands in, such as a shelf")] = None,
        relations: Annotated[
            dict[str, Target],
            Field(max_length=10, description='Where it goes: {"against_wall": "north", "facing": "desk-0"}'),
        ] = {},  # noqa: B006 - the default of a schema, which nothing changes
        seed: Annotated[Seed | None, Field(description="Another piece of the same words")] = None,
    ) -> Annotated[CallToolResult, SceneState]:
        """Add a piece of furniture by words; it gets the place nearest to where it is wanted."""
        sizes = {"depth": depth, "width": width, "height": height}
        options = {"what": what, "at": at[:2] if at else None, "turn": turn, "on": on, "inside": inside, "seed": seed}
        options |= sizes | {"relations": relations}
        return await self._edit(context, scene, "add", options, f"added {what}")

    async def remove(
        self,
        scene: SceneId,
        object: ObjectId,  # noqa: A002
        context: Context,
        cascade: Annotated[bool, Field(description="Also what stands on it")] = False,
    ) -> Annotated[CallToolResult, SceneState]:
        """Take an object out, with the relations that name it."""
        return await self._edit(context, scene, "remove", {"name": object, "cascade": cascade}, f"removed {object}")

    async def relate(
        self,
        scene: SceneId,
        subject: ObjectId,
        type: Annotated[Words, Field(description="Such as against_wall, facing, near, on_top, left_of")],  # noqa: A002
        context: Context,
        target: Target = True,
        hard: Annotated[bool, Field(description="Whether the scene is invalid where it does not hold")] = True,
        params: Params = {},  # noqa: B006
        frame: Annotated[
            Literal["own", "viewer"] | None,
            Field(description="Whose left and right: the target's own, or of who looks at its front; left_of needs it"),
        ] = None,
    ) -> Annotated[CallToolResult, SceneState]:
        """Add a relation, and move things so that it holds."""
        options = {"subject": subject, "kind": type, "target": True if target is None else target}
        options |= {"hard": hard, "params": params, "frame": frame}
        return await self._edit(context, scene, "relate", options, f"related {subject} {type}")

    async def unrelate(
        self,
        scene: SceneId,
        subject: ObjectId,
        type: Words,  # noqa: A002
        context: Context,
        target: Annotated[
            str | list[str] | None, Field(description='As the scene has it: an id, "wall:2", ...')
        ] = None,
    ) -> Annotated[CallToolResult, SceneState]:
        """Take out a relation."""
        options = {"subject": subject, "kind": type, "target": target}
        return await self._edit(context, scene, "unrelate", options, f"unrelated {subject} {type}")

    async def edit(
        self,
        scene: SceneId,
        edits: Annotated[
            list[dict[str, Any]],
            Field(
                min_length=1,
                max_length=200,
                description='Typed edits, each {"op": ...}: add, remove, replace, relate, unrelate, pose, size, '
                "support, rename, attributes, intent",
            ),
        ],
        context: Context,
        exact: Exact = False,
    ) -> Annotated[CallToolResult, SceneState]:
        """Apply several typed edits as one; all of them or, where one is wrong, none."""
        return await self._edit(context, scene, "edit", {"edits": edits}, f"{len(edits)} edits", exact)

    async def _edit(
        self, context: Context, scene: str, op: str, arguments: dict[str, Any], change: str, exact: bool = False
    ) -> CallToolResult:
        handle = self.service.handles.get(scene)
        async with handle.changing:
            before = handle.current
            job = "exact" if exact else "edit"
            result = await self.service.quick(context, job, scene=before.content, op=op, arguments=arguments)
            return await self.service.changed(context, handle, before, result, change)
