"""Models of pydantic: their fields become a list of attributes, with the text of ``Field(description=...)``.

They are also the arguments of the model, which its own ``__init__(**data)`` does not say.
"""

from __future__ import annotations

import ast
from typing import Any

from griffe import Class, Docstring, Extension, Function, Parameter, ParameterKind, Parameters, get_expression

PLAIN = {"schema_"}  # fields that nobody reads in Python


class FieldTexts(Extension):
    """Moves the fields of a model into its docstring, as other classes have them."""

    def on_class_members(self, *, node: Any, cls: Class, **_: Any) -> None:
        """List what is written ``name: type`` or ``name: type = Field(description=...)``."""
        if not cls.docstring or not any("Field" in ast.dump(part) for part in getattr(node, "body", ())):
            return
        lines, arguments = [], [Parameter("self", kind=ParameterKind.positional_or_keyword)]
        for part in node.body:
            if not isinstance(part, ast.AnnAssign) or not isinstance(part.target, ast.Name):
                continue
            name = part.target.id
            if name in cls.members:
                cls.del_member(name)
            if not name.startswith("_") and name not in PLAIN:
                annotation = plain(part.annotation)
                lines.append(f"    {name} ({ast.unparse(annotation)}): {text_of(part.value) or '-'}")
                of_type = get_expression(annotation, parent=cls)
                default = default_of(part.value)
                arguments.append(Parameter(name, annotation=of_type, kind=ParameterKind.keyword_only, default=default))
        cls.set_member("__init__", Function("__init__", parameters=Parameters(*arguments)))
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


def default_of(value: ast.expr | None) -> str | None:
    """What a field is when it is not given, as written; None where it has to be."""
    if not (isinstance(value, ast.Call) and getattr(value.func, "id", "") == "Field"):
        return ast.unparse(value) if value else None
    given = {keyword.arg: ast.unparse(keyword.value) for keyword in value.keywords}
    first = ast.unparse(value.args[0]) if value.args else "..."
    made = f"{given['default_factory']}()" if "default_factory" in given else None
    return given.get("default") or made or (first if first != "..." else None)


def before_examples(text: str, lines: list[str]) -> str:
    """A docstring with a section put in front of its examples."""
    head, mark, tail = text.partition("\nExamples:\n")
    return "\n".join([head.rstrip(), "", *lines, mark + tail])
