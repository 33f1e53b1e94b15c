"""Plans for tests: problems compiled once, candidates as the search leaves them, and a float64 twin of the measures."""

from __future__ import annotations

from functools import cache

import numpy as np

from sceneweaver.kernels import plan_tables as T
from sceneweaver.plans import Envelope, Programme, envelope_for
from sceneweaver.plans.solve_problem import CompiledPlan, compile_plan
from sceneweaver.plans.solve_run import run_rounds


@cache
def problem(name: str = "flat-2-bedrooms", seed: int = 1, profile: str = "base") -> CompiledPlan:
    """A compiled example."""
    programme = Programme.example(name)
    return compile_plan(programme, envelope_for(programme, seed), profile)


@cache
def candidates(name: str = "flat-2-bedrooms", seed: int = 1, count: int = 48, moves: int = 200):
    """The arrays of a short search: some candidates are valid, most are not."""
    return run_rounds(problem(name, seed), count, 3, 1, moves, "cpu", np.inf)[0]


def small() -> tuple[Programme, Envelope]:
    """A flat of four rooms that is quick to plan."""
    programme = Programme.from_graph(
        {"hall": "entrance_hall", "living": ("living_kitchen", 26), "bed": "bedroom", "bath": "bathroom"},
        [("hall", "living"), ("hall", "bed"), ("hall", "bath")],
    )
    return programme, Envelope.rectangle(9, 7)


