"""Tools that plan, design, open and furnish whole homes, and take rooms out of them and put them back."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from mcp.server.mcpserver import Context
from mcp_types import CallToolResult
from pydantic import Field

from sceneweaver.scene import InputError

from .answers import OpenedScene
from .answers_homes import DesignedHome, FurnishedHomeState, HomeState, PlannedHome, PlanOption, RoomOutcome
from .homes import home_fields, opened_home, read_home
from .inputs import HomeId, Name, Profile, RoomId, SceneId, Seconds, Seed, VersionNumber
from .limits import MOST_CANDIDATES, MOST_PLANS, MOST_PROMPT
from .service import Service, answer, uri_of
from .tools_scenes import STARTING
from .words import state_text
from .words_homes import home_text

USUAL, USUAL_PLANS = 300.0, 60.0
"""Seconds that a design, or the furnishing of rooms, and that a search for plans may take unless the call says so."""

HomePrompt = Annotated[str, Field(max_length=MOST_PROMPT, description="The home, in plain English")]
Request = Annotated[str, Field(max_length=MOST_PROMPT)]
Steps = Annotated[int, Field(ge=1, le=100, description="Steps of the agent in a room at most")]
Candidates = Annotated[
    int | None, Field(ge=1, le=MOST_CANDIDATES, description="Layouts for each call of a tool; null: by the device")
]
Clutter = Annotated[float, Field(ge=0.0, le=1.0, description="How lived-in: 0 a show room, 1 much lies about")]
Plans = Annotated[int, Field(ge=1, le=MOST_CANDIDATES, description="Plans that are searched for at once")]


class HomeTools:
    """Plan, design, open, furnish; rooms out and in."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def plan_home(
        self,
        context: Context,
        prompt: HomePrompt = "",
        programme: Annotated[
            str | dict[str, Any] | None,
            Field(
                description="Instead of a prompt: the name of an example, or rooms and adjacencies: "
                '{"rooms": [{"id": "hall", "type": "entrance_hall", "area": 6}, ...], "adjacencies": [["hall", '
                '"kitchen"], {"a": "kitchen", "b": "dining", "kind": "open"}]}; kinds: door, open, near, apart'
            ),
        ] = None,
        envelope: Annotated[
            dict[str, Any] | None,
            Field(
                description='What the plan fits into: {"width": 10, "depth": 8, "closed": [3], "entrance_wall": 3} '
                '(walls: 0 south, 1 east, 2 north, 3 west; closed: without windows), or {"outline": [[x, y], ...], '
                '"open_walls": [0, 1]}; null: as the prompt says, or chosen'
            ),
        ] = None,
        profile: Profile | None = None,
        count: Annotated[int, Field(ge=1, le=MOST_PLANS, description="Plans that are kept, each as a version")] = 4,
        plans: Plans = 1024,
        seed: Seed = 0,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, PlannedHome]:
        """Plan a whole home without furniture: rooms, walls, doors, windows, stairs. Takes seconds.

        The best plans become versions of one home, the best of them its first and current one; look at them with
        render_home, then furnish the one you like with furnish_home.
        """
        service = self.service
        service.homes.require_room()
        seconds = service.seconds(time_limit, USUAL_PLANS)
        options = {"profile": profile, "count": count, "plans": plans, "seed": seed}
        made = await service.long(
            context, "plan_home", seconds, prompt=prompt, programme=programme, envelope=envelope, **options
        )
        rows = made["plans"]
        handle = service.homes.open(rows[0]["home"], rows[0]["report"], "planned", None, made["basis"])
        versions = [handle.current, *(handle.add(r["home"], r["report"], "planned otherwise") for r in rows[1:])]
        handle.go(versions[0].number)
        await context.notify_resources_changed()
        state = PlannedHome(
            **home_fields(service, handle, handle.current, "planned", made["notes"]),
            options=[
                PlanOption(
                    version=version.number,
                    cost=row["cost"],
                    area=round(sum(version.report["plan"]["areas"].values()), 2),
                    soft=row["soft"],
                )
                for version, row in zip(versions, rows, strict=True)
                if version.number in handle.versions
            ],
            found=made["found"],
        )
        return answer(state, home_text(state))

    async def design_home(
        self,
        prompt: Annotated[str, Field(min_length=1, max_length=MOST_PROMPT, description="The home, in plain English")],
        context: Context,
        profile: Profile | None = None,
        seed: Seed = 0,
        steps: Steps = 10,
        candidates: Candidates = None,
        clutter: Clutter = 0.4,
        plans: Plans = 1024,
        folder: Annotated[
            Name | None, Field(description="Where its files go; a run that was cut off there goes on; null: a new one")
        ] = None,
        pictures: Annotated[
            Literal["none", "hero", "full"],
            Field(description="Into the folder: the plan; views from above and a page too; and at eye level"),
        ] = "none",
        formats: Annotated[
            list[Literal["glb", "usd", "mjcf", "sdf", "urdf"]], Field(max_length=5, description="Files for other tools")
        ] = [],  # noqa: B006 - the default of a schema, which nothing changes
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, DesignedHome]:
        """Design a whole home from a request in words: planned, all rooms furnished, checked. Takes minutes.

        For a flat, a house, a practice, an office of several rooms; for one room take design. The home is opened under
        a handle, and kept in a folder; each room that is done is reported.
        """
        service = self.service
        service.homes.require_room()
        seconds = service.seconds(time_limit, USUAL)
        name = folder or service.files.free_name("home")
        out = service.files.run_folder(name, "folder", "run.json")
        options = {"seed": seed, "steps": steps, "candidates": candidates, "clutter": clutter, "plans": plans}
        made = await service.long(
            context,
            "design_home",
            seconds + STARTING,
            out,
            prompt=prompt,
            out=str(out),
            profile=profile,
            pictures=pictures,
            export=list(formats) or "none",
            time_limit=seconds,
            **options,
        )
        handle = service.homes.open(made["home"], made["report"], "designed", made["review"], made["basis"])
        await context.notify_resources_changed()
        state = DesignedHome(
            **home_fields(service, handle, handle.current, "designed", made["notes"]),
            furnished=_outcomes(made["rooms"]),
            folder=name,
            files=made["files"],
            style=made["review"]["style"],
            unmet=made["unmet"],
            undone=[service.folder.without_paths(each) for each in made["undone"]],
            log=made["review"]["log"],
        )
        return answer(state, home_text(state))

    async def open_home(self, name: Name, context: Context) -> Annotated[CallToolResult, HomeState]:
        """Open a home.json below the server's folder (or a folder that has one), or an example by its name."""
        service = self.service
        service.homes.require_room()
        home, source = read_home(service.folder, name)
        report = await service.quick(context, "check_home", home=home, basis=None)
        handle = service.homes.open(home, report, f"opened {source}")
        await context.notify_resources_changed()
        state = opened_home(service, handle)
        return answer(state, home_text(state))

    async def furnish_home(
        self,
        home: HomeId,
        context: Context,
        requests: Annotated[
            dict[str, Request] | None,
            Field(
                max_length=60,
                description='Rooms to furnish, by id, with what each is to hold: {"bath": "a bathroom with a tub"}; '
                "empty words: what it was to hold before, or is usual. The other rooms stay. null: all rooms",
            ),
        ] = None,
        seed: Annotated[Seed | None, Field(description="Another one draws these rooms anew; null: the home's")] = None,
        steps: Steps = 10,
        candidates: Candidates = None,
        clutter: Clutter = 0.4,
        version: VersionNumber | None = None,
        time_limit: Seconds | None = None,
    ) -> Annotated[CallToolResult, FurnishedHomeState]:
        """Furnish rooms of a home, or furnish them anew: one, some, or all, in the look of the home. Takes minutes.

        This is how a room is drawn again and how what it holds is changed; walls, doors and windows stay.
        """
        service = self.service
        handle, seconds = service.homes.get(home), service.seconds(time_limit, USUAL)
        if requests is not None and not requests:
            raise InputError("requests: is empty; name a room, or leave it out for all rooms")
        options = {"seed": seed, "steps": steps, "candidates": candidates, "clutter": clutter}
        async with handle.changing:
            before = handle.get(version)
            for name in requests or ():
                before.content.room(name)
            given = {"home": before.content, "basis": handle.basis, "requests": requests, "time_limit": seconds}
            made = await service.long(context, "furnish_home", seconds + STARTING, **given, **options)
            change = (
                f"furnished {', '.join(requests) if requests is not None else 'all rooms'} of version {before.number}"
            )
            handle.go(before.number)
            after = handle.add(made["home"], made["report"], change)
            await context.notify_resource_updated(uri_of(handle))
        fields = home_fields(service, handle, after, change, made["notes"])
        state = FurnishedHomeState(**fields, furnished=_outcomes(made["rooms"]))
        return answer(state, home_text(state))

    async def open_room(
        self, home: HomeId, room: RoomId, context: Context, version: VersionNumber | None = None
    ) -> Annotated[CallToolResult, OpenedScene]:
        """Open a furnished room of a home as a scene, for the tools that edit scenes; put_room puts it back."""
        service = self.service
        service.handles.require_room()
        one = service.homes.get(home).get(version)
        scene = one.content.room(room).scene
        if scene is None:
            raise InputError(f"room: '{room}' is not furnished; furnish_home does that")
        report = await service.quick(context, "check", scene=scene)
        handle = service.handles.open(scene, report, f"{room} of {home} version {one.number}")
        await context.notify_resources_changed()
        state = OpenedScene(**service.opened(handle, []))
        return answer(state, state_text(state))

    async def put_room(
        self,
        home: HomeId,
        room: RoomId,
        scene: SceneId,
        context: Context,
        version: VersionNumber | None = None,
    ) -> Annotated[CallToolResult, HomeState]:
        """Put a scene in the place of a room of a home; its walls, doors and windows have to be that room's."""
        service = self.service
        handle, one = service.homes.get(home), service.handles.get(scene).current
        async with handle.changing:
            before = handle.get(version)
            changed = before.content.with_scene(room, one.content)
            report = await service.quick(context, "check_home", home=changed, basis=handle.basis)
            change = f"{scene} version {one.number} put into {room} of version {before.number}"
            handle.go(before.number)
            after = handle.add(changed, report, change)
            await context.notify_resource_updated(uri_of(handle))
        state = HomeState(**home_fields(service, handle, after, change, []))
        return answer(state, home_text(state))


def _outcomes(rooms: dict[str, dict[str, Any]]) -> list[RoomOutcome]:
    return [RoomOutcome(room=name, **outcome) for name, outcome in rooms.items()]
