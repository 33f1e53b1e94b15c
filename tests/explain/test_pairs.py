"""Proofs that one or two bodies do not fit into a room: never where a placement is known."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from shapely import affinity

import sceneweaver as sw
from sceneweaver.explain import certificate
from sceneweaver.explain.pairs import Body, fit_together, fits
from sceneweaver.scene import Part


def body(depth, width):
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (depth / 2, width / 2)
    return Body(corners, corners)


def planes(width, depth):
    return np.array([(1, 0, 0), (-1, 0, -width), (0, 1, 0), (0, -1, -depth)], dtype=float)


@pytest.mark.parametrize(
    ("a", "b", "room", "together"),
    [
        ((1, 1), (1, 1), (2.05, 1.02), True),
        ((1, 1), (1, 1), (1.93, 1.02), False),
        ((2.0, 0.5), (2.0, 0.5), (2.01, 1.01), True),
        ((2.0, 0.5), (2.0, 0.5), (2.01, 0.94), False),
        ((1.9, 1.7), (0.6, 3.5), (3.6, 2.2), False),
        ((1.9, 1.7), (0.6, 3.5), (3.6, 2.35), True),
    ],
)
def test_two_boxes_in_a_rectangle(a, b, room, together):
    assert fit_together(body(*a), body(*b), planes(*room)) is together
    assert fit_together(body(*b), body(*a), planes(*room)) is together
    tall = planes(*room[::-1])
    assert fit_together(body(*a), body(*b), tall) is together


def test_a_box_that_fits_on_the_diagonal_alone():
    assert fits(body(0.1, 4.7), planes(4.0, 3.0)) and not fits(body(0.1, 5.1), planes(4.0, 3.0))
    assert not fits(body(0.8, 4.7), planes(4.0, 3.0))


def test_what_random_placements_show_is_never_denied():
    rng, known = np.random.default_rng(0), 0
    for _ in range(200):
        width, depth = rng.uniform(1.5, 4.0, size=2)
        floor, placed, bodies = shapely.box(0, 0, width, depth), [], []
        for _ in range(2):
            size = rng.uniform(0.3, 2.5, size=2)
            box = affinity.rotate(shapely.box(*-size / 2, *size / 2), rng.uniform(0, 360), origin=(0, 0))
            x0, y0, x1, y1 = box.bounds
            if x1 - x0 > width or y1 - y0 > depth:
                break
            box = affinity.translate(box, rng.uniform(-x0, width - x1), rng.uniform(-y0, depth - y1))
            placed.append(box)
            bodies.append(body(*size))
        if len(placed) == 2 and not placed[0].intersects(placed[1]) and floor.buffer(1e-9).contains(placed[0]):
            known += 1
            assert fits(bodies[0], planes(width, depth)) and fit_together(*bodies, planes(width, depth))
        if known >= 10:
            break
    assert known >= 10, "else the test says little"


def scene_of(*sizes, outline=((0, 0), (3.6, 0), (3.6, 2.2), (0, 2.2))):
    objects = tuple(sw.SceneObject(id=f"o{k}", category="box", size=size) for k, size in enumerate(sizes))
    return sw.Scene(id="s", room=sw.Room(outline=outline), objects=objects)


def proof(scene):
    return certificate(scene, sw.refine(scene, candidates=4, device="cpu", explain=False), device="cpu")


def test_certificates_name_who_and_why():
    text = proof(scene_of((1.9, 1.7, 0.5), (0.6, 3.5, 2.0), (0.3, 0.3, 0.3)))
    assert text and "o0" in text and "o1" in text and "beside each other" in text and "o2" not in text


def test_no_certificate_without_a_proof():
    assert proof(scene_of((1.9, 1.6, 0.5), (0.6, 2.0, 2.0))) is None, "a valid layout is there"
    three = scene_of(
        (1.0, 1.2, 0.5), (1.0, 1.2, 0.5), (1.0, 1.2, 0.5), outline=((0, 0), (2.3, 0), (2.3, 1.9), (0, 1.9))
    )
    assert proof(three) is None, "by pairs it could be, and its floor is large enough"


def test_a_low_table_under_a_high_board_is_no_pair():
    low = Part(polygon=((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)), z=(0.0, 0.4))
    high = Part(polygon=((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)), z=(0.5, 0.6))
    leg = Part(polygon=((-0.9, -0.9), (-0.88, -0.9), (-0.88, 0.9), (-0.9, 0.9)), z=(0.0, 0.5))
    a = sw.SceneObject(id="low", category="box", size=(1.8, 1.8, 0.4), parts=(low,))
    b = sw.SceneObject(id="high", category="table", size=(1.8, 1.8, 0.6), parts=(high, leg))
    room = sw.Room(outline=((0, 0), (2.2, 0), (2.2, 2.2), (0, 2.2)))
    assert proof(sw.Scene(id="s", room=room, objects=(a, b))) is None
