"""Disturbed zoo layouts, judged by the oracle (tests/oracle/check_scene.py) and by `sceneweaver.verify.check`."""

from __future__ import annotations

import copy
import importlib.util
import json
import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.scene import Scene
from sceneweaver.verify import check

TESTS = Path(__file__).parents[1]
ZOO = TESTS / "zoo"
NEAR_M, NEAR_DEG = 1e-4, 0.01  # how near to a threshold two judges may differ

_spec = importlib.util.spec_from_file_location("oracle_check_scene", TESTS / "oracle" / "check_scene.py")
oracle = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(oracle)

FACES = {"front": (0, 1, 0.0), "left": (1, 0, 90.0), "back": (0, 1, 180.0), "right": (1, 0, 270.0)}
TIES = ("front_against", "front_to_front", "leftright_to_leftright", "side_by_side", "back_to_back", "around")
PAIR_TYPES = {
    "front_against": (("front",), ("front", "back", "left", "right")),
    "front_to_front": (("front",), ("front",)),
    "leftright_to_leftright": (("left", "right"), ("left", "right")),
    "side_by_side": (("left", "right", "front"), ("left", "right", "front")),
    "back_to_back": (("back",), ("back",)),
}
LOOSE_TYPES = ("near", "distance", "facing", "aligned", "parallel", "centered_on")
WALL_TYPES = ("against_wall", "side_against_wall", "in_corner", "at_window")
ORACLE_TYPES = (*PAIR_TYPES, *LOOSE_TYPES, *WALL_TYPES)
CATEGORIES = ("collision", "out_of_bounds", "zone", "opening", "unsupported")

Json = dict[str, Any]
Fact = tuple[str, ...]


def zoo(name: str) -> Json:
    """The JSON of a zoo room."""
    return json.loads((ZOO / f"{name}.json").read_text("utf-8"))


# ---- disturbing


