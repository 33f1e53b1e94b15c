"""``read_request``: a request in plain English as a typed scene graph."""

from __future__ import annotations

import re

from .asides import without_asides
from .chunker import chunked
from .clauses import read_clauses
from .graph import build
from .learned.analysis import analyse
from .learned.completing import complete
from .model import SceneGraph
from .parsed import Left, Parsed, without
from .parts_of_speech import with_parts_of_speech
from .predicates import with_predicates
from .refusals import with_refusals
from .source import Source, check_measures, check_text, read_source
from .statements import STATEMENTS, furnish_zones
from .subclauses import without_subclauses
from .things import match_of
from .tokens import Token, tokens

_ENGLISH = frozenset(
    ("a", "an", "the", "with", "and", "of", "on", "for", "to", "by", "at", "is", "are", "no", "its", "their", "that")
)
"""Words that hardly an English request does without."""

FEW = 0.08
"""Share of them up to which a request that is hardly understood is in another language."""


def read_request(text: str) -> SceneGraph:
    """What a request says. What is not understood is listed, what is assumed is noted; nothing is lost.

    The rules of ``lexicon/`` read first. Where things are and what stays free that no rule read is taken from the
    learned analysis (`learned`), if the request is in English.

    Raises:
        InputError: when there is nothing to read, or more than `source.MOST` characters.
    """
    return _read(text, learned=True)


def read_by_rules(text: str) -> SceneGraph:
    """What the rules alone read of a request; see `read_request`."""
    return _read(text, learned=False)


def parsed_by_rules(text: str) -> tuple[Source, Parsed]:
    """What the rules read of a text, before it has the form of a graph."""
    source = read_source(text)
    parsed = Parsed(notes=list(source.notes))
    for read in STATEMENTS:
        read(source, parsed)
    read_clauses(chunked(_at_their_places(tokens(source, parsed.notes))), source, parsed)
    return source, parsed


def _read(text: str, learned: bool) -> SceneGraph:
    check_text(text)
    source, parsed = parsed_by_rules(text)
    if learned and source.language == "en":
        complete(parsed, source, text, analyse(text, parsed), lambda sentence: parsed_by_rules(sentence)[1])
    furnish_zones(parsed)
    _sides(parsed, source)
    for note in source.notes:
        parsed.note(note)
    foreign = source.language == "en" and _is_foreign(text, parsed)
    if foreign or source.language != "en":
        _leave_out_unknown(parsed)
    if source.language != "en":
        pass  # the note says which language it is
    elif foreign or sum(ord(c) > 0x24F and c.isalpha() for c in text) > 3 or not re.search(r"[a-zA-Z]", text):
        parsed.note("only English is read; what else the request says was not understood")
    elif parsed.room_type is None and not parsed.mentions and sum(len(u.words.split()) for u in parsed.unread) >= 3:
        parsed.note("nothing of it names a room or furniture; only English is read")
    graph = build(text, source, parsed)
    if not graph.notes and not graph.unread and graph == SceneGraph(text=text):
        return graph.model_copy(update={"notes": ("nothing of the request was understood",)})
    return graph


def _at_their_places(found: list[Token]) -> list[Token]:
    """The tokens, each as what it is where it stands; what names nothing is told as a whole."""
    for step in (without_subclauses, with_refusals, with_parts_of_speech, with_predicates, without_asides):
        found = step(found)
    return found


def _is_foreign(text: str, parsed: Parsed) -> bool:
    """Whether a request is in another language that is written in Latin letters: most of it is no English."""
    spoken = re.findall(r"[^\W\d_]+", text.lower())
    strange = [u.words for u in parsed.unread] + [m.noun for m in parsed.mentions if m.generic]
    lost = sum(len(words.split()) for words in strange)
    return 2 * lost > len(spoken) > 4 and sum(word in _ENGLISH for word in spoken) <= FEW * len(spoken)


def _leave_out_unknown(parsed: Parsed) -> None:
    """Words of another language that look like nouns, or like slips of English ones, make no things."""
    unknown = [m for m in parsed.mentions if m.generic or match_of(m.noun).how == "spelling"]
    notes = {match_of(m.noun).note for m in unknown}
    parsed.unread += [Left(m.noun) for m in unknown]
    parsed.mentions = without(parsed.mentions, unknown)
    parsed.said = [s for s in parsed.said if not any(m in unknown for m in (*s.subjects, *s.targets))]
    parsed.notes = [note for note in parsed.notes if note not in notes]


def _sides(parsed: Parsed, source: Source) -> None:
    """Sides of the main part of a floor are those of the room."""
    for sides in parsed.sides[:1]:
        source.size = (max(sides[:2]), min(sides[:2]))
        if len(sides) > 2 and source.height is None:
            source.height = sides[2]
    check_measures(source)
