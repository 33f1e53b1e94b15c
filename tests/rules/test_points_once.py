"""What faults cost, their numbers and their texts stand in rows, each once, and none of them in Python."""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

import sceneweaver as sw
from sceneweaver.critic.design.query import Member
from sceneweaver.critic.model import CRITERIA
from sceneweaver.rules import faults
from sceneweaver.rules.design import Row, design_rules
from sceneweaver.rules.expression import Expression
from sceneweaver.rules.faults import FaultKind, fault_kinds

ROOT = Path(sw.__file__).parent
CHECKS = sorted((ROOT / "critic" / "checks").glob("*.py"))
READERS = [*sorted((ROOT / "critic").glob("*.py")), *CHECKS, *sorted((ROOT / "agent").glob("choice*.py"))]
SCALES = {"grade.py": {5.0, 0.2}, "model.py": {10.0}, "space.py": {0.06}, "totals.py": {0.75}}
"""Numbers that are no fault's: how grades follow from points, cells of a grid, an exponent of a measure."""

PLAIN = {0.0, 0.5, 1.0, 2.0, 90.0, 100.0}
"""Numbers of arithmetic: halves, quarter turns, centimetres."""

ENDS = ("points", "low", "high", "slack", "span", "grave", "params")
"""Fields of rows that are a number, or say one of several; in all others numbers have names."""


def constants(tree: ast.AST) -> Iterator[ast.Constant]:
    docs = {id(n.value) for n in ast.walk(tree) if isinstance(n, ast.Expr)}
    yield from (n for n in ast.walk(tree) if isinstance(n, ast.Constant) and id(n) not in docs)


def numbers_in_code(source: str, known: Iterable[float] = ()) -> list[tuple[int, float]]:
    """Numbers that are neither arithmetic nor tolerances of it; whole numbers in code count and index."""
    found = (n for n in constants(ast.parse(source)) if isinstance(n.value, float))
    return [(n.lineno, n.value) for n in found if n.value > 1e-3 and n.value not in {*PLAIN, 180.0, 360.0, *known}]


def costs_in_code(source: str) -> list[int]:
    """Lines where a call has points, a lid or how grave a fault is as a number of its own."""
    calls = (n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.Call))
    given = (k for call in calls for k in call.keywords if k.arg in ("points", "cap", "lid", "weight", "share"))
    return [
        k.value.lineno for k in given if isinstance(k.value, ast.Constant) and isinstance(k.value.value, int | float)
    ]


def sentences(source: str) -> list[str]:
    """Texts in code that are more than a word; messages of errors are none of faults."""
    return [n.value for n in constants(ast.parse(source)) if isinstance(n.value, str) and " " in n.value.strip()]


