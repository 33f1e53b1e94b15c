"""What categories are to a room: seat, bed, screen, wall-backed. The data is ``categories/roles.yaml``."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources
from typing import Any

from .category import ROLES, categories, read_yaml
from .taxonomy import members


@cache
def with_role(*roles: str) -> frozenset[str]:
    """The categories that have any of some roles.

    Raises:
        KeyError: for a role that ``roles.yaml`` does not know.

    Examples:
        >>> from sceneweaver.assets.roles import with_role
        >>> sorted(with_role("coffee_table"))
        ['coffee_table', 'nesting_tables', 'round_coffee_table']
    """
    return frozenset().union(*(_members(role) for role in roles))


def has_role(category: str, *roles: str) -> bool:
    """Whether a category has any of some roles; KeyError for an unknown role."""
    return category in with_role(*roles)


@cache
def roles_of(category: str) -> frozenset[str]:
    """All roles of a category."""
    return frozenset(role for role in _file() if category in _members(role))


@cache
def groups_above(category: str) -> frozenset[str]:
    """The groups of the taxonomy that a category belongs to, near and far; none for a category that is unknown."""
    known, found = categories(), set[str]()
    row = known.get(category)
    while row is not None and row.parent is not None:
        found.add(row.parent)
        row = known.get(row.parent)
    return frozenset(found)


@cache
def _file() -> Mapping[str, Mapping[str, Any]]:
    return read_yaml(resources.files(__package__ or "").joinpath("categories", ROLES))


@cache
def _members(role: str) -> frozenset[str]:
    row = _file()[role]
    return _union(role, row["of"]) - _union(role, row.get("but", ()))


def _union(role: str, names: list[str | Mapping[str, str]]) -> frozenset[str]:
    """The categories that entries of a role name: categories, groups, or other roles."""
    found: set[str] = set()
    for name in names:
        if isinstance(name, Mapping):
            found |= _members(name["role"])
            continue
        row = categories().get(name)
        if row is None:
            raise ValueError(f"{ROLES}: {role} names {name}, which is no category or group")
        found.update((name,) if row.size is not None else members(name))
    return frozenset(found)
