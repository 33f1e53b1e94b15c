"""The checker against pixels: on a grid of 50 mm both are exact, so they have to agree to the last millimetre."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from sceneweaver.home import Home, place_in
from sceneweaver.plans import MEASURES, Rule
from sceneweaver.plans.checking.facts import PlanFacts
from sceneweaver.plans.checking.readings import Reading, measures
from sceneweaver.plans.room_types import room_type
from tests.plans.random_homes import random_home
from tests.plans.raster import P, Raster, cropped, fits, flood, gap, grown, largest_square, rectangles

SEEDS = range(7)


def readings(home: Home, measure: str, **row: Any) -> list[Reading]:
    """What a measure says of all rooms."""
    rule = Rule(id="r", measure=measure, least=0.0, says="s", source="s", **row)
    return list(measures()[measure](PlanFacts(home, None, None), rule))


def by_room(home: Home, measure: str) -> dict[str, int]:
    """Values of a measure of rooms, in millimetres."""
    return {r.rooms[0]: round(r.value * 1000) for r in readings(home, measure)}


def pairs_said(home: Home, measure: str) -> set[frozenset[str]]:
    return {frozenset(r.rooms) for r in readings(home, measure)}


@pytest.mark.parametrize("seed", SEEDS)
def test_areas_sides_and_squares(seed: int):
    home = random_home(seed)
    raster = Raster(home, "s0")
    areas, sides, aspects, turnings = (by_room(home, name) for name in ("area", "side", "aspect", "turning"))
    for room in home.rooms:
        picture = raster.rooms[room.id]
        assert areas[room.id] == round(Fraction(int(picture.sum()) * P * P, 1000))
        fitting = rectangles(picture)
        enough = min(picture.sum() / 2, max(w * d for w, d in fitting))
        assert sides[room.id] == max(min(w, d) for w, d in fitting if w * d >= enough) * P
        i, j = np.nonzero(picture)
        extent = sorted((np.ptp(i) + 1, np.ptp(j) + 1))
        assert aspects[room.id] == round(1000 * extent[1] / extent[0])
        for x, y, dx, dy in leaf_squares(home, room.id):
            (i0, j0), (i1, j1) = raster.pixel(x, y), raster.pixel(x + dx, y + dy)
            picture = picture.copy()
            picture[min(i0, i1) : max(i0, i1), min(j0, j1) : max(j0, j1)] = False
        assert turnings[room.id] == largest_square(picture)


def leaf_squares(home: Home, room_id: str) -> list[tuple[float, float, float, float]]:
    """The square at the hinge of each leaf that swings into a room: corner and signed extents [m]."""
    found = []
    for door in home.doors:
        if door.kind not in ("hinged", "double") or door.opens_into != room_id:
            continue
        number, offset = place_in(home, door, room_id)
        wall = home.room(room_id).walls[number]
        hung = {
            "double": [(offset, 1, door.width / 2), (offset + door.width, -1, door.width / 2)],
            "hinged": [(offset, 1, door.width) if door.hinge == "left" else (offset + door.width, -1, door.width)],
        }[door.kind]
        for at, way, r in hung:
            x, y = wall.point(at)
            (tx, ty), (nx, ny) = wall.along, wall.inward
            found.append((x, y, way * tx * r + nx * r, way * ty * r + ny * r))
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_overlaps_walls_and_voids(seed: int):
    home = random_home(seed)
    raster = Raster(home, "s0")
    joined = {frozenset((d.room, d.to)) for d in home.doors if d.kind == "open" and d.to}
    pairs = {frozenset(p) for p in combinations(raster.rooms, 2)} - joined
    gaps = {pair: gap(*(raster.rooms[name] for name in pair)) for pair in pairs}
    assert pairs_said(home, "overlap") - joined == {pair for pair in pairs if gaps[pair] < 0}
    assert pairs_said(home, "wall_lack") - joined == {pair for pair in pairs if 0 <= gaps[pair] < 100}
    floors = np.any(list(raster.rooms.values()), axis=0)
    thick = grown(floors, 3)
    outside = np.zeros_like(floors)
    outside[0, 0] = True
    enclosed = ~thick & ~flood(~thick, outside)
    expected = largest_square(grown(enclosed, 3) & ~floors) if enclosed.any() else 0
    assert max((round(r.value * 1000) for r in readings(home, "void")), default=0) == expected


@pytest.mark.parametrize("seed", SEEDS)
def test_windows_and_doors_that_lead_out(seed: int):
    home = random_home(seed)
    raster = Raster(home, "s0")
    floors = np.any(list(raster.rooms.values()), axis=0)
    rooms = {room.id: room for room in home.rooms}
    bad = [w.room for w in home.windows if (raster.ahead(rooms[w.room], w.wall, w.offset, w.width, 1.3) & floors).any()]
    assert sorted(r.rooms[0] for r in readings(home, "window_fault")) == sorted(bad)
    wrong = [
        d.room
        for d in home.doors
        if d.to is None and (raster.ahead(rooms[d.room], d.wall, d.offset, d.width, 0.9) & floors).any()
    ]
    out = [r.rooms[0] for r in readings(home, "door_fault") if "leads out" in r.what]
    assert sorted(out) == sorted(wrong)


@pytest.mark.parametrize("seed", SEEDS)
def test_ways_through_rooms(seed: int):
    """The largest square that slides from door to door, and with one pixel more it does not."""
    home = random_home(seed)
    raster = Raster(home, "s0")
    said = by_room(home, "passage")
    for room in home.rooms:
        k, rest = divmod(said[room.id], P)
        assert not rest
        assert k == 0 or _slides(home, raster, room.id, k), room.id
        assert not _slides(home, raster, room.id, k + 1), room.id


def _slides(home: Home, raster: Raster, room_id: str, k: int) -> bool:
    picture, corner = cropped(raster.rooms[room_id])
    free = fits(picture, k)
    contacts = []
    for door in home.doors_of(room_id):
        number, offset = place_in(home, door, room_id)
        wall = home.room(room_id).walls[number]
        a, b = (np.subtract(raster.pixel(*wall.point(at)), corner) for at in (offset, offset + door.width))
        contact = np.zeros_like(free)
        axis = 0 if a[1] == b[1] else 1
        low, high = sorted((a[axis], b[axis]))
        across = a[1 - axis] - (k if wall.inward[1 - axis] < 0 else 0)
        ends = sorted((low, high - k))
        where: list[Any] = [None, None]
        where[axis], where[1 - axis] = slice(max(0, ends[0]), ends[1] + 1), slice(across, across + 1)
        if across >= 0:
            contact[tuple(where)] = True
        contacts.append(contact & free)
    if not contacts:
        return bool(free.any())
    first, *others = contacts
    if not all(contact.any() for contact in contacts):
        return False
    # Each part of the free places that the first door touches has to touch all other doors.
    for start in zip(*np.nonzero(first), strict=True):
        seed = np.zeros_like(free)
        seed[start] = True
        part = flood(free, seed)
        if all((part & other).any() for other in others):
            return True
    return False


@pytest.mark.parametrize("seed", range(100, 118))
def test_what_is_reached_by_words(seed: int):
    """Ways by the rules as one says them, over the doors alone."""
    home = random_home(seed)
    kinds = {room.id: room_type(room.type) for room in home.rooms}
    reached = {d.room for d in home.doors if d.to is None and kinds[d.room].transit == "all"}
    entrances = set(reached)
    growing = True
    while growing:
        before = len(reached)
        for door in home.doors:
            for here, there in ((door.room, door.to), (door.to, door.room)):
                if here is None or there is None or here not in reached:
                    continue
                behind_suite = kinds[here].transit == "suite" and "annex" in kinds[there].roles
                if kinds[here].transit == "all" or behind_suite:
                    reached.add(there)
        growing = len(reached) > before
    said = {r.rooms[0] for r in readings(home, "unreached")}
    assert said == (set(kinds) - reached if entrances else set())


def test_all_measures_are_known():
    assert set(measures()) == set(MEASURES)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1000, 1150))
def test_many_more(seed: int):
    test_areas_sides_and_squares(seed)
    test_overlaps_walls_and_voids(seed)
    test_windows_and_doors_that_lead_out(seed)
    test_ways_through_rooms(seed)
    test_what_is_reached_by_words(seed)
