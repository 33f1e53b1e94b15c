"""Requests with SceneEval's annotations, and whether a scene holds what they say: CNT, ATR, OOR and OAR.

The columns are those of SceneEval's CSV. A line is, of ObjCount ``quantifier,number,category``; of ObjAttr the same and
attributes; of OORel ``quantifier,number,words,anchor,category,category...`` (``anchor`` says which of them is it); of
OARel ``quantifier,number,words,category,element``. SceneEval has a vision-language model match objects to categories
and judge attributes, and another choose among its own relations. Here the taxonomy matches, and the critic judges what
words mean (``rules/stated.yaml``), as it does for designs from requests.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from sceneweaver.io import InputError, load_csv
from sceneweaver.io.messages import clean, show

COLUMNS = {"CNT": "ObjCount", "ATR": "ObjAttr", "OOR": "OORel", "OAR": "OARel"}
"""The four metrics and their columns."""

QUANTIFIERS = ("eq", "lt", "gt", "le", "ge")

MOST_LINES = 500
"""Lines of a request."""

_FIELDS = {"CNT": 3, "ATR": 4, "OOR": 6, "OAR": 5}
_NUMBER = re.compile(r"\d+")


class Line(NamedTuple):
    """One line of an annotation: its metric, how many (``quantifier`` and ``number``), and the rest of its fields."""

    metric: str
    text: str
    quantifier: str
    number: int
    rest: tuple[str, ...]

    def enough(self, count: int) -> bool:
        """Whether so many meet it."""
        n = self.number
        return {"eq": count == n, "lt": count < n, "gt": count > n, "le": count <= n, "ge": count >= n}[self.quantifier]


@dataclass(frozen=True)
class Annotated:
    """A request with what a scene for it must hold."""

    id: str
    text: str
    lines: tuple[Line, ...]

    @property
    def categories(self) -> tuple[str, ...]:
        """The categories that are counted, in their order."""
        return tuple(dict.fromkeys(line.rest[0] for line in self.lines if line.metric == "CNT"))


@dataclass(frozen=True)
class Requests:
    """The rows of a file, found by their words or by their number.

    Examples:
        >>> rows = [{"ID": "7", "Description": "A room with a bed.", "ObjCount": "eq,1,bed"}]
        >>> found = Requests.of(rows).find(prompt="", name="scene_7")
        >>> found.id, found.lines[0].enough(1)
        ('7', True)
    """

    by_text: Mapping[str, Annotated] = field(default_factory=dict)
    by_id: Mapping[str, Annotated] = field(default_factory=dict)

    @classmethod
    def load(cls, path: str | Path) -> Requests:
        """Read a CSV file with the columns ID, Description, ObjCount, ObjAttr, OORel and OARel.

        Raises:
            InputError: a file that cannot be read, lacks a column, or has a line that is none.
        """
        return cls.of(load_csv(path), clean(str(path)))

    @classmethod
    def of(cls, rows: Sequence[Mapping[str, str]], name: str = "requests") -> Requests:
        """From the rows of such a file."""
        if not rows:
            raise InputError(f"{name}: no rows; give a CSV file as of SceneEval")
        for column in ("ID", "Description", "ObjCount"):
            if column not in rows[0]:
                raise InputError(f"{name}: column {column} is missing; give a CSV file as of SceneEval")
        found = [_annotated(row, f"{name}: row {k}") for k, row in enumerate(rows, 2)]
        return cls({_plain(a.text): a for a in found}, {a.id: a for a in found})

    def find(self, *, prompt: str, name: str) -> Annotated | None:
        """The request that a scene was made for: the one of its words, else of the last number in its name."""
        if prompt and (found := self.by_text.get(_plain(prompt))) is not None:
            return found
        numbers = _NUMBER.findall(name)
        return self.by_id.get(str(int(numbers[-1]))) if numbers else None


def _plain(text: str) -> str:
    return " ".join(text.lower().split())


def _annotated(row: Mapping[str, Any], where: str) -> Annotated:
    lines = [
        _line(metric, text, f"{where}: {column}")
        for metric, column in COLUMNS.items()
        for text in dict.fromkeys(part.strip() for part in (row.get(column) or "").split(";"))
        if text
    ]
    if len(lines) > MOST_LINES:
        raise InputError(f"{where}: {len(lines)} lines; at most {MOST_LINES} are read")
    number = (row.get("ID") or "").strip()
    return Annotated(str(int(number)) if number.isdigit() else number, row.get("Description") or "", tuple(lines))


def _line(metric: str, text: str, where: str) -> Line:
    fields = [part.strip() for part in text.split(",")]
    if len(fields) < _FIELDS[metric]:
        raise InputError(f"{where} is {show(text)}; give at least {_FIELDS[metric]} values, such as eq,1,bed")
    quantifier = fields[0][:2]
    if quantifier not in QUANTIFIERS or not fields[1].isdigit():
        raise InputError(f"{where} is {show(text)}; begin with one of {', '.join(QUANTIFIERS)} and a number")
    return Line(metric, text, quantifier, int(fields[1]), tuple(fields[2:]))
