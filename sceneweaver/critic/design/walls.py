"""What is on the walls: bare stretches, pictures of the wrong size, height or place, curtains beside their windows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from sceneweaver.geometry.walls import Wall, wall_behind
from sceneweaver.knowledge.design_rules import limit
from sceneweaver.scene import Window
from sceneweaver.verify.solids import Body, Opening

from .. import kinds
from ..grade import Finding
from ..groups import ALL_BEDS, HUNG
from ..survey import Survey
from .breach import breach

TALL = 1.2
"""Height [m] from which furniture covers the wall behind it."""

CLOSE = 0.35
"""Gap [m] to a wall up to which tall furniture covers it."""

CURTAINS = frozenset(("curtain", "sheer_curtain"))

PLAIN = frozenset(("gym", "home_gym", "workshop", "garage", "storage_room", "server_room", "laboratory", "pantry"))
"""Rooms in which a wall may stay half as bare."""

OVER = kinds.SOFAS | ALL_BEDS | frozenset(("sideboard", "dresser", "console_table", "desk"))
"""What art is hung over."""


class Span(NamedTuple):
    """A stretch along a wall [m]."""

    start: float
    end: float


def faults(survey: Survey) -> Iterator[Finding]:
    """Bare walls, misplaced art, curtains off their window."""
    if not survey.brief.only and survey.brief.density != "sparse":
        yield from _bare(survey)
    yield from _art(survey)
    for opening in survey.placed.windows:
        yield from _curtains(survey, opening)


# ---- cover -----------------------------------------------------------------------------------------------------------


def covered(survey: Survey, wall: Wall) -> list[Span]:
    """Stretches of a wall with an opening, something hung, or tall furniture; in order, not overlapping."""
    spans = [Span(o.item.offset, o.item.offset + o.item.width) for o in _openings(survey) if o.wall.index == wall.index]
    for body in survey.bodies:
        hung = body.item.mount == "wall"
        if not hung and not (body.item.mount == "floor" and body.size[2] >= TALL):
            continue
        alongs, depths = zip(*(wall.coordinates(corner) for corner in body.corners), strict=True)
        if min(depths) > CLOSE or max(alongs) < 0.0 or min(alongs) > wall.length:
            continue
        if hung and wall_behind(survey.placed.walls, body.position, body.front) != wall.index:
            continue
        spans.append(Span(max(0.0, min(alongs)), min(wall.length, max(alongs))))
    merged: list[Span] = []
    for span in sorted(spans):
        if merged and span.start <= merged[-1].end:
            merged[-1] = Span(merged[-1].start, max(merged[-1].end, span.end))
        else:
            merged.append(span)
    return merged


def _openings(survey: Survey) -> list[Opening]:
    return [*survey.placed.doors, *survey.placed.windows]


def free_runs(survey: Survey, wall: Wall) -> list[Span]:
    """Stretches of a wall with nothing on them."""
    at, runs = 0.0, []
    for span in [*covered(survey, wall), Span(wall.length, wall.length)]:
        if span.start > at:
            runs.append(Span(at, span.start))
        at = max(at, span.end)
    return runs


def _bare(survey: Survey) -> Iterator[Finding]:
    most = limit("wall_covered", "length") * (2.0 if survey.room_type.name in PLAIN else 1.0)
    for wall in survey.placed.walls:
        if wall.length < most:
            continue
        bare = sum(run.end - run.start for run in free_runs(survey, wall) if run.end - run.start > most)
        share = 1.0 - sum(run.end - run.start for run in free_runs(survey, wall)) / wall.length
        if bare > 0.0 and (share < limit("wall_covered", "share") or bare > 2.0 * most):
            yield breach(
                "wall_covered",
                (),
                f"{bare:.1f} m of wall {wall.index} are bare, {share:.0%} of it is covered",
                measured=share,
                allowed=(limit("wall_covered", "share"), None),
                suggestion=f"hang something on wall {wall.index}, or put tall furniture before it",
                call=("add_wall_objects", {"walls": []}),
            )


# ---- art -------------------------------------------------------------------------------------------------------------


def _art(survey: Survey) -> Iterator[Finding]:
    corner = limit("art_corner", "gap")
    for body in survey.of_kind(HUNG):
        if body.item.mount != "wall":
            continue
        wall = survey.placed.walls[wall_behind(survey.placed.walls, body.position, body.front)]
        along, _ = wall.coordinates(body.centre)
        gap = min(along, wall.length - along) - body.size[1] / 2
        base = _below(survey, body)
        if gap < corner - 0.02 and wall.length > body.size[1] + 2 * corner:
            yield breach(
                "art_corner",
                (body.id,),
                f"{body.id} hangs {max(0.0, gap):.2f} m from the corner of the room",
                measured=gap,
                allowed=(corner, None),
                suggestion=f"hang {body.id} further from the corner",
            )
        if base is not None and body.item.category not in ("wall_mirror", "round_mirror", "gym_mirror"):
            yield from _width(survey, body, base)
        yield from _height(body, base)


def _below(survey: Survey, body: Body) -> Body | None:
    """The furniture that something hangs over."""
    for other, _ in survey.near(body, 0.3):
        lower = other.item.category in OVER and other.item.mount == "floor" and other.z[1] < body.z[1]
        if lower and abs(other.local(body.centre)[1]) < other.size[1] / 2:
            return other
    return None


def _width(survey: Survey, body: Body, base: Body) -> Iterator[Finding]:
    """Art that is much narrower, or wider, than what it hangs over; pictures beside each other count together."""
    row = [b for b in survey.of_kind(HUNG) if b.item.mount == "wall" and _below(survey, b) is base]
    if body is not row[0]:
        return
    sides = [base.local(b.centre)[1] + s * b.size[1] / 2 for b in row for s in (-1, 1)]
    share = (max(sides) - min(sides)) / base.size[1]
    low, high = limit("art_width", "share"), limit("art_width", "most")
    if not low - 0.1 <= share <= high:
        yield breach(
            "art_width",
            (body.id, base.id),
            f"{body.id} is {share:.0%} as wide as {base.id}, over which it hangs",
            measured=share,
            allowed=(low, high),
            suggestion=f"hang art over {base.id} that is two thirds as wide",
        )


def _height(body: Body, base: Body | None) -> Iterator[Finding]:
    low, high = limit("art_height", "low"), limit("art_height", "high")
    middle = (body.z[0] + body.z[1]) / 2
    if body.item.category not in ("picture", "poster", "photo_frames", "tapestry") or low <= middle <= high:
        return
    if base is not None and 0.05 <= body.z[0] - base.z[1] <= 0.45:
        return
    yield breach(
        "art_height",
        (body.id,),
        f"the middle of {body.id} is {middle:.2f} m above the floor",
        measured=middle,
        allowed=(low, high),
        suggestion=f"hang {body.id} with its middle at 1.5 m",
    )


# ---- curtains --------------------------------------------------------------------------------------------------------


def _curtains(survey: Survey, opening: Opening) -> Iterator[Finding]:
    """Curtains before a window that hang beside it, or are too narrow for it."""
    window, wall = opening.item, opening.wall
    assert isinstance(window, Window)
    middle = window.offset + window.width / 2
    spans: list[tuple[Body, float, float]] = []
    for body in survey.of_kind(CURTAINS):
        along, depth = wall.coordinates(body.centre)
        if depth < 0.5 and abs(along - middle) < (window.width + body.size[1]) / 2:
            spans.append((body, along - body.size[1] / 2, along + body.size[1] / 2))
    if not spans:
        return
    ids = [body.id for body, *_ in spans]
    left, right = min(s[1] for s in spans), max(s[2] for s in spans)
    off = abs((left + right) / 2 - middle)
    beyond = min(window.offset - left, right - window.offset - window.width)
    most, least = limit("curtain_centred", "offset"), limit("curtain_width", "beyond")
    if off > most:
        yield breach(
            "curtain_centred",
            (*ids, window.id),
            f"{ids[0]} hangs {off:.2f} m off the middle of {window.id}",
            measured=off,
            allowed=(None, most),
            suggestion=f"hang {ids[0]} over the middle of {window.id}",
        )
    elif beyond < least - 0.06:
        yield breach(
            "curtain_width",
            (*ids, window.id),
            f"{ids[0]} reaches {beyond:.2f} m beyond {window.id}",
            measured=beyond,
            allowed=(least, None),
            suggestion=f"take a wider curtain for {window.id}",
        )
    else:
        top, pane = max(body.z[1] for body, *_ in spans), window.sill + window.height
        if top < pane:
            yield breach(
                "curtain_width",
                (*ids, window.id),
                f"the rod of {ids[0]} hangs {pane - top:.2f} m below the top of {window.id}",
                measured=top,
                allowed=(pane, None),
                suggestion=f"take a longer curtain for {window.id}",
            )
