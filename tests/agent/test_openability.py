"""The touch after which doors and drawers open: other hand, turned about, left out; and nothing else gets worse."""

import math

import pytest

from sceneweaver.agent.executor import Outcome
from sceneweaver.agent.openability import _searched as searched
from sceneweaver.agent.openability import opened
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import Library
from sceneweaver.scene import Intent, Pose, Relation, Scene
from sceneweaver.scene.intent import Priority
from sceneweaver.tools.base import Proposal
from sceneweaver.verify import Violation, check, openable
from tests.verify.build import box, scene

WASHER = "parametric:washing_machine?seed=0"


class Judge:
    """What `opened` needs of an executor, without a request and its critic."""

    def judged(self, made: Scene) -> Outcome:
        return Outcome(made, check(made), None)  # type: ignore[arg-type]

    settings = Settings()
    library = Library()

    def run(self, made: Scene, proposal: Proposal, seed: int, rival: Outcome) -> Outcome:
        """A search that finds nothing."""
        assert proposal.edits and made is rival.scene
        return rival


def touched(made: Scene) -> tuple[Outcome, list[str]]:
    return opened(Judge().judged(made), Judge())  # type: ignore[arg-type]


def of_asset(asset: str, x: float, y: float, yaw: float = 0.0, **more) -> Scene:
    """An asset, without its zones, in an empty room of 8 by 8 m."""
    thing = Library().load(asset).object("piece", pose=Pose.from_yaw(x, y, 0.0, yaw))
    return scene([]).model_copy(update={"objects": (thing.model_copy(update={"zones": (), **more}),)})


def test_a_door_is_hung_at_the_other_side():
    made = of_asset(WASHER, 1.0, 4.0)
    w = made.objects[0].size[1]
    door = next(link for link in Library().load(WASHER).links if link.role == "door")
    side = math.copysign(1.0, door.anchor[1])
    tall = box("tall", (1.2, 0.3, 2.0), 1.3, 4.0 + side * (w / 2 + 0.16))
    made = made.model_copy(update={"objects": (*made.objects, *scene([tall]).objects)})
    assert not all(link.opens for link in openable.measure(made))
    after, notes = touched(made)
    assert after.report.valid and after.report.openable_share == 1.0 and not notes
    assert after.scene.object("piece").asset == f"{WASHER}&mirrored=1"


def test_what_faces_a_wall_turns_about():
    made = of_asset("parametric:dresser?seed=0", 8.0, 4.0)
    d = made.objects[0].size[0]
    made = made.replace_poses({"piece": Pose.from_yaw(8.0 - d / 2 - 0.01, 4.0, 0.0, 0.0)})
    assert not check(made, openable=True).valid
    after, _ = touched(made)
    assert after.report.valid and after.report.openable_share == 1.0
    assert abs(after.scene.object("piece").pose.frame.yaw) == pytest.approx(math.pi)


def blocked(priority: Priority) -> Scene:
    """A dresser in a niche of fixed blocks, one of them before it."""
    made = of_asset("parametric:dresser?seed=0", 4.0, 4.0)
    d, w, _ = made.objects[0].size
    blocks = [
        box("before", (0.3, 2.0, 1.5), 4.0 + d / 2 + 0.2, 4.0),
        box("behind", (0.3, 2.0, 1.5), 4.0 - d / 2 - 0.2, 4.0),
    ]
    rest = scene(blocks).objects
    meant = rest[0].model_copy(update={"intent": Intent(priority=priority)})
    wanted = made.objects[0].model_copy(update={"intent": Intent(priority="asked")})
    return made.model_copy(update={"objects": (wanted, meant, rest[1].model_copy(update={"fixed": True}))})


def test_what_is_optional_goes_out_of_the_way():
    after, notes = touched(blocked("optional"))
    assert after.report.valid and after.scene.ids == ("piece", "behind")
    assert notes and "before was left out" in notes[0]


def test_what_was_asked_for_stays_and_the_verdict_says_so():
    made = blocked("asked")
    after, notes = touched(made)
    assert not after.report.valid and after.scene is made and not notes
    assert {v.kind for v in after.report.violations} == {"blocked_link"} and after.report.openable_share == 0.0


@pytest.mark.parametrize(("gap", "row"), [((0.0, 0.05), "against_wall"), ((1.3, 1.8), "off_walls")])
def test_what_stands_off_its_wall_is_searched_for_off_all_of_them(gap, row):
    """A desk with its user between it and a wall was pushed back to that wall, where nothing opened either."""
    edits = []

    class Asked(Judge):
        def run(self, made, proposal, seed, rival):
            edits.extend(proposal.edits)
            return super().run(made, proposal, seed, rival)

    made = of_asset("parametric:dresser?seed=0", 4.0, 4.0)
    made = made.model_copy(
        update={"relations": (Relation(type="against_wall", subject="piece", hard=False, params={"gap": gap}),)}
    )
    blocked = Violation(kind="blocked_link", objects=("piece", "wall:0"), detail="a wall", amount=0.5)
    searched(Asked().judged(made), Asked(), [blocked])  # type: ignore[arg-type]
    assert [edit.relation.type for edit in edits] == [row]
