"""Whatever is written as a request is read, in bounded time: texts at random, and requests of a grammar.

`make test` reads a share of them, `make bench` reads all, from fresh seeds, which it prints.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice

import pytest

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.assets.sources import Library
from sceneweaver.language.read import read_request
from sceneweaver.language.source import MOST
from sceneweaver.scene import InputError
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior
from tests.language.graphs import consistent
from tests.language.made_requests import MadeRequests
from tests.language.odd_texts import OddTexts

SLOWEST = 2.0
"""Seconds of processor time that any request takes at most."""


@dataclass
class Readings:
    """What came of reading texts."""

    count: int = 0
    refused: int = 0
    slowest: float = 0.0
    faults: list[tuple[str, str]] = field(default_factory=list)

    def __str__(self) -> str:
        return f"{self.count} read, {self.refused} refused, {len(self.faults)} faults, slowest {self.slowest:.2f} s"


def read_all(texts: Iterable[str]) -> Readings:
    """Reads texts; all but a line for what is no request is a fault."""
    read_request("a bedroom")  # the lexicon is loaded once
    found = Readings()
    for text in texts:
        found.count += 1
        began = time.process_time()
        try:
            consistent(read_request(text))
        except InputError as error:
            found.refused += 1
            if (text.strip() and len(text) <= MOST) or "\n" in str(error):
                found.faults.append((text[:2000], f"refused: {error}"))
        except Exception as error:
            found.faults.append((text[:2000], f"{type(error).__name__}: {error}"[:200]))
        took = time.process_time() - began
        found.slowest = max(found.slowest, took)
        if took > SLOWEST:
            found.faults.append((text[:2000], f"it took {took:.1f} s"))
    return found


def made(seed: int, count: int) -> Iterator[str]:
    requests = MadeRequests(seed)
    return (requests.request() for _ in range(count))


def fresh_seed() -> int:
    """A seed that no one tuned the reader by; SCENEWEAVER_FUZZ_SEED names one again."""
    return int(os.environ.get("SCENEWEAVER_FUZZ_SEED") or int.from_bytes(os.urandom(4), "big"))


AGAIN = ("and so on ", "of ", "from floor to ceiling ", "as X ", "a desk, ", "without a ", "(a chair ", "3 x 4 m ")
"""What some readers looked for in all that stands before it, each time that it was said."""


def test_a_phrase_said_again_and_again_is_read() -> None:
    assert read_all(("a room with a bed and " + phrase * 6_000)[:6_000] for phrase in AGAIN).faults == []


def test_texts_at_random_are_read() -> None:
    assert read_all(islice(OddTexts(1), 150)).faults == []


def test_made_requests_are_read() -> None:
    assert read_all(made(3, 60)).faults == []


def drafted(text: str, library: Library) -> None:
    """The first draft of a request, as a design begins with it, but for the layout."""
    graph = read_request(text)
    room, _ = chosen_room(graph)
    InitPrior().propose(Context(graph, room, empty_scene(graph, room), library, seed=0))


@pytest.mark.slow
def test_two_hundred_thousand_texts_are_read() -> None:
    seed = fresh_seed()
    found = read_all(islice(OddTexts(seed), 200_000))
    print(f"texts at random, seed {seed}: {found}")
    long = read_all(islice(OddTexts(seed).long(), 500))
    print(f"long texts, seed {seed}: {long}")
    assert found.faults + long.faults == []


@pytest.mark.slow
def test_five_thousand_made_requests_are_read_and_some_drawn() -> None:
    seed = fresh_seed()
    found = read_all(made(seed, 5000))
    print(f"made requests, seed {seed}: {found}")
    library, faults = Library(), []
    for text in made(seed, 200):
        try:
            drafted(text, library)
        except Exception as error:
            faults.append((text, f"{type(error).__name__}: {error}"))
    print(f"first drafts of 200 of them: {len(faults)} faults")
    assert found.faults + faults == []
