"""Tables at which people stand."""

from __future__ import annotations

from sceneweaver.assets.roles import has_role

from .model import SceneGraph


def stood_at(graph: SceneGraph) -> frozenset[str]:
    """The ids of high tables that a request calls standing ones: no seats belong to them."""
    return frozenset(e.id for e in graph.entities if e.standing and has_role(e.category, "counter"))


__all__ = ["stood_at"]
