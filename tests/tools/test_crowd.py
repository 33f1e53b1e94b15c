"""Things on shelves: every board used, tidy, under what is above, and nothing in the way of anything."""

from __future__ import annotations

import math

import pytest

from sceneweaver.assets import categories
from sceneweaver.knowledge.surfaces import crowd_of, crowds
from sceneweaver.scene import InputError, Pose, Relation
from sceneweaver.tools.add_crowd import AddCrowd
from tests.sizes import share, sizes

from .surface_rooms import after, answer, carrier, faults, room, standing

TOOL = AddCrowd()
SHELVES = sorted(c for c in crowd_of() if categories()[c].mount[0] == "floor")


@sizes("step", 4, 1)
def test_every_shelf_stands(step: int) -> None:
    shelves = [obj for obj in map(standing, SHELVES) if obj.surfaces]
    assert len(shelves) > 20
    shelves = shelves[::step]
    for obj in shelves:
        scene = room([obj])
        proposal = answer(TOOL, scene, {"supports": [obj.id]})
        done = after(scene, proposal)
        assert not faults(done), obj.category
        assert len(done.objects) > 1 or proposal.unmet, obj.category


@pytest.mark.parametrize("theme", share(sorted(crowds()), 3))
def test_every_theme_on_a_wide_shelf(theme: str) -> None:
    scene = room([standing("metal_shelf")])
    done = after(scene, answer(TOOL, scene, {"supports": ["metal_shelf-0"], "theme": theme, "density": 0.9}))
    assert len(done.objects) >= 4 and not faults(done)


def test_books_on_every_board() -> None:
    scene = room([standing("bookcase")])
    done = after(scene, answer(TOOL, scene, {"density": 0.8}))
    shelf, added = done.objects[0], done.objects[1:]
    assert {o.support.surface for o in added if o.support} == {s.name for s in shelf.surfaces}
    assert sum(o.category == "standing_books" for o in added) >= len(shelf.surfaces) - 1
    for o in added:
        if o.category == "standing_books":
            assert abs(math.remainder(o.pose.yaw - shelf.pose.yaw, 2 * math.pi)) < 1e-6


def test_a_shelf_that_hangs_high_is_filled_as_well() -> None:
    hung = standing("wall_shelf").model_copy(update={"mount": "wall"})
    x, y, _ = hung.pose.position
    scene = room([hung.model_copy(update={"pose": Pose(position=(x, y, 1.5), quaternion=hung.pose.quaternion)})])
    assert len(after(scene, answer(TOOL, scene, {"supports": [hung.id]})).objects) > 2


def test_density() -> None:
    scene = room([standing("library_shelf")])
    width = [
        sum(o.size[1] for o in after(scene, answer(TOOL, scene, {"density": d}, seed=4)).objects[1:]) for d in (0, 1)
    ]
    assert width[0] < 0.85 * width[1]


def test_only_empty_boards_and_new_ids() -> None:
    scene = room([standing("bookcase"), standing("desk", at=(3, 3, 0))])
    once = after(scene, answer(TOOL, scene))
    assert all(carrier(once, o).id == "bookcase-0" for o in once.objects[2:])  # the desk is no shelf
    assert len(set(once.ids)) == len(once.ids)
    again = answer(TOOL, once)
    assert not again.edits and again.unmet


def test_same_seed_same_answer() -> None:
    scene = room([standing("pantry_shelf")])
    assert answer(TOOL, scene) == answer(TOOL, scene)
    assert answer(TOOL, scene) != answer(TOOL, scene, seed=2)


def test_low_ceiling() -> None:
    shelf = standing("pantry_shelf")
    scene = room([shelf], height=shelf.size[2] + 0.1)
    assert not faults(after(scene, answer(TOOL, scene)))


def test_category_without_theme_uses_what_it_holds() -> None:
    scene = room([standing("picnic_table")], [Relation(type="on_floor", subject="picnic_table-0")])
    done = after(scene, answer(TOOL, scene, {"supports": ["picnic_table-0"]}))
    held = set(categories()["picnic_table"].holds)
    assert len(done.objects) > 1 and {o.category for o in done.objects[1:]} <= held and not faults(done)


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({"theme": "bookz"}, "theme: 'bookz' is unknown"),
        ({"density": 1.5}, "density: 1.5"),
        ({"density": float("nan")}, "density"),
        ({"density": True}, "density"),
        ({"supports": ["x-0"]}, "supports: 'x-0'"),
    ],
)
def test_bad_inputs(inputs: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        answer(TOOL, room([standing("bookcase")]), inputs)
