"""The design rules as data, the table of them in the docs, and how a breach becomes a fault."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from sceneweaver.critic.design.breach import breach
from sceneweaver.critic.grade import Finding, grades
from sceneweaver.rules.design import CRITERIA, DesignRule, design_rules, limit
from sceneweaver.rules.grades import TRAITS, Traits, grade_weights

PAGE = Path(__file__).resolve().parents[2] / "docs" / "design_rules.md"


def entry(rule: DesignRule) -> str:
    """What the docs say of a rule."""
    numbers = ", ".join(f"{name} {value:g}" for name, value in rule.limits.items())
    rooms = ", ".join(sorted(name.replace("_", " ") for name in rule.rooms)) or "all rooms"
    return f"- `{rule.id}` ({rule.criterion}; {numbers or 'no numbers'}; {rooms}): {rule.statement}"


def test_the_docs_have_every_rule_with_its_numbers() -> None:
    lines = PAGE.read_text("utf-8").partition("## All rules")[2].split("\n## ")[0]
    found = [" ".join(part.split()) for part in re.split(r"\n(?=- )", lines.strip()) if part.startswith("- ")]
    wanted = [entry(rule) for rule in design_rules().values()]
    assert found == wanted, "docs/design_rules.md should list:\n" + "\n".join(wanted)


def test_rules_are_plain_sentences_with_a_limit_to_what_they_cost() -> None:
    for rule in design_rules().values():
        assert rule.statement.endswith(".") and rule.most >= rule.points, rule.id


def test_a_limit_is_read_by_name() -> None:
    assert limit("door_frame", "gap") == design_rules()["door_frame"].limits["gap"]
    with pytest.raises(KeyError):
        limit("door_frame", "colour")


def test_a_breach_names_its_rule_and_costs_no_more_than_all_of_it_may() -> None:
    rule = design_rules()["door_frame"]
    found = [breach(rule.id, (f"bed-{k}",), "it is near", measured=0.1, allowed=(0.3, None)) for k in range(20)]
    assert found[0].fault.rule == rule.id and found[0].fault.criterion == rule.criterion
    assert (found[0].fault.measured, found[0].fault.allowed) == (0.1, (0.3, None))
    one, all_of_them = (_lost(found[:1], rule.criterion), _lost(found, rule.criterion))
    assert all_of_them / one == pytest.approx(rule.most / rule.points, rel=0.02)


def _lost(found: list[Finding], criterion: str) -> float:
    """Points that findings take off a grade, beside what only eyes can tell."""
    return 10.0 * math.log(grades([])[criterion] / grades(found)[criterion])


def test_every_grade_has_its_weights_and_none_rises_with_a_fault() -> None:
    weights = grade_weights()
    assert tuple(weights.criteria) == CRITERIA and set(weights.enough) == set(TRAITS)
    for row in weights.criteria.values():
        assert min(row.own_checks, row.other_checks, row.own_rules, row.other_rules) > 0.0
        assert set(row.short) == set(TRAITS) and min(row.short.values()) >= 0.0


def test_a_kind_of_room_of_which_less_is_known_is_graded_lower() -> None:
    most = grade_weights().enough
    full, bare = Traits(**most), Traits(**{name: 0.0 for name in TRAITS})
    assert grades([], traits=full) == grades([])
    assert all(grades([], traits=bare)[name] < 0.8 * grades([])[name] for name in CRITERIA)
