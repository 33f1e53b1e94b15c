"""A kitchen run around a corner: which wall has the sink, how wide the units are, what hangs over them."""

from __future__ import annotations

import pytest

from sceneweaver.knowledge import room_type
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


@pytest.fixture
def propose(library):
    """The proposal of the prior for a request and a seed."""

    def run(words: str, seed: int = 1):
        brief = read_request(words)
        empty = Scene(id="empty", room={"outline": ((0, 0), (3, 0), (3, 3), (0, 3))})
        return InitPrior().propose(Context(brief, room_type(brief.room_type or ""), empty, library, seed))

    return run


def _chain(variant, leader):
    """The pieces of a run to either side of its corner unit, from there on."""
    wings = {"right": [], "left": []}
    for side, wing in wings.items():
        at = leader
        while True:
            ahead = [r for r in variant if r.type == "run_on" and r.target == at and r.params["side"] == side]
            if not ahead:
                break
            at = ahead[0].subject
            wing.append(at)
    return wings


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_the_sink_comes_before_the_middle_of_a_window(propose, seed):
    proposal = propose("a kitchen", seed)
    scene, variant = proposal.scene, proposal.variants[0]
    (corner,) = (o for o in scene.objects if o.category == "corner_cabinet")
    walls = {r.type: int(r.target.split(":")[1]) for r in variant if r.subject == corner.id}
    wings = _chain(variant, corner.id)
    side = next(side for side, wing in wings.items() if any("sink" in one for one in wing))
    wall = walls["against_wall" if side == "right" else "side_against_wall"]
    (window,) = scene.room.windows
    assert window.wall == wall
    at = corner.size[1]
    for name in wings[side]:
        width = scene.object(name).size[1]
        if "sink" in name:
            break
        at += width
    length = scene.room.walls[wall].length
    middle = window.offset + window.width / 2
    middle = middle if side == "right" else length - middle
    assert at + scene.object(name).size[1] / 2 == pytest.approx(middle, abs=0.3)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_run_is_one_piece(propose, seed):
    """One height, one finish of fronts and worktops, the fridge at an end and no stove in the corner."""
    proposal = propose("a kitchen", seed)
    scene, variant = proposal.scene, proposal.variants[0]
    by_item = {o.intent.program_item: o for o in scene.objects}
    run = {r.subject for r in variant if r.type == "run_on"} | {by_item["corner"].id}
    ends = {wing[-1] for wing in _chain(variant, by_item["corner"].id).values()}
    assert by_item["fridge"].id in ends
    run = {name for name in run if scene.object(name).mount == "floor"}
    units = [scene.object(name) for name in run - {by_item["fridge"].id}]
    assert {round(o.size[2], 3) for o in units} <= {0.9, 1.24}, "1.24 m is a worktop of 0.9 m with its tap"
    assert len({round(o.size[0], 3) for o in units if o.category != "corner_cabinet"}) == 1
    fronts = {o.attributes["material"] for o in units if "cabinet" in o.category or "counter" in o.category}
    assert len(fronts) == 1


def test_cabinets_hang_around_the_corner_and_not_before_the_window(propose):
    scene = propose("a kitchen", 3).scene
    variant = propose("a kitchen", 3).variants[0]
    hung = {o.intent.program_item: o for o in scene.objects if "wall_cabinet" in o.category}
    assert hung["wall_cabinet"].size[1] == pytest.approx(scene.object("kitchen_counter-0").size[1], abs=2e-3)
    tied = {r.subject: r.target for r in variant if r.subject in {o.id for o in hung.values()}}
    assert tied[hung["wall_cabinet_corner"].id] == hung["wall_cabinet"].id
    assert all(o.size[1] >= 0.3 for o in hung.values())


def test_a_small_kitchen_goes_without_what_is_only_usual(propose):
    scene = propose("a kitchen of 2.6 by 3.2 m").scene
    items = {o.intent.program_item for o in scene.objects}
    assert {"fridge", "stove", "sink", "counter"} <= items
    width = sum(o.size[1] for o in scene.objects if o.intent.program_item in ("fridge", "stove", "counter", "cabinet"))
    assert width + ("corner" in items) * 0.92 < 3.2


def test_every_way_has_the_widths_that_were_drawn(propose):
    """Going around another corner, or the other way around, changes no body."""
    for seed in range(1, 9):
        proposal = propose("a kitchen", seed)
        placed = [frozenset(r.subject for r in variant) for variant in proposal.variants]
        assert placed and len(set(placed)) == 1


def test_a_sink_that_is_named_is_no_counter(propose):
    scene = propose("a kitchen with a sink under the window and a fridge in the corner").scene
    asked = [o.category for o in scene.objects if o.intent.request is not None]
    assert "sink_cabinet" in asked and "kitchen_counter" not in asked
