"""Tools that open, design, list and close scenes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated, Any, Literal

import anyio
import anyio.to_thread
from mcp.server.mcpserver import Context
from mcp_types import CallToolResult
from pydantic import Field

from sceneweaver.home.io import EXAMPLES as HOME_EXAMPLES
from sceneweaver.io import read_bytes
from sceneweaver.plans import programme_names
from sceneweaver.runtime.options import takes
from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.io import EXAMPLES

from .answers import Closed, DesignedScene, OpenedScene, OpenScene, SceneList
from .handles import Handles
from .homes import FILE as HOME_FILE
from .homes import open_homes
from .inputs import Name, OpenId, Prompt, Seconds, design_parameters
from .limits import MOST_FOUND, MOST_SCENE
from .paths import Folder
from .service import Progress, Service, answer
from .words import state_text

USUAL = 120.0
"""Seconds that a design may take unless the call says otherwise."""

USUAL_BY_MODEL = 600.0
"""The same where a language model plans it, as far as the server gives so much."""

STARTING = 20.0
"""Seconds that the process of a design may take beyond its time limit: it starts up, and writes the results."""

DEEPEST = 6
"""Folders below the server's in which scene files are looked for."""


class SceneTools:
    """Design, open, list and close."""

    def __init__(self, service: Service) -> None:
        self.service = service

    @takes(design_parameters())
    async def design(
        self,
        prompt: Prompt,
        context: Context,
        *,
        time_limit: Seconds | None = None,
        folder: Annotated[
            Name | None, Field(description="Where its files go; a run that was cut off there goes on; null: a new one")
        ] = None,
        pictures: Annotated[bool, Field(description="Draw pictures and a report into the folder")] = False,
        formats: Annotated[
            list[Literal["glb", "usd", "mjcf", "scenestate"]], Field(max_length=4, description="Files for other tools")
        ] = [],  # noqa: B006 - the default of a schema, which nothing changes
        **options: Any,
    ) -> Annotated[CallToolResult, DesignedScene]:
        """Design a furnished room from a request in words. Takes from seconds to minutes; reports each step.

        The scene is opened under a handle, and kept in a folder with its report and every step.
        """
        service, planner = self.service, options["planner"]
        service.handles.require_room()
        seconds = service.seconds(time_limit, USUAL if planner == "rules" else USUAL_BY_MODEL)
        if planner == "llm" and service.llm is None:
            raise InputError("planner: llm needs a model, and this server was started without one; use rules")
        name = folder or service.files.free_name("room")
        out = service.files.run_folder(name, "folder")
        made = await service.workers.long.run(
            "design",
            {
                "prompt": prompt,
                "out": str(out),
                "time_limit": seconds,
                "pictures": pictures,
                "export": list(formats) or "none",
                **options,
                **(service.llm or {} if planner == "llm" else {}),
            },
            Progress(context),
            seconds=seconds + STARTING,
            folder=out,
        )
        handle = service.handles.open(made["scene"], made["report"], "designed", made["review"])
        await context.notify_resources_changed()
        state = DesignedScene(
            **service.opened(handle, made["notes"]),
            folder=name,
            grades={key: round(value, 2) for key, value in made["review"]["grades"].items()},
            unmet=made["unmet"],
            steps=made["steps"],
            finished=made["finished"],
            undone=[service.folder.without_paths(each) for each in made["undone"]],
            model=made["model"],
        )
        return answer(state, state_text(state))

    async def open(self, name: Name, context: Context) -> Annotated[CallToolResult, OpenedScene]:
        """Open a scene file below the server's folder (or a folder with a scene.json), or an example by its name."""
        service = self.service
        service.handles.require_room()
        scene, source = read_scene(service.folder, name)
        report = await service.quick(context, "check", scene=scene)
        handle = service.handles.open(scene, report, f"opened {source}")
        await context.notify_resources_changed()
        state = OpenedScene(**service.opened(handle, []))
        return answer(state, state_text(state))

    async def list_scenes(self) -> Annotated[CallToolResult, SceneList]:
        """List the scenes and homes that are open, and the files, examples and programmes that can be opened."""
        service = self.service
        files, home_files = await anyio.to_thread.run_sync(openable_files, service.folder)
        listed = SceneList(
            open=open_scenes(service.handles),
            files=files,
            examples=list(EXAMPLES),
            homes=open_homes(service.homes),
            home_files=home_files,
            home_examples=list(HOME_EXAMPLES),
            programmes=list(programme_names()),
        )
        lines = [
            f"{each.scene}: {each.name}, version {each.version}, {each.objects} objects, "
            f"{'valid' if each.valid else 'NOT valid'}"
            for each in listed.open
        ]
        lines += [
            f"{each.home}: {each.name}, version {each.version}, {each.rooms} rooms, {each.furnished} furnished, "
            f"{'valid' if each.valid else 'NOT valid'}"
            for each in listed.homes
        ]
        told = {"files": files, "examples": listed.examples, "homes": home_files}
        told |= {"examples of homes": listed.home_examples, "programmes": listed.programmes}
        lines = ["open: " + ("; ".join(lines) or "none")]
        return answer(listed, "\n".join([*lines, *(f"{what}: {', '.join(n) or 'none'}" for what, n in told.items())]))

    async def close(self, scene: OpenId, context: Context) -> Annotated[CallToolResult, Closed]:
        """Forget an open scene or home with all its versions. Files stay; export first what is to be kept."""
        service = self.service
        handle = (service.homes if scene in service.homes else service.handles).close(scene)
        await context.notify_resources_changed()
        closed = Closed(scene=handle.id, versions=len(handle.versions))
        return answer(closed, f"{handle.id} is closed, with {closed.versions} versions")


