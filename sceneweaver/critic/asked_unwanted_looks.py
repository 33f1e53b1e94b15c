"""Whether looks that the request does not want are seen: on the bodies as they are drawn, and on the room itself."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from sceneweaver.assets import Library
from sceneweaver.assets.body import Material
from sceneweaver.assets.materials import color_name, color_named, finishes
from sceneweaver.assets.placed import plain_material
from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.room_looks import room_looks
from sceneweaver.language import Exclusion
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import InputError
from sceneweaver.verify.solids import Body

from .grade import Call
from .survey import Survey
from .verdict import Asked, counted, met, unmet

LIMITS = fault_kind("unwanted_look").limits
"""Least share of a body's surface that counts, and how many are named."""

FLOOR_FAMILIES = {"wood": "wood", "tile": "ceramic", "stone": "stone", "concrete": "stone", "carpet": "fabric"}
"""What a floor is of."""

WALL_FAMILIES = {"boards": "wood", "logs": "wood", "metal": "metal", "tiles": "ceramic", "stone": "stone"}
"""What walls and ceilings are of, beside paint."""


def unwanted_look(survey: Survey, excluded: Exclusion, item: str) -> Asked:
    """What became of looks that are not wanted."""
    there = [(body, seen) for body in _meant(survey, excluded) if (seen := _seen(survey, excluded, body))]
    surfaces = [] if excluded.within else list(_surfaces(survey, excluded))
    ids = [body.id for body, _ in there]
    number = counted("number", len(ids) + len(surfaces), 0, 0)
    if not ids and not surfaces:
        return met("exclusion", item, (), f"'{excluded.words}': nothing of it is seen", number)
    shown = [f"{body.id} ({seen})" for body, seen in there[: int(LIMITS["shown"])]]
    small = [body.id for body, _ in there if body.item.mount == "surface" and body.id not in survey.program.asked_of]
    call: Call | None = ("remove_objects", {"ids": small}) if small else None
    return unmet(
        "exclusion",
        item,
        ids,
        f"'{excluded.words}': {', '.join((*surfaces, *shown))}",
        number,
        fault="unwanted_look",
        suggestion="give these another finish",
        call=call,
    )


def _meant(survey: Survey, excluded: Exclusion) -> Iterator[Body]:
    """The bodies that it is said of: none of which the request itself names this look."""
    for body in survey.bodies:
        names = {body.item.category, *groups_above(body.item.category)}
        if excluded.within and not names & {*excluded.within}:
            continue
        yield body


def _seen(survey: Survey, excluded: Exclusion, body: Body) -> str:
    """What of it is seen of a body; "" where nothing is, or where the request itself wants that."""
    asked = survey.brief.entity(survey.program.asked_of.get(body.id, ""))
    if asked is not None and (asked.color or asked.material) and not excluded.within:
        return ""
    if asked is None and str(body.item.attributes.get("style")) in excluded.styles:
        return str(body.item.attributes["style"])
    for share, material in _surface(body):
        if share < LIMITS["share"]:
            continue
        color = color_name(material.color)
        if color in excluded.colors:
            return color
        if asked is None or excluded.within:
            family = finishes()[material.name].family if material.name in finishes() else material.kind
            if {material.name, material.kind, family} & {*excluded.materials}:
                return material.name
    return ""


def _surface(body: Body) -> list[tuple[float, Material]]:
    """The materials of a body with the share of its surface that each has."""
    if body.item.asset is None:
        return [(1.0, plain_material(body.item))]
    return _shares(body.item.asset) or [(1.0, plain_material(body.item))]


@lru_cache(maxsize=2048)
def _shares(asset_id: str) -> list[tuple[float, Material]]:
    """Of an asset; empty where it cannot be read."""
    try:
        mesh = _library().load(asset_id).mesh
    except (InputError, OSError, ValueError, KeyError):
        return []
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    by_material = np.bincount(mesh.face_material, weights=areas, minlength=len(mesh.materials))
    whole = max(float(by_material.sum()), 1e-12)
    by_look: dict[str, float] = {}
    for share, material in zip(by_material / whole, mesh.materials, strict=True):
        by_look[color_name(material.color)] = by_look.get(color_name(material.color), 0.0) + float(share)
    return [(by_look[color_name(material.color)], material) for material in mesh.materials]


@lru_cache(maxsize=1)
def _library() -> Library:
    return Library()


def _surfaces(survey: Survey, excluded: Exclusion) -> Iterator[str]:
    """The parts of the room in such a look that the request does not name itself."""
    room, finish, said = survey.scene.room, survey.scene.room.finish, survey.brief.finish_of
    if finish is None:
        return
    looks = room_looks(room)
    parts: list[tuple[str, str, str | None, Material | None, str]] = [
        ("walls", "walls", finish.walls, looks.wall, WALL_FAMILIES.get(finish.walls_of, "paint")),
        ("floor", "floor", finish.floor.tone, looks.floor, FLOOR_FAMILIES[finish.floor.material]),
    ]
    if finish.accent is not None:
        wooden = "wood" if finish.accent.kind == "panelling" else "paint"
        parts.append(("accent wall", "accent", finish.accent.color, looks.accent, wooden))
    if finish.tiles is not None:
        parts.append(("wall tiles", "lower", finish.tiles.color, looks.tiles, "ceramic"))
    if finish.ceiling is not None:
        of = WALL_FAMILIES.get(finish.ceiling.material, "paint")
        parts.append(("ceiling", "ceiling", finish.ceiling.color, looks.ceiling, of))
    for name, part, color, look, family in parts:
        if said(part) is not None or look is None:
            continue
        named = _basic(color)
        if named in excluded.colors or (color is None and color_name(look.color) in excluded.colors):
            yield f"{name} ({color or color_name(look.color)})"
        elif {family, color} & {*excluded.materials}:
            yield f"{name} ({family})"


def _basic(color: str | None) -> str | None:
    """The basic colour of a colour's name, or of a finish; None for what has none."""
    if color is None:
        return None
    if color in finishes() and finishes()[color].family == "wood":
        return color_name(finishes()[color].material.color)
    try:
        return color_named(color)
    except InputError:
        return None


__all__ = ["unwanted_look"]
