"""What the tools for homes give back as text to read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .answers_homes import CheckedHome, DesignedHome, FurnishedHomeState, HomeRoomFacts, HomeState, PlannedHome
from .limits import MOST_LISTED


def home_faults(report: Mapping[str, Any], most: int = MOST_LISTED) -> list[str]:
    """What is wrong with a home as sentences: the rules of its plan each for itself, then everything else."""
    plan = report.get("plan", {}).get("violations", [])
    lines = [f"{v['rule']}: {v['detail']}" for v in plan]
    lines += [v["detail"] for v in report["violations"] if v["kind"] != "plan" or not plan]
    return [*lines[:most], *([f"and {len(lines) - most} more"] if len(lines) > most else [])]


def soft_rules(report: Mapping[str, Any]) -> list[str]:
    """Soft rules of the plan that are not kept, as sentences."""
    return [f"{v['rule']}: {v['detail']}" for v in report.get("plan", {}).get("soft", [])][:MOST_LISTED]


def home_text(state: HomeState) -> str:
    """A home after a call, in words."""
    lines = [f"{state.home} version {state.version}: {state.change}; {'valid' if state.valid else 'NOT valid'}"]
    lines += [f"- wrong: {line}" for line in state.violations] + [f"- soft: {line}" for line in state.soft]
    lines += [_room_line(room) for room in state.rooms]
    lines += [f"- not reached: {name}" for name in state.unreached]
    if isinstance(state, PlannedHome):
        lines.append(f"- {state.found} valid plans; the best of {len(state.options)} kinds are versions:")
        for option in state.options:
            soft = f", not kept: {', '.join(option.soft)}" if option.soft else ""
            lines.append(f"  version {option.version}: {option.area:.1f} m2, cost {option.cost:.3f}{soft}")
    if isinstance(state, FurnishedHomeState):
        for one in state.furnished:
            lines.append(f"- furnished {one.room}: " + (one.failed or f"grade {one.grade:.1f}, {one.request}"))
            lines += [f"  asked for and not so: {line}" for line in one.unmet]
    lines += [f"- note: {line}" for line in state.notes]
    if isinstance(state, DesignedHome):
        lines += [f"- asked for and not so: {line}" for line in state.unmet]
        lines += [f"- not done: {line}" for line in state.undone]
        lines += [f"- files in: {state.folder}"]
    return "\n".join(lines)


def checked_text(found: CheckedHome) -> str:
    """The judge on a home, in words."""
    lines = [f"{found.home} version {found.version}: {'valid' if found.valid else 'NOT valid'}"]
    lines += [f"- wrong: {line}" for line in found.violations] + [f"- soft: {line}" for line in found.soft]
    came = f"by {found.entrance}" if found.entrance else "by no door"
    lines.append(
        f"- from outside {came}: {found.walkable_share:.0%} of the floor, {found.reachable_share:.0%} of what is used"
    )
    return "\n".join(lines)


def _room_line(room: HomeRoomFacts) -> str:
    words = "empty" if room.objects is None else f"{room.objects} objects"
    to = f", to {', '.join(room.leads_to)}" if room.leads_to else ""
    return f"- {room.id}: {room.type}, {room.storey}, {room.area:.1f} m2, {words}{to}"
