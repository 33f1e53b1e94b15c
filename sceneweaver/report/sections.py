"""The parts of the page under the 3D view, as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sceneweaver.critic import Review

from .data import ReportData, StepRow
from .facts import RelationRow, ViolationRow
from .html import esc, number, picture_url
from .models import thought

_CAPTIONS = {
    "eye-door": "From the door",
    "eye-corner": "From a corner at eye level",
    "eye-corner2": "From another corner",
    "corner": "From above a corner",
    "top": "From above",
    "top_annotated": "Plan with names and dimensions",
}

_COUNTS = (
    ("requested", "Objects requested"),
    ("placed", "Placed"),
    ("dropped", "Dropped"),
    ("collisions", "Collisions"),
    ("out_of_bounds", "Out of the room"),
    ("unsupported", "Unsupported"),
    ("blocked_zones", "Blocked zones"),
    ("blocked_openings", "Blocked doors and windows"),
)


def header(data: ReportData, valid: bool | None) -> str:
    """Title, prompt, verdict and key numbers."""
    scene, metrics = data.scene, data.metrics
    badge = {True: ("good", "valid"), False: ("bad", "not valid"), None: ("unknown", "not checked")}[valid]
    relations = metrics.get("relations") or {}
    tallies = [relations.get(kind) or {} for kind in ("hard", "soft")]
    total = sum(int(t.get("total", 0)) for t in tallies)
    kept = sum(int(t.get("satisfied", 0)) for t in tallies)
    facts = [(str(len(scene.objects)), "object" if len(scene.objects) == 1 else "objects")]
    if scene.dropped:
        facts.append((str(len(scene.dropped)), "dropped"))
    if total:
        facts.append((f"{kept} / {total}", "relations hold"))
    seconds = (metrics.get("seconds") or {}).get("total")
    took = sum(step.seconds for step in data.steps) or seconds
    if isinstance(took, int | float):
        shown = f"{took:.1f} s" if took >= 0.05 else f"{took * 1000:.0f} ms"
        facts.append((shown, "in all steps" if data.steps else "in all"))
    share = metrics.get("reachable_share")
    if isinstance(share, int | float):
        facts.append((f"{100 * share:.0f} %", "reachable"))
    title = data.title or scene.id
    prompt = f'<p class="prompt">{esc(scene.prompt)}</p>' if scene.prompt and scene.prompt != title else ""
    rows = "".join(f"<li><b>{esc(value)}</b> <span>{esc(name)}</span></li>" for value, name in facts)
    kind = scene.room.type.replace("_", " ")
    head = f'<p class="eyebrow">{esc(kind)}</p><h1>{esc(title)}</h1>{prompt}'
    if data.phrases:  # the request comes next, with its phrases
        head = f"<h1>{esc(kind.capitalize())}</h1>"
    return (
        f'<header class="top"><div>{head}</div>'
        f'<p class="badge {badge[0]}">{badge[1]}</p><ul class="facts">{rows}</ul></header>'
    )


def scores(review: Review | None, metrics: Mapping[str, Any]) -> str:
    """The critic's grades as bars, with its reasons."""
    grades: dict[str, float] = {}
    critic = ""
    if review is not None:
        grades, critic = dict(review.grades), review.critic
    elif isinstance(metrics.get("scores"), Mapping):
        given = dict(metrics["scores"])
        critic = str(given.pop("critic", ""))
        grades = {k: float(v) for k, v in given.items() if isinstance(v, int | float) and not isinstance(v, bool)}
    if not grades:
        return ""
    cards = []
    for name, grade in grades.items():
        faults = [f for f in review.faults if f.criterion == name] if review is not None else []
        reasons = "".join(
            f"<li>{esc(f.reason)}" + (f" <em>{esc(f.suggestion)}</em>" if f.suggestion else "") + "</li>"
            for f in faults[:6]
        )
        if len(faults) > 6:
            reasons += f"<li>and {len(faults) - 6} more</li>"
        share = max(0.0, min(1.0, grade / 10))
        tone = "good" if grade >= 7.5 else "fair" if grade >= 5 else "bad"
        cards.append(
            f'<li><div class="grade"><h3>{esc(name.replace("_", " "))}</h3><b>{grade:.1f}</b></div>'
            f'<div class="bar" role="img" aria-label="{esc(name)}: {grade:.1f} of 10">'
            f'<i class="{tone}" style="width:{100 * share:.0f}%"></i></div>'
            + (f"<ul>{reasons}</ul>" if reasons else "")
            + "</li>"
        )
    by = f'<p class="aside">Graded 0 to 10 by the {esc(critic)} critic.</p>' if critic else ""
    return _section("scores", "Scores", f'{by}<ul class="grades">{"".join(cards)}</ul>')


