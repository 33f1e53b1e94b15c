"""Whether what people see from their seats is measured in the finished scene."""

from __future__ import annotations

import pytest

from sceneweaver.language.model import View
from sceneweaver.scene import SceneObject
from tests.critic.measuring import CHAIR, aligned, box, graph

SCREEN = box("whiteboard-0", (0.1, 1.6, 1.2), 5.0, 2.5, 180)
CLOSET = box("wardrobe-0", (0.6, 1.4, 2.0), 3.5, 2.5)


def chair(yaw: float) -> SceneObject:
    return box("dining_chair-0", CHAIR, 2.0, 2.5, yaw)


def status(view: str, *objects: SceneObject) -> str:
    said = View(id="view-0", target="whiteboard", kind=view, words="so")  # type: ignore[arg-type]
    brief = graph(objects, views=(said.model_dump(),))
    return aligned(objects, brief).of("view-0").status


@pytest.mark.parametrize(
    ("view", "yaw", "expected"),
    [
        ("see", 80, "met"),
        ("see", 120, "unmet"),
        ("face", 30, "met"),
        ("face", 80, "unmet"),
        ("not_back_to", 110, "met"),
        ("not_back_to", 180, "unmet"),
        ("back_to", 180, "met"),
        ("back_to", 0, "unmet"),
    ],
)
def test_a_view_is_the_angle_from_the_front_of_the_seat(view: str, yaw: float, expected: str):
    assert status(view, chair(yaw), SCREEN) == expected


def test_nobody_sees_through_a_wardrobe():
    assert status("see", chair(0), SCREEN) == "met"
    assert status("see", chair(0), CLOSET, SCREEN) == "unmet"
