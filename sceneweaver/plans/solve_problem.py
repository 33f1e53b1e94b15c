"""A programme, an envelope and a profile as the tables of the solver's kernels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
import warp as wp

from sceneweaver.io import InputError
from sceneweaver.kernels import plan_tables as tables
from sceneweaver.kernels.plan_tables import PROBLEM, SOFT, PlanProblem

from .envelope import Envelope
from .profile import Profile, Rule
from .programme import Programme, RoomSpec
from .room_types import selects
from .solve_frames import Frame, frames_of, millimetres
from .solve_stairs import SLAB, Stairwell

JAMB = 100
"""Wall beside a door [mm]."""
PIER = 150
"""Wall beside a window [mm]."""
PANE = 1400
"""Height of windows [mm]."""
SILL = 800
"""Height of a window's lower edge above the floor [mm]."""
SETS = {
    "through": tables.THROUGH,
    "suites": tables.SUITE,
    "annexes": tables.ANNEX,
    "stairs": tables.STAIRS,
    "wet_rooms": tables.WET,
}
"""Rooms as bits, by the flag that they have."""
WINDOW = (600, 2400)
"""Least and most width of a window [mm]."""
DOOR = 800
DOORS = {"guest_toilet": 700, "washroom": 700, "closet": 700, "pantry": 700, "storage_room": 700, "bathroom": 750}
"""Clear widths of doors [mm]: usual, and by type of the room that they lead to."""
PASSAGE = 1200
"""Width of an open passage [mm], through which light comes."""
ENTRANCE = 950
"""Width of the entrance's door [mm]."""
WET_WALL = 300
"""Of wall [mm] that neighbours with water share at least."""
BENDS = {"circulation": 2, "living": 1}
"""Cells beside its own that a room of a role may have."""
SOFT_SHARE = 1.0
"""What a soft row costs a candidate of what it costs in a report."""
ACCESSIBLE_TOILET = 5.0
"""Floor of an accessible toilet [m2], as the checker has it."""
KINDS = {"door": tables.DOOR, "open": tables.OPEN, "near": tables.NEAR, "apart": tables.APART}
UNBOUNDED = 2_000_000_000
SIDES = {(0, -1): 1, (1, 0): 2, (0, 1): 3, (-1, 0): 0}
"""Side of the walls by the way out: `plan_tables.SOUTH` and so on."""


class DeviceProblem(NamedTuple):
    """A problem on a device: what kernels take, and what has to live as long as they run."""

    ref: wp.array
    keep: PlanProblem


@dataclass(frozen=True)
class CompiledPlan:
    """What the kernels need, and what is needed to understand their answer.

    Attributes:
        programme: with a storey for each room, and with stairs.
        envelope: of the plan.
        profile: whose rules it keeps.
        frames: ways to part the envelope; those of the tables have them for every storey.
        stairwell: None on one storey.
        arrays: by name of `kernels.plan_tables.PROBLEM`.
        numbers: the problem's other fields.
    """

    programme: Programme
    envelope: Envelope
    profile: Profile
    frames: tuple[Frame, ...]
    stairwell: Stairwell | None
    arrays: dict[str, np.ndarray]
    numbers: dict[str, Any]

    @property
    def cells(self) -> int:
        """How many cells a plan may have, with its fixed ones."""
        return self.numbers["cells"] + (2 * self.programme.storeys if self.stairwell else 0)

    def on_device(self, device: str) -> DeviceProblem:
        """The tables on a device."""
        problem = PlanProblem()
        for table in PROBLEM:
            setattr(problem, table.name, wp.array(self.arrays[table.name], dtype=table.dtype, device=device))
        for name, value in self.numbers.items():
            setattr(problem, name, value)
        return DeviceProblem(wp.array([problem], dtype=PlanProblem, device=device), problem)


