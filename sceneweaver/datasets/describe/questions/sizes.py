"""Questions of lengths and areas: distances, the nearest, the largest, the floor."""

from __future__ import annotations

import math

from sceneweaver.verify.solids import Body

from ..facts import FLAT
from .question import Asker, Question, rounded, yes_no


def how_far(asker: Asker) -> Question | None:
    """The distance between two things."""
    for a, b in asker.pairs(asker.standing, asker.standing):
        apart = asker.facts.distance(a, b)
        if apart < 0.3:
            continue
        return Question(
            "distance",
            "number",
            asker.one_of(
                f"How many metres apart are {asker.name(a)} and {asker.name(b)}, measured on the floor between their "
                "nearest points?",
                f"How wide is the gap between {asker.name(a)} and {asker.name(b)}, seen from above, in metres?",
            ),
            rounded(apart, 1),
            asker.ids(a, b),
            {"distance": rounded(apart)},
            "distance between the two footprints, the outlines of their parts from above, rounded to 0.1 m",
            tolerance=rounded(max(0.1, 0.1 * apart), 2),
            unit="m",
        )
    return None


def within(asker: Asker) -> Question | None:
    """Whether two things are at most so far apart."""
    limit = (0.5, 1.0, 1.5, 2.0, 3.0)[int(asker.rng.integers(5))]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        apart = asker.facts.distance(*pair)
        return (None if abs(apart - limit) < 0.15 else apart < limit), apart

    found = asker.balanced(asker.pairs(asker.standing, asker.standing), answer)
    if found is None:
        return None
    (a, b), said, apart = found
    return Question(
        "within",
        "yes_no",
        asker.one_of(
            f"Is there less than {limit:g} m between {asker.name(a)} and {asker.name(b)}?",
            f"Are {asker.name(a)} and {asker.name(b)} less than {limit:g} m apart at their nearest points?",
        ),
        yes_no(said),
        asker.ids(a, b),
        {"distance": rounded(apart), "limit": limit},
        "distance between the two footprints",
        margin=rounded(abs(apart - limit)),
    )


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
        if margin < 0.25:
            continue
        return Question(
            "nearest",
            "choice",
            asker.one_of(
                f"Which of these is nearest to {asker.name(body)}?",
                f"Of these, what has the smallest gap to {asker.name(body)}?",
            ),
            asker.name(ranked[0]),
            asker.ids(body, *chosen),
            {"distances": {i: rounded(v) for i, v in apart.items()}},
            "the least of the distances between footprints",
            margin=rounded(margin),
            options=tuple(asker.name(b) for b in chosen),
            option_objects=tuple(b.id for b in chosen),
        )
    return None


def taller(asker: Asker) -> Question | None:
    """Whether one thing is taller than another."""

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, tuple[float, float]]:
        a, b = (body.z[1] - body.z[0] for body in pair)
        return (a > b if 0.08 < abs(a - b) < 0.6 else None), (a, b)

    found = asker.balanced(asker.pairs(asker.standing, asker.standing), answer)
    if found is None:
        return None
    (a, b), said, heights = found
    return Question(
        "taller",
        "yes_no",
        asker.one_of(
            f"Is {asker.name(a)} taller than {asker.name(b)}?",
            f"Does {asker.name(a)} stand taller than {asker.name(b)}?",
        ),
        yes_no(said),
        asker.ids(a, b),
        {"heights": {body.id: rounded(h) for body, h in zip((a, b), heights, strict=True)}},
        "comparison of the heights",
        margin=rounded(abs(heights[0] - heights[1])),
    )


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
    return Question(
        "largest",
        "choice",
        asker.one_of("Which of these takes up the most floor space?", "Which of these has the largest footprint?"),
        asker.name(ranked[0]),
        asker.ids(*chosen),
        {"areas": {b.id: rounded(size[b.id]) for b in chosen}},
        "depth times width of the box of each",
        margin=rounded(first - second),
        options=tuple(asker.name(b) for b in chosen),
        option_objects=tuple(b.id for b in chosen),
    )


def floor_area(asker: Asker) -> Question | None:
    """The area of the floor, all of it or what no furniture stands on."""
    import shapely

    facts = asker.facts
    area = facts.area
    if asker.coin():
        return Question(
            "floor_area",
            "number",
            asker.one_of("What is the floor area of the room in square metres?", "How many square metres is the room?"),
            rounded(area, 1),
            (),
            {"area": rounded(area)},
            "area of the outline of the room, rounded to 0.1 m2",
            tolerance=rounded(0.05 * area, 2),
            unit="m2",
        )
    rows = [r for b in facts.bodies if b.z[0] < FLAT < b.z[1] for r in range(*facts.placed.part_rows(b).indices(10**9))]
    taken = shapely.intersection(shapely.union_all(facts.placed.parts.polygons[rows]), facts.placed.floor)
    free = area - float(shapely.area(taken))
    return Question(
        "free_floor",
        "number",
        asker.one_of(
            "Seen from above, how many square metres of the floor are not covered by things that stand on it? Rugs and "
            "mats do not count.",
            "How much of the floor, in square metres, is left over when all that stands on it is seen from above (rugs "
            "and mats aside)?",
        ),
        rounded(free, 1),
        (),
        {"area": rounded(area), "taken": rounded(area - free)},
        f"area of the outline less the footprints of all things that begin below {FLAT} m and end above it",
        tolerance=rounded(max(0.3, 0.05 * area), 2),
        unit="m2",
    )


def how_high(asker: Asker) -> Question | None:
    """How high a thing is, of what is not quite flat."""
    bodies = [b for b in asker.standing if b.z[1] - b.z[0] > 0.3]
    if not bodies:
        return None
    body = bodies[int(asker.rng.integers(len(bodies)))]
    height = body.z[1] - body.z[0]
    return Question(
        "height",
        "number",
        asker.one_of(
            f"How tall is {asker.name(body)} in centimetres?", f"What is the height of {asker.name(body)} in cm?"
        ),
        round(100 * height),
        asker.ids(body),
        {"height": rounded(height)},
        "from the lowest to the highest point of its parts, rounded to 1 cm",
        tolerance=float(max(5, math.ceil(10 * height))),
        unit="cm",
    )


TEMPLATES = (how_far, how_far, within, nearest, taller, largest, floor_area, how_high)
