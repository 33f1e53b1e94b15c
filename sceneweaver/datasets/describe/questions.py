"""Questions of what there is, where things are and how large: counts, colours, sides, walls, distances, areas."""

from __future__ import annotations

import math
from collections import Counter
from functools import lru_cache
from typing import Any

import numpy as np

from sceneweaver.knowledge import room_types
from sceneweaver.knowledge.kin import kin
from sceneweaver.verify.measures import turn
from sceneweaver.verify.solids import Body

from .asker import Asker, Question, rounded
from .facts import FLAT, Facts, has_front, is_seat, is_watcher, viewer_of
from .naming import color, colors_apart, noun, nouns, with_article


@lru_cache(maxsize=2**16)
def _confusable(category: str, other: str) -> bool:
    """Whether someone may count one for the other."""
    mine, theirs = noun(category), noun(other)
    same_words = theirs.endswith(mine) or mine.endswith(theirs) or nouns(category) in theirs or nouns(other) in mine
    return same_words or other in kin(category)


def _countable(facts: Facts) -> list[str]:
    """Categories that nothing else in the room could be taken for."""
    there = sorted(facts.by_category)
    return [c for c in there if not any(d != c and _confusable(c, d) for d in there)]


def how_many(asker: Asker) -> Question | None:
    """How many of a category there are."""
    by_category = asker.facts.by_category
    known = _countable(asker.facts)
    # A number is drawn first, so that none is the usual answer.
    numbers = sorted({len(by_category[c]) for c in known} & set(range(1, 13)))
    if not numbers:
        return None
    wanted = asker.one(numbers)
    category = asker.one([c for c in known if len(by_category[c]) == wanted])
    objects = tuple(b.id for b in by_category[category])
    return asker.ask("count", wanted, (), {"category": category}, objects=objects, things=nouns(category))


def exists(asker: Asker) -> Question | None:
    """Whether there is something of a category; what is not there is usual in rooms of this kind."""
    by_category = asker.facts.by_category
    there = sorted(by_category)
    kind = room_types().get(asker.facts.scene.room.type)
    if kind is None:
        return None
    # Both answers come from things that rooms of this kind have as often, so that knowing rooms does not do.
    for need in ("optional", "usual"):
        kinds = sorted({c for item in kind.items if item.need == need for c in item.what})
        absent = [c for c in kinds if not any(c == d or _confusable(c, d) or _confusable(d, c) for d in there)]
        present = [c for c in kinds if c in there]
        if present and absent:
            said = asker.coin()
            category = asker.one(present if said else absent)
            objects = tuple(b.id for b in by_category.get(category, ()))
            operands = {"category": category, "count": len(objects)}
            return asker.ask("exists", said, (), operands, objects=objects, thing=with_article(noun(category)))
    return None


def more_of(asker: Asker) -> Question | None:
    """Whether there are more of one category than of another."""
    by_category = asker.facts.by_category
    known = _countable(asker.facts)
    pairs = [(a, b) for a in known for b in known if a != b and len(by_category[a]) != len(by_category[b])]
    found = asker.balanced(
        asker.shuffled(pairs), lambda pair: (len(by_category[pair[0]]) > len(by_category[pair[1]]), None)
    )
    if found is None:
        return None
    (a, b), said, _ = found
    objects = tuple(body.id for c in (a, b) for body in by_category[c])
    operands = {a: len(by_category[a]), b: len(by_category[b])}
    return asker.ask("more_of", said, (), operands, objects=objects, things=nouns(a), others=nouns(b))


def what_color(asker: Asker) -> Question | None:
    """The colour of a thing, of four."""
    coloured = [b for b in asker.standing if color(b)]
    shown = sorted({c for b in asker.facts.bodies if (c := color(b))})
    if not coloured or len(shown) < 2:
        return None
    body = asker.one(coloured)
    said = color(body)
    if said is None or said in asker.name(body):
        return None
    others = [c for c in asker.shuffled([*shown, "red", "blue", "green", "black", "white"]) if colors_apart(c, said)]
    options = asker.shuffled(list(dict.fromkeys([said, *others]))[:4])
    return asker.ask("color", said, (body,), {"color": said}, options=options)


