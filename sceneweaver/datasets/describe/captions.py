"""Captions of a scene in three lengths: a line, a paragraph, a list by place."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from sceneweaver.verify.solids import Body

from .facts import FLAT, Facts, is_seat, is_watcher
from .naming import Statement, Text, Words, counted, joined, listed, noun, number, room_noun, said, with_article


class Captioner(Words):
    """The captions of one scene."""

    def short(self) -> Text:
        """One line."""
        kind = room_noun(self.facts.scene.room.type)
        area = round(self.facts.area)
        most = 3 + int(self.rng.integers(2))
        chosen = self.main()[:most]
        parts = [self.group(c, bodies, looks=len(bodies) == 1) for c, bodies in chosen]
        things = listed([p.words for p in parts])
        statements = [Statement("room_type", (), self.facts.scene.room.type)]
        if self.rng.random() < 0.5:
            start = (
                f"{with_article(kind)} of {area} m²" if self.rng.random() < 0.5 else with_article(f"{area} m² {kind}")
            )
            statements.append(Statement("floor_area", (), area))
        else:
            start = with_article(kind)
        words = f"{start} with {things}" if things else start
        facts = [s for p in parts for s in p.statements]
        return said(words, *statements, *self.totals([b for _, bs in chosen for b in bs]), *facts)

    def paragraph(self) -> Text:
        """Some sentences: the room, the main furniture, where it is, what lies on it."""
        sentences = [
            self._room(),
            self._openings(),
            self._furniture(),
            *relations_told(self),
            *self._arrangements(),
        ]
        return joined([s for s in sentences if s is not None])

    def _room(self) -> Text:
        facts, room = self.facts, self.facts.scene.room
        kind = room_noun(room.type)
        area = round(facts.area, 1)
        stated = [Statement("room_type", (), room.type), Statement("floor_area", (), area)]
        sides = rectangle_sides(facts)
        fields = {"kind": kind, "a_kind": with_article(kind), "area": area}
        if sides is None:
            corners = len(room.outline)
            words = self.say("caption_corners", corners=number(corners), **fields)
            return said(words, *stated, Statement("corners", (), corners))
        words = self.say("caption_room", a=sides[0], b=sides[1], **fields)
        return said(words, *stated, Statement("extent", (), list(sides)))

    def _openings(self) -> Text | None:
        facts = self.facts
        doors, windows = facts.placed.doors, facts.placed.windows
        if not doors:
            return None
        stated = [Statement("doors", tuple(d.item.id for d in doors), len(doors))]
        stated.append(Statement("windows", tuple(w.item.id for w in windows), len(windows)))
        words = {
            noun: with_article(noun[:-1]) if len(there) == 1 else f"{number(len(there))} {noun}"
            for noun, there in (("doors", doors), ("windows", windows))
        }
        if not windows:
            return said(self.say("caption_doors", **words), *stated)
        walls = {w.wall.index for w in windows}
        side = _side(facts, next(iter(walls))) if facts.door is not None and len(walls) == 1 else None
        if side is None:
            return said(self.say("caption_openings", **words), *stated)
        stated.append(Statement("window_side", tuple(w.item.id for w in windows), side))
        return said(self.say("caption_side", side=side, **words), *stated)

    def _furniture(self) -> Text | None:
        chosen = self.main()[:6]
        if not chosen:
            return None
        parts = [self.group(c, bodies) for c, bodies in chosen]
        things = listed([p.words for p in parts])
        be = "is" if sum(len(bodies) for _, bodies in chosen) == 1 else "are"
        words = self.say("caption_furniture", things=things, be=be)
        facts = [s for p in parts for s in p.statements]
        return said(words, *self.totals([b for _, bs in chosen for b in bs]), *facts)

    def _arrangements(self) -> list[Text]:
        """What rests on the largest carriers."""
        facts = self.facts
        carriers = [(facts.by_id[c], how, things) for (c, how), things in facts.carried.items() if c in self.names]
        carriers = sorted(carriers, key=lambda row: (-len(row[2]), row[0].id, row[1]))[:5]
        return [self.resting(*carrier) for carrier in self.shuffled(carriers)[:2]]

    def by_place(self) -> list[dict[str, Any]]:
        """All that there is, by where it is: walls, the rest of the floor, each carrier, ceiling."""
        facts = self.facts
        places: dict[str, list[Body]] = defaultdict(list)
        hung: dict[str, list[Body]] = defaultdict(list)
        for body in facts.bodies:
            wall = facts.wall_at(body) if body.item.mount in ("floor", "wall") else None
            name = facts.wall_names.get(wall) if wall is not None else None
            if body.item.mount == "wall":
                hung[name or "a wall"].append(body)
            elif body.item.mount == "ceiling":
                places["on the ceiling"].append(body)
            elif body.item.mount == "floor":
                flat = body.z[1] <= FLAT
                places["on the floor" if flat else f"along {name}" if name else "elsewhere in the room"].append(body)
        rows = []
        for place, bodies in [*places.items(), *((f"hanging on {n}", b) for n, b in hung.items())]:
            text = self.inventory(bodies, looks=True)
            rows.append(_at(place, text, self._placed(place, bodies)))
        for (carrier, how), things in facts.carried.items():
            body = facts.by_id[carrier]
            named = carrier in self.names
            where = self.name(body) if named else with_article(noun(body.item.category))
            text = self.inventory(things)
            stated = (Statement(f"rests_{how}", (b.id, carrier)) for b in things)
            rows.append(_at(f"{how} {where}", text, stated))
        return rows

    def _placed(self, place: str, bodies: Sequence[Body]) -> tuple[Statement, ...]:
        predicate = {"on the ceiling": "on_ceiling", "on the floor": "on_floor", "elsewhere in the room": "on_floor"}
        kind = predicate.get(place, "along_wall" if place.startswith("along") else "on_wall")
        wall = [k for k, name in self.facts.wall_names.items() if place.endswith(name)]
        return tuple(Statement(kind, (b.id,), f"wall:{wall[0]}" if wall else None) for b in bodies)


def _at(place: str, text: Text, stated: Iterable[Statement]) -> dict[str, Any]:
    """What there is at a place, as JSON data."""
    found = Text(f"{place[0].upper()}{place[1:]}: {text.words}.", (*stated, *text.statements))
    return {"place": place, **found.to_dict()}


def rectangle_sides(facts: Facts) -> tuple[float, float] | None:
    """The sides of a rectangular room [m], the longer first, to 0.1 m; None for another shape."""
    walls = facts.placed.walls
    if len(walls) != 4 or any(abs(np.dot(w.along, walls[k - 1].along)) > 0.01 for k, w in enumerate(walls)):
        return None
    a, b = sorted((round(walls[0].length, 1), round(walls[1].length, 1)), reverse=True)
    return a, b


def _side(facts: Facts, wall: int) -> str | None:
    """Where a wall is for who comes in: "on the left"; None for one that looks another way."""
    if facts.doorway is None:
        return None
    _, inward, left = facts.doorway
    outward = facts.placed.walls[wall].outward
    for words, direction in {"straight ahead": inward, "on the left": left, "on the right": -left}.items():
        if float(np.dot(outward, direction)) > 0.94:
            return words
    return None


def captions(facts: Facts, seed: int) -> dict[str, Any]:
    """The captions of a scene as JSON data, each with the facts that it states.

    Args:
        facts: the scene.
        seed: what is drawn: wording, and which of the facts are told.
    """
    writer = Captioner(facts, np.random.default_rng(seed))
    return {
        "schema": "sceneweaver.captions/1",
        "short": writer.short().to_dict(),
        "paragraph": writer.paragraph().to_dict(),
        "by_place": writer.by_place(),
    }


MOST = 6
"""Sentences that are told of one room."""

LOW = 0.55
"""Height [m] below which a table is stood by, not sat at."""

_CONNECTED = ("front_against", "front_to_front", "around", "seated_at")


def relations_told(w: Words) -> list[Text]:
    """Where the main furniture is, each thing said once."""
    found: list[Text] = []
    found += list(_gatherings(w))[:2]
    kinds = (_walls, _facings, _sides, _betweens, _from_door)
    for kind in w.shuffled(kinds):
        found += list(kind(w))[:2]
    return w.shuffled(found)[:MOST]


def _walls(w: Words) -> Iterator[Text]:
    facts = w.facts
    by_wall: dict[int, list[Body]] = defaultdict(list)
    for body in w.furniture:
        wall = facts.wall_at(body, 0.9)
        if wall in facts.wall_names and facts.holds("against_wall", body, f"wall:{wall}"):
            by_wall[wall].append(body)
    for wall, bodies in sorted(by_wall.items(), key=lambda row: -sum(b.size[1] for b in row[1])):
        bodies = bodies[:3]
        stated = [Statement("against_wall", (b.id,), f"wall:{wall}") for b in bodies]
        verb = "stands" if len(bodies) == 1 else "stand"
        things = listed([w.names[b.id].text for b in bodies])
        words = w.say("caption_wall", things=things, stand=verb, wall=facts.wall_names[wall])
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
    for a in filter(is_watcher, w.furniture):
        for b in (b for b in facts.bodies if b.id in w.names and b.item.mount in ("floor", "wall") and b is not a):
            apart = math.dist(a.centre, b.centre)
            if b.z[1] - b.z[0] > 0.2 and 0.6 < apart < 4.5 and facts.holds("facing", a, b.id, degrees=10):
                words = f"{w.names[a.id].text} faces {w.names[b.id].text}"
                yield said(words, Statement("facing", (a.id, b.id)))
                break


def _sides(w: Words) -> Iterator[Text]:
    """What is next to what, without left or right, which are another's for each viewer."""
    facts = w.facts
    main = w.furniture[:10]
    for k, b in enumerate(main):
        for a in main[k + 1 :]:
            if facts.boxes_apart(a, b) < 0.3 and (apart := facts.distance(a, b)) < 0.3 and not _over(a, b):
                words = f"{w.names[a.id].text} is next to {w.names[b.id].text}"
                if apart < 0.25 and frozenset((a.id, b.id)) not in w.told:
                    yield said(words, Statement("near", (a.id, b.id), {"max": 0.3}))
                    break


def _betweens(w: Words) -> Iterator[Text]:
    facts = w.facts
    main = w.furniture[:7]
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
    for body in w.furniture:
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
