"""Models of pydantic: their fields become a list of attributes, with the text of ``Field(description=...)``."""

from __future__ import annotations

import ast
from typing import Any

from griffe import Class, Docstring, Extension

PLAIN = {"schema_"}  # fields that nobody reads in Python


class FieldTexts(Extension):
    """Moves the fields of a model into its docstring, as other classes have them."""

    def on_class_members(self, *, node: Any, cls: Class, **_: Any) -> None:
        """List what is written ``name: type`` or ``name: type = Field(description=...)``."""
        if not cls.docstring or not any("Field" in ast.dump(part) for part in getattr(node, "body", ())):
            return
        lines = []
        for part in node.body:
            if not isinstance(part, ast.AnnAssign) or not isinstance(part.target, ast.Name):
                continue
            name = part.target.id
            if name in cls.members:
                cls.del_member(name)
            if not name.startswith("_") and name not in PLAIN:
                lines.append(f"    {name} ({ast.unparse(plain(part.annotation))}): {text_of(part.value) or '-'}")
        cls.docstring = Docstring(before_examples(cls.docstring.value, ["Attributes:", *lines]), parent=cls)


def plain(annotation: ast.expr) -> ast.expr:
    """``Annotated[type, ...]`` as the type alone, at any depth."""
    inner = annotation.slice if isinstance(annotation, ast.Subscript) else None
    if isinstance(inner, ast.Tuple) and getattr(annotation.value, "id", "") == "Annotated":
        return inner.elts[0]
    if isinstance(annotation, ast.BinOp):
        return ast.BinOp(plain(annotation.left), annotation.op, plain(annotation.right))
    return annotation


def text_of(value: ast.expr | None) -> str:
    """The description in a call of ``Field``; "" without one."""
    for keyword in getattr(value, "keywords", ()):
        if keyword.arg == "description" and isinstance(keyword.value, ast.Constant):
            return str(keyword.value.value)
    return ""


def before_examples(text: str, lines: list[str]) -> str:
    """A docstring with a section put in front of its examples."""
    head, mark, tail = text.partition("\nExamples:\n")
    return "\n".join([head.rstrip(), "", *lines, mark + tail])
