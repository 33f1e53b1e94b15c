"""Tools that judge, draw and export whole homes."""

from __future__ import annotations

import base64
from typing import Annotated, Any, Literal

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult, ImageContent
from pydantic import Field, FiniteFloat

from .answers_homes import CheckedHome, ExportedHome, HomePicture, RenderedHome
from .inputs import HomeId, Name, Profile, Seconds, Side, VersionNumber
from .limits import MOST_VIEWS
from .service import Service, answer
from .tools_output import USUAL, picture_names
from .words_homes import checked_text, home_faults, soft_rules

ViewName = Annotated[str, Field(min_length=1, max_length=80)]


class HomeOutputTools:
    """Check, render, export homes."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def check_home(
        self,
        home: HomeId,
        context: Context,
        version: VersionNumber | None = None,
        robot_radius: Annotated[
            FiniteFloat, Field(ge=0.01, le=5, description="Of the round base that goes through the home [m]")
        ] = 0.25,
        profile: Annotated[
            Profile | None, Field(description="Rules of its plan; null: those of its plan, if any")
        ] = None,
        physics: Annotated[bool, Field(description="Simulate each room as well: does everything stay?")] = False,
        openable: Annotated[bool, Field(description="Open doors and drawers of furniture as well")] = False,
    ) -> Annotated[CallToolResult, CheckedHome]:
        """Judge a home: its plan by rules, its rooms, its doors and walls, and the ways from the entrance.

        Changes nothing. For the rules of plans alone, such as accessible ones, give a profile.
        """
        service = self.service
        handle = service.homes.get(home)
        one, basis = handle.get(version), handle.basis
        if profile is not None:
            basis = {"programme": basis["programme"] if basis else None, "profile": profile}
        options: dict[str, Any] = {"robot_radius": robot_radius, "physics": physics, "openable": openable}
        report = await service.quick(context, "check_home", home=one.content, basis=basis, **options)
        access = report["access"]
        found = CheckedHome(
            home=handle.id,
            version=one.number,
            valid=report["valid"],
            violations=home_faults(report),
            soft=soft_rules(report),
            plan_valid=report["plan"]["valid"] if "plan" in report else None,
            rooms={name: each["valid"] for name, each in report["rooms"].items()},
            **{
                name: access[name]
                for name in ("entrance", "walkable_share", "reachable_share", "unreached_rooms", "unreached_objects")
            },
            blocked_doors=access["blocked_doors"],
            by_stairs=access["by_stairs"],
            resource=f"report://{handle.id}",
        )
        return answer(found, checked_text(found))

    async def render_home(
        self,
        home: HomeId,
        context: Context,
        views: Annotated[
            list[ViewName],
            Field(
                min_length=1,
                max_length=MOST_VIEWS,
                description="plan: the drawing with dimensions, quick; overview: furnished rooms without roof; both of "
                "the lowest storey, or plan_STOREY, overview_STOREY; walk_01, walk_02 ...: at eye level, from the "
                "entrance on",
            ),
        ] = ["plan"],  # noqa: B006 - the default of a schema, which nothing changes
        width: Side = 1120,
        height: Side = 840,
        name: Annotated[
            Name | None, Field(description="Save them as well: a name that ends in .png; of several, -VIEW is added")
        ] = None,
        version: VersionNumber | None = None,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, RenderedHome]:
        """Draw a home: plans as architects draw them, storeys from above, a walk; the pictures are in the answer."""
        service = self.service
        handle, seconds = service.homes.get(home), service.seconds(time_limit, USUAL)
        one, wanted = handle.get(version), list(dict.fromkeys(views))
        names = picture_names(name, wanted)
        for each in names.values():
            service.folder.to_write(each, "name", ".png")
        options: dict[str, Any] = {"views": wanted, "width": width, "height": height}
        drawn = await service.long(context, "render_home", seconds, home=one.content, **options)
        pictures, images = [], []
        for view, shows, wide, high, data in drawn:
            if view in names:
                service.files.write(names[view], data, "name", ".png")
            pictures.append(HomePicture(view=view, shows=shows, width=wide, height=high, file=names.get(view)))
            images.append(ImageContent(data=base64.b64encode(data).decode(), mime_type="image/png"))
        told = RenderedHome(home=handle.id, version=one.number, pictures=pictures)
        lines = [
            f"{p.view}: {p.shows}, {p.width} x {p.height}" + (f", saved as {p.file}" if p.file else "")
            for p in pictures
        ]
        return answer(told, "\n".join([f"{handle.id} version {one.number}", *lines]), *images)

    async def export_home(
        self,
        home: HomeId,
        context: Context,
        formats: Annotated[
            list[Literal["home", "plan", "report", "glb", "usd", "usda", "mjcf", "sdf", "urdf"]],
            Field(
                min_length=1,
                max_length=9,
                description="home: home.json, which open_home reads; plan: SVG drawings; report: a page with rooms to "
                "click and a 3D view",
            ),
        ] = ["home", "plan"],  # noqa: B006
        folder: Annotated[Name | None, Field(description="Where the files go; null: a new folder")] = None,
        textures: Annotated[bool, Field(description="Materials with their maps, or plain and small")] = True,
        version: VersionNumber | None = None,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, ExportedHome]:
        """Write a whole home as one scene for other tools, into a folder; an older export there is replaced."""
        service = self.service
        handle, seconds = service.homes.get(home), service.seconds(time_limit, USUAL)
        one = handle.get(version)
        place = folder or service.files.free_name(f"export-{handle.id}-v{one.number}")
        options: dict[str, Any] = {"formats": list(dict.fromkeys(formats)), "textures": textures}
        with service.files.new_folder(place, "folder") as new:
            options["folder"] = str(new)
            given = {"home": one.content, "report": one.report, **options}
            files = await service.long(context, "export_home", seconds, new.parent.parent, **given)
        told = ExportedHome(home=handle.id, version=one.number, folder=place, files=files)
        lines = [f"{name}: {place}/{file}" for name, file in files.items()]
        return answer(told, "\n".join([f"{handle.id} version {one.number} in {place}", *lines]))
