"""Rows, runs, grids and even seats from random starts: found by the search and made exact."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.scene import Door, Relation, Room, Scene
from tests.layout.made import table, thing

GOOD = 0.75  # share of valid candidates that is asked for


def _scene(width: float, depth: float, objects, relations) -> Scene:
    door = Door(id="door", wall=0, offset=width - 1.2, width=0.9, height=2.1)
    room = Room(outline=((0, 0), (width, 0), (width, depth), (0, depth)), height=2.7, doors=(door,))
    return Scene(id="rows", room=room, objects=tuple(objects), relations=tuple(relations))


def _solved(scene: Scene) -> sw.Solution:
    solution = sw.refine(scene, candidates=16, seed=4, device="cpu", snap=True)
    assert np.mean(solution.status == 0) >= GOOD
    for candidate in np.flatnonzero(solution.status == 0)[:4]:
        assert sw.check(solution.scene(int(candidate)), walkable=False).valid
    return solution


def _seen(scene: Scene, a: str, b: str) -> tuple[float, float, float]:
    """Where a stands as b sees it: ahead, left, turned."""
    (x, y, _), (u, v, _) = scene.object(a).pose.position, scene.object(b).pose.position
    yaw = scene.object(b).pose.yaw
    turned = (scene.object(a).pose.yaw - yaw + math.pi) % math.tau - math.pi
    c, s = math.cos(yaw), math.sin(yaw)
    return c * (x - u) + s * (y - v), c * (y - v) - s * (x - u), turned


def _next(subject: str, target: str, side: str, gap: float) -> Relation:
    span = [gap - 0.05, gap + 0.05]
    return Relation(type="next_to", subject=subject, target=target, params={"side": side, "gap": span})


def test_a_restaurant_in_rows():
    """Twelve tables of four in three rows: the grid hangs together and all chairs are in their places."""
    objects, relations = [], []
    for row in range(3):
        for column in range(4):
            name = f"t{row}{column}"
            objects.append(table(name, size=(0.8, 1.2, 0.75)))
            if column:
                relations.append(_next(name, f"t{row}{column - 1}", "left", 0.6))
            elif row:
                relations.append(_next(name, f"t{row - 1}0", "front", 1.9))
            for k in range(4):
                objects.append(thing(f"{name}c{k}", (0.45, 0.45, 0.7), category="chair"))
                params = {"side": ("front", "back")[k % 2], "k": k // 2, "n": 2}
                relations.append(Relation(type="seated_at", subject=f"{name}c{k}", target=name, params=params))
    solution = _solved(_scene(10.0, 10.0, objects, relations))
    best = solution.best
    for row in range(3):
        for column in range(1, 4):
            ahead, left, turned = _seen(best, f"t{row}{column}", f"t{row}{column - 1}")
            assert (ahead, left, turned) == pytest.approx((0.0, 1.8, 0.0), abs=2e-3)


def test_a_run_goes_around_a_corner():
    """Five pieces of 0.9 m cannot stand at one wall of 3.4 m; they end in a corner and go on behind it."""
    pieces = [thing(f"p{k}", (0.6, 0.9, 0.9)) for k in range(5)]
    relations = [Relation(type="against_wall", subject=p.id) for p in pieces]
    relations.append(Relation(type="in_corner", subject="p2"))
    for k in (3, 4):
        relations.append(Relation(type="run_on", subject=f"p{k}", target=f"p{k - 1}", params={"side": "right"}))
    for k in (1, 0):
        relations.append(Relation(type="run_on", subject=f"p{k}", target=f"p{k + 1}", params={"side": "left"}))
    solution = _solved(_scene(3.4, 3.4, pieces, relations))
    for candidate in np.flatnonzero(solution.status == 0):
        scene = solution.scene(int(candidate))
        turns = {round(math.degrees(_seen(scene, f"p{k}", "p2")[2]) / 90) % 4 for k in range(5)}
        assert len(turns) == 2, "at two walls"


def test_a_line_has_even_gaps():
    lockers = [thing(f"p{k}", (0.5, 0.6, 1.8)) for k in range(5)]
    relations = [Relation(type="against_wall", subject=p.id) for p in lockers]
    relations += [_next(f"p{k}", f"p{k - 1}", "right", 0.2) for k in range(1, 5)]
    solution = _solved(_scene(6.0, 4.0, lockers, relations))
    for k in range(1, 5):
        ahead, left, turned = _seen(solution.best, f"p{k}", f"p{k - 1}")
        assert (ahead, left, turned) == pytest.approx((0.0, -0.8, 0.0), abs=2e-3)


def test_a_thing_in_the_middle():
    solution = _solved(
        _scene(6.0, 4.0, [thing("box")], [Relation(type="in_middle", subject="box", params={"offset": 0.1})])
    )
    x, y, _ = solution.best.object("box").pose.position
    assert abs(x - 3.0) <= 0.101 and abs(y - 2.0) <= 0.101
