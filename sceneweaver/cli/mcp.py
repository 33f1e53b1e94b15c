"""``sceneweaver mcp``."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

from sceneweaver.scene import InputError


def run_mcp(
    folder: Path,
    *,
    transport: Literal["stdio", "http"],
    port: int,
    device: str,
    time_limit: float,
    scenes: int,
    versions: int,
    models: dict[str, Any],
) -> int:
    """Serve scenes over the Model Context Protocol until the client leaves, or a signal comes.

    ``models`` are the arguments of a design that say which language model is asked; one has to be named, so that no
    assistant spends what nobody allowed.

    Raises:
        InputError: for a folder, port or model that cannot be used.
        MissingDependencyError: without the extra ``mcp``, or ``llm`` where a model is named.
    """
    if models["model"] is None:
        if any(models.get(name) is not None for name in ("base_url", "limits")):
            raise InputError("--model is missing; name the model that assistants may ask, or leave the others out")
    else:
        from sceneweaver.llm import Endpoint

        Endpoint.of(models["model"], models["base_url"])
    from sceneweaver.mcp import serve
    from sceneweaver.mcp.limits import Limits

    limits = Limits(seconds=time_limit, scenes=scenes, versions=versions)
    llm = models if models["model"] is not None else None
    serve(folder, transport=transport, port=port, device=device, limits=limits, llm=llm)
    return 0
