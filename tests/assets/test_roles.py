"""Roles of categories: known members, groups and other roles in them, exceptions, and no role said twice."""

from __future__ import annotations

from itertools import combinations

import pytest

from sceneweaver.assets import categories
from sceneweaver.assets.roles import _file, groups_above, has_role, roles_of, with_role
from sceneweaver.assets.taxonomy import members


def test_every_role_has_known_members_and_says_what_it_means():
    for role, row in _file().items():
        assert with_role(role) <= set(categories()), role
        assert with_role(role) and row["means"].endswith("."), role


def test_no_two_roles_are_the_same():
    same = [(a, b) for a, b in combinations(_file(), 2) if with_role(a) == with_role(b)]
    assert same == []


def test_groups_and_exceptions():
    assert with_role("upright_seat") >= set(members("chair_group")) - {"rocking_chair"}
    assert not has_role("rocking_chair", "upright_seat")
    assert with_role("desk", "dining_table") == with_role("desk") | with_role("dining_table") < with_role("seated_at")


def test_roles_of_a_category():
    assert {"bed", "any_bed"} <= roles_of("king_bed")
    assert roles_of("no_such_thing") == frozenset()
    assert "furniture" in groups_above("office_chair")


def test_an_unknown_role_is_an_error():
    with pytest.raises(KeyError):
        with_role("throne")
