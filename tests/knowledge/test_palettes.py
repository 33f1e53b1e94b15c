"""Palettes: they name what exists, keep to few woods and hues, suit their rooms, and follow the request."""

from __future__ import annotations

import math

import pytest

from sceneweaver.assets.materials import STYLES, color_named, finish, shade
from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.palettes import FALLBACK, accent_for, floor_for, groups_of, palette_for, palettes
from sceneweaver.scene import InputError
from tests.for_each import for_each

ROOMS = room_types()


@for_each(palettes())
def test_a_palette_names_what_exists(name):
    palette = palettes()[name]
    for color in (palette.walls, palette.accent, *palette.textiles):
        assert color_named(color)
    families = {"woods": {"wood"}, "paints": {"paint"}, "metals": {"metal"}}
    for field, allowed in families.items():
        assert {finish(m).family for m in getattr(palette, field)} <= allowed
    for material, tone in palette.floors.items():
        assert finish(tone).family == "wood" if material == "wood" else color_named(tone)
    assert set(palette.floors) == {"wood", "tile", "stone", "carpet", "concrete"}
    assert set(palette.styles) <= set(STYLES)


@for_each(palettes())
def test_furniture_stands_out_from_a_wooden_floor(name):
    palette = palettes()[name]
    floor = finish(palette.floors["wood"]).material.color
    assert all(math.dist(floor, finish(wood).material.color) > 0.15 for wood in palette.woods)


def test_what_the_file_says_of_rooms_is_of_rooms_that_exist():
    from sceneweaver.knowledge.palettes import _data

    data = _data()
    listed = {room for rooms in data["kinds"].values() for room in rooms}
    assert listed == {name for name, room in ROOMS.items() if room.palettes is None}
    assert {room.palettes for room in ROOMS.values()} - {None} <= set(data["kinds"])
    assert set(data["floors"]) <= set(ROOMS)
    assert set(data["accents"]) == set(data["kinds"])
    for palette in palettes().values():
        assert set(palette.groups) <= set(data["kinds"])


@for_each(sorted(ROOMS))
def test_each_room_has_a_palette_for_each_of_its_styles_and_they_vary(name):
    groups = set(groups_of(name))
    for style in ROOMS[name].styles:
        chosen = [palette_for(name, style, (), seed) for seed in range(12)]
        assert all(groups & set(p.groups) for p in chosen)
        assert all(style in p.styles for p in chosen)
    found = {palette_for(name, style, (), seed).name for seed in range(40) for style in ROOMS[name].styles}
    assert len(found) >= 2


def test_a_room_that_is_in_no_group_has_the_palettes_of_a_home():
    assert groups_of("zorb_hall") == (FALLBACK,)


def test_equal_seeds_give_equal_palettes():
    assert palette_for("bedroom", "modern", (), 5) == palette_for("bedroom", "modern", (), 5)
    assert floor_for("bedroom", "wood", 5) == floor_for("bedroom", "wood", 5)
    assert accent_for("bedroom", 5) == accent_for("bedroom", 5)


def test_colours_of_the_request_win():
    palette = palette_for("bedroom", "modern", ("navy", "gold"), 3)
    assert palette.accent == "navy"
    assert palette.textiles[0] == "navy"
    assert palette.metals == ("brass",)
    pale = palette_for("bedroom", "modern", ("ivory",), 3)
    assert pale.walls == "ivory"
    assert "ivory" in pale.textiles
    assert len(pale.textiles) <= 3


def test_a_word_that_is_no_colour_changes_nothing():
    assert palette_for("bedroom", "modern", ("octarine",), 3) == palette_for("bedroom", "modern", (), 3)


def test_floors_and_accents_vary_and_keep_to_what_is_known():
    assert {floor_for("bedroom", "wood", s) for s in range(40)} == {"wood", "carpet"}
    assert {floor_for("garage", "concrete", s) for s in range(10)} == {"concrete"}
    assert {accent_for("bedroom", s) for s in range(60)} == {"plain", "paint", "paper", "panelling"}


def test_a_palette_has_two_woods_at_most():
    row = palettes()["fjord"].model_dump(by_alias=True)
    from sceneweaver.knowledge.palettes import Palette

    with pytest.raises(InputError, match="woods"):
        Palette(**(row | {"woods": ("oak", "birch", "pine")}))


@for_each(palettes())
def test_floors_are_quiet(name):
    """Terracotta tiles are the loudest floor that people live on; carpets are quieter."""
    for material, tone in palettes()[name].floors.items():
        if material != "wood":
            colour = shade(tone)
            assert max(colour) - min(colour) < (0.3 if material == "carpet" else 0.45), (material, tone)
