"""The distribution that holds the library: its name, its version, and how to install what is missing beside it.

Nothing here names the distribution in a command: what is missing is installed by its own name, with the bounds that the
metadata of the distribution states, so that a package of another author that is called alike is never fetched.
"""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, requires, version

DISTRIBUTION = "sceneweaver-layout"
"""Name of the distribution; the module that it brings and the command are ``sceneweaver``."""

UNKNOWN = "0+unknown"
"""Version of a source tree that nobody installed."""

MODULES = {"PIL": "pillow", "pxr": "usd-core", "yaml": "pyyaml", "warp": "warp-lang"}
"""Modules that the distributions that bring them do not name."""


def package_version() -> str:
    """The version of the library."""
    try:
        return version(DISTRIBUTION)
    except PackageNotFoundError:
        return UNKNOWN


def missing_extra(extra: str, what: str) -> str:
    """One line that says what is missing and how to install it.

    Args:
        extra: the extra that brings it, such as "llm".
        what: what is wrong without it, such as "models need pydantic-ai".
    """
    wanted = [text for text, marker in _requirements() if re.search(rf"extra *== *['\"]{extra}['\"]", marker)]
    return f"{what} (extra '{extra}'); {_fix(wanted)}"


def missing_module(module: str, what: str) -> str:
    """One line that says which module is missing and how to install what brings it.

    Args:
        module: its name where it is imported, such as "scipy.spatial".
        what: what is wrong without it.
    """
    name = module.partition(".")[0]
    key = _plain(MODULES.get(name, name))
    wanted = [text for text, _ in _requirements() if _plain(re.split(r"[^\w.-]", text)[0]) == key]
    return f"{what}; {_fix(wanted[:1] or [MODULES.get(name, name)])}"


def _fix(wanted: list[str]) -> str:
    """What to do about requirements that are not met."""
    if not wanted:
        return "install it with: make install, in a clone"
    return f"install it with: pip install {' '.join(map(_quoted, wanted))} (in a clone: make install)"


def _quoted(requirement: str) -> str:
    return f"'{requirement}'" if re.search(r"[^\w.-]", requirement) else requirement


def _plain(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _requirements() -> list[tuple[str, str]]:
    """What the distribution requires, each with its marker; nothing where nobody installed it."""
    try:
        found = requires(DISTRIBUTION) or []
    except PackageNotFoundError:
        return []
    return [(text.strip(), marker) for text, _, marker in (line.partition(";") for line in found)]
