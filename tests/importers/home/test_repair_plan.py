"""Plans repaired with least movement: the nearest point of a polyhedron, lines of walls, and whole plans."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.home import HomeDoor, on_grid
from sceneweaver.importers.home.leaves import faults_of, hang
from sceneweaver.importers.home.repair.least_squares import Row, nearest
from sceneweaver.importers.home.repair.wall_lines import WallLines
from sceneweaver.io import InputError
from sceneweaver.plans import Profile, check_plan


def flat() -> sw.Home:
    return sw.Home.example("flat")


def stretched(home: sw.Home, axis: int, line: float, by: float, near: float = 0.06) -> sw.Home:
    """The home with the wall around a line along an axis moved, openings as they were counted along their walls."""

    def moved(p: tuple[float, float]) -> tuple[float, float]:
        q = [*p]
        q[axis] = round(q[axis] + by, 3) if abs(q[axis] - line) <= near else q[axis]
        return q[0], q[1]

    rooms = tuple(r.model_copy(update={"outline": tuple(moved(p) for p in r.outline)}) for r in home.rooms)
    return home.with_changes(rooms=rooms)


def active_sets(start: np.ndarray, weights: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The nearest point by trying all sets of rows that hold with equality: the twin of `nearest`."""
    best, cost = None, np.inf
    for count in range(min(len(b), len(start)) + 1):
        for rows in combinations(range(len(b)), count):
            k = list(rows)
            inverse = a[k] / weights
            try:
                steps = np.linalg.solve(inverse @ a[k].T, b[k] - a[k] @ start) if k else np.zeros(0)
            except np.linalg.LinAlgError:
                continue
            x = start + steps @ inverse
            value = float(weights @ (x - start) ** 2)
            if (a @ x >= b - 1e-9).all() and value < cost:
                best, cost = x, value
    assert best is not None
    return best


