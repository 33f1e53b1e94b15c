"""The rules for small things, colours, style and what makes a room complete: kept by one room, broken by another."""

from __future__ import annotations

import pytest

from sceneweaver.knowledge.complete import expected_of
from sceneweaver.scene import Palette, Pose, SceneObject
from tests.critic.breaches import box, broken, hung, on, top

Boxes = list[SceneObject]

SHELF = top(box("linen_cabinet-0", (0.4, 0.9, 1.9), 5.7, 2.5, 180))
LOW = top(box("cabinet-0", (0.4, 0.9, 0.9), 5.7, 2.5, 180))
BED = box("bed-0", (2.0, 1.6, 0.5), 1.05, 2.25)
STANDS = [top(box(f"nightstand-{k}", (0.4, 0.45, 0.5), 0.25, y)) for k, y in enumerate((1.2, 3.3))]


def seated(height: float) -> Boxes:
    """A desk with a chair whose seat is at a height [m], its back twice as high."""
    from sceneweaver.scene import Part

    chair = box("kids_chair-0", (0.4, 0.4, 2 * height), 3.5, 2.5, 180)
    square = ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))
    back = ((-0.2, -0.2), (-0.15, -0.2), (-0.15, 0.2), (-0.2, 0.2))
    parts = (Part(polygon=square, z=(0.0, height)), Part(polygon=back, z=(height, 2 * height)))
    return [top(box("desk-0", (0.7, 1.4, 0.72), 3.0, 2.5)), chair.model_copy(update={"parts": parts})]


def pictures(*seeds: int) -> Boxes:
    row = [hung(f"picture-{k}", (0.03, 0.6, 0.8), 1 + k, 4.98, -90, 1.1) for k in range(len(seeds))]
    return [p.model_copy(update={"asset": f"parametric:picture?seed={s}"}) for p, s in zip(row, seeds, strict=True)]


def furniture(*looks: tuple[str, str]) -> Boxes:
    """Cabinets, each of a colour and a material."""
    return [
        box(f"cabinet-{k}", (0.5, 0.9, 1.0), 0.6 + k, 4.7, -90, color=color, material=material)
        for k, (color, material) in enumerate(looks)
    ]


def small(*styles: str) -> Boxes:
    things = [on(LOW, f"vase-{k}", (0.05, 0.05, 0.2), style=style, color="red") for k, style in enumerate(styles)]
    return [LOW, *things]


def lamps(first: str, second: str) -> Boxes:
    pair = [on(s, f"table_lamp-{k}", material=m) for k, (s, m) in enumerate(zip(STANDS, (first, second), strict=True))]
    return [BED, *STANDS, *pair]


BLUE, GREEN, RED = ("blue", "blue paint"), ("green", "green paint"), ("red", "red paint")
OAK, WALNUT, ASH = ("tan", "oak"), ("brown", "walnut"), ("grey", "ash grey wood")
BLACK = ("black", "black paint")

BREACHES: list[tuple[str, str, Boxes, Boxes, set[str]]] = [
    (
        "daily_things_in_reach",
        "bathroom",
        [LOW, on(LOW, "towel_roll-0")],
        [SHELF, on(SHELF, "towel_roll-0")],
        {"towel_roll-0"},
    ),
    ("belongs_to_room", "meeting_room", [LOW, on(LOW, "mug-0")], [LOW, on(LOW, "knife_block-0")], {"knife_block-0"}),
    (
        "one_of_each",
        "kitchen",
        [LOW, on(LOW, "knife_block-0")],
        [LOW, on(LOW, "knife_block-0"), on(LOW, "knife_block-1")],
        {"knife_block-0", "knife_block-1"},
    ),
    ("not_cloned", "bedroom", pictures(1, 2), pictures(1, 1), {"picture-0", "picture-1"}),
    (
        "fits_its_place",
        "kitchen",
        [hung("wall_clock-0", (0.03, 0.3, 0.3), 2, 4.98, -90, 1.7)],
        [hung("wall_clock-0", (0.03, 0.6, 0.6), 2, 4.98, -90, 1.7)],
        {"wall_clock-0"},
    ),
    (
        "fits_its_place",
        "meeting_room",
        [hung("whiteboard-0", (0.05, 1.8, 1.1), 2, 4.98, -90, 0.9)],
        [hung("whiteboard-0", (0.05, 0.9, 1.1), 2, 4.98, -90, 0.9)],
        {"whiteboard-0"},
    ),
    ("seat_fits_table", "childrens_room", seated(0.46), seated(0.28), {"desk-0", "kids_chair-0"}),
    (
        "three_hues",
        "living_room",
        furniture(BLUE, GREEN, OAK),
        furniture(BLUE, GREEN, RED, OAK),
        {"cabinet-0", "cabinet-2"},
    ),
    ("two_woods", "living_room", furniture(OAK, WALNUT), furniture(OAK, WALNUT, ASH), {"cabinet-2"}),
    ("not_one_colour", "living_room", furniture(BLACK, BLUE, OAK), furniture(BLACK, BLACK, BLACK, BLACK), {""}),
    ("pairs_match", "bedroom", lamps("brass", "brass"), lamps("brass", "oak"), {"table_lamp-0", "table_lamp-1"}),
    (
        "complete_for_its_kind",
        "waiting_room",
        [box("palm-0", (0.6, 0.6, 1.6), 1, 4), box("kids_table-0", (0.6, 0.6, 0.5), 4, 4)],
        [box("palm-0", (0.6, 0.6, 1.6), 1, 4)],
        {""},
    ),
]


