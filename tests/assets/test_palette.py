"""A room's palette: what is drawn for it has its woods, its metal and its colours, unless something else is asked."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library, Wish
from sceneweaver.assets.materials import color_name, color_named, finishes, hue
from sceneweaver.scene import InputError, Palette
from tests.sizes import share

PALETTE = Palette(
    name="test",
    style="modern",
    woods=("walnut",),
    paints=("white paint",),
    metals=("brass",),
    textiles=("off white", "navy", "mustard"),
    seed=3,
)
FURNITURE = ("bed", "nightstand", "wardrobe", "dresser", "sofa", "armchair", "dining_chair", "dining_table", "rug")
SMALL = (
    "cushion",
    "table_lamp",
    "mug",
    "vase",
    "toy_car",
    "storage_box",
    "folded_towel",
    "building_blocks",
    "pen_holder",
)
DYED = ("paint", "fabric", "leather", "plastic", "ceramic")


def drawn(category: str, **wish: object):
    return Library().choose(category, 1, Wish(style="modern", palette=PALETTE.code, **wish))[0]  # type: ignore[arg-type]


@pytest.mark.parametrize("category", share(FURNITURE + SMALL, 2))
def test_everything_follows_the_palette(category):
    hues = {hue(color_named(c)) for c in PALETTE.textiles} | {None}
    woods = {name for name, f in finishes().items() if f.family == "wood"}
    for seed in range(4):
        for material in drawn(category, seed=seed).mesh.materials:
            family = material.name.rpartition(" ")[2]
            assert material.name not in woods - {"walnut"}
            if family in DYED:
                assert hue(color_name(material.color)) in hues, (category, seed, material.name)


def test_furniture_of_a_room_has_one_finish_and_rooms_differ():
    bodies = {drawn("kitchen_cabinet", seed=s).attributes["material"] for s in range(5)}
    bodies |= {drawn("kitchen_counter", seed=s).attributes["material"] for s in range(5)}
    assert len(bodies) == 1
    codes = [PALETTE.model_copy(update={"seed": k}).code for k in range(12)]
    looks = {Library().choose("dresser", 1, Wish(palette=code))[0].attributes["material"] for code in codes}
    assert looks == {"walnut", "white paint"}


def test_in_a_room_of_one_colour_all_is_painted_or_dyed():
    white = PALETTE.model_copy(update={"woods": ("white paint",), "metals": ("white steel",), "textiles": ("white",)})
    for category in ("dining_table", "sofa", "vase"):
        made = Library().choose(category, 1, Wish(style="modern", palette=white.code))[0]
        assert made.attributes["color"] == "white", category


def test_prints_are_seen_and_have_the_colour_that_is_named():
    rug = drawn("rug", material="leopard", seed=1)
    assert {m.printed for m in rug.mesh.materials if m.name == "leopard"} == {True}
    sofa = drawn("sofa", material="striped", color="green", seed=1)
    assert any(m.printed and m.name == "green striped" for m in sofa.mesh.materials)


def test_what_is_asked_wins():
    assert drawn("sofa", color="green", seed=1).attributes["color"] == "green"
    assert "oak" in drawn("dining_table", material="oak", seed=1).attributes["material"]


def test_an_id_draws_the_same_again_and_books_keep_their_colors():
    asset = drawn("sofa", seed=5)
    again = Library().load(asset.id)
    assert again.id == asset.id and again.mesh.materials == asset.mesh.materials
    covers = {m.name for s in range(4) for m in drawn("standing_books", seed=s).mesh.materials}
    assert len({hue(color_name(finishes()[c].material.color)) for c in covers if c in finishes()} - {None}) > 3


@pytest.mark.parametrize(
    "code", ["oak", "oak/white paint/brass/navy/x", "oak/oak/brass/navy/1", "elm/white paint/brass/navy/1"]
)
def test_a_code_that_is_none_is_refused(code):
    with pytest.raises(InputError, match="palette"):
        Library().choose("sofa", 1, Wish(palette=code))


@pytest.mark.parametrize(
    "change", [{"woods": ()}, {"woods": ("oak", "pine", "teak")}, {"textiles": ("a", "b", "c", "d")}]
)
def test_a_palette_has_two_woods_and_three_colors_at_most(change):
    with pytest.raises(InputError):
        Palette(**{**PALETTE.model_dump(), **change})
