"""Whether a scene is what was asked for: its objects and what they are like, the room, and nothing unwanted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.materials import color_named, palette
from sceneweaver.assets.taxonomy import likeliness, members
from sceneweaver.brief import Entity
from sceneweaver.geometry.angles import cross
from sceneweaver.knowledge.surfaces import lays, usual_arrangement
from sceneweaver.scene import InputError
from sceneweaver.verify.solids import Body

from . import kinds
from .asked_relations import faults as relation_faults
from .grade import Finding, finding
from .survey import FLAT, Survey

GRADE_CAP = 5.0
"""Highest grade when something that was asked for is missing, or something unwanted is there."""

AREA_SLACK = 0.12
"""Share by which a floor may differ from what was asked."""

SIZE_SLACK = 0.15
"""Share by which a size may differ from what was asked."""

PER_PERSON = 0.7
"""Share of the room type's floor a person that is enough."""


WORDS = {
    "wooden": "wood",
    "timber": "wood",
    "metallic": "metal",
    "steel": "metal",
    "iron": "metal",
    "cloth": "fabric",
    "upholstered": "fabric",
    "textile": "fabric",
}
"""Words for materials that mean a whole family of them."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Differences between the request and the scene."""
    yield from _objects(survey)
    yield from relation_faults(survey)
    yield from _unwanted(survey)
    yield from _room(survey)
    yield from _style(survey)


def mine(survey: Survey, asked: Entity) -> list[Body]:
    """The objects that stand for something asked."""
    return [b for b in survey.bodies if survey.program.asked_of.get(b.id) == asked.id]


def _objects(survey: Survey) -> Iterator[Finding]:
    for asked in survey.brief.entities:
        bodies = mine(survey, asked)
        least, most = asked.count or (1, 10**6)
        name = kinds.words(asked.category)
        if len(bodies) < least:
            missing = least - len(bodies)
            call: dict[str, Any] = {"category": asked.category, "count": missing}
            call.update({k: v for k in ("color", "material", "style") if (v := getattr(asked, k)) is not None})
            inputs: dict[str, Any] = {"objects": [call]}
            # a table is laid with more than was asked for
            table = None if survey.brief.only else _table_for(survey, asked.category, missing)
            if table is not None:
                inputs["supports"] = [table]
            yield finding(
                "alignment",
                "missing_asked",
                (b.id for b in bodies),
                f"{len(bodies)} of {least} '{asked.noun}' that were asked for",
                f"add {missing} {name}",
                points=1.0 + 2.5 * missing / least,
                cap=GRADE_CAP if len(bodies) * 2 < least else None,
                tool="add_objects" if table is None else "add_tabletop",
                inputs=inputs,
            )
        spare = [b.id for b in (*bodies[most:], *_beside(survey, asked))] if asked.count is not None else []
        if spare:
            yield finding(
                "alignment",
                "too_many",
                spare,
                f"{most + len(spare)} '{asked.noun}', {most} were asked for",
                f"remove {', '.join(spare)}",
                points=0.6 + 1.4 * min(1.0, len(spare) / max(1, most)),
                tool="remove_objects",
                inputs={"ids": spare},
            )
        yield from _attributes(asked, bodies)
        yield from _sizes(asked, bodies)


def _table_for(survey: Survey, category: str, count: int) -> str | None:
    """A bare table whose arrangement has a place for so many of a category, the likeliest: a desk for a screen."""
    found: list[tuple[int, str]] = []
    for body in survey.bodies:
        rank = likeliness(category, body.item.category)
        name = survey.program.item_of.get(body.id)
        item = survey.room_type.item(name) if name else None
        plan = usual_arrangement(item.top if item is not None else None, body.item.category)
        if rank is not None and not survey.carried.get(body.id) and lays(plan, category, count):
            found.append((rank, body.id))
    return min(found)[1] if found else None


def _beside(survey: Survey, asked: Entity) -> list[Body]:
    """More of what was asked for, that stands for nothing else in the request."""
    names = {asked.category, *members(asked.category)}
    if len(mine(survey, asked)) < (asked.count or (1, 1))[1]:
        return []
    return [b for b in survey.bodies if b.item.category in names and b.id not in survey.program.asked_of]


