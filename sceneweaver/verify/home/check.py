"""The judge of whole homes: one call that measures rooms, what joins them, and the ways through them."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, show
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.verify import walkable
from sceneweaver.verify.check import check, versions
from sceneweaver.verify.report import Report

from . import access as ways_through
from . import joints
from .floors import RADIUS
from .reports import HomeReport, HomeViolation, PlanVerdict

if TYPE_CHECKING:
    from sceneweaver.assets import Library


def check_home(
    home: Home,
    plan_report: PlanVerdict | None = None,
    *,
    robot_radius: float = RADIUS,
    physics: bool = False,
    openable: bool = False,
    library: Library | None = None,
) -> HomeReport:
    """Judge a home in float64, independently of what planned and furnished it.

    Every furnished room is judged by `sceneweaver.check`. Of the home itself: each scene has the room that the home
    says; floors of rooms do not overlap; doors and windows go straight through one wall; nothing reaches through a wall
    or stands in a doorway or in the way of a leaf; and from the entrance a round base gets through all doors, into
    every room and to all that is used, to other storeys by stairs.

    Args:
        home: what to judge; rooms without a scene count as empty.
        plan_report: the verdict on its plan, such as that of `sceneweaver.plans.check_plan`; None: the plan's rules
            are not part of the verdict.
        robot_radius: of the base [m], a disc; 0.01 to 5.
        physics, openable, library: as in `sceneweaver.check`, for each room.

    Returns:
        The reports of the rooms, how far the base gets, and everything that is wrong.

    Raises:
        InputError: a radius out of its range.

    Examples:
        >>> import sceneweaver as sw
        >>> report = sw.check_home(sw.Home.example("flat"))
        >>> report.valid, report.access.unreached_rooms
        (True, ())
    """
    least, most = walkable.RADII
    if not is_number(robot_radius) or not least <= robot_radius <= most:
        raise InputError(f"robot_radius is {show(robot_radius)}; give metres, {least:g} to {most:g}")
    began = last = time.perf_counter()
    seconds: dict[str, float] = {}

    def lap(name: str) -> None:
        nonlocal last
        checkpoint()
        now = time.perf_counter()
        seconds[name], last = now - last, now

    reports: dict[str, Report] = {}
    for room in home.rooms:
        if room.scene is not None:
            reports[room.id] = check(
                room.scene, robot_radius=robot_radius, physics=physics, openable=openable, library=library
            )
    lap("rooms")
    placed = ways_through.placed_rooms(home)
    found = [*_of_plan(plan_report), *_of_rooms(reports)]
    steps: tuple[Callable[[], Iterable[HomeViolation]], ...] = (
        lambda: joints.shells(home),
        lambda: joints.rooms(home),
        lambda: joints.openings(home),
        lambda: joints.through_walls(home, placed),
        lambda: joints.leaves(home, placed),
    )
    for step in steps:
        found += step()
    lap("joints")
    reach, missed = ways_through.measure(ways_through.Ways.of(home, placed, float(robot_radius)), float(robot_radius))
    found += missed
    lap("ways")
    warnings = [f"{name}: {text}" for name, report in reports.items() for text in report.warnings]
    valid = not found and all(report.valid for report in reports.values())
    laps = {"total": time.perf_counter() - began, **seconds}
    return HomeReport(valid, reports, reach, tuple(found), plan_report, laps, versions(), tuple(warnings))


def _of_plan(report: PlanVerdict | None) -> list[HomeViolation]:
    if report is None or report.valid:
        return []
    some = getattr(report, "violations", ())
    first = f": {some[0].detail}" if some else ""
    return [HomeViolation("plan", (), (), f"the plan breaks {len(some) or 'some'} hard rules{first}", float(len(some)))]


def _of_rooms(reports: dict[str, Report]) -> list[HomeViolation]:
    found = []
    for name, report in reports.items():
        faults = [violation for violation in report.violations if violation.hard]
        if not report.valid:
            first = f": {faults[0].detail}" if faults else ""
            detail = f"{name} is not valid, {len(faults)} faults{first}"
            found.append(HomeViolation("room", (name,), (), detail, float(len(faults))))
    return found