class Layout:
    """A zoo scene whose objects can be moved; yaws in degrees."""

    def __init__(self, scene: Json, rng: np.random.Generator) -> None:
        self.rng = rng
        self.scene = {**scene, "room": copy.deepcopy(scene["room"]), "objects": [dict(o) for o in scene["objects"]]}
        self.objects = {o["id"]: o for o in self.scene["objects"]}
        self.pose = {}
        for o in self.scene["objects"]:
            x, y, z = o["pose"]["position"]
            self.pose[o["id"]] = [x, y, z, math.degrees(oracle.yaw_of(o["pose"]["quaternion"]))]
        self.walls = oracle.walls(scene["room"])
        self.standing = [k for k, o in self.objects.items() if not o.get("support")]
        self.relations = [dict(r) for r in scene["relations"]]
        self.named = {self._name(r) for r in self.relations}

    def pick(self, items: Any) -> Any:
        return items[self.rng.integers(len(items))]

    def some(self, scale: float) -> float:
        return float(self.rng.normal(0.0, scale))

    def shift(self, scale: float, share: float) -> None:
        """Move and turn a share of what stands on the floor, with what rests on it."""
        for k in self.standing:
            if self.rng.random() < share:
                p = self.pose[k]
                self.carry(k, [p[0] + self.some(scale), p[1] + self.some(scale), p[2], p[3] + self.some(scale * 50)])

    def carry(self, k: str, pose: list[float]) -> None:
        """Put an object elsewhere, and what rests on it most times along."""
        old, self.pose[k] = self.pose[k], pose
        turn = math.radians(pose[3] - old[3])
        c, s = math.cos(turn), math.sin(turn)
        for child, o in self.objects.items():
            if o.get("support") and o["support"]["object"] == k and self.rng.random() < 0.8:
                p = self.pose[child]
                dx, dy = p[0] - old[0], p[1] - old[1]
                x, y = pose[0] + c * dx - s * dy, pose[1] + s * dx + c * dy
                self.pose[child] = [x, y, p[2] + pose[2] - old[2], p[3] + pose[3] - old[3]]

    def rest(self) -> None:
        """Shift what rests on surfaces: along, across the edge, up, down, into each other."""
        for k, o in self.objects.items():
            if o.get("support") and self.rng.random() < 0.5:
                p = self.pose[k]
                p[0] += self.some(self.pick((0.01, 0.1)))
                p[1] += self.some(self.pick((0.01, 0.1)))
                p[2] += self.pick((0.0, 0.0, 0.001, -0.0015, 0.002, -0.002, 0.0025, -0.003, 0.05, -0.2))

    def lift(self) -> None:
        """Raise or sink some objects, and hang some on the wall."""
        for k in self.standing:
            if self.rng.random() < 0.1:
                self.pose[k][2] += self.pick((0.001, -0.0015, 0.0025, -0.003, 0.4, 1.0, 2.0, -0.2))
            if self.rng.random() < 0.08:
                self.objects[k]["mount"] = "wall"
                self.pose[k][2] = max(0.0, self.pose[k][2] + self.pick((0.0, 1.0)))

    def swap(self) -> None:
        a, b = self.pick(self.standing), self.pick(self.standing)
        pa, pb = list(self.pose[a]), list(self.pose[b])
        self.carry(a, pb)
        self.carry(b, pa)

    def beside(self, kind: str) -> None:
        """Put one object to a face of another, more or less, and relate them."""
        a, b = self.pick(self.standing), self.pick(self.standing)
        if a == b:
            return
        mine, theirs = (self.pick(sides) for sides in PAIR_TYPES[kind])
        x, y, z, yaw = self.pose[b]
        (ra, wa, ta), (rb, wb, tb) = self._face(a, mine), self._face(b, theirs)
        out = math.radians(yaw + tb)
        nx, ny = math.cos(out), math.sin(out)
        gap, along = self.rng.uniform(-0.04, 0.09), self.rng.uniform(-1.2, 1.2) * (wa + wb)
        turned = yaw + tb + 180.0 - ta + self.some(9.0)
        if self.rng.random() < 0.06:  # just at a threshold
            gap, along = self.pick((0.0, 0.05, 0.051, -0.001)), self.pick((0.0, max(wa, wb) / 0.6))
            turned = yaw + tb + 180.0 - ta + self.pick((0.0, 0.0, 10.0, -15.0))
        back = math.radians(turned + ta)
        px = x + nx * (rb + gap) - ny * along * 0.6 - math.cos(back) * ra
        py = y + ny * (rb + gap) + nx * along * 0.6 - math.sin(back) * ra
        self.carry(a, [px, py, self.pose[a][2], turned])
        params = self.pick(({}, {}, {"gap": [-0.3, 0.02]}, {"gap": [0.02, 0.4]}))
        self.relate(kind, a, b, params)

    def to_wall(self) -> None:
        """Put an object to a wall, more or less, at any spot along it."""
        a, kind = self.pick(self.standing), self.pick(("against_wall", "side_against_wall"))
        side = "back" if kind == "against_wall" else self.pick(("left", "right", "front"))
        i = int(self.rng.integers(len(self.walls)))
        w = self.walls[i]
        r, half, t = self._face(a, side)
        turned = math.degrees(math.atan2(-w["n"][1], -w["n"][0])) - t + self.some(3.5)
        out = math.radians(turned + t)
        gap = self.rng.uniform(-0.01, 0.1)
        s = self.rng.uniform(0.7 * half, max(w["L"] - 0.7 * half, 0.8 * half))
        if self.rng.random() < 0.06:  # just at a threshold
            gap, s = self.pick((-0.001, 0.0, 0.05, 0.07, 0.071)), self.pick((half, 0.8 * half, w["L"] - 0.8 * half))
        px = w["p"][0] + w["t"][0] * s + w["n"][0] * gap - math.cos(out) * r
        py = w["p"][1] + w["t"][1] * s + w["n"][1] * gap - math.sin(out) * r
        self.carry(a, [px, py, self.pose[a][2], turned])
        target = self.pick((None, f"wall:{i}", f"wall:{self.rng.integers(len(self.walls))}"))
        self.relate(kind, a, target, self.pick(({}, {}, {"gap": [0.0, 0.03]}, {"gap": [0.02, 0.2]})))

    def to_corner(self) -> None:
        a = self.pick(self.standing)
        i = int(self.rng.integers(len(self.walls)))
        before, after = self.walls[i - 1], self.walls[i]
        d, w, _ = self.objects[a]["size"]
        u, v = self.rng.uniform(-0.05, 0.3, 2) + (d / 2, w / 2)
        x = after["p"][0] + after["n"][0] * v - before["t"][0] * u
        y = after["p"][1] + after["n"][1] * v - before["t"][1] * u
        turned = math.degrees(math.atan2(after["t"][1], after["t"][0])) + self.some(6.0)
        self.carry(a, [x, y, self.pose[a][2], turned])
        self.relate("in_corner", a, None, {})

    def to_window(self) -> None:
        if not self.scene["room"]["windows"]:
            return
        a, o = self.pick(self.standing), self.pick(self.scene["room"]["windows"])
        w, half = self.walls[o["wall"]], self.objects[a]["size"][1] / 2
        s = o["offset"] + o["width"] / 2 + self.rng.uniform(-1, 1) * (o["width"] / 2 + half)
        g = self.objects[a]["size"][0] / 2 + self.rng.uniform(0.0, 1.3)
        x, y = (w["p"][k] + w["t"][k] * s + w["n"][k] * g for k in (0, 1))
        turned = math.degrees(math.atan2(w["n"][1], w["n"][0])) + self.some(4.0)
        self.carry(a, [x, y, self.pose[a][2], turned])
        self.relate("at_window", a, o["id"], {})

    def relate_any(self) -> None:
        """Relate any two objects, the second often turned or shifted so that the relation nearly holds."""
        kind = self.pick(LOOSE_TYPES)
        a, b = self.pick(list(self.objects)), self.pick(list(self.objects))
        if a == b:
            return
        p = self.pose[a]
        if kind in ("aligned", "parallel") and self.rng.random() < 0.6:
            p[3] = self.pose[b][3] + self.pick((0.0, 90.0, 180.0)) + self.some(3.0)
        if kind == "centered_on" and self.rng.random() < 0.5:
            p[0] = self.pose[b][0] + self.some(0.15)
        if kind == "facing" and self.rng.random() < 0.6:
            towards = math.atan2(self.pose[b][1] - p[1], self.pose[b][0] - p[0])
            p[3] = math.degrees(towards) + self.some(15.0)
        low = float(self.rng.uniform(0.0, 1.0))
        params = {
            "near": self.pick(({}, {"max": low * 2})),
            "distance": {"min": low, "max": low + 1.0},
            "facing": self.pick(({}, {"degrees": 25.0})),
        }
        self.relate(kind, a, b, params.get(kind, {}))

    def relate(self, kind: str, subject: str, target: str | None, params: Json) -> None:
        hard = bool(self.rng.random() < 0.8)
        relation = {"type": kind, "subject": subject, "target": target, "params": params, "hard": hard, "weight": 1.0}
        if self._name(relation) not in self.named:
            self.named.add(self._name(relation))
            self.relations.append(relation)

    def done(self) -> Json:
        for k, (x, y, z, yaw) in self.pose.items():
            half = math.radians(yaw) / 2
            quaternion = [0.0, 0.0, math.sin(half), math.cos(half)]
            self.objects[k]["pose"] = {"position": [float(x), float(y), float(z)], "quaternion": quaternion}
        for door in self.scene["room"]["doors"]:
            door["swing"] = self.pick(("in-left", "in-right", "out", "slide"))
        return {**self.scene, "relations": self.relations}

    def _face(self, k: str, side: str) -> tuple[float, float, float]:
        """Distance of a face from the centre, its half width and its direction."""
        reach, across, direction = FACES[side]
        size = self.objects[k]["size"]
        return size[reach] / 2, size[across] / 2, direction

    @staticmethod
    def _name(r: Json) -> Fact:
        return r["subject"], r["type"], str(r.get("target"))


