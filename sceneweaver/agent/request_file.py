"""``request.json``: how a request was read, and what became of each item of it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import ClassVar, Literal

from pydantic import Field

from sceneweaver.critic import ItemOutcome, Review
from sceneweaver.io import load_json, write_atomic
from sceneweaver.io.messages import path_name
from sceneweaver.language import SceneGraph
from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

NAME = "request.json"

MAX_BYTES = 16 * 2**20
"""Most bytes of a file that are read."""


class RequestFile(FrozenModel):
    """The scene graph of a request with the outcome of each item, in the order of the graph."""

    _noun: ClassVar[str] = "request"

    schema_: Literal["sceneweaver.request/1"] = Field(alias="schema")
    graph: SceneGraph
    summary: dict[str, int] = Field(description="How many items there are (total), and how many of each status")
    outcomes: tuple[ItemOutcome, ...]
    disagreements: tuple[str, ...] = Field(
        default=(),
        description="Where a model read it in another way than the offline reader; left out if empty",
    )

    @classmethod
    def of(cls, graph: SceneGraph, review: Review, disagreements: tuple[str, ...] = ()) -> RequestFile:
        """The file of a request and a review of the scene."""
        found = review.alignment
        return cls(
            schema="sceneweaver.request/1",
            graph=graph,
            summary=found.summary,
            outcomes=found.items,
            disagreements=disagreements,
        )

    @classmethod
    def load(cls, path: Path) -> RequestFile:
        """Read a file.

        Raises:
            InputError: when it cannot be read or is no such file; it names the file.
        """
        data = load_json(path, max_bytes=MAX_BYTES)
        try:
            return cls.model_validate(data)
        except InputError as error:
            raise InputError(f"{path_name(path)}: {error}") from None

    def save(self, path: Path) -> None:
        """Write it under a temporary name beside the path and rename it."""
        data = self.model_dump(mode="json", by_alias=True, exclude=None if self.disagreements else {"disagreements"})
        write_atomic(path, json.dumps(data, indent=1, ensure_ascii=False) + "\n")
