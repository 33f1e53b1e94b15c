"""Checks of inputs against a JSON schema: the part of JSON Schema that tool cards use, with errors of one line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sceneweaver.io.messages import show, suggest
from sceneweaver.scene import InputError

TYPES: Mapping[str, tuple[type, ...]] = {
    "object": (Mapping,),
    "array": (list, tuple),
    "string": (str,),
    "number": (int, float),
    "integer": (int,),
    "boolean": (bool,),
    "null": (type(None),),
}

_NUMBER, _COUNT = {"type": "number"}, {"type": "integer", "minimum": 0}

KEYWORDS: Mapping[str, Mapping[str, Any]] = {
    "type": {"type": ["string", "array"], "items": {"type": "string"}, "minItems": 1},
    "description": {"type": "string"},
    "default": {},
    "properties": {},
    "required": {"type": "array", "items": {"type": "string"}},
    "items": {},
    "enum": {"type": "array", "minItems": 1},
    "minimum": _NUMBER,
    "maximum": _NUMBER,
    "exclusiveMinimum": _NUMBER,
    "minItems": _COUNT,
    "maxItems": _COUNT,
    "additionalProperties": {},
}
"""Keywords that are understood, with the schema of what each may be; {}: anything, or it is looked at by itself."""

_NAMES = {
    "object": "an object {...}",
    "array": "a list",
    "string": "a text",
    "number": "a number",
    "integer": "a whole number",
    "boolean": "true or false",
    "null": "null",
}

DEEPEST = 24
"""Levels of nesting that inputs may have."""


def check_schema(schema: Any, where: str = "inputs") -> None:
    """Refuse a schema with keywords or types that are not understood, or that contradicts itself.

    Raises:
        InputError: with the path to what is wrong.
    """
    if not isinstance(schema, Mapping):
        raise InputError(f"{where} is {show(schema)}; give a schema {{type: ...}}")
    for key in schema:
        if key not in KEYWORDS:
            raise InputError(f"{where}: keyword {show(key)} is not understood{suggest(str(key), sorted(KEYWORDS))}")
        check_inputs(KEYWORDS[key], schema[key], f"{where}.{key}")
    for name in _types(schema):
        if name not in TYPES:
            raise InputError(f"{where}.type is {show(name)}{suggest(name, TYPES)}")
    properties = schema.get("properties", {})
    if not isinstance(properties, Mapping):
        raise InputError(f"{where}.properties is {show(properties)}; give an object {{name: schema}}")
    for name, inner in properties.items():
        if not isinstance(name, str):
            raise InputError(f"{where}.properties has the name {show(name)}; put names such as on in quotes")
        check_schema(inner, f"{where}.{name}")
    for name in schema.get("required", ()):
        if name not in properties:
            raise InputError(f"{where}.required names {show(name)}{suggest(str(name), properties)}")
    if "items" in schema:
        check_schema(schema["items"], f"{where}[]")
    extra = schema.get("additionalProperties", True)
    if not isinstance(extra, bool):
        check_schema(extra, f"{where}.*")
    for low, high in (("minimum", "maximum"), ("minItems", "maxItems")):
        if low in schema and high in schema and schema[low] > schema[high]:
            raise InputError(f"{where}: {low} {schema[low]} is more than {high} {schema[high]}; swap them")


def check_inputs(schema: Mapping[str, Any], data: Any, where: str = "inputs", depth: int = 0) -> None:
    """Refuse data that a schema does not allow.

    Args:
        schema: as `check_schema` accepts it.
        data: plain JSON data.
        where: how errors name the data.
        depth: levels above it.

    Raises:
        InputError: one line with the path, what is there, and what is allowed.
    """
    if depth > DEEPEST:
        raise InputError(f"{where} is nested more than {DEEPEST} levels deep; make it flat")
    names = _types(schema)
    if names and not any(_is(data, name) for name in names):
        raise InputError(f"{where} is {show(data)}; give {' or '.join(_NAMES[n] for n in names)}")
    if "enum" in schema and data not in schema["enum"]:
        options = [str(option) for option in schema["enum"]]
        raise InputError(f"{where} is {show(data)}{suggest(str(data), options, what='one of')}")
    if isinstance(data, Mapping):
        _check_object(schema, data, where, depth)
    elif isinstance(data, list | tuple):
        _check_list(schema, data, where, depth)
    elif isinstance(data, int | float) and not isinstance(data, bool):
        _check_number(schema, data, where)


def _check_object(schema: Mapping[str, Any], data: Mapping[str, Any], where: str, depth: int) -> None:
    properties, extra = schema.get("properties", {}), schema.get("additionalProperties", True)
    for name in schema.get("required", ()):
        if name not in data:
            what = properties[name].get("description", "it is needed")
            raise InputError(f"{where}.{name} is missing; {what}")
    for name, value in data.items():
        if name in properties:
            check_inputs(properties[name], value, f"{where}.{name}", depth + 1)
        elif extra is False:
            raise InputError(f"{where}: {show(name)} is unknown{suggest(str(name), properties)}")
        elif extra is not True:
            check_inputs(extra, value, f"{where}[{show(name)}]", depth + 1)


def _check_list(schema: Mapping[str, Any], data: Sequence[Any], where: str, depth: int) -> None:
    least, most = schema.get("minItems", 0), schema.get("maxItems")
    if len(data) < least:
        raise InputError(f"{where} has {len(data)} entries; at least {least}")
    if most is not None and len(data) > most:
        raise InputError(f"{where} has {len(data)} entries; at most {most}")
    if "items" in schema:
        for k, value in enumerate(data):
            check_inputs(schema["items"], value, f"{where}[{k}]", depth + 1)


def _check_number(schema: Mapping[str, Any], value: float, where: str) -> None:
    if value != value or value in (float("inf"), float("-inf")):
        raise InputError(f"{where} is {show(float(value))}; numbers must be finite")
    if "minimum" in schema and value < schema["minimum"]:
        raise InputError(f"{where} is {show(value)}; at least {schema['minimum']:g}")
    if "exclusiveMinimum" in schema and value <= schema["exclusiveMinimum"]:
        raise InputError(f"{where} is {show(value)}; more than {schema['exclusiveMinimum']:g}")
    if "maximum" in schema and value > schema["maximum"]:
        raise InputError(f"{where} is {show(value)}; at most {schema['maximum']:g}")


def _types(schema: Mapping[str, Any]) -> tuple[str, ...]:
    names = schema.get("type", ())
    return (names,) if isinstance(names, str) else tuple(names)


def _is(data: Any, name: str) -> bool:
    """Whether data has a JSON type; true and false are no numbers, 2.0 is a whole number."""
    if isinstance(data, bool):
        return name == "boolean"
    if name == "integer" and isinstance(data, float):
        return data.is_integer()
    return isinstance(data, TYPES[name])
