"""Open scenes and homes, and their reports, as resources."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from mcp.server.mcpserver import MCPServer
from mcp.server.mcpserver.exceptions import ResourceNotFoundError
from mcp_types import Resource

from sceneweaver.home import Home
from sceneweaver.scene import InputError, Scene

from .handles import Handle, Handles, Version
from .homes import report_data

JSON = "application/json"


def add_resources(server: MCPServer[Any], handles: Handles[Scene], homes: Handles[Home]) -> None:
    """Give a server the templates ``scene://{scene}``, ``scene://{scene}/{version}``, the same of homes, and
    ``report://{scene}``, which takes both."""

    @server.resource("scene://{scene}", name="scene", mime_type=JSON)
    def current(scene: str) -> str:
        """An open scene as it is now, in the form of scene.json."""
        return _found(lambda: handles.get(scene).current.content.dumps())

    @server.resource("scene://{scene}/{version}", name="version", mime_type=JSON)
    def numbered(scene: str, version: str) -> str:
        """A version of an open scene, in the form of scene.json."""
        return _found(lambda: handles.get(scene).get(_number(version)).content.dumps())

    @server.resource("home://{home}", name="home", mime_type=JSON)
    def current_home(home: str) -> str:
        """An open home as it is now, in the form of home.json."""
        return _found(lambda: homes.get(home).current.content.dumps())

    @server.resource("home://{home}/{version}", name="home version", mime_type=JSON)
    def numbered_home(home: str, version: str) -> str:
        """A version of an open home, in the form of home.json."""
        return _found(lambda: homes.get(home).get(_number(version)).content.dumps())

    @server.resource("report://{scene}", name="report", mime_type=JSON)
    def report(scene: str) -> str:
        """The judge's report on an open scene or home as it is now, and what the design said that it came from."""
        if scene in homes:
            return _text(report_data(homes.get(scene)))
        return _found(lambda: report_text(handles.get(scene)))


def report_text(handle: Handle[Scene]) -> str:
    """The report and the review of a scene as JSON; the review may be of an earlier version, which it names."""
    version = handle.current
    reviewed = _reviewed(handle)
    data = {
        "scene": handle.id,
        "version": version.number,
        "report": version.report,
        "review": reviewed.review if reviewed else None,
        "reviewed_version": reviewed.number if reviewed else None,
    }
    return _text(data)


def listed(handles: Handles[Scene], homes: Handles[Home]) -> list[Resource]:
    """The resources of all open scenes and homes."""
    return [
        Resource(uri=f"{kind}://{handle.id}", name=f"{handle.current.content.id} {kind}", mime_type=JSON)
        for one, some in (("scene", handles), ("home", homes))
        for handle in some
        for kind in (one, "report")
    ]


def _text(data: Any) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False)


def _reviewed(handle: Handle[Scene]) -> Version[Scene] | None:
    """The latest version that was reviewed, no later than the current one."""
    upto = [handle.versions[n] for n in sorted(handle.versions) if n <= handle.current.number]
    return next((version for version in reversed(upto) if version.review is not None), None)


def _number(text: str) -> int:
    if not text.isascii() or not text.isdigit() or len(text) > 9:
        raise InputError("version: this is no number of a version")
    return int(text)


def _found(read: Callable[[], str]) -> str:
    try:
        return read()
    except InputError as error:
        raise ResourceNotFoundError(str(error)) from None
