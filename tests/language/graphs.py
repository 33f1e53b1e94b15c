"""What holds of every scene graph, whatever the request was."""

from __future__ import annotations

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import SceneGraph

PLACES = {"window", "door", "corner", "middle", "half", "wall", "ceiling", "floor", "room"}


def consistent(graph: SceneGraph) -> None:
    """Names are unique, relations are about what is there, and counts make sense."""
    ids = [a.id for a in graph.entities]
    assert len(ids) == len(set(ids))
    assert all(category_named(a.category).size is not None for a in graph.entities)
    assert all(a.count is None or 0 <= a.count[0] <= a.count[1] for a in graph.entities)
    for relation in graph.relations:
        assert relation.subject in ids
        for target in relation.targets:
            assert target in ids or target.split(":")[0] in PLACES
            assert target != relation.subject
