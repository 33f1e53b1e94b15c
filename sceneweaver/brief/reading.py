"""What is read of a request, and the state of its reader."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from .lexer import Token

MODIFIERS = ("color", "material", "finish", "styles", "scale", "shape", "moods", "dim", "density", "room_scale")

CATALOGUE = {
    "near": "near", "beside": "near", "by": "near", "side_by_side": "side_by_side", "in_front_of": "in_front_of",
    "behind": "behind", "left_of": "left_of", "right_of": "right_of", "between": "between", "around": "around",
    "against": "against_wall", "on": "on_top", "inside": "inside", "above": "above", "below": "near",
    "facing": "facing", "opposite": "facing", "parallel": "parallel", "aligned": "aligned",
    "back_to_back": "back_to_back",
    "flank": "leftright_to_leftright", "at_table": "front_against", "away": "away_from_door",
}  # fmt: skip
"""What a spoken relation between two things is in the relation catalogue."""

SMALL = {
    "potted_plant": "small_plant", "floor_lamp": "table_lamp", "palm": "small_plant", "standing_mirror": "round_mirror",
    "floor_vase": "vase", "globe": "desk_globe", "tv": "tv_on_stand",
}  # fmt: skip
"""What is meant when something that usually stands on the floor is put on something."""

BESIDE = 0.6
"""Distance [m] up to which things are next to each other."""


@dataclass
class Mention:
    """A kind of thing that the request names."""

    noun: str
    category: str
    count: tuple[int, int] | None = None
    color: str | None = None
    material: str | None = None
    style: str | None = None
    size: list[float | None] = field(default_factory=lambda: [None, None, None])
    scale: float = 1.0
    words: list[str] = field(default_factory=list)
    id: str = ""


@dataclass
class Said:
    """A relation as it was said: mentions, and a mention, two of them, or a place as its target."""

    kind: str
    subjects: list[Mention]
    target: Any
    words: str


@dataclass
class Pending:
    """What was read before the noun that it belongs to."""

    count: tuple[int, int] | None = None
    bound: str | None = None
    definite: bool = False
    any: bool = False
    length: float | None = None
    tokens: list[Token] = field(default_factory=list)

    @property
    def empty(self) -> bool:
        """Whether nothing stands before the noun."""
        return self.count is None and not self.any and not self.tokens and self.length is None


@dataclass
class Reading:
    """What a request says, before it is put into the form of a brief."""

    mentions: list[Mention] = field(default_factory=list)
    said: list[Said] = field(default_factory=list)
    without: list[str] = field(default_factory=list)
    room: str | None = None
    room_words: str = ""
    room_scale: float = 1.0
    shape: str | None = None
    style: str | None = None
    colors: list[str] = field(default_factory=list)
    density: str | None = None
    people: int | None = None
    for_whom: list[str] = field(default_factory=list)
    openings: dict[str, int] = field(default_factory=dict)
    only: bool = False
    unread: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


class State:
    """Where the reader is, and what it has in hand."""

    def __init__(self, tokens: list[Token], notes: list[str]):
        self.tokens = tokens
        self.out = Reading(notes=notes)
        self.at = 0
        self.pending = Pending()
        self.subjects: list[Mention] = []  # who a relation is about
        self.last: list[Mention] = []  # the noun phrase just read, for "it", "them" and lists
        self.relation: tuple[str, list[Mention], str] | None = None
        self.before: list[tuple[str, Any, str]] = []  # relations said ahead of their subject
        self.before_used = False
        self.first_of_pair: Mention | None = None
        self.negated = False
        self.owner: Mention | None = None  # whose "with" it is
        self.joined = False  # whether "and" or a comma came just before
        self.strangers: list[str] = []

    def _ahead(self, count: int) -> list[Token]:
        return self.tokens[self.at : self.at + count]

    def _noun_follows(self, within: int) -> bool:
        return any(t.has("noun", "group") for t in self._ahead(within))

    def _number_follows(self) -> bool:
        return any(t.has("number", "amount") for t in self._ahead(1))

    def _leftover(self) -> None:
        """Colours and styles without a noun belong to the room."""
        for token in self.pending.tokens:
            self._for_room(token)
        self.pending = Pending()

    def _for_room(self, token: Token) -> None:
        out = self.out
        if token.has("styles") and out.style is None:
            out.style = token.get("styles")
        if token.has("density") and out.density is None:
            out.density = token.get("density")
        if token.has("color") and not self.mentioned_color(token.text):
            out.colors.append(token.text)

    def mentioned_color(self, word: str) -> bool:
        """Whether a colour was said of a thing already."""
        return any(m.color == word for m in self.out.mentions[-1:])

    def _known(self, category: str) -> Mention | None:
        return next((m for m in reversed(self.out.mentions) if m.category == category), None)

    def _stranger_ends(self) -> None:
        if self.strangers:
            self.out.unread.append(" ".join(self.strangers))
            self.strangers = []
