"""The entry points: a server as an object, and one that serves until it is told to end."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError

from .limits import Limits

if TYPE_CHECKING:
    from .server import SceneServer

PORT = 8643
"""Port of streamable HTTP unless another is given."""


def build_server(
    folder: str | Path = ".",
    *,
    device: str = "auto",
    limits: Limits | None = None,
    llm: Mapping[str, Any] | None = None,
) -> SceneServer:
    """A server for the scenes of one folder, not yet connected to anything.

    Args:
        folder: below which all files are read and written; it must be there.
        device: "auto", "cpu", "cuda" or "cuda:k".
        limits: how much is kept and for how long calls may run.
        llm: arguments of `sceneweaver.design` with which it asks a language model; None: the tool refuses to.

    Raises:
        InputError: for a folder that cannot be used, or limits out of range.
        MissingDependencyError: without the SDK of the Model Context Protocol.
    """
    limits = limits or Limits()
    for name in ("seconds", "scenes", "versions", "waiting"):
        if not getattr(limits, name) >= 1:
            raise InputError(f"limits: {name} is {getattr(limits, name)}; give at least 1")
    try:
        import mcp.server.mcpserver  # noqa: F401
    except ModuleNotFoundError as error:
        name = error.name or "mcp"
        what = f"the package '{name}' is missing, without which there is no MCP server"
        raise MissingDependencyError(missing_extra("mcp", what)) from None
    from .server import make_server

    return make_server(folder, device, limits, llm)


def serve(
    folder: str | Path = ".",
    *,
    transport: Literal["stdio", "http"] = "stdio",
    port: int = PORT,
    device: str = "auto",
    limits: Limits | None = None,
    llm: Mapping[str, Any] | None = None,
) -> None:
    """Serve the scenes of one folder until the client leaves (stdio) or a signal comes.

    Args:
        folder, device, limits, llm: as for `build_server`.
        transport: "stdio", or "http": streamable HTTP that only this computer can reach.
        port: of HTTP; 0 takes any that is free.

    Raises:
        InputError: as `build_server`, and for a port that is not free.
        MissingDependencyError: as `build_server`.
    """
    if transport not in ("stdio", "http"):
        raise InputError(f"--transport: '{transport}' is unknown; use stdio or http")
    server = build_server(folder, device=device, limits=limits, llm=llm)
    from .transports import serve_http, serve_stdio

    if transport == "stdio":
        serve_stdio(server)
    else:
        serve_http(server, port)
