"""Requests made by a grammar, from a seed: rooms, counted things with words of quality, places, exclusions, sizes."""

from __future__ import annotations

import random
from typing import Any

from sceneweaver.assets.materials import color_words, finishes
from sceneweaver.assets.taxonomy import phrases
from sceneweaver.knowledge.load import room_words
from sceneweaver.language.vocabulary import NUMBERS, expand, plural, words

PLACES = ("the window", "the door", "the wall", "the corner", "the middle of the room", "the far wall", "the ceiling")
OPENINGS = ("{}", "{} with {}", "design {} that has {}", "{}: {}", "I would like {}, with {}", "Please make {} for me")
SCALES = ("small", "large", "tall", "low", "wide", "tiny", "huge", "long")
PEOPLE = ("a family of four", "two", "a student", "12 people", "children", "an elderly couple")


class MadeRequests:
    """Endless requests from a seed; equal seeds give equal requests."""

    def __init__(self, seed: int) -> None:
        self._rng = random.Random(seed)
        self._rooms, self._nouns = sorted(room_words()), sorted(phrases())
        self._colors, self._numbers = sorted(color_words()), sorted(NUMBERS)
        self._finishes = sorted(name for name, finish in finishes().items() if not finish.asked)
        relations: dict[str, Any] = words("relations")
        self._places = sorted({p for patterns in relations["prepositions"].values() for p in expand(patterns)})
        self._lemmas = sorted(relations["verbs"]["frames"])
        self._styles = sorted(word for group in words()["styles"].values() for word in group)

    def request(self) -> str:
        """One request, of one to nine sentences."""
        form = self._rng.choice(OPENINGS)
        said = [form.format(self._room(), self._list())]
        said += [self._sentence() for _ in range(self._rng.choice((0, 1, 1, 2, 2, 3, 4, 8)))]
        return ". ".join(said) + self._rng.choice((".", "", "!"))

    def _room(self) -> str:
        rng, words = self._rng, ["a"]
        words += [rng.choice(SCALES)] * (rng.random() < 0.3) + [rng.choice(self._styles)] * (rng.random() < 0.3)
        if rng.random() < 0.2:
            words.append(f"{rng.randint(2, 12)} x {rng.randint(2, 9)} m")
        words.append(rng.choice(self._rooms))
        if rng.random() < 0.2:
            words.append(rng.choice((f"of {rng.randint(6, 90)} m2", f"for {rng.choice(PEOPLE)}", "with a 3 m ceiling")))
        return " ".join(words)

    def _thing(self) -> str:
        rng, noun = self._rng, self._rng.choice(self._nouns)
        few = rng.choice(("a", "the", "one", "two", "three", "some", "a pair of", str(rng.randint(1, 14)), "number"))
        few = rng.choice(self._numbers) if few == "number" else few
        qualities = [rng.choice(group) for group in (SCALES, self._colors, self._finishes) if rng.random() < 0.2]
        if rng.random() < 0.08:
            qualities.append(f"{rng.uniform(0.3, 2.5):.1f} m {rng.choice(('wide', 'high', 'long', 'deep'))}")
        return " ".join([few, *qualities, noun if few in ("a", "the", "one") else plural(noun)])

    def _list(self) -> str:
        things = [self._thing() for _ in range(self._rng.choice((1, 1, 2, 3, 5)))]
        return " and ".join(part for part in (", ".join(things[:-1]), things[-1]) if part)

    def _sentence(self) -> str:
        rng, place = self._rng, self._rng.choice(self._places)
        target = self._thing() if rng.random() < 0.6 else rng.choice(PLACES)
        verb = rng.choice(self._lemmas).split()[0]
        return rng.choice(
            (
                f"{self._thing()} {place} {target}",
                f"{self._list()} are {place} {target}",
                f"there is {self._thing()} {place} {target}, and {self._thing()} {rng.choice(self._places)} it",
                f"{place} {target} stands {self._thing()}",
                f"{self._thing()} with {self._list()} on it",
                f"{self._thing()} {verb}s {self._list()}",
                f"each of the {plural(rng.choice(self._nouns))} has {self._thing()}",
                f"one of them is {place} {target}, the other {rng.choice(self._places)} {self._thing()}",
                f"no {rng.choice(self._nouns)}, {rng.choice(self._nouns)} or {rng.choice(self._nouns)}",
                f"without {self._list()}, but with {self._thing()} that is {place} {target}",
                f"{self._thing()} between {self._thing()} and {self._thing()}",
                f"{rng.randint(2, 8)} chairs around {self._thing()}, which {verb}s {target}",
                f"nothing on the walls, only {self._thing()}",
                f"while {self._thing()} is {place} {target}, {self._thing()} faces it",
                f"the walls are {rng.choice(self._colors)} and the floor is {rng.choice(self._finishes)}",
                f"the room is {rng.randint(2, 15)} by {rng.randint(2, 15)} metres and {rng.uniform(2.2, 4):.2f} m high",
            )
        )
