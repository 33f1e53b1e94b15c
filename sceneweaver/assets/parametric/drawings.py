"""Drawings made once for all finishes, kept in memory and told to other processes.

What a drawing looks like depends on category, seed, the request but for its look, and the answers to what the drawing
asked of its finishes. So what is known is a tree: after some decisions about finishes comes a question, and each answer
leads on, until all is known and the shape stands there.
"""

from __future__ import annotations

import json
from collections import Counter, OrderedDict
from dataclasses import dataclass
from functools import cache
from hashlib import blake2b
from pathlib import Path
from threading import Lock
from typing import Any
from weakref import WeakValueDictionary

import numpy as np

from sceneweaver.io import packaged

from ..asset import Asset
from ..body import Material
from ..category import categories
from ..drawing import Drawing, Request
from ..drawing.assemble import bare_of
from ..drawing.bare import Bare
from ..drawing.finishes import Finishes
from ..drawing.packing import packed, unpacked
from ..drawing.watched import Decision, Question, answer, decide
from ..journal import Journal, journal_key
from ..recent import Recent
from .catalogue import check, draw, makers

_FINISH = 4096
"""Memory [bytes] of an asset without what it shares with other finishes of its drawing."""

_STEPS = 48
"""Decisions and questions have one part in so many of the memory of drawings: some two or three times what leads to
those that are kept."""


@dataclass(frozen=True)
class Step:
    """Decisions on finishes, and what is asked then; None: nothing, the drawing is done."""

    decisions: tuple[Decision, ...]
    question: Question | None

    @property
    def nbytes(self) -> int:
        """About the memory that it takes."""
        return 384 + 80 * len(self.decisions)


