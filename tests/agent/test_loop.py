"""The loop: which steps it takes, what it keeps, when it stops. Planner, tools and executor are stand-ins."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import pytest

from sceneweaver.agent import loop
from sceneweaver.agent.design import _resume
from sceneweaver.agent.executor import Outcome
from sceneweaver.agent.folder import RunFolder
from sceneweaver.agent.loop import NOTHING_YET, Run, empty_scene
from sceneweaver.agent.memory import Call, Memory
from sceneweaver.agent.planner import Situation
from sceneweaver.agent.settings import Settings
from sceneweaver.critic import CRITERIA, Fault, Review, VisualReview
from sceneweaver.knowledge import room_type
from sceneweaver.language import SceneGraph
from sceneweaver.runtime.deadline import Deadline, Stop
from sceneweaver.scene import InputError, Pose, Scene, SceneObject
from sceneweaver.scene.edits import Add
from sceneweaver.tools.base import Context, Proposal
from sceneweaver.tools.card import own_card
from sceneweaver.tools.registry import Registered
from sceneweaver.verify import Report, check

ROOM = room_type("bedroom")
BRIEF = SceneGraph(text="a bedroom", room_type="bedroom")


@dataclass
class Tool:
    """Adds a box whose category says which grade the critic is to give."""

    name: str
    answers: list[Proposal | Exception | Callable[[], Proposal]] = field(default_factory=list)
    seen: list[Context] = field(default_factory=list)

    def propose(self, context: Context) -> Proposal:
        self.seen.append(context)
        answer = self.answers.pop(0)
        if callable(answer):
            answer = answer()
        if isinstance(answer, Exception):
            raise answer
        return answer


@dataclass
class Planner:
    """Gives out lists of calls in order, then none."""

    plans: list[list[Call]]
    seen: list[Situation] = field(default_factory=list)
    name: str = "scripted"

    def plan(self, situation: Situation) -> list[Call]:
        self.seen.append(situation)
        return self.plans.pop(0)[: situation.settings.side_by_side] if self.plans else []


class Executor:
    """Applies the first edit of a proposal; the grade of the outcome stands in what it adds."""

    def __init__(self, *_: Any, found: Callable[[Outcome], None]) -> None:
        self.attempts, self.found = 0, found

    def judged(self, scene: Scene, report: Report | None = None) -> Outcome:
        return Outcome(scene, report or check(scene), Review(grades=dict.fromkeys(CRITERIA, 0.0)))

    def run(self, scene: Scene, proposal: Proposal, seed: int, rival: Outcome | None = None) -> Outcome:
        self.attempts += 5
        (edit,) = proposal.edits
        assert isinstance(edit, Add)
        if any(o.id == edit.object.id for o in scene.objects):
            raise InputError(f"add '{edit.object.id}': it is there")
        after = scene.model_copy(update={"objects": (*scene.objects, edit.object)})
        grade = float(edit.object.category)
        faults = (Fault(criterion="layout", kind="k", reason="r", tool="add_objects"),) * (grade < 9.9)
        review = Review(grades=dict.fromkeys(CRITERIA, grade), faults=faults)
        made = Outcome(after, check(after), review, proposal.notes, proposal.unmet)
        self.found(made)
        if "endless" in proposal.notes:
            for_ever()
        return made


def for_ever() -> None:
    """What asks no deadline."""
    while True:
        time.sleep(0.01)


def adds(object_id: str, grade: float, at: float = 2.0, **said: Any) -> Proposal:
    """A box at (at, at) [m] that makes the scene worth a grade."""
    box = SceneObject(id=object_id, category=str(grade), size=(0.2, 0.2, 0.2), pose=Pose(position=(at, at, 0.0)))
    return Proposal(edits=(Add(object=box),), **said)


@pytest.fixture
def go(monkeypatch) -> Callable[..., tuple[Run, Outcome | None, Planner, dict[str, Tool]]]:
    """Run the loop on scripted answers of tools and scripted plans, one call of each tool a step unless given."""
    monkeypatch.setattr(loop, "Executor", Executor)

    def run(
        answers: dict[str, Sequence[Proposal | Exception]], plans: Sequence[Sequence[Call]], **more: Any
    ) -> tuple[Run, Outcome | None, Planner, dict[str, Tool]]:
        tools = {name: Tool(name, list(given)) for name, given in answers.items()}
        known = {name: Registered(own_card(name), lambda t=t: t, name) for name, t in tools.items()}
        planner = Planner([list(calls) for calls in plans])
        settings = more.pop("settings", Settings(device="cpu"))
        made = Run(BRIEF, ROOM, settings, known, planner, **more)
        return made, made.go(), planner, tools

    return run


BEGIN = [Call(tool="init_prior")]


def calls(*tools: str, **inputs: Any) -> list[Call]:
    return [Call(tool=name, inputs=inputs) for name in tools]


def test_what_is_better_is_kept_and_what_is_worse_is_rolled_back(go):
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 4, 1.0), adds("c", 6, 1.0)]}
    run, best, planner, _ = go(answers, [BEGIN, calls("add_objects", n=1), calls("add_objects", n=2)])
    assert best.scene.ids == ("a", "c") and best.review.total == 6
    assert [s.accepted for s in run.memory.steps] == [True, False, True]
    assert run.memory.steps[1].note == "no better than before" and run.memory.steps[1].after["layout"] == 5
    assert run.memory.failed == (Call(tool="add_objects", inputs={"n": 1}).signature,)
    assert [s.scene.ids if s.scene else None for s in planner.seen[:4]] == [None, ("a",), ("a",), ("a", "c")]
    assert run.memory.finished == "nothing is left that a tool can mend"


def test_a_violation_outweighs_every_grade(go):
    # The second box stands in the first one.
    answers = {"init_prior": [adds("a", 2)], "add_objects": [adds("b", 9.5)]}
    run, best, _, _ = go(answers, [BEGIN, calls("add_objects")])
    assert best.scene.ids == ("a",) and not run.memory.steps[1].accepted
    assert run.memory.steps[1].tried[0]["violations"] == 1


def test_of_calls_side_by_side_the_best_wins_and_the_others_are_not_blamed(go):
    answers = {
        "init_prior": [adds("a", 5)],
        "add_objects": [adds("b", 6, 0.5)],
        "add_crowd": [adds("c", 7, 1.0)],
        "add_tabletop": [InputError("supports: give ids")],
    }
    plan = calls("add_objects", "add_crowd", "add_tabletop")
    run, best, _, _ = go(answers, [BEGIN, plan], settings=Settings(device="cpu", side_by_side=3))
    assert best.scene.ids == ("a", "c")
    kept = run.memory.steps[1]
    assert kept.call == plan[1] and kept.accepted and kept.note == ""
    assert [row.get("failed") for row in kept.tried] == [None, None, "supports: give ids"]
    assert run.memory.failed == (plan[2].signature,)
    assert run.memory.confidence["add_tabletop"] < 1 == run.memory.confidence["add_crowd"]


def test_a_call_that_makes_nothing_better_is_blamed_where_another_of_its_step_does(go):
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 4, 0.5)], "add_crowd": [adds("c", 7, 1.0)]}
    plan = calls("add_objects", "add_crowd")
    run, best, _, _ = go(answers, [BEGIN, plan])
    assert best.scene.ids == ("a", "c") and run.memory.steps[1].accepted
    assert run.memory.failed == (plan[0].signature,) and run.memory.confidence["add_objects"] < 1


def test_a_call_is_told_what_it_has_to_beat(go, monkeypatch):
    rivals: list[tuple[str, ...] | None] = []

    class Watched(Executor):
        def run(self, scene: Scene, proposal: Proposal, seed: int, rival: Outcome | None = None) -> Outcome:
            rivals.append(None if rival is None else rival.scene.ids)
            return super().run(scene, proposal, seed, rival)

    monkeypatch.setattr(loop, "Executor", Watched)
    answers = {
        "init_prior": [adds("a", 5)],
        "add_objects": [adds("b", 6, 0.5), adds("d", 6, 1.5)],
        "add_crowd": [adds("c", 5.5, 1.0)],
    }
    plans = [BEGIN, calls("add_objects", "add_crowd"), calls("add_objects", n=2)]
    go(dict(answers), plans)
    assert rivals == [None, ("a",), ("a", "b"), ("a", "b")]
    rivals.clear()
    go(dict(answers), plans, settings=Settings(device="cpu", one_shot=True))
    assert set(rivals) == {None}


@pytest.mark.parametrize(("grade", "drawn"), [(loop.GOOD["functionality"], 1), (loop.GOOD["functionality"] - 0.1, 2)])
def test_a_room_is_drawn_again_unless_the_first_is_good(go, grade, drawn):
    answers = {"init_prior": [adds("a", 10 * grade), adds("b", 10 * grade)]}
    run, *_ = go(answers, [calls("init_prior", "init_prior")])
    assert len(run.memory.steps[0].tried) == drawn


def test_a_call_that_changes_nothing_is_not_carried_out(go):
    answers = {"init_prior": [adds("a", 5)], "add_crowd": [Proposal(unmet=("the shelf is full",))]}
    run, best, _, _ = go(answers, [BEGIN, calls("add_crowd")])
    assert best.scene.ids == ("a",)
    assert run.memory.steps[1].tried[0]["failed"] == run.memory.steps[1].note == "nothing to change: the shelf is full"


def test_tools_see_the_scene_the_call_and_the_request(go):
    first = Call(tool="add_objects", inputs={"objects": []}, instruction="put a lamp", seed=77)
    _, best, _, tools = go({"init_prior": [adds("a", 5)], "add_objects": [adds("b", 6, 1.0)]}, [BEGIN, [first]])
    begun, context = tools["init_prior"].seen[0], tools["add_objects"].seen[0]
    assert begun.scene == empty_scene(BRIEF, ROOM)
    assert (context.scene.ids, context.seed, context.instruction) == (("a",), 77, "put a lamp")
    assert context.inputs == {"objects": []} and context.brief is BRIEF and context.room_type is ROOM
    assert best.scene.ids == ("a", "b")


def test_only_what_an_initialiser_could_not_do_is_unmet(go):
    answers = {
        "init_prior": [adds("a", 5, notes=("n",), unmet=("no bed",))],
        "add_objects": [adds("b", 6, 1.0, notes=("m",), unmet=("no lamp",))],
        "add_crowd": [adds("c", 1, 0.5, notes=("rolled back",))],
    }
    run, _, _, _ = go(answers, [BEGIN, calls("add_objects"), calls("add_crowd")])
    assert run.memory.unmet == ("no bed",) and run.memory.notes == ("n", "m", "no lamp")


@pytest.mark.parametrize(
    ("settings", "grades", "steps", "reason"),
    [
        ({"steps": 2}, [5, 6, 7], 2, "2 steps"),
        ({"patience": 2}, [5, 4, 4, 8], 3, "no progress in 2 steps"),
        ({"patience": 1}, [5, 6, 4, 8], 3, "no progress in 1 steps"),
        ({"to_gain": 0.05}, [9, 10], 2, "grade 10.0"),
        # there are faults that a tool can mend
        ({"to_gain": 4.0}, [5, 7, 8], 3, "nothing is left that a tool can mend"),
        ({"work": 5}, [5, 6], 1, "5 attempts"),
        ({"work": 6}, [5, 6, 7], 2, "6 attempts"),
    ],
)
def test_when_it_stops(go, settings, grades, steps, reason):
    boxes = [adds(f"b{k}", grade, 0.5 + 0.5 * k) for k, grade in enumerate(grades)]
    plans = [BEGIN, *([calls("add_objects", k=k) for k in range(1, len(grades))])]
    run, _, _, _ = go(
        {"init_prior": boxes[:1], "add_objects": boxes[1:]}, plans, settings=Settings(device="cpu", **settings)
    )
    assert len(run.memory.steps) == steps and run.memory.finished == reason
    assert run.memory.spent is bool(settings.keys() & {"steps", "work"})


def late(proposal: Proposal) -> Callable[[], Proposal]:
    """An answer for which the deadline of `SOON` is over, but not the grace after it."""

    def answer() -> Proposal:
        time.sleep(0.3)
        return proposal

    return answer


def soon(**more: Any) -> dict[str, Any]:
    """A deadline that comes in a fifth of a second."""
    return {"settings": Settings(device="cpu", seconds=3.0, **more), "deadline": Deadline(time.monotonic() + 0.2)}


def test_a_step_that_ends_soon_after_the_deadline_counts(go):
    boxes = [adds(f"b{k}", 5 + k, 0.5 + 0.5 * k) for k in range(2)]
    plans = [calls("init_prior", "add_objects"), calls("add_objects")]
    run, best, _, _ = go({"init_prior": [late(boxes[0])], "add_objects": boxes[1:]}, plans, **soon(side_by_side=2))
    assert best.scene.ids == ("b0",) and run.memory.finished == run.cut_off == "3 seconds"
    assert len(run.memory.steps) == 1 and len(run.memory.steps[0].tried) == 1
    assert not run.memory.failed  # what there was no time for is not held against its tool


def test_when_the_first_tool_takes_too_long_there_is_the_empty_room_that_was_asked_for(go, tmp_path):
    folder, began = RunFolder(tmp_path), time.monotonic()
    with folder.held():
        run, best, _, _ = go({"init_prior": [for_ever]}, [BEGIN], folder=folder, **soon())
    assert time.monotonic() - began < 3.0
    assert not best.scene.objects and best.scene.room.doors and best.report.valid
    assert run.unmet == (NOTHING_YET,) and run.memory.spent and run.cut_off == "3 seconds"
    assert Scene.load(tmp_path / "scene.json").room == best.scene.room
    assert json.loads((tmp_path / "metrics.json").read_text("utf-8"))["cut_off"]
    assert folder.resume(BRIEF, run.settings) is None  # the step does not count: a larger limit begins anew


def test_when_the_first_step_takes_too_long_there_is_its_best_layout_so_far(go, tmp_path):
    folder = RunFolder(tmp_path)
    colliding = adds("a", 5, notes=("endless",), unmet=("a sofa",))
    with folder.held():
        run, best, _, _ = go({"init_prior": [colliding]}, [BEGIN], folder=folder, **soon())
    assert best.scene.ids == ("a",) and run.unmet == ("a sofa",) and not run.memory.steps
    assert Scene.load(tmp_path / "scene.json") == best.scene


def test_a_later_step_that_takes_too_long_leaves_what_there_was(go, tmp_path):
    folder = RunFolder(tmp_path)
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 9, 1.0, notes=("endless",))]}
    with folder.held():
        run, best, _, _ = go(answers, [BEGIN, calls("add_objects")], folder=folder, **soon())
    assert best.scene.ids == ("a",) and len(run.memory.steps) == 1 and run.cut_off == "3 seconds"
    kept = folder.resume(BRIEF, run.settings)
    assert kept is not None and kept[1] == best.scene and kept[0].spent


def test_a_stop_ends_it_as_a_deadline_does(go):
    stop = Stop(allowance=0.0)
    ask = threading.Timer(0.2, stop.request, ("SIGTERM",))
    ask.start()
    answers = {"init_prior": [adds("a", 5)], "add_objects": [for_ever]}
    run, best, _, _ = go(answers, [BEGIN, calls("add_objects")], deadline=Deadline(stop=stop))
    ask.join()
    assert best.scene.ids == ("a",) and run.cut_off == run.memory.finished == "SIGTERM" and run.memory.spent


def test_what_is_wrong_in_the_last_layout_is_taken_out(go, tmp_path):
    folder, settings = RunFolder(tmp_path), Settings(device="cpu", reflect=False)
    answers = {"init_prior": [adds("a", 5)], "add_tabletop": [adds("b", 9)]}  # in one place
    with folder.held():
        run, best, _, _ = go(answers, [], folder=folder, settings=settings)
    assert len(best.scene.objects) == 1 and best.report.valid and not run.cut_off
    assert run.notes == (f"{'a' if best.scene.ids == ('b',) else 'b'} was left out: the room has no place for it",)
    assert Scene.load(tmp_path / "scene.json") == best.scene
    assert len(run.best.scene.objects) == 2  # what a run that goes on begins with is as it was


def test_without_a_first_scene_it_says_why(go):
    with pytest.raises(InputError, match="prompt: the floor is too small"):
        go({"init_prior": [InputError("the floor is too small")]}, [BEGIN])
    with pytest.raises(InputError, match="prompt: no tool can begin"):
        go({}, [])


def test_it_begins_again_when_the_first_scene_fails(go):
    run, best, planner, _ = go({"init_prior": [InputError("no"), adds("a", 5)]}, [BEGIN, BEGIN])
    assert best.scene.ids == ("a",) and [s.accepted for s in run.memory.steps] == [False, True]
    assert planner.seen[1].scene is None and planner.seen[1].memory.stale == 1


def test_a_fixed_plan_keeps_all_it_does_and_asks_no_planner(go):
    answers = {
        "init_prior": [adds("a", 5)],
        "add_tabletop": [adds("b", 1, 1.0)],
        "update_layout": [adds("a", 9)],  # fails: it is there
    }
    run, best, planner, _ = go(answers, [], settings=Settings(device="cpu", reflect=False))
    assert best.scene.ids == ("a", "b") and not planner.seen
    assert [s.call.tool for s in run.memory.steps] == ["init_prior", "add_tabletop", "update_layout"]
    assert [s.accepted for s in run.memory.steps] == [True, True, False] and not run.memory.failed


def test_a_plan_made_once_is_followed_whatever_comes_of_it(go):
    answers = {
        "init_prior": [adds("a", 8)],
        "add_objects": [adds("b", 3, 1.0)],
        "add_crowd": [adds("c", 2, 1.5)],
    }
    plan = [*calls("add_objects", "add_crowd"), *calls("add_objects", one=1)]
    run, best, planner, _ = go(answers, [BEGIN, plan], settings=Settings(device="cpu", one_shot=True))
    assert best.scene.ids == ("a", "b", "c") and len(planner.seen) == 2
    assert run.memory.plan == tuple(plan[:2])  # of a tool that takes lists the call for all faults is enough


def test_a_finished_run_is_not_taken_up_again(go, monkeypatch):
    scene = empty_scene(BRIEF, ROOM)
    kept = Outcome(scene, check(scene), Review(grades=dict.fromkeys(CRITERIA, 4.0)))
    run, best, planner, _ = go({}, [BEGIN], memory=Memory(finished="3 steps"), best=kept)
    assert best is kept and not planner.seen and run.memory.finished == "3 steps"


@pytest.mark.parametrize(("limits", "goes_on"), [({"steps": 2}, True), ({"patience": 1}, False)])
def test_a_larger_budget_goes_on_and_a_run_without_progress_does_not(go, tmp_path, limits, goes_on):
    folder, settings = RunFolder(tmp_path), Settings(device="cpu", **limits)
    assert folder.resume(BRIEF, settings) is None
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 4, 1.0)]}
    with folder.held():
        before, _, _, _ = go(answers, [BEGIN, calls("add_objects")], folder=folder, settings=settings)
    assert before.memory.spent is goes_on
    larger = Run(BRIEF, ROOM, Settings(device="cpu", **{**limits, "steps": 9}), {}, Planner([]), folder=folder)
    _resume(larger, RunFolder(tmp_path))
    assert larger.memory.steps == before.memory.steps and larger.best is not None
    assert bool(larger.memory.finished) is not goes_on and not larger.memory.spent


def test_every_step_is_told_and_written(go, tmp_path):
    told: list[int] = []
    folder = RunFolder(tmp_path)
    settings = Settings(device="cpu")
    assert folder.resume(BRIEF, settings) is None
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 4, 1.0)]}
    with folder.held():
        run, best, _, _ = go(
            answers,
            [BEGIN, calls("add_objects")],
            folder=folder,
            settings=settings,
            said=lambda step: told.append(step.number),
        )
    assert told == [1, 2]
    assert Scene.load(tmp_path / "steps" / "02" / "scene.json") == best.scene
    state = json.loads((tmp_path / "state.json").read_text("utf-8"))
    assert Memory.model_validate(state["memory"]) == run.memory and state["memory"]["finished"]
    kept = RunFolder(tmp_path).resume(BRIEF, settings)
    assert kept == (run.memory, best.scene)


def test_the_empty_scene_is_a_square_of_the_usual_size():
    scene = empty_scene(BRIEF, ROOM)
    width = scene.room.outline[2][0]
    assert width**2 == pytest.approx(ROOM.area[1], rel=0.01) and scene.room.height == ROOM.height
    assert scene.prompt == "a bedroom" and not scene.objects


def test_a_tool_that_breaks_down_costs_its_step_alone(go):
    answers = {"init_prior": [adds("a", 5)], "add_objects": [ZeroDivisionError("no size"), adds("b", 6, 1.0)]}
    plans = [BEGIN, calls("add_objects"), calls("add_objects", again=1)]
    with pytest.warns(RuntimeWarning, match="add_objects: unexpected ZeroDivisionError: no size"):
        run, best, _, _ = go(answers, plans)
    assert best.scene.ids == ("a", "b") and [s.accepted for s in run.memory.steps] == [True, False, True]
    assert len(run.undone) == 1 and run.memory.failed


def test_when_the_first_tool_breaks_down_there_is_the_empty_room(go):
    with pytest.warns(RuntimeWarning, match="unexpected"):
        run, best, _, _ = go({"init_prior": [KeyError("x")]}, [BEGIN])
    assert not best.scene.objects and best.report.valid and run.undone and not run.cut_off


def test_what_is_worse_by_measure_is_not_even_looked_at(go):
    def look(outcome: Outcome) -> Outcome:
        seen.append(outcome.scene.ids)
        return outcome

    seen: list[tuple[str, ...]] = []
    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", 4, 1.0), adds("c", 6, 1.0)]}
    _, best, *_ = go(answers, [BEGIN, calls("add_objects", n=1), calls("add_objects", n=2)], look=look)
    assert seen == [("a",), ("a", "c")] and best.scene.ids == ("a", "c")


@pytest.mark.parametrize(
    ("before", "after", "grade", "kept"),
    [(6.0, 6.5, 4.9, True), (6.0, 6.2, 4.9, False), (6.0, 9.0, 4.5, False), (6.0, 5.0, 5.3, False)],
)
def test_sight_decides_between_what_is_about_as_good_by_measure(go, before, after, grade, kept):
    def look(outcome: Outcome) -> Outcome:
        grades = dict.fromkeys(CRITERIA, after if "b" in outcome.scene.ids else before)
        seen = VisualReview(model="m", samples=1, grades=grades)
        return replace(outcome, review=outcome.review.model_copy(update={"seen": seen}))

    answers = {"init_prior": [adds("a", 5)], "add_objects": [adds("b", grade, 1.0)]}
    run, best, *_ = go(answers, [BEGIN, calls("add_objects")], look=look)
    assert ("b" in best.scene.ids) == kept == run.memory.steps[1].accepted
    assert bool(run.memory.failed) != kept
    assert ("by vision" in run.memory.steps[1].note) == (kept or grade > 5)
