"""What a language model did in a design: who planned, read and graded, what it cost, and its thoughts at each step."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .data import ReportData, ThoughtRow
from .html import esc, number

_COUNTS = (
    ("asks", "Questions"),
    ("calls", "Requests"),
    ("failed", "Requests without a usable reply"),
    ("tokens_in", "Tokens in"),
    ("tokens_out", "Tokens out"),
    ("seconds", "Seconds of waiting"),
)


def section(data: ReportData) -> str:
    """Who did what, where the readers disagree, and what was spent; empty where no model was asked."""
    models = data.metrics.get("models")
    if not isinstance(models, Mapping):
        return ""
    planned = [str(who) for who in models.get("planned") or ()]
    by_rules = [k + 1 for k, who in enumerate(planned) if who == "rules"]
    roles = models.get("roles") or {}
    facts = [f"The request was read by {models.get('read') or 'rules'}."]
    if roles.get("planner") == "llm" and planned:
        rest = f"; steps {', '.join(map(str, by_rules))} by rules" if by_rules else ""
        facts.append(
            f"{len(planned) - len(by_rules)} of {len(planned)} steps were planned by {models.get('name')}{rest}."
        )
    else:
        facts.append("All steps were planned by rules.")
    if models.get("lost"):
        facts.append(f"The model was not asked to the end: {models['lost']}")
    rows = "".join(f"<li>{esc(row)}</li>" for row in models.get("disagreements") or ())
    apart = f"<h3>Where the readers disagree</h3><ul class='findings'>{rows}</ul>" if rows else ""
    return (
        '<section id="models" aria-labelledby="models-title"><h2 id="models-title">Language model</h2>'
        f"<p>{esc(' '.join(facts))}</p>{apart}{_spent(models)}</section>"
    )


def thought(row: ThoughtRow | None) -> str:
    """What the planner thought before a step, with the calls that it ranked."""
    if row is None:
        return ""
    said = [("Problem", row.problem), ("Last step", row.last_step), ("Solved", row.solved), ("Note", row.note)]
    lines = "".join(f"<p class='aside'><b>{name}:</b> {esc(text)}</p>" for name, text in said if text)
    items = "".join(
        f"<li><b>{esc(call.tool)}</b> {call.confidence:.2f} {esc(call.instruction)} <em>{esc(call.outcome)}</em></li>"
        for call in row.ranked
    )
    ranked = f"<ol class='findings'>{items}</ol>" if items else ""
    return f"<details class='thought'><summary>Planned by {esc(row.by)}</summary>{lines}{ranked}</details>"


def _spent(models: Mapping[str, Any]) -> str:
    usage = models.get("usage") or {}
    purposes = usage.get("by_purpose") or {}
    columns = [("in all", usage), *purposes.items()]
    counts = list(_COUNTS)
    if usage.get("cost") is not None:
        counts.append(("cost", f"Cost {usage.get('currency') or ''}".rstrip()))
    head = "".join(f"<th scope='col'>{esc(name)}</th>" for name, _ in columns)
    body = "".join(
        f"<tr><th scope='row'>{esc(name)}</th>"
        + "".join(f"<td>{_amount(key, column.get(key))}</td>" for _, column in columns)
        + "</tr>"
        for key, name in counts
    )
    return (
        f"<details><summary>{esc(models.get('name'))}: {number(usage.get('calls'))} requests</summary>"
        f'<table class="metrics"><thead><tr><td></td>{head}</tr></thead><tbody>{body}</tbody></table></details>'
    )


def _amount(key: str, value: object) -> str:
    return number(value, 4 if key == "cost" else 1)
