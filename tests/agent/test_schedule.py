"""The time limit of a design is divided before it begins: what comes after the search is kept, and grows with it."""

from __future__ import annotations

import math
import time
from dataclasses import replace

import pytest

from sceneweaver.agent import Settings
from sceneweaver.agent.loop import Run
from sceneweaver.agent.planner import RulesPlanner
from sceneweaver.agent.schedule import EXPECTED, LEAST, MOST, STARTING, Schedule
from sceneweaver.export import FORMATS
from sceneweaver.knowledge import room_type
from sceneweaver.language import SceneGraph
from sceneweaver.runtime.deadline import Deadline, Stop

ALL = tuple(name for name in FORMATS if name != "usda")


def test_what_is_kept_grows_with_the_room_the_formats_and_the_machine():
    plan = Schedule(STARTING, 40, ("glb",))
    kept = plan.kept(120.0)
    assert kept > LEAST
    for more in (replace(plan, objects=200), replace(plan, formats=ALL), replace(plan, started=2 * STARTING)):
        assert more.kept(120.0) > kept
    assert replace(plan, pictures=False).kept(120.0) < kept
    assert replace(plan, pictures=False, formats=()).kept(120.0) >= LEAST


@pytest.mark.parametrize("limit", [1.0, 6.0, 30.0, 120.0])
@pytest.mark.parametrize("started", [0.0, 3.0, 40.0])
def test_the_search_has_its_share(limit, started):
    plan = Schedule(started, 400, ALL)
    assert 0.0 <= plan.kept(limit) <= MOST * max(0.0, limit - started)


def run(**options: object) -> Run:
    given = {"settings": Settings(**options), "tools": {}, "planner": RulesPlanner()}
    return Run(SceneGraph(text="a study"), room_type("study"), **given)


def test_a_run_keeps_time_for_judgement_files_and_pictures():
    limit = Deadline(time.monotonic() + 120.0)
    one = run(seconds=120.0)
    one.schedule = Schedule(STARTING, EXPECTED, ALL)
    one.divide(limit)
    kept = one.schedule.kept(120.0)
    assert one.deadline.margin == pytest.approx(kept)
    assert one.closing.moment - one.deadline.moment == pytest.approx(one.schedule.judgement)
    assert limit.moment - one.closing.moment >= one.schedule.files + one.schedule.drafts + one.schedule.page


def test_what_cut_a_run_off_says_how_much_was_kept():
    one = run(seconds=90.0)
    one.schedule = Schedule(STARTING, EXPECTED, ALL)
    one.divide(Deadline(time.monotonic() + 90.0))
    kept = one.deadline.margin
    assert one._cut() == f"90 seconds, {kept:.0f} of them kept for judgement, files and pictures" == one.cut_off


def test_a_stop_ends_a_run_without_a_limit_at_once():
    stop = Stop()
    one = run(seconds=None)
    one.schedule = Schedule(STARTING, EXPECTED, ALL)
    one.divide(Deadline(math.inf, stop=stop))
    assert not one.deadline.passed
    stop.request("SIGTERM")
    assert one.deadline.passed and one.closing.passed and not one.limit.passed
    assert one._cut() == "SIGTERM"
