"""All that a model server may do wrong, by name, each made from the good reply that it spoils.

script = misbehaving(answering({...}), seeded(7, share=0.4))
script = misbehaving(answering({...}), always("broken_json"))
"""

from __future__ import annotations

import importlib
import random
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from tests.llm.said import Asked, Said, Script

Spoils = Callable[[Asked, Said], Said]


@dataclass(frozen=True)
class Misbehaviour:
    """One way to misbehave.

    Attributes:
        name: what it is called.
        family: "answers" (the protocol is kept, what is said is wrong), "shapes" (JSON that is no reply), "statuses",
            "broken" (connections and documents), "slow" (ends only by a time-out), "large", "echoes" (shows the key).
        does: the good reply to the spoilt one.
    """

    name: str
    family: str
    does: Spoils


CATALOGUE: dict[str, Misbehaviour] = {}
"""All by name."""

MODULES = ("answers", "shapes", "statuses", "connections", "large", "echoes")


def bad(family: str) -> Callable[[Spoils], Spoils]:
    """Enters a misbehaviour into the catalogue under the name of its function."""

    def entered(does: Spoils) -> Spoils:
        name = does.__name__
        assert name not in CATALOGUE, name
        CATALOGUE[name] = Misbehaviour(name, family, does)
        return does

    return entered


def catalogue(*families: str) -> list[Misbehaviour]:
    """Those of some families, or all, in the order of their modules."""
    for module in MODULES:
        importlib.import_module(f"tests.llm.bad_{module}")
    return [one for one in CATALOGUE.values() if not families or one.family in families]


Pick = Callable[[Asked], Misbehaviour | None]


def misbehaving(good: Script, pick: Pick) -> Script:
    """A script whose good replies are spoilt where `pick` gives a misbehaviour."""

    def script(asked: Asked) -> Said:
        chosen = pick(asked)
        said = good(asked)
        return chosen.does(asked, said) if chosen else said

    return script


def always(name: str) -> Pick:
    """This one every time."""
    catalogue()
    return lambda asked: CATALOGUE[name]


def first(name: str, times: int) -> Pick:
    """This one for so many requests, then none."""
    catalogue()
    return lambda asked: CATALOGUE[name] if asked.ordinal < times else None


def seeded(seed: int, share: float, among: Iterable[Misbehaviour] = ()) -> Pick:
    """One at random for this share of the requests: a matter of the seed and the request's ordinal alone."""
    choices = list(among) or catalogue()

    def pick(asked: Asked) -> Misbehaviour | None:
        chance = random.Random(f"{seed} {asked.ordinal}")
        return chance.choice(choices) if chance.random() < share else None

    return pick
