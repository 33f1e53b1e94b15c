"""What is read of a request, and the state of its reader."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from sceneweaver.assets import categories

from .lexer import Token

MODIFIERS = ("color", "material", "finish", "styles", "scale", "shape", "moods", "dim", "density", "room_scale")

SMALL = {
    "potted_plant": "small_plant",
    "floor_lamp": "table_lamp",
    "palm": "small_plant",
    "standing_mirror": "round_mirror",
    "floor_vase": "vase",
    "globe": "desk_globe",
    "tv": "tv_on_stand",
}
"""What is meant when something that usually stands on the floor is put on something."""


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
    implied: bool = False
    """Whether only a part of the room ("dining area") called for it."""


@dataclass
class ParsedRelation:
    """A relation as it was said: mentions, and a mention, two of them, or a place as its target."""

    kind: str
    subjects: list[Mention]
    target: Any
    words: str


@dataclass
class OpenRelation:
    """A relation that waits for its target; ``rest`` is who it is about if nothing follows the target."""

    kind: str
    subjects: list[Mention]
    words: str
    guessed: bool = False
    rest: list[Mention] = field(default_factory=list)


@dataclass
class PendingModifiers:
    """What was read before the noun that it belongs to."""

    count: tuple[int, int] | None = None
    bound: str | None = None
    definite: bool = False
    any: bool = False
    article: bool = False
    length: float | None = None
    sides: tuple[float, ...] | None = None
    tokens: list[Token] = field(default_factory=list)

    @property
    def empty(self) -> bool:
        """Whether nothing stands before the noun."""
        return self.count is None and not self.any and not self.tokens and self.length is None and self.sides is None


@dataclass
class ParsedRequest:
    """What a request says, before it is put into the form of a brief."""

    mentions: list[Mention] = field(default_factory=list)
    said: list[ParsedRelation] = field(default_factory=list)
    without: list[str] = field(default_factory=list)
    room_type: str | None = None
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
    sides: list[tuple[float, ...]] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def give_sides(mention: Mention, sides: tuple[float, ...]) -> None:
    """Two sides [m] and perhaps a height; the longer side lies as it does in the usual thing of that kind."""
    usual = categories()[mention.category].size
    long, short = max(sides[:2]), min(sides[:2])
    deep = usual is not None and sum(usual.depth) > sum(usual.width)
    mention.size[0:2] = (long, short) if deep else (short, long)
    if len(sides) > 2:
        mention.size[2] = sides[2]
    mention.scale = 1.0


class ParserState:
    """Where the reader is, and what it has in hand."""

    def __init__(self, tokens: list[Token], notes: list[str]):
        self.tokens = tokens
        self.out = ParsedRequest(notes=notes)
        self.at = 0
        self.pending = PendingModifiers()
        self.subjects: list[Mention] = []  # who a relation is about
        self.last: list[Mention] = []  # the noun phrase just read, for "it", "them" and lists
        self.relation: OpenRelation | None = None
        self.before: list[tuple[str, Any, str]] = []  # relations said ahead of their subject
        self.before_used = False
        self.first_of_pair: Mention | None = None
        self.negated = False
        self.negated_article = False  # "without a TV, a rug": the list goes on; "no TV, a rug": it does not
        self.negated_nouns = 0
        self.owner: Mention | None = None  # whose "with" it is
        self.party: list[Mention] = []  # the things of the part of the room that was named last
        self.joined = False  # whether "and" or a comma came just before
        self.strangers: list[str] = []
        self.closed = False  # whether a relation was said of the last phrase, so that no list goes on from it
        self.opening = True  # whether a sentence has just begun
        self.predicate: list[Mention] = []  # what "is red" is about

    def _ahead(self, count: int) -> list[Token]:
        return self.tokens[self.at : self.at + count]

    def _noun_follows(self, within: int) -> bool:
        return any(t.has("noun", "group") for t in self._ahead(within))

    def _number_follows(self) -> bool:
        return any(t.has("number", "amount") for t in self._ahead(1))

    def _leftover(self) -> None:
        """Colours and styles without a noun belong to what "is" them, or to the room."""
        if self.predicate and self.pending.tokens:
            for mention in self.predicate:
                self._describe(mention)
        else:
            for token in self.pending.tokens:
                self._for_room(token)
        self.pending = PendingModifiers()

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

    def _describe(self, mention: Mention) -> None:
        """What stood before a noun, or was said to be so of it."""
        for word in self.pending.tokens:
            if word.has("color"):
                mention.color = word.get("color")
            elif word.has("material"):
                mention.material = word.get("material")
            elif word.has("finish"):
                mention.words.append(word.text)
            elif word.has("scale"):
                mention.scale = float(word.get("scale"))
            elif word.has("styles"):
                mention.style = word.get("styles")
            elif not word.has("moods", "dim", "density"):
                mention.words.append(word.text)
        if self.pending.length is not None:
            axis = next((t.get("dim") for t in self.pending.tokens if t.has("dim")), None)
            if axis is not None:
                mention.size[int(axis)] = self.pending.length
                mention.scale = 1.0
        if self.pending.sides is not None:
            give_sides(mention, self.pending.sides)

    def _note(self, text: str) -> None:
        self.out.notes.append(text)

    def _stranger_ends(self) -> None:
        if self.strangers:
            self.out.unread.append(" ".join(self.strangers))
            self.strangers = []