def read_scene(folder: Folder, name: str) -> tuple[Scene, str]:
    """A scene by the name of a file, of a folder that holds one, or of an example, and where it is from.

    Raises:
        InputError: for a name that is refused, or what is no scene.
    """
    path = folder.place(name, "name")
    if name in EXAMPLES and not path.exists():
        return Scene.example(name), f"the example {name}"
    if path.is_dir():
        path = folder.place(f"{name}/scene.json", "name")
    shown = folder.shown(path)
    if path.suffix.lower() != ".json":
        raise InputError(f"name: '{shown}' is no scene file; give one that ends in .json, or an example")
    try:
        return Scene.loads(read_bytes(path, max_bytes=MOST_SCENE)), shown
    except InputError as error:
        raise InputError(f"name: {shown}: {str(error).removeprefix(f'{path}: ')}") from None


def open_scenes(handles: Handles[Scene]) -> list[OpenScene]:
    """All open scenes."""
    return [
        OpenScene(
            scene=handle.id,
            name=handle.current.content.id,
            version=handle.current.number,
            versions=sorted(handle.versions),
            objects=len(handle.current.content.objects),
            valid=handle.current.report["valid"],
        )
        for handle in handles
    ]


def openable_files(folder: Folder) -> tuple[list[str], list[str]]:
    """Names of scenes and of homes below a folder: files called scene.json and home.json, and other JSON files right in
    it as scenes; links are left out."""
    scenes, homes = list[str](), list[str]()
    for at, folders, names in os.walk(folder.root):
        deep = len(Path(at).relative_to(folder.root).parts)
        folders[:] = sorted(n for n in folders if not n.startswith(".") and deep < DEEPEST and n != "steps")
        for name in sorted(names):
            wanted = name == "scene.json" or (not deep and name.endswith(".json"))
            if name.startswith(".") or not (wanted or name == HOME_FILE) or Path(at, name).is_symlink():
                continue
            (homes if name == HOME_FILE else scenes).append(folder.shown(Path(at, name)))
        if len(scenes) + len(homes) >= MOST_FOUND:
            break
    return scenes[:MOST_FOUND], homes[:MOST_FOUND]