def pictures(data: ReportData) -> str:
    """The rendered pictures, large ones embedded as JPEG."""
    order = sorted(data.pictures, key=lambda name: (list(_CAPTIONS).index(name) if name in _CAPTIONS else 9, name))
    figures = []
    for name in order:
        picture = data.pictures[name]
        caption = esc(_CAPTIONS.get(name, name.replace("_", " ")))
        wide = ' class="wide"' if name == "top_annotated" else ""
        url = picture_url(picture, 1600 if name == "top_annotated" else 1100)
        figures.append(
            f'<figure{wide}><img src="{url}" alt="{caption}" width="{picture.width}" height="{picture.height}">'
            f"<figcaption>{caption}</figcaption></figure>"
        )
    return _section("pictures", "Pictures", f'<div class="pictures">{"".join(figures)}</div>') if figures else ""


def findings(data: ReportData, faults: Sequence[ViolationRow]) -> str:
    """Violations, unmet wishes, dropped objects, warnings and notes."""
    parts = []
    hard = [f for f in faults if f.kind != "soft_relation"]
    soft = [f for f in faults if f.kind == "soft_relation"]
    for title, rows, kind in (("Violations", hard, "bad"), ("Soft relations that do not hold", soft, "fair")):
        if rows:
            items = "".join(f'<li><span class="tag {kind}">{esc(f.name)}</span> {esc(f.detail)}</li>' for f in rows)
            parts.append(f"<h3>{title}</h3><ul class='findings'>{items}</ul>")
    if data.scene.dropped:
        items = "".join(f"<li><b>{esc(d.id)}</b> ({esc(d.category)}): {esc(d.reason)}</li>" for d in data.scene.dropped)
        parts.append(f"<h3>Not placed</h3><ul class='findings'>{items}</ul>")
    for title, texts in (("Unmet wishes", data.unmet), ("Warnings", data.warnings), ("Notes", data.notes)):
        if texts:
            items = "".join(f"<li>{esc(text)}</li>" for text in texts)
            parts.append(f"<h3>{title}</h3><ul class='findings'>{items}</ul>")
    return _section("findings", "Findings", "".join(parts)) if parts else ""


def measures(metrics: Mapping[str, Any]) -> str:
    """The table of metrics.json."""
    if not metrics:
        return ""
    rows: list[tuple[str, str]] = [(name, number(metrics[key])) for key, name in _COUNTS if key in metrics]
    for kind, name in (("hard", "Hard relations that hold"), ("soft", "Soft relations that hold")):
        tally = (metrics.get("relations") or {}).get(kind)
        if tally and tally.get("total"):
            rows.append((name, f"{tally.get('satisfied', 0)} of {tally['total']}"))
    for key, name in (("walkable_share", "Floor that can be walked on"), ("reachable_share", "Objects within reach")):
        if isinstance(metrics.get(key), int | float):
            rows.append((name, f"{100 * metrics[key]:.1f} %"))
    for key, name in (
        ("moved_over_0_1m", "Moved more than 10 cm when settled"),
        ("moved_over_0_01m", "Moved more than 1 cm when settled"),
        ("mean_shift_m", "Mean shift when settled [m]"),
    ):
        if key in (metrics.get("stability") or {}):
            rows.append((name, number(metrics["stability"][key], 4)))
    rows += [
        (key.capitalize().replace("_", " "), str(metrics[key]))
        for key in ("candidates", "seed", "device", "cut_off")
        if metrics.get(key) is not None
    ]
    more: list[tuple[str, str]] = []
    spent = metrics.get("seconds") or {}
    more += [(f"Seconds, {name.replace('_', ' ')}", number(value, 3)) for name, value in spent.items()]
    more += [(f"Version of {name}", str(value)) for name, value in (metrics.get("versions") or {}).items()]
    tail = f"<details><summary>Times and versions</summary>{_table(more)}</details>" if more else ""
    return _section("metrics", "Metrics", _table(rows) + tail)


