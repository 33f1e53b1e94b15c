"""What each has for its own counts as met only at it: one to one, within reach, on the side that people mean."""

from __future__ import annotations

import pytest

from sceneweaver.scene import Part, SceneObject
from sceneweaver.verify.stated import worktop
from tests.critic.measuring import CHAIR, TABLE, box, graph, holds, relation, survey

WHEEL, STOOL, DESK = (0.65, 0.6, 0.63), (0.35, 0.35, 0.45), (0.7, 1.4, 0.75)


def wheels(*gaps: float) -> list[SceneObject]:
    """Wheels in a row that look along x, each with a stool so far [m] before its front."""
    found = []
    for k, gap in enumerate(gaps):
        found.append(box(f"pottery_wheel-{k}", WHEEL, 1.5, 1.0 + 1.4 * k))
        found.append(box(f"stool-{k}", STOOL, 1.5 + (WHEEL[0] + STOOL[0]) / 2 + gap, 1.0 + 1.4 * k, 180.0))
    return found


@pytest.mark.parametrize(("gaps", "status"), [((0.1, 0.2), "assumed"), ((0.1, 1.1), "unmet")])
def test_each_stool_is_within_reach_of_its_wheel(gaps: tuple[float, ...], status: str) -> None:
    told = {"type": "near", "subject": "stool", "targets": ("pottery_wheel",), "each": True, "implied": True}
    assert relation(*wheels(*gaps), **told).status == status


def test_two_stools_at_one_wheel_leave_the_other_without():
    told = {"type": "near", "subject": "stool", "targets": ("pottery_wheel",), "each": True, "implied": True}
    both = [
        one.model_copy(update={"pose": box("x-0", STOOL, 2.1, 1.0 + 0.1 * k).pose}) if "stool" in one.id else one
        for k, one in enumerate(wheels(0.1, 0.1))
    ]
    assert relation(*both, **told).status == "unmet"


@pytest.mark.parametrize(("x", "yaw", "met"), [(2.85, 180.0, True), (1.15, 0.0, False), (2.85, 0.0, False)])
def test_behind_a_desk_is_where_its_owner_sits(x: float, yaw: float, met: bool) -> None:
    desk, chair = box("desk-0", DESK, 2.0, 2.5), box("chair-0", CHAIR, x - 0.1, 2.5, yaw)
    assert holds(desk, chair, type="behind", subject="chair", targets=("desk",)) == met


@pytest.mark.parametrize(("x", "yaw", "met"), [(1.0, 0.0, True), (2.9, 180.0, False), (1.0, 180.0, False)])
def test_visitors_are_across_a_desk_and_look_at_it(x: float, yaw: float, met: bool) -> None:
    desk = box("desk-0", DESK, 2.0, 2.5)
    visitors = [box(f"chair-{k}", CHAIR, x, 2.15 + 0.7 * k, yaw) for k in range(2)]
    assert holds(desk, *visitors, type="in_front_of", subject="chair", targets=("desk",)) == met


def test_a_mirror_of_each_chair_is_before_it():
    def row(yaw: float) -> list[SceneObject]:
        chairs = [box(f"barber_chair-{k}", (1.0, 0.7, 1.1), 1.6, 1.2 + 1.5 * k, yaw) for k in range(2)]
        return chairs + [
            box(f"wall_mirror-{k}", (0.03, 0.8, 1.0), 0.015, 1.2 + 1.5 * k, z=1.0, mount="wall") for k in range(2)
        ]

    told = {"type": "above", "subject": "wall_mirror", "targets": ("barber_chair",), "each": True, "implied": True}
    assert relation(*row(180.0), **told).status == "assumed"
    assert relation(*row(0.0), **told).status == "unmet"


def test_a_table_without_surfaces_is_as_high_as_its_largest_part():
    def prism(depth: float, width: float, z: tuple[float, float]) -> Part:
        a, b = depth / 2, width / 2
        return Part(polygon=((-a, -b), (a, -b), (a, b), (-a, b)), z=z)

    table = box("dining_table-0", (TABLE[0], TABLE[1], 1.0), 3.0, 2.5)
    table = table.model_copy(update={"parts": (prism(0.2, 0.4, (0.75, 1.0)), prism(0.9, 1.8, (0.7, 0.75)))})
    seen = survey((table,), graph((table,)))
    assert worktop(seen.bodies[0]) == pytest.approx(0.75)
