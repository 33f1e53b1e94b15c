"""Numbers of data files: plain ones, or arithmetic over named quantities such as ``band / 2 * width``."""

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
)  # fmt: skip
_FUNCTIONS = {"min": min, "max": max, "round": round, "sqrt": math.sqrt, "inf": math.inf, "__builtins__": {}}


class Expression:
    """A number of a data file.

    Args:
        text: a number, or arithmetic (``+ - * /``, ``min``, ``max``, ``round``, ``sqrt``) over names, with a number
            in brackets for an end of a range: ``gap[1]``.

    Raises:
        ValueError: when the text has anything else in it.
    """

    __slots__ = ("_code", "names", "text")

    def __init__(self, text: str | float) -> None:
        self.text = text
        self._code: CodeType | None = None
        self.names: frozenset[str] = frozenset()
        if isinstance(text, str):
            self._code, self.names = _parsed(text)

    def value(self, scope: Mapping[str, Any]) -> Any:
        """The number, with the names looked up in ``scope``."""
        return self.text if self._code is None else eval(self._code, _FUNCTIONS, scope)  # noqa: S307 (nodes checked)

    def __repr__(self) -> str:
        return str(self.text)


@cache
def _parsed(text: str) -> tuple[CodeType, frozenset[str]]:
    tree = ast.parse(text, mode="eval")
    for node in ast.walk(tree):
        if not isinstance(node, _NODES):
            raise ValueError(f"{text!r}: only arithmetic over names can stand here, no {type(node).__name__}")
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} - set(_FUNCTIONS)
    return compile(tree, "<rule>", "eval"), frozenset(names)
