"""A model whose replies are data: what it said when it was asked, or a person who is asked now and whose reply stays.

Replies of a room are a list in ``data/by_model/<room>.yaml``, in the order of the questions of each kind:

    - asks: Plan            # type of the answer
      about: 3f2a...        # of the text that it answers
      says: {...}
"""

from __future__ import annotations

import hashlib
import importlib
import itertools
import pkgutil
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml

from sceneweaver.agent import by_model
from sceneweaver.io import write_atomic
from sceneweaver.knowledge.load import read_yaml
from sceneweaver.llm import Reply
from tests.llm.model_server import Asked, Said
from tests.llm.said import says

FOLDER = Path(__file__).parent / "data" / "by_model"
ELSEWHERE = ("sceneweaver.tools.room_reply",)
"""Modules with types of answers outside of `sceneweaver.agent.by_model`."""

WORD = 4
"""Characters of text that count as a token."""

POLL = 0.5
"""Seconds between two looks for the reply of a person."""


class Script:
    """Says what a file of replies has; with a folder, asks a person there where the file has no fitting reply.

    Attributes:
        changed: questions whose text is another than that which the reply was written for.
        missing: questions that no reply is there for; they are refused.
        waited: seconds that a person took.
    """

    def __init__(self, file: Path, ask_in: Path | None = None) -> None:
        self.file, self.ask_in = file, ask_in
        self.rows: list[dict[str, Any]] = read_yaml(file.read_text("utf-8")) if file.exists() else []
        self.changed: list[str] = []
        self.missing: list[str] = []
        self.waited = 0.0
        self._turns: Counter[str] = Counter()
        self._kinds = list(kinds())

    def __call__(self, asked: Asked) -> Said:
        kind = next((k.__name__ for k in self._kinds if asked.wants(k)), "Inputs")
        turn = self._turns[kind]
        self._turns[kind] += 1
        about = hashlib.sha256("\n".join([asked.text, *asked.told]).encode()).hexdigest()[:16]
        own = [row for row in self.rows if row["asks"] == kind]
        row = own[turn] if turn < len(own) else None
        if row is not None and row["about"] != about:
            self.changed.append(f"{kind} {turn + 1}")
        if self.ask_in is not None and (row is None or row["about"] != about):
            said = {"asks": kind, "about": about, "says": self._told(asked, f"{kind} {turn + 1}", row)}
            if row is None:
                self.rows.append(said)
            else:
                row.update(said)
            row = said
            self._save()
        if row is None:
            self.missing.append(f"{kind} {turn + 1}")
            return Said(refusal="nothing is written down for this question")
        reply = says(row["says"], asked)
        words = len(str(row["says"])) // WORD
        return Said(text=reply.text, calls=reply.calls, tokens=(_tokens(asked), words))

    def _told(self, asked: Asked, title: str, old: dict[str, Any] | None) -> Any:
        """What a person answers: question and pictures as files, the answer as `answer.yaml` beside them."""
        assert self.ask_in is not None
        place = self.ask_in / title.replace(" ", "-")
        number = next(n for n in itertools.count() if not Path(f"{place}-{n}").exists())
        place = Path(f"{place}-{number}")
        place.mkdir(parents=True)
        told = "".join(f"\n\n# Told\n{text}" for text in asked.told)
        before = f"\n\n# Said before\n{yaml.safe_dump(old['says'], allow_unicode=True)}" if old else ""
        parts = f"# Instructions\n{asked.instructions}\n\n# Asked\n{asked.text}{told}{before}\n"
        (place / "question.md").write_text(parts, "utf-8")
        for k, picture in enumerate(asked.pictures, 1):
            (place / f"{k}.png").write_bytes(picture)
        answer = place / "answer.yaml"
        began = time.monotonic()
        while not answer.exists():
            time.sleep(POLL)
        time.sleep(POLL)  # until it is written
        self.waited += time.monotonic() - began
        return read_yaml(answer.read_text("utf-8"))

    def _save(self) -> None:
        write_atomic(self.file, yaml.safe_dump(self.rows, allow_unicode=True, sort_keys=False, width=90))


def kinds() -> Iterator[type[Reply]]:
    """Every type of answer that the library asks for."""
    for module in pkgutil.iter_modules(by_model.__path__, f"{by_model.__name__}."):
        importlib.import_module(module.name)
    for name in ELSEWHERE:
        importlib.import_module(name)
    waiting = [Reply]
    while waiting:
        kind = waiting.pop(0)
        waiting += kind.__subclasses__()
        if kind is not Reply and kind.__module__.partition(".")[0] == "sceneweaver":  # others may be loaded: of tests
            yield kind


def _tokens(asked: Asked) -> int:
    return (len(asked.instructions) + len(asked.text) + sum(map(len, asked.told))) // WORD
