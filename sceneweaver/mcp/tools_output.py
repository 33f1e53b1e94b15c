"""Tools that draw and export scenes, and list furniture."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import Annotated, Any, Literal

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult, ImageContent
from pydantic import Field

from sceneweaver.scene import InputError

from .answers import Exported, FurnitureList, Picture, Rendered
from .inputs import Name, SceneId, Seconds, Side, VersionNumber, Words
from .limits import MOST_VIEWS
from .service import Service, answer

View = Literal["plan", "top", "top_annotated", "corner", "corner2", "eye-door", "eye-corner", "eye-corner2"]

USUAL = 120.0
"""Seconds that pictures and files may take unless the call says otherwise."""


class OutputTools:
    """Render, export, list furniture."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def render(
        self,
        scene: SceneId,
        context: Context,
        views: Annotated[
            list[View],
            Field(
                min_length=1,
                max_length=MOST_VIEWS,
                description="plan: an annotated drawing, quick; top, top_annotated, corner, corner2: pictures from "
                "above; eye-door, eye-corner, eye-corner2: at eye level",
            ),
        ] = ["plan"],  # noqa: B006 - the default of a schema, which nothing changes
        width: Side = 960,
        height: Side = 720,
        name: Annotated[
            Name | None, Field(description="Save them as well: a name that ends in .png; of several, -VIEW is added")
        ] = None,
        version: VersionNumber | None = None,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, Rendered]:
        """Draw a scene; the pictures are in the answer."""
        service = self.service
        handle, seconds = service.handles.get(scene), service.seconds(time_limit, USUAL)
        one, wanted = handle.get(version), list(dict.fromkeys(views))
        names = picture_names(name, wanted)
        for each in names.values():
            service.folder.to_write(each, "name", ".png")
        options = {"views": wanted, "width": width, "height": height}
        drawn = await service.long(context, "render", seconds, scene=one.content, **options)
        pictures, images = [], []
        for view, wide, high, data in drawn:
            if view in names:
                service.files.write(names[view], data, "name", ".png")
            pictures.append(Picture(view=view, width=wide, height=high, file=names.get(view)))
            images.append(ImageContent(data=base64.b64encode(data).decode(), mime_type="image/png"))
        told = Rendered(scene=handle.id, version=one.number, pictures=pictures)
        lines = [f"{p.view}: {p.width} x {p.height}" + (f", saved as {p.file}" if p.file else "") for p in pictures]
        return answer(told, "\n".join([f"{handle.id} version {one.number}", *lines]), *images)

    async def export(
        self,
        scene: SceneId,
        context: Context,
        formats: Annotated[
            list[Literal["scene", "usd", "usda", "mjcf", "glb", "scenestate", "sdf", "urdf"]],
            Field(min_length=1, max_length=8, description="scene: scene.json, which open reads"),
        ] = ["scene", "glb"],  # noqa: B006
        folder: Annotated[Name | None, Field(description="Where the files go; null: a new folder")] = None,
        textures: Annotated[bool, Field(description="Materials with their maps, or plain and small")] = True,
        version: VersionNumber | None = None,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, Exported]:
        """Write a scene into a folder below the server's, for other tools; an older export there is replaced."""
        service = self.service
        handle, seconds = service.handles.get(scene), service.seconds(time_limit, USUAL)
        one = handle.get(version)
        place = folder or service.files.free_name(f"export-{handle.id}-v{one.number}")
        options: dict[str, Any] = {"formats": list(dict.fromkeys(formats)), "textures": textures}
        with service.files.new_folder(place, "folder") as new:
            options["folder"] = str(new)
            files = await service.long(context, "export", seconds, new.parent.parent, scene=one.content, **options)
        told = Exported(scene=handle.id, version=one.number, folder=place, files=files)
        lines = [f"{name}: {place}/{file}" for name, file in files.items()]
        return answer(told, "\n".join([f"{handle.id} version {one.number} in {place}", *lines]))

    async def list_furniture(
        self,
        context: Context,
        words: Annotated[
            Words | None,
            Field(description='Things ("desk, floor lamp"), a group ("seating") or a kind of room; null: everything'),
        ] = None,
    ) -> Annotated[CallToolResult, FurnitureList]:
        """List furniture that can be added by words, with usual sizes, and the kinds of rooms that are known."""
        found = FurnitureList.model_validate(await self.service.quick(context, "furniture", words=words))
        if words is not None and not found.furniture:
            raise InputError(f"words: {'; '.join(found.notes) or 'name something, such as desk'}")
        lines = [
            f"{row.words}: " + " x ".join(f"{low:g}-{high:g}" for low, high in row.size) + f" m, {'/'.join(row.mount)}"
            for row in found.furniture
        ]
        rooms = ["rooms: " + ", ".join(name.replace("_", " ") for name in found.rooms)] if words is None else []
        return answer(found, "\n".join([*lines, *rooms, *(f"note: {note}" for note in found.notes)]))


def picture_names(name: str | None, views: Sequence[str]) -> dict[str, str]:
    """The names of the files that pictures are saved as, by view."""
    if name is None:
        return {}
    if len(views) == 1:
        return {views[0]: name}
    stem = name[:-4] if name.lower().endswith(".png") else name
    return {view: f"{stem}-{view}{name[len(stem) :]}" for view in views}
