"""Profiles: rows with sources, one on top of another, and bad ones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sceneweaver.io import InputError
from sceneweaver.knowledge.load import room_types as kinds_of_rooms
from sceneweaver.plans import Profile, Rule, profile_names, room_types

ROW = {"id": "r", "measure": "area", "least": 5.0, "says": "s", "source": "s"}


def test_the_figures_of_the_code():
    base = Profile.named("base")
    bounds = {row.id: row.least if row.least is not None else row.most for row in base.rows}
    expected = {
        **{"habitable-area": 6.5, "one-large-room": 11.1, "habitable-side": 2.13, "glazing": 0.08, "hall-width": 0.91},
        **{"ceiling": 2.13, "aspect": 2.5, "riser": 0.196, "going": 0.254, "stair-width": 0.91, "headroom": 2.03},
    }
    assert {name: bounds[name] for name in expected} == expected
    assert all(base.rule(name).hard for name in expected)


def test_each_row_has_a_source_and_a_bound():
    for name in profile_names():
        for row in Profile.named(name).rows:
            assert row.source.strip() and row.says.endswith("."), row.id
            assert row.least is None or row.most is None or row.least < row.most


def test_a_profile_on_top_of_another():
    base, japan = Profile.named("base"), Profile.named("japan")
    assert japan.rule("hall-width").least == 0.75 and base.rule("hall-width").least == 0.91
    assert [row.id for row in japan.rows] == [row.id for row in base.rows]
    assert len(Profile.named("accessible").rows) == len(base.rows) + 4
    assert "aspect" not in {row.id for row in base.without("aspect").rows}


def test_own_profiles(tmp_path: Path):
    (tmp_path / "mine.yaml").write_text(
        "extends: base\nrows:\n  - {id: aspect, measure: aspect, most: 2.0, says: Squat., source: taste}\n", "utf-8"
    )
    mine = Profile.load(tmp_path / "mine.yaml")
    assert mine.rule("aspect").most == 2.0 and mine.rule("riser") == Profile.named("base").rule("riser")


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({"measure": "beauty"}, 'measure is "beauty"; known: area'),
        ({"least": None}, "rule 'r': least is missing, and so is most; give one of them"),
        ({"of": ["bedrom"]}, 'of[0] is "bedrom"; did you mean "bedroom"?'),
        ({"weight": 0.0}, "weight is 0"),
        ({"source": ""}, "source"),
    ],
)
def test_bad_rows(change: dict[str, Any], line: str):
    with pytest.raises(InputError) as said:
        Rule(**{**ROW, **change})
    assert line in str(said.value) and "\n" not in str(said.value)


def test_bad_profiles():
    with pytest.raises(InputError, match=r'rows\[1\]\.id is "r", as of row 0'):
        Profile(rows=(Rule(**ROW), Rule(**ROW)))
    with pytest.raises(InputError, match='profile "bse" is not known; did you mean "base"'):
        Profile.named("bse")
    with pytest.raises(InputError, match='rule "heit" is not in base'):
        Profile.named("base").rule("heit")


def test_soft_rows_cost_at_most_their_weight():
    row = Rule(**{**ROW, "hard": False, "weight": 2.0, "per": 4.0})
    assert [row.cost(excess) for excess in (0, 1, 4, 40)] == [0, 0.5, 2.0, 2.0]


def test_rooms_are_furnished_by_kinds_that_there_are():
    known = kinds_of_rooms()
    for kind in room_types().values():
        assert kind.area[0] <= kind.area[1] <= kind.area[2]
        assert kind.side**2 <= kind.area[2], kind.name
        assert kind.furnish is None or kind.furnish in known, kind.name
