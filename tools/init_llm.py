"""Begin with what a language model writes for this very request; it is then drawn as known kinds of rooms are."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.generate.room_rules import check_room, missing, refuse
from sceneweaver.io import packaged
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.load import group_templates
from sceneweaver.knowledge.surfaces import arrangements, crowds
from sceneweaver.language import SceneGraph
from sceneweaver.llm import ModelError
from sceneweaver.scene import CATALOGUE, InputError

from .base import Context, Proposal
from .card import checked
from .init_prior import InitPrior
from .room_kept import not_kept
from .room_reply import ProgrammeReply, room_of

RETRIES = 4
"""Times that a model is told what is wrong with a room."""

LONGEST = 4000
"""Characters of a request that are told."""


class InitLlm:
    """Draws the room that a model wrote down for the request."""

    name = "init_llm"

    def propose(self, context: Context) -> Proposal:
        """A whole scene; InputError without a model, or when it writes nothing that can be drawn."""
        inputs = checked(self.name, context.inputs)
        if context.client is None:
            raise InputError(f"tool {self.name} needs a language model, and there is none; use init_prior")

        def check(reply: ProgrammeReply) -> None:
            room = programme(reply, context.room_type)
            check_room(room)
            refuse(missing(room, context.room_type, context.brief))
            drawn(context, room, inputs)

        try:
            reply = context.client.ask(
                "programme", ProgrammeReply, instructions(), [_question(context)], check=check, retries=RETRIES
            )
        except ModelError as error:
            raise InputError(f"tool {self.name}: {error}") from error
        room = programme(reply, context.room_type)
        if reply.style and "style" not in inputs:
            inputs = {**inputs, "style": reply.style}
        made = drawn(context, room, inputs)
        said = (
            f"a model wrote down what the room holds: {len(room.items)} kinds of things for {shorten(reply.kind, 60)}"
        )
        scene = made.scene
        lost = not_kept(room, made, context.brief)
        if lost:
            said += f"; not as it was written: {'; '.join(lost)}"
        if scene is not None:
            scene = scene.model_copy(update={"provenance": {**scene.provenance, "tool": self.name}})
        return replace(made, scene=scene, notes=(said, *made.notes))


def programme(reply: ProgrammeReply, usual: RoomType) -> RoomType:
    """The kind of room that was asked for, holding what a model says; InputError where that cannot be."""
    least, _, largest = usual.area
    own = usual.model_dump(exclude={"items", "area", "people", "made_of"})
    area = (min(least, reply.area), reply.area, max(largest, reply.area))
    people = usual.people if reply.people is None else reply.people
    return room_of(reply, **{**own, "area": area, "people": people, "for_request": True})


def drawn(context: Context, room: RoomType, inputs: Any) -> Proposal:
    """A room of that kind, drawn; what goes wrong is a reason for another one."""
    try:
        return InitPrior().propose(replace(context, room_type=room, inputs=inputs, client=None))
    except InputError as error:
        hint = (
            "; name others as what carries it, or leave it to their top" if "support is missing" in str(error) else ""
        )
        raise InputError(f"the room cannot be drawn: {error}{hint}") from None
    except Exception as error:  # anything may stand in what a model wrote
        raise InputError(f"the room cannot be drawn ({type(error).__name__}); write it more simply") from error


@cache
def instructions() -> str:
    """What a model is told of its part."""
    return packaged.text(__package__ or "", "prompts", "room.md")


@cache
def vocabulary() -> str:
    """The words that a room may be written in, as JSON: relations, groups, arrangements, themes, categories.

    Before what a relation means stand its target and its parameters, before a group its items, as ``id:category``.
    """
    # Short lines of text: as objects, their keys alone would be a tenth of what a model reads.
    data = {
        "relations": {
            name: f"({' '.join([spec.target, *sorted(spec.params)])}) {spec.description}"
            for name, spec in CATALOGUE.items()
            if spec.target != "objects"
        },
        "groups": {name: f"({_members(one.items)}) {one.description}" for name, one in group_templates().items()},
        "arrangements": {name: one.description for name, one in arrangements().items()},
        "themes": {name: one.description for name, one in crowds().items()},
        "categories": " ".join(name for name, one in categories().items() if one.size is not None),
    }
    return compact(data)


def _members(rows: Sequence[Mapping[str, Any]]) -> str:
    """Names of the items of a group, each with its category where that is called otherwise."""
    whats = [(row["id"], row["what"] if isinstance(row["what"], str) else row["what"][0]) for row in rows]
    return " ".join(name if name == what else f"{name}:{what}" for name, what in whats)


def compact(data: object) -> str:
    """JSON without spaces, in letters as they are."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"))


def _question(context: Context) -> str:
    """Request, the kind of room as it is known, and the words to write in, as JSON."""
    rows = {
        "task": compact("Write down what this very room holds."),
        "request": compact(request_data(context.brief)),
        "such_a_room": compact(room_data(context.room_type)),
        "words": vocabulary(),
    }
    return "{" + ",\n".join(f'"{key}":{text}' for key, text in rows.items()) + "}"


def request_data(brief: SceneGraph) -> dict[str, Any]:
    """What was asked for, as it was understood."""
    data: dict[str, Any] = {
        "text": shorten(brief.text, LONGEST),
        "asks_for": [
            {"noun": shorten(e.noun), "category": e.category, "count": list(e.count or (1, 1))} for e in brief.entities
        ],
        "does_not_want": [shorten(e.words) for e in brief.exclusions],
        "sides": list(brief.size) if brief.size else None,
        "area": brief.area,
        "people": brief.people,
        "style": brief.style,
        "only_what_it_names": brief.only or None,
    }
    return {key: value for key, value in data.items() if value not in (None, [])}


def room_data(room: RoomType) -> dict[str, Any]:
    """A kind of room as it is known."""
    return {
        "name": room.name,
        "is": shorten(room.description, 200),
        "area": list(room.area),
        "items": {item.id: {"what": item.what[0], "need": item.need} for item in room.items},
    }
