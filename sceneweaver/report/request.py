"""The request with what became of each phrase: met, unmet, assumed or not understood."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Sequence
from typing import Any

from sceneweaver.critic import STATUSES, ItemOutcome, Phrase

from .data import ReportData
from .html import esc

SYMBOLS = {"met": "\u2713", "unmet": "\u2717", "assumed": "\u2248", "not_understood": "?"}
NAMES = {"met": "met", "unmet": "unmet", "assumed": "assumed", "not_understood": "not understood"}
LEGEND = ("met", "unmet", "assumed", "not_understood")


def items(data: ReportData) -> list[dict[str, Any]]:
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


def said(outcome: ItemOutcome) -> str:
    """An outcome as a sentence, with what was measured and what is allowed."""
    text = f"{NAMES[outcome.status]}: {outcome.reason}"
    return text if outcome.measured is None or outcome.told else f"{text} ({_numbers(outcome)})"


def section(data: ReportData) -> str:
    """The text with its phrases marked, a legend, and a list of what is not met or stands nowhere in the text."""
    if not data.phrases:
        return ""
    counts = Counter(phrase.outcome.status for phrase in data.phrases)
    legend = "".join(
        f'<li class="{status}"><span class="sign" aria-hidden="true">{SYMBOLS[status]}</span> '
        f"{NAMES[status]} <b>{counts[status]}</b></li>"
        for status in LEGEND
    )
    rows = "".join(_row(k, phrase) for k, phrase in enumerate(data.phrases) if _listed(phrase))
    listed = f'<ul class="items">{rows}</ul>' if rows else ""
    return (
        '<section id="request" aria-labelledby="request-title"><h2 id="request-title">Request</h2>'
        f'<p class="request-text">{_marked(data.request, data.phrases)}</p>'
        f'<ul class="legend" aria-label="Legend">{legend}</ul>'
        '<p id="request-detail" class="request-detail" role="status" aria-live="polite"></p>'
        f"{listed}</section>"
    )


def _listed(phrase: Phrase) -> bool:
    return phrase.span is None or phrase.outcome.status in ("unmet", "not_understood")


def _row(k: int, phrase: Phrase) -> str:
    status = phrase.outcome.status
    return (
        f'<li><button type="button" class="item {status}" data-items="{k}" aria-pressed="false">'
        f'<span class="sign" aria-hidden="true">{SYMBOLS[status]}</span>'
        f'<span class="quiet">{NAMES[status]}: </span><b>{esc(phrase.words)}</b> '
        f'<span class="detail">{esc(phrase.outcome.reason)}</span></button></li>'
    )


def _marked(text: str, phrases: Sequence[Phrase]) -> str:
    """The text, cut wherever a phrase begins or ends; each piece bears the worst status of the phrases over it."""
    spans = {k: phrase.span for k, phrase in enumerate(phrases) if phrase.span is not None}
    cuts = sorted({0, len(text), *(end for span in spans.values() for end in span)})
    pieces = []
    for start, end in itertools.pairwise(cuts):
        over = [k for k, span in spans.items() if span.start <= start and end <= span.end]
        pieces.append((tuple(sorted(over, key=lambda k: _rank(phrases[k]))), text[start:end]))
    found, before = [], ""
    for over, run in itertools.groupby(pieces, key=lambda piece: piece[0]):
        piece = "".join(words for _, words in run)
        status = phrases[over[0]].outcome.status if over and piece.strip() else ""
        found.append(_piece(over, piece, phrases, joined=bool(status) and status == before))
        before = status
    return "".join(found)


def _rank(phrase: Phrase) -> tuple[int, int]:
    """The worst first, then the innermost."""
    assert phrase.span is not None
    return -STATUSES.index(phrase.outcome.status), phrase.span.end - phrase.span.start


def _piece(over: Sequence[int], text: str, phrases: Sequence[Phrase], joined: bool) -> str:
    """One piece; ``joined`` to one of the same status right before it, it looks like one with that."""
    if not over or not text.strip():
        return esc(text)
    status = phrases[over[0]].outcome.status
    title = "\n".join(said(phrases[k].outcome) for k in over)
    return (
        f'<span class="phrase {status}{" joined" if joined else ""}" role="button" tabindex="0" aria-pressed="false" '
        f'data-items="{" ".join(map(str, over))}" title="{esc(title)}">'
        f'<span class="sign" aria-hidden="true">{SYMBOLS[status]}</span>{esc(text)}'
        f'<span class="quiet"> ({NAMES[status]})</span></span>'
    )


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
