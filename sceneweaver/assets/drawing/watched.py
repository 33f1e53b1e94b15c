"""What a drawing is given as finishes, and what it asks of them: all else of it is the same in every finish.

So it is with the style, which is mostly one of finishes, and with the suite.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import fields
from typing import Any, TypeVar

from ..body import Material
from ..category import Category
from .choices import Choices
from .finishes import Finishes
from .request import Request

T = TypeVar("T")

Decision = tuple[str, ...]
""""material", a role and names of finishes, or "named" and one name."""

Question = tuple[Any, ...]
"""What is asked and with which arguments: of a finish, after its number, or of the whole, see `answer`."""

_IN_ORDER = tuple(field.name for field in fields(Material))
_FIELDS = frozenset(_IN_ORDER)


def decide(finishes: Finishes, decision: Decision) -> Material:
    """The finish that a decision comes to."""
    kind, first, *names = decision
    return finishes.material(first, *names) if kind == "material" else finishes.named(first)


def answer(question: Question, given: Sequence[Material], finishes: Finishes) -> Hashable:
    """What a question is answered, by the finishes that were given so far and by what is asked of all of them."""
    if question[0] == "pick":
        _, name, count = question
        return finishes.pick(name, range(count), matched=True)
    if question[0] == "chance":
        _, name, share = question
        return finishes.chance(name, share, matched=True)
    if isinstance(question[0], str):
        return getattr(finishes, question[0])
    number, what, *rest = question
    if what == "same":
        return given[number] == given[rest[0]]
    found = getattr(given[number], what)
    return found(*rest) if rest else found


class Trace:
    """The finishes ``given`` to a drawing, by decisions, and its questions in between, each asked once.

    ``asked`` are questions with how many decisions there had been, and the answer.
    """

    def __init__(self, finishes: Finishes):
        self.finishes = finishes
        self.decisions: list[Decision] = []
        self.given: list[Material] = []
        self.asked: list[tuple[int, Question, Hashable]] = []
        self._answers: dict[Question, Any] = {}

    def give(self, decision: Decision, finish: Material) -> Watched:
        """A finish as the drawing may see it."""
        self.decisions.append(decision)
        self.given.append(finish)
        return Watched(len(self.given) - 1, self)

    def ask(self, *question: Any) -> Any:
        """The answer to a question."""
        if question not in self._answers:
            self._answers[question] = found = answer(question, self.given, self.finishes)
            self.asked.append((len(self.given), question, found))
        return self._answers[question]


class Watched(Material):
    """A finish that a drawing was given. What the drawing learns of it is noted, all at once where it reads a field."""

    number: int
    trace: Trace

    def __new__(cls, *_: Any, **changed: Any) -> Any:
        """A watched finish; from fields, as `dataclasses.replace` gives them, a finish of the drawing's own."""
        return Material(**changed) if changed else super().__new__(cls)

    def __init__(self, number: int, trace: Trace):
        object.__getattribute__(self, "__dict__").update(number=number, trace=trace)

    def __getattribute__(self, name: str) -> Any:
        return self.trace.ask(self.number, name) if name in _FIELDS else object.__getattribute__(self, name)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Material):
            return NotImplemented
        if not isinstance(other, Watched):
            return all([getattr(self, name) == getattr(other, name) for name in _IN_ORDER])  # all are noted
        a, b = sorted((self.number, other.number))
        return a == b or self.trace.ask(a, "same", b)

    def __hash__(self) -> int:
        return super().__hash__()

    def called(self, *names: str) -> bool:
        """As of the finish; only the answer is noted. So for all below."""
        return self.trace.ask(self.number, "called", *names)

    @property
    def kind(self) -> str:
        """As of the finish."""
        return self.trace.ask(self.number, "kind")

    @property
    def printed(self) -> bool:
        """As of the finish."""
        return self.trace.ask(self.number, "printed")

    def darker(self, than: float) -> bool:
        """As of the finish."""
        return self.trace.ask(self.number, "darker", than)

    def near(self, color: tuple[float, float, float], within: float) -> bool:
        """As of the finish."""
        return self.trace.ask(self.number, "near", color, within)


class Watching(Choices):
    """Choices with finishes that are watched.

    Args:
        category: What is drawn.
        seed: Its seed.
        request: All that is asked of it; the drawing sees only what is ``bare`` of it.
        any_material: As of `Finishes`.
    """

    def __init__(self, category: Category, seed: int, request: Request | None = None, *, any_material: bool = False):
        asked = request or Request()
        super().__init__(category, seed, asked.bare)
        self.finishes = Finishes(category, seed, asked, any_material=any_material)
        self.trace = Trace(self.finishes)
        self._roles: dict[str, Watched] = {}
        self._named: dict[str, Watched] = {}

    def material(self, role: str, *names: str) -> Material:
        """A finish for a role such as "top" or "legs": one of the names, "@wood" for any of a family.

        Names may come in one string, as "oak, walnut".

        The same role has the same finish all over. The first role that can do so takes the material that the user
        asked for, also one that is not among its names where its families allow it, and the first that can takes the
        colour; a style prefers finishes that suit it.
        """
        if role not in self._roles:
            self._roles[role] = self._given(("material", role, *names))
        return self._roles[role]

    def named(self, name: Material | str) -> Material:
        """A finish without alternative, as the room's palette has it."""
        if isinstance(name, Material):
            return name
        if name not in self._named:
            self._named[name] = self._given(("named", name))
        return self._named[name]

    def pick(self, name: str, options: Sequence[T], matched: bool = False) -> T:
        """One of the options; ``matched``: the same for all pieces of a suite."""
        return options[self.trace.ask("pick", name, len(options))] if matched else super().pick(name, options)

    def chance(self, name: str, share: float, matched: bool = False) -> bool:
        """True in that share of the seeds; ``matched``: the same for all pieces of a suite."""
        return self.trace.ask("chance", name, share) if matched else super().chance(name, share)

    @property
    def style(self) -> str:
        """The style that is asked for, or one of its own."""
        return self.trace.ask("style")

    @property
    def in_suite(self) -> bool:
        """Whether it is one of several pieces that match."""
        return self.trace.ask("in_suite")

    @property
    def in_room(self) -> bool:
        """Whether it is for a room with a palette."""
        return self.trace.ask("in_room")

    def _given(self, decision: Decision) -> Watched:
        return self.trace.give(decision, decide(self.finishes, decision))
