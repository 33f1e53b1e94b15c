"""``read_by_model``: a request in any language as a scene graph, filled by a model and checked by code."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from string import Template
from typing import get_args

from sceneweaver.io import packaged
from sceneweaver.knowledge import room_types
from sceneweaver.llm import ModelClient, ModelError
from sceneweaver.scene import InputError

from ..graph import build
from ..model import PLACES, AttributeKind, SceneGraph
from ..source import LONGEST, Source
from ..things import MANY
from .disagreements import Disagreement, is_foreign
from .draft import Draft, add_things
from .english import cut, english
from .quotes import Quotes
from .readings import united
from .relations import add_relations
from .reply import RequestReply, RoomReply, Style
from .room import add_room

REFUSALS = 2
"""Times that a model is told what is wrong with its reading before what is wrong is left out."""

TOLD = 10
"""Problems that it is told at a time."""


@dataclass(frozen=True)
class Reading:
    """A request, read by a model.

    Attributes:
        graph: what to work from; its notes hold those below.
        disagreements: where the offline reader read something else, and which of the two is in the graph.
        notes: what of the model's answer was left out or mended.
        room: the kind of room in English as the model named it, also where none of that name is known.
    """

    graph: SceneGraph
    disagreements: tuple[Disagreement, ...] = ()
    notes: tuple[str, ...] = ()
    room: str = ""


def read_by_model(client: ModelClient, text: str, offline: SceneGraph) -> Reading:
    """What a request says, by a model.

    Each quote of the model is looked up in the text, each English noun in the taxonomy. What cannot be is told to the
    model, a few times, and then left out, with a note. `united` says how the reading meets that of the offline reader.

    Args:
        client: asks the model.
        text: the request, in any language.
        offline: what the offline reader read of it.

    Raises:
        ModelError: when there is no answer at all that can be read. Where a first answer is good enough and only
            mending it failed, that is used, with a note.
    """
    read = _Reader(text[:LONGEST])
    content = [json.dumps({"request": text[:LONGEST]}, ensure_ascii=False)]
    failure = ""
    try:
        reply = client.ask("read", RequestReply, instructions(), content, check=read.check)
    except ModelError as error:
        if read.best is None:
            raise
        reply, failure = read.best, str(error)
    draft = read.draft(reply)
    notes = [f"{problem}: {then}" for problem, then in draft.problems.items()]
    if len(text) > LONGEST:
        notes.append(f"only the first {LONGEST} of {len(text)} characters were read")
    if failure:
        notes.append(f"the model did not mend its reading: {cut(failure, 200)}")
    draft.parsed.notes += notes
    graph = build(text, draft.source, draft.parsed)
    if is_foreign(offline, reply.language):
        rows: tuple[Disagreement, ...] = (Disagreement.of_language(cut(reply.language) or "another language"),)
    else:
        graph, rows = united(graph, offline, draft.marked)
    return Reading(graph, rows, tuple(notes), english(reply.room.kind))


class _Reader:
    """Checks replies about one text; keeps the best."""

    def __init__(self, text: str) -> None:
        self._quotes = Quotes(text)
        self._refused, self._least = 0, 0
        self.best: RequestReply | None = None

    def draft(self, reply: RequestReply) -> Draft:
        """A reply in the form of the offline reader, with what is wrong about it."""
        draft = Draft(self._quotes, Source(self._quotes.text, list(range(len(self._quotes.text)))))
        add_things(reply, draft)
        add_relations(reply.relations, draft)
        add_room(reply.room, draft)
        draft.parsed.only = bool(reply.only)
        if not (reply.things or reply.exclusions or reply.unread or reply.room != RoomReply()):
            draft.problems["nothing of the request is in the answer"] = "nothing was read"
        return draft

    def check(self, reply: RequestReply) -> RequestReply | None:
        """Refuses a reply with something wrong, as long as there is hope; what is only doubtful is told beside it.

        Raises:
            InputError: what the model is to mend.
        """
        draft = self.draft(reply)
        if self.best is None or len(draft.problems) <= self._least:
            self.best, self._least = reply, len(draft.problems)
        if not draft.problems or self._refused >= REFUSALS:
            return self.best
        self._refused += 1
        raise InputError(_told([*draft.problems, *(draft.doubts if self._refused == 1 else ())]))


def _told(wrong: Sequence[str]) -> str:
    """What a model is told: the first of what is wrong."""
    shown = [f"- {problem}" for problem in list(dict.fromkeys(wrong))[:TOLD]]
    more = [f"- and {len(wrong) - TOLD} more"] if len(wrong) > TOLD else []
    return "\n".join(["Answer again, in full, with this mended:", *shown, *more])


@cache
def instructions() -> str:
    """What the model is told of the vocabulary."""
    prompt = packaged.text(__package__ or "", "prompts", "read_request.md")
    return Template(prompt).substitute(
        rooms=", ".join(room_types()).replace("_", " "),
        styles=", ".join(get_args(Style)),
        kinds=", ".join(get_args(AttributeKind)),
        places=", ".join(PLACES),
        many=str(list(MANY)),
    )
