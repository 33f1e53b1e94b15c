"""Captions of a scene in three lengths: a line, a paragraph, a list by place."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import Any

import numpy as np

from sceneweaver.verify.solids import Body

from .facts import FLAT, Facts
from .nouns import listed, noun, number, room_noun, with_article
from .relation_texts import relations_told
from .statements import Statement, Text, joined, said
from .words import Words


class Captioner:
    """The captions of one scene."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        self.facts = facts
        self.rng = rng
        self.words = Words(facts, rng)

    def short(self) -> Text:
        """One line."""
        kind = room_noun(self.facts.scene.room.type)
        area = round(self.facts.area)
        most = 3 + int(self.rng.integers(2))
        chosen = self.words.main()[:most]
        parts = [self.words.group(c, bodies, looks=len(bodies) == 1) for c, bodies in chosen]
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
        return said(words, *statements, *self.words.totals([b for _, bs in chosen for b in bs]), *facts)

    def paragraph(self) -> Text:
        """Some sentences: the room, the main furniture, where it is, what lies on it."""
        sentences = [
            self._room(),
            self._openings(),
            self._furniture(),
            *relations_told(self.words),
            *self._arrangements(),
        ]
        return joined([s for s in sentences if s is not None])

    def _room(self) -> Text:
        facts, room = self.facts, self.facts.scene.room
        kind = room_noun(room.type)
        area = round(facts.area, 1)
        stated = [Statement("room_type", (), room.type), Statement("floor_area", (), area)]
        sides = rectangle_sides(facts)
        if sides is None:
            words = self.words.one_of(
                f"this {kind} has a floor of {area:g} m² with {number(len(room.outline))} corners",
                f"the floor of this {kind} covers {area:g} m² and has {number(len(room.outline))} corners",
            )
            return said(words, *stated, Statement("corners", (), len(room.outline)))
        a, b = sides
        stated.append(Statement("extent", (), [a, b]))
        words = self.words.one_of(
            f"this {kind} is {a:g} m by {b:g} m, which makes {area:g} m²",
            f"the {kind} measures {a:g} by {b:g} metres ({area:g} m²)",
            f"this is {with_article(kind)} of {area:g} m², {a:g} m long and {b:g} m wide",
        )
        return said(words, *stated)

    def _openings(self) -> Text | None:
        facts = self.facts
        doors, windows = facts.placed.doors, facts.placed.windows
        if not doors:
            return None
        stated = [Statement("doors", tuple(d.item.id for d in doors), len(doors))]
        stated.append(Statement("windows", tuple(w.item.id for w in windows), len(windows)))
        door_words = with_article("door") if len(doors) == 1 else f"{number(len(doors))} doors"
        if not windows:
            return said(
                self.words.one_of(f"it has {door_words} and no window", f"there is no window, but {door_words}"),
                *stated,
            )
        window_words = with_article("window") if len(windows) == 1 else f"{number(len(windows))} windows"
        walls = {w.wall.index for w in windows}
        if facts.door is not None and len(walls) == 1:
            side = _side(facts, next(iter(walls)))
            if side is not None:
                stated.append(Statement("window_side", tuple(w.item.id for w in windows), side))
                return said(
                    self.words.one_of(
                        f"it has {door_words}, and {window_words} {side}",
                        f"coming in through the door, you see {window_words} {side}",
                    ),
                    *stated,
                )
        return said(f"it has {door_words} and {window_words}", *stated)

    def _furniture(self) -> Text | None:
        chosen = self.words.main()[:6]
        if not chosen:
            return None
        parts = [self.words.group(c, bodies) for c, bodies in chosen]
        things = listed([p.words for p in parts])
        be = "is" if sum(len(bodies) for _, bodies in chosen) == 1 else "are"
        words = self.words.one_of(
            f"it is furnished with {things}", f"there {be} {things}", f"the main furniture is {things}"
        )
        facts = [s for p in parts for s in p.statements]
        return said(words, *self.words.totals([b for _, bs in chosen for b in bs]), *facts)

    def _arrangements(self) -> list[Text]:
        """What rests on the largest carriers."""
        facts = self.facts
        carriers = [
            (facts.by_id[c], how, things) for (c, how), things in facts.carried.items() if c in self.words.names
        ]
        carriers = sorted(carriers, key=lambda row: (-len(row[2]), row[0].id, row[1]))[:5]
        found = []
        for k in self.rng.permutation(len(carriers))[:2]:
            body, how, things = carriers[int(k)]
            found.append(self.words.resting(body, how, things))
        return found

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
            text = self.words.inventory(bodies, looks=True)
            rows.append(
                {
                    "place": place,
                    **Text(
                        f"{place[0].upper()}{place[1:]}: {text.words}.",
                        (*self._placed(place, bodies), *text.statements),
                    ).to_dict(),
                }
            )
        for (carrier, how), things in facts.carried.items():
            body = facts.by_id[carrier]
            where = (
                self.words.names[carrier].text
                if carrier in self.words.names
                else with_article(noun(body.item.category))
            )
            text = self.words.inventory(things)
            stated = (Statement(f"rests_{how}", (b.id, carrier)) for b in things)
            rows.append(
                {
                    "place": f"{how} {where}",
                    **Text(f"{how.capitalize()} {where}: {text.words}.", (*stated, *text.statements)).to_dict(),
                }
            )
        return rows

    def _placed(self, place: str, bodies: Sequence[Body]) -> tuple[Statement, ...]:
        predicate = {"on the ceiling": "on_ceiling", "on the floor": "on_floor", "elsewhere in the room": "on_floor"}
        kind = predicate.get(place, "along_wall" if place.startswith("along") else "on_wall")
        wall = [k for k, name in self.facts.wall_names.items() if place.endswith(name)]
        return tuple(Statement(kind, (b.id,), f"wall:{wall[0]}" if wall else None) for b in bodies)


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