def disturb(scene: Json, rng: np.random.Generator, moves: int) -> Json:
    """A layout near the witness or far from it, with more relations than it came with."""
    layout = Layout(scene, rng)
    layout.shift(layout.pick((0.0, 0.002, 0.01, 0.05, 0.3)), layout.pick((0.2, 1.0)))
    actions = [lambda kind=kind: layout.beside(kind) for kind in PAIR_TYPES]
    actions += [layout.to_wall, layout.to_wall, layout.to_corner, layout.to_window, layout.swap]
    for _ in range(int(rng.integers(0, moves + 1))):
        layout.pick(actions)()
    for _ in range(6):
        layout.relate_any()
    if rng.random() < 0.5:
        layout.rest()
    if rng.random() < 0.4:
        layout.lift()
    return layout.done()


# ---- judging


def _relation(r: Json) -> Fact:
    target = r.get("target")
    return ("relation", r["subject"], r["type"], " and ".join(target) if isinstance(target, list) else str(target))


def by_oracle(scene: Json) -> set[Fact]:
    """Everything that the oracle finds wrong; a relation that does not hold is wrong."""
    bodies = {o["id"]: oracle.Obj(o) for o in scene["objects"]}
    ties = [r for r in scene["relations"] if r["type"] in TIES]
    found = oracle.check({**scene, "relations": ties}, cache=bodies)
    hanging = {o["id"] for o in scene["objects"] if o["mount"] == "wall"}  # the oracle has no support for these
    facts: set[Fact] = {("collision", *sorted(pair)) for pair in found["collisions"]}
    facts |= {("out_of_bounds", k) for k in found["oob"]}
    facts |= {("zone", *triple) for triple in found["zones"]}
    facts |= {("opening", *pair) for pair in found["openings"]}
    facts |= {("unsupported", k) for k in found["support"] if k not in hanging}
    walls = oracle.walls(scene["room"])
    facts |= {_relation(r) for r in scene["relations"] if not oracle.holds(r, bodies, walls, scene["room"])}
    return facts


