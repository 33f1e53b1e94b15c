"""What inputs that a model gives must keep to beyond their card: one parent, real sizes, what was asked for stays."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.generate.draft import groups_of
from sceneweaver.generate.meant import named_kinds
from sceneweaver.io.messages import shorten, show, suggest
from sceneweaver.language import SceneGraph
from sceneweaver.scene import CATALOGUE, InputError, Relation, Scene
from sceneweaver.tools.add_relation import clash
from sceneweaver.tools.card import own_card

LONGEST_TEXT = 200
"""Characters that a text of inputs may have."""

LONGEST_NOUN = 40
"""Characters of the name of a thing that nobody knows."""

MOST_ENTRIES = 100
"""Entries that a list or an object of inputs may have."""

DEEPEST = 12
"""Levels of nesting that inputs may have."""

MOST_NAMED: int = own_card("add_objects").inputs["properties"]["objects"]["maxItems"]
"""Things that one call may name, besides those that the request asks for: as the card says, which a model is shown."""

MOST_ADDED = 400
"""Things that one call may add, with all that fills shelves."""

TOLERANCE = 0.02
"""Share by which a size may be outside what such things measure."""

FLAT = 0.02
"""Height [m] below which nobody can tell the sizes of things apart."""

HOLDING = ("on_top", "inside")
"""Relations that say what carries a thing."""

PULLED_UP = CATALOGUE.with_role("seat")
"""Relations that pull a seat up to one table."""

_AXES = ("deep", "wide", "high")


def check_extent(data: Any, where: str = "inputs", depth: int = 0) -> None:
    """Refuse inputs that are out of all proportion: long texts and lists, deep nesting.

    Raises:
        InputError: with the path to what is too long.
    """
    if depth > DEEPEST:
        raise InputError(f"{where} is nested more than {DEEPEST} levels deep; make it flat")
    if isinstance(data, str) and (len(data) > LONGEST_TEXT or not data.isprintable()):
        raise InputError(f"{where} is {show(data)}; give one line of at most {LONGEST_TEXT} characters")
    if isinstance(data, Mapping | list | tuple) and len(data) > MOST_ENTRIES:
        raise InputError(f"{where} has {len(data)} entries; at most {MOST_ENTRIES}")
    if isinstance(data, Mapping):
        for key, value in data.items():
            check_extent(str(key), f"{where}: a name", depth + 1)
            check_extent(value, f"{where}.{shorten(str(key), 40)}", depth + 1)
    elif isinstance(data, list | tuple):
        for k, value in enumerate(data):
            check_extent(value, f"{where}[{k}]", depth + 1)


def wrong_inputs(inputs: Mapping[str, Any], scene: Scene, brief: SceneGraph) -> list[str]:
    """What is wrong with inputs by themselves, each as a line; they are as their card says."""
    rows = [(f"inputs.objects[{k}]", row) for k, row in _rows(inputs.get("objects"))]
    found = [line for where, row in rows for line in _wrong_thing(where, row, brief)]
    found += list(_wrong_sizes(inputs, scene))
    found += _too_many([row for _, row in rows], brief)
    return found


def _rows(data: Any) -> Iterator[tuple[int, Mapping[str, Any]]]:
    for k, row in enumerate(data if isinstance(data, list | tuple) else ()):
        if isinstance(row, Mapping):
            yield k, row


def _wrong_thing(where: str, row: Mapping[str, Any], brief: SceneGraph) -> Iterator[str]:
    """What is wrong with one thing that inputs name."""
    category, size = row.get("category"), row.get("size")
    if isinstance(category, str):
        match = resolve(category)
        if match.generic and not _noun(category) and match.category not in {e.category for e in brief.entities}:
            yield f"{where}.category is {show(category)}, which is no noun; name one thing, such as floor lamp"
        if match.category in categories() and isinstance(size, list | tuple):
            yield from _out_of_range(f"{where}.size", match.category, size)
        unwanted = groups_of(match.category) & set(brief.without)
        if unwanted:
            yield f"{where}: the request wants no {' and no '.join(sorted(unwanted))}; leave it out"
        elif brief.only and match.category not in named_kinds(brief):
            yield f"{where}: the request wants only what it names, which is no {shorten(category)}; leave it out"
    asked = row.get("asked")
    if isinstance(asked, str) and brief.entity(asked) is None:
        known = [entity.id for entity in brief.entities]
        yield f"{where}.asked is {show(asked)}{suggest(asked, known, what='the request names')}"
    if row.get("need") == "asked" and asked is None:
        yield f"{where}.need is asked; say with asked which thing of the request it stands for, or leave need out"
    places = [place for _, place in _rows(row.get("place"))]
    for types, doing in ((HOLDING, "stand on"), (PULLED_UP, "be pulled up to")):
        targets = {str(p.get("to")) for p in places if p.get("type") in types and not p.get("soft")}
        if len(targets) > 1:
            yield f"{where}.place has {len(targets)} parents, {' and '.join(sorted(targets))}; it can {doing} one only"


def _noun(text: str) -> bool:
    """Whether a text may be the name of a thing: a few words and nothing else."""
    return re.fullmatch(r"[^\W\d_]+([ _'-][^\W\d_]+){0,3}", text.strip()) is not None and len(text) <= LONGEST_NOUN


def _out_of_range(where: str, category: str, size: Sequence[Any]) -> Iterator[str]:
    """The extents [m] that no such thing has."""
    known = categories()[category].size
    for k, (extent, (low, high)) in enumerate(zip(size, known.ranges if known else (), strict=False)):
        if high < FLAT:  # as flat as it is, whatever a rounded number says
            continue
        if isinstance(extent, int | float) and not low * (1 - TOLERANCE) <= extent <= high * (1 + TOLERANCE):
            name = category.replace("_", " ")
            yield f"{where}[{k}] is {extent:g}; a {name} is {low:g} to {high:g} m {_AXES[k]}"


def _wrong_sizes(inputs: Mapping[str, Any], scene: Scene) -> Iterator[str]:
    """The same for sizes that are given to objects which are there."""
    sizes, scale = inputs.get("sizes"), inputs.get("scale")
    there = {o.id: o for o in scene.objects}
    wanted: dict[str, tuple[str, Sequence[Any]]] = {}
    for name, size in sizes.items() if isinstance(sizes, Mapping) else ():
        wanted[name] = (f"inputs.sizes[{show(name)}]", size if isinstance(size, list | tuple) else ())
    if isinstance(scale, int | float) and isinstance(inputs.get("ids"), list | tuple):
        for name in inputs["ids"]:
            if isinstance(name, str) and name in there:
                where = f"inputs.scale makes {show(name)} too large or too small: its size"
                wanted[name] = (where, [extent * scale for extent in there[name].size])
    for name, (where, size) in wanted.items():
        category = there[name].category if name in there else ""
        if category in categories():
            yield from _out_of_range(where, category, size)


def _too_many(rows: Sequence[Mapping[str, Any]], brief: SceneGraph) -> list[str]:
    counts = [row.get("count", 1) for row in rows]
    named = sum(c for c in counts if isinstance(c, int | float))
    most = MOST_NAMED + sum(e.count[1] if e.count else 1 for e in brief.entities)
    return [f"inputs.objects names {named:g} things; name at most {most} in one call"] if named > most else []


def wrong_changes(before: Scene, after: Scene, brief: SceneGraph) -> list[str]:
    """What is wrong with what a tool made of a scene, each as a line."""
    there, kept = {o.id: o for o in before.objects}, {o.id for o in after.objects}
    added = [o for o in after.objects if o.id not in there]
    found = _lost([o.id for o in before.objects if o.id not in kept], before, after, brief)
    unwanted = sorted({o.category for o in added if groups_of(o.category) & set(brief.without)})
    if unwanted:
        found.append(f"this adds {', '.join(unwanted)}, which the request does not want; leave it out")
    if len(added) > MOST_ADDED:
        found.append(
            f"this adds {len(added)} things; at most {MOST_ADDED} in one call: name fewer, or lower the density"
        )
    moved = [o.id for o in after.objects if o.id in there and there[o.id].fixed and o.pose != there[o.id].pose]
    if moved:
        found.append(f"{', '.join(moved[:5])} must stay where it is; leave it out")
    return found + _never(before, after)


def _lost(gone: Sequence[str], before: Scene, after: Scene, brief: SceneGraph) -> list[str]:
    """What was asked for and would be missing; more than was asked for may go."""
    excluded = set(brief.without)
    found: list[str] = []
    for name in gone:
        intent, category = before.object(name).intent, before.object(name).category
        if groups_of(category) & excluded:
            continue
        entity = brief.entity(intent.request) if intent.request is not None else None
        if entity is not None:
            left = sum(o.intent.request == entity.id for o in after.objects)
            least = entity.count[0] if entity.count else 1
            if left < least:
                found.append(f"{name} was asked for ({least} x {shorten(entity.noun)}) and must stay")
        elif intent.priority == "asked":
            found.append(f"{name} was asked for and must stay")
    more = [f"and {len(found) - 4} others were asked for"] if len(found) > 4 else []
    return [*found[:4], *more]


def _never(before: Scene, after: Scene) -> list[str]:
    """New relations that can never hold, alone or with others."""
    old = set(map(_key, before.relations))
    new = [r for r in after.relations if r.hard and _key(r) not in old]
    xs, ys = zip(*after.room.outline, strict=True)
    longest = math.hypot(max(xs) - min(xs), max(ys) - min(ys))
    found: list[str] = []
    for r in new:
        least = r.params.get("min")
        if isinstance(least, int | float) and least > longest:
            found.append(f"{_said(r)} wants {least:g} m, and the room is {longest:.1f} m from corner to corner")
        rival = next((o for o in after.relations if o is not r and o.hard and clash(r, o)), None)
        if rival is not None:
            found.append(f"{_said(r)} and {_said(rival)} can never both hold; keep one, or make yours soft")
    return found[:5]


def _key(r: Relation) -> tuple[Any, ...]:
    return r.type, r.subject, r.target, tuple(sorted((k, str(v)) for k, v in r.params.items())), r.hard


def _said(r: Relation) -> str:
    return f"{r.type} of {r.subject}" + (f" to {' and '.join(r.targets)}" if r.targets else "")
