"""What hangs from hooks, rails and radiators: bodies below or before what carries them, clear of each other."""

import pytest
import shapely

from sceneweaver.assets import Library, Wish
from sceneweaver.assets.carrying import carrier, hangs_from, is_hook
from sceneweaver.generate.cavities import hollow, upright
from sceneweaver.generate.hooks import bare, hang, hooks_of, hung_body, lift_of
from sceneweaver.language import read_request

WISH = Wish(seed=3)


def _hung(category, thing, count, noun):
    library = Library()
    body = bare(library.choose(category, 1, WISH)[0], category, WISH, library)
    bodies = [hung_body(one, thing, noun, WISH, library) for one in library.choose(thing, count, WISH)]
    obj = body.object("carrier", mount=body.mount)
    return obj, bodies, hang(obj, carrier(category), bodies, lift_of(body.mount, body, 2.6, None), body.mount == "wall")


@pytest.mark.parametrize(
    ("category", "thing", "count", "noun"),
    [
        ("towel_radiator", "folded_towel", 2, "towels"),
        ("coat_rack", "apron", 3, "coats"),
        ("clothes_rack", "folded_clothes", 6, "dresses"),
        ("pot_rack", "frying_pan", 3, "pans"),
        ("chair", "backpack", 1, "backpack"),
    ],
)
def test_what_hangs_is_clear_of_its_carrier_and_of_the_others(category, thing, count, noun):
    obj, bodies, found = _hung(category, thing, count, noun)
    assert None not in found
    taken = [(shapely.Polygon(part.polygon), part.z) for part in obj.solids]
    for body, surface in zip(bodies, hooks_of(list(zip(bodies, found, strict=True))), strict=True):
        assert is_hook(surface.name)
        own, (low, high) = shapely.Polygon(surface.polygon).buffer(-0.002), (surface.z, surface.z + body.size[2])
        for shape, (z0, z1) in taken:
            assert z1 <= low + 1e-6 or z0 >= high - 1e-6 or own.intersection(shape).area < 1e-6
        gap = min(max(own.distance(shape), z0 - high, low - z1) for shape, (z0, z1) in taken[: len(obj.solids)])
        assert gap < 0.01  # it touches what it hangs from
        taken.append((own, (low, high)))


def test_garments_hang_side_by_side_along_a_rail_and_what_usually_hangs_there_gives_way():
    obj, _, found = _hung("clothes_rack", "folded_clothes", 5, "shirts")
    assert max(part.z[1] - part.z[0] for part in obj.solids if part.polygon[0][0] < -0.1) < 0.5
    assert len({round(place.y, 2) for place in found}) == 5
    assert all(abs(place.yaw) > 1.5 for place in found)


def test_a_thing_that_is_told_to_be_on_hooks_hangs_and_on_a_radiator_only_cloth_does():
    assert hangs_from("hat", "hat", carrier("coat_hooks"))
    assert not hangs_from("shoe_pair", "shoes", carrier("clothes_rack"))
    assert hangs_from("folded_towel", "towel", carrier("radiator"))
    assert not hangs_from("vase", "vase", carrier("radiator"))
    assert not hangs_from("handbag", "handbag", carrier("dining_table"))


def test_a_vessel_keeps_its_cavity_free_for_what_is_put_into_it():
    mug = Library().choose("mug", 1, WISH)[0]
    opened = hollow(mug)
    inner = shapely.Polygon(opened.surfaces[-1].polygon).buffer(-0.001)
    floor = opened.surfaces[-1].z
    assert not any(
        part.z[1] > floor + 0.001 and shapely.Polygon(part.polygon).intersection(inner).area > 1e-7
        for part in opened.parts
    )
    assert hollow(opened) is opened
    pen = Library().choose("pen", 1, WISH)[0]
    assert upright(pen, "pen", WISH, Library()).size[2] == pytest.approx(max(pen.size), abs=0.002)


@pytest.mark.parametrize(
    ("text", "subject", "kind", "target"),
    [
        ("A cloakroom with a coat stand and two coats on the coat stand", "apron", "hanging_from", "coat_rack"),
        ("A porch with a backpack hanging from hooks on the wall", "backpack", "hanging_from", "coat_hooks"),
        ("A galley with pans hung on a pan rack above the stove", "frying_pan", "hanging_from", "pot_rack"),
        ("A den with an armchair and a throw draped over the armchair", "blanket_throw", "on", "armchair"),
        ("A gym with towels in a basket", "folded_towel", "inside", "basket"),
        ("A porch, a bowl with keys in it on the console table", "bowl", "on", "console_table"),
        ("A porch with hats on top of the wardrobe", "hat", "on", "wardrobe"),
    ],
)
def test_a_word_of_place_means_how_the_one_carries_the_other(text, subject, kind, target):
    assert (subject, kind, target) in {(r.subject, r.type, r.targets[0]) for r in read_request(text).relations}


def test_what_ends_a_list_of_contents_and_has_its_own_place_is_no_content():
    graph = read_request("A study with a bookcase full of books and a globe on the desk")
    assert [r.targets[0] for r in graph.relations if r.subject == "desk_globe"] == ["desk"]
