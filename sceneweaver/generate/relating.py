"""From what a call says ("near the sofa", "at the left wall") to relations between objects that are there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.scene import CATALOGUE, InputError, Relation, SceneObject
from sceneweaver.scene.messages import suggest

from .draft import Draft
from .relations import wall_named

CEILING = 0.15
"""Height [m] that is left free above what hangs over something."""

WORDS = ("type", "to", "soft", "weight", "params")

Chosen = dict[str, str]
"""Which instance a word means for one subject, so that all its relations mean the same."""


def row_of(entry: str | Mapping[str, Any], where: str = "place") -> dict[str, Any]:
    """A relation as type, to, soft, weight and params; what is none of these is a parameter.

    Raises:
        InputError: for an unknown type of relation.
    """
    data: dict[str, Any] = {}
    if isinstance(entry, str):
        words = entry.split()
        data["soft"] = bool(words) and words[0] == "soft"
        words = words[data["soft"] :]
        data["type"] = words[0] if words else ""
        if len(words) > 1:
            data["to"] = " ".join(words[1:])
    else:
        data = {k: v for k, v in entry.items() if k in WORDS and v is not None}
        data["params"] = {**data.get("params", {}), **{k: v for k, v in entry.items() if k not in WORDS}}
    if data["type"] not in CATALOGUE:
        raise InputError(f"{where}.type is '{data['type']}'{suggest(data['type'], CATALOGUE)}")
    return {"to": None, "soft": False, "weight": 1.0, "params": {}, **data}


def relations_of(
    draft: Draft, rows: Iterable[Mapping[str, Any]], subject: SceneObject, count: int = 1
) -> tuple[list[Relation], list[str]]:
    """The relations of one subject, and what could not be said, each as a line.

    Args:
        draft: what is there; the subject is in it already.
        rows: as `row_of` gives them.
        subject: the object to place.
        count: how many equal ones are placed with it.
    """
    found: list[Relation] = []
    failed: list[str] = []
    chosen: Chosen = {}
    for row in rows:
        try:
            relation = _relation(draft, row, subject, count, chosen)
        except InputError as error:
            failed.append(f"{subject.id} {row['type']}: {error}")
            continue
        if relation is None:
            failed.append(
                f"{subject.id} {row['type']} {_words(row['to'])}: there is no such thing here".replace("  ", " ")
            )
            continue
        if any((r.type, r.target) == (relation.type, relation.target) for r in found):
            continue
        found.append(relation)
        if relation.type == "above" and subject.mount == "wall":  # at the wall behind it, not at the one opposite
            found.append(
                Relation(
                    type="near", subject=subject.id, target=relation.target, params={"max": 0.3}, hard=relation.hard
                )
            )
    return found, failed


def _relation(
    draft: Draft, row: Mapping[str, Any], subject: SceneObject, count: int, chosen: Chosen
) -> Relation | None:
    kind, room = CATALOGUE[row["type"]].target_kind, draft.room
    params, to = dict(row["params"]), row["to"]
    target: str | tuple[str, str] | None = None
    type = row["type"]
    if kind == "wall":
        target = _wall(draft, to)
    elif kind == "window":
        if not room.windows:
            return None
        target = _opening(draft, to, [w.id for w in room.windows], "window", subject)
        width = next(w.width for w in room.windows if w.id == target)
        if subject.mount == "wall" and "overlap" not in params:  # a curtain hangs before the middle of its window
            params["overlap"] = max(0.1, round(0.95 * min(1.0, width / subject.size[1]), 2))
    elif kind == "door":
        if not room.doors:
            return None
        if to is not None and to != "door":
            target = _opening(draft, to, [d.id for d in room.doors], "door", subject)
    elif kind == "objects":
        pair = _pair(draft, to, subject)
        if pair is None:
            return None
        target = pair
    elif kind == "object":
        target = instance(draft, to, subject, chosen)
        if target is None:
            return None
        other = draft.objects[target]
        if type == "above" and other.size[2] + subject.size[2] + CEILING > room.height:
            raise InputError(f"there is no height for it above {target}")
        if type == "around":
            tied = [r for r in draft.relations if r.type == "around" and r.target == target and r.subject != subject.id]
            if count < 2 or any(draft.objects[r.subject].category != subject.category for r in tied):
                type, params = "front_against", {}
            else:
                params.setdefault("n", count)
    return Relation(
        type=type, subject=subject.id, target=target, params=params, hard=not row["soft"], weight=row["weight"]
    )


def instance(draft: Draft, to: str | Iterable[str] | None, subject: SceneObject, chosen: Chosen) -> str | None:
    """The object that is meant: of the first word that names any, the one that fewest of this kind are tied to."""
    words = [to] if isinstance(to, str) else list(to or ())
    for word in words:
        if word in chosen:
            return chosen[word]
        pool = [id for id in draft.named(word) if id != subject.id]
        if not pool:
            continue
        kept = [id for id in pool if id in chosen.values()]
        best = kept[0] if kept else min(pool, key=lambda id: (draft.load(id, subject), pool.index(id)))
        chosen[word] = best
        return best
    return None


def _wall(draft: Draft, to: Any) -> str | None:
    """ "wall:k" of "wall:2", "wall:left" or "left wall"; None for any wall."""
    if to is None or to == "wall":
        return None
    name = str(to).removeprefix("wall:").removesuffix(" wall")
    return f"wall:{wall_named(name, draft.room)}"


def _opening(draft: Draft, to: Any, ids: list[str], noun: str, subject: SceneObject) -> str:
    if to in ids:
        return str(to)
    if to not in (None, noun, f"{noun}s"):
        raise InputError(f"'{to}' is no {noun}{suggest(str(to), ids)}")
    return min(ids, key=lambda id: (draft.load(id, subject), ids.index(id)))


def _pair(draft: Draft, to: Any, subject: SceneObject) -> tuple[str, str] | None:
    words = [to] if isinstance(to, str) else list(to or ())
    pools = [[id for id in draft.named(word) if id != subject.id] for word in words]
    if len(pools) == 1 and len(pools[0]) > 1:
        return pools[0][0], pools[0][1]
    if len(pools) == 2 and all(pools):
        second = [id for id in pools[1] if id != pools[0][0]]
        return (pools[0][0], second[0]) if second else None
    return None


def _words(to: Any) -> str:
    return to if isinstance(to, str) else " or ".join(to or ())