@pytest.mark.parametrize(
    ("rule", "kind", "good", "bad", "objects"), BREACHES, ids=[f"{k}-{line[0]}" for k, line in enumerate(BREACHES)]
)
def test_a_room_keeps_the_rule_and_another_breaks_it(rule, kind, good, bad, objects) -> None:
    assert not broken(rule, kind, good)
    assert objects <= broken(rule, kind, bad)


def test_a_shelf_along_the_far_side_of_a_desk_is_not_what_one_sits_at() -> None:
    from sceneweaver.scene import Surface

    desk, chair = seated(0.46)
    rear = ((-0.35, -0.7), (-0.1, -0.7), (-0.1, 0.7), (-0.35, 0.7))
    fore = ((-0.1, -0.7), (0.35, -0.7), (0.35, 0.7), (-0.1, 0.7))
    surfaces = (Surface(name="shelf", polygon=rear, z=1.0), Surface(name="top", polygon=fore, z=0.72))
    desk = desk.model_copy(update={"surfaces": surfaces})
    assert not broken("seat_fits_table", "office", [desk, chair])
    turned = desk.model_copy(update={"pose": Pose.from_yaw(3.0, 2.5, 0.0, 3.1415926)})
    assert desk.id in broken("seat_fits_table", "office", [turned, chair])


def test_small_things_follow_the_style_or_the_palette() -> None:
    modern, mixed = small(*["modern"] * 7), small("modern", *["rustic"] * 6)
    style = {"style": "modern"}
    assert not broken("small_things_in_style", "bedroom", modern, provenance=style)
    assert "vase-6" in broken("small_things_in_style", "bedroom", mixed, provenance=style)
    look = {"woods": ("oak",), "metals": ("brass",), "textiles": ("beige",), "name": "x", "style": "modern"}
    red, blue = Palette(paints=("red paint",), **look), Palette(paints=("blue paint",), **look)
    assert not broken("small_things_in_style", "bedroom", mixed, palette=red)
    assert "vase-6" in broken("small_things_in_style", "bedroom", mixed, palette=blue)


@pytest.mark.parametrize(
    ("material", "color", "textile", "metal", "follows"),
    [
        ("rust ceramic", "orange", "rust", "iron", True),  # the dye itself, though its basic colour has another name
        ("orange ceramic", "orange", "rust", "iron", True),  # of its hue
        ("teal ceramic", "teal", "rust", "iron", False),
        ("charcoal ceramic", "navy", "charcoal", "iron", True),  # the nearest basic colour of a dye misleads
        ("brass", "gold", "grey", "brass", True),
        ("brass", "gold", "grey", "iron", False),
        ("green glass", "dark green", "grey", "iron", True),  # what a bottle is made of
    ],
)
def test_small_things_follow_dyes_and_metals_of_the_palette(material, color, textile, metal, follows) -> None:
    look = Palette(
        name="x", style="modern", woods=("oak",), paints=("white paint",), metals=(metal,), textiles=(textile,)
    )
    things = [on(LOW, f"vase-{k}", (0.05, 0.05, 0.2), style="modern", color=color, material=material) for k in range(7)]
    found = broken("small_things_in_style", "bedroom", [LOW, *things], palette=look)
    assert bool(found) != follows


def test_what_does_not_belong_or_is_there_twice_can_be_removed() -> None:
    from sceneweaver.critic.design import faults
    from tests.critic.breaches import survey

    things = [LOW, on(LOW, "coffee_maker-0"), on(LOW, "coffee_maker-1"), on(LOW, "perfume-0")]
    found = {f.fault.rule: f.fault for f in faults(survey("kitchen", things))}
    assert found["one_of_each"].inputs == {"ids": ["coffee_maker-1"]}
    assert found["belongs_to_room"].inputs == {"ids": ["perfume-0"]}
    assert {found[r].tool for r in ("one_of_each", "belongs_to_room")} == {"remove_objects"}


def test_what_a_request_names_is_neither_foreign_nor_spare() -> None:
    from sceneweaver.scene import Intent

    asked = on(LOW, "knife_block-0").model_copy(update={"intent": Intent(priority="asked")})
    assert not broken("belongs_to_room", "bedroom", [LOW, asked])
    assert not broken("one_of_each", "kitchen", [LOW, asked, on(LOW, "knife_block-1")])


def test_what_makes_a_room_complete_is_known_by_room() -> None:
    assert {row.why for row in expected_of("gym")} >= {"lockers"} and not expected_of("storage_room")


def test_what_people_look_for_in_a_room_is_not_foreign_to_it() -> None:
    from sceneweaver.critic.design import other_faults
    from tests.critic.breaches import survey

    def foreign(kind: str, *things: SceneObject) -> set[str]:
        found = [f.fault for f in other_faults(survey(kind, things)) if f.fault.kind == "foreign_object"]
        return {name for fault in found for name in fault.objects}

    ball, treadmill = box("medicine_ball-0", (0.3, 0.3, 0.3), 2, 2), box("treadmill-0", (1.8, 0.8, 1.4), 4, 2)
    trolley = box("serving_trolley-0", (0.5, 0.8, 0.9), 3, 4)
    assert foreign("living_room", ball) == {"medicine_ball-0"}
    assert foreign("storage_room", trolley) == {"serving_trolley-0"} and not foreign("restaurant", trolley)
    assert "treadmill-0" in foreign("bedroom", treadmill)
