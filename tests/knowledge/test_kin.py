"""Kinds that people count as one, and what is there for another kind alone."""

from __future__ import annotations

import pytest

from sceneweaver.knowledge.kin import excluded_kinds


@pytest.mark.parametrize(
    ("unwanted", "gone", "kept"),
    [
        (["tv"], {"tv", "tv_on_stand", "tv_stand", "soundbar", "remote_control"}, {"sofa", "speaker", "sideboard"}),
        (["plant_group"], {"palm", "fern", "small_plant"}, {"vase"}),
        (["armchair"], {"armchair", "recliner"}, {"sofa", "dining_chair"}),
        ([], set(), {"tv_stand"}),
    ],
)
def test_what_a_room_does_not_have(unwanted: list[str], gone: set[str], kept: set[str]) -> None:
    found = excluded_kinds(unwanted)
    assert gone <= found and not kept & found