class Rows:
    """The rows of a profile for one use, and what they say of a room."""

    def __init__(self, profile: Profile, use: str) -> None:
        self.hard, self.soft = profile.hard(use), profile.soft(use)

    def bound(self, measure: str, room: RoomSpec | None = None, soft: bool = False) -> tuple[float, float]:
        """The narrowest interval of a measure, for a room where one is given."""
        least, most = -np.inf, np.inf
        for row in self.soft if soft else self.hard:
            if row.measure == measure and (room is None or selects(row.of, room.kind)):
                least = max(least, -np.inf if row.least is None else row.least)
                most = min(most, np.inf if row.most is None else row.most)
        return least, most

    def slope(self, rule: str) -> float:
        """What an excess of 1 costs a candidate by a soft row; 0 where there is none."""
        return next((slope_of(row) for row in self.soft if row.id == rule), 0.0)

    def selected(self, rule: str, room: RoomSpec, side: Literal["of", "to"] = "of") -> bool:
        """Whether a soft row is about a room; not where there is no such row."""
        return any(row.id == rule and selects(getattr(row, side), room.kind) for row in self.soft)

    def form(self, measure: str, room: RoomSpec) -> Rule | None:
        """The narrowest of the soft rows that bound a measure of a room."""
        found = [row for row in self.soft if row.measure == measure and selects(row.of, room.kind)]
        return min(found, key=lambda row: (row.most or 0.0) - (row.least or 0.0), default=None)

    def door_least(self, room: RoomSpec, entrance: bool = False) -> float:
        """Least clear width [m] of a door."""
        wanted = "entrance-door" if entrance else "inner-door"
        rows = [row for row in self.hard if row.measure == "door_width" and wanted in row.of]
        words = room.kind.roles | {room.kind.name}
        rows = [row for row in rows if entrance or not words & set(row.except_of)]
        return max((row.least or 0.0 for row in rows), default=0.0)


def slope_of(row: Rule) -> float:
    """What an excess of 1 beyond a soft row costs a candidate, without an end: searches need a slope."""
    return SOFT_SHARE * row.weight / row.until


def mm(value: float) -> int:
    """Metres as whole millimetres, rounded up, at most what fits into an integer."""
    return int(min(np.ceil(round(1000 * value, 6)), UNBOUNDED))


