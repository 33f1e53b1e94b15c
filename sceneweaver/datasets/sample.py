"""What is made of one request: the files of a scene and its row in the index."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

Status = Literal["ok", "rejected", "failed"]
"""Delivered; made, but not through the gates; not made."""


@dataclass(frozen=True)
class Sample:
    """A scene of a data set, or the reason why there is none.

    Attributes:
        index: its number in the data set.
        key: its name in shards.
        status: "ok", "rejected" or "failed".
        row: its columns in the index that follow from specification and index alone, see `columns`.
        files: by suffix (``scene.json``, ``glb``, ``xml``, ...), its files in a shard; empty unless it is "ok".
        seconds: by stage, how long it took; kept apart from the index, as no two runs agree on it.
    """

    index: int
    key: str
    status: Status
    row: dict[str, Any]
    files: dict[str, bytes] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)
