"""What the page says of a language model: who did what, why, and what it cost."""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.report import RankedCall, ReportData, StepRow, ThoughtRow, report_html
from tests.report.scenes import HOSTILE, furnished, load
from tests.report.test_report import Page

USAGE = {"asks": 3, "calls": 4, "failed": 1, "tokens_in": 900, "tokens_out": 80, "seconds": 2.5, "cost": 0.0123}
MODELS = {
    "name": f"openai:m{HOSTILE}",
    "roles": {"planner": "llm", "reader": "llm", "critic": "symbolic", "samples": 1},
    "planned": ["openai:m", "rules", "openai:m"],
    "read": "openai:m",
    "lost": f"the limit of 4 calls is reached {HOSTILE}",
    "disagreements": [f"bed, count: 2 offline, 1 by the model {HOSTILE}"],
    "usage": {**USAGE, "currency": "EUR", "by_purpose": {"plan": USAGE}},
}
THOUGHT = ThoughtRow(
    by=f"openai:m{HOSTILE}",
    problem=f"the shelf is bare {HOSTILE}",
    ranked=(RankedCall("add_crowd", 0.8, f"fill it {HOSTILE}", "grade 6.10, 0 violations"),),
)


def test_who_planned_read_and_what_it_cost():
    step = StepRow(1, "add_crowd", "fill it", True, 1.0, thought=THOUGHT)
    data = ReportData(furnished(), {"models": MODELS}, steps=(step,), load=load)
    page = Page(report_html(data))
    for text in (
        "2 of 3 steps were planned by openai:m",
        "steps 2 by rules",
        "the limit of 4 calls is reached",
        "bed, count: 2 offline, 1 by the model",
        "Cost EUR",
        "0.0123",
        "the shelf is bare",
        "add_crowd",
        "0.80",
        "grade 6.10",
    ):
        assert text in page.text, text
    assert not any("onerror" in attrs for _, attrs in page.tags)


def test_without_a_model_the_page_says_nothing_of_one():
    step = StepRow(1, "add_crowd", "fill it", True, 1.0)
    data = ReportData(furnished(), {}, steps=(step,), load=load)
    assert "Language model" not in report_html(data) and "Planned by" not in report_html(data)
    free = {**MODELS, "lost": None, "disagreements": [], "usage": {**USAGE, "cost": None}}
    text = Page(report_html(replace(data, metrics={"models": free}))).text
    assert "Cost" not in text and "was not asked to the end" not in text
