"""What the tables and lists of a home's page say, from the home and its metrics."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.home import Home, HomeDoor, HomeRoom

from ..facts import KINDS, SOFT, ViolationRow, faults_of
from .data import HomePage

_MEASURES = {"circulation_share": "Share of halls and corridors"}
_ACCESS = (
    ("walkable_share", "Floor that a base can stand on", "%"),
    ("reachable_share", "Needed things within reach", "%"),
)


@dataclass(frozen=True)
class RoomRow:
    """A room as the page tells of it; ``verdict`` is a tone and words, ``faults`` are what is wrong in it."""

    id: str
    title: str
    storey: str
    area: float
    sides: tuple[float, float]
    objects: int | None
    verdict: tuple[str, str]
    grade: float | None
    faults: tuple[ViolationRow, ...]
    wishes: tuple[ViolationRow, ...]
    doors: tuple[str, ...]
    glazing: float
    request: str
    lacking: tuple[str, ...]
    outdoor: bool


def room_titles(home: Home) -> dict[str, str]:
    """What each room is called: its kind, with a number where there are several."""
    kinds, seen, titles = Counter(room.type for room in home.rooms), Counter[str](), {}
    for room in home.rooms:
        seen[room.type] += 1
        words = " ".join(room.type.replace("_", " ").replace("-", " ").split()) or room.id
        several = kinds[room.type] > 1 and room.type != "stairs"
        titles[room.id] = (words[:1].upper() + words[1:]) + (f" {seen[room.type]}" if several else "")
    return titles


def room_rows(page: HomePage, titles: Mapping[str, str]) -> list[RoomRow]:
    """A row for each room, in the order of the home."""
    return [_row(page, room, titles) for room in page.home.rooms]


def _row(page: HomePage, room: HomeRoom, titles: Mapping[str, str]) -> RoomRow:
    home = page.home
    checked = (page.metrics.get("rooms") or {}).get(room.id) or {}
    design = page.metrics.get("design") or {}
    faults = faults_of(checked)
    xs, ys = zip(*room.outline, strict=True)
    area = signed_area(room.outline)
    glass = sum(w.width * w.height for w in home.windows if w.room == room.id)
    return RoomRow(
        room.id,
        titles[room.id],
        room.storey,
        area,
        (max(xs) - min(xs), max(ys) - min(ys)),
        None if room.scene is None else len(room.scene.objects),
        _verdict(room, checked),
        (design.get("grades") or {}).get(room.id),
        tuple(fault for fault in faults if fault.kind not in SOFT),
        tuple(fault for fault in faults if fault.kind in SOFT),
        tuple(_door(door, room.id, titles) for door in home.doors_of(room.id)),
        glass / area if area > 0 else 0.0,
        str((design.get("requests") or {}).get(room.id) or ""),
        tuple(map(str, (design.get("lacking") or {}).get(room.id) or ())),
        room.outdoor,
    )


def _verdict(room: HomeRoom, checked: Mapping[str, Any]) -> tuple[str, str]:
    if isinstance(checked.get("valid"), bool):
        return ("good", "valid") if checked["valid"] else ("bad", "not valid")
    return ("unknown", "not furnished" if room.scene is None else "not checked")


def _door(door: HomeDoor, room: str, titles: Mapping[str, str]) -> str:
    other = door.to if door.room == room else door.room
    kind = {"hinged": "door", "double": "double door", "sliding": "sliding door", "open": "passage"}[door.kind]
    return f"{kind} of {door.width:.2f} m to " + (titles[other].lower() if other is not None else "the outside")


def plan_rows(metrics: Mapping[str, Any], titles: Mapping[str, str]) -> list[tuple[str, str, str, str]]:
    """The rules that a plan breaks: tone, the rule, its rooms, and the numbers; hard ones first."""
    plan = metrics.get("plan") or {}
    found = []
    for key, tone in (("violations", "bad"), ("soft", "fair")):
        for one in plan.get(key) or ():
            rooms = ", ".join(titles.get(name, name) for name in one.get("rooms") or ())
            found.append((tone, str(one.get("rule", "")).replace("_", " "), rooms, str(one.get("detail", ""))))
    return found


def home_faults(metrics: Mapping[str, Any]) -> list[tuple[str, str]]:
    """What is wrong with the home as a whole: kind and detail."""
    return [
        (KINDS.get(str(v.get("kind")), str(v.get("kind", "")).replace("_", " ").capitalize()), str(v.get("detail", "")))
        for v in metrics.get("violations") or ()
    ]


def measures(metrics: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Numbers of the plan and of the ways through the home."""
    plan, access = metrics.get("plan") or {}, metrics.get("access") or {}
    rows = []
    for key, value in (plan.get("measures") or {}).items():
        name = _MEASURES.get(key, key.replace("_", " ").capitalize())
        shown = f"{100 * value:.1f} %" if key.endswith("share") else f"{value:.2f}"
        rows.append((name, shown))
    for key, name, unit in _ACCESS:
        if isinstance(access.get(key), int | float):
            rows.append((name, f"{100 * access[key]:.1f} {unit}"))
    if isinstance(plan.get("cost"), int | float):
        rows.append(("Cost of soft rules", f"{plan['cost']:.2f}"))
    return rows


def verdict(metrics: Mapping[str, Any]) -> tuple[str, str]:
    """A tone and a word for the whole home."""
    plan = metrics.get("plan") or {}
    values = [v for v in (metrics.get("valid"), plan.get("valid")) if isinstance(v, bool)]
    if not values:
        return "unknown", "not checked"
    return ("good", "valid") if all(values) else ("bad", "not valid")


def demand_rows(design: Mapping[str, Any]) -> list[tuple[str, str, str, str]]:
    """Each demand of a design: a tone, what became of it, its words, what was found."""
    tones = {"met": "good", "partly": "fair", "not met": "bad", "not understood": "unknown"}
    rows = [row for row in design.get("demands") or () if isinstance(row, Mapping)]
    texts = [tuple(str(row.get(key, "")) for key in ("status", "words", "found")) for row in rows]
    return [(tones.get(status, "unknown"), status, words, found) for status, words, found in texts]