def what_is_on(asker: Asker) -> Question | None:
    """What rests on a thing."""
    carriers = [
        (key, things)
        for key, things in asker.facts.carried.items()
        if key[0] in asker.names and 1 <= len(things) <= 8 and len({_surface(t) for t in things}) == 1
    ]
    if not carriers:
        return None
    (carrier, how), things = asker.one(carriers)
    body = asker.facts.by_id[carrier]
    operands = {"carrier": carrier, "supports": {t.id: _surface(t) for t in things}}
    objects = (*asker.ids(body), *(t.id for t in things))
    counts = Counter(noun(t.item.category) for t in things)
    inventory = [word for word in sorted(counts) for _ in range(counts[word])]
    return asker.ask(f"what_is_{how}", inventory, (body,), operands, objects=objects)


def _surface(thing: Body) -> str | None:
    return thing.item.support.surface if thing.item.support is not None else None


def is_on(asker: Asker) -> Question | None:
    """Whether a thing rests on another."""
    facts = asker.facts
    carriers = [facts.by_id[c] for c, how in facts.carried if how == "on" and c in asker.names]
    small = [b for b in asker.named if b.item.support is not None and len(asker.names[b.id].ids) == 1]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, str]:
        thing, carrier = pair
        support = thing.item.support
        on = {b.id for b in facts.carried.get((carrier.id, "on"), ())}
        chain = support is not None and support.object != carrier.id and _stands_over(facts, thing, carrier)
        inside = support is not None and support.object == carrier.id and thing.id not in on
        return (None if chain or inside else thing.id in on), support.object if support else ""

    likely = [(b, facts.by_id[b.item.support.object]) for b in small if b.item.support is not None]
    direct = [(b, c) for b, c in asker.shuffled(likely) if c.id in asker.names][:8]
    pairs = asker.shuffled([*direct, *list(asker.pairs(small, carriers))[:8]])
    return asker.ask_balanced("is_on", pairs, answer, lambda said, support: {"operands": {"support": support}})


def _stands_over(facts: Facts, thing: Body, carrier: Body) -> bool:
    """Whether a carrier holds a thing by way of others."""
    support = thing.item.support
    while support is not None:
        if support.object == carrier.id:
            return True
        support = facts.by_id[support.object].item.support
    return False


TURNED = 25.0
"""Angle [deg] from straight ahead from which something is on one's left or right."""


def side_from_door(asker: Asker) -> Question | None:
    """Which of two things is farther to the left, seen from the door."""
    facts = asker.facts
    if facts.doorway is None:
        return None
    for a, b in asker.pairs(asker.standing, asker.standing):
        corners_a, corners_b = (_corners(asker, body) for body in (a, b))
        if min(corners_a[:, 0].min(), corners_b[:, 0].min()) < 0.3:
            continue
        # Both views have to agree with a margin: across the direction into the room, and by bearing from the door.
        left_of, right_of = _beyond(corners_a, corners_b), _beyond(corners_b, corners_a)
        lefter, righter = (aside > 0.05 and turned > 2 for aside, turned in (left_of, right_of))
        if lefter == righter:
            continue
        if asker.coin():
            a, b, lefter = b, a, not lefter
        aside = {body.id: rounded(facts.from_door(body)[1]) for body in (a, b)}  # pyright: ignore[reportOptionalSubscript]
        return asker.ask(
            "side_from_door",
            "left" if lefter else "right",
            (a, b),
            {"left_of_axis": aside},
            margin=rounded(max(left_of[0], right_of[0])),
            options=("left", "right"),
        )
    return None


def _corners(asker: Asker, body: Body) -> np.ndarray:
    """Corners [4, 2] of a box, ahead and to the left [m] of who looks in from the door."""
    start, inward, left = asker.facts.doorway  # pyright: ignore[reportGeneralTypeIssues]
    return (np.array(body.corners) - start) @ np.stack([inward, left], axis=1)


def _beyond(one: np.ndarray, other: np.ndarray) -> tuple[float, float]:
    """How far all corners [4, 2] of one box are to the left of those of another, aside [m] and by bearing [deg]."""
    bearings = [np.degrees(np.arctan2(corners[:, 1], corners[:, 0])) for corners in (one, other)]
    return float(one[:, 1].min()) - float(other[:, 1].max()), float(bearings[0].min()) - float(bearings[1].max())


