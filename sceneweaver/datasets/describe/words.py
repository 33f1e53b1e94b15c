"""Groups of things in words: "two cream nightstands", "a vase, two books and a lamp"."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from sceneweaver.verify.solids import Body

from .facts import Facts
from .naming import Name, look, names
from .nouns import counted, listed, noun, number
from .statements import Statement, Text, said


class Words:
    """Words for the things of one scene, with what they state."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        self.facts = facts
        self.rng = rng
        self.names: dict[str, Name] = names(facts)
        self.told: set[frozenset[str]] = set()

    def one_of(self, *texts: str) -> str:
        """One of several wordings."""
        return texts[int(self.rng.integers(len(texts)))]

    def groups(self, bodies: Sequence[Body]) -> list[tuple[str, list[Body]]]:
        """Bodies by category, in the order in which they come."""
        found: dict[str, list[Body]] = defaultdict(list)
        for body in bodies:
            found[body.item.category].append(body)
        return list(found.items())

    def group(self, category: str, bodies: Sequence[Body], looks: bool = True) -> Text:
        """Some things of one category: "two cream nightstands"."""
        seen = {look(b) for b in bodies}
        shared = next(iter(seen)) if len(seen) == 1 and looks else None
        statements = []
        words = counted(len(bodies), category)
        if shared is not None and not set(shared[0].split()) & set(noun(category).split()):
            words = counted(len(bodies), category, shared[0])
            statements = [Statement(shared[1], (b.id,), shared[0]) for b in bodies]
        return Text(words, tuple(statements))

    def inventory(self, bodies: Sequence[Body], looks: bool = False) -> Text:
        """Things in a row: "a vase, two books and a lamp"."""
        parts = [self.group(category, group, looks) for category, group in self.groups(bodies)]
        return Text(listed([p.words for p in parts]), tuple(s for p in parts for s in p.statements))

    def totals(self, bodies: Sequence[Body]) -> tuple[Statement, ...]:
        """That there are so many of each category, of what is all there."""
        everything = self.facts.by_category
        return tuple(
            Statement("count", tuple(b.id for b in everything[c]), {"category": c, "count": len(everything[c])})
            for c, _ in self.groups(bodies)
        )

    def main(self) -> list[tuple[str, list[Body]]]:
        """Categories of furniture by how much room they take."""
        groups = [(c, [b for b in bs if b.item.mount == "floor"]) for c, bs in self.groups(self.facts.furniture)]
        return sorted(groups, key=lambda g: (-round(sum(b.size[0] * b.size[1] * b.size[2] for b in g[1]), 6), g[0]))

    def resting(self, body: Body, how: str, things: Sequence[Body]) -> Text:
        """What rests on or in a thing, all of it or with the number of the rest."""
        chosen = list(things)
        groups = self.groups(chosen)
        if len(groups) > 5:
            groups = groups[:4]
            rest = len(chosen) - sum(len(bodies) for _, bodies in groups)
            chosen = [b for _, bodies in groups for b in bodies]
            words = listed(
                [
                    *(counted(len(bs), c) for c, bs in groups),
                    f"{number(rest)} other {'thing' if rest == 1 else 'things'}",
                ]
            )
        else:
            words = self.inventory(chosen).words
        be = "is" if len(things) == 1 else "are"
        stated = [Statement(f"rests_{how}", (b.id, body.id)) for b in things]
        return said(f"{how} {self.names[body.id].text} {be} {words}", *stated)
