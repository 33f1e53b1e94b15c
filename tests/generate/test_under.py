"""What a request puts under a thing, on top of a thing with doors, and what it hangs below a window."""

from __future__ import annotations

from sceneweaver.knowledge import room_type
from sceneweaver.scene import Scene
from tests.generate.test_quantity import drafted


def asked(scene: Scene, kind: str) -> list[tuple[str, str, bool]]:
    return [(r.subject, str(r.target), r.hard) for r in scene.relations if r.type == kind and r.asked]


def test_shoes_have_a_place_each_in_the_frame_of_their_bench():
    scene = drafted("a hallway with a bench and two pairs of shoes under the bench", room_type("hallway"))
    shoes = [o.id for o in scene.objects if o.category == "shoe_pair" and o.intent.request]
    rows = asked(scene, "arranged")
    assert shoes and {row[0] for row in rows} == set(shoes) and all(hard for _, _, hard in rows)
    places = {(r.params["ahead"], r.params["left"]) for r in scene.relations if r.type == "arranged"}
    assert len(places) == len(shoes)


def test_a_desk_under_a_bed_looks_out_where_one_climbs_up_and_has_nothing_above_it():
    scene = drafted("a bedroom with a loft bed and a desk under the loft bed", room_type("teen_bedroom"))
    (row,) = [r for r in scene.relations if r.type == "arranged"]
    loft = scene.object("loft_bed-0")
    entered = {zone.name for zone in loft.zones if zone.hard}
    assert {90.0: "left", -90.0: "right", 0.0: "front"}[row.params["turn"]] in entered
    over = [r for r in scene.relations if r.type == "above" and r.target == row.subject]
    assert over == []


def test_on_top_of_a_fridge_is_no_shelf_in_it():
    scene = drafted("a kitchen with a toaster on top of the fridge", room_type("kitchen"))
    (toaster,) = [o for o in scene.objects if o.category == "toaster" and o.intent.request]
    assert toaster.support is not None and toaster.support.surface == "top"
    inside = drafted("a kitchen with a bottle in the fridge", room_type("kitchen"))
    (bottle,) = [o for o in inside.objects if o.category == "bottle" and o.intent.request]
    assert bottle.support is not None and bottle.support.surface != "top"


def test_what_hangs_below_a_window_hangs_under_its_sill():
    scene = drafted("an office, and below its window an air conditioner", room_type("office"))
    (unit,) = [o for o in scene.objects if o.category == "air_conditioner"]
    sill = min(w.sill for w in scene.room.windows)
    assert unit.mount == "wall" and unit.intent.mounting_height is not None
    assert unit.intent.mounting_height[1] + unit.size[2] <= sill
