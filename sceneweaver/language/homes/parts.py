"""What is read of a request for a home before it is a programme: rooms as they were named, what was said of them."""

from __future__ import annotations

from dataclasses import dataclass, field

from sceneweaver.language.model import Span
from sceneweaver.plans.programme import AdjacencyKind

from .lexicon import RoomKind, Use
from .tokens import Token


@dataclass(eq=False)
class Named:
    """Rooms as one phrase names them, or refers to them ("one of them").

    Attributes:
        kind: of the rooms.
        at, first, last: number of the token that names them, and of the first and the last one of the phrase.
        count: how many; None where it is open ("meeting rooms").
        told: how its number was told: "number", "article", "total" (of a two-bedroom flat), "each" (one for each of
            the people), or "" for none.
        definite: whether it is "the" or somebody's, so that it may have been named before.
        all: whether it is every one of them.
        of: the rooms that it refers to some of.
        per: the rooms of which each one has its own; times: the people of whom each one has.
        open: whether it is an open one; size: factor on the usual area, area: (least, most) [m2] of each,
            side: least width [m].
        storey: "ground", "upper" ... as it was said.
        least, most: floor [m2] of each that is not to be gone below, and not above.
        equal: whether they are told to be of one size; more: whether it is one more of those before ("a separate one").
        outside: "also" or "only" where it has a door of its own that leads outside.
        owner: whose it is told to be alone ("mother", of "her own bathroom").
        noun: what its own request calls it; said: its name in the singular.
        wishes: what its own request says besides, in words; unwanted: what it is not to have.
    """

    kind: RoomKind
    at: int
    first: int
    last: int
    span: Span
    count: int | None = None
    told: str = ""
    definite: bool = False
    all: bool = False
    of: Named | None = None
    per: Named | None = None
    times: int = 1
    size: float | None = None
    area: tuple[float, float] | None = None
    least: float | None = None
    most: float | None = None
    side: float | None = None
    equal: bool = False
    more: bool = False
    owner: str = ""
    outside: str = ""
    open: bool = False
    storey: str | None = None
    accessible: bool = False
    alone: Span | None = None
    """Where it says that nobody is to be behind its walls."""
    daylight: bool | None = None
    looks: list[str] = field(default_factory=list[str])
    wishes: list[str] = field(default_factory=list[str])
    noun: str = ""
    said: str = ""
    barred: bool = False
    ids: list[str] = field(default_factory=list[str])

    @property
    def root(self) -> Named:
        """The rooms that it refers to some of, or itself."""
        return self.of.root if self.of is not None else self


@dataclass
class Joint:
    """What rooms are to others, or to a place ("entrance"): ``kind`` is one of an `Adjacency`."""

    a: Named
    b: Named | str
    kind: AdjacencyKind
    span: Span
    each: bool = False
    hard: bool = True
    how: str = ""
    """ "opposite" or "not through", which no adjacency says."""


@dataclass
class Person:
    """So many people of a role: adults, children, babies, twins, couples, seniors."""

    role: str
    count: int
    span: Span
    who: str = ""
    """What somebody who is told alone is called: "mother", also where he is called mum; empty for several."""


@dataclass
class Reading:
    """All that was read so far."""

    text: str
    tokens: tuple[Token, ...]
    use: Use
    use_at: int | None
    second: Use | None = None
    """The business that a home is told to have beside it."""
    business: list[bool] = field(default_factory=list[bool])
    """For each token whether it tells of the business."""
    named: list[Named] = field(default_factory=list[Named])
    joints: list[Joint] = field(default_factory=list[Joint])
    people: list[Person] = field(default_factory=list[Person])
    household: int | None = None
    """How many people a number alone tells: "we are five"."""
    own_rooms: bool = False
    """Whether everybody is to have a room."""
    share_ground: bool = False
    """Whether the rooms that all use are told to be on the ground floor."""
    share: bool = False
    """Whether children share."""
    together: bool = False
    """Whether all children have one room."""
    visitors: bool = False
    workers: int | None = None
    staff: dict[str, int] = field(default_factory=dict[str, int])
    storeys: int | None = None
    one_storey: bool = False
    accessible: bool = False
    area: tuple[float, float] | None = None
    least: float | None = None
    most: float | None = None
    """Floor [m2] of the home that is not to be gone below, and not above."""
    scale: float = 1.0
    """Factor on the usual areas of all rooms."""
    width: float | None = None
    depth: float | None = None
    doors: float | None = None
    ways: float | None = None
    """Least clear widths [m] of doors, and of halls."""
    sleep_storey: str | None = None
    live_storey: str | None = None
    """The storeys on which all who live there are told to sleep, and to have all rooms of theirs."""
    l_shape: bool = False
    window_sides: int | None = None
    styles: list[str] = field(default_factory=list[str])
    loose: list[tuple[str, Span, bool]] = field(default_factory=list[tuple[str, Span, bool]])
    """What is asked for and is in no room that is named."""
    unwanted: list[tuple[str, Span]] = field(default_factory=list[tuple[str, Span]])
    """Things that are not wanted."""
    notes: list[str] = field(default_factory=list[str])
    unmeasured: list[Span] = field(default_factory=list[Span])
    """Where it says what a plan is to be like and has no measure of: "quiet", "in the middle"."""
    rows: list[tuple[Span, str, str]] = field(default_factory=list[tuple[Span, str, str]])
    """What was understood: where it stands, of what kind it is, what became of it."""

    def use_of(self, at: int) -> Use:
        """The use that a token tells of: that of the business, where it does, else that of the home."""
        return self.second if self.second is not None and at >= 0 and self.business[at] else self.use

    def did(self, token: Token | int, what: str) -> None:
        """Token is accounted for."""
        one = self.tokens[token] if isinstance(token, int) else token
        one.done = one.done or what

    def say_vague(self, token: Token) -> None:
        """What is said of a home and no plan is measured by: a demand not understood, or praise with a note."""
        if token.has("unmeasured"):
            if token.span not in self.unmeasured:
                self.unmeasured.append(token.span)
            return
        note = f"'{token.text}': nothing of a plan is measured by it"
        if note not in self.notes:
            self.notes.append(note)

    def sentences(self) -> list[range]:
        """Numbers of the tokens of each sentence."""
        found: list[range] = []
        start = 0
        for at, token in enumerate(self.tokens):
            if token.stops:
                found.append(range(start, at))
                start = at + 1
        found.append(range(start, len(self.tokens)))
        return [one for one in found if len(one)]

    def named_at(self) -> dict[int, Named]:
        """Rooms by the number of the token that names them."""
        return {one.at: one for one in self.named}

    def named_between(self, start: int, stop: int) -> list[Named]:
        """Rooms whose name stands between two tokens."""
        return [one for one in self.named if start <= one.at < stop]
