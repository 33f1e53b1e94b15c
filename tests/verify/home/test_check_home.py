"""The judge of homes: what joins rooms, doors and their leaves, and the ways of a round base."""

import json

import numpy as np
import pytest
import shapely

from sceneweaver.home import Home
from sceneweaver.scene import InputError
from sceneweaver.verify.home import check_home
from sceneweaver.verify.home.access import Ways
from tests.verify.build import box
from tests.verify.home.homes import bars, flat, furnished, house, mirrored, thing, turned

WAYS = (lambda home: home, turned, mirrored, lambda home: turned(mirrored(home)))


def kinds(home, **options):
    return check_home(home, **options).counts


def test_the_empty_flat_is_valid():
    report = check_home(Home.example("flat"))
    assert report.valid and not report.violations and not report.rooms
    assert report.access.entrance == "front-door" and report.access.walkable_share == 1.0


@pytest.mark.parametrize("seen", WAYS)
@pytest.mark.parametrize(("gap", "passes"), [(0.49, False), (0.499, False), (0.5, True), (0.51, True)])
def test_a_gap_is_passed_by_what_is_as_wide_however_the_home_lies(gap, passes, seen):
    report = check_home(seen(flat(hall=bars(gap))))
    assert report.valid is passes
    missed = set() if passes else {"living", "kitchen", "bath", "bedroom", "bedroom-2"}
    assert set(report.access.unreached_rooms) == missed
    assert (report.access.walkable_share > 0.99) is passes and not report.access.blocked_doors
    assert set(report.counts) == (set() if passes else {"unreached_room"})


@pytest.mark.parametrize("radius", [0.15, 0.3])
def test_the_radius_of_the_base_is_asked_for(radius):
    narrow, wide = (check_home(flat(hall=bars(2 * radius + by)), robot_radius=radius) for by in (-0.005, 0.005))
    assert not narrow.valid and wide.valid and wide.access.robot_radius == radius


@pytest.mark.parametrize("bad", [0.0, 6.0, "wide", float("nan")])
def test_a_radius_out_of_range_is_refused(bad):
    with pytest.raises(InputError, match="robot_radius is"):
        check_home(Home.example("flat"), robot_radius=bad)


@pytest.mark.parametrize("seen", WAYS)
def test_a_blocked_doorway_is_found_with_all_that_it_shuts_off(seen):
    """The door of bedroom-2 is at x = 6.3 from y = 4.5 to 5.3, and swings in."""
    report = check_home(seen(flat(bedroom_2=[thing("chest", "chest", (0.5, 1.0, 0.5), 6.6, 4.9)])))
    assert not report.valid
    assert report.access.blocked_doors == ("door-bedroom-2",) and report.access.unreached_rooms == ("bedroom-2",)
    assert set(report.counts) == {"room", "blocked_leaf", "blocked_door", "unreached_room"}
    said = next(v for v in report.violations if v.kind == "blocked_door")
    assert said.detail == "a base of 0.25 m does not get through door-bedroom-2 between bedroom-2 and hall"
    assert report.rooms["bedroom-2"].blocked_openings == 1


@pytest.mark.parametrize("seen", WAYS)
def test_a_leaf_sweeps_a_quarter_disc_about_its_hinge(seen):
    """That of bedroom-2 hangs on the right of who comes in, at y = 4.5, and reaches 0.8 m into the room."""
    corner = {"near the free end": (6.95, 5.25), "near the hinge": (6.95, 4.55)}
    hit = {name: kinds(seen(flat(bedroom_2=[box("post", (0.1, 0.1, 1.0), *at)]))) for name, at in corner.items()}
    assert "blocked_leaf" in hit["near the hinge"] and "blocked_leaf" not in hit["near the free end"]
    rug = box("rug", (1.0, 1.0, 0.015), 6.9, 4.9)
    assert "blocked_leaf" not in kinds(seen(flat(bedroom_2=[rug])))


@pytest.mark.parametrize("seen", WAYS)
def test_what_is_used_has_to_be_reached_and_decoration_not(seen):
    """A wardrobe behind a row of shelves that no base passes: its front is 1.54 m from the base at the nearest."""
    row = [box("row", (0.3, 3.4, 1.0), 8.2, 7.0 - 1.4, 90.0)]
    away = {"wardrobe": ("wardrobe", (0.6, 1.0, 2.0)), "plant": ("plant", (0.4, 0.4, 1.0))}
    found = {}
    for name, (category, size) in away.items():
        home = seen(flat(bedroom_2=[*row, thing(name, category, size, 8.2, 7.29, -90.0)]))
        found[name] = check_home(home)
    assert found["wardrobe"].access.unreached_objects == ("bedroom-2/wardrobe",)
    assert found["wardrobe"].access.needed == 1 and found["wardrobe"].access.reachable_share == 0.0
    assert found["plant"].access.unreached_objects == () and found["plant"].access.reachable_share == 1.0
    said = found["wardrobe"].violations[-1]
    assert said.kind == "unreached_object" and said.amount == pytest.approx(6.99 - 5.2 - 0.25, abs=1e-3)


