"""Kitchens in two runs: told in many ways, washed at along one wall and cooked at along the wall opposite."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library
from sceneweaver.generate.kitchen_runs import in_two_runs, run_categories, sides_meant
from sceneweaver.generate.room import first_draft
from sceneweaver.generate.setup import Setup
from sceneweaver.knowledge import room_type
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement
from sceneweaver.scene import Room, Scene

EMPTY = Scene(id="empty", room=Room(outline=((0, 0), (4, 0), (4, 3), (0, 3))))

UNITS = ("sink_cabinet", "dishwasher", "stove", "fridge")


def kitchen(*relations: tuple[str, str, str], **more: object) -> SceneGraph:
    entities = tuple(Entity(id=name, noun=name, category=name, count=(1, 1)) for name in UNITS)
    stated = tuple(
        StatedRelation(id=f"relation-{k}", type=kind, subject=subject, targets=(target,))  # type: ignore[arg-type]
        for k, (kind, subject, target) in enumerate(relations)
    )
    return SceneGraph(text="", entities=entities, relations=stated, **more)  # type: ignore[arg-type]


ROWS = Arrangement(id="arrangement-0", entity="runs", pattern="rows", rows=2, columns=1)
TWO_RUNS = {
    "its word": kitchen(room_words="galley kitchen"),
    "two rows of units": kitchen(arrangements=(ROWS,)),
    "what is opposite": kitchen(("opposite", "stove", "sink_cabinet")),
    "named walls": kitchen(("against", "stove", "wall:left"), ("against", "sink_cabinet", "wall:right")),
}


@pytest.mark.parametrize("told", TWO_RUNS)
def test_two_runs_are_along_opposite_walls(told: str, library: Library) -> None:
    brief = TWO_RUNS[told].model_copy(update={"size": (4.4, 2.5)})
    setup = Setup(brief=brief, room_type=room_type("kitchen"), scene=EMPTY, library=library, seed=1)
    proposal = first_draft(setup)
    scene = proposal.scene
    assert scene is not None and proposal.variants
    walls = scene.room.walls
    for variant in proposal.variants:
        led = {r.subject: r.target for r in variant if r.type == "against_wall"}
        of = {}
        for r in variant:
            if r.type == "run_on":
                of[r.subject] = of.get(str(r.target), str(r.target))
        runs = {leader: {leader, *(name for name, to in of.items() if to == leader)} for leader in led}
        assert len(runs) == 2
        first, second = (walls[int(str(target).partition(":")[2])].outward for target in led.values())
        assert first[0] * second[0] + first[1] * second[1] < -0.99
        for pair in (("sink_cabinet-0", "dishwasher-0"), ("stove-0", "fridge-0")):
            assert any(set(pair) <= run for run in runs.values())
        assert not any({"sink_cabinet-0", "stove-0"} <= run for run in runs.values())
    assert not [o.id for o in scene.objects if o.category in ("dining_table", "corner_cabinet")]


def test_other_kitchens_are_not_in_two_runs():
    units = run_categories(room_type("kitchen"))
    assert not in_two_runs(kitchen(), units)
    assert not in_two_runs(kitchen(("next_to", "stove", "fridge")), units)
    assert not in_two_runs(kitchen(("against", "stove", "wall:left"), ("against", "fridge", "wall:left")), units)
    assert not in_two_runs(kitchen(room_words="galley kitchen"), ())


def test_a_unit_on_the_opposite_side_is_opposite_the_other_run():
    said = StatedRelation(type="opposite", subject="fridge", targets=("stove",), words="opposite side")
    brief = kitchen(room_words="galley kitchen").model_copy(update={"relations": (said,)})
    assert sides_meant(brief, room_type("kitchen")).relations[0].targets == ("sink_cabinet",)
    across = said.model_copy(update={"targets": ("sink_cabinet",)})
    assert sides_meant(brief.model_copy(update={"relations": (across,)}), room_type("kitchen")).relations == (across,)