class Drawings:
    """The assets that were used last. Finishes of one drawing share its arrays, which are counted once.

    ``nbytes`` is about the memory that they take, ``drawn`` how many drawings were made here and ``told`` how many
    other processes made.

    Args:
        most: Bytes that are kept at most.
    """

    def __init__(self, most: int):
        self.nbytes = self.drawn = self.told = 0
        self._assets: OrderedDict[tuple[str, int, Request], tuple[Asset, Bare]] = OrderedDict()
        self._uses: Counter[Bare] = Counter()
        self._steps: Recent[bytes, Step] = Recent(0, lambda step: step.nbytes)
        self._bares: WeakValueDictionary[bytes, Bare] = WeakValueDictionary()
        self._by_shape: WeakValueDictionary[str, Bare] = WeakValueDictionary()
        self._journal: Journal | None = None
        self._lock = Lock()
        self.keep(most)

    def keep(self, most: int) -> None:
        """Keep so many bytes at most from now on, and as many more for what leads to drawings as belong to them."""
        self.most, self._steps.most = most, most // _STEPS

    def __len__(self) -> int:
        return len(self._assets)

    def share(self, journal: Journal | None) -> None:
        """Tell other processes what is drawn, and ask them, from now on; None: no longer."""
        self._journal = journal

    def get(self, category: str, seed: int, request: Request) -> Asset:
        """As `make`, of what is kept where that is possible."""
        key = category, seed, request
        with self._lock:
            if key in self._assets:
                self._assets.move_to_end(key)
                return self._assets[key][0]
        asset, bare = self._made(category, seed, request)
        with self._lock:
            if key not in self._assets:
                self._assets[key] = asset, bare
                self.nbytes += _FINISH + (0 if self._uses[bare] else bare.nbytes)
                self._uses[bare] += 1
            while self.nbytes > self.most and len(self._assets) > 1:
                self._forget(self._assets.popitem(last=False)[1][1])
        return asset

    def _forget(self, bare: Bare) -> None:
        self.nbytes -= _FINISH
        self._uses[bare] -= 1
        if not self._uses[bare]:
            del self._uses[bare]
            self.nbytes -= bare.nbytes

    def _made(self, category: str, seed: int, request: Request) -> tuple[Asset, Bare]:
        check(category)
        for any_material in (False, True):
            finishes = Finishes(categories()[category], seed, request, any_material=any_material)
            given: list[Material] = []
            bare = self._followed(finishes, given)
            if bare is None:
                drawing = draw(category, seed, request, any_material)
                bare, given, finishes = self._noted(drawing), drawing.trace.given, drawing.finishes
            if not finishes.lacks_material:  # else draw again, as its colour waited for it
                break
        return bare.finished(given, finishes), bare

    def _followed(self, finishes: Finishes, given: list[Material]) -> Bare | None:
        """The shape that some finishes lead to, and in ``given`` those of them that it has; None: not drawn yet."""
        key = _root(finishes.category.name, finishes.seed, finishes.request)
        while (found := self._found(key)) is not None:
            step, bare = found
            given += [decide(finishes, decision) for decision in step.decisions]
            if step.question is None:
                return bare
            key = journal_key(key, answer(step.question, given, finishes))
        return None

    def _found(self, key: bytes) -> tuple[Step, Bare | None] | None:
        step, bare = self._steps.peek(key), self._bares.get(key)
        if step is not None and (step.question is not None or bare is not None):
            return step, bare
        told = self._journal.get(key) if self._journal is not None else None
        if told is None:
            return None
        self.told += 1
        return self._kept(key, *_read(told))

    def _noted(self, drawing: Drawing) -> Bare:
        """The shape of a drawing, with how it came to be."""
        self.drawn += 1
        trace, key, first = drawing.trace, _root(drawing.category.name, drawing.seed, drawing.request), 0
        tell = self._journal is not None and _is_own(drawing.category.name)
        for count, question, found in trace.asked:
            self._note(key, Step(tuple(trace.decisions[first:count]), question), None, tell)
            key, first = journal_key(key, found), count
        return self._note(key, Step(tuple(trace.decisions[first:]), None), bare_of(drawing), tell)

    def _note(self, key: bytes, step: Step, bare: Bare | None, tell: bool) -> Any:
        known = self._steps.peek(key) is not None
        if tell and self._journal is not None and not (known and bare is None):
            self._journal.put(key, _written(step, bare))
        return self._kept(key, step, bare)[1]

    def _kept(self, key: bytes, step: Step, bare: Bare | None) -> tuple[Step, Bare | None]:
        """The same, where another drawing came to the same shape with that one's arrays."""
        with self._lock:
            self._steps.put(key, step)
            if bare is not None:
                twin = self._by_shape.get(bare.key)
                bare = twin if twin is not None and twin.same(bare) else bare
                self._bares[key] = self._by_shape[bare.key] = bare
        return step, bare


def _root(category: str, seed: int, request: Request) -> bytes:
    return journal_key("drawing", _edition(), category, seed, request.bare)


@cache
def _edition() -> str:
    """What the code of drawings is: what other code drew and told is of no use."""
    digest = blake2b(np.__version__.encode(), digest_size=8)
    here = Path(__file__).parents[1]
    for folder in (here, here.parent / "geometry"):
        for file in sorted(folder.rglob("*")):
            if file.suffix in (".py", ".yaml"):
                digest.update(packaged.bytes_of(file))
    return digest.hexdigest()


def _is_own(category: str) -> bool:
    """Whether the library draws it: a drawing of the user's may change from run to run."""
    return makers()[category].__module__.startswith(__name__.partition(".")[0] + ".")


def _written(step: Step, bare: Bare | None) -> bytes:
    row, data = packed(bare) if bare is not None else (None, b"")
    head = json.dumps([step.decisions, step.question, row]).encode()
    return len(head).to_bytes(4, "little") + head + data


def _read(content: bytes) -> tuple[Step, Bare | None]:
    end = 4 + int.from_bytes(content[:4], "little")
    decisions, question, row = json.loads(content[4:end])
    step = Step(_tuples(decisions), _tuples(question))
    return step, None if row is None else unpacked(row, memoryview(content)[end:])


def _tuples(value: Any) -> Any:
    """Tuples where JSON has lists."""
    return tuple(map(_tuples, value)) if isinstance(value, list) else value
