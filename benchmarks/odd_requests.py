"""Odd requests by a grammar: each kind is a way in which people, or machines, ask for what cannot be, or say nothing.

Equal seeds give equal requests.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

import yaml

Draw = random.Random

_WORDS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
ROOMS, THINGS, SMALL = _WORDS["rooms"], _WORDS["things"], _WORDS["small"]
PLACES, NUMBERS, UNITS = _WORDS["places"], _WORDS["numbers"], _WORDS["units"]
NONSENSE, FOREIGN, INJECTIONS = _WORDS["nonsense"], _WORDS["foreign"], _WORDS["injections"]


def _count(d: Draw) -> str:
    return f"{d.choice(('', 'exactly ', 'at least '))}{d.choice((12, 40, 99, 500, 10_000, 10**12))}"


def _impossible_counts(d: Draw) -> str:
    asked = ", ".join(f"{_count(d)} {d.choice(THINGS)}s" for _ in range(d.randint(1, 3)))
    return f"a {d.choice(('tiny', 'small', ''))} {d.choice(ROOMS)} with {asked}"


def _contradictions(d: Draw) -> str:
    thing, other = d.sample(THINGS, 2)
    return d.choice(
        (
            f"a {d.choice(ROOMS)} with a {thing} and without a {thing}",
            f"a {thing} left of the {other}, and the {other} left of the {thing}, in a {d.choice(ROOMS)}",
            f"a {d.choice(ROOMS)} with no furniture but with two {thing}s and a {other} in the middle of the middle",
            f"a {d.choice(ROOMS)} of 12 m2, 3 m by 9 m, with exactly three but at most two {thing}s",
            f"a windowless {d.choice(ROOMS)} with a {thing} by the window facing the wall facing the door",
            f"an empty {d.choice(ROOMS)} that is full of {thing}s",
        )
    )


def _sizes_of_rooms(d: Draw) -> str:
    side = d.choice(("0", "0.01", "0.5", "1", "1.2", "60", "300", "1e6", "-4", "nan", "inf"))
    unit = d.choice(("m", "cm", "metres", "ft", ""))
    return f"a {d.choice(ROOMS)} of {side} {unit} by {d.choice((side, '3'))} {unit} with a {d.choice(THINGS)}"


def _sizes_of_things(d: Draw) -> str:
    size = d.choice(("0", "0.001", "12", "1000", "1e300", "-1", "tiny", "gigantic", "enormous", "microscopic"))
    unit = "" if size.isalpha() else d.choice((" m wide", " cm high", " mm deep", " m x 7 m"))
    return f"a {d.choice(ROOMS)} with a {size}{unit} {d.choice(THINGS)} and a {d.choice(('large', 'small'))} rug"


def _nonsense(d: Draw) -> str:
    words = [d.choice([*NONSENSE, d.choice(THINGS)]) for _ in range(d.randint(1, 9))]
    return f"{d.choice(('a', 'the', ''))} {' '.join(words)} {d.choice(('with', 'on', 'of', ''))} {d.choice(NONSENSE)}"


def _negations(d: Draw) -> str:
    no = ", ".join(
        f"{d.choice(('no', 'not a', 'without any', 'never a', 'not not a'))} {t}" for t in d.sample(THINGS, 4)
    )
    return f"a {d.choice(ROOMS)} with {no}" if d.random() < 0.7 else f"not a {d.choice(ROOMS)}, {no}"


def _hardly_anything(d: Draw) -> str:
    return d.choice(
        (" ", "\n\n", ".", "?!", "a", "the", "room", "...", "42", "-", "\u200b", "🛏️", "🙂🛋️🪴", "and and", "''")
    )


def _very_long(d: Draw) -> str:
    clause = f"a {d.choice(THINGS)} {d.choice(PLACES)} the {d.choice(THINGS)}"
    return d.choice(
        (
            f"a {d.choice(ROOMS)} with " + ", ".join(f"a {d.choice(THINGS)}" for _ in range(d.choice((60, 400)))),
            f"a {d.choice(ROOMS)} with " + " and ".join([clause] * d.choice((50, 800))),
            "bed" * d.choice((500, 20_000)),
            f"a very {'very ' * d.choice((300, 9000))}large {d.choice(ROOMS)}",
            " ".join(d.choice(NONSENSE) for _ in range(3000)),
        )
    )


def _languages(d: Draw) -> str:
    return d.choice(FOREIGN) + d.choice(("", "", " with a bed", " / " + d.choice(FOREIGN)))


def _nested_supports(d: Draw) -> str:
    chain = " on ".join(f"a {t}" for t in d.sample(SMALL + THINGS, d.randint(3, 7)))
    return f"a {d.choice(ROOMS)} with {chain}"


def _missing_targets(d: Draw) -> str:
    thing = d.choice(THINGS)
    missing = d.choice(("helicopter", "moat", "other one", "third window", "altar", "it", "them", "unicorn"))
    return f"a {d.choice(ROOMS)} with a {thing} {d.choice(PLACES)} the {missing}"


def _injections(d: Draw) -> str:
    return d.choice(INJECTIONS).format(room=f"a {d.choice(ROOMS)} with a {d.choice(THINGS)}")


def _numbers_in_words(d: Draw) -> str:
    return (
        f"a {d.choice(ROOMS)} with {d.choice(NUMBERS)} {d.choice(THINGS)}s and {d.choice(NUMBERS)} {d.choice(SMALL)}s"
    )


def _units(d: Draw) -> str:
    side, unit = d.choice(("3", "4.5", "1/2", "12'6\"", "three", "1.000,50")), d.choice(UNITS)
    return f"a {side} {unit} by {side} {unit} {d.choice(ROOMS)} with a {d.choice(THINGS)} {side} {d.choice(UNITS)} wide"


def _absurd_places(d: Draw) -> str:
    count = d.choice(("a dozen", "six", "three", "ten"))
    parts = [f"{count} {d.choice(THINGS)}s {d.choice(PLACES)} the {d.choice(THINGS)}" for _ in range(d.randint(2, 4))]
    return f"{', '.join(parts)} in a {d.choice(('tiny', 'narrow', 'round', ''))} {d.choice(ROOMS)}"


def _crowds(d: Draw) -> str:
    people = d.choice((0, 1, 25, 80, 400, 100_000))
    return f"a {d.choice(('restaurant', 'classroom', 'office', 'dining room', 'library'))} for {people} people"


def _itself(d: Draw) -> str:
    thing = d.choice(THINGS)
    return f"a {d.choice(ROOMS)} with a {thing} {d.choice(PLACES)} the same {thing} {d.choice(PLACES)} itself"


def _marks(d: Draw) -> str:
    text = f"a {d.choice(ROOMS)} with a {d.choice(THINGS)}"
    marks = "\u202e\u0301\ufeff\t\u2028;:,(){}[]<>|\\/*&^%#@!~\"'`=+_-\x07\x1b"
    return "".join(c + (d.choice(marks) if d.random() < 0.3 else "") for c in text)


def _many_relations(d: Draw) -> str:
    things = d.sample(THINGS, 6)
    said = [f"the {a} is {d.choice(PLACES)} the {b}" for a in things for b in d.sample(things, 2)]
    return f"a {d.choice(ROOMS)} with a {', a '.join(things)}. " + ". ".join(said)


def _two_rooms(d: Draw) -> str:
    one, two = d.sample(ROOMS, 2)
    return f"a {one} that is a {two}, with a {two} in the {one}, and a {d.choice(THINGS)} in each {d.choice(ROOMS)}"


KINDS: Mapping[str, Callable[[Draw], str]] = MappingProxyType(
    {
        "impossible counts": _impossible_counts,
        "contradictions": _contradictions,
        "sizes of rooms": _sizes_of_rooms,
        "sizes of things": _sizes_of_things,
        "nonsense": _nonsense,
        "negations": _negations,
        "hardly anything": _hardly_anything,
        "very long": _very_long,
        "languages": _languages,
        "nested supports": _nested_supports,
        "missing targets": _missing_targets,
        "injections": _injections,
        "numbers in words": _numbers_in_words,
        "units": _units,
        "absurd places": _absurd_places,
        "crowds": _crowds,
        "on itself": _itself,
        "marks": _marks,
        "many relations": _many_relations,
        "two rooms": _two_rooms,
    }
)


def odd_requests(each: int, seed: int = 0) -> list[tuple[str, str]]:
    """``each`` requests of every kind, as (kind, text)."""
    return [(kind, draw(random.Random(f"{seed} {kind} {k}"))) for k in range(each) for kind, draw in KINDS.items()]
