"""Numbers and conditions of data files: plain ones, or arithmetic and comparisons over named quantities and measures.

``0.1``, ``band / 2 * width``, ``count(seats) >= 3 and gap(table, sofa) < 0.3``.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping
from functools import cache
from types import CodeType
from typing import Any

_NODES = (
    ast.Expression, ast.BinOp, ast.UnaryOp, ast.Constant, ast.Name, ast.Load, ast.Call, ast.Subscript,
    ast.Add, ast.Sub, ast.Mult, ast.Div, ast.USub,
    ast.BoolOp, ast.And, ast.Or, ast.Not, ast.IfExp, ast.keyword,
    ast.Compare, ast.Lt, ast.LtE, ast.Gt, ast.GtE, ast.Eq, ast.NotEq, ast.In, ast.NotIn, ast.Is, ast.IsNot,
)  # fmt: skip
_FUNCTIONS: dict[str, Any] = {
    "min": min,
    "max": max,
    "round": round,
    "abs": abs,
    "sqrt": math.sqrt,
    "inf": math.inf,
    "__builtins__": {},
}


CALLED = "()"
"""What follows the name of a function in the scope that an expression is looked up in."""


class Expression:
    """A number, a truth value or a text of a data file.

    Args:
        text: a number, or arithmetic (``+ - * /``, ``min``, ``max``, ``round``, ``abs``, ``sqrt``), comparisons and
            ``and``, ``or``, ``not``, ``x if y else z`` over names and calls of named functions, with a number in
            brackets for an end of a range: ``gap[1]``.

    Raises:
        ValueError: when the text has anything else in it.
    """

    __slots__ = ("_code", "names", "text")

    def __init__(self, text: str | float) -> None:
        if isinstance(text, bool):
            raise ValueError("a bare on, off, yes or no of YAML is a truth value: write it in quotes")
        self.text = text
        self._code: CodeType | None = None
        self.names: frozenset[str] = frozenset()
        if isinstance(text, str):
            self._code, self.names = _parsed(text)

    def value(self, scope: Mapping[str, Any]) -> Any:
        """The number, with the names looked up in ``scope``."""
        if self._code is None:
            return self.text
        try:
            return eval(self._code, _FUNCTIONS, scope)  # noqa: S307 (nodes checked)
        except Exception as error:
            error.add_note(f"in {self.text!r}")
            raise

    def call(self) -> tuple[str, tuple[str, ...]]:
        """The function that the text calls, and the names that it is called with.

        Raises:
            ValueError: when the text is no such call.
        """
        tree = ast.parse(str(self.text), mode="eval").body
        if not isinstance(tree, ast.Call) or not isinstance(tree.func, ast.Name):
            raise ValueError(f"{self.text!r}: one call of a measure is meant")
        return tree.func.id, tuple(a.id for a in tree.args if isinstance(a, ast.Name))

    def __repr__(self) -> str:
        return str(self.text)


@cache
def _parsed(text: str) -> tuple[CodeType, frozenset[str]]:
    tree = ast.parse(text, mode="eval")
    for node in ast.walk(tree):
        if not isinstance(node, _NODES):
            raise ValueError(f"{text!r}: {type(node).__name__} cannot stand here")
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id not in _FUNCTIONS:
            node.func.id += CALLED  # a measure and a number may have one name
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} - set(_FUNCTIONS)
    names = {name for name in names if not name.endswith(CALLED)}
    return compile(tree, "<rule>", "eval"), frozenset(names)
