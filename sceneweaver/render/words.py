"""Words of categories and of kinds of rooms that pictures go by; the tables are data."""

from __future__ import annotations

import re
from functools import cache
from importlib import resources
from typing import Any

from sceneweaver.assets.category import read_yaml


@cache
def tables() -> dict[str, Any]:
    """All tables of ``words.yaml``."""
    return read_yaml(resources.files(__package__ or "").joinpath("words.yaml"))


def is_one_of(text: str, kind: str) -> bool:
    """Whether a category, or the type of a room, has the words of a pattern of ``words.yaml``."""
    return _pattern(kind).search(text.lower().replace("-", " ").replace("_", " ")) is not None


@cache
def _pattern(kind: str) -> re.Pattern[str]:
    return re.compile("".join(tables()[kind].split()))
