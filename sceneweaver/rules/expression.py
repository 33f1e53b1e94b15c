"""Numbers and conditions of data files: plain ones, or arithmetic over named things such as ``half * band``.

An expression may call functions of its scope, ``gap(sofa, table) < reach``, and go through the things of a list,
``all(gap(sofa, t) < reach for t in tables)``.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping
from functools import cache
from types import CodeType
from typing import Any

_NODES = (
    (ast.Expression, ast.Constant, ast.Name, ast.Load, ast.Attribute, ast.Subscript, ast.Call, ast.Tuple)
    + (ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.UnaryOp, ast.USub, ast.Not)
    + (ast.BoolOp, ast.And, ast.Or, ast.Compare, ast.Eq, ast.NotEq, ast.Lt, ast.LtE, ast.Gt, ast.GtE)
    + (ast.Is, ast.IsNot, ast.In, ast.NotIn, ast.IfExp, ast.keyword, ast.Slice, ast.List, ast.Starred)
    + (ast.GeneratorExp, ast.ListComp, ast.SetComp, ast.comprehension, ast.Store)
)

CALLED = "()"
"""What follows the name of a function in a scope, so that a function and a number may have one name."""

_PLAIN = (min, max, round, abs, sum, any, all, sorted, zip, math.sqrt, math.hypot)
_FUNCTIONS: dict[str, Any] = {f.__name__ + CALLED: f for f in _PLAIN}
_FUNCTIONS.update({"count" + CALLED: len, "inf": math.inf, "__builtins__": {}})


class Expression:
    """A number, a condition or a pair of numbers of a data file.

    Args:
        text: a value, or in words an expression over names: arithmetic, comparisons, ``and``, ``or``, ``not``,
            ``min``, ``max``, ``sum``, ``any``, ``all``, ``sorted``, ``zip``, ``count``, ``round``, ``abs``, ``sqrt``,
            ``hypot``, ``inf``, public attributes, brackets for parts of a list, comprehensions, and calls of functions
            of the scope.

    Raises:
        ValueError: when the text has anything else in it.
    """

    __slots__ = ("_code", "_nested", "names", "text")

    def __init__(self, text: str | float | None) -> None:
        self.text = text
        self._code: CodeType | None = None
        self._nested = False
        self.names: frozenset[str] = frozenset()
        if isinstance(text, str):
            self._code, self.names, self._nested = _parsed(text)

    def value(self, scope: Mapping[str, Any]) -> Any:
        """What it is where the names mean what ``scope`` says."""
        if self._code is None:
            return self.text
        try:
            # The inside of a comprehension sees globals alone, so there the scope goes among them.
            if self._nested:
                return eval(self._code, {**_FUNCTIONS, **scope})  # its nodes are checked
            return eval(self._code, _FUNCTIONS, scope)
        except Exception as error:
            error.add_note(f"in the expression {self.text!r} of a rule")
            raise

    def __repr__(self) -> str:
        return str(self.text)


@cache
def _parsed(text: str) -> tuple[CodeType, frozenset[str], bool]:
    """The code of an expression, the names that it needs, and whether it has a comprehension."""
    tree = ast.parse(text.strip(), mode="eval")
    for node in ast.walk(tree):
        private = isinstance(node, ast.Attribute) and node.attr.startswith("_")
        called = isinstance(node, ast.Call) and not isinstance(node.func, ast.Name)
        if private or called or not isinstance(node, _NODES):
            raise ValueError(f"{text!r}: only arithmetic and comparisons can stand here, no {type(node).__name__}")
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            node.func.id += CALLED
    named = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    own = {node.id for node in named if isinstance(node.ctx, ast.Store)}
    names = {node.id for node in named if not node.id.endswith(CALLED)} - own - set(_FUNCTIONS)
    return compile(tree, "<rule>", "eval"), frozenset(names), bool(own)
