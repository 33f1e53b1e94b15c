"""Reading and writing ``home.json``: guarded on the way in, atomic on the way out."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Self

from sceneweaver.io import MAX_BYTES, InputError, parse_json, read_bytes, write_atomic
from sceneweaver.io.messages import clean, quote, show, suggest
from sceneweaver.scene.base import FrozenModel

SCHEMA = "sceneweaver.home/1"
"""Name and version of the format."""

EXAMPLES = tuple(sorted(p.stem for p in (Path(__file__).parent / "examples").glob("*.json")))
"""Names for ``Home.example``."""


def is_home(data: Any) -> bool:
    """Whether plain JSON data says that it is a home, of any version."""
    return isinstance(data, dict) and str(data.get("schema", "")).startswith("sceneweaver.home/")


class HomeFile(FrozenModel):
    """A home as far as reading and writing go."""

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, max_bytes: int = MAX_BYTES) -> Self:
        """Read a ``home.json``.

        Raises:
            InputError: with one line that names the file, the field and the fix.
        """
        name = clean(os.fspath(path))
        try:
            return cls.loads(read_bytes(path, max_bytes=max_bytes))
        except InputError as error:
            text = str(error)
            raise InputError(text if text.startswith(f"{name}: ") else f"{name}: {text}") from None

    @classmethod
    def loads(cls, text: str | bytes) -> Self:
        """The home in the text of a ``home.json``; InputError with one line on anything wrong."""
        return cls.from_json(parse_json(text, wanted=f'a home, {{"schema": "{SCHEMA}", ...}}'))

    @classmethod
    def from_json(cls, data: Any) -> Self:
        """The home in plain JSON data; InputError on anything wrong."""
        if not isinstance(data, dict):
            raise InputError(f'is {show(data)}; give a home, {{"schema": "{SCHEMA}", ...}}')
        if data.get("schema") != SCHEMA:
            raise InputError(f"schema is {show(data.get('schema'))}; this version reads {quote(SCHEMA)}")
        return cls.model_validate(data)

    @classmethod
    def example(cls, name: str = "flat") -> Self:
        """One of the homes that ship with the library, see ``EXAMPLES``; InputError for another name."""
        if name not in EXAMPLES:
            raise InputError(f"no example {quote(name)}{suggest(name, EXAMPLES, what='examples', mark=chr(39))}")
        return cls.load(Path(__file__).parent / "examples" / f"{name}.json")

    def to_json(self) -> dict[str, Any]:
        """The home as plain JSON data; furnished rooms as their scenes write themselves."""
        data = self.model_dump(mode="json", by_alias=True, exclude={"rooms": {"__all__": {"scene"}}})
        for written, room in zip(data["rooms"], getattr(self, "rooms"), strict=True):  # noqa: B009 - of the subclass
            written["scene"] = None if room.scene is None else room.scene.to_json()
        return data

    def dumps(self) -> str:
        """The text of a ``home.json``."""
        return json.dumps(self.to_json(), ensure_ascii=False, allow_nan=False, indent=1) + "\n"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write ``home.json`` under a temporary name and rename it; InputError when that cannot be done."""
        write_atomic(path, self.dumps(), through_link=True)
