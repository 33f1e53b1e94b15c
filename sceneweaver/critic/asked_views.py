"""Whether people see from their seats what a request says they see, and have nothing at their backs that they should
not."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sceneweaver.assets.roles import groups_above
from sceneweaver.language.model import View
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from .places import segments
from .survey import Survey, turn_to
from .verdict import Asked, met, not_understood, unmet


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each view that a request states; of several seats the one that is farthest off tells."""
    for k, said in enumerate(survey.brief.views):
        item = said.id or f"view-{k}"
        seats = _seats(survey, said)
        if not seats:
            yield not_understood("relation", item, (), f"'{said.words}': there are no seats")
            continue
        targets = _targets(survey, said)
        if not targets and said.target != "each other":
            yield not_understood("relation", item, (), f"'{said.words}': there is no {said.target}")
            continue
        worst, wrong = _worst(survey, said, seats, targets)
        ids = [seat.id for seat in seats]
        if worst.ok() and not wrong:
            yield met("relation", item, ids, f"'{said.words}': so it is for {len(seats)} seats", worst)
            continue
        reason = f"'{said.words}' does not hold for {', '.join(wrong[:4])}: {worst}"
        share = len(wrong) / len(seats)
        yield unmet("relation", item, ids, reason, worst, fault="not_seen", wrong=wrong, share=share)


def _seats(survey: Survey, said: View) -> list[Body]:
    """The seats that a view is said of: those that are named, else all on the floor."""
    named = survey.standing_for(said.entity) if said.entity else []
    return named or [
        body
        for body in survey.bodies
        if body.item.mount == "floor" and "seating" in groups_above(body.item.category) and body.item.support is None
    ]


def _targets(survey: Survey, said: View) -> list[tuple[float, float]]:
    """Where what is looked at is: the middles of things, or of openings."""
    if said.target == "middle":
        xs, ys = [p[0] for p in survey.scene.room.outline], [p[1] for p in survey.scene.room.outline]
        return [((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)]
    things = [body.centre[:2] for body in survey.standing_for(said.target)]
    return things or [segment.middle[:2] for segment in segments(survey, said.target)]


def _worst(
    survey: Survey, said: View, seats: Sequence[Body], targets: Sequence[tuple[float, float]]
) -> tuple[Measurement, list[str]]:
    """The measurement of the seat that is farthest off, and the seats that are off."""
    limits = fault_kind("not_seen").limits
    low, high = (limits["back"], math.inf) if said.kind == "back_to" else (0.0, limits["back"])
    if said.kind in ("see", "face"):
        high = limits[said.kind]
    found: list[tuple[float, Measurement, str]] = []
    for seat in seats:
        points = targets or [_middle([b for b in seats if b is not seat])] if len(seats) > 1 or targets else []
        for point in points[:1] if said.kind in ("see", "face") else points:
            turned = Measurement("turned from it", math.degrees(turn_to(seat, point)), low, high, "deg")
            found.append((turned.excess, turned, seat.id))
        if said.kind == "see" and targets and (covered := _covered(survey, said, seat, targets[0])) is not None:
            hidden = Measurement(f"{covered.id} in the way, its height", covered.z[1], 0.0, limits["eye"], "m")
            found.append((1.0, hidden, seat.id))
    wrong = list(dict.fromkeys(name for _, m, name in found if not m.ok()))
    return max(found, key=lambda row: row[0])[1], wrong


def _middle(bodies: Sequence[Body]) -> tuple[float, float]:
    return (sum(b.centre[0] for b in bodies) / len(bodies), sum(b.centre[1] for b in bodies) / len(bodies))


def _covered(survey: Survey, said: View, seat: Body, point: tuple[float, float]) -> Body | None:
    """What stands between the eyes of who sits there and what is to be seen; None where nothing does."""
    import shapely

    limits = fault_kind("not_seen").limits
    line = shapely.LineString([seat.centre[:2], point])
    own = {b.id for b in survey.standing_for(said.target)} | {seat.id}
    for body in survey.bodies:
        tall = body.z[0] < limits["eye"] < body.z[1] and max(body.size[:2]) > limits["wide"]
        seating = "seating" in groups_above(body.item.category)
        if body.id in own or not tall or seating or body.item.mount != "floor":
            continue
        box = shapely.Polygon(body.corners)
        if shapely.length(shapely.intersection(line, box)) > limits["wide"] / 2:
            return body
    return None


__all__ = ["outcomes"]
