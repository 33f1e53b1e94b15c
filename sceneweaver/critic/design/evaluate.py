"""Findings of the rows of the design rules."""

from __future__ import annotations

import math
import string
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sceneweaver.rules.design import DesignRule, Row, design_rules
from sceneweaver.rules.expression import Expression
from sceneweaver.verify.solids import Body, Opening

from ..grade import Finding
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


def _findings(world: Surveyed, rule: DesignRule, row: Row) -> Iterator[Finding]:
    """The findings of one row."""
    for case in cases(world, row.of, rule.limits):
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
    return one if isinstance(one, str) else one.id if isinstance(one, Body) else one.item.id


def filled(template: str, case: Mapping[str, Any]) -> str:
    """A template with the values of the expressions in its braces; of lists of objects the ids of the first few."""
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
    return template["tool"], {k: _input(v, case) for k, v in template.items() if k not in ("tool", "if")}


def _input(template: Any, case: Case) -> Any:
    """Inputs of a tool, where ``= x`` stands for the value of an expression: of objects their ids."""
    if isinstance(template, dict):
        return {k: _input(v, case) for k, v in template.items()}
    if isinstance(template, list):
        return [_input(v, case) for v in template]
    if not isinstance(template, str) or not template.startswith("= "):
        return template
    value = Expression(template[2:]).value(case)
    if isinstance(value, (Body, Opening)):
        return _id(value)
    return [_id(one) for one in value] if isinstance(value, (tuple, list)) else value
