"""Rows of the design rules: what they name exists, and what cannot be read is refused."""

from __future__ import annotations

import ast
import re
import string
from importlib import resources

import pytest

import sceneweaver.critic.review  # noqa: F401 - registers all measures
from sceneweaver.critic.design.query import Member, kind_set
from sceneweaver.critic.design.registry import MEASURES
from sceneweaver.critic.design.world import SELECTORS
from sceneweaver.rules import design
from sceneweaver.rules.design import Row, design_rules
from sceneweaver.rules.expression import _FUNCTIONS, CALLED, Expression
from sceneweaver.rules.faults import fault_kinds

ROWS = [(rule.id, row) for rule in (*design_rules().values(), *fault_kinds().values()) for row in rule.rows]


def texts(row: Row) -> list[str]:
    """The expressions of a row."""
    found = [row.where, row.measure, row.low, row.high, row.slack, row.measured, row.weight, *row.let.values()]
    found += [row.points, row.grave]
    for name, text in row.of.items() if not isinstance(row.of, str) else ():
        if name != "from":
            member = Member.parse(name, text)
            found += [member.source, member.where, member.key, member.distance]
    several = [{"True": t} if isinstance(t, str) else t for t in (row.text, row.mend)]
    templates = [t for one in several for t in one.values()]
    fields = [f for t in templates for _, f, _, _ in string.Formatter().parse(t) if f is not None]
    fields += [condition for one in several for condition in one if condition != "else"]
    return [e.text for e in found if e is not None and isinstance(e.text, str)] + [*fields, *row.objects]


@pytest.mark.parametrize(("rule", "row"), [r for r in ROWS if r[1].text])
def test_what_a_row_of_the_critic_names_exists(rule: str, row: Row) -> None:
    named = row.of if isinstance(row.of, str) else row.of.get("from", "")
    assert not named or named in SELECTORS, rule
    for text in texts(row):
        calls = {n.func.id + CALLED for n in ast.walk(ast.parse(text.strip(), mode="eval")) if isinstance(n, ast.Call)}
        assert calls <= {name + CALLED for name in MEASURES} | set(_FUNCTIONS), (rule, text)


def test_every_measure_is_called_by_a_row_and_says_what_it_measures() -> None:
    folders = (resources.files(design.__package__ or "") / name for name in ("design", "faults"))
    files = [file for folder in folders for file in folder.iterdir()]
    rows = "".join(file.read_text("utf-8") for file in files if file.name.endswith(".yaml"))
    assert [name for name in MEASURES if not re.search(rf"\b{name}\(", rows)] == []
    assert [name for name, function in MEASURES.items() if not function.__doc__] == []


@pytest.mark.parametrize("row", [{"of": "door", "hgih": 1}, {"of": "door", "measured": False}, {"if": "x.__class__"}])
def test_rows_that_cannot_be_read_are_refused(row: dict) -> None:
    with pytest.raises(ValueError):
        design.read_row("a_rule", row)


def test_sets_of_categories() -> None:
    assert "sectional_sofa" in kind_set("sofa") and "sectional_sofa" not in kind_set("sofa -=sectional_sofa")
    assert "sofa" not in kind_set("-sofa") and "desk" in kind_set("-sofa")
    with pytest.raises(ValueError, match="no role"):
        kind_set("=soffa")


def test_functions_and_numbers_may_have_one_name() -> None:
    assert Expression("gap(2) < gap").value({"gap()": lambda x: x, "gap": 3}) is True


def test_expressions_go_through_lists() -> None:
    scope = {"gap()": lambda a, b: abs(a - b), "reach": 2, "all": (1, 2, 5)}
    assert Expression("[o for o in all if gap(o, 0) <= reach]").value(scope) == [1, 2]
    assert Expression("sum(gap(o, all[0]) * k for o, k in zip(all, (1, 1, 2)))").value(scope) == 9
    assert Expression("max(o for o in all) > reach").names == {"all", "reach"}


def test_members_are_cut_outside_of_brackets() -> None:
    member = Member.parse("near*", "= [o for o in all if o > 1] if near < 5 by -near")
    assert member.source is not None and member.where is not None and member.key is not None
    assert member.source.value({"all": (1, 2, 5)}) == [2, 5]
    assert member.where.value({"near": 2}) and member.key.value({"near": 2}) == -2
