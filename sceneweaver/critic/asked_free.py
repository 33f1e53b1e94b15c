"""What became of the floor that a request wants free: measured from where things stand, whoever placed them."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

from sceneweaver.language.free_floor import scene_area
from sceneweaver.language.model import PLACES, FreeArea
from sceneweaver.language.vocabulary import words
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.free_floor import SLACK, measure
from sceneweaver.verify.solids import Body

from .places import segments
from .survey import Survey
from .verdict import Asked, met, not_understood, partly, text_of, unmet


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each free area that the request states.

    A rectangle or circle that the scene keeps free is measured at its place; one that it does not keep, or that is not
    free there, anywhere in the room where the request names no place.
    """
    scene = survey.scene
    kept = {area.request: area for area in scene.free_areas if area.request is not None}
    for asked in survey.brief.free_areas:
        area = scene_area(asked, survey.ids_of, scene.room)
        if area is None:
            yield not_understood("free_area", asked.id, (), f"'{asked.words}' names nothing that is there")
            continue
        placed = kept.get(asked.id)
        found = measure(survey.placed, placed if placed is not None else area, anywhere=placed is None)
        if not found.holds and placed is not None and not area.targets and area.kind in ("rectangle", "circle"):
            found = measure(survey.placed, area, anywhere=True)
        objects = tuple(name for name in (*area.targets, *area.others) if name in survey.placed.by_id)
        m = found.measurement
        if m is None:
            yield not_understood("free_area", asked.id, objects, f"'{asked.words}' was not measured")
        elif found.holds and (short := _short_of(survey, asked, m.value)):
            yield partly("free_area", asked.id, objects, f"{text_of(m)}; {short}", m)
        elif found.holds:
            yield met("free_area", asked.id, objects, f"{text_of(m)}", m)
        else:
            wrong = tuple(name for name in found.objects if name in survey.placed.by_id)
            by = f" because of {', '.join(wrong[:4])}" if wrong else ""
            yield unmet(
                "free_area",
                asked.id,
                objects,
                f"{text_of(m)}{by}",
                m,
                fault="asked_free_floor",
                wrong=wrong or objects,
                share=m.excess / max(m.low, 1e-6),
                suggestion=f"keep free: {asked.words}",
            )


def _short_of(survey: Survey, asked: FreeArea, width: float) -> str:
    """What of an area that is free is not as it was asked for, in words; empty where all is."""
    for name in asked.targets:
        if name.partition(":")[0] not in PLACES and not survey.ids_of(name):
            return f"'{name}' of '{asked.words}' is not there"
    limits = fault_kind("asked_free_floor").limits
    if asked.kind == "path" and (thing := _in_line(survey, asked)):
        return f"{thing} stands in the straight way"
    if asked.most is not None and width > asked.most + limits["wider"]:
        return f"at most {asked.most:.2f} m were asked for"
    if asked.kind == "gap" and len(asked.targets) == 2 and not _face(survey, *asked.targets):
        return "they are not across from each other"
    return ""


def _in_line(survey: Survey, asked: FreeArea) -> str:
    """What stands in the straight way between the two ends of a path that is told to be one; empty where nothing does,
    or one of several ways is free."""
    import shapely

    told = set(words("bearing_words")["straight"].split())
    if len(asked.targets) != 2 or told.isdisjoint(asked.words.lower().split()):
        return ""
    ends = [_shapes(survey, name) for name in asked.targets]
    own = {name for target in asked.targets for name in survey.ids_of(target)}
    found, touch = "", fault_kind("asked_free_floor").limits["touch"]
    for a, b in itertools.product(*ends):
        if shapely.intersects(a, b):
            return ""
        line = shapely.LineString([shapely.centroid(a), shapely.centroid(b)])
        lane = line.difference(a.buffer(touch) | b.buffer(touch)).buffer(asked.size[0] / 2 - SLACK, cap_style="flat")
        things = [o for o in survey.reaching(lane) if o in survey.standing and o.id not in own]
        taken = [o.id for o, share in zip(things, survey.taken(lane, things), strict=True) if share > 0.0]
        if not taken:
            return ""
        found = found or taken[0]
    return found


def _shapes(survey: Survey, name: str) -> list[Any]:
    """What is at an end of a path, in plan."""
    if survey.brief.entity(name) is not None:
        return [survey.footprint(b) for one in survey.ids_of(name) for b in survey.bodies if b.id == one]
    return [segment.line for segment in segments(survey, name)]


def _face(survey: Survey, one: str, other: str) -> bool:
    """Whether some of the things on both sides of a gap are beside each other over a part of their width."""
    pairs = [(a, b) for a in survey.standing_for(one) for b in survey.standing_for(other) if a is not b]
    return not pairs or any(_abreast(a, b) and _abreast(b, a) for a, b in pairs)


def _abreast(a: Body, b: Body) -> bool:
    """Whether one is, for the larger part, between the lines of two opposite sides of the other."""
    ahead, aside = a.local((b.centre[0], b.centre[1]))
    half = min(b.size[:2]) / 2
    return abs(ahead) <= a.size[0] / 2 + half or abs(aside) <= a.size[1] / 2 + half
