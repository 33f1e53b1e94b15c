"""Questions of where things are: sides, walls, what faces what, what stands between."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.verify.measures import turn
from sceneweaver.verify.solids import Body

from ..facts import has_front, is_bed, is_seat, is_watcher
from .question import Asker, Question, rounded, yes_no

APART = 0.4
"""Distance [m] sideways from which two things count as left and right of each other."""

TURNED = 25.0
"""Angle [deg] from straight ahead from which something is on one's left or right."""


def side_from_door(asker: Asker) -> Question | None:
    """Which of two things is farther to the left, seen from the door."""
    facts = asker.facts
    if facts.doorway is None:
        return None
    for a, b in asker.pairs(asker.standing, asker.standing):
        (ahead_a, left_a), (ahead_b, left_b) = _spans(asker, a), _spans(asker, b)
        if min(ahead_a, ahead_b) < 0.3:
            continue
        bearing_a, bearing_b = (_bearings(asker, body) for body in (a, b))
        lefter = left_a[0] - left_b[1] > 0.05 and bearing_a[0] - bearing_b[1] > 2
        righter = left_b[0] - left_a[1] > 0.05 and bearing_b[0] - bearing_a[1] > 2
        if lefter == righter:
            continue
        if asker.coin():
            a, b, lefter = b, a, not lefter
        return Question(
            "side_from_door",
            "choice",
            asker.one_of(
                f"You stand in the doorway and look straight into the room. Is {asker.name(a)} to the left or to the "
                f"right of {asker.name(b)}?",
                f"As you come in through the door, which side of {asker.name(b)} is {asker.name(a)} on: left or right?",
            ),
            "left" if lefter else "right",
            asker.ids(a, b),
            {"left_of_axis": {body.id: rounded(facts.from_door(body)[1]) for body in (a, b)}},  # pyright: ignore[reportOptionalSubscript]
            "the boxes of the two, across the direction into the room and by bearing from the middle of the doorway",
            margin=rounded(max(left_a[0] - left_b[1], left_b[0] - left_a[1])),
            options=("left", "right"),
        )
    return None


def _corners(asker: Asker, body: Body) -> np.ndarray:
    """Corners [4, 2] of a box, ahead and to the left [m] of who looks in from the door."""
    start, inward, left = asker.facts.doorway  # pyright: ignore[reportGeneralTypeIssues]
    return (np.array(body.corners) - start) @ np.stack([inward, left], axis=1)


def _spans(asker: Asker, body: Body) -> tuple[float, tuple[float, float]]:
    corners = _corners(asker, body)
    return float(corners[:, 0].min()), (float(corners[:, 1].min()), float(corners[:, 1].max()))


def _bearings(asker: Asker, body: Body) -> tuple[float, float]:
    corners = _corners(asker, body)
    angles = np.degrees(np.arctan2(corners[:, 1], corners[:, 0]))
    return float(angles.min()), float(angles.max())


def side_of_thing(asker: Asker) -> Question | None:
    """Whether a thing is on the left or right of who sits in a seat, or looks at a piece of furniture."""
    facts = asker.facts
    fronted = [b for b in asker.standing if has_front(b) and not b.tilted]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        a, b = pair
        if facts.boxes_apart(a, b) > 3.0:
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
    name = asker.name(b)
    if is_seat(b):
        start = f"You sit on {name} and look straight ahead."
    elif is_bed(b):
        start = f"You stand at the foot of {name} and look at it."
    else:
        start = f"You stand before the front of {name} and look at it."
    return Question(
        "side_of_thing",
        "choice",
        f"{start} Is {asker.name(a)} on your left or on your right?",
        "left" if left else "right",
        asker.ids(a, b),
        {
            "in_frame_of": b.id,
            "centre": [rounded(v) for v in b.local(a.centre)],
            "viewer": "own" if is_seat(b) else "opposite",
        },
        "corners of the first box, [ahead, left] in the frame of the second; left and right swap if one looks at it",
        margin=rounded(margin),
        options=("left", "right"),
    )


