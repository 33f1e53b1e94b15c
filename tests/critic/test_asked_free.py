"""What became of free floor that a request states: met or not, with what was measured, wherever it came from."""

from __future__ import annotations

import pytest

from sceneweaver.critic.asked import alignment, measured
from sceneweaver.critic.model import ItemOutcome
from sceneweaver.critic.survey import Survey
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import FreeArea
from sceneweaver.scene import FreeArea as SceneArea
from sceneweaver.scene import Pose, Scene, SceneObject
from tests.critic.measuring import BED, CHAIR, ROOM, box, graph
from tests.critic.rooms import BEDROOM
from tests.reports import empty_report


def outcome(area: FreeArea, *objects: SceneObject, kept: tuple[SceneArea, ...] = ()) -> ItemOutcome:
    brief: SceneGraph = graph(objects, free_areas=(area,))
    scene = Scene(id="made", room=ROOM, objects=objects, free_areas=kept)
    return alignment(measured(Survey.of(scene, empty_report(), BEDROOM, brief))).of(area.id)


def asked(kind: str, width: float, *targets: str, **more: str) -> FreeArea:
    return FreeArea(id="free-0", kind=kind, size=(width, width), targets=targets, words="as asked", **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(("width", "status"), [(1.9, "met"), (2.4, "unmet")])
def test_a_clearance_is_met_or_not_with_its_number(width, status):
    bed, chair = box("bed", BED, 1.1, 2.5), box("chair", CHAIR, 4.5, 2.5)
    found = outcome(asked("clearance", width, "bed", side="front"), bed, chair)
    assert (found.status, found.kind) == (status, "free_area")
    assert found.measured == pytest.approx(4.25 - 2.1, abs=1e-6)
    assert found.allowed == (width, None)
    assert found.objects == ("bed",)


def test_a_circle_may_be_anywhere():
    found = outcome(asked("circle", 1.5), box("bed", BED, 1.1, 0.9))
    assert found.status == "met" and found.measured is not None and found.measured > 3.0
    crowd = [box(f"chair-{k}", CHAIR, 0.8 + 1.2 * (k % 5), 0.8 + 1.2 * (k // 5)) for k in range(20)]
    assert outcome(asked("circle", 1.5), *crowd).status == "unmet"


def test_what_a_scene_keeps_free_is_measured_where_it_lies():
    kept = SceneArea(id="k", kind="circle", size=(1.5, 1.5), pose=Pose.from_yaw(3.0, 2.5, 0.0, 0.0), request="free-0")
    chair = box("chair", CHAIR, 3.0 + 0.25 + 0.9, 2.5)
    assert outcome(asked("circle", 1.5), chair, kept=(kept,)).measured == pytest.approx(1.8)
    elsewhere = outcome(asked("circle", 1.5), box("chair", CHAIR, 3.0, 2.5), kept=(kept,))
    assert elsewhere.status == "met"  # it is free in another place, and no place was asked for


def test_a_gap_between_things_of_one_kind():
    beds = [box(f"bed-{k}", BED, 1.5, y) for k, y in enumerate((1.0, 3.4))]
    assert outcome(asked("gap", 0.8, "bed"), *beds).status == "met"
    assert outcome(asked("gap", 0.9, "bed"), *beds).status == "unmet"


def test_off_the_walls_and_ways():
    bed = box("bed", BED, 1.6, 2.5)
    assert outcome(asked("gap", 0.5, "bed", "wall"), bed).status == "met"
    assert outcome(asked("gap", 0.7, "bed", "wall"), bed).status == "unmet"
    assert outcome(asked("path", 1.0, "door", "bed"), bed).status == "met"


def test_what_is_not_there_is_not_understood():
    assert outcome(asked("clearance", 1.0, "zebra"), box("bed", BED, 1.1, 2.5)).status == "not_understood"
