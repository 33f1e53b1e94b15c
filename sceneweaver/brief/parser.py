"""Tokens into a brief: noun phrases, what is said about them, and what relates them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from sceneweaver.assets import categories

from .lexer import Token
from .tables import category_of, groups
from .tables import words as listed

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


class Parser:
    """Reads tokens from left to right; make one, then call ``run``."""

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

    def run(self) -> Reading:
        """The whole request."""
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            self.at += 1
            self._one(token)
        self._stranger_ends()
        self._leftover()
        return self.out

    # tokens

    def _one(self, token: Token) -> None:
        if not token.kinds:
            self.strangers.append(token.text)
            return
        if token.has("break"):
            self._stranger_ends()
            self._break(token.text)
            return
        if token.has("only_all"):
            self.out.only = True
            return
        if token.has("neg") and not (token.has("number") and self._noun_follows(1)):
            self._stranger_ends()
            self.negated, self.joined = True, False
            self._leftover()
            return
        if token.has("nothing") and not token.has("noun"):
            self._nothing()
            return
        if token.has("only") and not token.has("noun"):
            self.out.only = self.out.only or self._noun_follows(4)
            return
        if token.has("bound") and self._number_follows():
            self.pending.bound = token.get("bound")
            return
        if token.has("number", "amount") and self._counted(token):
            return
        if token.has("length"):
            self.pending.length = token.get("length")
            return
        if token.text in ("seats", "sleeps", "seat", "sleep", "seating", "accommodates") and self._number_follows():
            self.out.people = (self.tokens[self.at].get("amount") or (0, self.tokens[self.at].get("number")))[1]
            self.at += 1
            return
        if token.has("place") and self._place(token):
            return
        if token.has("people_words", "whom") and self._people(token):
            return
        if token.has("group") and not token.has("noun") and (self.out.room is not None or self._other_room()):
            self._stranger_ends()
            self._group(token)
            return
        if token.has("room") and self._room(token):
            return
        if token.has("group") and not (token.has("noun") and self.relation):
            self._group(token)
            return
        if token.has("noun") and self._is_noun(token):
            self._stranger_ends()
            self._noun(token)
            return
        if token.has("pron") and self.relation is not None and self.relation[0] != "away" and self._pronoun():
            return
        if token.has("relation", "shape") and token.has("shape") and any(t.has("room", "noun") for t in self._ahead(1)):
            self.pending.tokens.append(token)  # "a round restaurant"
            return
        if token.has("relation") and self._relation(token):
            return
        if token.has("with"):
            self._with()
            return
        if token.has("and"):
            self.joined = True
            return
        if token.has("det"):
            if self.negated and token.text in ("a", "an") and self._negation_over():
                self.negated = False
            self._leftover()
            self.pending = Pending(definite=token.text in ("the", "this", "that", "these", "those"), any=True)
            return
        if token.has("each", "both"):
            return
        if token.has(*MODIFIERS):
            self.pending.tokens.append(token)
            return
        if token.has("verb") and self.last:
            self.subjects, self.relation = list(self.last), None

    def _ahead(self, count: int) -> list[Token]:
        return self.tokens[self.at : self.at + count]

    def _noun_follows(self, within: int) -> bool:
        return any(t.has("noun", "group") for t in self._ahead(within))

    def _negation_over(self) -> bool:
        """Whether a new phrase begins: "no TV, and a desk" wants a desk, "without a TV or a desk" does not."""
        back = [t.text for t in reversed(self.tokens[max(0, self.at - 7) : self.at - 1])]
        return back[:1] != ["or"] and ("," in back[:2] or (back[:1] == ["and"] and "no" in back))

    def _other_room(self) -> bool:
        """Whether another word names the room, so that a "dining area" is a part of it."""
        return any(t.has("room") and not t.has("group", "noun") for t in self.tokens)

    def _number_follows(self) -> bool:
        return any(t.has("number", "amount") for t in self._ahead(1))

    # what stands before a noun

    def _counted(self, token: Token) -> bool:
        if token.has("amount"):
            count = token.get("amount")
            if token.text in ("twin", "double", "single") and self.at < len(self.tokens):
                ahead = self.tokens[self.at]
                if ahead.has("room") or ahead.text == "room":
                    self.out.people = 1 if token.text == "single" else 2  # "a twin room"
                    return True
                if ahead.has("noun") and f"{token.text} {ahead.text}":
                    self.pending.tokens.append(token)
                    return True
        else:
            n = int(token.get("number"))
            bound, high = self.pending.bound, 400
            count = {"least": (n, max(n, min(high, n + 4))), "above": (n + 1, n + 5), "most": (min(1, n), n),
                     "below": (min(1, n), max(0, n - 1)), None: (n, n)}[bound]  # fmt: skip
        before = self.tokens[self.at - 2].text if self.at >= 2 else ""
        ahead = self._ahead(1)
        if before == "for" and (not ahead or ahead[0].has("break", "with", "relation", "and")):
            self.out.people = count[1]  # "an office for two"
            return True
        self._leftover()
        self.pending = Pending(count=count, any=True, definite=self.pending.definite)
        return True

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

    # rooms, people, places

    def _room(self, token: Token) -> bool:
        name = token.get("room")
        noun = token.has("noun")
        if self.out.room is not None:
            other = name != self.out.room and not noun and not any(t.has("noun") for t in self._ahead(1))
            if other:
                self.out.notes.append(f"'{token.text}' is another room; only the {self.out.room_words} is made")
            return not noun
        if noun and (self.out.mentions or self.owner is not None):
            return False
        if self.relation is not None and self.relation[0] not in ("inside",) and noun:
            return False
        self._stranger_ends()
        out = self.out
        out.room, out.room_words = name, token.text
        spoken = token.text.replace("'s", "").split()
        out.for_whom += [w for w in spoken if w in listed()["whom"]]  # "bedroom for a teenager" may be one name
        for word in self.pending.tokens:
            if word.has("room_scale"):
                out.room_scale = float(word.get("room_scale"))
            if word.has("shape") and out.shape is None:
                out.shape = word.get("shape")
            self._for_room(word)
        self.pending, self.relation = Pending(), None
        self.subjects, self.last = [], []
        return True

    def _people(self, token: Token) -> bool:
        previous = self.tokens[self.at - 2] if self.at >= 2 else None
        after_for = previous is not None and (previous.text in ("for", "of") or previous.has("number", "amount"))
        if token.has("noun") and not after_for:
            return False
        ahead = self.tokens[self.at] if self.at < len(self.tokens) else None
        if ahead is not None and ahead.has("noun", "room") and not ahead.has("stop"):
            if ahead.has("room"):
                return False
            self.pending.tokens.append(token)  # "kids desk"
            return True
        if self.pending.count is not None:
            self.out.people = self.pending.count[1]
        elif token.text in ("couple", "young couple", "parents", "elderly couple") and self.out.people is None:
            self.out.people = 2
        elif token.text in ("family",) and self.out.people is None:
            of = [t.get("number") for t in self._ahead(2) if t.has("number")]
            self.out.people = int(of[0]) if of else 4
            if of:
                self.at += 2
        if token.has("whom") and token.text not in self.out.for_whom:
            self.out.for_whom.append(token.text)
        self.pending = Pending()
        return True

    def _place(self, token: Token) -> bool:
        place = str(token.get("place"))
        if place == "corner" and token.has("noun"):
            return False
        if place in ("window", "door") and self._opening(place):
            return True
        relation = self.relation
        if place == "room":
            if self.strangers and self.out.room is None and not self.out.room_words:
                self.out.room_words = " ".join([*self.strangers, token.text])
                self.out.notes.append(f"'{self.out.room_words}' is no kind of room that is known")
            if relation is not None and relation[0] == "inside":
                self.relation = None
            for word in self.pending.tokens:
                if word.has("room_scale"):
                    self.out.room_scale = float(word.get("room_scale"))
                if word.has("shape") and self.out.shape is None:
                    self.out.shape = word.get("shape")
                self._for_room(word)
            self.pending = Pending()
            return True
        kinds = {"corner": "corner", "middle": "middle", "floor": "floor", "ceiling": "ceiling"}
        kind = relation[0] if relation else ("inside" if place in kinds or place.startswith("wall:") else None)
        if kind is None:
            return token.has("stop")
        if self.negated:
            self.negated = False
            return True
        if kind == "away" and place != "door":
            self.out.notes.append(f"'away from the {place}' cannot be said as a relation and was left out")
            self.relation = None
            return True
        subjects, words = (relation[1], relation[2]) if relation else (self.last[-1:], token.text)
        if kind == "between" and self.first_of_pair is not None:
            self.out.said.append(Said("near", list(subjects), self.first_of_pair, words))
        self._relate(kind, place, subjects, words)
        return True

    def _opening(self, place: str) -> bool:
        """Windows and doors as parts of the room: "two windows", "no windows", "with a window"."""
        if self.relation is not None and self.relation[0] not in ("inside",):
            return False
        if self.negated:
            self.out.openings[place], self.negated = 0, False
        elif self.pending.count is not None:
            self.out.openings[place] = self.pending.count[0]
        elif not self.pending.definite and self.pending.any:
            self.out.openings[place] = 1
        self.pending = Pending()
        return True

    def _nothing(self) -> None:
        for k, token in enumerate(self._ahead(5)):
            place = str(token.get("place") or "").split(":")[0]
            if place in groups()["nothing_on"]:
                self.out.without += groups()["nothing_on"][place]
                self.at += k + 1
                return
            if token.text in ("else", "more"):
                self.out.only = True
                return

    # nouns

    def _is_noun(self, token: Token) -> bool:
        ahead = self.tokens[self.at] if self.at < len(self.tokens) else None
        if token.has("color", "material") and ahead is not None and ahead.has("noun"):
            self.pending.tokens.append(token)
            return False
        return not (token.has("stop", "verb") and self.pending.empty and self.relation is None and not self.joined)

    def _noun(self, token: Token) -> None:
        name = token.get("noun")
        category = category_of(name)
        if name in ("furniture", "object"):  # "white furniture" is about the whole room
            self._leftover()
            self.negated = False
            return
        if self.negated and self.pending.definite and any(t.has("relation") for t in self._ahead(1)):
            self.negated = False  # "don't put the bed near the door" wants a bed
            self._connect(self._known(category) or self._made(token.text, category))
            self.pending, self.negated = Pending(), True
            return
        if self.negated:
            words = groups()["without"].get(token.text)
            self.out.without += words or [name if categories()[name].size is None else category]
            self.pending, self.joined = Pending(), False
            return
        mention = self._known(category) if self.pending.definite or self.relation is not None else None
        fresh = mention is None or self.pending.count is not None or any(
            t.has("color", "material") for t in self.pending.tokens
        )  # fmt: skip
        if mention is None or fresh:
            mention = self._made(token.text, category)
        self._for_modifiers(mention)
        self.pending = Pending()
        self._connect(mention)

    def _known(self, category: str) -> Mention | None:
        return next((m for m in reversed(self.out.mentions) if m.category == category), None)

    def _made(self, noun: str, category: str) -> Mention:
        count = self.pending.count
        if count is None and self.pending.any and not self.pending.definite:
            count = (1, 1)
        mention = Mention(noun, category, count)
        self.out.mentions.append(mention)
        return mention

    def _for_modifiers(self, mention: Mention) -> None:
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

    def _connect(self, mention: Mention) -> None:
        """A noun ends a relation as its target, or begins a new phrase."""
        joined, self.joined = self.joined, False
        if self.relation is not None:
            kind, subjects, words = self.relation
            if kind == "between" and self.first_of_pair is None:
                self.first_of_pair = mention
                if mention.count is not None and mention.count[0] >= 2:
                    self._relate(kind, (mention, mention), subjects, words)
                return
            target: Any = (self.first_of_pair, mention) if kind == "between" else mention
            if self.at >= 2 and self.tokens[self.at - 2].has("each") and mention.count is not None:
                for subject in subjects:  # "four chairs around each table"
                    low, high = subject.count or (1, 1)
                    subject.count = (low * mention.count[0], high * mention.count[1])
            for subject in subjects if kind in ("on", "inside") else ():
                subject.category = SMALL.get(subject.category, subject.category)
            self._relate(kind, target, subjects, words)
            self.last = [mention]
            return
        if self.before_used and not joined:  # "on the desk a lamp and a book": both; a new phrase is free of it
            self.before = []
        for kind, target, words in self.before:
            self.out.said.append(Said(kind, [mention], target, words))
        self.before_used = bool(self.before)
        if self.owner is not None and self.owner is not mention:
            self._owned(self.owner, mention)
        if joined and self.last and not any(mention is m for m in self.last):
            self.subjects = [*self.subjects, mention]
            self.last = [*self.last, mention]
        else:
            self.subjects, self.last = [mention], [mention]

    def _owned(self, owner: Mention, mention: Mention) -> None:
        """ "A desk with a lamp": what is small stands on what it came with, the rest is near it."""
        known = categories()
        small = known[mention.category].mount[0] == "surface"
        if small and known[owner.category].mount[0] == "floor":
            self.out.said.append(Said("on", [mention], owner, f"{owner.noun} with {mention.noun}"))
        elif known[mention.category].mount[0] == "floor" and known[owner.category].mount[0] == "floor":
            self.out.said.append(Said("near", [mention], owner, f"{owner.noun} with {mention.noun}"))
        many = owner.count
        if self._each and many is not None and mention.count is not None:
            mention.count = (mention.count[0] * many[0], mention.count[1] * many[1])

    @property
    def _each(self) -> bool:
        return any(t.has("each") for t in self.tokens[max(0, self.at - 6) : self.at])

    def _group(self, token: Token) -> None:
        """A part of the room ("reading corner") stands for its things."""
        row = groups()["groups"][token.get("group")]
        negated, self.negated = self.negated, False
        if negated:
            self.out.without += [category_of(name) for name in row["things"]]
            self.pending = Pending()
            return
        made = []
        for name, (low, high) in row["things"].items():
            category = category_of(name)
            mention = self._known(category) or Mention(name.replace("_", " "), category, (low, high))
            if mention not in self.out.mentions:
                self.out.mentions.append(mention)
            made.append(mention)
        for mention in made[1:]:
            self.out.said.append(Said("near", [mention], made[0], token.text))
        names = ", ".join(m.noun for m in made)
        self.out.notes.append(f"'{token.text}' was taken for: {names}")
        self.pending, self.joined, self.relation = Pending(), False, None
        for kind, target, words in self.before:
            self.out.said.append(Said(kind, made[:1], target, words))
        self.before = []
        self.subjects, self.last = made[:1], made[:1]

    # relations

    def _relation(self, token: Token) -> bool:
        kind = str(token.get("relation"))
        if token.has("place") and kind in ("left_of", "right_of") and not self._noun_follows(3):
            return False
        if kind in ("by", "inside", "on") and token.has("stop") and not self._target_follows():
            return False
        if self.negated and any(t.has("room") and not t.has("noun") for t in self._ahead(2)):
            self.negated = False  # "no plants in the living room"
            return True
        if self.negated:  # where a thing must not be
            self._leftover()
            start = self.at - 1
            while self.at < len(self.tokens) and self.tokens[self.at].has("det"):
                self.at += 1
            self.at = min(self.at + 1, len(self.tokens))
            words = " ".join(t.text for t in self.tokens[start : self.at])
            self.out.unread.append(f"not {words}")
            self.out.notes.append(f"'not {words}' cannot be said as a relation and was left out")
            self.negated = False
            return True
        self._leftover()
        subjects = list(self.subjects)
        if self.last and not self._verb_before():
            # "A bed and a desk by the window": the desk; "... are by the window": both; "on" is said of all.
            subjects = list(self.last) if kind in ("on", "inside") else self.last[-1:]
        if self.joined:
            subjects = []
        self.relation, self.first_of_pair, self.joined = (kind, subjects, token.text), None, False
        if kind == "flank":
            self.relation = (kind, list(self.last) if not subjects or len(self.last) == 2 else subjects, token.text)
        return True

    def _target_follows(self) -> bool:
        return any(t.has("noun", "place", "pron", "room") for t in self._ahead(5) if not t.has("break"))

    def _verb_before(self) -> bool:
        return any(t.has("verb") and not t.has("relation") for t in self.tokens[max(0, self.at - 3) : self.at - 1])

    def _relate(self, kind: str, target: Any, subjects: list[Mention], words: str) -> None:
        self.relation, self.first_of_pair = None, None
        self.pending = Pending()
        spoken = f"{words} the {target}" if isinstance(target, str) else words
        subjects = [s for s in subjects if s is not target]
        if subjects:
            self.out.said.append(Said(kind, list(subjects), target, spoken))
            self.subjects = list(subjects)
        else:
            self.before.append((kind, target, spoken))
            self.before_used = False

    def _pronoun(self) -> bool:
        assert self.relation is not None
        kind, subjects, words = self.relation
        others = [m for m in self.out.mentions if m not in subjects]
        if not others:
            return False
        target = self.owner if self.owner is not None and self.owner not in subjects else others[-1]
        self._relate(kind, target, subjects, words)
        return True

    def _with(self) -> None:
        self.negated = False
        self.owner = self.last[-1] if self.last and self.out.mentions else None
        if self._each and self.subjects:  # "two nightstands beside the bed, each with a lamp"
            self.owner = self.subjects[-1]
        if not self.last:
            self._leftover()
        self.joined = False
        self.relation = None

    def _break(self, text: str) -> None:
        self._leftover()
        if text == ",":
            if self.before_used:
                self.before, self.before_used = [], False
            self.joined = True
            return
        self.negated, self.joined, self.owner, self.relation = False, False, None, None
        self.before, self.subjects = [], []

    def _stranger_ends(self) -> None:
        if self.strangers:
            self.out.unread.append(" ".join(self.strangers))
            self.strangers = []
