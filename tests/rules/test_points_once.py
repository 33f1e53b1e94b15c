"""Limits and lids of the kinds of faults stand in `rules/faults.yaml` alone."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import sceneweaver as sw
from sceneweaver.critic.model import CRITERIA
from sceneweaver.rules.design import design_rules
from sceneweaver.rules.faults import fault_kind, fault_kinds

CHECKS = "facing belonging needs order rows space sizes access finish physical review"


def calls(source: str) -> list[ast.Call]:
    """The calls that make a finding."""
    found = (n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.Call) and isinstance(n.func, ast.Name))
    return [n for n in found if isinstance(n.func, ast.Name) and n.func.id == "finding"]


def said_again(source: str) -> list[int]:
    """Lines where a lid is a number of the call's own, or points are though the row of the kind has them."""
    lines = []
    for call in calls(source):
        kind = call.args[1].value if isinstance(call.args[1], ast.Constant) else ""
        named = {k.arg for k in call.keywords}
        if "cap" in named or ("points" in named and fault_kind(str(kind)).points is not None):
            lines.append(call.lineno)
    return lines


@pytest.mark.parametrize("name", CHECKS.split())
def test_no_check_has_lids_or_points_that_a_row_has(name):
    source = (Path(sw.__file__).parent / "critic" / f"{name}.py").read_text("utf-8")
    assert said_again(source) == []
    kinds = {c.args[1].value for c in calls(source) if isinstance(c.args[1], ast.Constant)}
    assert kinds <= set(fault_kinds())


def test_what_is_said_again_is_found():
    assert said_again('finding("layout", "off_centre", (), "x", points=0.7)') == [1]
    assert said_again('finding("layout", "askew", (), "x", cap=5.0)') == [1]


def test_rows_are_no_design_rules_and_lower_known_grades():
    rows = {name: row for name, row in fault_kinds().items() if name != "default"}
    assert not set(rows) & set(design_rules())
    assert all(row.criteria and set(row.criteria) <= set(CRITERIA) for row in rows.values())
    assert all(row.most > 0 and (row.lid is None or 0 < row.lid < 10) for row in rows.values())