class Twin:
    """Violations of one candidate by the words of the rules, in Python's integers and floats."""

    def __init__(self, plan: CompiledPlan, frame: int, cells: np.ndarray, storey: np.ndarray, owner: np.ndarray):
        self.plan, self.a, self.n = plan, plan.arrays, plan.numbers
        self.cells = [
            (k, tuple(map(int, cells[k])), int(storey[k]), int(owner[k])) for k in range(len(cells)) if storey[k] >= 0
        ]
        self.inner, self.rooms = self.n["inner"], self.n["rooms"]
        first = self.a["fixed_start"][frame]
        self.closed = {
            k
            for k, *_ in self.cells
            if k >= self.n["cells"] and not self.a["fixed_room"][first + k - self.n["cells"]][2]
        }

    def has(self, room: int, bit: int) -> bool:
        return bool(self.a["room_flags"][room] & int(bit))

    def of(self, room: int, doors: bool = False):
        return [(k, c, s) for k, c, s, o in self.cells if o == room and not (doors and k in self.closed)]

    @staticmethod
    def gap(p, q):
        return [max(p[i], q[i]) - min(p[i + 2], q[i + 2]) for i in (0, 1)]

    def shared(self, p, q):
        g = self.gap(p, q)
        return next((-g[1 - i] for i in (0, 1) if g[i] == self.inner and g[1 - i] < 0), 0)

    def lack(self, p, q, need):
        g = self.gap(p, q)
        return min(abs(g[i] - self.inner) + max(need + g[1 - i], 0) for i in (0, 1))

    def rooms_lack(self, a, b, need, doors=True):
        found = [self.lack(p, q, need) for _, p, s in self.of(a, doors) for _, q, t in self.of(b, doors) if s == t]
        return min(found, default=1_000_000)

    def door(self, a, b):
        return int(min(self.a["room_door"][a], self.a["room_door"][b]))

    def floor(self, room):
        cells = self.of(room)
        total = sum((c[2] - c[0]) * (c[3] - c[1]) for _, c, _ in cells)
        home = next((c for k, c, _ in cells if k == room), None)
        for k, c, _ in cells:
            if self.rooms <= k < self.n["cells"] and home and self.shared(c, home) >= self.a["room_side"][room]:
                total += self.shared(c, home) * self.inner
        return total

    def light(self, room):
        total = 0
        for _, c, _ in self.of(room):
            for (side, at, low, high), flags in zip(self.a["facade"], self.a["facade_flags"], strict=True):
                along = 1 - side % 2
                if flags & int(T.WINDOWS) and c[side] == at:
                    free = min(c[along + 2], high) - max(c[along], low) - 2 * self.n["pier"]
                    total += free if free >= self.n["least_window"] else 0
        return total

    def touching(self, a, b):
        need = self.door(a, b) + 2 * self.n["jamb"]
        return any(s == t and self.shared(p, q) >= need for _, p, s in self.of(a, True) for _, q, t in self.of(b, True))

    def must(self):
        pairs = set()
        for (a, b, kind, width), _ in zip(self.a["adjacency"], self.a["adjacency_weight"], strict=True):
            if kind in (int(T.DOOR), int(T.OPEN)) and self.rooms_lack(a, b, width + 2 * self.n["jamb"]) == 0:
                pairs |= {(int(a), int(b)), (int(b), int(a))}
        return pairs

    def reached(self):
        """Rooms that are reached: whichever order they are taken in."""
        must = self.must()
        asked = {a for a, _ in must}
        seen, grew = {self.n["entrance"]}, True
        while grew:
            grew = False
            for a in list(seen):
                for b in set(range(self.rooms)) - seen:
                    way = (a, b) in must
                    if self.has(a, T.THROUGH):
                        way |= self.touching(a, b) and not (b in asked and self.has(b, T.ANNEX))
                        way |= self.has(a, T.STAIRS) and self.has(b, T.STAIRS)
                    else:
                        way &= self.has(a, T.SUITE) and self.has(b, T.ANNEX)
                    if way:
                        seen.add(b)
                        grew = True
        return seen

    def wet_groups(self):
        wet = [r for r in range(self.rooms) if self.has(r, T.WET)]
        wall = self.n["wet_wall"]

        def joined(a, b):
            for _, p, s in self.of(a):
                for _, q, t in self.of(b):
                    if s == t and self.shared(p, q) >= wall:
                        return True
                    if abs(s - t) == 1 and max(self.gap(p, q)) <= -wall:
                        return True
            return False

        groups, left = 0, set(wet)
        while left:
            groups += 1
            front = [left.pop()]
            while front:
                room = front.pop()
                more = {o for o in left if joined(room, o)}
                left -= more
                front += more
        return groups

    def violations(self) -> dict[str, float]:
        """By rule; for ``reached`` and ``wet-groups`` 1 where it is broken, else 0."""
        a, n = self.a, self.n
        floors = [self.floor(r) for r in range(self.rooms)]
        found = dict.fromkeys(("area", "side", "aspect", "glazing", "adjacency", "reached", "wet-groups"), 0.0)
        for r in range(self.rooms):
            least, _, most = (int(v) for v in a["room_area"][r])
            found["area"] += (max(least - floors[r], 0) + max(floors[r] - most, 0)) / 1e6
            boxes = [c for _, c, _ in self.of(r)]
            hull = (
                [min(c[i] for c in boxes) for i in (0, 1)] + [max(c[i] for c in boxes) for i in (2, 3)]
                if boxes
                else None
            )
            for k, c, _ in self.of(r):
                if k < n["cells"]:
                    found["side"] += max(int(a["cell_side"][k]) - min(c[2] - c[0], c[3] - c[1]), 0) / 1000
            if hull:
                short, long = sorted((hull[2] - hull[0], hull[3] - hull[1]))
                ratio = int(a["room_aspect"][r])
                if 1000 * long > ratio * short:
                    found["aspect"] += max(long - ratio * short / 1000, 1) / 1000
            need = n["least_window"] if self.has(r, T.LIT) else 0
            if self.has(r, T.GLAZED):
                need = max(need, -(-floors[r] * n["glazing"] // (1000 * n["pane"])))
            if self.light(r) < need:
                way = min(
                    abs(hull[side] - at)
                    for (side, at, *_), f in zip(a["facade"], a["facade_flags"], strict=True)
                    if f & int(T.WINDOWS)
                )
                found["glazing"] += (need - self.light(r) + 0.3 * min(way, 10000)) / 1000
        for (x, y, kind, width), weight in zip(a["adjacency"], a["adjacency_weight"], strict=True):
            if weight >= 0:
                continue
            if kind == int(T.APART):
                lack = 1.0 if self.rooms_lack(x, y, 1, False) == 0 else 0.0
            elif kind == int(T.NEAR):
                lack = min(self.rooms_lack(x, y, n["wet_wall"], False), 20000) / 1000
            else:
                lack = min(self.rooms_lack(x, y, width + 2 * n["jamb"]), 20000) / 1000
                lack += 0.3 if lack else 0.0
            found["adjacency"] += lack
        found["reached"] = float(len(self.reached()) < self.rooms)
        found["wet-groups"] = float(self.wet_groups() > n["wet_groups"])
        halls = sum(f for r, f in enumerate(floors) if self.has(r, T.CIRCULATION))
        found["corridors"] = max(0.0, 20 * (halls / max(sum(floors), 1) - n["corridors"][0] / 1000))
        large = max((f for r, f in enumerate(floors) if self.has(r, T.LARGE)), default=0)
        found["large-room"] = max(n["large_room"] - large, 0) / 1e6
        return found