def compile_plan(programme: Programme, envelope: Envelope, profile: Profile | str = "base") -> CompiledPlan:
    """The tables of a problem.

    Raises:
        InputError: the programme is too large, asks for what no plan of this kind has, or finds no place.
    """
    profile = Profile.of(profile)
    programme = programme.with_storeys()
    if envelope.storeys != programme.storeys:
        raise InputError(f"envelope has {envelope.storeys} storeys, the programme {programme.storeys}; make them equal")
    rows = Rows(profile, programme.use)
    rooms = programme.rooms
    stairwell = _stairwell(envelope, rows) if programme.storeys > 1 else None
    frames = frames_of(envelope, stairwell)
    if not frames:
        raise InputError("envelope has no place for the stairs; make it larger")
    cell_room = list(range(len(rooms)))
    for number, room in enumerate(rooms):
        if "stairs" not in room.kind.roles:
            cell_room += [number] * max((BENDS.get(role, 0) for role in room.kind.roles), default=0)
    fixed = 2 * programme.storeys if stairwell else 0
    most = tables.MAX_CELLS - fixed
    if len(rooms) > min(most, 31):
        raise InputError(f"programme has {len(rooms)} rooms with stairs; the solver takes at most {min(most, 31)}")
    cell_room = cell_room[: min(most, tables.MAX_CODE // 2)]
    arrays = _room_arrays(programme, rows) | _relation_arrays(programme, rows)
    arrays["cell_room"] = np.array(cell_room, dtype=np.int32)
    arrays["cell_side"] = arrays["room_side"][cell_room]
    arrays |= _frame_arrays(programme, frames) | _facade_arrays(envelope)
    circulation = rows.bound("circulation_share")[1], rows.bound("circulation_share", soft=True)[1]
    glazing = max((row.least or 0.0 for row in rows.hard if row.measure == "glazing"), default=0.0)
    groups = rows.bound("wet_groups")[1]
    entrance = programme.room(programme.entrance)
    turning = max((row.least or 0.0 for row in rows.hard if row.measure == "turning"), default=0.0)
    numbers = {
        "rooms": len(rooms),
        "cells": len(cell_room),
        "frames": len(frames),
        "storeys": programme.storeys,
        "entrance": programme.index[programme.entrance],
        "inner": mm(envelope.inner_wall),
        "jamb": JAMB,
        "pier": PIER,
        "entrance_door": max(ENTRANCE, mm(rows.door_least(entrance, entrance=True))),
        "glazing": mm(glazing),
        "pane": PANE,
        "least_window": WINDOW[0],
        "most_window": WINDOW[1],
        "wet_groups": int(min(groups, 99)),
        "wet_wall": WET_WALL,
        "corridors": wp.vec2i(*(int(min(1000 * share, 1000)) for share in circulation)),
        "large_room": int(1e6 * max((r.least or 0 for r in rows.hard if r.measure == "largest_area"), default=0)),
        "turning": mm(turning),
        "weights": _weights(rows),
    }
    for name, flag in SETS.items():
        has = (arrays["room_flags"] & int(flag)) != 0
        numbers[name] = sum(1 << int(room) for room in np.flatnonzero(has))
    return CompiledPlan(programme, envelope, profile, tuple(frames), stairwell, arrays, numbers)


def _stairwell(envelope: Envelope, rows: Rows) -> Stairwell:
    rise = round(1000 * envelope.height) + SLAB
    riser, going, width = rows.bound("riser")[1], rows.bound("going")[0], rows.bound("stair_width")[0]
    return Stairwell.between(
        rise,
        int(1000 * min(riser, 0.2)),
        mm(max(going, 0.2)),
        mm(max(width, 0.8)),
        mm(max(rows.bound("passage")[0], 0.8)),
    )


def _roomy(room: RoomSpec) -> bool:
    """Whether each part of a room is as wide as the room has to be: no hall."""
    return "circulation" not in room.kind.roles


def _passage(rows: Rows, room: RoomSpec) -> int:
    """Least width [mm] of a hall."""
    return mm(max(rows.bound("passage", room)[0], 0.95))


def _room_arrays(programme: Programme, rows: Rows) -> dict[str, np.ndarray]:
    areas, sides, aspects, forms, flags, storeys, ranks, doors = [], [], [], [], [], [], [], []
    accessible = accessible_toilet(programme, rows)
    for room in programme.rooms:
        roles = room.kind.roles
        least, most = rows.bound("area", room)
        if room is accessible:
            least = max(least, ACCESSIBLE_TOILET)
        wanted = (max(room.area[0], least), room.area[1], min(room.area[2], most))
        areas.append([int(np.ceil(1e6 * wanted[0])), int(1e6 * wanted[1]), int(1e6 * wanted[2])])
        side = max(room.side or 0.0, rows.bound("side", room)[0], rows.bound("turning", room)[0], 0.6)
        if "circulation" in roles:
            side = max(side, _passage(rows, room) / 1000)
        sides.append(mm(side))
        aspects.append(int(min(1000 * rows.bound("aspect", room)[1], 10**6)))
        forms.append(_form(room, rows))
        flags.append(_flags(room, programme, rows))
        storeys.append(0 if "stairs" in roles else 1 << (room.storey or 0))
        ranks.append(_rank(room))
        least_door = rows.door_least(room)
        doors.append(max(DOORS.get(room.type, DOOR), mm(least_door)))
    return {
        "room_area": np.array(areas, dtype=np.int32),
        "room_side": np.array(sides, dtype=np.int32),
        "room_aspect": np.array(aspects, dtype=np.int32),
        "room_form": np.array(forms, dtype=np.float32),
        "room_flags": np.array(flags, dtype=np.int32),
        "room_storeys": np.array(storeys, dtype=np.int32),
        "room_rank": np.array(ranks, dtype=np.int32),
        "room_door": np.array(doors, dtype=np.int32),
    }


def _form(room: RoomSpec, rows: Rows) -> list[float]:
    """Ratio of sides from which a room costs something, and how much; the same of how much it fills of a rectangle."""
    aspect, fill = rows.form("aspect", room), rows.form("fill", room)
    usual = 2.5 if _roomy(room) else 6.0
    ratio = [usual, 0.2] if aspect is None or aspect.most is None else [aspect.most, slope_of(aspect)]
    return ratio + ([0.0, 0.0] if fill is None or fill.least is None else [fill.least, slope_of(fill)])


def accessible_toilet(programme: Programme, rows: Rows) -> RoomSpec | None:
    """The toilet to be accessible, where the profile asks for one: the largest on the entrance's storey."""
    entrance = programme.room(programme.entrance)
    toilets = [r for r in programme.rooms if "toilet" in r.kind.roles and r.storey == entrance.storey]
    asked = any(row.measure == "accessible_toilets" for row in rows.hard)
    return max(toilets, key=lambda r: r.area[2]) if asked and toilets else None


def _flags(room: RoomSpec, programme: Programme, rows: Rows) -> int:
    roles = room.kind.roles
    # an annex without a door of its own stands at a way, like any room
    flags = {
        tables.THROUGH: room.kind.transit == "all",
        tables.SUITE: room.kind.transit == "suite",
        tables.ANNEX: "annex" in roles,
        tables.GLAZED: rows.bound("glazing", room)[0] > 0,
        tables.LIT: room.needs_daylight or rows.bound("escape", room)[0] > 0,
        tables.WET: "wet" in roles,
        tables.CIRCULATION: "circulation" in roles and "stairs" not in roles,
        tables.LARGE: rows.bound("largest_area", room)[0] > 0,
        tables.STAIRS: "stairs" in roles,
        tables.SUNNY: rows.bound("sun", room, soft=True)[0] > 0,
        tables.TURNING: rows.bound("turning", room)[0] > 0,
        tables.PUBLIC: "public" in roles,
        tables.QUIET: "sleeping" in roles and "living" not in roles,
        tables.SLIDING: bool(roles & {"service", "annex"}),
        tables.LIVING: rows.selected("living-first", room, "to"),
        tables.MASTER: rows.selected("master-largest", room, "to"),
        tables.DAY: rows.selected("toilet-not-at-kitchen", room, "to"),
        tables.TOILET: rows.selected("toilet-not-at-kitchen", room),
        tables.TWO_SIDED: rows.selected("two-sides", room),
    }
    return sum(bit for bit, holds in flags.items() if holds)


def _rank(room: RoomSpec) -> int:
    """Which rooms others are entered from: halls first, then stairs, living rooms, what else is a way."""
    roles = room.kind.roles
    if "stairs" in roles:
        return 1
    if "circulation" in roles:
        return 0
    if room.kind.transit != "all":
        return 9
    return 3 if "cooking" in roles else 2


def _relation_arrays(programme: Programme, rows: Rows) -> dict[str, np.ndarray]:
    adjacency, weights = [], []
    widths = {room.id: max(DOORS.get(room.type, DOOR), mm(rows.door_least(room))) for room in programme.rooms}
    for x in programme.adjacencies:
        width = min(widths[x.a], widths[x.b])
        if x.kind == "open":
            stairs = any("stairs" in programme.room(end).kind.roles for end in (x.a, x.b))
            width = max(900, width) if stairs else PASSAGE
        adjacency.append([programme.index[x.a], programme.index[x.b], KINDS[x.kind], width])
        weights.append(-1.0 if x.hard else 0.5 * x.weight)
    for a, b, row in _doors_wished(programme, rows):
        adjacency.append([programme.index[a], programme.index[b], tables.DOOR, min(widths[a], widths[b])])
        weights.append(slope_of(row))
    if len(adjacency) > tables.MAX_ROWS:
        raise InputError(f"adjacencies are {len(adjacency)}; the solver takes at most {tables.MAX_ROWS}")
    wishes: list[tuple[int, int, float, float]] = []
    for row in rows.soft:
        if row.measure == "distance":
            wishes += _wishes(programme, row)
    return {
        "adjacency": np.array(adjacency, dtype=np.int32).reshape(-1, 4),
        "adjacency_weight": np.array(weights, dtype=np.float32),
        "wish_room": np.array([w[0] for w in wishes], dtype=np.int32),
        "wish_mask": np.array([w[1] for w in wishes], dtype=np.int32),
        "wish_reach": np.array([[w[2], w[3]] for w in wishes], dtype=np.float32).reshape(-1, 2),
    }


def _doors_wished(programme: Programme, rows: Rows) -> Iterable[tuple[str, str, Rule]]:
    """Pairs of rooms of a storey that a soft row wants a door between, the programme having none for the first."""
    joined = [{x.a, x.b} for x in programme.adjacencies if x.kind in ("door", "open", "apart")]
    for row in rows.soft:
        if row.measure == "door_between" and row.least:
            for room in programme.rooms:
                others = [o.id for o in programme.rooms if selects(row.to, o.kind) and o.storey == room.storey]
                pairs = [{room.id, other} for other in others if other != room.id]
                if selects(row.of, room.kind) and pairs and not any(pair in joined for pair in pairs):
                    near = [{x.a, x.b} for x in programme.adjacencies if x.kind == "near"]
                    other = next((p for p in pairs if p in near), pairs[0]) - {room.id}
                    yield room.id, other.pop(), row


def _wishes(programme: Programme, row: Rule) -> Iterable[tuple[int, int, float, float]]:
    for number, room in enumerate(programme.rooms):
        others = sum(1 << k for k, o in enumerate(programme.rooms) if k != number and selects(row.to, o.kind))
        if selects(row.of, room.kind) and others and not selects(row.to, room.kind):
            yield number, others, 1000 * (row.most or 0.0), slope_of(row)


def _frame_arrays(programme: Programme, frames: Iterable[Frame]) -> dict[str, np.ndarray]:
    stairs = [k for k, room in enumerate(programme.rooms) if "stairs" in room.kind.roles]
    by_storey = {programme.rooms[k].storey: k for k in stairs}
    frames = list(frames)
    bays, storeys, fixed, fixed_room = [], [], [], []
    starts, fixed_starts = [0], [0]
    for frame in frames:
        for storey in range(programme.storeys):
            bays += frame.bays[storey]
            storeys += [storey] * len(frame.bays[storey])
            for part in frame.fixed:
                fixed.append(part.rect)
                fixed_room.append([by_storey[storey], storey, int(part.doors)])
        starts.append(len(bays))
        fixed_starts.append(len(fixed))
    counts = [tuple(map(len, frame.bays)) for frame in frames]
    families = [[counts.index(c), len(counts) - counts[::-1].index(c)] for c in counts]
    return {
        "bay_start": np.array(starts, dtype=np.int32),
        "bay": np.array(bays, dtype=np.int32).reshape(-1, 4),
        "bay_storey": np.array(storeys, dtype=np.int32),
        "fixed_start": np.array(fixed_starts, dtype=np.int32),
        "fixed": np.array(fixed, dtype=np.int32).reshape(-1, 4),
        "fixed_room": np.array(fixed_room, dtype=np.int32).reshape(-1, 3),
        "frame_family": np.array(families, dtype=np.int32).reshape(-1, 2),
        "frame_share": np.linspace(0, 1, len(frames) + 1, dtype=np.float32)[1:],
    }


def _facade_arrays(envelope: Envelope) -> dict[str, np.ndarray]:
    corners, outer = millimetres(envelope.inner), millimetres(envelope.outline)
    facades, flags = [], []
    for wall, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1], strict=True)):
        c, d = outer[wall], outer[(wall + 1) % len(outer)]
        along = (np.sign(b[0] - a[0]), np.sign(b[1] - a[1]))
        side = SIDES[int(along[1]), -int(along[0])]
        axis = side % 2
        # at an inward corner the inner face goes on behind the wall that meets it there
        low = max(min(a[1 - axis], b[1 - axis]), min(c[1 - axis], d[1 - axis]))
        high = min(max(a[1 - axis], b[1 - axis]), max(c[1 - axis], d[1 - axis]))
        facades.append([side, a[axis], low, high])
        windows = wall in envelope.open_walls
        entrance = envelope.entrance_wall in (None, wall)
        flags.append(tables.WINDOWS * windows + tables.ENTRANCE * entrance)
    return {
        "facade": np.array(facades, dtype=np.int32),
        "facade_flags": np.array(flags, dtype=np.int32),
    }


def _weights(rows: Rows) -> Any:
    weight = {
        "area": 1.0,
        "corridors": rows.slope("corridors-short"),
        "wet": rows.slope("wet-together"),
        "dead_ends": rows.slope("no-dead-ends"),
        "sun": 0.4 * rows.slope("living-sun"),
        "bedroom_doors": rows.slope("bedrooms-apart"),
        "toilet_doors": rows.slope("toilet-not-at-kitchen"),
        "halls": rows.slope("hall-modest"),
        "bedrooms": rows.slope("living-largest"),
        "master": rows.slope("master-largest"),
        "two_sides": rows.slope("two-sides"),
        "living_first": rows.slope("living-first"),
    }
    return [weight[name] for name in SOFT]
