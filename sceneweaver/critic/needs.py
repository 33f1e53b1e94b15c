"""Whether a room can be used for what it is: needed and usual furniture, and groups that belong together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sceneweaver.knowledge import Item
from sceneweaver.knowledge.kin import serves

from . import kinds
from .grade import Finding, finding
from .program import Need
from .seats import seats_at
from .survey import Survey

SPARE = 0.15
"""Share of the usual items of a kind of room that one room may do without."""

PARENT_WIDE = 0.9
"""Distance [m] within which a seat counts as being at a table."""

SHOW = frozenset(("decor", "lighting", "plant_group", "textile"))
"""Groups whose absence makes a room unfinished rather than useless."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Missing furniture and incomplete groups."""
    reported: set[str] = set()
    spared = _spared(survey)
    for need in survey.program.needs:
        if need.missing:
            reported.add(need.item.id)
            if need.item.id not in spared:
                yield _missing(survey, need)
    yield from _desks(survey, reported)
    yield from _tables(survey, reported)
    yield from _screens(survey)


def placing(survey: Survey, item: Item, parent: str | None = None) -> list[dict[str, Any]]:
    """The item's relations as ``add_objects`` takes them, with ids for items; ``parent`` is what it goes with."""
    found = []
    for place in item.place:
        row: dict[str, Any] = {"type": place.type, **place.params}
        if place.to not in (None, "wall", "window", "door"):
            ids = [object_id for object_id, name in survey.program.item_of.items() if name == place.to]
            if not ids:
                continue
            row["to"] = parent if parent in ids else ids[0]
        elif place.to is not None and place.to != "wall":
            row["to"] = place.to
        if place.soft:
            row["soft"] = True
        found.append(row)
    return found


def _spared(survey: Survey) -> set[str]:
    """Ids of usual items that a room does without and nobody misses: a few of all that such rooms have."""
    usual = [n for n in survey.program.needs if n.item.need == "usual" and not n.asked]
    absent = [n.item.id for n in usual if not n.have]
    few = {n.item.id for n in usual if n.have and 2 * n.missing <= n.least}
    return few | set(absent if len(absent) <= SPARE * len(usual) else ())


def _missing(survey: Survey, need: Need) -> Finding:
    item, have, category = need.item, len(need.have), need.item.what[0]
    name = kinds.words(category)
    on = [object_id for object_id, of in survey.program.item_of.items() if of in item.on]
    calls: list[dict[str, Any]] = []
    for parent, number in _lacking(survey, need):
        row: dict[str, Any] = {"category": category, "count": number}
        place = placing(survey, item, parent)
        calls.append({**row, **({"place": place} if place else {}), **({"on": on} if on else {})})
    reason = f"{have} of {need.least} {name}s" if have else f"there is no {name}"
    reason += f"; {kinds.a(survey.room_type.name)} {'needs' if item.need == 'needed' else 'usually has'} {need.least}"
    fix = f"add {need.missing} {name}{'s' if need.missing > 1 else ''}"
    share = need.missing / need.least
    call = ("add_objects", {"objects": calls})
    if item.need == "needed":
        points, grave = 1.5 + 2.5 * share, share > 0.5
        others = not have and any(serves(b.item.category, item.what) for b in survey.bodies)
        if have >= need.core or others:
            points, grave = (0.4 + 1.6 * share), False  # too few for its size, or others do its work
        return finding(
            "functionality",
            "missing_needed",
            need.have,
            reason,
            fix,
            points=points,
            grave=grave,
            call=call,
        )
    show = bool(kinds.groups_of(category) & SHOW)
    criterion = "functionality" if item.with_ is not None and not show else "completion"
    return finding(
        criterion,
        "missing_usual",
        need.have,
        reason,
        fix,
        points=(0.25 if show else 0.35) * share + 0.1,
        call=call,
    )


