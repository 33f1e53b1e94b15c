"""The words that a tool knows, as JSON for prompts: relations, categories, arrangements, themes, items of the room."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sceneweaver.agent.memory import Call
from sceneweaver.assets import categories, resolve
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge.surfaces import arrangements, crowds
from sceneweaver.scene import CATALOGUE
from sceneweaver.scene.catalogue import ParamSpec
from sceneweaver.tools.base import Context
from sceneweaver.tools.card import ToolCard

from .scene_text import compact, rounded

MOST = 80
"""Categories that are listed."""

KIN = 10
"""Relatives of a category that are listed with it: of a chair other chairs."""

WORDS = 3
"""Longest name of a thing [words] that is looked for in a text."""

SENTENCE = 200
"""Longest description [characters]."""

MOST_CARRIERS = 100
"""Objects that carry things, of those in a scene, that are listed."""


def relations_data() -> dict[str, Any]:
    """Every relation type with what it means, its target and its parameters."""
    found: dict[str, Any] = {}
    for name, spec in CATALOGUE.items():
        row: dict[str, Any] = {"means": spec.description, "target": spec.target.removesuffix("?")}
        if spec.target.endswith("?"):
            row["target_may_be_left_out"] = True
        if spec.params:
            row["params"] = {key: _param(param) for key, param in spec.params.items()}
        found[name] = row
    return found


def _param(param: ParamSpec) -> str:
    """A parameter in words."""
    kind = "one of " + ", ".join(param.choices) if param.choices else param.type
    return " ".join(part for part in (kind, f"[{param.unit}]" if param.unit else "", param.description) if part)


def categories_data(texts: Iterable[str], more: Iterable[str] = ()) -> dict[str, Any]:
    """Categories that texts name, with their relatives, and some more: sizes [m] and what holds them.

    Args:
        texts: the instruction, the request: anything that names things.
        more: categories to list first.
    """
    known = categories()
    names = [name for name in more if name in known and known[name].size is not None]
    named = [name for text in texts for name in categories_in(text)]
    kin = [other for name in named for other in _kin(name)]
    return {name: _category(name) for name in [*dict.fromkeys((*names, *named, *kin))][:MOST]}


def categories_in(text: str) -> list[str]:
    """The categories with bodies that words of a text name, in their order."""
    words, found, at = re.findall(r"[^\W\d_]+", text.lower())[:400], list[str](), 0
    while at < len(words):
        for length in range(min(WORDS, len(words) - at), 0, -1):
            match = resolve(" ".join(words[at : at + length]))
            if match.how in ("exact", "synonym", "plural", "group") and match.category in categories():
                found.append(match.category)
                at += length - 1
                break
        at += 1
    return [*dict.fromkeys(found)]


def _kin(name: str) -> list[str]:
    parent = categories()[name].parent if name in categories() else None
    return list(members(parent))[:KIN] if parent else []


def _category(name: str) -> dict[str, Any]:
    known = category_named(name)
    ranges = known.size.ranges if known.size is not None else ()
    row: dict[str, Any] = {"size": [[rounded(low), rounded(high)] for low, high in ranges], "mount": list(known.mount)}
    return row | ({"on": list(known.on)} if known.on else {})


def catalogue_data(card: ToolCard, context: Context, call: Call) -> dict[str, Any]:
    """What of the catalogue the inputs of a tool name."""
    words, scene = words_of(card.inputs), context.scene
    found: dict[str, Any] = {}
    if words & {"place", "relations"}:
        found["relations"] = relations_data()
    if words & {"category", "categories"}:
        there = [*dict.fromkeys(o.category for o in scene.objects if o.mount != "surface")]
        found["categories"] = categories_data([call.instruction, context.brief.text, compact(dict(call.inputs))], there)
        found["items_of_such_a_room"] = {
            item.id: {"categories": [*dict.fromkeys(item.what)], "need": item.need} for item in context.room_type.items
        }
    for word, name, known in (("arrangement", "arrangements", arrangements), ("theme", "themes", crowds)):
        if word in words:
            found[name] = {key: shorten(one.description, SENTENCE) for key, one in known().items()}
    if words & {"supports", "on"}:
        found["carriers"] = [o.id for o in scene.objects if o.surfaces][:MOST_CARRIERS]
    return found


def words_of(schema: Mapping[str, Any]) -> frozenset[str]:
    """The names of all properties in a schema, at any depth."""
    return frozenset(_properties(schema))


def _properties(schema: Any) -> Iterator[str]:
    if isinstance(schema, Mapping):
        inner = schema.get("properties", {})
        yield from inner
        for part in (*inner.values(), schema.get("items"), schema.get("additionalProperties")):
            yield from _properties(part)
