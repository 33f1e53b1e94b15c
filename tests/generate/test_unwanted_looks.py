"""Rooms without the colours and materials that a request does not want."""

from sceneweaver.assets import Library, Wish
from sceneweaver.assets.materials import color_name, color_named
from sceneweaver.assets.scheme import scheme_for
from sceneweaver.generate.unwanted_looks import avoided, of_room
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import read_request

CODE = "oak/white paint,black paint/black steel/grey,pink,black/3"


def test_palettes_have_nothing_of_a_color_that_is_not_wanted():
    unwanted = of_room(avoided(read_request("a girl's bedroom, nothing pink, no blue")))
    for seed in range(6):
        found = palette_for("childrens_room", colors=("white",), seed=seed, avoid=unwanted)
        names = {color_named(name) for name in (found.walls, found.accent, *found.textiles)}
        assert not names & {"pink", "blue", "navy", "light blue"}


def test_a_color_is_avoided_by_the_things_that_are_meant():
    entries = avoided(read_request("a kitchen with no black appliances"))
    code = f"{CODE}/{','.join(entries)}"
    of_fridge, of_chair = scheme_for("fridge", code), scheme_for("chair", code)
    assert "black" not in {color_name(one.material.color) for one in (*of_fridge.paints, *of_fridge.metals)}
    assert "black" in {color_name(one.material.color) for one in of_chair.metals}


def test_what_has_colors_of_its_own_avoids_them_too():
    made = [
        Library().load(Library().choose("books", 1, Wish(palette=f"{CODE}/red,burgundy", seed=seed))[0].id)
        for seed in range(3)
    ]
    colors = {color_name(material.color) for asset in made for material in asset.mesh.materials}
    assert not colors & {"red", "burgundy"}
