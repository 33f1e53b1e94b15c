"""``sceneweaver mcp``."""

from __future__ import annotations

from pathlib import Path
from typing import Literal


def run_mcp(
    folder: Path,
    *,
    transport: Literal["stdio", "http"],
    port: int,
    device: str,
    time_limit: float,
    scenes: int,
    versions: int,
) -> int:
    """Serve scenes over the Model Context Protocol until the client leaves, or a signal comes.

    Raises:
        InputError: for a folder or port that cannot be used.
        MissingDependencyError: without the extra ``mcp``.
    """
    from sceneweaver.mcp import serve
    from sceneweaver.mcp.limits import Limits

    limits = Limits(seconds=time_limit, scenes=scenes, versions=versions)
    serve(folder, transport=transport, port=port, device=device, limits=limits)
    return 0