@pytest.mark.parametrize("seed", range(12))
def test_the_nearest_point_is_that_of_all_active_sets(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n, m = 4, 6
    start, weights = rng.normal(size=n) * 300, rng.uniform(0.5, 4, n)
    a = rng.normal(size=(m, n))
    b = a @ (rng.normal(size=n) * 300)  # something keeps them all
    rows = [Row(dict(enumerate(row.tolist())), float(bound)) for row, bound in zip(a, b, strict=True)]
    x, left = nearest(start, weights, rows)
    twin = active_sets(start, weights, a, b)
    assert not left
    assert np.abs(x - twin).max() < 0.5  # millimetres
    assert weights @ (x - start) ** 2 <= weights @ (twin - start) ** 2 * 1.001 + 0.1


def test_rows_that_contradict_each_other_are_told() -> None:
    x, left = nearest(np.zeros(1), np.ones(1), [Row({0: 1.0}, 5.0, "up"), Row({0: -1.0}, 5.0, "down")])
    assert np.isfinite(x).all() and left


def test_floors_and_their_slopes() -> None:
    lines = WallLines.of(flat())
    import shapely

    for room, part in enumerate(lines.rooms):
        floor, slope = lines.area(room, lines.start)
        assert floor == pytest.approx(shapely.Polygon(part.outline).area * 1e6)
        for k in range(len(lines.start)):
            there = lines.start.copy()
            there[k] += 1.0
            assert lines.area(room, there)[0] - floor == pytest.approx(slope.get(k, 0.0), abs=2.0)


def test_a_wall_between_rooms_is_one_line() -> None:
    lines = WallLines.of(flat())
    pairs = [(a, b) for a, b, gap in lines.facing() if gap == 100]
    assert pairs
    for a, b in pairs:
        assert lines.difference(a, b) == ({}, 100.0)


def test_a_plan_that_keeps_the_rules_stays() -> None:
    home = flat()
    repair = sw.repair_plan(home)
    assert repair.home is home and repair.before.valid and not repair.moved and not repair.left


def test_a_wall_moves_no_more_than_needed() -> None:
    """The wall between living room and kitchen is moved until the kitchen lacks 80 mm of the least depth."""
    least = Profile.named("base").rule("kitchen-side").least
    assert least is not None
    home = flat()
    home = home.with_changes(windows=tuple(w for w in home.windows if w.id != "window-kitchen-2"))
    narrow = stretched(home, 1, 4.45, round(3.1 - least + 0.08, 3))
    assert "kitchen-side" in {v.rule for v in check_plan(narrow).violations}
    repair = sw.repair_plan(narrow)
    assert repair.after.valid and not repair.left
    walls = [abs(m.by) for m in repair.moved if m.what == "wall"]
    assert walls and 0.03 < max(walls) <= 0.081
    assert all(on_grid(v) for r in repair.home.rooms for p in r.outline for v in p)
    assert [r.id for r in repair.home.rooms] == [r.id for r in home.rooms]
    assert sw.repair_plan(narrow).home == repair.home


def test_a_narrow_door_is_widened_about_its_middle() -> None:
    home = flat()
    door = next(d for d in home.doors if d.to is not None and d.kind == "hinged")
    thin = door.model_copy(update={"width": 0.5, "offset": round(door.offset + (door.width - 0.5) / 2, 3)})
    broken = home.with_changes(doors=tuple(thin if d.id == door.id else d for d in home.doors))
    repair = sw.repair_plan(broken)
    assert repair.after.valid
    now = next(d for d in repair.home.doors if d.id == door.id)
    assert now.width == 0.6 and now.offset + now.width / 2 == pytest.approx(thin.offset + 0.25, abs=1e-3)
    assert [(m.what, m.id, m.how) for m in repair.moved] == [("door", door.id, "made wider")]


def test_a_room_without_a_window_gets_one() -> None:
    home = flat()
    room = next(r for r in home.rooms if r.type == "bedroom")
    dark = home.with_changes(windows=tuple(w for w in home.windows if w.room != room.id))
    repair = sw.repair_plan(dark)
    assert {v.rule for v in repair.before.violations} >= {"daylight", "escape"} and repair.after.valid
    (window,) = [w for w in repair.home.windows if w.room == room.id]
    import shapely

    assert window.width * window.height >= 0.08 * shapely.Polygon(room.outline).area


def test_a_room_without_a_door_gets_one() -> None:
    home = flat()
    bath = next(r for r in home.rooms if "bath" in r.type)
    shut = home.with_changes(doors=tuple(d for d in home.doors if bath.id not in (d.room, d.to)))
    repair = sw.repair_plan(shut)
    assert not repair.before.valid and repair.after.valid
    assert len(repair.home.doors) == len(home.doors) and any("added" in m.how for m in repair.moved)


def test_a_home_without_an_entrance_gets_one() -> None:
    home = flat()
    shut = home.with_changes(doors=tuple(d for d in home.doors if d.to is not None or home.room(d.room).outdoor))
    repair = sw.repair_plan(shut)
    assert repair.after.valid and len(repair.home.entrances) == 1


def test_leaves_that_meet_are_hung_otherwise() -> None:
    home = flat()
    room = max(home.rooms, key=lambda r: len(list(home.doors_of(r.id))))
    doors = tuple(
        d.model_copy(update={"opens_into": room.id}) if room.id in (d.room, d.to) and d.kind == "hinged" else d
        for d in home.doors
    )
    crowded = home.with_changes(doors=doors)
    names = [d.id for d in crowded.doors]
    hung = crowded.with_changes(doors=hang(crowded, names))
    assert sum(faults_of(hung).values()) <= sum(faults_of(crowded).values())
    assert sum(faults_of(hung).values()) == 0
    assert [(d.id, d.room, d.wall, d.offset) for d in hung.doors] == [
        (d.id, d.room, d.wall, d.offset) for d in home.doors
    ]


def test_what_cannot_be_mended_is_said() -> None:
    """A home of one room of 4 m2: no wall beside it can give it more."""
    outline = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    room = {"id": "a", "type": "studio_apartment", "storey": "ground", "outline": outline}
    door = HomeDoor(id="d", room="a", wall=0, offset=0.5, width=0.9, opens_into="a")
    home = sw.Home.from_json({"schema": "sceneweaver.home/1", "id": "tiny", "rooms": [room]}).with_changes(
        doors=(door,)
    )
    repair = sw.repair_plan(home)
    assert len(repair.after.violations) < len(repair.before.violations)
    assert any("toilet" in line for line in repair.left) and all("\n" not in line for line in repair.left)


@pytest.mark.parametrize("seed", range(6))
def test_never_worse(seed: int) -> None:
    """Homes damaged at random: fewer faults than before, or the home as it was."""
    rng = np.random.default_rng(seed)
    home = flat()
    for _ in range(3):
        axis = int(rng.integers(2))
        lines = sorted({p[axis] for r in home.rooms for p in r.outline})
        try:
            home = stretched(
                home, axis, lines[int(rng.integers(1, len(lines) - 1))], float(rng.uniform(-0.5, 0.5)), 0.11
            )
        except InputError:
            continue
    repair = sw.repair_plan(home)
    assert len(repair.after.violations) < len(repair.before.violations) or repair.home == home
    assert repair.after == check_plan(repair.home)


def test_an_unknown_profile() -> None:
    with pytest.raises(InputError, match="profile"):
        sw.repair_plan(flat(), profile="strict")
