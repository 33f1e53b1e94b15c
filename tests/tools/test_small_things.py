"""What stands on furniture suits the room: nothing of another room, few of a kind, pairs alike, a plate a seat."""

from __future__ import annotations

from collections import Counter

import pytest

from sceneweaver.assets import make
from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.small_things import belongs, most_of
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Palette, Pose, Relation, Scene
from sceneweaver.tools.add_crowd import AddCrowd
from sceneweaver.tools.add_tabletop import AddTabletop
from sceneweaver.tools.base import Context
from tests.sizes import sizes

from .surface_rooms import LIBRARY, after, answer, faults, room, standing

PALETTE = Palette(
    name="p",
    style="modern",
    woods=("oak",),
    paints=("white paint",),
    metals=("brass",),
    textiles=("white", "navy"),
    seed=4,
)


def dressed(scene: Scene, kind: str, clutter: float = 0.4, seed: int = 1) -> Scene:
    """The scene with small things on all that carries some, as a room of a kind."""
    for tool in (AddTabletop(), AddCrowd()):
        context = Context(SceneGraph(text=""), room_types()[kind], scene, LIBRARY, seed, clutter=clutter)
        scene = after(scene, tool.propose(context))
    return scene


def furnished(*categories: str) -> Scene:
    """Furniture far from each other."""
    found = []
    for k, category in enumerate(categories):  # apart by more than they reach
        pose = Pose.from_yaw(-3.6 + 3.2 * (k % 3), -3.6 + 3.2 * (k // 3), 0.0, 0.0)
        found.append(make(category, 3 + k).object(f"{category}-{k}", pose=pose))
    return room(found).model_copy(update={"palette": PALETTE})


@pytest.mark.parametrize(
    ("kind", "furniture"),
    [
        ("meeting_room", ("sideboard", "cabinet", "console_table", "coffee_station", "bookcase")),
        ("office", ("cabinet", "tall_cabinet", "filing_cabinet", "round_dining_table", "desk")),
        ("kitchen", ("kitchen_counter",) * 5 + ("sink_cabinet", "kitchen_cabinet", "kitchen_island")),
        ("bathroom", ("vanity", "linen_cabinet", "shower_stool")),
        ("gym", ("metal_shelf", "gym_bench", "bench", "cabinet")),
        ("childrens_room", ("desk", "nightstand", "low_bookcase", "dresser", "toy_chest")),
    ],
)
@sizes("seeds", 1, 3)
def test_nothing_of_another_room_and_few_of_a_kind(kind, furniture, seeds):
    for seed in range(seeds):
        scene = dressed(furnished(*furniture), kind, seed=seed)
        small = Counter(o.category for o in scene.objects if o.mount == "surface")
        assert sum(small.values()) >= 2 * len(furniture)
        assert not [c for c in small if not belongs(c, kind)]
        assert all(n <= (most_of(c, kind) or n) for c, n in small.items()), small
        assert not faults(scene)


def test_wrong_rooms_and_caps_are_known():
    assert not belongs("perfume", "meeting_room") and not belongs("toothbrush_cup", "kitchen")
    assert not belongs("table_lamp", "office") and not belongs("knife_block", "meeting_room")
    assert most_of("knife_block", "kitchen") == 1 and most_of("knife_block", "office") == 0
    assert most_of("mug", "office") is None


def test_a_kitchen_sink_has_soap_and_a_sponge():
    for seed in range(3):
        names = {o.category for o in dressed(furnished("sink_cabinet"), "kitchen", seed=seed).objects}
        assert "sponge" in names and names & {"dish_soap", "soap_dispenser"} and "toothbrush_cup" not in names


def test_lamps_on_either_side_of_a_bed_are_the_same_and_mirrored():
    bed = make("bed", 2).object("bed-0", pose=Pose.from_yaw(0.0, 0.0, 0.0, 0.0))
    stands, ties = [], []
    for k, side in enumerate((1, -1)):
        pose = Pose.from_yaw(-0.8, side * (bed.size[1] / 2 + 0.35), 0.0, 0.0)
        stands.append(make("nightstand", 5).object(f"nightstand-{k}", pose=pose))
        ties.append(Relation(type="leftright_to_leftright", subject=f"nightstand-{k}", target="bed-0"))
    scene = room([bed, *stands], ties).model_copy(update={"palette": PALETTE})
    for seed in range(4):
        done = dressed(scene, "bedroom", clutter=0.0, seed=seed)
        left, right = (
            next(o for o in done.objects if o.category == "table_lamp" and o.support and o.support.object == s.id)
            for s in stands
        )
        assert left.asset == right.asset
        assert abs(left.pose.position[1] + right.pose.position[1]) < 0.06
        assert abs(left.pose.position[0] - right.pose.position[0]) < 0.06


def test_two_seats_have_two_places():
    table = make("cafe_table", 3).object("cafe_table-0", pose=Pose.from_yaw(0.0, 0.0, 0.0, 0.0))
    chairs, ties = [], []
    for k, (x, yaw) in enumerate(((0.62, 3.14159), (-0.62, 0.0))):
        chairs.append(make("dining_chair", 4).object(f"chair-{k}", pose=Pose.from_yaw(x, 0.0, 0.0, yaw)))
        ties.append(Relation(type="front_against", subject=f"chair-{k}", target="cafe_table-0"))
    scene = room([table, *chairs], ties)
    for seed in range(3):
        done = after(scene, answer(AddTabletop(), scene, {"supports": [table.id], "arrangement": "dining"}, seed))
        count = Counter(o.category for o in done.objects)
        if not count["place_setting"]:
            assert count["plate"] == count["cutlery_set"] == 2 and count["wine_glass"] + count["drinking_glass"] >= 2
        else:
            assert count["place_setting"] == 2


def test_clutter_adds_things_and_turns_them_and_none_is_a_show_room():
    scene = furnished("coffee_table", "desk", "bed", "sofa")
    counts = [
        sum(len(dressed(scene, "studio_apartment", clutter=c, seed=s).objects) for s in range(4))
        for c in (0.0, 0.4, 1.0)
    ]
    assert counts[0] < counts[1] < counts[2]
    tidy = dressed(scene, "studio_apartment", clutter=0.0)
    laid = [o for o in tidy.objects if o.category in ("book_stack", "cushion", "remote_control", "notebook")]
    assert laid and all(abs(o.pose.yaw) < 0.01 or abs(abs(o.pose.yaw) - 1.5708) < 0.01 for o in laid)
    assert not faults(dressed(scene, "studio_apartment", clutter=1.0))


def test_a_sideboard_of_a_waiting_room_is_not_dressed_like_a_living_room():
    obj = standing("sideboard")
    for kind, lamps in (("living_room", True), ("office", False)):
        names = [o.category for s in range(3) for o in dressed(room([obj]), kind, seed=s).objects]
        assert ("table_lamp" in names) is lamps
