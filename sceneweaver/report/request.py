"""What became of each phrase of the request, and faults that a model sees: both show their objects in the view."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

from sceneweaver.critic import STATUSES, ItemOutcome, Phrase

from .data import ReportData

SYMBOLS = {
    "met": "\u2713",
    "partly": "\u00bd",
    "substituted": "\u2248",
    "assumed": "\u2248",
    "not_understood": "?",
    "unmet": "\u2717",
}
NAMES = {status: status.replace("_", " ") for status in SYMBOLS}
SEVERITIES = {1: ("unknown", "blemish"), 2: ("fair", "flaw"), 3: ("bad", "grave")}
"""Tone and name of a fault by its severity."""


@dataclass(frozen=True)
class Piece:
    """A piece of the request: the numbers of the phrases over it, the worst first, and the worst status (empty: none).

    ``joined`` to one of the same status right before it, it looks like one with that; ``title`` says what is known.
    """

    text: str
    over: tuple[int, ...] = ()
    status: str = ""
    title: str = ""
    joined: bool = False


def context(data: ReportData) -> dict[str, Any]:
    """What the page shows of the request and of the faults that a model sees."""
    apart = ("unmet", "not_understood", "substituted", "partly")
    shown = [(k, p) for k, p in enumerate(data.phrases) if p.span is None or p.outcome.status in apart]
    table = {"symbols": SYMBOLS, "names": NAMES, "severities": SEVERITIES}
    return {**table, "pieces": pieces(data), "listed_phrases": shown}


def phrase_items(data: ReportData) -> list[dict[str, Any]]:
    """What the scripts of the page need to know of each item, in the order of the phrases."""
    known = set(data.scene.ids)
    return [
        {
            "status": phrase.outcome.status,
            "text": said(phrase.outcome),
            "objects": [object_id for object_id in phrase.outcome.objects if object_id in known],
        }
        for phrase in data.phrases
    ]


def fault_items(data: ReportData) -> list[dict[str, Any]]:
    """What the scripts of the page need to know of each fault that a model sees, in their order."""
    known = set(data.scene.ids)
    seen = data.review.seen if data.review is not None else None
    return [
        {"status": "seen", "text": fault.reason, "objects": [o for o in fault.objects if o in known]}
        for fault in (seen.faults if seen is not None else ())
    ]


def said(outcome: ItemOutcome) -> str:
    """An outcome as a sentence, with what was measured and what is allowed."""
    text = f"{NAMES[outcome.status]}: {outcome.reason}"
    return text if outcome.measured is None or outcome.told else f"{text} ({_numbers(outcome)})"


def pieces(data: ReportData) -> list[Piece]:
    """The request, cut wherever a phrase begins or ends."""
    text, phrases = data.request, data.phrases
    spans = {k: phrase.span for k, phrase in enumerate(phrases) if phrase.span is not None}
    cuts = sorted({0, len(text), *(end for span in spans.values() for end in span)})
    marked = []
    for start, end in itertools.pairwise(cuts):
        over = [k for k, span in spans.items() if span.start <= start and end <= span.end]
        marked.append((tuple(sorted(over, key=lambda k: _rank(phrases[k]))), text[start:end]))
    found: list[Piece] = []
    for over, run in itertools.groupby(marked, key=lambda piece: piece[0]):
        words = "".join(part for _, part in run)
        if not over or not words.strip():
            found.append(Piece(words))
            continue
        status, title = phrases[over[0]].outcome.status, "\n".join(said(phrases[k].outcome) for k in over)
        found.append(Piece(words, over, status, title, bool(found) and found[-1].status == status))
    return found


def _rank(phrase: Phrase) -> tuple[int, int]:
    """The worst first, then the innermost."""
    assert phrase.span is not None
    return -STATUSES.index(phrase.outcome.status), phrase.span.end - phrase.span.start


def _numbers(outcome: ItemOutcome) -> str:
    unit = f" {outcome.unit}" if outcome.unit else ""
    low, high = outcome.allowed or (None, None)
    if low is None and high is None:
        allowed = ""
    elif low is None:
        allowed = f", allowed at most {high:g}{unit}"
    elif high is None:
        allowed = f", allowed at least {low:g}{unit}"
    else:
        allowed = f", allowed {low:g}{unit}" if low == high else f", allowed {low:g} to {high:g}{unit}"
    return f"{outcome.quantity} {round(outcome.measured or 0.0, 3):g}{unit}{allowed}"
