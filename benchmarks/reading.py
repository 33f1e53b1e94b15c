"""How much of what strangers wrote is read: the graph of a request beside its marks, by the rules alone and with the
network. ``python -m benchmarks.reading`` takes the requests of the writer on whom nothing was trained, ``--trained``
those of the others (which the rules have not seen either).
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from sceneweaver.language import SceneGraph, read_request
from sceneweaver.language.learned.labels import WHERE
from sceneweaver.language.model import PLACES, Entity, Span
from sceneweaver.language.read import read_by_rules

from .annotated_requests import Annotated, annotated_requests

Pair = tuple[int, int]

MUTUAL = ("next_to", "near", "facing", "opposite", "side_by_side", "far_from")
"""Types that say the same of both."""

FIGURES = {
    "things": ("things read", "things"),
    "right things": ("entities right", "entities"),
    "counts": ("counts right", "counts"),
    "exclusions": ("excluded", "unwanted"),
    "free floor": ("free read", "free"),
    "relations": ("related", "links"),
    "right relations": ("relations right", "relations"),
}
"""Shares, by what is counted of what."""


def counted(asked: Annotated, graph: SceneGraph) -> Counter[str]:
    """What there is in the marks and in the graph, and what of it is in the other.

    A relation is read when the graph has one between the same two things, or of the thing and a place of the room,
    whatever its type: types of the graph are finer than links.
    """
    found: Counter[str] = Counter()
    entities = [entity for entity in graph.entities if entity.span is not None]
    of: dict[int, list[Entity]] = {}
    for number, (start, end, kind) in asked.mentions.items():
        over = [entity for entity in entities if _over(entity.span, start, end)]
        if kind == "thing":
            of[number] = over
            found["things"] += 1
            found["things read"] += bool(over)
            many = asked.counts.get(number, 1)
            if over and many is not None:
                low, high = (sum((entity.count or (1, 1))[k] for entity in over) for k in (0, 1))
                found["counts"] += 1
                found["counts right"] += low <= many <= high and (many > 1 or high <= 2)
        elif kind == "unwanted":
            found["unwanted"] += 1
            found["excluded"] += not over and any(_over(one.span, start, end) for one in graph.exclusions)
        elif kind == "free":
            found["free"] += 1
            found["free read"] += any(_over(area.span, start, end) for area in graph.free_areas)
    for entity in entities:
        if not entity.implied:
            found["entities"] += 1
            found["entities right"] += any(
                _over(entity.span, start, end)
                for start, end, kind in asked.mentions.values()
                if kind in ("thing", "reference")
            )
    links = set(_links(asked))
    for one, other in links:
        found["links"] += 1
        found["related"] += _is_related(graph, of, one, other)
    found += _right(graph, of, asked, links)
    return found


def _over(span: Span | None, start: int, end: int) -> bool:
    return span is not None and span.start < end and start < span.end


def _meant(asked: Annotated, number: int) -> int:
    """The mention that a reference stands for."""
    for _ in range(6):
        if number == 0 or asked.mentions[number][2] != "reference":
            break
        number = next((b for name, a, b in asked.links if name == "same" and a == number), 0)
    return number


def _links(asked: Annotated) -> Iterator[Pair]:
    """What things are placed by: things, places of the room, openings."""
    for name, a, b in asked.links:
        one, other = _meant(asked, a), _meant(asked, b)
        kinds = [asked.mentions[number][2] for number in (one, other) if number]
        if name in WHERE and kinds[:1] == ["thing"] and kinds[1:] in (["thing"], ["place"], ["opening"]):
            yield one, other


def _is_related(graph: SceneGraph, of: Mapping[int, list[Entity]], one: int, other: int) -> bool:
    subjects = {entity.id for entity in of.get(one, ())}
    if other not in of:
        at_places = (relation.subject in subjects and _at_place(relation.targets) for relation in graph.relations)
        return any(at_places) or any(barred.subject in subjects for barred in graph.exclusions if barred.relation)
    targets = {entity.id for entity in of[other]}
    for relation in graph.relations:
        if relation.subject in subjects and targets & set(relation.targets):
            return True
        if relation.type in MUTUAL and relation.subject in targets and subjects & set(relation.targets):
            return True
    return False


def _at_place(targets: Iterable[str]) -> bool:
    return any(target.partition(":")[0] in PLACES for target in targets)


def _right(graph: SceneGraph, of: Mapping[int, list[Entity]], asked: Annotated, links: Iterable[Pair]) -> Counter[str]:
    """Relations between what both have, and how many of them are stated."""
    found: Counter[str] = Counter()
    numbers: dict[str, set[int]] = {}
    for number, entities in of.items():
        for entity in entities:
            numbers.setdefault(entity.id, set()).add(number)
    each = {(_meant(asked, a), _meant(asked, b)) for name, a, b in asked.links if name == "each"}
    stated = {*links, *each} | {(b, a) for a, b in (*links, *each)}
    for relation in graph.relations:
        one = numbers.get(relation.subject, set())
        if one and relation.targets and all(target in numbers for target in relation.targets):
            found["relations"] += 1
            pairs = ((a, b) for a in one for target in relation.targets for b in numbers[target])
            found["relations right"] += any(pair in stated for pair in pairs)
        elif one and _at_place(relation.targets):
            found["relations"] += 1
            found["relations right"] += any(a in one and b not in of for a, b in stated)
    return found


def shares(found: Counter[str]) -> dict[str, float]:
    """`FIGURES` in per cent."""
    return {name: round(100 * found[a] / max(1, found[b]), 1) for name, (a, b) in FIGURES.items()}


def main() -> None:
    """Prints both readers side by side."""
    given = argparse.ArgumentParser(prog="python -m benchmarks.reading")
    given.add_argument("--trained", action="store_true", help="requests of the writers that the network was trained on")
    requests = list(annotated_requests(held_out=not given.parse_args().trained))
    readers = {"rules": read_by_rules, "rules and network": read_request}
    rows = {name: sum((counted(one, read(one.text)) for one in requests), Counter()) for name, read in readers.items()}
    print(f"{len(requests)} requests, {rows['rules']['links']} relations")
    for figure in FIGURES:
        print(f"{figure:16}", *(f"{name} {shares(row)[figure]:5.1f}" for name, row in rows.items()), sep="  ")


if __name__ == "__main__":
    main()
