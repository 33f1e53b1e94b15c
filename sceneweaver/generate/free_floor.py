"""How much floor a request keeps free, for how large a room is drawn."""

from __future__ import annotations

from sceneweaver.language import SceneGraph


def kept_free(brief: SceneGraph) -> float:
    """The floor [m2] that is to stay free as a patch of its own: rectangles and circles, not the ways around things."""
    return sum(area.size[0] * area.size[1] for area in brief.free_areas if area.kind in ("rectangle", "circle"))


def people_of(brief: SceneGraph) -> int | None:
    """For how many people the room is: as the request says it of the room, else of what they do there."""
    told = [one.people for one in brief.capacities]
    return brief.people if brief.people is not None or not told else max(told)