def faces(asker: Asker) -> Question | None:
    """Whether a seat or a screen faces a thing."""
    watchers = [b for b in asker.named if is_watcher(b) and not b.tilted]
    targets = asker.standing + [b for b in asker.named if b.item.mount == "wall"]

    def answer(pair: tuple[Body, Body]) -> tuple[bool | None, float]:
        a, b = pair
        away = (b.centre[0] - a.centre[0], b.centre[1] - a.centre[1])
        if math.hypot(*away) < 0.3 or math.hypot(*away) > 6:
            return None, 0.0
        angle = turn(a.front, away)
        return (True if angle <= 12 else False if angle >= 45 else None), angle

    near = sorted(asker.pairs(watchers, targets), key=lambda p: answer(p)[0] is not True)
    found = asker.balanced([*near[:6], *asker.shuffled(near[6:])], answer)
    if found is None:
        return None
    (a, b), said, angle = found
    return Question(
        "faces",
        "yes_no",
        asker.one_of(
            f"Does {asker.name(a)} face {asker.name(b)}?", f"Is {asker.name(a)} turned toward {asker.name(b)}?"
        ),
        yes_no(said),
        asker.ids(a, b),
        {"degrees_off": rounded(angle, 1)},
        "angle between the front of the first and the direction to the centre of the second: yes up to 15, no from 40",
        margin=rounded(15 - angle if said else angle - 40, 1),
    )


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
        others = [k for k in facts.wall_names if k != wall]
        clear = min(facts.wall_gap(body, k) for k in others)
        if clear < 0.3:
            continue
        names = asker.shuffled(facts.wall_names[k] for k in facts.wall_names)
        return Question(
            "which_wall",
            "choice",
            asker.one_of(
                f"For someone who comes in through the door, which wall does {asker.name(body)} stand against?",
                f"As you enter, which wall is {asker.name(body)} placed against?",
            ),
            facts.wall_names[wall],
            asker.ids(body),
            {"wall": f"wall:{wall}", "distance": rounded(facts.wall_gap(body, wall)), "next_nearest": rounded(clear)},
            "distance of the box from each wall that has a name",
            margin=rounded(clear - facts.wall_gap(body, wall)),
            options=tuple(names),
        )
    return None


def between(asker: Asker) -> Question | None:
    """Which thing stands between two others."""
    facts = asker.facts
    for a, b in list(asker.pairs(asker.standing, asker.standing))[:12]:
        if not 1.2 < math.dist(a.centre, b.centre) < 5:
            continue
        others = [c for c in asker.standing if c not in (a, b)]
        places = {c.id: facts.beside_line(c, a, b) for c in others}
        inside = [c for c in others if 0.22 < places[c.id][0] < 0.78 and places[c.id][1] < 0.3]
        maybe = [c for c in others if 0.05 < places[c.id][0] < 0.95 and places[c.id][1] < 0.8]
        far = [c for c in others if c not in maybe]
        if len(inside) != 1 or len(maybe) != 1 or len(far) < 3:
            continue
        options = asker.shuffled([inside[0], *asker.shuffled(far)[:3]])
        return Question(
            "between",
            "choice",
            asker.one_of(
                f"Which of these stands between {asker.name(a)} and {asker.name(b)}?",
                f"Of these, what is in the middle between {asker.name(a)} and {asker.name(b)}?",
            ),
            asker.name(inside[0]),
            asker.ids(inside[0], a, b),
            {"relation": "between", "subject": inside[0].id, "target": [a.id, b.id]},
            "the relation `between` of the catalogue, which holds for this one alone and not nearly for the others",
            margin=0.2,
            options=tuple(asker.name(c) for c in options),
            option_objects=tuple(c.id for c in options),
        )
    return None


TEMPLATES = (side_from_door, side_from_door, side_of_thing, side_of_thing, faces, which_wall, between)
