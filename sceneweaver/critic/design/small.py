"""Small things: within reach, in the right kind of room, once where people own one, not copies of each other."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.knowledge.small_things import belongs, most_of
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..survey import Survey
from .breach import breach
from .measure import applies, asked_for, named, names

DAILY = frozenset(("toiletry", "tableware", "cookware"))
"""Groups of things that are taken to hand every day."""

TOWELS = named("folded_towel towel_roll towel_stack")

OUT_OF_HAND = 0.1
"""Height [m] beyond the rule's up to which most people still reach."""

UNIQUE = named("picture poster photo_frames tapestry")
"""What people never hang twice."""

OWN = {"laptop": 4, "standing_books": 3}
"""How many of some things look the same before it is seen."""

MANY = 24
"""Things of a kind from which nobody looks for those that are alike, as the books of a library."""

BOTTLES = named("shampoo_bottle lotion_bottle perfume")

BOARDS = frozenset(("whiteboard", "blackboard"))

CROWN = kinds.TALL_PLANTS | {"monstera", "fiddle_leaf_fig"}

BINS = frozenset(("pedal_bin", "trash_can", "wastebasket"))

TABLETOP = 0.65
"""Share of a small table that its settings may take."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for small things."""
    yield from _reach(survey)
    yield from _foreign(survey)
    yield from _again(survey)
    yield from _clones(survey)
    if applies(survey, "fits_its_place"):
        yield from _fits(survey)


def _reach(survey: Survey) -> Iterator[Finding]:
    high = limit("daily_things_in_reach", "high")
    up = [
        b
        for b in survey.bodies
        if b.item.mount == "surface"
        and b.z[0] > high + OUT_OF_HAND
        and (kinds.groups_of(b.item.category) & DAILY or b.item.category in TOWELS)
        and not asked_for(survey, b)
    ]
    if up:
        top = max(b.z[0] for b in up)
        yield breach(
            "daily_things_in_reach",
            (b.id for b in up),
            f"{names(up)} stands {top:.2f} m above the floor",
            measured=top,
            allowed=(limit("daily_things_in_reach", "low"), high),
            weight=min(2.0, 0.6 + 0.2 * len(up)),
            suggestion=f"keep {names(up)} between 0.4 and {high:g} m",
            call=("remove_objects", {"ids": [b.id for b in up]}),
        )


def _foreign(survey: Survey) -> Iterator[Finding]:
    """Things that people do not have in such a room."""
    if not applies(survey, "belongs_to_room"):
        return
    room = survey.room_type.name
    found = [
        b
        for b in survey.bodies
        if b.item.mount == "surface" and not belongs(b.item.category, room) and not asked_for(survey, b)
    ]
    if found:
        yield breach(
            "belongs_to_room",
            (b.id for b in found),
            f"{names(found)} does not belong in {kinds.a(room)}",
            measured=float(len(found)),
            weight=min(5.0, 0.7 + 0.3 * len(found)),
            suggestion=f"remove {names(found)}",
            call=("remove_objects", {"ids": [b.id for b in found]}),
        )


def _again(survey: Survey) -> Iterator[Finding]:
    """More of a thing than a room has."""
    if not applies(survey, "one_of_each"):
        return
    by: dict[str, list[Body]] = defaultdict(list)
    for body in survey.bodies:
        by[body.item.category].append(body)
    spare: list[Body] = []
    everyone: list[Body] = []
    for category, bodies in by.items():
        most = most_of(category, survey.room_type.name)
        if not most or len(bodies) <= most or any(asked_for(survey, b) for b in bodies) or _one_each(survey, bodies):
            continue
        spare += bodies[most:]
        everyone += bodies
    if spare:
        yield breach(
            "one_of_each",
            (b.id for b in everyone),
            f"{names(spare)} {'is' if len(spare) == 1 else 'are'} there beside another of the kind",
            measured=float(len(spare)),
            weight=min(3.0, 0.7 + 0.3 * len(spare)),
            suggestion=f"remove {names(spare)}",
            call=("remove_objects", {"ids": [b.id for b in spare]}),
        )


