"""One question about a scene with its answer and how it was found."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import islice
from typing import Any, Literal, TypeVar

import numpy as np

from sceneweaver.verify.solids import Body

from .facts import Facts
from .naming import Speaker, wordings

Form = Literal["yes_no", "choice", "count", "number", "list"]

T = TypeVar("T")

TRIED = 24
"""Candidates of a template that are looked at in one scene."""


@dataclass(frozen=True)
class Question:
    """A question, its answer by geometry and what that came from.

    Attributes:
        template: what kind of question it is.
        form: "yes_no", "choice" (one of ``options``), "count" (a whole number), "number" (right within ``tolerance``)
            or "list" (nouns in any order, as often as they are there).
        question: in English.
        answer: "yes" or "no", one of the options, a number, or a list.
        objects: ids that it is about.
        operands: the measurements that the answer follows from; lengths [m], areas [m2], angles [deg].
        method: how the answer follows from them.
        margin: how far the measurement is from where the answer would change, in its unit; None: it is counted or said.
        options: of a choice.
        option_objects: ids of the options, where they are things.
        tolerance: how far a number may be off.
        unit: of a number.
    """

    template: str
    form: Form
    question: str
    answer: Any
    objects: tuple[str, ...]
    operands: dict[str, Any]
    method: str
    margin: float | None = None
    options: tuple[str, ...] = ()
    option_objects: tuple[str, ...] = ()
    tolerance: float | None = None
    unit: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """JSON data, without what is not there."""
        return {key: value for key, value in asdict(self).items() if value not in (None, ())}


class Asker(Speaker):
    """What templates of questions need: the facts, the names of things, and the draws of this scene."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        super().__init__(facts, rng)
        self.named = [b for b in facts.bodies if b.id in self.names]
        self.standing = [b for b in facts.furniture if b.id in self.names]
        self.floor: Any = None

    def ids(self, *bodies: Body) -> tuple[str, ...]:
        """All ids that the names of some bodies speak of, without repetition."""
        return tuple(dict.fromkeys(i for body in bodies for i in self.names[body.id].ids))

    def pairs(self, first: list[Body], second: list[Body]) -> Iterator[tuple[Body, Body]]:
        """Pairs of different bodies, none of them part of the other's name, in a drawn order."""
        for a in self.shuffled(first):
            for b in self.shuffled(second):
                if a is not b and a.id not in self.names[b.id].ids and b.id not in self.names[a.id].ids:
                    yield a, b

    def balanced(self, candidates: Iterable[T], answer: Callable[[T], tuple[bool | None, Any]]) -> tuple | None:
        """A candidate whose answer was drawn; None where the scene does not have one for "yes" and one for "no".

        So both answers are equally likely, whatever is known of rooms in general.

        Args:
            candidates: what could be asked about.
            answer: whether it is so, and what it was read off; None for what is too close to call.
        """
        wanted, found = self.coin(), {}
        for candidate in islice(candidates, TRIED):
            said, read = answer(candidate)
            if said is not None and said not in found:
                found[said] = (candidate, said, read)
            if len(found) == 2:
                return found[wanted]
        return None

    def ask_balanced(
        self,
        template: str,
        candidates: Iterable[Body | tuple[Body, ...]],
        answer: Callable[[Any], tuple[bool | None, Any]],
        details: Callable[[bool, Any], dict[str, Any]],
        **fields: Any,
    ) -> Question | None:
        """The question of a template about a candidate whose answer was drawn, see `balanced`.

        Args:
            template: its name in ``wordings.yaml``.
            candidates: things, or pairs of them.
            answer: whether it is so, and what it was read off.
            details: from both to further arguments of `ask`.
            fields: other fields of wordings and method.
        """
        found = self.balanced(candidates, answer)
        if found is None:
            return None
        about, said, read = found
        return self.ask(
            template, said, about if isinstance(about, tuple) else (about,), **details(said, read), **fields
        )

    def ask(
        self,
        template: str,
        answer: Any,
        about: Sequence[Body],
        operands: dict[str, Any],
        *,
        objects: tuple[str, ...] | None = None,
        options: Sequence[str] | Sequence[Body] = (),
        margin: float | None = None,
        tolerance: float | None = None,
        **fields: Any,
    ) -> Question:
        """The question of a template in one of its wordings.

        Args:
            template: its name in ``wordings.yaml``.
            answer: as `Question.answer`; a truth value is said as "yes" or "no", a body by its name.
            about: the things whose names are the fields {0}, {1} ... of the wordings.
            operands: what the answer follows from.
            objects: ids that it is about, where these are not those that the names speak of.
            options: of a choice: words or things.
            margin: from where the answer would change.
            tolerance: how far a number may be off.
            fields: other fields of wordings and method.
        """
        data = wordings()[template]
        things = [self.name(body) for body in about]
        bodies = [option for option in options if isinstance(option, Body)]
        if isinstance(answer, bool | np.bool_):
            answer = "yes" if answer else "no"
        return Question(
            template,
            data["form"],
            self.say(template, *things, **fields),
            self.name(answer) if isinstance(answer, Body) else answer,
            self.ids(*about) if objects is None else objects,
            operands,
            data["method"].format(**fields),
            margin=margin,
            options=tuple(self.name(option) if isinstance(option, Body) else option for option in options),
            option_objects=tuple(body.id for body in bodies),
            tolerance=tolerance,
            unit=data.get("unit"),
        )


Template = Callable[[Asker], Question | None]
"""Asks one question, or none where the scene does not lend itself to it."""


def rounded(value: float, digits: int = 3) -> float:
    """A measurement as it is written."""
    return round(float(value), digits)
