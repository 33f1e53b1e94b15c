"""Groups that a request tells thing by thing, as rigid units: each member has its place in the frame of the first.

Things that face each other, stand side by side or have another between them say where they are to each other, and not
where in the room. They are composed in a frame of their own, which the search moves as one body; what keeps them from
it, such as two walls that they are told to be at, leaves them to the search one by one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from sceneweaver.assets.roles import has_role
from sceneweaver.knowledge.desk_sides import desk_side
from sceneweaver.language import SceneGraph, StatedRelation
from sceneweaver.language.vocabulary import family

from .patterns import Spot, seen_from, within
from .program import Wanted

SLACK = 0.04
"""Gap [m] on either side of what stands between two things."""

LEGROOM = 0.44
"""Way [m] between a lounge seat and the low table before it."""

TALK, MEET = 1.5, 1.1
"""Gaps [m] between the fronts of lounge seats that face each other, and of other things."""

BESIDE, CLOSE = 0.12, 0.03
"""Gaps [m] between neighbours that nobody steps between: of seats and tables, and of things alike in a line."""

PUSHED = 0.01
"""Gap [m] between desks whose users face each other."""

TUCKED = -0.1
"""Gap [m] between a chair and the table that it is at."""

WIDE_SEAT, LOW, LONG = 1.25, 0.6, 1.3
"""Width [m] of a seat that others sit opposite of, height of a table before lounge seats, and depth of a thing beside
which others stand at its back: a bed."""

FIRE = 1.2
"""Gap [m] between a fire, or what else hangs or stands at a wall, and the seats about it."""

INTO = 0.01
"""Overlap [m] of bodies that counts as none."""

_BOUND = ("wall", "window", "door", "corner", "middle")
"""Places that one group is not at two of."""


@dataclass(frozen=True)
class Unit:
    """A group: the leader, and each other member with its spot in the leader's frame and the statement behind it.

    ``turned`` are the ids of members whose front is fixed by the group.
    """

    leader: Wanted
    spots: tuple[tuple[Wanted, Spot, str], ...]
    turned: frozenset[str]

    @property
    def ids(self) -> frozenset[str]:
        """The ids of all members."""
        return frozenset((self.leader.id, *(one.id for one, _, _ in self.spots)))


@dataclass
class _Plan:
    """Frames that grow together: by id of a thing its frame, named by one of its members, and its spot there.

    ``said`` is the statement behind each place, ``turned`` are those whose front it fixes, ``held`` are between others.
    """

    brief: SceneGraph
    things: dict[str, Wanted]
    made: dict[str, list[Wanted]]
    bound: dict[str, set[str]]
    at: dict[str, tuple[str, Spot]] = field(default_factory=dict)
    said: dict[str, str] = field(default_factory=dict)
    turned: set[str] = field(default_factory=set)
    held: set[str] = field(default_factory=set)

    def where(self, one: Wanted) -> tuple[str, Spot]:
        return self.at.get(one.id, (one.id, Spot(0.0, 0.0)))

    def members(self, root: str) -> list[Wanted]:
        return [self.things[name] for name, (r, _) in self.at.items() if r == root] or [self.things[root]]

    def together(self, a: Wanted, b: Wanted) -> bool:
        return self.where(a)[0] == self.where(b)[0]

    def spot(self, b: Wanted, a: Wanted) -> Spot:
        """The place of a member in the frame of another of the same group."""
        return seen_from(self.where(a)[1], self.where(b)[1])

    def put(self, one: Wanted, base: Wanted, spot: Spot, said: str) -> bool:
        """Sets a thing, with all that has its place by it, at a spot in the frame of another; whether that can be."""
        root, here = self.where(base)
        other, own = self.where(one)
        if root == other:
            return False
        bounds = [self.bound.get(m.id, set()) for r in (root, other) for m in self.members(r)]
        if len(set().union(*bounds)) > 1:
            return False
        target = within(here, spot)
        shift = within(target, seen_from(own, Spot(0.0, 0.0)))
        moved = {m.id: within(shift, self.where(m)[1]) for m in self.members(other)}
        stay = [(m, self.where(m)[1]) for m in self.members(root)]
        if any(_meet(self.things[name], at, m, s) for name, at in moved.items() for m, s in stay):
            return False
        self.at[root] = self.where(self.things[root])
        for name, at in moved.items():
            self.at[name] = (root, at)
        self.said[one.id] = said
        self.said.setdefault(base.id, said)
        return True


def _meet(a: Wanted, at: Spot, b: Wanted, other: Spot) -> bool:
    """Whether two bodies are in each other."""
    import shapely

    return bool(shapely.area(shapely.intersection(_box(a, at), _box(b, other))) > INTO * min(a.asset.size[:2]))


def _box(one: Wanted, at: Spot):
    import shapely

    d, w, _ = one.asset.size
    d, w = d - 2 * INTO, w - 2 * INTO
    corners = [within(at, Spot(x / 2, y / 2)) for x, y in ((-d, -w), (d, -w), (d, w), (-d, w))]
    return shapely.Polygon([(p.ahead, p.left) for p in corners])


def composed(
    brief: SceneGraph,
    wanted: Sequence[Wanted],
    patterns: Sequence[Sequence[tuple[Wanted, Spot]]] = (),
) -> list[Unit]:
    """The groups of a request.

    Args:
        brief: the request.
        wanted: the objects to be.
        patterns: things with their spots in the frame of the first, which are laid out already.
    """
    free = {w.id: w for w in wanted if w.mount == "floor" and w.support is None and not w.thing.is_flat}
    made: dict[str, list[Wanted]] = {}
    for one in free.values():
        made.setdefault(one.asked or "", []).append(one)
    bound: dict[str, set[str]] = {}
    for said in brief.relations:
        if said.targets and said.targets[0].partition(":")[0] in _BOUND and said.type not in ("facing", "opposite"):
            for one in made.get(said.subject, ()):
                bound.setdefault(one.id, set()).add(said.targets[0])
    plan = _Plan(brief, free, made, bound)
    for spots in patterns:
        plan.at |= {one.id: (spots[0][0].id, spot) for one, spot in spots if one.id in free}
    for step in (_beside, _facing, _about):
        for said in brief.relations:
            if not said.implied:
                step(plan, said)
    for said in _parting(brief):
        _between(plan, said)
    return list(_units(plan, {one.id for spots in patterns for one, _ in spots}))


def _units(plan: _Plan, patterned: set[str]) -> Iterator[Unit]:
    for root in dict.fromkeys(r for r, _ in plan.at.values()):
        members = plan.members(root)
        fresh = [m for m in members if m.id in plan.said]
        if not fresh or len(members) < 2:
            continue
        inside = {m.id for m in members}
        named = {m.asked for m in members}
        tied = {
            m.id for r in plan.brief.relations if set(r.targets) - named for m in plan.made.get(r.subject, ())
        }  # what is said of a member and of what is no member is said of the group
        led = [m for m in members if m.id == root] if root in patterned else []
        leader = (led or sorted(members, key=lambda m: (m.id in plan.held, m.id not in tied, -m.footprint)))[0]
        spots = [
            (m, plan.spot(m, leader), plan.said.get(m.id, ""))
            for m in members
            if m is not leader and not (m.id in patterned and led and m.id not in plan.said)
        ]
        yield Unit(leader, tuple(spots), frozenset(plan.turned & inside))


# ---- side by side ----------------------------------------------------------------------------------------------------


def _beside(plan: _Plan, said: StatedRelation) -> None:
    """What is side by side, in the order in which it is named."""
    if said.type != "side_by_side" or not said.targets:
        return
    subjects = plan.made.get(said.subject, [])
    targets = [one for name in said.targets if name != said.subject for one in plan.made.get(name, ())]
    for one, two in _pairs(subjects, targets) if targets else zip(subjects, subjects[1:], strict=False):
        _next(plan, one, two, said.id)


def _pairs(ones: Sequence[Wanted], twos: Sequence[Wanted]) -> Iterator[tuple[Wanted, Wanted]]:
    return zip(ones, twos, strict=False)


def _next(plan: _Plan, one: Wanted, two: Wanted, said: str, least: float = 0.0) -> bool:
    """Sets a thing at the end of the row that another is in."""
    if plan.together(one, two):
        return False
    between = [b for a in (one, two) for b in _told_between(plan, a) if {one.asked, two.asked} >= _ends(plan, b)]
    gap = max([least, _gap_beside(one, two), *(b.asset.size[1] + 2 * SLACK for b in between)])
    end = max(
        (plan.spot(m, one).left for m in plan.members(plan.where(one)[0]) if _level(plan.spot(m, one))), default=0
    )
    start = min(
        (plan.spot(m, two).left for m in plan.members(plan.where(two)[0]) if _level(plan.spot(m, two))), default=0
    )
    left = end - start + (one.asset.size[1] + two.asset.size[1]) / 2 + gap
    ahead = (two.asset.size[0] - one.asset.size[0]) / 2  # with the backs in line
    return plan.put(two, one, Spot(ahead, left), said)


def _level(spot: Spot) -> bool:
    return abs(spot.ahead) < 0.5 and abs(spot.turn) < 1.0


def side_way(one: Wanted) -> float:
    """How far [m] the room that a thing needs reaches beyond its left or right."""
    return max(_clear(one, "left"), _clear(one, "right"))


def front_way(one: Wanted) -> float:
    """How far [m] the room that a thing needs reaches before its front."""
    half = one.asset.size[0] / 2
    return max((p[0] - half for zone in one.asset.zones if zone.hard for p in zone.polygon), default=0.0)


def told_between(brief: SceneGraph, name: str) -> set[str]:
    """The entities that a request has between things of one entity, or between these and others."""
    return {said.subject for said in _parting(brief) if name in said.targets}


def _parting(brief: SceneGraph) -> Iterator[StatedRelation]:
    """What is said to be between, as relations: one thing, or one in each gap."""
    yield from (said for said in brief.relations if said.type == "between")
    for one in brief.arrangements:
        if one.pattern == "between":
            yield StatedRelation(id=one.id, type="between", subject=one.entity, targets=(one.around,), each=True)


def _gap_beside(one: Wanted, two: Wanted) -> float:
    """The gap [m] between two things side by side: as much as who gets in from a side needs."""
    ways = [_clear(one, "left"), _clear(two, "right")]
    if max(ways) > 0.0:
        return max(ways) + 0.01
    alike = one.category == two.category and family(one.category) not in ("seat", "table")
    return CLOSE if alike else BESIDE


def _clear(one: Wanted, side: str) -> float:
    """How far [m] the room that a thing needs reaches beyond its left or right side."""
    sign, half = (1.0 if side == "left" else -1.0), one.asset.size[1] / 2
    reach = [sign * p[1] - half for zone in one.asset.zones if zone.hard and zone.name == side for p in zone.polygon]
    return max(reach, default=0.0)


# ---- facing ----------------------------------------------------------------------------------------------------------


def _facing(plan: _Plan, said: StatedRelation) -> None:
    """What faces each other; seats that face a seat, or are opposite one."""
    if said.type not in ("facing", "opposite") or len(said.targets) != 1 or said.params:
        return
    ones, twos = plan.made.get(said.targets[0], []), plan.made.get(said.subject, [])
    if said.subject == said.targets[0]:
        if len(ones) % 2 or said.type != "facing":
            return
        ones, twos = ones[: len(ones) // 2], ones[len(ones) // 2 :]
    mutual = any(
        r.type == said.type and r.subject == said.targets[0] and r.targets == (said.subject,)
        for r in plan.brief.relations
    )
    both = (r for r in plan.brief.relations if (r.subject, r.targets) == (said.subject, said.targets))
    if any(r.type in ("next_to", "near", "left_of", "right_of", "behind") for r in both):
        return  # it is told to be elsewhere as well
    if desk_side(said, plan.brief) is not None:
        return  # the desk is between them
    if not ones or not twos or plan.together(ones[0], twos[0]):
        return
    seats = all(family(one.category) == "seat" for one in (*ones, *twos))
    lounge = all(has_role(one.category, "lounge_seat") for one in ones)
    if (mutual and said.type == "facing") or (seats and (lounge or said.type == "facing")):
        _opposite(plan, ones, twos, said.id)


def _opposite(plan: _Plan, ones: Sequence[Wanted], twos: Sequence[Wanted], said: str, gap: float = 0.0) -> bool:
    """Sets a row of things before another, each looking at the other row, middle before middle."""
    for row in (ones, twos):
        for a, b in zip(row, row[1:], strict=False):
            if not plan.together(a, b) and not _next(plan, a, b, said):
                return False
    one, two = ones[0], twos[0]
    desks = has_role(one.category, "desk") and has_role(two.category, "desk")
    between = [b for a in (*ones, *twos) for b in _told_between(plan, a)]
    deep = max((b.asset.size[0] for b in between), default=0.0)
    room = LEGROOM if has_role(one.category, "lounge_seat") else SLACK
    usual = PUSHED if desks else TALK if has_role(one.category, "lounge_seat") else MEET
    gap = gap or max(_stated_gap(plan, one, two), deep + 2 * room if deep else usual)
    way = -1.0 if desks else 1.0  # who sits at a desk is before its front
    aside = _middle(plan, ones) + _middle(plan, twos)
    ahead = way * (one.asset.size[0] / 2 + gap + two.asset.size[0] / 2)
    done = plan.put(two, one, Spot(ahead, aside, 180.0), said)
    if done:
        plan.turned |= {thing.id for thing in (*ones, *twos)}
    return done


def _middle(plan: _Plan, row: Sequence[Wanted]) -> float:
    """How far [m] to the left of the first of a row its middle is."""
    spots = [(plan.spot(one, row[0]).left, one.asset.size[1] / 2) for one in row]
    return (max(at + half for at, half in spots) + min(at - half for at, half in spots)) / 2


def _stated_gap(plan: _Plan, one: Wanted, two: Wanted) -> float:
    """The gap [m] that the request has between two things as free floor; 0 where it says none."""
    names = {one.asked, two.asked}
    gaps = [a.size[0] for a in plan.brief.free_areas if a.kind == "gap" and set(a.targets) == names]
    return max(gaps, default=0.0)


# ---- around ----------------------------------------------------------------------------------------------------------


def _about(plan: _Plan, said: StatedRelation) -> None:
    """Seats around what is at a wall: a fire. On an arc before it, all looking at it."""
    if said.type != "around" or len(said.targets) != 1 or said.each:
        return
    seats, hosts = plan.made.get(said.subject, []), plan.made.get(said.targets[0], [])
    if len(hosts) != 1 or len(seats) < 2 or family(seats[0].category) != "seat":
        return
    host = hosts[0]
    if host.thing.is_table or not host.wall or any(seat.id in plan.at for seat in seats):
        return  # seats of a pattern have their places to it already
    d, w, _ = seats[0].asset.size
    n = len(seats)
    step = min(math.radians(140) / max(1, n - 1), math.radians(50))
    away = max(host.asset.size[0] / 2 + FIRE, (w + BESIDE) / (2 * math.tan(step / 2))) + d / 2
    for k, seat in enumerate(seats):
        angle = step * (k - (n - 1) / 2)
        spot = Spot(away * math.cos(angle), away * math.sin(angle), math.degrees(angle) + 180.0)
        if plan.put(seat, host, spot, said.id):
            plan.turned.add(seat.id)


# ---- between ---------------------------------------------------------------------------------------------------------


def _told_between(plan: _Plan, one: Wanted) -> list[Wanted]:
    """What the request has between a thing and another."""
    return [
        thing for said in _parting(plan.brief) if one.asked in said.targets for thing in plan.made.get(said.subject, ())
    ]


def _ends(plan: _Plan, one: Wanted) -> set[str]:
    return {name for said in _parting(plan.brief) if said.subject == one.asked for name in said.targets}


def _between(plan: _Plan, said: StatedRelation) -> None:
    """What is between two things, one for each two neighbours where there are as many."""
    if not all(plan.made.get(name) for name in said.targets):
        return
    pools = [plan.made[name] for name in dict.fromkeys(said.targets)]
    if len(pools) == 1:
        pairs = list(_neighbours(plan, pools[0]))
    elif len(pools) == 2:
        pairs = list(_pairs(*pools))
    else:
        return
    for thing, (a, b) in zip(plan.made.get(said.subject, ()), pairs, strict=False):
        if not plan.together(a, b):
            _bring(plan, thing, a, b, said.id)
        if not plan.together(a, b) or plan.together(thing, a):
            continue
        if plan.put(thing, a, _spot_between(plan, thing, a, b), said.id):
            plan.held.add(thing.id)


def _neighbours(plan: _Plan, things: Sequence[Wanted]) -> Iterator[tuple[Wanted, Wanted]]:
    """Each two next to each other: in their rows, where they have places already; else in their order."""
    frames: dict[str, list[Wanted]] = {}
    for one in things:
        frames.setdefault(plan.where(one)[0], []).append(one)
    if len(frames) == len(things) or len(things) == 2:
        yield from zip(things, things[1:], strict=False)
        return
    for members in frames.values():
        spots = {m.id: plan.spot(m, members[0]) for m in members}
        lefts, aheads = ({round(s[k], 1) for s in spots.values()} for k in (1, 0))
        along, across = (1, 0) if len(lefts) >= len(aheads) else (0, 1)
        rows: dict[float, list[Wanted]] = {}
        for m in members:
            rows.setdefault(round(spots[m.id][across], 0), []).append(m)
        for row in rows.values():
            row.sort(key=lambda m: spots[m.id][along])
            yield from zip(row, row[1:], strict=False)


def _bring(plan: _Plan, thing: Wanted, a: Wanted, b: Wanted, said: str) -> None:
    """Sets the two that something is between to each other as such things usually are with it."""
    d, w, h = thing.asset.size
    lounge = all(has_role(one.category, "lounge_seat") for one in (a, b))
    seats = all(family(one.category) == "seat" for one in (a, b))
    wide = max(a.asset.size[1], b.asset.size[1]) >= WIDE_SEAT
    if lounge and wide and h < LOW:
        _opposite(plan, [a], [b], said, d + 2 * LEGROOM)
    elif seats and not lounge and thing.thing.is_table:
        _opposite(plan, [a], [b], said, d + 2 * TUCKED)
    elif family(a.category) == family(b.category) and (
        seats or a.category == b.category or family(a.category) == "bed_group"
    ):
        across = d if _is_divider(thing) else w
        _next(plan, a, b, said, across + 2 * SLACK)


def _is_divider(thing: Wanted) -> bool:
    """Whether a thing parts what is at its two faces: it is flat, and higher than one sees over sitting."""
    d, w, h = thing.asset.size
    return h > 1.2 and d < 0.25 * w


def _spot_between(plan: _Plan, thing: Wanted, a: Wanted, b: Wanted) -> Spot:
    """The place of a thing between two of a group, in the frame of the first."""
    to = plan.spot(b, a)
    d, w, _ = thing.asset.size
    turned = round(abs(to.turn) / 90.0) % 2 == 1
    if turned:  # at right angles: before both
        side = math.copysign(1.0, to.left)
        ahead = a.asset.size[0] / 2 + LEGROOM + d / 2
        inner = abs(to.left) - b.asset.size[0] / 2
        return Spot(ahead, side * (inner - LEGROOM - w / 2))
    if abs(to.ahead) > abs(to.left):  # across from each other
        way = math.copysign(1.0, to.ahead)
        low, high = a.asset.size[0] / 2, abs(to.ahead) - b.asset.size[0] / 2
        if abs(to.turn) < 1.0:  # end at end: with its back in line with their right sides
            return Spot(way * (low + high) / 2, (d - a.asset.size[1]) / 2, 90.0)
        return Spot(way * (low + high) / 2, to.left / 2)
    low, high = a.asset.size[1] / 2, abs(to.left) - b.asset.size[1] / 2
    left = math.copysign((low + high) / 2, to.left)
    if _is_divider(thing):
        return Spot(to.ahead / 2, left, 90.0)
    back = a.asset.size[0] >= LONG or a.category == b.category and family(a.category) != "seat"
    return Spot((d - a.asset.size[0]) / 2 if back else to.ahead / 2, left)