def _one_each(survey: Survey, bodies: list[Body]) -> bool:
    """Whether each of some things stands on a table of its own that people sit around, as in a restaurant."""
    bases = [survey.placed.by_id.get(b.item.support.object) for b in bodies if b.item.support is not None]
    tables = {b.id for b in bases if b is not None and b.item.category in kinds.DINING}
    return len(tables) == len(bodies)


def _clones(survey: Survey) -> Iterator[Finding]:
    """Copies: the same picture twice, one bottle again and again, everybody's laptop the same."""
    if not applies(survey, "not_cloned"):
        return
    limits = design_rules()["not_cloned"].limits
    sets: dict[tuple[str, str], list[Body]] = defaultdict(list)
    count = Counter(b.item.category for b in survey.bodies)
    for body in survey.bodies:
        if body.item.category in UNIQUE | BOTTLES | OWN.keys() and not asked_for(survey, body):
            look = (body.item.asset or "").split("&size")[0] or str(body.item.attributes.get("material"))
            sets[body.item.category, look].append(body)
    pictures = [b for (c, _), bodies in sets.items() if c in UNIQUE and len(bodies) > limits["picture"] for b in bodies]
    copies = [
        b
        for (c, _), bodies in sets.items()
        if c not in UNIQUE and len(bodies) >= OWN.get(c, limits["count"]) and count[c] < MANY
        for b in bodies
    ]
    for bodies, least in ((pictures, 2), (copies, 3)):
        if len(bodies) >= least:
            yield breach(
                "not_cloned",
                (b.id for b in bodies),
                f"{names(bodies)} look exactly alike",
                measured=float(len(bodies)),
                allowed=(0.0, 1.0),
                weight=1.0 if bodies is pictures else 0.7,
                suggestion=f"take others for {names(bodies[1:])}",
            )


def _fits(survey: Survey) -> Iterator[Finding]:
    """Things too large or too small for where they are."""
    limits = design_rules()["fits_its_place"].limits
    small_room = survey.area < limits["large_room"]
    wrong: list[tuple[Body, str, float, tuple[float | None, float | None]]] = []
    for body in survey.bodies:
        d, w, h = body.size
        category = body.item.category
        if asked_for(survey, body):
            continue
        if category == "wall_clock" and max(w, h) > limits["clock"] + (0.0 if small_room else 0.1):
            wrong.append((body, f"{max(w, h):.2f} m across", max(w, h), (None, limits["clock"])))
        elif category in BOARDS and body.item.mount == "wall" and (w * h < limits["board"] or w < h):
            wrong.append((body, f"{w:.2f} x {h:.2f} m for a whole room", w * h, (limits["board"], None)))
        elif category in CROWN and small_room and max(d, w) > limits["crown"]:
            wrong.append((body, f"{max(d, w):.2f} m wide", max(d, w), (None, limits["crown"])))
        elif category in BINS and small_room and h > limits["bin"] + 0.02:
            wrong.append((body, f"{h:.2f} m tall", h, (None, limits["bin"])))
        elif category == "cafe_table" and body.item.surfaces:
            share = _taken(survey, body)
            if share > TABLETOP:
                wrong.append((body, f"taken by {share:.0%} with what stands on it", share, (None, TABLETOP)))
    by: dict[str, list[tuple[Body, str, float, tuple[float | None, float | None]]]] = defaultdict(list)
    for row in wrong:
        by[row[0].item.category].append(row)
    for rows in by.values():
        body, text, value, allowed = rows[0]
        yield breach(
            "fits_its_place",
            (b.id for b, *_ in rows),
            f"{body.id} is {text}" + (f", and {len(rows) - 1} more" if len(rows) > 1 else ""),
            measured=value,
            allowed=allowed,
            weight=min(2.0, 0.8 + 0.2 * len(rows)),
            suggestion=f"take another size for {names(b for b, *_ in rows)}",
        )


def _taken(survey: Survey, table: Body) -> float:
    """Share of the top of a table that the boxes of the things on it take."""
    top = math.pi / 4 * table.size[0] * table.size[1] if abs(table.size[0] - table.size[1]) < 0.02 else 0.0
    top = top or table.size[0] * table.size[1]
    return sum(b.size[0] * b.size[1] for b in survey.carried.get(table.id, ())) / max(1e-6, top)
