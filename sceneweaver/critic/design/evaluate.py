"""Findings of rows: of the design rules, and of the kinds of faults beside them."""

from __future__ import annotations

import math
import string
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sceneweaver.rules.design import DesignRule, Row, design_rules
from sceneweaver.rules.expression import Expression
from sceneweaver.rules.faults import fault_kinds
from sceneweaver.verify.solids import Body, Opening

from ..grade import Finding, finding
from ..survey import Survey
from .breach import breach
from .query import Case, cases, listed
from .world import Surveyed

NAMED = 3
"""Objects of a list that a text names one by one."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Every breach of a design rule that is for this kind of room."""
    world, room = Surveyed(survey), survey.room_type.name
    for rule in design_rules().values():
        for row in rule.rows if rule.applies(room) else ():
            if row.text and row.applies(room):
                yield from _findings(world, rule, row)


def other_faults(survey: Survey) -> Iterator[Finding]:
    """Every fault of the kinds beside the design rules; of a room without objects only those that are for it."""
    world = Surveyed(survey)
    for kind in fault_kinds().values():
        for row in kind.rows if survey.bodies or kind.empty else ():
            for case, *_ in _broken(world, row, kind.limits) if row.text else ():
                for criterion in (row.criterion,) if row.criterion else kind.criteria:
                    yield finding(
                        criterion,
                        kind.id,
                        _ids(case, row.objects),
                        filled(row.text, case),
                        filled(row.mend, case),
                        points=None if row.points is None else float(row.points.value(case)),
                        grave=row.grave is not None and bool(row.grave.value(case)),
                        call=_call(row.call, case),
                    )


def _broken(world: Surveyed, row: Row, limits: Mapping[str, Any]) -> Iterator[tuple[Case, Any, Any, Any]]:
    """The cases in which a row is broken, with the ends of its interval and the value that is not in it."""
    for case in cases(world, row.of, limits):
        for name, expression in row.let.items():
            case[name] = expression.value(case)
        if row.where is not None and not row.where.value(case):
            continue
        low, high, value = _number(row.low, case), _number(row.high, case), None
        if row.measure is not None:
            value = row.measure.value(case)
            slack = float(row.slack.value(case))
            if value is None or (-math.inf if low is None else low - slack) <= value <= (
                math.inf if high is None else high + slack
            ):
                continue
        ends = {name: end for name, end in (("low", low), ("high", high)) if end is not None}
        case.update(ends, value=value)
        yield case, low, high, value


def _findings(world: Surveyed, rule: DesignRule, row: Row) -> Iterator[Finding]:
    """The findings of one row of a design rule."""
    for case, low, high, value in _broken(world, row, rule.limits):
        measured = value if row.measured is None else row.measured.value(case)
        allowed = (low, high) if row.allowed is None else tuple(_number(end, case) for end in row.allowed)
        yield breach(
            rule.id,
            _ids(case, row.objects),
            filled(row.text, case),
            measured=None if measured is None else float(measured),
            allowed=None if allowed == (None, None) else (allowed[0], allowed[1]),
            weight=float(row.weight.value(case)),
            suggestion=filled(row.mend, case),
            call=_call(row.call, case),
        )


def _number(expression: Expression | None, case: Case) -> float | None:
    value = None if expression is None else expression.value(case)
    return None if value is None else float(value)


def _ids(case: Case, names: Iterable[str]) -> list[str]:
    """The ids of what some expressions name, each once."""
    found: dict[str, None] = {}
    for name in names:
        value = Expression(name).value(case)
        found.update((_id(one), None) for one in listed(value) if one is not None)
    return list(found)


def _id(one: Any) -> str:
    return one.id if isinstance(one, Body) else one.item.id if isinstance(one, Opening) else one


def filled(template: str | Mapping[str, str], case: Mapping[str, Any]) -> str:
    """A template with the values of the expressions in its braces; of lists of objects the ids of the first few.

    Of several templates by condition the first whose condition holds; "else" always does.
    """
    if not isinstance(template, str):
        template = next(
            t for condition, t in template.items() if condition == "else" or Expression(condition).value(case)
        )
    parts = []
    for text, name, spec, _ in string.Formatter().parse(template):
        parts.append(text)
        if name is not None:
            parts.append(_said(Expression(name).value(case), spec or ""))
    return "".join(parts)


def _said(value: Any, spec: str) -> str:
    if value is None:
        return "the wall"
    if isinstance(value, (Body, Opening)):
        return _id(value)
    if isinstance(value, (tuple, list)):
        ids = ["the wall" if one is None else _id(one) for one in value]
        return ", ".join(ids[:NAMED]) + (f" and {len(ids) - NAMED} more" if len(ids) > NAMED else "")
    return format(value, spec)


def _call(template: Mapping[str, Any] | None, case: Case) -> tuple[str, dict[str, Any]] | None:
    """The call of a tool; none where its condition does not hold."""
    if template is None or ("if" in template and not Expression(template["if"]).value(case)):
        return None
    inputs = {k: _input(v, case) for k, v in template.items() if k not in ("tool", "if")}
    return _input(template["tool"], case), {k: v for k, v in inputs.items() if v is not None}


def _input(template: Any, case: Case) -> Any:
    """Inputs of a tool, where ``= x`` stands for the value of an expression: of objects their ids.

    An item of a list with ``each: {name: x}`` stands for one item for each value of the expression.
    """
    if isinstance(template, dict):
        return {k: _input(v, case) for k, v in template.items()}
    if isinstance(template, list):
        return [made for v in template for made in _items(v, case)]
    if not isinstance(template, str) or not template.startswith("= "):
        return template
    value = Expression(template[2:]).value(case)
    if isinstance(value, (Body, Opening)):
        return _id(value)
    return [_id(one) for one in value] if isinstance(value, (tuple, list)) else value


def _items(template: Any, case: Case) -> Iterator[Any]:
    """What an item of a list of inputs stands for."""
    each = template.get("each") if isinstance(template, dict) else None
    if each is None:
        yield _input(template, case)
        return
    rest = {k: v for k, v in template.items() if k != "each"}
    for name, text in each.items():
        for one in Expression(text).value(case):
            yield _input(rest, {**case, name: one})
