"""Colours and materials that a request does not want: of nothing in the room, or of some of its things."""

from __future__ import annotations

from collections.abc import Collection

from sceneweaver.assets.materials import finishes
from sceneweaver.assets.scheme import allowed_color, is_avoided
from sceneweaver.knowledge.load import data_of
from sceneweaver.knowledge.palettes import is_allowed
from sceneweaver.language import SceneGraph
from sceneweaver.scene import RoomFinish
from sceneweaver.scene.finish import FloorMaterial

FLOORS: tuple[FloorMaterial, ...] = ("wood", "tile", "stone", "concrete", "carpet")
"""What takes the place of a floor that is not wanted, the likeliest first."""

FAMILY_OF = {"wood": "wood", "tile": "ceramic", "stone": "stone", "carpet": "carpet", "concrete": "concrete"}
"""What a floor is of, by the families of finishes."""


def avoided(brief: SceneGraph) -> tuple[str, ...]:
    """Colours, finishes and families of them that are not wanted, as a palette keeps them."""
    found: list[str] = []
    for one in brief.exclusions:
        if one.relation is None:
            what = (*one.colors, *one.materials)
            found += [f"{of}:{name}" for of in one.within for name in what] if one.within else what
    return tuple(dict.fromkeys(found))


def of_room(avoid: Collection[str]) -> frozenset[str]:
    """Of what is avoided that which holds for all of the room."""
    return frozenset(name for name in avoid if ":" not in name)


def styles_unwanted(brief: SceneGraph) -> frozenset[str]:
    """The styles that are not wanted."""
    return frozenset(style for one in brief.exclusions if one.relation is None for style in one.styles)


def cleaned(finish: RoomFinish, brief: SceneGraph) -> RoomFinish:
    """Walls, floor and ceiling without what the request does not want; what it asks for of a part stays."""
    avoid = of_room(avoided(brief))
    carpet = _no_carpet(brief)
    if not avoid and not carpet:
        return finish
    update: dict[str, object] = {}
    if brief.finish_of("walls") is None and not is_allowed(finish.walls, avoid):
        update["walls"] = allowed_color(finish.walls, avoid) if finish.walls not in finishes() else "white"
    if finish.walls_of in ("boards", "logs") and "wood" in avoid:
        update |= {"walls_of": "plaster", "walls": allowed_color("white", avoid)}
    accent = finish.accent
    if accent is not None and not any(brief.finish_of(part) for part in ("accent", "lower", "panels")):
        wooden = accent.kind == "panelling" and "wood" in avoid
        if wooden or not is_allowed(accent.color, avoid):
            update["accent"] = None
    if finish.tiles is not None and not is_allowed(finish.tiles.color, avoid):
        tiles = finish.tiles.model_copy(update={"color": allowed_color(finish.tiles.color, avoid)})
        update["tiles"] = tiles
    if brief.finish_of("floor") is None:
        floor, never = finish.floor, avoid | ({"carpet"} if carpet else set())
        if FAMILY_OF[floor.material] in never or floor.material in never:
            other = next(of for of in FLOORS if FAMILY_OF[of] not in never)
            floor = floor.model_copy(update={"material": other, "tone": None if other != "tile" else "light grey"})
        if floor.tone is not None and not is_allowed(floor.tone, avoid):
            wood = _wood(avoid) if floor.material == "wood" else None
            floor = floor.model_copy(update={"tone": wood or allowed_color("light grey", avoid)})
        update["floor"] = floor
    if finish.ceiling is not None and brief.finish_of("ceiling") is None:
        above = finish.ceiling
        if not is_allowed(above.color, avoid) or (above.material in ("boards", "logs") and "wood" in avoid):
            above = above.model_copy(update={"material": "plaster", "color": allowed_color("white", avoid)})
        if above.beams is not None and ("wood" in avoid or not is_allowed(above.beams, avoid)):
            above = above.model_copy(update={"beams": None})
        update["ceiling"] = above
    if finish.trim is not None and ("wood" in avoid or not is_allowed(finish.trim, avoid)):
        update["trim"] = None if "white" not in avoid else allowed_color("light grey", avoid)
    return finish.model_copy(update=update)


def _wood(avoid: Collection[str]) -> str | None:
    return next((name for name, one in finishes().items() if one.family == "wood" and not is_avoided(one, avoid)), None)


def _no_carpet(brief: SceneGraph) -> bool:
    """Whether the request wants no carpet, on the floor or as one."""
    words = data_of("stated_finishes.yaml")["floors"]["carpet"]["words"]
    return any(one.relation is None and one.words.removesuffix("s") in words for one in brief.exclusions)


__all__ = ["avoided", "cleaned", "of_room", "styles_unwanted"]