def _table(rows: Sequence[tuple[str, str]]) -> str:
    body = "".join(f"<tr><th scope='row'>{esc(n)}</th><td>{esc(v)}</td></tr>" for n, v in rows)
    return f'<table class="metrics"><tbody>{body}</tbody></table>'


def relations(rows: Sequence[RelationRow]) -> str:
    """All relations, those that do not hold first."""
    if not rows:
        return ""
    marks = {
        True: ("held", "\u2713", "holds"),
        False: ("broken", "\u2717", "does not hold"),
        None: ("", "\u00b7", "not checked"),
    }
    items = []
    for row in sorted(rows, key=lambda r: r.held is not False):
        kind, mark, words = marks[row.held]
        detail = f'<span class="detail">{esc(row.detail)}</span>' if row.detail else ""
        items.append(
            f'<li class="{kind}"><span class="mark" role="img" aria-label="{words}">{mark}</span>'
            f"<span>{esc(row.text)}</span>{detail}</li>"
        )
    return _section("relations", "Relations", f'<ul class="relations">{"".join(items)}</ul>')


def steps(rows: Sequence[StepRow]) -> str:
    """The history, step by step."""
    if not rows:
        return ""
    items = []
    before: Mapping[str, float] = {}
    for row in rows:
        picture = ""
        if row.picture is not None:
            url = picture_url(row.picture, 440, 80)
            size = f'width="{row.picture.width}" height="{row.picture.height}"'
            picture = f'<img src="{url}" alt="After step {row.number}" {size}>'
        state = ("good", "accepted") if row.accepted else ("bad", "rolled back")
        note = f'<p class="aside">{esc(row.note)}</p>' if row.note else ""
        items.append(
            f'<li class="{"" if row.accepted else "undone"}"><div class="step-text"><div class="step-head">'
            f'<b class="step-number">{esc(row.number)}</b><h3>{esc(row.tool)}</h3>'
            f'<span class="tag {state[0]}">{state[1]}</span><span class="seconds">{row.seconds:.1f} s</span></div>'
            f"<p>{esc(row.instruction)}</p>{note}{thought(row.thought)}{_change(before, row.grades)}</div>"
            f"{picture}</li>"
        )
        if row.accepted and row.grades:
            before = row.grades
    return _section("steps", "Steps", f'<ol class="steps">{"".join(items)}</ol>')


def _change(before: Mapping[str, float], after: Mapping[str, float]) -> str:
    """Grades before and after a step."""
    cells = []
    for name, grade in after.items():
        old = before.get(name)
        tone = "" if old is None or abs(grade - old) < 0.05 else "good" if grade > old else "bad"
        was = "" if old is None else f"<s>{old:.1f}</s> "
        cells.append(f'<li class="{tone}"><span>{esc(name.replace("_", " "))}</span> {was}<b>{grade:.1f}</b></li>')
    return f'<ul class="change">{"".join(cells)}</ul>' if cells else ""


def _section(element_id: str, title: str, body: str) -> str:
    heading = f'<h2 id="{element_id}-title">{title}</h2>'
    return f'<section id="{element_id}" aria-labelledby="{element_id}-title">{heading}{body}</section>'


def columns(parts: Iterable[str]) -> str:
    """Short sections side by side where there is room."""
    kept = "".join(part for part in parts if part)
    return f'<div class="columns">{kept}</div>' if kept else ""
