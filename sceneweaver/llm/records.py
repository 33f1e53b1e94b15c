"""Every question and answer of a run as files: `0001-plan.json`, pictures by content, and what was spent.

endpoint.json      which model was asked, and the sessions of the folder
usage.json         what was spent
0001-plan.json     one question: text, every reply, what the validator said, the outcome
pictures/          what was shown, once each, by SHA-256
kinds/             JSON schemas of the answers, which go along with a question
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sceneweaver.io import load_json, own_folder, require_no_link, write_atomic
from sceneweaver.scene import InputError

from .reply import Picture
from .secrets import line, redact

SCHEMA = "sceneweaver.llm_record/1"
FOLDER_SCHEMA = "sceneweaver.llm_records/1"
NAME = re.compile(r"(\d{4,})-([a-z0-9_-]+)\.json")


@dataclass(frozen=True)
class Asked:
    """A question as it is sent.

    Attributes:
        purpose: short name of what is asked for.
        kind: name of the type of the answer.
        instructions: how to answer.
        content: text and pictures, in order.
        schema: JSON schema of the answer.
    """

    purpose: str
    kind: str
    instructions: str
    content: tuple[str | Picture, ...]
    schema: Mapping[str, Any] = field(default_factory=dict[str, Any])

    @property
    def digest(self) -> str:
        """Of everything but the pictures' bytes: two machines may draw the same scene with other last bits."""
        parts = [["picture", part.title] if isinstance(part, Picture) else ["text", part] for part in self.content]
        data = json.dumps([self.purpose, self.kind, self.instructions, parts])
        return hashlib.sha256(data.encode()).hexdigest()


@dataclass
class Record:
    """One question and what came of it.

    Attributes:
        asked: the question.
        digest: of the question.
        attempts: every reply or failed request, in order, as JSON data.
        answer: the accepted answer as the model gave it, before code mended it.
        failure: class and words of the error; empty when there is an answer.
        lost: why no further question is asked from here on; "" when more may be.
        usage: what it cost, as the fields of `Count`.
        number: of the record in its folder.
    """

    asked: Asked
    attempts: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    answer: dict[str, Any] | None = None
    failure: dict[str, str] = field(default_factory=dict[str, str])
    lost: str = ""
    usage: dict[str, Any] = field(default_factory=dict[str, Any])
    digest: str = ""
    number: int = 0

    def to_dict(self, pictures: Sequence[str], session: int) -> dict[str, Any]:
        """As JSON data; ``pictures`` are the names of the files, in order."""
        names = iter(pictures)
        return {
            "schema": SCHEMA,
            "number": self.number,
            "session": session,
            "purpose": self.asked.purpose,
            "kind": self.asked.kind,
            "digest": self.asked.digest,
            "instructions": self.asked.instructions,
            "content": [
                {"picture": next(names), "title": part.title} if isinstance(part, Picture) else {"text": part}
                for part in self.asked.content
            ],
            "attempts": self.attempts,
            "answer": self.answer,
            "failure": self.failure,
            "lost": self.lost,
            "usage": self.usage,
        }


