"""The room itself: its kind, who it is for, and its places."""

from __future__ import annotations

from .lexer import Token
from .parser_state import ParsedRelation, PendingModifiers
from .tables import groups
from .tables import words as vocabulary_words
from .things import Things


class Places(Things):
    """Reads rooms, people, windows and doors, corners and walls."""

    def _room(self, token: Token) -> bool:
        name = token.get("room")
        noun = token.has("noun")
        if self.out.room_type is not None:
            other = name != self.out.room_type and not noun and not any(t.has("noun") for t in self._ahead(1))
            if other:
                self.out.notes.append(f"'{token.text}' is another room; only the {self.out.room_words} is made")
            return not noun
        if noun and (self.out.mentions or self.owner is not None):
            return False
        if self.relation is not None and self.relation.kind not in ("inside",) and noun:
            return False
        self._stranger_ends()
        out = self.out
        out.room_type, out.room_words = name, token.text
        spoken = token.text.replace("'s", "").split()
        known = vocabulary_words()["whom"]
        out.for_whom += [w for w in spoken if w in known]  # "bedroom for a teenager" may be one name
        for word in self.pending.tokens:
            if word.has("room_scale"):
                out.room_scale = float(word.get("room_scale"))
            self._room_shape(word)
            self._for_room(word)
        self.pending, self.relation = PendingModifiers(), None
        self.subjects, self.last = [], []
        return True

    def _room_shape(self, word: Token) -> None:
        if word.has("shape") and self.out.shape is None:
            self.out.shape = word.get("shape")
        if word.text in ("long", "narrow", "elongated", "oblong", "long narrow", "long and narrow"):
            self._note(f"'{word.text}' gives no measure; give the sides of the room, such as 6 x 2 m")

    def _other_room(self) -> bool:
        """Whether another word names the room, so that a "dining area" is a part of it."""
        return any(t.has("room") and not t.has("group", "noun") for t in self.tokens)

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
        self.pending = PendingModifiers()
        return True

    def _place(self, token: Token) -> bool:
        place = str(token.get("place"))
        if place == "corner" and token.has("noun"):
            return False
        if place in ("window", "door") and self._opening(place):
            return True
        relation = self.relation
        if place == "room":
            if self.strangers and self.out.room_type is None and not self.out.room_words:
                self.out.room_words = " ".join([*self.strangers, token.text])
                self.out.notes.append(f"'{self.out.room_words}' is no kind of room that is known")
            if relation is not None and relation.kind == "inside":
                self.relation = None
            for word in self.pending.tokens:
                if word.has("room_scale"):
                    self.out.room_scale = float(word.get("room_scale"))
                self._room_shape(word)
                self._for_room(word)
            self.pending = PendingModifiers()
            return True
        kinds = {"corner": "corner", "middle": "middle", "floor": "floor", "ceiling": "ceiling"}
        kind = relation.kind if relation else ("inside" if place in kinds or place.startswith("wall:") else None)
        if kind is None:
            return token.has("stop")
        if self.negated:
            self.negated = False
            return True
        if kind == "away" and place != "door":
            self.out.notes.append(f"'away from the {place}' cannot be said as a relation and was left out")
            self.relation = None
            return True
        subjects, words = (relation.subjects, relation.words) if relation else (self.last[-1:], token.text)
        if kind == "between" and self.first_of_pair is not None:
            self.out.said.append(ParsedRelation("near", list(subjects), self.first_of_pair, words))
        self._relate(kind, place, subjects, words, token.text)
        return True

    def _opening(self, place: str) -> bool:
        """Windows and doors as parts of the room: "two windows", "no windows", "with a window"."""
        if self.relation is not None and self.relation.kind not in ("inside",):
            return False
        if self.negated:
            self.out.openings[place], self.negated = 0, False
        elif self.pending.count is not None:
            self.out.openings[place] = self.pending.count[0]
        elif not self.pending.definite and self.pending.any:
            self.out.openings[place] = 1
        self.pending = PendingModifiers()
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
