"""Kinds of rooms as files of their own: names that are safe, text that is read without running anything in it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from sceneweaver.io import dump_yaml
from sceneweaver.io.messages import shorten
from sceneweaver.io.yaml_text import parse_yaml
from sceneweaver.scene import InputError

from .groups import expanded
from .load import group_templates, with_on
from .model import RoomType

SCHEMA = "sceneweaver.room/1"

LARGEST = 64 * 1024
"""Bytes of a file at most."""

LONGEST = 40
"""Characters of a name at most."""


def plain(words: str) -> str:
    """Words as requests are searched for them: lower case, with single blanks."""
    return " ".join(re.findall(r"[^\W_]+", words.lower()))


def slug(words: str) -> str:
    """The name of a room that words call so, fit for a file: "Mountain hut" is mountain_hut.

    Raises:
        InputError: where no Latin letters are in them, or too many.
    """
    name = "_".join(re.findall(r"[a-z0-9]+", words.lower()))
    if not re.match(r"[a-z]", name) or len(name) > LONGEST:
        raise InputError(f"room: '{shorten(words)}' is no name; give one to {LONGEST} letters, such as mountain hut")
    return name


def read_room(text: str) -> RoomType:
    """A kind of room from the text of a file.

    Raises:
        InputError: one line, for what is no room.
    """
    data = with_on(parse_yaml(text, "room"))
    if not isinstance(data, dict) or data.pop("schema", None) != SCHEMA:
        raise InputError(f"give a mapping with schema: {SCHEMA}")
    return room_from(data)


def room_from(data: Mapping[str, Any]) -> RoomType:
    """A kind of room from the data of a file; InputError with one line for what is none."""
    try:
        room = RoomType(**expanded(data, group_templates()))
    except InputError:
        raise
    except (TypeError, ValueError, KeyError, AttributeError, RecursionError) as error:
        raise InputError(shorten(" ".join(str(error).split()) or type(error).__name__, 200)) from None
    if slug(room.name) != room.name:
        raise InputError(f"name is '{shorten(room.name)}'; give it as {slug(room.name)}")
    return room


def room_text(data: Mapping[str, Any]) -> str:
    """The text of a file with the data of a room; equal data give equal text."""
    import json

    plain_data = json.loads(json.dumps({"schema": SCHEMA, **data}))
    return dump_yaml(plain_data, width=110, default_flow_style=None)
