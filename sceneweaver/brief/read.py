"""``read_request``: a request in plain English as a typed scene graph."""

from __future__ import annotations

import re

from sceneweaver.scene import InputError

from .chunker import Chunker
from .clauses import Clauses
from .graph import build
from .model import SceneGraph
from .parsed import Parsed
from .source import Source, check_measures, read_source
from .tokens import tokens


def read_request(text: str) -> SceneGraph:
    """What a request says. What is not understood is listed, what is assumed is noted; nothing is lost.

    Raises:
        InputError: when there is nothing to read.
    """
    if not isinstance(text, str) or not text.strip():
        raise InputError('prompt: it is empty; say what room you want, such as "a bedroom with a desk"')
    source = read_source(text)
    parsed = Parsed(notes=list(source.notes))
    Clauses(Chunker(tokens(source, parsed.notes)).run(), source, parsed).run()
    _sides(parsed, source)
    for note in source.notes:
        parsed.note(note)
    foreign = sum(ord(c) > 0x24F and c.isalpha() for c in text)
    if foreign > 3 or not re.search(r"[a-zA-Z]", text):
        parsed.note("only English is read; what else the request says was not understood")
    elif parsed.room_type is None and not parsed.mentions and sum(len(u.words.split()) for u in parsed.unread) >= 3:
        parsed.note("nothing of it names a room or furniture; only English is read")
    graph = build(text, source, parsed)
    if not graph.notes and not graph.unread and graph == SceneGraph(text=text):
        return graph.model_copy(update={"notes": ("nothing of the request was understood",)})
    return graph


def _sides(parsed: Parsed, source: Source) -> None:
    """The sides that are of no thing are those of the room; the first count."""
    for sides in parsed.sides:
        if source.size is None:
            source.size = (max(sides[:2]), min(sides[:2]))
            if len(sides) > 2 and source.height is None:
                source.height = sides[2]
        elif set(sides[:2]) != set(source.size):
            source.notes.append(f"{sides[0]:g} x {sides[1]:g} m: the room has other sides already; it was left out")
    check_measures(source)
