"""Few things, many things, and things that do not belong."""

from __future__ import annotations

from collections import Counter

from sceneweaver.agent.loop import empty_scene
from sceneweaver.assets import Library
from sceneweaver.assets.roles import groups_above
from sceneweaver.generate.quantity import DECORATION
from sceneweaver.knowledge import RoomType, room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


def drafted(text: str, kind: RoomType) -> Scene:
    graph = read_request(text)
    scene = InitPrior().propose(Context(graph, kind, empty_scene(graph, kind), Library(), seed=1)).scene
    assert scene is not None
    return scene


def test_a_sparse_room_has_no_decoration() -> None:
    kind = room_type("living_room")
    assert any(groups_above(o.category) & DECORATION for o in drafted("a living room", kind).objects)
    sparse = drafted("a living room with an armchair and very little else", kind)
    assert not any(groups_above(o.category) & DECORATION for o in sparse.objects)
    assert "armchair" in {o.category for o in sparse.objects}


def test_what_is_everywhere_is_on_the_floor_and_on_furniture() -> None:
    scene = drafted("a living room with plants absolutely everywhere", room_type("living_room"))
    plants = [o for o in scene.objects if o.intent.request == "potted_plant"]
    assert len(plants) >= 8 and {o.category for o in plants} == {"potted_plant", "small_plant"}
    assert {o.mount for o in plants} == {"floor", "surface"}


def test_what_is_on_every_surface_is_spread() -> None:
    scene = drafted("a kitchen with bottles on every surface", room_type("kitchen"))
    on = Counter(o.support.object for o in scene.objects if o.intent.request == "bottle" and o.support is not None)
    assert sum(on.values()) >= 10 and len(on) >= 3


def test_what_never_belongs_in_a_room_is_not_added_unless_it_is_asked_for() -> None:
    kind = room_type("living_room").model_copy(update={"never": ("sofa", "plant_group")})
    assert not {"sofa", "potted_plant"} & {o.category for o in drafted("a living room", kind).objects}
    assert "sofa" in {o.category for o in drafted("a living room with a sofa", kind).objects}


def test_chairs_that_stand_at_a_table_leave_no_desks_without_any() -> None:
    scene = drafted("a dormitory with one long table and four chairs at the table", room_type("dormitory"))
    assert "desk" not in {o.category for o in scene.objects}
    assert sum(o.intent.request == "chair" for o in scene.objects) == 4


def test_a_huge_lamp_hangs_no_lower_than_others() -> None:
    scene = drafted("a dining room with one huge pendant over the table", room_type("dining_room"))
    lamp, table = (next(o for o in scene.objects if o.intent.program_item == name) for name in ("pendant", "table"))
    assert scene.room.height - lamp.size[2] > table.size[2] + 0.5
    assert lamp.size[1] > 0.6


def test_a_general_word_takes_no_other_thing_of_that_name() -> None:
    scene = drafted("a game room with a small table", room_type("game_room"))
    assert {o.category for o in scene.objects if o.intent.request == "dining_table"} & {"pool_table"} == set()
    chairs = drafted("a bedroom with a desk and two chairs at the desk", room_type("bedroom")).objects
    assert {o.category for o in chairs if o.intent.request == "chair"} <= {"chair", "office_chair", "dining_chair"}


def test_in_a_small_bathroom_the_shower_that_is_asked_for_is_the_only_bath() -> None:
    tubs = {"bathtub", "freestanding_bathtub"}
    small = drafted("a small bathroom with a shower", room_type("bathroom"))
    assert "shower" in {o.category for o in small.objects} and not tubs & {o.category for o in small.objects}
