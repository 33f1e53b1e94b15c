"""What became of the things that a request names, and of what it does not want."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sceneweaver.assets import resolve
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import members
from sceneweaver.knowledge.kin import interchangeable, is_one, is_several
from sceneweaver.language import Entity, Exclusion
from sceneweaver.language.coverage import idle_words
from sceneweaver.language.statements.counts import VAGUE
from sceneweaver.language.unwanted import belongs_there, kinds_unwanted
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.solids import Body

from . import asked_attributes, kinds
from .asked_calls import adding
from .asked_relations import holding
from .asked_unwanted_looks import unwanted_look
from .asked_words import of_its_own
from .survey import FLAT, Survey
from .verdict import Asked, counted, met, not_understood, partly, substituted, unmet

MANY = 10**6

EXTENTS = {"depth": 1, "width": 1, "height": 1, "length": 1, "top": 1, "seat": 1, "knee": 1, "diameter": 2, "side": 2}
"""How many of its three extents a length that is stated of a thing gives, at most."""


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each entity with its attributes, then each exclusion."""
    for asked in survey.brief.entities:
        bodies = survey.standing_for(asked.id)
        lengths = sum(EXTENTS.get(m.quantity, 0) for m in survey.brief.measures if m.entity == asked.id)
        like = list(asked_attributes.outcomes(asked, bodies, lengths, survey.scene.room.windows))
        yield _whole(survey, asked, _entity(survey, asked, bodies), like)
        yield from like
    yield from _exclusions(survey)
    if survey.brief.only and survey.brief.entities:
        yield _only(survey)


def _whole(survey: Survey, asked: Entity, thing: Asked, like: Sequence[Asked]) -> Asked:
    """A thing that is there, of which not all that was said of it was read and can be seen, is so in part."""
    words = {a.id: (a.words or a.value).lower().split() for a in asked.attributes}
    unseen = [
        item.outcome.reason
        for item in like
        if item.outcome.status == "not_understood" and not idle_words().issuperset(words.get(item.outcome.item, ["?"]))
    ]
    if thing.outcome.status == "met" and not unseen and (lost := _unread(survey, asked)):
        unseen = [f"'{lost}' of it was not understood"]
    if thing.outcome.status != "met" or not unseen:
        return thing
    reason = f"{thing.outcome.reason}; {unseen[0]}"
    return replace(thing, outcome=thing.outcome.model_copy(update={"status": "partly", "reason": reason}))


def _unread(survey: Survey, asked: Entity) -> str:
    """A word of its noun phrase that says nothing of what stands there: a "washing table" that is a table alone."""
    match = resolve(singular(asked.noun))
    if match.how == "head" and match.category == asked.category:
        own = {*asked.category.split("_"), *(word for a in asked.attributes for word in a.words.lower().split())}
        lost = next((word for word in match.modifiers if word not in own), "")
        if lost:
            return lost
    return of_its_own(survey.brief, asked)


def _entity(survey: Survey, asked: Entity, bodies: list[Body]) -> Asked:
    least, most = asked.count or (1, MANY)
    ids = [b.id for b in bodies]
    if len(bodies) < least:
        missing = least - len(bodies)
        return unmet(
            "entity",
            asked.id,
            ids,
            f"{len(bodies)} of {least} '{asked.noun}' that were asked for",
            counted("number", len(bodies), least, most if most < MANY else float("inf")),
            fault="missing_asked",
            share=missing / least,
            suggestion=f"add {missing} {kinds.words(asked.category)}",
            grave=len(bodies) < fault_kind("missing_asked").limits["grave"] * least,
            call=adding(survey, asked, missing),
        )
    spare = [b.id for b in (*bodies[most:], *_beside(survey, asked, bodies))] if asked.count is not None else []
    have = counted(
        "objects", len(bodies) + len(spare) - len(bodies[most:]), least, most if most < MANY else float("inf")
    )
    if spare:
        return unmet(
            "entity",
            asked.id,
            [*ids, *(s for s in spare if s not in ids)],
            f"{most + len(spare)} '{asked.noun}', {most} were asked for",
            have,
            fault="too_many",
            wrong=spare,
            share=len(spare) / max(1, most),
            suggestion=f"remove {', '.join(spare)}",
            call=("remove_objects", {"ids": spare}),
        )
    made = f"'{asked.noun}': {', '.join(ids[:6])}"
    other = next((b for b in bodies if not is_one(b.item.category, asked.category, asked.noun)), None)
    if asked.unnamed or asked.generic or other is not None:
        name = kinds.words(asked.category if other is None else other.item.category)
        made = f"a {name} stands for '{asked.noun}'"
        return substituted("entity", asked.id, ids, made, have)
    if asked.count not in (None, VAGUE) and any(is_several(b.item.category, singular(asked.noun)) for b in bodies):
        return partly("entity", asked.id, ids, f"{made}, each of which is several", have)
    return met("entity", asked.id, ids, made, have, assumed=asked.implied)


