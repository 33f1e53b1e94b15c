"""A scene, and what is measured in it, as JSON for prompts: equal scenes give equal text, free of clocks and paths.

Whatever comes from files or requests stands in JSON strings, cut to a length: it is data, as the prompt "scene" says.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.critic import Review
from sceneweaver.io import packaged
from sceneweaver.io.messages import shorten
from sceneweaver.scene import Door, Relation, Scene, SceneObject, Window
from sceneweaver.verify import Report

MOST = 200
"""Objects that are listed one by one, unless told otherwise; the others are counted."""

MOST_FACTS = 40
"""Violations, and faults of a critic, that are listed."""

DESCRIPTION, NAME, SENTENCE = 80, 120, 240
"""Longest text [characters] of a description, of an id or category, and of a sentence."""

_COUNTS = ("requested", "placed", "dropped", "collisions", "out_of_bounds", "unsupported")
_BLOCKED = ("blocked_zones", "blocked_openings")
_SHARES = ("walkable_share", "reachable_share", "openable_share")


def prompt(name: str) -> str:
    """A text of ``prompts/``; that of "scene" says what `scene_text` and `facts_text` mean."""
    return packaged.text(__package__ or "", "prompts", f"{name}.md").strip()


def scene_text(scene: Scene, *, most: int = MOST) -> str:
    """The scene as JSON, one object or relation a line.

    Args:
        scene: any scene.
        most: objects that are listed; of more the little wanted, those on supports and the small ones are counted by
            category instead, under what they stand on.
    """
    listed = _listed(scene, most)
    names = {o.id for o in listed} | {o.id for o in scene.room.openings}
    counted = _counted(scene, names)
    told = [r for r in scene.relations if _named(r) <= names][: 4 * most]
    rows = {
        "room": compact(_room(scene)),
        "objects": _lines(_object(o, counted.pop(o.id, None)) for o in listed),
        "not_listed": compact(counted.pop("", {})),
        "relations": _lines(map(_relation, told)),
        "relations_not_listed": compact(len(scene.relations) - len(told)),
    }
    idle = {"not_listed": "{}", "relations_not_listed": "0"}
    return "{" + ",\n".join(f'"{key}":{text}' for key, text in rows.items() if idle.get(key) != text) + "}"


def facts_text(report: Report, review: Review) -> str:
    """What the judge measured and the symbolic critic found, as JSON; the gravest first, at most `MOST_FACTS` each."""
    critic: dict[str, Any] = {"grades": {name: round(value, 1) for name, value in review.grades.items()}}
    critic["faults"] = [
        {
            "criterion": fault.criterion,
            "kind": fault.kind,
            "objects": _names(fault.objects),
            "reason": shorten(fault.reason, SENTENCE),
            **({"suggestion": shorten(fault.suggestion, SENTENCE)} if fault.suggestion else {}),
            **({"tool": fault.tool} if fault.tool else {}),
            "points": round(fault.points, 2),
        }
        for fault in review.faults[:MOST_FACTS]
    ]
    if len(review.faults) > MOST_FACTS:
        critic["not_listed"] = len(review.faults) - MOST_FACTS
    return compact({"judge": judge_facts(report), "critic": critic})


def judge_facts(report: Report) -> dict[str, Any]:
    """What the judge measured, as plain data; hard violations first, at most `MOST_FACTS`."""
    hard = sorted(report.violations, key=lambda v: not v.hard)
    judge: dict[str, Any] = {"valid": report.valid}
    judge |= {k: getattr(report, k) for k in (*_COUNTS, *_BLOCKED) if getattr(report, k)}
    judge |= {k: round(getattr(report, k), 3) for k in _SHARES if getattr(report, k) is not None}
    for kind, tally in (("hard", report.relations.hard), ("soft", report.relations.soft)):
        judge[f"{kind}_relations"] = f"{tally.satisfied} of {tally.total} hold"
    judge["violations"] = [
        {"kind": v.kind, "objects": _names(v.objects), "detail": shorten(v.detail, SENTENCE), "hard": v.hard}
        for v in hard[:MOST_FACTS]
    ]
    if len(hard) > MOST_FACTS:
        judge["not_listed"] = len(hard) - MOST_FACTS
    return judge


def compact(data: object) -> str:
    """JSON without spaces, in letters as they are."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def rounded(value: float, digits: int = 2) -> float | int:
    """A number for a prompt: whole ones without a point, and never -0."""
    found = round(float(value), digits) + 0.0
    return int(found) if found == int(found) else found