def side_of_thing(asker: Asker) -> Question | None:
    """Whether a thing is on the left or right of who sits in a seat, or looks at a piece of furniture."""
    fronted = [b for b in asker.standing if has_front(b) and not b.tilted]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        a, b = pair
        if asker.facts.boxes_apart(a, b) > 3.0:
            return None, 0.0
        corners = np.array([b.local(corner) for corner in a.corners])
        angles = np.degrees(np.arctan2(corners[:, 1], corners[:, 0]))
        sides = np.sign(corners[:, 1])
        if abs(sides.sum()) < 4 or np.abs(angles).min() < TURNED or np.abs(angles).max() > 180 - TURNED:
            return None, 0.0
        return bool((sides[0] > 0) == is_seat(b)), float(np.abs(corners[:, 1]).min())

    found = asker.balanced(asker.pairs(asker.standing, fronted), answer)
    if found is None:
        return None
    (a, b), left, margin = found
    start = asker.say(f"viewer_{viewer_of(b)}", asker.name(b))
    operands = {
        "in_frame_of": b.id,
        "centre": [rounded(v) for v in b.local(a.centre)],
        "viewer": "own" if is_seat(b) else "opposite",
    }
    side = "left" if left else "right"
    margin, options = rounded(margin), ("left", "right")
    return asker.ask("side_of_thing", side, (a, b), operands, margin=margin, options=options, start=start)


def faces(asker: Asker) -> Question | None:
    """Whether a seat or a screen faces a thing."""
    watchers = [b for b in asker.named if is_watcher(b) and not b.tilted]
    targets = asker.standing + [b for b in asker.named if b.item.mount == "wall"]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        a, b = pair
        away = (b.centre[0] - a.centre[0], b.centre[1] - a.centre[1])
        if not 0.3 <= math.hypot(*away) <= 6:
            return None, 0.0
        angle = turn(a.front, away)
        return (True if angle <= 12 else False if angle >= 45 else None), angle

    near = sorted(asker.pairs(watchers, targets), key=lambda p: answer(p)[0] is not True)

    def details(said: bool, angle: float) -> dict[str, Any]:
        margin = rounded(15 - angle if said else angle - 40, 1)
        return {"operands": {"degrees_off": rounded(angle, 1)}, "margin": margin}

    return asker.ask_balanced("faces", [*near[:6], *asker.shuffled(near[6:])], answer, details)


def which_wall(asker: Asker) -> Question | None:
    """The wall that a thing stands against."""
    facts = asker.facts
    if len(facts.wall_names) < 3:
        return None
    walls = {b.id: facts.wall_at(b, 0.9) for b in asker.standing}
    # A wall is drawn first, so that none is the usual answer.
    for wall, body in ((k, b) for k in asker.shuffled(facts.wall_names) for b in asker.shuffled(asker.standing)):
        if walls[body.id] != wall or facts.wall_gap(body, wall) > 0.08:
            continue
        gap, clear = facts.wall_gap(body, wall), min(facts.wall_gap(body, k) for k in facts.wall_names if k != wall)
        if clear < 0.3:
            continue
        return asker.ask(
            "which_wall",
            facts.wall_names[wall],
            (body,),
            {"wall": f"wall:{wall}", "distance": rounded(gap), "next_nearest": rounded(clear)},
            margin=rounded(clear - gap),
            options=asker.shuffled(facts.wall_names.values()),
        )
    return None


def between(asker: Asker) -> Question | None:
    """Which thing stands between two others."""
    for a, b in list(asker.pairs(asker.standing, asker.standing))[:12]:
        if not 1.2 < math.dist(a.centre, b.centre) < 5:
            continue
        others = [c for c in asker.standing if c not in (a, b)]
        places = {c.id: asker.facts.beside_line(c, a, b) for c in others}
        inside = [c for c in others if 0.22 < places[c.id][0] < 0.78 and places[c.id][1] < 0.3]
        maybe = [c for c in others if 0.05 < places[c.id][0] < 0.95 and places[c.id][1] < 0.8]
        far = [c for c in others if c not in maybe]
        if len(inside) != 1 or len(maybe) != 1 or len(far) < 3:
            continue
        options = asker.shuffled([inside[0], *asker.shuffled(far)[:3]])
        operands = {"relation": "between", "subject": inside[0].id, "target": [a.id, b.id]}
        return asker.ask("between", inside[0], (inside[0], a, b), operands, margin=0.2, options=options)
    return None


def how_far(asker: Asker) -> Question | None:
    """The distance between two things."""
    for pair in asker.pairs(asker.standing, asker.standing):
        apart = asker.facts.distance(*pair)
        if apart >= 0.3:
            tolerance = rounded(max(0.1, 0.1 * apart), 2)
            return asker.ask("distance", rounded(apart, 1), pair, {"distance": rounded(apart)}, tolerance=tolerance)
    return None