def by_check(scene: Json) -> set[Fact]:
    """The same from the report, whose counts must agree with its violations."""
    report = check(Scene.model_validate(scene), walkable=False)
    hanging = {o["id"] for o in scene["objects"] if o["mount"] == "wall"}
    facts: set[Fact] = set()
    kinds = Counter(v.kind for v in report.violations)
    for v in report.violations:
        if v.kind in ("collision", "out_of_bounds"):
            facts.add((v.kind, *sorted(v.objects)))
        elif v.kind == "blocked_zone":
            facts.add(("zone", v.objects[0], str(v.zone), v.objects[1]))
        elif v.kind == "blocked_opening":
            facts.add(("opening", v.objects[1], v.objects[0]))
        elif v.kind == "unsupported":
            if v.objects[0] not in hanging:
                facts.add(("unsupported", v.objects[0]))
        else:
            target = " and ".join(v.objects[1:]) or None
            facts.add(("relation", v.objects[0], v.relation.type if v.relation else "", str(target)))
    assert (report.collisions, report.out_of_bounds) == (kinds["collision"], kinds["out_of_bounds"])
    assert (report.blocked_zones, report.blocked_openings) == (kinds["blocked_zone"], kinds["blocked_opening"])
    for tally, kind, hard in (
        (report.relations.hard, "relation", True),
        (report.relations.soft, "soft_relation", False),
    ):
        assert tally.total == sum(r["hard"] is hard for r in scene["relations"])
        assert tally.total - tally.satisfied == kinds[kind]
    assert report.valid == (not (len(report.violations) - kinds["soft_relation"]))
    return facts


def at_threshold(scene: Json, fact: Fact, judge: Callable[[Json], set[Fact]] = by_oracle) -> bool:
    """Whether a judge changes its mind when an object that takes part is nudged by 0.1 mm or 0.01 degrees."""
    before = fact in judge(scene)
    ids = {o["id"]: o for o in scene["objects"]}
    step = math.radians(NEAR_DEG) / 2
    for name in {n for n in fact if n in ids}:
        pose = ids[name]["pose"]
        x, y, z = pose["position"]
        qx, qy, qz, qw = pose["quaternion"]
        moves = product((-NEAR_M, 0, NEAR_M), (-NEAR_M, 0, NEAR_M), (0,), (-step, 0, step))
        for dx, dy, dz, turn in (*moves, (0, 0, NEAR_M, 0), (0, 0, -NEAR_M, 0)):
            c, s = math.cos(turn), math.sin(turn)
            quaternion = [c * qx - s * qy, c * qy + s * qx, c * qz + s * qw, c * qw - s * qz]
            moved = {**ids[name], "pose": {"position": [x + dx, y + dy, z + dz], "quaternion": quaternion}}
            objects = [moved if o["id"] == name else o for o in scene["objects"]]
            if (fact in judge({**scene, "objects": objects})) != before:
                return True
    return False


@dataclass
class Agreement:
    """What came of judging many layouts twice."""

    layouts: int = 0
    seen: Counter = field(default_factory=Counter)
    near: list[tuple[str, Fact]] = field(default_factory=list)
    wrong: list[tuple[str, Fact]] = field(default_factory=list)


def compare(rooms: dict[str, int], moves: int) -> Agreement:
    """Judge as many layouts of each room as asked for; ``seen`` counts (category or relation type, whether wrong)."""
    result = Agreement()
    for name, count in rooms.items():
        witness = zoo(name)
        for seed in range(count):
            scene = disturb(witness, np.random.default_rng([seed, len(name), moves]), moves)
            theirs, ours = by_oracle(scene), by_check(scene)
            for fact in theirs ^ ours:
                where = result.near if at_threshold(scene, fact) else result.wrong
                where.append((f"{name} layout {seed}", fact))
            found = {fact[0] for fact in theirs}
            result.seen.update((kind, kind in found) for kind in CATEGORIES)
            result.seen.update((r["type"], _relation(r) in theirs) for r in scene["relations"])
            result.layouts += 1
    return result
