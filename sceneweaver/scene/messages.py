"""One clear line for everything that can be wrong: where it is, what it is, how to mend it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from sceneweaver.io.messages import clean, nearest, quote, shorten, show, suggest

Loc = tuple[str | int, ...]

# What the numbers of a field are, by field name; follows "size[1] is -0.5; ".
_MEANING = {
    "size": "sizes are positive metres",
    "width": "widths are positive metres",
    "height": "heights are positive metres",
    "headroom": "head rooms are positive metres, or null for no limit",
    "offset": "offsets are metres from the wall's first corner, 0 or more",
    "sill": "sills are metres above the floor, 0 or more",
    "wall": "walls are numbered from 0",
    "index": "indices are numbered from 0",
    "weight": "weights are positive numbers",
}
_EXPECTED = {
    "float_type": "a number",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "string_type": "a string",
    "string_unicode": "a string of valid Unicode",
    "dict_type": "an object {...}",
    "model_type": "an object {...}",
    "model_attributes_type": "an object {...}",
    "tuple_type": "a list",
}
_LABELLED = ("doors", "windows", "objects", "relations", "dropped", "storeys", "rooms", "stairs")


class FieldError(ValueError):
    """Something wrong at ``loc``, a path relative to the model that raises it; ``text`` continues the path."""

    def __init__(self, loc: Loc, text: str) -> None:
        super().__init__(text)
        self.loc = loc
        self.text = text


def locate(loc: Sequence[str | int], data: object) -> tuple[str, str]:
    """The path ``loc`` as (labelled head, rest), for example ("objects[3] 'chair-0'", "size[1]")."""
    head, rest, last = "", "", None
    for key in loc:
        if isinstance(key, int):
            rest += f"[{key}]"
        else:
            rest += f".{clean(shorten(key))}" if rest else clean(shorten(key))
        data = _child(data, key)
        if isinstance(key, int) and last in _LABELLED:
            head, rest = f"{head}.{rest}" if head else rest, ""
            head += _label(data)
        last = key
    return head, rest


def describe(loc: Sequence[str | int], text: str, data: object, prefix: str = "") -> str:
    """One line: the path ``loc`` into ``data``, then ``text``.

    A text that starts with ": " speaks about the keys of the thing at ``loc``; any other text goes on after the path.
    """
    head, rest = locate(loc, data)
    path = ": ".join(p for p in (prefix, head, rest) if p)
    return clean(f"{path}{text}" if text.startswith(": ") and path else f"{path} {text.removeprefix(': ')}").strip()


def one_line(error: ValidationError, root: type[BaseModel], data: object, prefix: str = "") -> str:
    """The first problem of a pydantic error as one line; ``data`` is the input, for the ids in the path."""
    problems = error.errors(include_url=False)
    first = problems[0]
    if first["type"] == "missing":  # a misspelt key is both missing and unknown: the second says more
        same = [p for p in problems if p["type"] == "extra_forbidden" and p["loc"][:-1] == first["loc"][:-1]]
        first = same[0] if same else first
    if first["type"] == "missing" and isinstance(first["loc"][-1], int):  # a pair or triple that is too short
        loc, given = first["loc"][:-1], len(first["input"])
        wanted = 1 + max(int(p["loc"][-1]) for p in problems if p["type"] == "missing" and p["loc"][:-1] == loc)
        return describe(loc, f"has {given} {'entry' if given == 1 else 'entries'}; give {wanted}", data, prefix)
    loc, text = _explain(first, root)
    return describe(loc, text, data, prefix)


def _child(data: object, key: str | int) -> object:
    if isinstance(key, int):
        return data[key] if isinstance(data, list | tuple) and key < len(data) else None
    return data.get(key) if isinstance(data, Mapping) else getattr(data, key, None)


def _label(item: object) -> str:
    name, kind = _child(item, "id"), _child(item, "type")
    if isinstance(name, str):
        return f" {quote(name)}"
    subject = _child(item, "subject")
    if isinstance(kind, str) and isinstance(subject, str):
        return f" {clean(shorten(kind))} {quote(subject)}"
    return ""


def _explain(problem: Mapping[str, Any], root: type[BaseModel]) -> tuple[Loc, str]:
    """The path and the text of one entry of ``ValidationError.errors()``."""
    kind, loc, value, ctx = problem["type"], tuple(problem["loc"]), problem.get("input"), problem.get("ctx", {})
    field = next((key for key in reversed(loc) if isinstance(key, str)), "")
    if kind == "value_error":
        cause = ctx["error"]
        return (loc + cause.loc, cause.text) if isinstance(cause, FieldError) else (loc, f"is wrong: {cause}")
    if loc[-1:] == ("[key]",):
        return loc[:-2], f": key {show(value)} is not a string; JSON keys are"
    if kind == "extra_forbidden":
        return loc[:-1], f': unknown key "{clean(shorten(str(loc[-1])))}"{_key_hint(str(loc[-1]), loc[:-1], root)}'
    if kind == "missing":
        return loc[:-1], f': "{loc[-1]}" is missing; add it{_meaning(root, loc)}'
    if kind == "too_long":
        most = ctx["max_length"]  # a pair or triple has to have just so many
        return loc, f"has {ctx['actual_length']} entries; give {most if most <= 4 else f'at most {most}'}"
    if kind == "too_short":
        return loc, f"has {ctx['actual_length']} entries; give at least {ctx['min_length']}"
    if kind == "string_too_short":
        return loc, f"is {show(value)}; give at least {ctx['min_length']} character"
    if kind == "literal_error":
        options = _literals(root, loc)
        return loc, f"is {show(value)}{suggest(value, options, what='give one of')}"
    if kind == "finite_number":
        return loc, f"is {show(value)}; numbers must be finite"
    if kind in ("greater_than", "greater_than_equal"):
        bound = ctx.get("gt", ctx.get("ge"))
        least = f", at least {bound:g}" if isinstance(value, int | float) and value > 0 else ""
        return loc, f"is {show(value)}; {_MEANING.get(field, f'it must be at least {bound:g}')}{least}"
    if kind in ("less_than", "less_than_equal"):
        return loc, f"is {show(value)}; numbers are metres, at most {ctx.get('lt', ctx.get('le')):g}"
    if kind in _EXPECTED:
        return loc, f"is {show(value)}; give {_EXPECTED[kind]}"
    return loc, f"is {show(value)}; {problem['msg']}"


def _models(annotation: object) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for argument in get_args(annotation) for model in _models(argument)]


def _annotation(root: type[BaseModel], loc: Loc) -> object:
    """The annotation of the last named field on the way ``loc`` into ``root``; None when there is no such field."""
    annotation: object = root
    for key in loc:
        if isinstance(key, str):
            models = _models(annotation)
            fields = {f.alias or name: f for name, f in models[0].model_fields.items()} if models else {}
            if key not in fields:
                return None
            annotation = fields[key].annotation
    return annotation


def _keys(model: type[BaseModel]) -> list[str]:
    return [f.alias or name for name, f in model.model_fields.items()]


def _key_hint(key: str, loc: Loc, root: type[BaseModel]) -> str:
    """The nearest known key of the model at ``loc``, or of a model right under it (as "pose.position")."""
    models = _models(_annotation(root, loc))
    if not models:
        return ""
    own = _keys(models[0])
    under: dict[str, str] = {}
    for name, f in models[0].model_fields.items():
        for part in (f.annotation, *get_args(f.annotation)):  # a model or an optional one, not a list of them
            if isinstance(part, type) and issubclass(part, BaseModel):
                under.update({sub: f"{f.alias or name}.{sub}" for sub in _keys(part) if sub not in own})
    near = nearest(key, [*own, *under])
    return suggest(key, own, what="known keys") if near is None else f'; did you mean "{under.get(near, near)}"?'


def _literals(root: type[BaseModel], loc: Loc) -> list[str]:
    parts = get_args(_annotation(root, loc))
    return [text for part in parts for text in ((part,) if isinstance(part, str) else get_args(part))]


def _meaning(root: type[BaseModel], loc: Loc) -> str:
    models = _models(_annotation(root, loc[:-1]))
    for name, field in models[0].model_fields.items() if models else ():
        if (field.alias or name) == loc[-1] and field.description:
            return f" ({field.description[0].lower()}{field.description[1:].split('. ')[0].rstrip('.')})"
    return ""