def _attributes(asked: Entity, bodies: Sequence[Body]) -> Iterator[Finding]:
    for key, points in (("color", 1.0), ("material", 0.8), ("style", 0.4)):
        want = getattr(asked, key)
        if want is None or not bodies:
            continue
        wrong = [b for b in bodies if key in b.item.attributes and not _alike(b, key, want)]
        if wrong:
            is_ = wrong[0].item.attributes.get(key)
            ids = [b.id for b in wrong]
            yield finding(
                "alignment",
                f"wrong_{key}",
                ids,
                f"{ids[0]} is {is_}, '{want}' was asked for",
                f"replace {', '.join(ids)} by {want} {kinds.words(asked.category)}",
                points=points,
            )


def _alike(body: Body, key: str, want: str) -> bool:
    """Whether an attribute says what was asked, in its own words or by the name of a shade or a family."""
    given = str(body.item.attributes.get(key, "")).lower()
    if key == "color":
        wanted, given = _color(want), _color(given)
        return wanted == given or wanted in given.split() or given in wanted.split()
    if want.lower() in given.split():
        return True
    wanted = WORDS.get(want.lower(), want.lower())
    if key == "material":
        finish = palette().get(str(body.item.attributes.get("material", "")))
        if finish is not None and wanted in (finish.family, WORDS.get(finish.family)):
            return True
    return wanted == given or wanted in given.split() or (" " in wanted and wanted in given)


def _color(words: str) -> str:
    """The basic colour of some words, the words themselves where they name none."""
    try:
        return color_named(words)
    except InputError:
        return " ".join(words.lower().split())


def _sizes(asked: Entity, bodies: Sequence[Body]) -> Iterator[Finding]:
    row = categories().get(asked.category)
    for body in bodies:
        target = list(body.size)
        for k in range(3):
            want = asked.size[k]
            if want is not None:
                target[k] = want
        off = max(abs(a - b) / b for a, b in zip(body.size, target, strict=True))
        if off > SIZE_SLACK:
            yield finding(
                "alignment",
                "wrong_asked_size",
                (body.id,),
                f"{body.id} measures {_show(body.size)} m, {_show(target)} m was asked for",
                f"resize {body.id}",
                points=0.8,
                tool="update_size",
                inputs={"sizes": {body.id: target}},
            )
        elif asked.scale != 1.0 and row is not None and row.size is not None and asked.size == (None, None, None):
            usual = math.prod((low + high) / 2 for low, high in row.size.ranges[:2])
            ratio = body.size[0] * body.size[1] / usual
            if (asked.scale > 1.0 and ratio < 1.0) or (asked.scale < 1.0 and ratio > 1.0):
                factor = math.sqrt(asked.scale / ratio)
                size = [round(s * (factor if k < 2 else 1.0), 3) for k, s in enumerate(body.size)]
                yield finding(
                    "alignment",
                    "wrong_asked_size",
                    (body.id,),
                    f"{body.id} covers {ratio:.2f} of the usual area; '{asked.noun}' was asked for "
                    f"{'large' if asked.scale > 1 else 'small'}",
                    f"resize {body.id}",
                    points=0.6,
                    tool="update_size",
                    inputs={"sizes": {body.id: size}},
                )


def _show(size: Sequence[float]) -> str:
    return " x ".join(f"{s:.2f}" for s in size)


def _unwanted(survey: Survey) -> Iterator[Finding]:
    banned = {name for word in survey.brief.without for name in (word, *members(word))}
    there = [b.id for b in survey.bodies if b.item.category in banned]
    if there:
        yield finding(
            "alignment",
            "unwanted",
            there,
            f"{', '.join(there[:4])}: not wanted in this room",
            f"remove {', '.join(there)}",
            points=3.0,
            cap=GRADE_CAP,
            tool="remove_objects",
            inputs={"ids": there},
        )
    if not survey.brief.only or not survey.brief.entities:
        return
    extra = [
        b.id
        for b in survey.bodies
        if b.id not in survey.program.asked_of and b.item.mount != "surface" and b.size[2] > FLAT
    ]
    if extra:
        yield finding(
            "alignment",
            "not_only",
            extra,
            f"{len(extra)} pieces of furniture beside what was asked for alone",
            f"remove {', '.join(extra)}",
            points=min(4.0, 0.8 * len(extra)),
            tool="remove_objects",
            inputs={"ids": extra},
        )


