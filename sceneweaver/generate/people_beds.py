"""Beds for those who sleep in a room, and of what each has one the things of each."""

from __future__ import annotations

import math

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge.capacity import owned, sleeping_places
from sceneweaver.language import Entity
from sceneweaver.language.model import Capacity

from .people_draft import CHILDREN, PeopleDraft, is_vague

MOST = 12
"""People of whom each has things for their own, at most: pupils of a class share lockers."""

NARROW = 1.25
"""Width of what one person has for their own, in the least that such things have, where some are for several."""


def beds(draft: PeopleDraft, said: Capacity, target: Entity | None) -> None:
    """As many beds as so many people sleep in; those that the request counts stay as they are."""
    found = [target] if target is not None else [e for e in draft.entities if sleeping_places(e.category)]
    if found:
        if (
            len(found) == 1
            and is_vague(found[0])
            and found[0].noun.split()[-1] == "beds"
            and found[0].category == "bed"
        ):
            draft.change(found[0], category="single_bed", count=(said.people, said.people))  # each has their own
        elif len(found) == 1 and is_vague(found[0]):
            count = math.ceil(said.people / sleeping_places(found[0].category))
            draft.change(found[0], count=(count, count))
        return
    item = next((i for i in draft.room.items if any(map(sleeping_places, i.what))), None)
    if item is None:
        return
    children = bool(CHILDREN & set(draft.brief.for_whom))
    wide = sleeping_places(item.what[0]) > 1
    category = item.what[0]
    if wide and (children or said.people == 1 or said.people > 2):
        category = "single_bed"
    draft.add(category, math.ceil(said.people / max(1, sleeping_places(category))))


def one_each(draft: PeopleDraft) -> None:
    """Of what everybody has one for their own, such as desks, one for each where the request names several."""
    people = draft.brief.people
    if people is None or not 1 < people <= MOST:
        return
    for entity in draft.entities:
        if not is_vague(entity) or entity.category not in owned():
            continue
        draft.change(entity, count=(people, people))
        known = category_named(entity.category).size
        if known is not None and entity.size[1] is None and known.width[1] > 2 * known.width[0]:
            width = round(NARROW * known.width[0], 3)  # of lockers in a row one door, not three
            draft.change(draft.now(entity.id), size=(entity.size[0], width, entity.size[2]))