def test_a_thing_through_the_wall_is_found_on_both_sides():
    """From the bedroom through 0.1 m of wall into bedroom-2."""
    report = check_home(flat(bedroom=[box("shelf", (0.4, 0.8, 1.0), 9.0, 4.0)]))
    (found,) = [v for v in report.violations if v.kind == "through_wall"]
    assert found.rooms == ("bedroom", "bedroom-2") and found.parts == ("bedroom/shelf",)
    assert found.amount == pytest.approx(0.3 * 0.4, abs=1e-6)
    assert report.rooms["bedroom"].out_of_bounds == 1 and not report.valid


def test_a_thing_in_an_opening_is_found():
    report = check_home(flat(hall=[box("post", (0.3, 0.3, 1.0), 6.15, 3.0)]))
    assert [v.parts for v in report.violations if v.kind == "through_wall"] == [("hall/post", "door-bedroom")]


def test_rooms_that_overlap_and_openings_into_them_are_found():
    home = Home.example("flat")
    rooms = []
    for room in home.rooms:
        outline = [(x, y - 1.0) for x, y in room.outline] if room.id == "bedroom-2" else room.outline
        rooms.append(room.model_copy(update={"outline": tuple(outline)}))
    found = check_home(home.model_copy(update={"rooms": tuple(rooms)})).counts
    assert found["rooms_overlap"] == 1


def test_a_scene_of_another_room_is_found():
    home = flat(bath=[box("stool", (0.3, 0.3, 0.4), 5.0, 7.0)])
    other = home.room("bath").scene
    assert other is not None
    taller = other.model_copy(update={"room": other.room.model_copy(update={"height": 2.9})})
    rooms = [r.model_copy(update={"scene": taller}) if r.id == "bath" else r for r in home.rooms]
    report = check_home(home.model_copy(update={"rooms": tuple(rooms)}))
    assert report.counts == {"shell": 1} and "2.9 m high" in report.violations[0].detail


def test_a_home_without_a_door_out_has_no_entrance():
    home = Home.example("flat")
    shut = home.with_changes(doors=tuple(d for d in home.doors if d.to is not None))
    report = check_home(shut)
    assert report.access.entrance is None and report.counts["no_entrance"] == 1
    assert len(report.access.unreached_rooms) == len(home.rooms)


def test_a_door_narrower_than_the_base_is_blocked():
    home = Home.example("flat")
    doors = [d.model_copy(update={"width": 0.48}) if d.id == "door-bath" else d for d in home.doors]
    assert check_home(home.with_changes(doors=tuple(doors))).access.blocked_doors == ("door-bath",)


@pytest.mark.parametrize(("shape", "seen"), [*(("straight", seen) for seen in WAYS), ("u", WAYS[0]), ("u", turned)])
def test_another_storey_is_reached_by_the_stair_and_not_on_wheels(shape, seen):
    report = check_home(seen(house(shape=shape)))
    assert report.valid and report.access.by_stairs == ("well-first", "room-first")


def test_a_stair_without_room_before_it_is_blocked():
    home = house(landing=1.2)
    things = [box("chest", (0.9, 1.0, 0.6), 0.5, 0.7, 90.0)]
    report = check_home(furnished(home, well_ground=things))
    assert report.counts["blocked_stair"] == 1 and "room-first" in report.access.unreached_rooms


def test_the_plan_is_part_of_the_verdict_where_its_report_is_given():
    class Plan:
        valid = False

        def to_dict(self):
            return {"valid": self.valid}

    report = check_home(Home.example("flat"), Plan())
    assert not report.valid and report.counts == {"plan": 1} and report.to_dict()["plan"] == {"valid": False}


def test_the_report_is_written_as_json(tmp_path):
    report = check_home(flat(hall=bars(0.4)))
    report.save(tmp_path / "metrics.json")
    data = json.loads((tmp_path / "metrics.json").read_text())
    assert data["schema"] == "sceneweaver.home-metrics/1" and data["valid"] is False
    assert data["counts"] == {"unreached_room": 5} and data["access"]["entrance"] == "front-door"
    assert data["rooms"]["hall"]["schema"].startswith("sceneweaver.metrics") or data["rooms"]["hall"]["valid"] is True


@pytest.mark.parametrize("seed", range(4))
def test_regions_are_where_the_disc_is_clear_of_everything(seed):
    """Against distances by shapely to walls and boxes, at random points: the same but for the rounding of arcs."""
    rng = np.random.default_rng(seed)
    things = [
        box(f"box-{k}", (depth, width, 1.0), x, y, yaw)
        for k in range(6)
        for depth, width, x, y, yaw in [rng.uniform((0.2, 0.2, 6.8, 4.6, 0), (0.9, 0.9, 9.6, 7.1, 360)).tolist()]
    ]
    ways = Ways.of(flat(bedroom_2=things))
    (floor,) = ways.floors.values()
    points = rng.uniform((6.3, 4.1), (10.1, 7.6), (4000, 2))
    flat_points = shapely.points(points)
    inside = np.zeros(len(points), dtype=bool)
    for region in floor.regions:
        inside |= shapely.intersects(region, flat_points)
    solids = shapely.union_all(ways.placed["bedroom-2"].parts.polygons)
    away = np.minimum(shapely.distance(floor.ground.boundary, flat_points), shapely.distance(solids, flat_points))
    outside = ~shapely.intersects(floor.ground, flat_points)
    sure = np.abs(away - 0.25) > 4e-4
    assert sure.mean() > 0.98
    np.testing.assert_array_equal(inside[sure], ((away >= 0.25) & ~outside)[sure])
