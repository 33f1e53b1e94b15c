"""Data that ships with the library, by package and name; it is ours, so it is read without bounds."""

from __future__ import annotations

import hashlib
import marshal
import sys
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Any

from sceneweaver.runtime.caches import cache_place, places, writable

from .errors import SceneWeaverError
from .reading import read_bytes
from .writing import write_atomic

_CACHE = "sceneweaver/data"
_LARGEST = 16 * 2**20
_VERSION = f"{sys.version_info[:2]} {marshal.version} "
"""Of what is kept: other versions of Python may write it in another way."""


def folder(package: str, *names: str) -> Traversable:
    """A folder of a package."""
    return resources.files(package).joinpath(*names)


def text(package: str, *names: str) -> str:
    """A text of a package, UTF-8."""
    return resources.files(package).joinpath(*names).read_text(encoding="utf-8")


def text_of(file: Traversable) -> str:
    """A text of a package that was found in a `folder`."""
    return file.read_text(encoding="utf-8")


def bytes_of(file: Traversable) -> bytes:
    """As `text_of`, the bytes."""
    return file.read_bytes()


def yaml_data(package: str, *names: str) -> Any:
    """A YAML file of a package."""
    return parse(text(package, *names))


def parse(content: str) -> Any:
    """YAML of ours: anchors and aliases are allowed, and no line is looked at twice.

    What was parsed once is kept in the user's cache, by its content: reading that is fifty times as fast.
    """
    name = hashlib.sha256(f"{_VERSION}{content}".encode()).hexdigest()
    kept = _kept(name)
    if kept is not None:
        return kept[0]
    import yaml

    data = yaml.load(content, Loader=_loader())
    _keep(name, data)
    return data


def _kept(name: str) -> tuple[Any] | None:
    """What was parsed before, in a tuple; None where nothing of it is there that can be read."""
    for place in places(cache_place(_CACHE)):
        try:
            written = read_bytes(place / name, max_bytes=_LARGEST)
            if hashlib.sha256(written[32:]).digest() == written[:32]:
                return (marshal.loads(written[32:]),)
        except (SceneWeaverError, OSError, EOFError, ValueError, TypeError):
            continue
    return None


def _keep(name: str, data: Any) -> None:
    """Keep what was parsed, where that can be written: nothing is lost where it cannot."""
    try:
        content = marshal.dumps(data)
        write_atomic(writable(cache_place(_CACHE)) / name, hashlib.sha256(content).digest() + content)
    except (SceneWeaverError, OSError, ValueError):
        return


@cache
def _loader() -> Any:
    import yaml

    return getattr(yaml, "CSafeLoader", yaml.SafeLoader)