class Recorder:
    """Writes records into a folder; goes on where an earlier session of the folder stopped.

    Args:
        folder: made when it is not there; its parent has to be.
        endpoint: of the model, as JSON data with `title` and `pictures`.

    Attributes:
        usage: what earlier sessions have spent, as `Usage.to_dict` gave it; empty for a new folder.

    Raises:
        InputError: when the folder cannot be written, or holds something else.
    """

    def __init__(self, folder: Path, endpoint: Mapping[str, Any]) -> None:
        self.folder = folder
        try:
            folder.parent.mkdir(parents=True, exist_ok=True)
            for own in (folder, folder / "pictures", folder / "kinds"):
                own_folder(own)
            numbers = [int(found[1]) for name in os.listdir(folder) if (found := NAME.fullmatch(name))]
        except OSError as error:
            raise InputError(f"{folder}: records cannot be written there ({line(error.strerror)})") from None
        for name in ("endpoint.json", "usage.json"):
            require_no_link(folder / name)
        before = read_folder(folder) if (folder / "endpoint.json").exists() else {"sessions": []}
        usage = _read(folder / "usage.json") if (folder / "usage.json").exists() else {}
        self.usage: dict[str, Any] = usage.get("usage", {})
        self._number = self._kept = max(numbers, default=0)
        kept = min(usage.get("kept", self._number), self._number) if before["sessions"] else 0
        sessions = [*before["sessions"], {"first": self._number + 1, "kept": kept}]
        self.session = len(sessions)
        self._keeps = False
        data = {"schema": FOLDER_SCHEMA, **endpoint, "sessions": sessions}
        self._save(folder / "endpoint.json", _text(data))

    def _save(self, place: Path, content: bytes) -> None:
        """Write a file of the records, in their own folder."""
        write_atomic(place, content, within=self.folder.parent)

    def next_number(self) -> int:
        """The number of the next record; taken before a question is sent, so that equal runs number alike."""
        self._number += 1
        return self._number

    def write(self, record: Record, usage: Mapping[str, Any]) -> None:
        """Write a record, its pictures, the schema of its answer and what is spent by now."""
        names: list[str] = []
        for part in record.asked.content:
            if isinstance(part, Picture):
                name = f"{hashlib.sha256(part.png).hexdigest()}.png"
                if not (place := self.folder / "pictures" / name).exists():
                    self._save(place, part.png)
                names.append(name)
        data = redact(record.to_dict(names, self.session))
        data["kind"] = self._kind(record.asked)
        place = self.folder / f"{record.number:04d}-{_slug(record.asked.purpose)}.json"
        if place.exists():
            raise InputError(f"{place}: is there already; two runs write records into one folder")
        self._save(place, _text(data))
        self._write_usage(usage)

    def _kind(self, asked: Asked) -> str:
        """Name of the file of a schema, below `kinds`, without its ending."""
        text = _text(asked.schema)
        name = f"{asked.kind}-{hashlib.sha256(text).hexdigest()[:8]}"
        if not (place := self.folder / "kinds" / f"{name}.json").exists():
            self._save(place, text)
        return name

    def keep(self, usage: Mapping[str, Any]) -> None:
        """Mark all calls so far as part of what the run has saved."""
        self._kept, self._keeps = self._number, True
        self._write_usage(usage)

    def _write_usage(self, usage: Mapping[str, Any]) -> None:
        data: dict[str, Any] = {"schema": FOLDER_SCHEMA, "usage": usage}
        if self._keeps:
            data["kept"] = self._kept
        self.usage = dict(usage)
        self._save(self.folder / "usage.json", _text(redact(data)))


NEEDED = frozenset(("purpose", "number", "digest", "answer", "failure", "usage"))
"""What a record has at least."""


def read_folder(folder: Path) -> dict[str, Any]:
    """What `endpoint.json` says.

    Raises:
        InputError: when this is no folder of records.
    """
    if not (folder / "endpoint.json").is_file():
        raise InputError(f"{folder}: holds no records of a model; give the folder of a run, or its llm folder")
    data = _read(folder / "endpoint.json")
    if data.get("schema") != FOLDER_SCHEMA or not isinstance(data.get("sessions"), list):
        raise InputError(f"{folder}: its endpoint.json is not of {FOLDER_SCHEMA}")
    return data


def read_records(folder: Path) -> list[dict[str, Any]]:
    """The records that count, in the order of their numbers: without those of steps that were not saved.

    Raises:
        InputError: for a file that is no record.
    """
    sessions = read_folder(folder)["sessions"]
    try:
        ranges = [range(session["kept"] + 1, session["first"]) for session in sessions[1:]]
    except (KeyError, TypeError):
        raise InputError(f"{folder}: the sessions in its endpoint.json are not of {FOLDER_SCHEMA}") from None
    places = sorted((int(named[1]), name) for name in os.listdir(folder) if (named := NAME.fullmatch(name)))
    found: list[dict[str, Any]] = []
    for number, name in places:
        if any(number in left_out for left_out in ranges):
            continue
        data = _read(folder / name)
        if data.get("schema") != SCHEMA or not data.keys() >= NEEDED:
            raise InputError(f"{folder / name}: is no record of {SCHEMA}")
        found.append({**data, "file": name})
    return found


def _read(place: Path) -> dict[str, Any]:
    data = load_json(place)
    if not isinstance(data, dict):
        raise InputError(f"{place}: is no JSON object")
    return data


def _text(data: Mapping[str, Any]) -> bytes:
    """JSON in UTF-8; halves of pairs, which no UTF-8 has, as JSON escapes them."""
    return (json.dumps(data, indent=1, ensure_ascii=False) + "\n").encode("utf-8", "backslashreplace")


def _slug(purpose: str) -> str:
    return re.sub(r"[^a-z0-9_]+", "-", purpose.lower()).strip("-")[:40] or "ask"
