"""What gives way where no plan is found: programmes that ask for less and less, in a stated order."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sceneweaver.home import Home
from sceneweaver.language.homes import HomeRequest
from sceneweaver.plans import Profile, Programme, RoomSpec, check_plan

WIDER = (0.1, 0.2)
"""Shares by which areas give way, one after the other."""


@dataclass(frozen=True)
class Softer:
    """A programme that asks for less.

    Attributes:
        programme: what is solved.
        line: what gave way.
        own_envelope: whether sides of the plan that were asked for gave way as well.
    """

    programme: Programme
    line: str
    own_envelope: bool = False


def softer(programme: Programme, request: HomeRequest | None = None) -> Iterator[Softer]:
    """Programmes that ask for less, each for less than the one before.

    First what is merely wished of rooms to each other gives way, then areas by 10 and by 20 %, then doors that were
    assumed, those that were asked for, and at last the sides of the plan. What changes nothing is left out. Hard rows
    of the profile never give way.

    Args:
        programme: of which no plan was found.
        request: what it was read from; None: all of it was asked for.

    Examples:
        >>> from sceneweaver.furnish.giving_way import softer
        >>> from sceneweaver.plans import Programme
        >>> [step.line for step in softer(Programme.example("flat-2-bedrooms"))][1:3]
        ['areas give way by 10 %', 'areas give way by 20 %']
    """
    hard = tuple(x for x in programme.adjacencies if x.hard)
    if len(hard) < len(programme.adjacencies):
        programme = programme.model_copy(update={"adjacencies": hard})
        yield Softer(programme, "what is wished of rooms to each other gives way")
    firm = programme
    for share in WIDER:
        programme = firm.model_copy(update={"rooms": tuple(_wider(room, share) for room in firm.rooms)})
        yield Softer(programme, f"areas give way by {share:.0%}".replace("%", " %"))
    asked = _pairs_asked(request)
    kept = tuple(x for x in hard if request is None or frozenset((x.a, x.b)) in asked)
    for fewer, line in ((kept, "doors that were assumed give way"), ((), "doors that were asked for give way")):
        if len(fewer) < len(programme.adjacencies):
            programme = programme.model_copy(update={"adjacencies": fewer})
            yield Softer(programme, line)
    if request is not None and (request.width or request.depth or request.l_shape or request.window_sides):
        yield Softer(programme, "sides and shape of the plan give way", own_envelope=True)


def missed(asked: Programme, home: Home, profile: Profile | str, told: Collection[str]) -> tuple[list[str], list[str]]:
    """What of a programme a plan does not have, by the exact checker: what was asked for, and what was a default.

    Args:
        asked: the programme before anything gave way.
        home: the plan.
        profile: of its rules.
        told: ids of rooms whose area was asked for.
    """
    wanted, default = list[str](), list[str]()
    for violation in check_plan(home, asked, profile).violations:
        if violation.rule == "programme-area":
            (wanted if {*violation.rooms} & {*told} else default).append(violation.detail)
        elif violation.rule.startswith("programme-"):
            wanted.append(violation.detail)
    return wanted, default


def areas_asked(request: HomeRequest | None, programme: Programme) -> frozenset[str]:
    """Ids of the rooms whose size was said; all where there is no request."""
    if request is None:
        return frozenset(room.id for room in programme.rooms)
    return frozenset(room.id for room in request.rooms if room.area is not None or room.size or room.equal)


def _wider(room: RoomSpec, share: float) -> RoomSpec:
    least, target, most = room.area
    area = (round(least * (1 - share), 2), target, round(most * (1 + share), 2))
    side = None if room.side is None else round(room.side * (1 - share / 2), 2)
    return room.model_copy(update={"area": area, "side": side})


def _pairs_asked(request: HomeRequest | None) -> frozenset[frozenset[str]]:
    """Pairs of rooms of which the request says something."""
    joints = request.joints if request is not None else ()
    return frozenset(frozenset(pair) for joint in joints for pair in zip(joint.a, joint.b, strict=False))
