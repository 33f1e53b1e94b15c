"""Arrangements on tables: inside, apart, facing whom they serve, and what was asked for is there."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from sceneweaver.assets import categories, make
from sceneweaver.generate.surface_field import Field, Piece, Prism, Shape
from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.surfaces import arrangement_of, arrangements, crowd_of
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.scene import InputError, Intent, Pose, Relation, Scene, SceneObject, Support, Window
from sceneweaver.tools.add_tabletop import AddTabletop
from sceneweaver.tools.base import Context
from tests.sizes import sizes

from .surface_rooms import KIND, LIBRARY, after, answer, carrier, faults, laid, room, standing

TOOL = AddTabletop()
NAMES = (
    "desk_set laptop_desk bedside dining cafe_table bar_setting coffee_table side_table dresser_display vanity_set "
    "sink_set bath_edge toilet_tank kitchen_counter stove_top kitchen_island sideboard_display console_display "
    "tv_stand meeting reception_counter checkout workbench teacher_desk school_desk kids_table toy_top bed_dressing "
    "sofa_dressing windowsill treatment_desk lab_bench music_desk bench_top ottoman_tray gym_bench_top waiting_table "
    "washing_machine_top shelf_display generic"
)


def of(scene: Scene, category: str) -> list[SceneObject]:
    return [o for o in scene.objects if o.category == category]


def local(obj: SceneObject, frame: SceneObject) -> tuple[float, float]:
    dx, dy = (a - b for a, b in zip(obj.pose.position[:2], frame.pose.position[:2], strict=True))
    c, s = math.cos(frame.pose.yaw), math.sin(frame.pose.yaw)
    return c * dx + s * dy, -s * dx + c * dy


def test_data() -> None:
    assert set(NAMES.split()) <= set(arrangements())
    assert set(arrangement_of()) | set(crowd_of()) <= set(categories())
    for kind in (None, *room_types()):
        meant = [a for a in arrangements().values() if kind in a.rooms or (kind is None and not a.rooms)]
        twice = [c for a in meant for c in a.by_category]
        assert len(twice) == len(set(twice)), kind
        replaced = [name for a in meant for name in a.instead]
        assert len(replaced) == len(set(replaced)) and set(replaced) <= set(arrangements()), kind


@sizes("step", 4, 1)
def test_every_arrangement_stands(step: int) -> None:
    tried = 0
    for category in sorted(arrangement_of())[::step]:
        obj = standing(category) if "floor" in categories()[category].mount else None
        if obj is None or not obj.surfaces or obj.mount != "floor":  # it hangs, or this body carries nothing
            continue
        scene = room([obj])
        done = after(scene, answer(TOOL, scene, {"supports": [obj.id]}))
        assert not faults(done), category
        assert all(carrier(done, o).id == obj.id for o in done.objects[1:]), category
        tried += 1
    assert tried > 50 / step


def test_desk() -> None:
    scene = room([standing("desk")])
    done = after(scene, answer(TOOL, scene))
    (monitor,), (keyboard,), (pad,), (mouse,) = (of(done, n) for n in ("monitor", "keyboard", "mouse_pad", "mouse"))
    desk = done.object("desk-0")
    assert abs(math.remainder(monitor.pose.yaw - desk.pose.yaw, 2 * math.pi)) < 0.02
    assert local(keyboard, desk)[0] > local(monitor, desk)[0] + 0.1
    assert local(mouse, desk)[1] > local(keyboard, desk)[1] + 0.15  # at the right hand of who sits in front
    assert mouse.support is not None and mouse.support.object == pad.id
    assert ("in_front_of", keyboard.id, monitor.id) in {(r.type, r.subject, r.target) for r in done.relations}
    assert not any(r.hard for r in done.relations)


def test_chair_behind_the_desk() -> None:
    desk, chair = standing("desk", at=(0.0, 0.0, 0.0)), standing("office_chair", at=(-0.75, 0.0, 0.0))
    done = after(room([desk, chair]), answer(TOOL, room([desk, chair])))
    assert abs(math.remainder(of(done, "monitor")[0].pose.yaw - math.pi, 2 * math.pi)) < 0.02


@pytest.mark.parametrize("category", ["dining_table", "round_dining_table"])
def test_a_place_before_each_chair(category: str) -> None:
    scene = laid(category)
    done = after(scene, answer(TOOL, scene))
    assert not faults(done, tuple(scene.ids))
    plates = of(done, "place_setting") or of(done, "plate")
    assert len(plates) == 4
    for plate in plates:
        chair = min(of(done, "dining_chair"), key=lambda c: math.dist(c.pose.position[:2], plate.pose.position[:2]))
        assert abs(math.remainder(plate.pose.yaw - chair.pose.yaw - math.pi, 2 * math.pi)) < 0.5
    assert len({p.asset for p in plates}) == 1


def test_same_seed_same_answer() -> None:
    scene = room([standing("desk"), standing("sideboard", at=(3, 3, 0))])
    assert answer(TOOL, scene) == answer(TOOL, scene)
    assert answer(TOOL, scene) != answer(TOOL, scene, seed=2)


def test_asked() -> None:
    scene = room([standing("dining_table")])
    wish = {
        "supports": ["dining_table-0"],
        "objects": [{"category": "candlestick", "count": 2}, {"category": "laptop"}],
    }
    done = after(scene, answer(TOOL, scene, wish))
    assert len(of(done, "candlestick")) >= 2 and of(done, "laptop") and not faults(done)


def test_seats_that_people_sit_on_carry_nothing_but_a_stool_may_be_a_small_table() -> None:
    desk, stool, bench = standing("desk"), standing("stool", at=(3, 3, 0)), standing("bench", at=(-3, 3, 0))
    asked = bench.model_copy(update={"intent": Intent(priority="asked")})
    sat_on = Relation(type="seated_at", subject=stool.id, target=desk.id)

    def carrying(scene: Scene) -> set[str]:
        done = after(scene, answer(TOOL, scene))
        return {carrier(done, o).id for o in done.objects if o.support is not None}

    assert {desk.id, stool.id, bench.id} <= carrying(room([desk, stool, bench]))
    assert carrying(room([desk, stool, asked], [sat_on])) == {desk.id}


def test_what_must_not_be_there_is_not_laid_out_either() -> None:
    scene = room([standing("tv_stand")])
    brief = read_request("a living room without a television")
    found = [
        TOOL.propose(Context(said, room_types()[KIND], scene, LIBRARY, 1)) for said in (SceneGraph(text=""), brief)
    ]
    assert [bool(of(after(scene, proposal), "tv_on_stand")) for proposal in found] == [True, False]


def test_two_screens_stand_side_by_side() -> None:
    scene = room([standing("desk"), standing("side_table", at=(2, 2, 0))])
    wish = {"supports": ["side_table-0", "desk-0"], "objects": [{"category": "monitor", "count": 2}]}
    done = after(scene, answer(TOOL, scene, wish))
    desk, (left, right) = done.object("desk-0"), of(done, "monitor")
    assert all(o.support is not None and o.support.object == desk.id for o in (left, right)), "not on the side table"
    assert all(abs(math.remainder(o.pose.yaw - desk.pose.yaw, 2 * math.pi)) < 0.1 for o in (left, right))
    (x0, y0), (x1, y1) = local(left, desk), local(right, desk)
    assert abs(x0 - x1) < 0.1 < abs(y0 - y1) and of(done, "keyboard") and not faults(done)


def test_too_much_is_said() -> None:
    scene = room([standing("nightstand")])
    proposal = answer(TOOL, scene, {"objects": [{"category": "microwave", "count": 6}]})
    assert any("microwave" in line for line in proposal.unmet)
    assert not faults(after(scene, proposal))


def test_ids_are_new_and_dressed_stays() -> None:
    scene = room([standing("desk")])
    once = after(scene, answer(TOOL, scene))
    assert not answer(TOOL, once).edits  # nothing lacks things
    twice = after(once, answer(TOOL, once, {"supports": ["desk-0"], "arrangement": "generic"}))
    assert len(set(twice.ids)) == len(twice.ids) and not faults(twice)


def test_what_the_file_of_a_room_puts_on_a_table_does_not_keep_it_bare() -> None:
    desk = standing("desk", at=(0.0, 0.0, 0.0))
    main = desk.surfaces[0]
    till = make("cash_register", 1).object(
        "cash_register-0",
        pose=Pose.from_yaw(0.0, 0.4, main.z, 0.0),
        mount="surface",
        support=Support(object="desk-0", surface=main.name),
    )
    own = till.model_copy(update={"intent": Intent(program_item="till")})
    for thing, dressed in ((own, True), (till, False)):
        scene = room([desk, thing])
        assert bool(answer(TOOL, scene).edits) is dressed


def test_under_a_wall_cabinet_and_before_a_window() -> None:
    counter = standing("kitchen_counter", at=(0.0, 0.0, math.pi / 2))
    y = -5 + counter.size[0] / 2 + 0.01
    counter = counter.model_copy(update={"pose": Pose.from_yaw(0, y, 0, math.pi / 2)})
    low = SceneObject(
        id="hood",
        category="range_hood",
        size=(0.5, 3.0, 0.5),
        mount="ceiling",
        pose=Pose.from_yaw(0.0, -4.75, counter.size[2] + 0.2, math.pi / 2),
    )
    window = Window(id="window-0", wall=0, offset=3.0, width=4.0, sill=1.0, height=1.2)
    for scene in (room([counter, low]), room([counter], windows=(window,))):
        done = after(scene, answer(TOOL, scene))
        assert len(done.objects) > len(scene.objects)
        assert not faults(done, ("hood",))


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({"supports": ["nothing-0"]}, "supports: 'nothing-0'"),
        ({"supports": "desk-0"}, "supports: give a list"),
        ({"supports": ["office_chair-0"]}, "no surface"),
        ({"arrangement": "desk_sett"}, "arrangement: 'desk_sett' is unknown"),
        ({"objects": [{"count": 2}]}, r"objects\[0\]: give a category"),
        ({"objects": [{"category": "mug", "count": 0}]}, r"objects\[0\].count"),
        ({"objects": [{"category": "wardrobe"}]}, r"objects\[0\].category"),
    ],
)
def test_bad_inputs(inputs: dict[str, object], words: str) -> None:
    scene = room([standing("desk"), standing("office_chair", at=(3, 3, 0))])
    with pytest.raises(InputError, match=words) as caught:
        answer(TOOL, scene, inputs)
    assert "\n" not in str(caught.value)


def test_field_of_any_simple_polygon() -> None:
    ell = np.array([(0, 0), (1, 0), (1, 0.4), (0.4, 0.4), (0.4, 1), (0, 1)], dtype=float)
    square = np.array([(-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)])
    shape = Shape((Prism(square, 0.0, 0.2),), (0.2, 0.2, 0.2))
    field = Field(ell, headroom=0.5)
    at = np.array([(0.2, 0.2), (0.8, 0.2), (0.2, 0.8), (0.8, 0.8), (0.45, 0.45), (0.05, 0.2)])
    assert field.free(shape, 0.0, at).tolist() == [True, True, True, False, False, False]
    field.put(Piece(shape), (0.2, 0.2))
    assert not field.free(shape, 0.3, np.array([(0.3, 0.2)]))[0]
    assert not Field(ell, headroom=0.1).free(shape, 0.0, at).any()


def test_a_group_is_placed_at_the_first_candidate_that_is_free_for_all_of_it() -> None:
    square = np.array([(-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)])
    box = Shape((Prism(square, 0.0, 0.2),), (0.2, 0.2, 0.2))
    field = Field(np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)]))
    pair = [Piece(box), Piece(box, at=np.array([0.3, 0.0]))]
    field.put(Piece(box), (0.5, 0.25))
    off = np.array([(-0.2, 0.25), (0.95, 0.25)])  # outside; the second of the pair beyond the edge
    fits = np.array([(0.5, 0.25), (0.2, 0.25), (0.7, 0.25)])  # taken; the second on what is taken; beyond the edge
    assert field.place(pair, [off, fits]) is None
    assert field.place(pair[:1], [off, fits]).tolist() == [0.2, 0.25]
    near = field.place(pair[:1], field.near((0.5, 0.25), 0.3))
    assert near is not None and 0.2 < np.hypot(*(near - (0.5, 0.25))) < 0.25
    assert field.place(pair[:1], field.near((0.5, 0.25), 0.1)) is None


def test_many_places_at_once_are_as_one_by_one() -> None:
    rng = np.random.default_rng(2)
    outline = np.array([(0, 0), (1.2, 0), (1.2, 0.5), (0.5, 0.5), (0.5, 0.9), (0, 0.9)])
    corners = [np.column_stack([r * np.cos(a), r * np.sin(a)]) for r, a in _rings(rng, 12)]
    shape = Shape((Prism(corners[0], 0.0, 0.1), Prism(corners[1] + 0.05, 0.0, 0.2)), (0.2, 0.2, 0.2))
    field = Field(outline, headroom=0.5, edge=0.01)
    for ring in corners[2:]:
        field.put(Piece(Shape((Prism(ring, 0.0, 0.15),), (0.1, 0.1, 0.15))), rng.uniform((0, 0), (1.2, 0.9)))
    at, yaw, gap = rng.uniform((0, 0), (1.2, 0.9), (400, 2)), 0.4, 0.006
    inner = shapely.Polygon(outline).buffer(-0.01, join_style="mitre")
    there = [shapely.Polygon(p.polygon) for p in field.taken]
    wanted = []
    for x, y in at:
        mine = [shapely.Polygon(p.moved(x, y, yaw).polygon) for p in shape.prisms]
        # corners of discs apart: the separation along the normals of edges is never more than the distance
        near = min(a.distance(b) for a in mine for b in there)
        wanted.append(all(inner.covers(a) for a in mine) and near >= gap)
    good = field.free(shape, yaw, at, gap)
    assert 20 < good.sum() < 380
    assert not (good & ~np.array(wanted)).any()
    assert (good == wanted).mean() > 0.97


def _rings(rng: np.random.Generator, count: int):
    """Radii [m] and angles [rad] of some convex rings."""
    return [(rng.uniform(0.03, 0.08), np.sort(rng.permutation(12)[:5]) * np.pi / 6) for _ in range(count)]