@pytest.mark.parametrize("path", READERS, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_no_number_or_cost_of_a_fault_is_in_code(path):
    source = path.read_text("utf-8")
    assert numbers_in_code(source, SCALES.get(path.name, ())) == []
    assert costs_in_code(source) == []


@pytest.mark.parametrize("path", CHECKS, ids=lambda path: path.name)
def test_no_text_of_a_fault_is_in_a_check(path):
    assert sentences(path.read_text("utf-8")) in ([], ["listed elsewhere"])  # a name that a row asks for


def test_what_is_in_code_is_found():
    assert numbers_in_code("GAP = 0.15\nif math.degrees(turn) > 35.0 * 2.0: pass") == [(1, 0.15), (2, 35.0)]
    assert costs_in_code('finding("layout", "off_centre", (), "x", points=1)') == [1]
    assert sentences('"""A check."""\nfinding("layout", f"{a} hangs low")') == [" hangs low"]


# ---- rows ------------------------------------------------------------------------------------------------------------

KINDS = [kind for kind in fault_kinds().values() if kind.rows]


def inputs(value: Any) -> Iterator[str]:
    """The expressions in the inputs of a tool."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from one.values() if key == "each" else inputs(one)
    elif isinstance(value, list):
        for one in value:
            yield from inputs(one)
    elif isinstance(value, str) and value.startswith("= "):
        yield value[2:]


def expressions(row: Row, ends: bool) -> list[Expression]:
    """The expressions of a row: of the fields that are numbers, or of all others."""
    if ends:
        values = [getattr(row, name) for name in ENDS if name != "params"]
        return [e for e in (*values, *row.params.values()) if e is not None]
    found = [row.where, row.measure, *row.let.values(), *map(Expression, row.objects)]
    for name, text in row.of.items() if not isinstance(row.of, str) else ():
        if name != "from":
            member = Member.parse(name, text)
            found += [member.source, member.distance, member.where, member.key]
    several = [{"else": t} if isinstance(t, str) else t for t in (row.text, row.mend)]
    found += [Expression(c) for one in several for c in one if c != "else"]
    parsed = (string.Formatter().parse(t) for one in several for t in one.values())
    found += [Expression(field) for parts in parsed for _, field, _, _ in parts if field is not None]
    return [e for e in (*found, *map(Expression, inputs(row.call))) if e is not None]


def numbers(expression: Expression) -> set[float]:
    if not isinstance(expression.text, str):
        return {abs(float(expression.text))} if expression.text is not None else set()
    tree = ast.parse(f"x = {expression.text.strip()}")
    calls = (n for n in ast.walk(tree) if isinstance(n, ast.Call) and isinstance(n.func, ast.Name))
    digits = {id(arg) for call in calls if call.func.id == "round" for arg in call.args[1:]}  # type: ignore[union-attr]
    found = (n for n in constants(tree) if id(n) not in digits)
    return {abs(float(n.value)) for n in found if isinstance(n.value, int | float)}


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.id)
def test_numbers_of_rows_have_names(kind: FaultKind):
    """What is compared and measured with is a limit of the kind or a number that kinds share, so it stands once."""
    for row in kind.rows:
        for expression in expressions(row, ends=False):
            assert numbers(expression) <= PLAIN, expression


def test_no_number_is_shadowed_and_none_is_left_over():
    shared = set(faults._shared()["numbers"])
    code = "".join(path.read_text("utf-8") for path in (*READERS, *(ROOT / "critic" / "design").glob("*.py")))
    code += (ROOT / "agent" / "planned.py").read_text("utf-8")
    unused = shared - set(re.findall(r'"(\w+)"', code))
    for kind in KINDS:
        own = set(kind.limits) - shared
        used = {
            name for row in kind.rows for e in (*expressions(row, True), *expressions(row, False)) for name in e.names
        }
        assert all(kind.limits[name] == faults.number(name) for name in shared), kind.id
        looked_up = set(re.findall(r'"(\w+)"', code)) | {"sparse", "normal", "full"}  # the densities of requests
        assert own <= used | looked_up, kind.id
        unused -= used
    assert not unused


def test_kinds_are_no_design_rules_and_lower_known_grades():
    rows = fault_kinds()
    assert not set(rows) & set(design_rules())
    for kind in rows.values():
        assert kind.criteria and set(kind.criteria) <= set(CRITERIA), kind.id
        assert kind.most > 0 and (kind.lid is None or 0 < kind.lid < 10), kind.id
        for row in kind.rows:
            assert row.criterion in ("", *kind.criteria) and (row.points is None) is (kind.points is not None), kind.id
            assert row.grave is None or kind.lid is not None, kind.id


def test_a_kind_that_is_not_known_or_has_another_field_is_refused(tmp_path, monkeypatch):
    assert faults.fault_kind("of my own").most == 3.0
    (tmp_path / "faults").mkdir()
    (tmp_path / "faults.yaml").write_text("{most: 3.0, numbers: {}}")
    (tmp_path / "faults" / "mine.yaml").write_text("[{id: mine, criteria: [layout], pionts: 1.0}]")
    monkeypatch.setattr(faults.resources, "files", lambda _: tmp_path)
    with pytest.raises(ValueError, match="pionts"):
        faults.fault_kinds.__wrapped__()