def _beside(survey: Survey, asked: Entity, bodies: list[Body]) -> list[Body]:
    """More of what was asked for, or of what takes its role, that stands for nothing else in the request."""
    if len(bodies) < (asked.count or (1, 1))[1]:
        return []
    names = {*interchangeable(asked.category), *members(asked.category)}
    return [b for b in survey.bodies if b.item.category in names and b.id not in survey.program.asked_of]


def _exclusions(survey: Survey) -> Iterator[Asked]:
    for k, excluded in enumerate(survey.brief.exclusions):
        item = excluded.id or f"exclusion-{k}"
        if excluded.relation is not None:
            yield _elsewhere(survey, excluded, item)
            continue
        if excluded.colors or excluded.styles or excluded.within:
            yield unwanted_look(survey, excluded, item)
            continue
        there = [b.id for b in survey.bodies if _is_unwanted(survey, excluded, b)]
        if not there:
            nothing = kinds.words(excluded.words)
            said = nothing if nothing.startswith("nothing") else f"no {nothing}"
            yield met("exclusion", item, (), said, counted("number", 0, 0, 0))
            continue
        yield unmet(
            "exclusion",
            item,
            there,
            f"{', '.join(there[:4])}: not wanted in this room",
            counted("number", len(there), 0, 0),
            fault="unwanted",
            suggestion=f"remove {', '.join(there)}",
            grave=True,
            call=("remove_objects", {"ids": there}),
        )


def _is_unwanted(survey: Survey, excluded: Exclusion, body: Body) -> bool:
    """Whether a body is what an exclusion rules out: of its categories, or by material and place unless asked for."""
    named = (*excluded.categories, *kinds_unwanted(excluded.words))
    if excluded.others and body.id in survey.program.asked_of:
        return False
    if any(body.item.category in (word, *members(word)) for word in named):
        return True
    if body.id in survey.program.asked_of:
        return False
    if excluded.mount and body.item.mount == excluded.mount:
        return body.item.category not in belongs_there(excluded.mount)
    material = str(body.item.attributes.get("material", ""))
    return any(name == material or name in material.split() for name in excluded.materials)


def _elsewhere(survey: Survey, excluded: Exclusion, item: str) -> Asked:
    """What must not be in one place, wherever else it is."""
    there = holding(survey, excluded)
    if there is None:
        return not_understood("exclusion", item, (), f"'{excluded.words}' is nothing that can be measured here")
    ids = [b.id for b in there]
    if not there:
        return met("exclusion", item, (), f"{excluded.words}: as asked", counted("number", 0, 0, 0))
    wanted = bool(excluded.subject)
    remedy = "put {} elsewhere" if wanted else "remove {}"
    return unmet(
        "exclusion",
        item,
        ids,
        f"'{excluded.words}' was asked for: {', '.join(ids[:4])}",
        counted("number", len(ids), 0, 0),
        fault="asked_relation" if wanted else "unwanted",
        wrong=ids,
        suggestion=remedy.format(", ".join(ids)),
        grave=not wanted,
        call=None if wanted else ("remove_objects", {"ids": ids}),
    )


def _only(survey: Survey) -> Asked:
    """Nothing but what is named: what lies flat or stands on other things aside."""
    asked_of = survey.program.asked_of
    extra = [b.id for b in survey.bodies if b.id not in asked_of and b.item.mount != "surface" and b.size[2] > FLAT]
    number = counted("number", len(extra), 0, 0)
    if not extra:
        return met("room", "room.only", (), "nothing but what was asked for", number)
    return unmet(
        "room",
        "room.only",
        extra,
        f"{len(extra)} pieces of furniture beside what was asked for alone",
        number,
        fault="not_only",
        share=len(extra) / fault_kind("not_only").limits["pieces"],
        suggestion=f"remove {', '.join(extra)}",
        call=("remove_objects", {"ids": extra}),
    )