def _lacking(survey: Survey, need: Need) -> list[tuple[str | None, int]]:
    """With what the missing ones should go, and how many with each: the instances that have the fewest near them."""
    name = need.item.with_
    parents = [object_id for object_id, of in survey.program.item_of.items() if of == name] if name is not None else []
    if len(parents) < 2:
        return [(parents[0] if parents else None, need.missing)]
    each, left, found = -(-need.least // len(parents)), need.missing, []
    have = set(need.have)
    near = {p: sum(b.id in have for b, _ in survey.near(survey.placed.by_id[p], PARENT_WIDE)) for p in parents}
    for parent in sorted(parents, key=lambda p: near[p]):
        number = min(left, max(0, each - near[parent]))
        if number:
            found.append((parent, number))
            left -= number
    return found if not left else [*found, (parents[0], left)]


def _desks(survey: Survey, reported: set[str]) -> Iterator[Finding]:
    for desk in survey.of_kind(kinds.DESKS - {"reception_desk", "standing_desk"}):
        if seats_at(survey, desk):
            continue
        item = survey.program.item_of.get(desk.id)
        if any(n.item.with_ == item and item is not None and n.item.id in reported for n in survey.program.needs):
            continue
        seat = "stool" if desk.item.category == "dressing_table" else "office_chair"
        seat = next((i.what[0] for i in survey.room_type.items if any(kinds.upright_seat(c) for c in i.what)), seat)
        yield finding(
            "functionality",
            "incomplete_group",
            (desk.id,),
            f"no chair within {PARENT_WIDE:g} m of {desk.id}",
            f"add a {kinds.words(seat)} in front of {desk.id}",
            points=1.5,
            call=(
                "add_objects",
                {"objects": [{"category": seat, "count": 1, "place": [{"type": "front_to_front", "to": desk.id}]}]},
            ),
        )


def _tables(survey: Survey, reported: set[str]) -> Iterator[Finding]:
    for table in survey.of_kind(kinds.DINING - {"bar_table", "folding_table"}):
        have = seats_at(survey, table)
        want = 2 if min(table.size[:2]) < 0.75 and max(table.size[:2]) < 1.0 else max(2, round(max(table.size[:2])))
        item = survey.program.item_of.get(table.id)
        needs = [n for n in survey.program.needs if item is not None and n.item.with_ == item]
        if len(have) >= want or any(n.item.id in reported for n in needs):
            continue
        seats = [i for i in survey.room_type.items if any(kinds.upright_seat(c) for c in i.what)]
        if seats and not any(i.with_ == item for i in seats):
            want = 1  # the room sets out its seats otherwise
            if have:
                continue
        category = have[0].item.category if have else (seats[0].what[0] if seats else "dining_chair")
        missing = want - len(have)
        yield finding(
            "functionality",
            "incomplete_group",
            (table.id, *(b.id for b in have)),
            f"{len(have)} seats within {PARENT_WIDE:g} m of {table.id}, which is {max(table.size[:2]):.1f} m long",
            f"add {missing} {kinds.words(category)} around {table.id}",
            points=0.6 + 1.4 * missing / want,
            call=(
                "add_objects",
                {
                    "objects": [
                        {"category": category, "count": missing, "place": [{"type": "front_against", "to": table.id}]}
                    ]
                },
            ),
        )


def _screens(survey: Survey) -> Iterator[Finding]:
    """A television that nobody can watch from a seat."""
    if not survey.of_kind(kinds.TVS) or survey.of_kind(kinds.LOUNGE, kinds.BEDS, kinds.LONG_BEDS):
        return
    if any(kinds.upright_seat(b.item.category) or b.item.category == "bench" for b in survey.bodies):
        return
    seats = kinds.LOUNGE | kinds.BEDS | kinds.LONG_BEDS
    if not any(set(item.what) & seats or any(map(kinds.upright_seat, item.what)) for item in survey.room_type.items):
        return  # such rooms are not made for sitting
    tvs = [b.id for b in survey.of_kind(kinds.TVS)]
    yield finding(
        "functionality",
        "incomplete_group",
        tvs,
        f"no seat in the room for {tvs[0]}",
        f"add a sofa facing {tvs[0]}",
        points=1.2,
        call=(
            "add_objects",
            {"objects": [{"category": "sofa", "count": 1, "place": [{"type": "facing", "to": tvs[0]}]}]},
        ),
    )
