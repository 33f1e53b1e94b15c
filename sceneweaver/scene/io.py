"""Reading and writing ``scene.json``: guarded on the way in, atomic on the way out."""

from __future__ import annotations

import contextlib
import json
import os
import re
import secrets
from pathlib import Path
from typing import Any, Self

from .base import FrozenModel
from .errors import InputError
from .messages import clean, quote, show, suggest
from .migrate import migrate

MAX_BYTES = 64 * 2**20
"""Largest file [bytes] that is read unless told otherwise."""

EXAMPLES = tuple(sorted(p.stem for p in (Path(__file__).parent / "examples").glob("*.json")))
"""Names for ``Scene.example``."""

_OMIT_EMPTY = ("description", "parts", "intent", "attributes")


class SceneFile(FrozenModel):
    """A scene as far as reading and writing go: what `Scene` has of it."""

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, max_bytes: int = MAX_BYTES) -> Self:
        """Read a ``scene.json`` of this or an older schema version.

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
        """The scene in the text of a ``scene.json``; InputError with one line on anything wrong."""
        return cls.from_json(parse(text))

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
        """The scene as plain JSON data; empty optional fields of objects and of their intents are left out."""
        data = self.model_dump(mode="json", by_alias=True)
        for obj in data["objects"]:
            intent = obj["intent"].items()
            obj["intent"] = {key: value for key, value in intent if value is not None and value is not False}
            for key in _OMIT_EMPTY:
                if obj[key] is None or obj[key] == {}:
                    del obj[key]
        return data

    def dumps(self) -> str:
        """The text of a ``scene.json``: floats in full, short lists of numbers on one line."""
        text = json.dumps(self.to_json(), indent=1, ensure_ascii=False, allow_nan=False)
        # Raw newlines stand between JSON tokens only, never within a string: these two match nothing else.
        text = re.sub(r'\[\n\s+([^\[\]{}"]*?)\n\s+\]', _join, text)
        return re.sub(r'\[\n\s+((?:\[[^\[\]{}"\n]*\],?\s+)+?)\]', _join, text) + "\n"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write ``scene.json`` under a temporary name and rename it; InputError when that cannot be done."""
        write_atomic(path, self.dumps())


def read_bytes(path: str | os.PathLike[str], *, max_bytes: int = MAX_BYTES) -> bytes:
    """The content of a file of at most ``max_bytes``; a larger one is refused before it is read.

    Raises:
        InputError: when it is missing, a folder, too large, or cannot be read.
    """
    name = clean(os.fspath(path))
    limit = f"{max_bytes / 2**20:.6g} MB"
    try:
        size = os.stat(path).st_size
        if os.path.isdir(path):
            raise InputError(f"{name}: this is a folder; give the file in it, such as scene.json")
        if size > max_bytes:
            raise InputError(f"{name}: the file has {size / 2**20:.6g} MB; at most {limit} are read")
        with open(path, "rb") as file:
            content = file.read(max_bytes + 1)
    except FileNotFoundError:
        raise InputError(f"{name}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: cannot be read ({_reason(error)}); check the path and its permissions") from None
    if len(content) > max_bytes:  # a pipe or device, whose size nobody knows before
        raise InputError(f"{name}: the file has more than {limit}; at most that is read")
    return content


def parse(text: str | bytes) -> Any:
    """JSON text as data.

    Raises:
        InputError: not UTF-8, not JSON (with line and column), cut off, a key twice, nested too deep.
    """
    if isinstance(text, bytes):
        try:
            text = text.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise InputError(f"not UTF-8 text (byte {error.start}); save the file as UTF-8") from None
    if not text.strip():
        raise InputError('the file is empty; give a scene, {"schema": "sceneweaver.scene/1", ...}')
    try:
        return json.loads(text, object_pairs_hook=_unique)
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        if error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated string"):
            text = f"invalid JSON: it ends too early, at {where} ({error.msg}); is the file cut off?"
            raise InputError(text) from None
        raise InputError(f"invalid JSON at {where}: {error.msg}") from None
    except RecursionError:
        raise InputError("invalid JSON: nested too deep; a scene has fewer than 40 levels") from None
    except InputError:
        raise
    except ValueError:  # Python refuses to convert integers of thousands of digits
        raise InputError("invalid JSON: a number has too many digits; numbers must fit a double") from None


def write_atomic(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file so that others see the old one or the whole new one: temporary name, fsync, rename.

    Raises:
        InputError: when the folder is missing or cannot be written; no temporary file stays behind.
    """
    name = clean(os.fspath(path))
    data = content.encode("utf-8") if isinstance(content, str) else content
    temporary: str | None = None
    try:
        target = os.path.realpath(path)
        if os.path.isdir(target):
            raise InputError(f"{name}: this is a folder; give a file name in it, such as scene.json")
        temporary = os.path.join(os.path.dirname(target), f".sceneweaver-{secrets.token_hex(8)}.tmp")
        with open(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666), "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, target)
        temporary = None
    except FileNotFoundError:
        raise InputError(f"{name}: its folder does not exist; make it first") from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name}: cannot be written ({_reason(error)}); choose another place") from None
    finally:
        if temporary is not None:
            with contextlib.suppress(OSError):
                os.unlink(temporary)


def _join(match: re.Match[str]) -> str:
    return "[" + re.sub(r"\s*\n\s*", " ", match[1].strip()) + "]"


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    data = dict(pairs)
    if len(data) < len(pairs):
        keys = [key for key, _ in pairs]
        twice = next(key for key in keys if keys.count(key) > 1)
        name = data.get("id")
        where = f" of {quote(name)}" if isinstance(name, str) else ""
        raise InputError(f"invalid JSON: key {show(twice)} stands twice in one object{where}; remove one")
    return data


def _reason(error: Exception) -> str:
    return clean(error.strerror if isinstance(error, OSError) and error.strerror else str(error))
