"""What the parts of the page under the 3D view show, for its template."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .data import ReportData, StepRow
from .facts import SOFT, RelationRow, ViolationRow
from .html import number

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

_SPENT = (
    ("asks", "Questions"),
    ("calls", "Requests"),
    ("failed", "Requests without a usable reply"),
    ("tokens_in", "Tokens in"),
    ("tokens_out", "Tokens out"),
    ("seconds", "Seconds of waiting"),
)

_MARKS = {
    True: ("held", "\u2713", "holds"),
    False: ("broken", "\u2717", "does not hold"),
    None: ("", "\u00b7", "not checked"),
}


def context(data: ReportData, faults: Sequence[ViolationRow], rows: Sequence[RelationRow]) -> dict[str, Any]:
    """All that the template asks for beside the request and the view."""
    metrics = data.metrics
    valid = metrics.get("valid") if isinstance(metrics.get("valid"), bool) else None
    hard = [fault for fault in faults if fault.kind not in SOFT]
    soft = [fault for fault in faults if fault.kind in SOFT]
    grades, critic = _grades(data)
    return {
        "metrics": metrics,
        "verdict": {True: ("good", "valid"), False: ("bad", "not valid"), None: ("unknown", "not checked")}[valid],
        "facts": _facts(data),
        "grades": grades,
        "critic": critic,
        "models": _models(metrics.get("models")),
        "violations": (("Violations", hard, "bad"), ("Wishes that do not hold", soft, "fair")),
        "has_findings": bool(faults or data.scene.dropped or data.unmet or data.warnings or data.notes),
        "pictures": _pictures(data),
        "steps": _steps(data.steps),
        "relations": sorted(rows, key=lambda row: row.held is not False),
        "marks": _MARKS,
        "measured": _measured(metrics),
        "more_measured": [
            *((f"Seconds, {k.replace('_', ' ')}", number(v, 3)) for k, v in (metrics.get("seconds") or {}).items()),
            *((f"Version of {name}", str(value)) for name, value in (metrics.get("versions") or {}).items()),
        ],
    }


def _facts(data: ReportData) -> list[tuple[str, str]]:
    """Key numbers, each with its name."""
    scene, metrics = data.scene, data.metrics
    relations = metrics.get("relations") or {}
    tallies = [relations.get(kind) or {} for kind in ("hard", "soft")]
    total, kept = (sum(int(t.get(key, 0)) for t in tallies) for key in ("total", "satisfied"))
    facts = [(str(len(scene.objects)), "object" if len(scene.objects) == 1 else "objects")]
    if scene.dropped:
        facts.append((str(len(scene.dropped)), "dropped"))
    if total:
        facts.append((f"{kept} / {total}", "relations hold"))
    took = sum(step.seconds for step in data.steps) or (metrics.get("seconds") or {}).get("total")
    if isinstance(took, int | float):
        shown = f"{took:.1f} s" if took >= 0.05 else f"{took * 1000:.0f} ms"
        facts.append((shown, "in all steps" if data.steps else "in all"))
    share = metrics.get("reachable_share")
    if isinstance(share, int | float):
        facts.append((f"{100 * share:.0f} %", "reachable"))
    return facts


def _grades(data: ReportData) -> tuple[dict[str, float], str]:
    """Grades by criterion and the critic that gave them: of the review, else of metrics.json."""
    if data.review is not None:
        return dict(data.review.grades), data.review.critic
    given = data.metrics.get("scores")
    if not isinstance(given, Mapping):
        return {}, ""
    numbers = {k: v for k, v in given.items() if isinstance(v, int | float) and not isinstance(v, bool)}
    return {k: float(v) for k, v in numbers.items() if k != "critic"}, str(given.get("critic", ""))


def _models(models: object) -> dict[str, Any] | None:
    """What a language model did in a design: who planned and read, where readers disagree, and what was spent."""
    if not isinstance(models, Mapping):
        return None
    planned = [str(who) for who in models.get("planned") or ()]
    by_rules = [k + 1 for k, who in enumerate(planned) if who == "rules"]
    facts = [f"The request was read by {models.get('read') or 'rules'}."]
    if (models.get("roles") or {}).get("planner") == "llm" and planned:
        rest = f"; steps {', '.join(map(str, by_rules))} by rules" if by_rules else ""
        count = len(planned) - len(by_rules)
        facts.append(f"{count} of {len(planned)} steps were planned by {models.get('name')}{rest}.")
    else:
        facts.append("All steps were planned by rules.")
    if models.get("lost"):
        facts.append(f"The model was not asked to the end: {models['lost']}")
    usage = models.get("usage") or {}
    columns = {"in all": usage, **(usage.get("by_purpose") or {})}
    counts = list(_SPENT)
    if usage.get("cost") is not None:
        counts.append(("cost", f"Cost {usage.get('currency') or ''}".rstrip()))
    return {
        "facts": facts,
        "apart": list(models.get("disagreements") or ()),
        "name": models.get("name"),
        "calls": usage.get("calls"),
        "columns": list(columns),
        "spent": [
            (name, [number(column.get(key), 4 if key == "cost" else 1) for column in columns.values()])
            for key, name in counts
        ],
    }


def _pictures(data: ReportData) -> list[tuple[str, str, Any]]:
    """Name, caption and picture of each, those with captions of their own first."""
    order = sorted(data.pictures, key=lambda name: (list(_CAPTIONS).index(name) if name in _CAPTIONS else 9, name))
    return [(name, _CAPTIONS.get(name, name.replace("_", " ")), data.pictures[name]) for name in order]


def _steps(rows: Sequence[StepRow]) -> list[tuple[StepRow, list[tuple[str, float | None, float, str]]]]:
    """Each step with its changes of grades: name, grade before and after, and tone."""
    found = []
    before: Mapping[str, float] = {}
    for row in rows:
        changes = []
        for name, grade in row.grades.items():
            old = before.get(name)
            tone = "" if old is None or abs(grade - old) < 0.05 else "good" if grade > old else "bad"
            changes.append((name, old, grade, tone))
        found.append((row, changes))
        if row.accepted and row.grades:
            before = row.grades
    return found


def _measured(metrics: Mapping[str, Any]) -> list[tuple[str, str]]:
    """The table of metrics.json."""
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
    return rows
