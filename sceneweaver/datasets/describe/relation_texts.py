"""Sentences on where the furniture of a room is: walls, gatherings, what faces, stands between or next to what."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.verify.solids import Body

from .facts import Facts, is_seat, is_watcher
from .nouns import counted, listed
from .statements import Statement, Text, said
from .words import Words

MOST = 6
"""Sentences that are told of one room."""

LOW = 0.55
"""Height [m] below which nobody sits at a table."""

_CONNECTED = ("front_against", "front_to_front", "around", "seated_at")


def relations_told(w: Words) -> list[Text]:
    """Where the main furniture is, each thing said once."""
    found: list[Text] = []
    found += list(_gatherings(w))[:2]
    kinds = (_walls, _facings, _sides, _betweens, _from_door)
    for kind in (kinds[int(k)] for k in w.rng.permutation(len(kinds))):
        for text in list(kind(w))[:2]:
            found.append(text)
    return [found[int(k)] for k in w.rng.permutation(len(found))][:MOST]


def _walls(w: Words) -> Iterator[Text]:
    facts = w.facts
    by_wall: dict[int, list[Body]] = defaultdict(list)
    for body in facts.furniture:
        wall = facts.wall_at(body, 0.9)
        if body.id in w.names and wall in facts.wall_names and facts.holds("against_wall", body, f"wall:{wall}"):
            by_wall[wall].append(body)
    for wall, bodies in sorted(by_wall.items(), key=lambda row: -sum(b.size[1] for b in row[1])):
        bodies = bodies[:3]
        stated = [Statement("against_wall", (b.id,), f"wall:{wall}") for b in bodies]
        verb = "stands" if len(bodies) == 1 else "stand"
        things = listed([w.names[b.id].text for b in bodies])
        words = w.one_of(
            f"{things} {verb} against {facts.wall_names[wall]}", f"against {facts.wall_names[wall]} {verb} {things}"
        )
        yield said(words, *stated)


def _gatherings(w: Words) -> Iterator[Text]:
    """Seats at tables and the like."""
    facts = w.facts
    seats: dict[str, list[Body]] = defaultdict(list)
    for relation in facts.scene.relations:
        if relation.type in _CONNECTED and isinstance(relation.target, str) and relation.target in facts.by_id:
            body, target = facts.by_id[relation.subject], facts.by_id[relation.target]
            near = body.item.mount == "floor" and facts.distance(body, target) < 0.25
            if near and is_seat(body) and body not in seats[target.id]:
                seats[target.id].append(body)
    for target, bodies in seats.items():
        groups = w.groups(bodies)
        if target in w.names and len(groups) == 1 and len(bodies) > 0:
            category, _ = groups[0]
            stated = [Statement("near", (b.id, target), {"max": 0.3}) for b in bodies]
            where = w.names[target].text
            verb = "stands" if len(bodies) == 1 else "stand"
            mine = w.names.get(bodies[0].id) if len(bodies) == 1 else None
            things = mine.text if mine else counted(len(bodies), category)
            w.told.add(frozenset((target, *(b.id for b in bodies))))
            by = "by" if facts.by_id[target].size[2] < LOW else "at"
            yield said(f"{things} {verb} {by} {where}", *stated)


def _facings(w: Words) -> Iterator[Text]:
    facts = w.facts
    for a in (b for b in facts.furniture if b.id in w.names and is_watcher(b)):
        for b in (b for b in facts.bodies if b.id in w.names and b.item.mount in ("floor", "wall") and b is not a):
            apart = math.dist(a.centre, b.centre)
            if b.z[1] - b.z[0] > 0.2 and 0.6 < apart < 4.5 and facts.holds("facing", a, b.id, degrees=10):
                words = f"{w.names[a.id].text} faces {w.names[b.id].text}"
                yield said(words, Statement("facing", (a.id, b.id)))
                break


def _sides(w: Words) -> Iterator[Text]:
    """What is next to what, without left or right, which are another's for each viewer."""
    facts = w.facts
    main = [b for b in facts.furniture if b.id in w.names][:10]
    for k, b in enumerate(main):
        for a in main[k + 1 :]:
            if facts.boxes_apart(a, b) < 0.3 and (apart := facts.distance(a, b)) < 0.3 and not _over(a, b):
                words = f"{w.names[a.id].text} is next to {w.names[b.id].text}"
                if apart < 0.25 and frozenset((a.id, b.id)) not in w.told:
                    yield said(words, Statement("near", (a.id, b.id), {"max": 0.3}))
                    break


def _betweens(w: Words) -> Iterator[Text]:
    facts = w.facts
    main = [b for b in facts.furniture if b.id in w.names][:7]
    for c in main:
        for k, a in enumerate(main):
            for b in main[k + 1 :]:
                if c in (a, b) or not 1.0 < math.dist(a.centre, b.centre) < 3.5:
                    continue
                share, aside = facts.beside_line(c, a, b)
                if 0.3 < share < 0.7 and aside < 0.25:
                    mine, one, other = (w.names[x.id].text for x in (c, a, b))
                    yield said(f"{mine} stands between {one} and {other}", Statement("between", (c.id, a.id, b.id)))
                    return


def _from_door(w: Words) -> Iterator[Text]:
    """What is on the left, on the right and straight ahead of a visitor."""
    facts = w.facts
    sides: dict[str, list[Body]] = defaultdict(list)
    for body in (b for b in facts.furniture if b.id in w.names):
        side = door_side(facts, body)
        if side is not None and len(sides[side]) < 2:
            sides[side].append(body)
    words = {"left": "on the left", "right": "on the right", "ahead": "straight ahead"}
    chosen = [side for side in words if sides[side]]
    predicates = {"left": "left_from_door", "right": "right_from_door", "ahead": "ahead_of_door"}
    if chosen:
        said_of = [
            f"{words[s]} {be} {listed([w.names[b.id].text for b in sides[s]])}"
            for s in chosen
            for be in ["is" if len(sides[s]) == 1 else "are"]
        ]
        stated = [Statement(predicates[s], (b.id,)) for s in chosen for b in sides[s]]
        yield said(f"as you come in, {listed(said_of)}", *stated)


def _over(a: Body, b: Body) -> bool:
    return a.z[0] >= b.z[1] or b.z[0] >= a.z[1]


def door_side(facts: Facts, body: Body) -> str | None:
    """Whether a body is on the "left" or "right" of who comes in, or "ahead"; None between these."""
    place = facts.from_door(body)
    if place is None or place[0] < 0.4:
        return None
    bearing = math.degrees(math.atan2(place[1], place[0]))
    if abs(bearing) < 10:
        return "ahead"
    return "left" if bearing > 25 else "right" if bearing < -25 else None
