"""What a vision model says about the room: its grades beside the critic's, its reasons, and faults to click on."""

from __future__ import annotations

from typing import Any

from sceneweaver.critic import Review, VisualFault, VisualReview

from .data import ReportData
from .html import esc

SEVERITIES = {1: ("unknown", "blemish"), 2: ("fair", "flaw"), 3: ("bad", "grave")}
"""Tone and name of a fault by its severity."""


def items(data: ReportData) -> list[dict[str, Any]]:
    """What the scripts of the page need to know of each fault, in their order."""
    known = set(data.scene.ids)
    seen = data.review.seen if data.review is not None else None
    return [
        {"status": "seen", "text": fault.reason, "objects": [o for o in fault.objects if o in known]}
        for fault in (seen.faults if seen is not None else ())
    ]


def section(data: ReportData) -> str:
    """Grades with their spread, comments, and faults that show their objects; empty where no model was asked."""
    if data.review is None or data.review.seen is None:
        return ""
    seen = data.review.seen
    cards = "".join(_card(name, data.review, seen) for name in seen.grades)
    rows = "".join(_row(k, fault, seen.samples) for k, fault in enumerate(seen.faults))
    listed = f'<h3>What it sees</h3><ul class="items">{rows}</ul>' if rows else ""
    return (
        '<section id="seen" aria-labelledby="seen-title"><h2 id="seen-title">Seen by a model</h2>'
        f'<p class="aside">{_about(seen)}</p><ul class="grades">{cards}</ul>{listed}</section>'
    )


def _about(seen: VisualReview) -> str:
    """Who looked at what, how often."""
    shown = _count(len(seen.pictures), "picture") if seen.pictures else "the data alone"
    text = f"{seen.model} looked at {shown}: {_count(seen.samples, 'answer')}, mean {seen.mean:.1f} of 10"
    if seen.samples > 1:
        text += f", standard deviation {seen.spread:.1f}"
    text += ". It stands beside the scores and changes none of them."
    if seen.failed:
        text += f" Without an answer: {'; '.join(seen.failed)}"
    return esc(text)


def _card(name: str, review: Review, seen: VisualReview) -> str:
    grade = seen.grades[name]
    tone = "good" if grade >= 7.5 else "fair" if grade >= 5 else "bad"
    beside = f"{review.critic} critic {review.grades[name]:.1f}" if name in review.grades else ""
    low, high = seen.ranges.get(name, (grade, grade))
    apart = f"{low:g} to {high:g}, deviation {seen.deviation.get(name, 0.0):.1f}" if seen.samples > 1 else ""
    comments = "".join(f"<li>{esc(text)}</li>" for text in dict.fromkeys(seen.comments.get(name, ())) if text)
    return (
        f'<li><div class="grade"><h3>{esc(name.replace("_", " "))}</h3><b>{grade:.1f}</b></div>'
        f'<div class="bar" role="img" aria-label="{esc(name)}: {grade:.1f} of 10">'
        f'<i class="{tone}" style="width:{100 * max(0.0, min(1.0, grade / 10)):.0f}%"></i></div>'
        f'<p class="aside">{esc("; ".join(part for part in (beside, apart) if part))}</p>'
        + (f"<ul>{comments}</ul>" if comments else "")
        + "</li>"
    )


def _row(k: int, fault: VisualFault, samples: int) -> str:
    tone, name = SEVERITIES[max(1, min(3, round(fault.severity)))]
    by = f", in {round(fault.share * samples)} of {samples} answers" if samples > 1 else ""
    about = f"{', '.join(fault.objects) or 'the room'}: "
    return (
        f'<li><button type="button" class="item" data-items="{k}" aria-pressed="false">'
        f'<span class="tag {tone}">{name}</span> <b>{esc(about)}</b>{esc(fault.reason)} '
        f'<span class="detail">{esc(fault.suggestion)} ({esc(fault.criterion + by)})</span></button></li>'
    )


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")