def degrees(yaw: float) -> float | int:
    """A turn in whole tenths of a degree, in (-180, 180]."""
    found = rounded(math.degrees(yaw), 1)
    return 180 if found == -180 else found


def _listed(scene: Scene, most: int) -> list[SceneObject]:
    """The objects that are told one by one, in their order: what stands in the room before what lies on supports."""

    def order(at: int) -> tuple[bool, bool, int, float, int]:
        obj = scene.objects[at]
        asked = obj.intent.priority == "asked"
        return not asked, obj.mount == "surface", -obj.intent.rank, -math.prod(obj.size), at

    kept = sorted(range(len(scene.objects)), key=order)[:most]
    return [scene.objects[at] for at in sorted(kept)]


def _counted(scene: Scene, listed: set[str]) -> dict[str, dict[str, int]]:
    """How many of each category are not listed, by the listed object that carries them; "" for the others."""
    carriers = {o.id: o.support.object if o.support else "" for o in scene.objects}
    found: dict[str, Counter[str]] = {}
    for obj in scene.objects:
        if obj.id not in listed:
            carrier, seen = carriers[obj.id], {obj.id}
            while carrier and carrier not in listed and carrier not in seen:
                seen.add(carrier)
                carrier = carriers.get(carrier, "")
            found.setdefault(carrier if carrier in listed else "", Counter())[shorten(obj.category, NAME)] += 1
    return {carrier: dict(sorted(counts.items())) for carrier, counts in found.items()}


def _room(scene: Scene) -> dict[str, Any]:
    room = scene.room
    return {
        "type": shorten(room.type, NAME),
        "outline": [[rounded(x), rounded(y)] for x, y in room.outline],
        "height": rounded(room.height),
        "doors": [{**_opening(scene, o), "height": rounded(o.height), "swing": o.swing} for o in room.doors],
        "windows": [{**_opening(scene, o), "sill": rounded(o.sill), "height": rounded(o.height)} for o in room.windows],
    }


def _opening(scene: Scene, opening: Door | Window) -> dict[str, Any]:
    wall = scene.room.walls[opening.wall]
    ends = [
        [rounded(s + (e - s) * along / wall.length) for s, e in zip(wall.start, wall.end, strict=True)]
        for along in (opening.offset, opening.offset + opening.width)
    ]
    return {"id": shorten(opening.id, NAME), "wall": f"wall:{opening.wall}", "from": ends[0], "to": ends[1]}


def _object(obj: SceneObject, carried: Mapping[str, int] | None) -> dict[str, Any]:
    data: dict[str, Any] = {"id": shorten(obj.id, NAME), "category": shorten(obj.category, NAME)}
    if obj.description:
        data["description"] = shorten(obj.description, DESCRIPTION)
    data["position"] = [rounded(v) for v in obj.pose.position]
    data["yaw"] = degrees(obj.pose.yaw)
    data["size"] = [rounded(v) for v in obj.size]
    data["mount"] = obj.mount
    if obj.support:
        data["support"] = shorten(obj.support.object, NAME)
        data["surface"] = shorten(obj.support.surface, NAME)
    if obj.intent.priority == "asked":
        data["asked"] = True
    if obj.fixed:
        data["fixed"] = True
    if carried:
        data["also_carries"] = dict(carried)
    return data


def _relation(relation: Relation) -> dict[str, Any]:
    data: dict[str, Any] = {"type": relation.type, "subject": shorten(relation.subject, NAME)}
    if relation.targets:
        targets = _names(relation.targets)
        data["target"] = targets[0] if isinstance(relation.target, str) else targets
    if relation.params:
        data["params"] = {name: _short(value) for name, value in relation.params.items()}
    return {**data, "hard": relation.hard}


def _short(value: Any) -> Any:
    """A param of a relation, its numbers rounded."""
    if isinstance(value, list | tuple):
        return [_short(item) for item in value]
    return rounded(value, 3) if isinstance(value, float) else value


def _named(relation: Relation) -> set[str]:
    """The ids that a relation names, walls aside."""
    return {relation.subject, *(t for t in relation.targets if not t.startswith("wall:"))}


def _names(ids: Iterable[str]) -> list[str]:
    return [shorten(name, NAME) for name in ids]


def _lines(rows: Iterable[Mapping[str, Any]]) -> str:
    text = ",\n".join(map(compact, rows))
    return f"[\n{text}\n]" if text else "[]"
