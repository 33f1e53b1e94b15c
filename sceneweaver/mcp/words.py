"""What the tools give back as text to read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.explain.words import plural

from .answers import DesignedScene, OpenedScene, SceneState
from .differences import SOFT, Difference, Moved
from .limits import MOST_LISTED


def faults(report: Mapping[str, Any], hard: bool, most: int) -> list[str]:
    """The violations of a report as sentences."""
    lines = [
        v["detail"] or f"{v['kind']}: {', '.join(v['objects'])}" for v in report["violations"] if v["hard"] is hard
    ]
    return [*lines[:most], *([f"and {len(lines) - most} more"] if len(lines) > most else [])]


def state_text(state: SceneState) -> str:
    """A scene after a call, in words."""
    lines = [f"{state.scene} version {state.version}: {state.change}; {'valid' if state.valid else 'NOT valid'}"]
    lines += [f"- wrong: {line}" for line in state.violations]
    lines += [f"- soft: {line}" for line in state.soft]
    lines += difference_lines(state.difference)
    lines += [f"- note: {line}" for line in state.notes]
    if isinstance(state, OpenedScene):
        lines += _opened_lines(state)
    if isinstance(state, DesignedScene):
        lines += [f"- asked for and not so: {line}" for line in state.unmet]
        lines += [f"- not done: {line}" for line in state.undone]
        lines += [model_words(state.model)] if state.model else []
        lines += [f"- the agent ended: {state.finished}", f"- files in: {state.folder}"]
    return "\n".join(lines)


def model_words(used: Mapping[str, Any]) -> str:
    """What a language model did, on one line."""
    usage = used["usage"]
    cost = f", {usage['cost']:.4g} {usage['currency']}" if usage.get("cost") is not None else ""
    lost = f"; not asked any more: {used['lost']}" if used["lost"] else ""
    tokens = usage["tokens_in"] + usage["tokens_out"]
    return f"- model {used['name']}: {plural(usage['calls'], 'call')}, {tokens} tokens{cost}{lost}"


def _opened_lines(state: OpenedScene) -> list[str]:
    room = state.room
    corners = ", ".join(f"({x:g}, {y:g})" for x, y in room.outline)
    lines = [f"{room.type}, {room.height:g} m high, corners {corners}"]
    for what, walls in (("door", room.doors), ("window", room.windows)):
        lines += [f"- {what} {name} in wall:{wall}" for name, wall in walls.items()]
    for thing in state.objects:
        x, y, z = thing.position
        size = " x ".join(f"{v:.2f}" for v in thing.size)
        on = f" on {thing.on}" if thing.on else ""
        lines.append(
            f"- {thing.id}: {thing.category} at ({x:.2f}, {y:.2f}, {z:.2f}), {thing.yaw:.0f} deg, {size} m{on}"
        )
    hard = [line for line in state.relations if not line.startswith(SOFT)]
    lines += [f"- {line}" for line in hard]
    return lines + [f"- and {len(state.relations) - len(hard)} soft relations, which are in the data"]


def difference_lines(found: Difference) -> list[str]:
    """What changed, a line each."""
    lines = [f"- added: {name}" for name in found.added] + [f"- removed: {name}" for name in found.removed]
    far = [move for move in found.moved if move_words(move)]
    lines += [f"- moved: {move_words(move)}" for move in far[:MOST_LISTED]]
    if len(far) < len(found.moved):
        lines.append(f"- moved by less than 5 mm: {len(found.moved) - len(far)}")
    for each in found.resized:
        sizes = (" x ".join(f"{v:.2f}" for v in size) for size in (each.before, each.after))
        lines.append(f"- resized: {each.id} from {' to '.join(sizes)} m")
    lines += [f"- changed: {name}" for name in found.changed]
    lines += [f"- now related: {line}" for line in found.related]
    lines += [f"- no longer related: {line}" for line in found.unrelated]
    return lines + (["- the room changed"] if found.room else [])


def move_words(move: Moved) -> str:
    """How far something went, in words; empty for less than 5 mm and half a degree."""
    words = [f"{move.distance:.2f} m"] if move.distance >= 0.005 else []
    words += [f"{abs(move.rise):.2f} m {'up' if move.rise > 0 else 'down'}"] if abs(move.rise) >= 0.005 else []
    words += [f"turned {move.turn:+.0f} deg"] if abs(move.turn) >= 0.5 else []
    return f"{move.id} {', '.join(words)}" if words else ""
