"""Reading and writing ``scene.json``: guarded on the way in, atomic on the way out."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any, Self

from sceneweaver.io import MAX_BYTES, InputError, parse_json, read_bytes, write_atomic
from sceneweaver.io.messages import clean, quote, suggest

from .base import FrozenModel
from .migrate import migrate

EXAMPLES = tuple(sorted(p.stem for p in (Path(__file__).parent / "examples").glob("*.json")))
"""Names for ``Scene.example``."""

_OMIT_EMPTY = ("description", "parts", "yaw_domain", "intent", "attributes")


class SceneFile(FrozenModel):
    """A scene as far as reading and writing go: what `Scene` has of it."""

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        *,
        max_bytes: int = MAX_BYTES,
        within: str | os.PathLike[str] | None = None,
    ) -> Self:
        """Read a ``scene.json`` of this or an older schema version.

        Args:
            path: The file.
            max_bytes: A larger one is refused.
            within: A folder above it, from which on no link is followed; None: links are.

        Raises:
            InputError: with one line that names the file, the field and the fix.
        """
        name = clean(os.fspath(path))
        try:
            return cls.loads(read_bytes(path, max_bytes=max_bytes, within=within))
        except InputError as error:
            text = str(error)
            raise InputError(text if text.startswith(f"{name}: ") else f"{name}: {text}") from None

    @classmethod
    def loads(cls, text: str | bytes) -> Self:
        """The scene in the text of a ``scene.json``; InputError with one line on anything wrong."""
        return cls.from_json(parse_json(text, wanted='a scene, {"schema": "sceneweaver.scene/1", ...}'))

    @classmethod
    def from_json(cls, data: Any) -> Self:
        """The scene in plain JSON data of this or an older schema version; InputError on anything wrong."""
        return cls.model_validate(migrate(data))

    @classmethod
    def example(cls, name: str = "bedroom") -> Self:
        """One of the scenes that ship with the library, see ``EXAMPLES``; InputError for another name."""
        if name not in EXAMPLES:
            raise InputError(f"no example {quote(name)}{suggest(name, EXAMPLES, what='examples', mark=chr(39))}")
        return cls.load(Path(__file__).parent / "examples" / f"{name}.json")

    def to_json(self) -> dict[str, Any]:
        """The scene as plain JSON data; what says nothing in objects, their intents and relations is left out."""
        data = self.model_dump(mode="json", by_alias=True)
        for key in ("finish", "light"):
            if data["room"][key] is None:
                del data["room"][key]
        if not data["free_areas"]:
            del data["free_areas"]
        for obj in data["objects"]:
            intent = obj["intent"].items()
            obj["intent"] = {key: value for key, value in intent if value is not None and value is not False}
            for key in _OMIT_EMPTY:
                if obj[key] is None or obj[key] == {}:
                    del obj[key]
        for relation in data["relations"]:
            for key in ("asked", "request"):
                if not relation[key]:
                    del relation[key]
        return data

    def dumps(self) -> str:
        """The text of a ``scene.json``: floats in full, short lists of numbers on one line."""
        text = json.dumps(self.to_json(), indent=1, ensure_ascii=False, allow_nan=False)
        # Raw newlines stand between JSON tokens only, never within a string: these two match nothing else.
        text = re.sub(r'\[\n\s+([^\[\]{}"]*?)\n\s+\]', _join, text)
        return re.sub(r'\[\n\s+((?:\[[^\[\]{}"\n]*\],?\s+)+?)\]', _join, text) + "\n"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write ``scene.json`` under a temporary name and rename it; InputError when that cannot be done.

        Where ``path`` is a link, the file that it leads to is written.
        """
        write_atomic(path, self.dumps(), through_link=True)


def _join(match: re.Match[str]) -> str:
    return "[" + re.sub(r"\s*\n\s*", " ", match[1].strip()) + "]"