# ---- the room --------------------------------------------------------------------------------------------------------


def _room(survey: Survey) -> Iterator[Finding]:
    brief, room, area = survey.brief, survey.scene.room, survey.area
    if brief.room_type is not None and brief.room_type != survey.room_type.name:
        yield _shell("wrong_room", f"{kinds.a(survey.room_type.name)}; {kinds.a(brief.room_type)} was asked for", 3.0)
    want = brief.size[0] * brief.size[1] if brief.size is not None else brief.area
    if want is not None and abs(area - want) > AREA_SLACK * want:
        yield _shell("wrong_area", f"{area:.1f} m2 of floor, {want:.1f} m2 were asked for", 1.5)
    elif want is None and brief.scale != 1.0:
        usual = survey.room_type.area[1]
        if (brief.scale > 1.0 and area < usual) or (brief.scale < 1.0 and area > usual):
            word = "large" if brief.scale > 1.0 else "small"
            yield _shell("wrong_area", f"{area:.1f} m2 of floor for a {word} room; usual are {usual:.1f} m2", 1.0)
    if brief.people is not None and survey.room_type.area_per_person is not None:
        each = area / max(1, brief.people)
        if each < PER_PERSON * survey.room_type.area_per_person and want is None:
            yield _shell("too_small", f"{each:.1f} m2 a person for {brief.people} people", 1.0)
    if brief.shape is not None and brief.shape != (shape := shape_of(survey)):
        yield _shell("wrong_shape", f"the floor is {shape}-shaped, '{brief.shape}' was asked for", 1.5)
    if brief.height is not None and abs(room.height - brief.height) > 0.05:
        yield _shell(
            "wrong_height", f"the ceiling is {room.height:.2f} m high, {brief.height:.2f} m was asked for", 0.6
        )
    for name, asked, have in (("door", brief.doors, room.doors), ("window", brief.windows, room.windows)):
        if asked is not None and len(have) != asked:
            yield _shell(f"wrong_{name}s", f"{len(have)} {name}s, {asked} were asked for", 1.0)


def _shell(kind: str, reason: str, points: float) -> Finding:
    return finding("alignment", kind, (), reason, "start again with a room as asked", points=points)


def shape_of(survey: Survey) -> str:
    """The shape of the floor by its corners that turn inward and outward."""
    walls = survey.placed.walls
    sines = [cross(walls[wall.index - 1].along, wall.along) for wall in walls]
    turns = [sine for sine in sines if abs(sine) > 0.03]
    inward = sum(t < 0 for t in turns)
    if inward == 0:
        return "rectangle" if len(turns) == 4 else "round" if len(turns) >= 7 else "polygon"
    if inward == 1:
        return "L"
    if inward == 2:
        signs = [t < 0 for t in turns]
        between = [i for i, s in enumerate(signs) if s]
        gap = min(between[1] - between[0], len(signs) - between[1] + between[0])
        return "U" if gap == 1 else "T"
    return "polygon"


# ---- style -----------------------------------------------------------------------------------------------------------


def _style(survey: Survey) -> Iterator[Finding]:
    brief = survey.brief
    furniture = [b for b in survey.bodies if b.item.mount == "floor"]
    if brief.style is not None:
        told = [b for b in furniture if "style" in b.item.attributes]
        other = [b for b in told if b.item.attributes["style"] != brief.style]
        if told and len(other) > 0.5 * len(told):
            yield finding(
                "alignment",
                "wrong_style",
                (b.id for b in other[:8]),
                f"{len(told) - len(other)} of {len(told)} pieces are {brief.style}",
                f"choose {brief.style} furniture",
                points=1.2 * (len(other) / len(told)),
            )
    if brief.colors:
        told = [b for b in furniture if "color" in b.item.attributes]
        wanted = {c.lower().replace("gray", "grey") for c in brief.colors}
        if told and not any(str(b.item.attributes["color"]).lower() in wanted for b in told):
            yield finding(
                "alignment",
                "wrong_colors",
                (),
                f"nothing is {' or '.join(brief.colors)}",
                f"choose furniture in {' and '.join(brief.colors)}",
                points=0.8,
            )


__all__ = ["faults", "mine", "shape_of"]
