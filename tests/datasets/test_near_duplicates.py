"""Layouts that are nearly the same are found, however the room is turned, and never lie in two splits."""

import math

import numpy as np
import pytest
from scipy.cluster.hierarchy import DisjointSet

import sceneweaver as sw
from sceneweaver.datasets import Folder
from sceneweaver.datasets.files import pack
from sceneweaver.datasets.files.fingerprint import Layout, join_near_duplicates, near_duplicates, smallest
from sceneweaver.datasets.files.packing import assign_splits
from sceneweaver.datasets.tables import arrow
from tests.datasets.small import make_small, small_scene, small_spec


def _signature(scene) -> str:
    return Layout.of(scene).signature


def seen(layout: Layout, angle: float, shift=(0.0, 0.0), mirror: bool = False) -> Layout:
    """The same room elsewhere."""
    c, s = math.cos(angle), math.sin(angle)
    matrix = np.array([[c, -s], [s, c]]) @ np.diag([1.0, -1.0 if mirror else 1.0])
    outline = layout.outline @ matrix.T + shift
    boxes = layout.boxes.copy()
    boxes[:, :2] = boxes[:, :2] @ matrix.T + shift
    boxes[:, 2] = (-boxes[:, 2] if mirror else boxes[:, 2]) + angle
    return Layout(outline[::-1] if mirror else outline, layout.categories, boxes)


def moved(layout: Layout, thing: int, by: float, turn: float = 0.0) -> Layout:
    boxes = layout.boxes.copy()
    boxes[thing, 0] += by
    boxes[thing, 2] += turn
    return Layout(layout.outline, layout.categories, boxes)


@pytest.fixture(params=range(3))
def layout(request):
    return Layout.of(small_scene(request.param))


@pytest.mark.parametrize("mirror", [False, True])
@pytest.mark.parametrize("angle", [0.0, 90.0, 180.0, -90.0, 33.3])
def test_a_room_that_is_turned_shifted_or_mirrored_is_the_same(layout, angle, mirror):
    other = seen(layout, math.radians(angle), (3.1, -0.7), mirror)
    assert other.signature == layout.signature
    assert near_duplicates(layout, other) and near_duplicates(other, layout)
    assert np.abs(other.embedding - layout.embedding).max() < 1e-5


def test_the_order_of_objects_does_not_matter():
    scene = sw.Scene.example("bedroom")
    assert _signature(scene.model_copy(update={"objects": scene.objects[::-1]})) == _signature(scene)


def test_small_things_do_not_matter_and_large_ones_do():
    scene = sw.Scene.example("bedroom")
    chair = scene.move("chair", by=(0.5, 0.0))
    bed = scene.move("bed", by=(0.5, 0.0))
    assert _signature(chair) == _signature(scene) != _signature(bed)


@pytest.mark.parametrize(("by", "degrees", "same"), [(0.09, 0, True), (0.11, 0, False), (0, 14, True), (0, 16, False)])
def test_the_bounds_are_10_cm_and_15_degrees(layout, by, degrees, same):
    other = moved(layout, 0, by, math.radians(degrees))
    assert near_duplicates(layout, other) == same


def test_a_room_with_other_walls_is_another(layout):
    lengthened = Layout(layout.outline * (1.1, 1.0), layout.categories, layout.boxes)
    assert not near_duplicates(layout, lengthened)


def test_rounding_in_a_row_changes_nothing(layout):
    row = {"outline": layout.outline.tolist(), "categories": layout.categories, "boxes": layout.boxes.tolist()}
    assert Layout.from_row(row).signature == layout.signature


def test_all_near_duplicates_are_found_and_nothing_else():
    """As a comparison of all pairs finds them: the embedding leaves none out."""
    rng = np.random.default_rng(0)
    base = [Layout.of(small_scene(n)) for n in range(6)]
    layouts = []
    for n in range(90):
        one = base[n % 6]
        noise = np.zeros_like(one.boxes)
        noise[:, :2] = rng.uniform(-1, 1, (len(noise), 2)) * rng.choice([0.04, 0.15])
        shaken = Layout(one.outline, one.categories, one.boxes + noise)
        layouts.append(seen(shaken, rng.uniform(0, 7), (n, 0), bool(n % 2)))
    expected, found = DisjointSet(range(90)), DisjointSet(range(90))
    for a in range(90):
        for b in range(a):
            if near_duplicates(layouts[a], layouts[b]):
                expected.merge(a, b)
    join_near_duplicates(found, [(n, one.signature, one) for n, one in enumerate(layouts)])
    assert smallest(found).tolist() == smallest(expected).tolist()
    assert 6 < len(set(smallest(found).tolist())) < 90


def test_layouts_drawn_at_random_are_told_apart():
    one = Layout.of(small_scene(0))
    rng = np.random.default_rng(1)
    layouts = []
    for n in range(2000):
        boxes = one.boxes.copy()
        boxes[:, :2] += rng.uniform(-2, 2, (len(boxes), 2))
        layouts.append((n, str(n), Layout(one.outline, one.categories, boxes)))
    sets = DisjointSet(range(2000))
    join_near_duplicates(sets, layouts)
    assert len(set(smallest(sets).tolist())) > 1900


def test_empty_rooms_are_near_duplicates_when_of_one_size():
    rooms = [sw.Scene(id="a", room=sw.Room.rectangle(w, 3.0)) for w in (4.0, 4.1, 6.0)]
    layouts = [Layout.of(room) for room in rooms]
    sets = DisjointSet(range(3))
    join_near_duplicates(sets, [(n, one.signature, one) for n, one in enumerate(layouts)])
    assert smallest(sets).tolist() == [0, 0, 2]


def test_shares_of_splits_are_exact_to_one_family():
    spec = small_spec(splits={"train": 0.9, "validation": 0.05, "test": 0.05})
    splits = assign_splits(spec, np.arange(1000))
    assert np.bincount(splits).tolist() == [50, 900, 50]  # test, train, validation
    assert (assign_splits(spec, np.arange(1000)) == splits).all()
    assert (assign_splits(spec.model_copy(update={"seed": 1}), np.arange(1000)) != splits).any()


def test_families_are_never_torn():
    families = np.random.default_rng(0).integers(0, 40, 500)
    splits = assign_splits(small_spec(), families)
    assert all(len(set(splits[families == f])) == 1 for f in set(families.tolist()))
    assert 0.4 < (splits == 0).mean() < 0.6


def test_layouts_of_a_room_and_near_duplicates_share_a_split(tmp_path):
    requests = make_small(tmp_path, 30, rooms={"layouts": 3})  # scenes 0, 9, 18 ... are of one kind, moved at random
    pack(Folder(tmp_path), requests)
    rows = arrow().parquet.read_table(tmp_path / "meta" / "index.parquet").to_pylist()
    for name in ("room", "near_duplicate_group"):
        splits = {}
        for row in rows:
            splits.setdefault(row[name], set()).add(row["split"])
        assert all(len(found) == 1 for found in splits.values())
    assert {row["split"] for row in rows} == {"train", "test"}


def test_the_same_scene_twice_is_one_group(tmp_path, monkeypatch):
    monkeypatch.setattr("tests.datasets.small.small_scene", lambda number: sw.Scene.example("bedroom"))
    requests = make_small(tmp_path, 4)
    pack(Folder(tmp_path), requests)
    rows = arrow().parquet.read_table(tmp_path / "meta" / "index.parquet").to_pylist()
    assert {row["near_duplicate_group"] for row in rows} == {0}
    assert len({row["split"] for row in rows}) == 1
