"""Reading scenes of older schema versions.

A migration turns the data of one version into that of the next; a chain of them ends at the current one:

    @migration("sceneweaver.scene/1")
    def _from_1(data: dict[str, Any]) -> dict[str, Any]: ...   # gives data of sceneweaver.scene/2

``intent`` came to version 1 as an optional field of objects. Before that its fields were attributes with other names;
objects without an intent get theirs from those. ``asked`` of relations was a list [type, subject] in the provenance,
and ``finish`` of the room was {floor, walls} there.
"""

from __future__ import annotations

import copy
import math
import re
from collections.abc import Callable
from typing import Any

from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, quote, show

from .finish import RoomFinish
from .intent import Intent

SCHEMA = "sceneweaver.scene/1"
"""The current version."""

Migration = Callable[[dict[str, Any]], dict[str, Any]]

_NAME, _, _VERSION = SCHEMA.rpartition("/")
_CURRENT = int(_VERSION)
_SCHEMA = re.compile(re.escape(_NAME) + r"/(0|[1-9][0-9]{0,5})", re.ASCII)
_migrations: dict[str, Migration] = {}

_INTENT = {
    "need": "priority",
    "asked": "request",
    "item": "program_item",
    "hang": "mounting_height",
    "clear": "keep_clear",
}
"""Fields of the intent by the attributes that once held them."""


def migration(schema: str) -> Callable[[Migration], Migration]:
    """Register a function from data of version ``schema`` to data of the next version.

    The function gets a copy that it may change; the ``schema`` key is set for it. What it cannot make sense of it may
    leave as it is, to be refused with a clear line by the model.

    Raises:
        InputError: when ``schema`` is not an older version of the scene schema, or has a migration already.
    """
    match = _SCHEMA.fullmatch(schema)
    if match is None or int(match[1]) >= _CURRENT:
        raise InputError(f"schema {show(schema)} is no version before {SCHEMA}")
    if schema in _migrations:
        raise InputError(f"schema {show(schema)} has a migration already")

    def register(function: Migration) -> Migration:
        _migrations[schema] = function
        return function

    return register


def migrate(data: Any) -> dict[str, Any]:
    """The data in the current schema version; data that is current already is given back as it is, never changed.

    Raises:
        InputError: not an object, no schema or another one, a newer version, a version without migration.
    """
    if not isinstance(data, dict):
        raise InputError(f'the top level is {show(data)}; give an object {{"schema": "{SCHEMA}", ...}}')
    if "schema" not in data:
        raise InputError(f'"schema" is missing; add "schema": "{SCHEMA}"')
    schema = data["schema"]
    if schema == SCHEMA:
        return _with_meaning(data)
    match = _SCHEMA.fullmatch(schema) if isinstance(schema, str) else None
    if match is None:
        raise InputError(f'schema is {show(schema)}; a scene file has "{SCHEMA}"')
    version = int(match[1])
    if version > _CURRENT:
        raise InputError(f'schema is {show(schema)}, written by a newer version than "{SCHEMA}"; upgrade sceneweaver')
    try:
        data = copy.deepcopy(data)
    except RecursionError:
        raise InputError("nested too deep; a scene has fewer than 40 levels") from None
    for step in range(version, _CURRENT):
        function = _migrations.get(f"{_NAME}/{step}")
        if function is None:
            raise InputError(f'schema is {show(schema)}, too old to be read; write it as "{SCHEMA}"')
        try:
            data = {**function(data), "schema": f"{_NAME}/{step + 1}"}
        except InputError:
            raise
        except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
            text = f"schema is {show(schema)} and could not be brought to {_NAME}/{step + 1}"
            raise InputError(f"{text} ({type(error).__name__}: {quote(error)}); mend it by hand") from None
    return _with_meaning(data)


def _with_meaning(data: dict[str, Any]) -> dict[str, Any]:
    """The data with what stands in attributes and provenance for intents and relations moved to where it belongs."""
    objects, relations, provenance = (data.get(key) for key in ("objects", "relations", "provenance"))
    if isinstance(objects, list | tuple):
        moved = [_with_intent(obj) for obj in objects]
        if any(new is not old for new, old in zip(moved, objects, strict=True)):
            data = {**data, "objects": moved}
    asked = provenance.get("asked") if isinstance(provenance, dict) else None
    if isinstance(relations, list | tuple) and isinstance(asked, list) and all(isinstance(a, list) for a in asked):
        data = {**data, "relations": [_with_asked(r, asked) for r in relations]}
        data["provenance"] = {key: value for key, value in data["provenance"].items() if key != "asked"}
    return _with_finish(data)


def _with_finish(data: dict[str, Any]) -> dict[str, Any]:
    """The data with the names of floor and paint that stood in the provenance as the finish of the room."""
    room, provenance = data.get("room"), data.get("provenance")
    if not isinstance(room, dict) or not isinstance(provenance, dict):
        return data
    said = provenance.get("finish")
    if not isinstance(said, dict) or said.keys() - {"floor", "walls"} or "finish" in room:
        return data
    finish: dict[str, Any] = {"walls": said.get("walls")} if said.get("walls") else {}
    if said.get("floor"):
        finish["floor"] = {"material": said["floor"]}
    try:
        RoomFinish.model_validate(finish)
    except InputError:
        return data  # somebody else's data of that name: it stays
    kept = {key: value for key, value in provenance.items() if key != "finish"}
    return {**data, "room": {**room, "finish": finish}, "provenance": kept}


def _with_asked(relation: Any, asked: list[list[Any]]) -> Any:
    if not isinstance(relation, dict) or [relation.get("type"), relation.get("subject")] not in asked:
        return relation
    return {"asked": True, **relation}


def _with_intent(obj: Any) -> Any:
    attributes = obj.get("attributes") if isinstance(obj, dict) and "intent" not in obj else None
    if not isinstance(attributes, dict) or attributes.keys().isdisjoint(_INTENT):
        return obj
    intent: dict[str, Any] = {}
    for old, new in _INTENT.items():
        try:
            if old in attributes and Intent.model_validate({new: attributes[old]}):
                intent[new] = attributes[old]
        except InputError:
            pass  # somebody else's attribute of that name: it stays one
    kept = {key: value for key, value in attributes.items() if _INTENT.get(key) not in intent}
    return {**obj, "intent": intent, "attributes": kept} if intent else obj


@migration("sceneweaver.scene/0")
def _yaw_to_quaternion(data: dict[str, Any]) -> dict[str, Any]:
    """Version 0 was the draft of upright objects: ``pose: {position, yaw}`` with yaw in radians about +z."""
    objects = data.get("objects")
    for obj in objects if isinstance(objects, list) else ():
        pose = obj.get("pose") if isinstance(obj, dict) else None
        if not isinstance(pose, dict) or "yaw" not in pose or "quaternion" in pose:
            continue
        yaw = pose["yaw"]
        if not is_number(yaw) or not math.isfinite(yaw):
            raise InputError(f"object {quote(obj.get('id'))}: pose.yaw is {show(yaw)}; give a finite number of radians")
        del pose["yaw"]
        pose["quaternion"] = list(from_yaw(yaw))
    return data
