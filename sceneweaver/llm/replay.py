"""A client that answers from the records of a run, without a network and without pydantic-ai."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from sceneweaver.io import read_bytes
from sceneweaver.scene import InputError

from .client import ModelClient
from .conversation import accepted, error_of
from .errors import ModelError, ReplayError
from .records import Record, Recorder, read_folder, read_records
from .reply import Picture, Reply

Answer = TypeVar("Answer", bound=Reply)


class ReplayClient(ModelClient):
    """Gives the answers of a recorded run to the same questions, and its failures as well.

    A question is the same when purpose, type of answer, instructions, text and titles of pictures are. What pictures
    show is not compared: two machines may draw equal scenes with other last bits. Equal questions are answered in
    the order in which they were asked.

    Args:
        folder: of the records.
        recorder: where the replayed run writes records of its own.

    Raises:
        InputError: when the folder holds no records.
    """

    def __init__(self, folder: Path, recorder: Recorder | None = None) -> None:
        super().__init__(None, recorder=recorder)
        endpoint = read_folder(folder)
        self._folder = folder
        self._records = read_records(folder)
        self._used: set[int] = set()
        self.name = str(endpoint.get("title", "model"))
        self.pictures = bool(endpoint.get("pictures", True))
        self.usage.priced, self.usage.currency = bool(endpoint.get("priced")), str(endpoint.get("currency", ""))

    def shown(self, purpose: str) -> tuple[Picture, ...] | None:
        """As recorded: when a run was short of time it showed fewer. One whose file is gone has its title alone."""
        with self._lock:
            rows = (row for row in self._records if row["purpose"] == purpose and row["number"] not in self._used)
            content = next(rows, {}).get("content", [])
        return tuple(self._picture(part) for part in content if isinstance(part, dict) and "picture" in part)

    def _picture(self, part: dict[str, Any]) -> Picture:
        name = Path(str(part["picture"])).name  # a file of this folder, whatever the record says
        try:
            png = read_bytes(self._folder / "pictures" / name)
        except InputError:
            png = b""
        return Picture(png, str(part.get("title", "")))

    def _answers(
        self,
        records: Sequence[Record],
        kind: type[Answer],
        check: Callable[[Answer], Answer | None] | None,
        retries: int,
    ) -> list[Answer | ModelError]:
        with self._lock:
            found = [self._find(record) for record in records]
        answers = [self._answer(record, kind, check, file) for record, file in zip(records, found, strict=True)]
        with self._lock:
            for record in records:
                self.usage.add(record.asked.purpose, record.usage)
                self._note(record)
        return answers

    def _find(self, record: Record) -> str:
        """Fill in what came of the same question in the recorded run; gives the file's name."""
        asked = record.asked
        same = [row for row in self._records if row["purpose"] == asked.purpose and row["number"] not in self._used]
        for row in same:
            if row["digest"] == asked.digest:
                self._used.add(row["number"])
                record.attempts, record.answer = row.get("attempts", []), row["answer"]
                record.failure, record.lost, record.usage = row["failure"], row.get("lost", ""), row["usage"]
                return str(row["file"])
        if same:
            raise ReplayError(f"replay: record {same[0]['file']} is of another request: {_difference(same[0], record)}")
        asked_before = sum(row["purpose"] == asked.purpose for row in self._records)
        raise ReplayError(
            f"replay: {self._folder} has no record of request {asked_before + 1} for {asked.purpose!r}; "
            "replay with the request, options and version of the recorded run"
        )

    def _answer(
        self, record: Record, kind: type[Answer], check: Callable[[Answer], Answer | None] | None, file: str
    ) -> Answer | ModelError:
        passed: Answer | None = None
        for attempt in record.attempts:  # a check may keep the best of what it refuses, so it sees all of them
            if "answer" not in attempt:
                continue
            passed, words = _checked(attempt["answer"], kind, check)
            if (passed is None) != ("refused" in attempt):
                now = f"no longer passes: {words}" if passed is None else "is no longer refused"
                raise ReplayError(f"replay: an answer of record {file} {now}")
        if record.answer is None:
            return error_of(record)
        if passed is None:
            raise ReplayError(f"replay: record {file} has no answer that passes")
        return passed


def _checked(
    data: Any, kind: type[Answer], check: Callable[[Answer], Answer | None] | None
) -> tuple[Answer | None, str]:
    try:
        return accepted(kind.model_validate(data), kind, check)[1:]
    except ValidationError as error:
        return None, f"{error.error_count()} fields are wrong"


def _difference(row: dict[str, Any], record: Record) -> str:
    """Where a question differs from a recorded one."""
    asked = record.asked
    if (kind := str(row.get("kind")).rpartition("-")[0]) != asked.kind:
        return f"it asks for {kind}, not {asked.kind}"
    if row.get("instructions") != asked.instructions:
        return f"its instructions differ {_place(str(row.get('instructions')), asked.instructions)}"
    content = row.get("content", [])
    for index, (old, new) in enumerate(zip(content, asked.content, strict=False)):
        text = new if isinstance(new, str) else new.title
        kept = old.get("text") if isinstance(new, str) else old.get("title")
        if kept != text:
            return f"part {index + 1} of its text differs {_place(str(kept), text)}"
    return f"it has {len(content)} parts, not {len(asked.content)}"


def _place(old: str, new: str) -> str:
    same = next((i for i, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), min(len(old), len(new)))
    return f"from character {same + 1} on: {old[same : same + 40]!r}, now {new[same : same + 40]!r}"