def within(asker: Asker) -> Question | None:
    """Whether two things are at most so far apart."""
    limit = asker.one((0.5, 1.0, 1.5, 2.0, 3.0))

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        apart = asker.facts.distance(*pair)
        return (None if abs(apart - limit) < 0.15 else apart < limit), apart

    def details(said: bool, apart: float) -> dict[str, Any]:
        return {"operands": {"distance": rounded(apart), "limit": limit}, "margin": rounded(abs(apart - limit))}

    return asker.ask_balanced("within", asker.pairs(asker.standing, asker.standing), answer, details, limit=limit)


def nearest(asker: Asker) -> Question | None:
    """Which of some things is nearest to another."""
    for body in asker.shuffled(asker.standing):
        others = [b for b in asker.standing if b is not body and body.id not in asker.names[b.id].ids]
        chosen = [b for b in asker.shuffled(others) if b.id not in asker.names[body.id].ids][:4]
        if len(chosen) < 3:
            return None
        apart = {b.id: asker.facts.distance(body, b) for b in chosen}
        ranked = sorted(chosen, key=lambda b: apart[b.id])
        margin = apart[ranked[1].id] - apart[ranked[0].id]
        if margin >= 0.25:
            operands = {"distances": {i: rounded(v) for i, v in apart.items()}}
            about = (body, *chosen)
            return asker.ask("nearest", ranked[0], about, operands, margin=rounded(margin), options=chosen)
    return None


def taller(asker: Asker) -> Question | None:
    """Whether one thing is taller than another."""

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, dict[str, float]]:
        heights = {body.id: body.z[1] - body.z[0] for body in pair}
        a, b = heights.values()
        return (a > b if 0.08 < abs(a - b) < 0.6 else None), heights

    def details(said: bool, heights: dict[str, float]) -> dict[str, Any]:
        a, b = heights.values()
        return {"operands": {"heights": {i: rounded(h) for i, h in heights.items()}}, "margin": rounded(abs(a - b))}

    return asker.ask_balanced("taller", asker.pairs(asker.standing, asker.standing), answer, details)


def largest(asker: Asker) -> Question | None:
    """Which of some things takes up most of the floor."""
    size = {b.id: b.size[0] * b.size[1] for b in asker.standing}
    by_size = sorted(asker.standing, key=lambda b: (-size[b.id], b.id))
    if len(by_size) < 3:
        return None
    # Things of like sizes, so that knowing furniture does not do.
    start = int(asker.rng.integers(max(1, len(by_size) - 3)))
    ranked = by_size[start : start + 4]
    chosen = asker.shuffled(ranked)
    first, second = size[ranked[0].id], size[ranked[1].id]
    if first < 1.2 * second:
        return None
    operands = {"areas": {b.id: rounded(size[b.id]) for b in chosen}}
    return asker.ask("largest", ranked[0], chosen, operands, margin=rounded(first - second), options=chosen)


def floor_area(asker: Asker) -> Question | None:
    """The area of the floor, all of it or what no furniture stands on."""
    import shapely

    facts, area = asker.facts, asker.facts.area
    if asker.coin():
        return asker.ask("floor_area", rounded(area, 1), (), {"area": rounded(area)}, tolerance=rounded(0.05 * area, 2))
    rows = [r for b in facts.bodies if b.z[0] < FLAT < b.z[1] for r in range(*facts.placed.part_rows(b).indices(10**9))]
    taken = shapely.intersection(shapely.union_all(facts.placed.parts.polygons[rows]), facts.placed.floor)
    free = area - float(shapely.area(taken))
    operands = {"area": rounded(area), "taken": rounded(area - free)}
    tolerance = rounded(max(0.3, 0.05 * area), 2)
    return asker.ask("free_floor", rounded(free, 1), (), operands, tolerance=tolerance, flat=FLAT)


def how_high(asker: Asker) -> Question | None:
    """How high a thing is, of what is not quite flat."""
    bodies = [b for b in asker.standing if b.z[1] - b.z[0] > 0.3]
    if not bodies:
        return None
    body = asker.one(bodies)
    height = body.z[1] - body.z[0]
    tolerance = float(max(5, math.ceil(10 * height)))
    return asker.ask("height", round(100 * height), (body,), {"height": rounded(height)}, tolerance=tolerance)


TEMPLATES = (
    *(how_many, how_many, exists, exists, more_of, what_color, what_is_on, is_on),
    *(side_from_door, side_from_door, side_of_thing, side_of_thing, faces, which_wall, between),
    *(how_far, how_far, within, nearest, taller, largest, floor_area, how_high),
)
