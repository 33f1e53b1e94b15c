"""Relations, as they are said: who is related to what."""

from __future__ import annotations

from typing import Any

from .lexer import Token
from .reading import Mention, Pending, Said, State


class Relating(State):
    """Reads relations, "with", pronouns and the ends of phrases."""

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
