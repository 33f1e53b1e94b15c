"""Data that ships with the library, by package and name; it is ours, so it is read without bounds."""

from __future__ import annotations

from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Any


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
    """YAML of ours: anchors and aliases are allowed, and no line is looked at twice."""
    import yaml

    return yaml.load(content, Loader=_loader())


@cache
def _loader() -> Any:
    import yaml

    return getattr(yaml, "CSafeLoader", yaml.SafeLoader)
